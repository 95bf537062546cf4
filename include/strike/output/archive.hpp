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
#include <vector>

#include <Eigen/Core>

#include <strike/error.hpp>

namespace strike {

/// How things tell what they remember, all with one function of theirs, which writes, reads and compares:
///
///   template <class Archive>
///   void serialize(Archive& archive) {
///     archive(position_, velocity_);  // changes as a run goes on: is written, and comes back
///     archive.same(mass_);            // follows from the scene: has to be the same there and here
///   }
///
/// An archive takes numbers and what is copied as bytes, Eigen's vectors and matrices of fixed size, std::string,
/// std::vector, std::span and std::tuple of such things, and whatever has such a function.
template <class Derived>
class Archive {
 public:
  static constexpr bool reads = false;

  template <class... Values>
  void operator()(Values&&... values) {
    (item(values), ...);
  }
  template <class... Values>
  void same(const Values&...) {}

 protected:
  template <class T>
  static constexpr bool is_list = requires(T list) {
    list.data();
    list.resize(std::size_t{});
    requires !requires { T::RowsAtCompileTime; };
  };
  template <class T>
  static constexpr bool is_fixed_matrix = requires {
    requires T::SizeAtCompileTime >
    0;
    requires std::is_arithmetic_v<typename T::Scalar>;
  };
  template <class T>
  static constexpr bool is_plain = is_fixed_matrix<T> || (std::is_trivially_copyable_v<T> && !std::is_pointer_v<T> &&
                                                          !requires(T a) { a.data(); });

  template <class T>
  void item(T& value) {
    if constexpr (requires { value.serialize(derived()); })
      value.serialize(derived());
    else if constexpr (is_list<T>)
      list(value);
    else if constexpr (requires { std::span(value); })
      items(std::span(value));
    else if constexpr (requires { std::tuple_size<T>::value; })
      std::apply([&](auto&... one) { (item(one), ...); }, value);
    else if constexpr (is_plain<T>)
      derived().bytes(&value, sizeof value);
    else
      static_assert(is_plain<T>,
                    "strike: an Archive does not know how to keep this: give its type template <class Archive> void "
                    "serialize(Archive& archive) { archive(...); } with all that it remembers.");
  }

 private:
  Derived& derived() { return static_cast<Derived&>(*this); }

  template <class List>
  void list(List& list) {
    std::uint64_t size = list.size();
    item(size);
    if constexpr (Derived::reads) derived().resize(list, size);
    items(std::span(list.data(), list.size()));
  }
  template <class T, std::size_t n>
  void items(std::span<T, n> all) {
    if constexpr (is_plain<T> && !requires(T & one) { one.serialize(derived()); })
      derived().bytes(all.data(), all.size_bytes());
    else
      for (T& one : all) item(one);
  }
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

/// What has to be the same in a scene that goes on from a checkpoint, as one number.
class Fingerprint : public Archive<Fingerprint> {
 public:
  void bytes(const void*, std::size_t) {}

  template <class... Values>
  void same(const Values&... values) {
    (hash(values), ...);
  }
  std::uint64_t value() const { return hash_.value(); }

 private:
  template <class T>
  void hash(const T& value) {
    if constexpr (requires { value.data(); })
      hash_.add(value.data(), value.size() * sizeof(*value.data()));
    else if constexpr (is_plain<T>)
      hash_.add(&value, sizeof value);
    else
      static_assert(is_plain<T>, "strike: Archive::same takes numbers and lists of numbers.");
  }

  Hash hash_;
};

}  // namespace detail

}  // namespace strike
