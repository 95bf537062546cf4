#pragma once
#include <cerrno>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <strike/error.hpp>
#include <strike/process.hpp>
#include <strike/text.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

// POSIX, since <filesystem> costs a twentieth of the compile time of a program.
namespace strike::detail {

/// Makes the folder of a file and the folders above it, where they are not there.
[[gnu::cold]] inline void make_folder_of(const std::string& path) {
  for (std::size_t end = path.find('/', 1); end != std::string::npos; end = path.find('/', end + 1))
    ::mkdir(path.substr(0, end).c_str(), 0777);  // fails where it is there; fopen says what is wrong
}

/// Size of a file [bytes]; a path that is no file on a disk has none.
[[gnu::cold]] inline bool has_size(const std::string& path, std::uint64_t& bytes) {
  struct ::stat status;
  if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return false;
  bytes = static_cast<std::uint64_t>(status.st_size);
  return true;
}

/// True if what was written is on the disk, as far as the operating system knows, or if it has no such disk.
[[gnu::cold]] inline bool is_on_disk(int file) {
  return ::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
}

/// A file being written; of several processes the first one writes. Its folder is made if it is not there; the old
/// content stays until the first `write`. When `write` returns, the operating system has the text, so that it survives
/// a crash of the program. A text for which the disk has no room is not in the file, not even its first half.
class OutputFile {
 public:
  [[gnu::cold]] explicit OutputFile(std::string path) : path_(std::move(path)) {
    by_first([&] {
      make_folder_of(path_);
      file_ = std::fopen(path_.c_str(), "ab");
      if (!file_)
        throw Error(joined({"strike: the file '", path_,
                            "' cannot be opened for writing: choose a path in a folder that you may write to."}));
      std::setvbuf(file_, nullptr, _IONBF, 0);
    });
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
    by_first([&] {
      if (size_ == 0) cut(0);
      if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) {
        cut(size_);
        refuse_text();
      }
    });
    size_ += text.size();
  }

  /// Continues after the first bytes of the old content and removes the rest. Error: the file is shorter.
  [[gnu::cold]] void go_on_behind(std::uint64_t bytes) {
    by_first([&] {
      cut(bytes);
      if (std::uint64_t there = 0; !has_size(path_, there) || there != bytes)
        throw Error(joined(
            {"strike: the file '", path_, "' is not as long as when the run was saved: put it back, or start anew."}));
    });
    size_ = bytes;
  }
  /// Size of the text written [bytes].
  std::uint64_t size() const { return size_; }

  /// Waits until the text is on the disk, as far as the operating system knows. Error: it is not.
  [[gnu::cold]] void sync() {
    by_first([&] {
      if (!is_on_disk(::fileno(file_))) refuse_text();
    });
    is_synced_ = true;
  }
  bool is_synced() const { return is_synced_; }
  /// Error: the operating system has lost some of the text.
  [[gnu::cold]] void close() {
    by_first([&] {
      if (std::FILE* const file = std::exchange(file_, nullptr); file && std::fclose(file) != 0) refuse_text();
    });
  }

  const std::string& path() const { return path_; }

 private:
  [[noreturn, gnu::cold]] void refuse_text() const {
    throw Error(detail::joined(
        {"strike: the file '", path_, "' cannot be written to the end: make room on its disk and run again."}));
  }
  /// Shortens the file to this size, if it is a file on a disk and longer.
  [[gnu::cold]] void cut(std::uint64_t bytes) {
    if (std::uint64_t there = 0;
        has_size(path_, there) && there > bytes && ::truncate(path_.c_str(), static_cast<::off_t>(bytes)) != 0)
      throw Error(
          joined({"strike: the file '", path_, "' cannot be cut (", std::strerror(errno), "): make it writable."}));
  }

  std::string path_;
  std::FILE* file_ = nullptr;
  std::uint64_t size_ = 0;
  bool is_synced_ = false;
};

