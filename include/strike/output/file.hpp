#pragma once
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

#include <strike/error.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// A file being written. Its folder is made if it is not there; what was in it stays until the first `write`. What that
/// was given is with the operating system when it returns, so that it survives the end of the program, however that
/// comes.
class OutputFile {
 public:
  explicit OutputFile(std::string path) : path_(std::move(path)) {
    std::error_code ignored;  // fopen tells what is wrong
    if (const auto folder = std::filesystem::path(path_).parent_path(); !folder.empty())
      std::filesystem::create_directories(folder, ignored);
    file_ = std::fopen(path_.c_str(), "ab");
    if (!file_)
      throw Error(detail::joined(
          {"File '", path_, "' cannot be opened for writing: choose a path in a folder that you may write to."}));
  }
  OutputFile(OutputFile&& other) noexcept
      : path_(std::move(other.path_)), file_(std::exchange(other.file_, nullptr)), size_(other.size_) {}
  OutputFile& operator=(OutputFile&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(file_, other.file_);
    std::swap(size_, other.size_);
    return *this;
  }
  ~OutputFile() {
    if (file_) std::fclose(file_);
  }

  void write(std::string_view text) {
    if (size_ == 0) cut(0);
    size_ += text.size();
    if (std::fwrite(text.data(), 1, text.size(), file_) != text.size() || std::fflush(file_) != 0)
      throw Error(
          detail::joined({"File '", path_, "' cannot be written to the end: make room on its disk and run again."}));
  }

  /// Goes on behind the first bytes of what was in the file, and cuts the rest off. Error: there are fewer.
  void go_on_behind(std::uint64_t bytes) {
    cut(bytes);
    std::error_code failure;
    if (const auto there = std::filesystem::file_size(path_, failure); failure || there != bytes)
      throw Error(joined({"File '", path_, "' is not as long as when the run was saved: put it back, or begin anew."}));
    size_ = bytes;
  }
  /// How much has been written, in bytes.
  std::uint64_t size() const { return size_; }

  /// Waits until it is on the disk, where the operating system can tell.
  void sync() {
#if __has_include(<unistd.h>)
    ::fsync(::fileno(file_));
#endif
  }

  const std::string& path() const { return path_; }

 private:
  /// If it is longer; what is no file on a disk has no length.
  void cut(std::uint64_t bytes) {
    std::error_code none;
    if (const auto there = std::filesystem::file_size(path_, none); !none && there > bytes)
      std::filesystem::resize_file(path_, bytes);
  }

  std::string path_;
  std::FILE* file_ = nullptr;
  std::uint64_t size_ = 0;
};

/// Writes a file whole, by `write(OutputFile&)`, or leaves what was there: a reader or a killed run never meets half of
/// it.
template <std::invocable<OutputFile&> Write>
void replace_file(const std::string& path, const Write& write) {
  const std::string part = path + ".part";
  {
    OutputFile file(part);
    write(file);
  }
  std::error_code failure;
  std::filesystem::rename(part, path, failure);
  if (failure)
    throw Error(detail::joined(
        {"File '", path, "' cannot be replaced (", failure.message(), "): close or remove what is there."}));
}

inline void replace_file(const std::string& path, std::string_view content) {
  replace_file(path, [&](OutputFile& file) { file.write(content); });
}

inline bool file_exists(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

/// Text as a field of a CSV file (RFC 4180): in quotes if it holds a comma, a quote or a line end.
inline std::string csv_escaped(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace strike::detail
