#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/error.hpp>

namespace strike {

/// The interface of a checkpoint to an object with a state: one function of the object, which writes, reads and
/// compares:
///
///     template <class Archive>
///     void serialize(Archive& archive) {
///       archive(position_, velocity_);  // changes during a run: written and restored
///       archive.same(mass_);            // follows from the scene: must be equal when read
///     }
///
/// An archive takes numbers and other types that can be copied as bytes, Eigen's vectors and matrices of fixed size,
/// std::string, std::vector, std::span and std::tuple of these, and every type with such a function. Archives that
/// write, read and compare are of one type, so that each such function is compiled once.
class Archive {
 public:
  /// True if the archive restores values, false if it writes them.
  bool reads() const { return reads_; }

  template <class... Values>
  void operator()(Values&&... values) {
    (item(values), ...);
  }
  template <class... Values>
  void same(const Values&... values) {
    (identity(values), ...);
  }

 protected:
  explicit Archive(bool reads) : reads_(reads) {}
  ~Archive() = default;

  /// Writes or reads `count` bytes.
  virtual void bytes(void* at, std::size_t count) = 0;
  /// Includes bytes that must be equal in the fingerprint.
  virtual void note(const void*, std::size_t) {}
  /// Error: the file holds fewer than `count` bytes, so that a list cannot have `count` elements.
  virtual void allow(std::uint64_t) {}

 private:
  template <class T>
  static constexpr bool is_list = requires(T list) {
    list.data();
    list.resize(std::size_t{});
    requires !requires { T::RowsAtCompileTime; };
  };
  template <class T>
  static constexpr bool is_fixed_matrix = requires {
    requires T::SizeAtCompileTime > 0;
    requires std::is_arithmetic_v<typename T::Scalar>;
  };
  template <class T>
  static constexpr bool is_plain =
      is_fixed_matrix<T> || (std::is_trivially_copyable_v<T> && !std::is_pointer_v<T> && !requires(T a) { a.data(); });

  template <class T>
  void item(T& value) {
    if constexpr (std::is_arithmetic_v<T> || is_fixed_matrix<T>)
      bytes(&value, sizeof value);
    else if constexpr (requires { value.serialize(*this); })
      value.serialize(*this);
    else if constexpr (is_list<T>)
      list(value);
    else if constexpr (requires { std::span(value); })
      items(std::span(value));
    else if constexpr (requires { std::tuple_size<T>::value; })
      [&]<std::size_t... i>(std::index_sequence<i...>) {
        (item(std::get<i>(value)), ...);
      }(std::make_index_sequence<std::tuple_size_v<T>>{});
    else if constexpr (is_plain<T>)
      bytes(&value, sizeof value);
    else
      static_assert(
          is_plain<T>,
          "strike: an Archive cannot save this type: give it template <class Archive> void serialize(Archive& "
          "archive) { archive(...); } with its state.");
  }

  template <class List>
  void list(List& list) {
    std::uint64_t size = list.size();
    item(size);
    if (reads_) {
      allow(size);
      list.resize(static_cast<std::size_t>(size));
    }
    items(std::span(list.data(), list.size()));
  }
  template <class T, std::size_t n>
  void items(std::span<T, n> all) {
    if constexpr (is_plain<T> && !requires(T& one, Archive& archive) { one.serialize(archive); })
      bytes(all.data(), all.size_bytes());
    else
      for (T& one : all) item(one);
  }

  template <class T>
  void identity(const T& value) {
    if constexpr (requires { value.data(); })
      note(value.data(), static_cast<std::size_t>(value.size()) * sizeof(*value.data()));
    else if constexpr (is_plain<T>)
      note(&value, sizeof value);
    else
      static_assert(is_plain<T>, "strike: Archive::same takes numbers and lists of numbers.");
  }

  bool reads_;
};

namespace detail {

/// A hash of bytes, eight at a time (constants of splitmix64, Steele, Lea and Flood 2014).
class Hash {
 public:
  void add(const void* bytes, std::size_t count) {
    const char* at = static_cast<const char*>(bytes);
    for (; count > 0; at += std::min<std::size_t>(count, 8), count -= std::min<std::size_t>(count, 8)) {
      std::uint64_t word = 0;
      std::memcpy(&word, at, std::min<std::size_t>(count, 8));
      value_ = (value_ ^ word ^ (count < 8 ? count << 56 : 0)) * 0xbf58476d1ce4e5b9u;
      value_ ^= value_ >> 31;
    }
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0x9e3779b97f4a7c15u;
};

/// One number of everything that must be equal in a scene that continues from a checkpoint.
class Fingerprint final : public Archive {
 public:
  Fingerprint() : Archive(false) {}
  std::uint64_t value() const { return hash_.value(); }

 private:
  void bytes(void*, std::size_t) override {}
  void note(const void* at, std::size_t count) override { hash_.add(at, count); }

  Hash hash_;
};

}  // namespace detail

}  // namespace strike