/// The path behind a link, which stays a link when the file is replaced.
[[gnu::cold]] inline std::string path_behind(const std::string& path) {
  struct ::stat status;
  if (::lstat(path.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) return path;
  const std::unique_ptr<char, void (*)(void*)> behind(::realpath(path.c_str(), nullptr), &std::free);
  return behind ? std::string(behind.get()) : path;
}
/// True of devices and pipes, which are written and never replaced.
[[gnu::cold]] inline bool is_device(const std::string& path) {
  struct ::stat status;
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}
/// Waits until the names in the folder of a file are on the disk. Error: they are not.
[[gnu::cold]] inline void sync_folder_of(const std::string& path) {
  const std::size_t end = path.rfind('/');
  const std::string folder = end == std::string::npos ? "." : path.substr(0, end + 1);
  const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY);
  if (opened < 0) return;  // a folder that may be written and not read
  const bool done = is_on_disk(opened);
  ::close(opened);
  if (!done)
    throw Error(joined({"strike: the folder '", folder, "' cannot be written: check its disk and run again."}));
}

/// The file NAME.part, which grows until it replaces NAME or is removed. Who writes it has a lock, so that another
/// program or thread waits; the system takes the lock from a killed program, and the next one replaces what that left.
class PartFile {
 public:
  [[gnu::cold]] explicit PartFile(const std::string& target) : path_(joined({target, ".part"})) {
    if (!this_process.is_first) return;
    make_folder_of(path_);
    do {
      unlock();
      lock_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
      while (::flock(lock_, LOCK_EX) != 0 && errno == EINTR) continue;  // a disk without locks goes without
    } while (lock_ >= 0 && !is_locked());
  }
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile() {
    if (lock_ >= 0 && !is_moved_) ::unlink(path_.c_str());
    unlock();
  }

  const std::string& path() const { return path_; }

  /// Puts the file in the place of the target, which the user knows as `path`. Error: it stays where it is.
  [[gnu::cold]] void replace(const std::string& target, const std::string& path) {
    by_first([&] {
      is_moved_ = std::rename(path_.c_str(), target.c_str()) == 0;
      if (!is_moved_)
        throw Error(joined({"strike: the file '", path, "' cannot be replaced (", std::strerror(errno),
                            "): close or remove what is there."}));
    });
  }

 private:
  /// False if the program that had the lock has moved or removed the file since.
  [[gnu::cold]] bool is_locked() const {
    struct ::stat ours, there;
    return ::fstat(lock_, &ours) == 0 && ::stat(path_.c_str(), &there) == 0 && ours.st_ino == there.st_ino &&
           ours.st_dev == there.st_dev;
  }
  void unlock() {
    if (lock_ >= 0) ::close(lock_);
  }

  std::string path_;
  int lock_ = -1;
  bool is_moved_ = false;
};

/// Removes what a killed program has left of a new content.
[[gnu::cold]] inline void remove_part_of(const std::string& path) {
  if (!this_process.is_first) return;
  const std::string target = path_behind(path);
  if (::access(joined({target, ".part"}).c_str(), F_OK) == 0) PartFile{target};
}

/// Writes a file whole, by `write(OutputFile&)`, or leaves the old file: a reader never finds half of it, even after a
/// killed run. If `write` syncs the file, the disk has it under its name.
template <std::invocable<OutputFile&> Write>
void replace_file(const std::string& path, const Write& write) {
  if (first_says([&] { return is_device(path); })) {
    OutputFile file(path);
    write(file);
    return file.close();
  }
  const std::string target = path_behind(path);
  PartFile part(target);
  OutputFile file(part.path());
  file.go_on_behind(0);  // without what a killed program has left
  write(file);
  const bool synced = file.is_synced();
  file.close();
  part.replace(target, path);
  if (synced) by_first([&] { sync_folder_of(target); });
}

[[gnu::cold]] inline void replace_file(const std::string& path, std::string_view content) {
  replace_file(path, [&](OutputFile& file) { file.write(content); });
}

[[gnu::cold]] inline bool file_exists(const std::string& path) { return ::access(path.c_str(), F_OK) == 0; }

/// Text as a field of a CSV file (RFC 4180): in quotes if it holds a comma, a quote or a line end.
[[gnu::cold]] inline std::string csv_escaped(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace strike::detail
