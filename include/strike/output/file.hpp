#pragma once
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <strike/error.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// A file being written. Its folder is made if it is not there. What `write` was given is with the operating system
/// when it returns, so that it survives the end of the program, however that comes.
class OutputFile {
 public:
  explicit OutputFile(std::string path) : path_(std::move(path)) {
    std::error_code ignored;  // fopen tells what is wrong
    if (const auto folder = std::filesystem::path(path_).parent_path(); !folder.empty())
      std::filesystem::create_directories(folder, ignored);
    file_ = std::fopen(path_.c_str(), "wb");
    if (!file_)
      throw Error(detail::joined(
          {"File '", path_, "' cannot be opened for writing: choose a path in a folder that you may write to."}));
  }
  OutputFile(OutputFile&& other) noexcept : path_(std::move(other.path_)), file_(std::exchange(other.file_, nullptr)) {}
  OutputFile& operator=(OutputFile&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(file_, other.file_);
    return *this;
  }
  ~OutputFile() {
    if (file_) std::fclose(file_);
  }

  void write(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), file_) != text.size() || std::fflush(file_) != 0)
      throw Error(
          detail::joined({"File '", path_, "' cannot be written to the end: make room on its disk and run again."}));
  }

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::FILE* file_ = nullptr;
};

/// Writes a file whole or leaves what was there: a reader or a killed run never meets half of it.
inline void replace_file(const std::string& path, std::string_view content) {
  const std::string part = path + ".part";
  OutputFile(part).write(content);
  std::error_code failure;
  std::filesystem::rename(part, path, failure);
  if (failure)
    throw Error(detail::joined(
        {"File '", path, "' cannot be replaced (", failure.message(), "): close or remove what is there."}));
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
