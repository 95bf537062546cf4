#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>
#include <thread>

#include <strike/output/file.hpp>
#include <strike/output/history.hpp>

#include "scratch.hpp"
#include "support/catch.hpp"
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace strike;

namespace {

std::ptrdiff_t files_in(const ScratchFolder& folder) {
  return std::distance(std::filesystem::directory_iterator(folder.path()), {});
}

/// While it lives, no file grows beyond so many bytes, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit now{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &now);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

}  // namespace

TEST_CASE("replace_file makes folders, replaces, and leaves nothing beside it") {
  const ScratchFolder folder("file");
  detail::replace_file(folder / "a/b/c.txt", "first");
  detail::replace_file(folder / "a/b/c.txt", "second");
  CHECK(content_of(folder / "a/b/c.txt") == "second");
  CHECK(std::distance(std::filesystem::directory_iterator(folder / "a/b"), {}) == 1);
}

TEST_CASE("a file that cannot be written is an error in one sentence") {
  const ScratchFolder folder("file-error");
  std::filesystem::create_directories(folder / "taken");
  CHECK_THROWS_WITH(detail::OutputFile(folder / "taken"),
                    "strike: the file '" + (folder / "taken") +
                        "' cannot be opened for writing: choose a path in a folder that you may write to.");
  std::filesystem::create_directories(folder / "full/inside");
  CHECK_THROWS_WITH(detail::replace_file(folder / "full", "x"),
                    Catch::Matchers::ContainsSubstring("cannot be replaced"));
  if (std::filesystem::exists("/dev/full"))  // a device on which every write fails
    CHECK_THROWS_WITH(
        detail::OutputFile("/dev/full").write("x"),
        "strike: the file '/dev/full' cannot be written to the end: make room on its disk and run again.");
}

TEST_CASE("a link stays a link, and a device is written, not replaced") {
  const ScratchFolder folder("file-link");
  detail::replace_file(folder / "there/a.txt", "first");
  std::filesystem::create_symlink(folder / "there/a.txt", folder / "link");
  detail::replace_file(folder / "link", "second");
  CHECK(std::filesystem::is_symlink(folder / "link"));
  CHECK(content_of(folder / "there/a.txt") == "second");
  std::filesystem::create_symlink("/dev/null", folder / "null");
  detail::replace_file(folder / "null", "x");
  CHECK(std::filesystem::is_symlink(folder / "null"));
}

TEST_CASE("if writing fails, the old file stays and nothing is left beside it") {
  const ScratchFolder folder("file-kept");
  detail::replace_file(folder / "a.txt", "first");
  CHECK_THROWS_AS(detail::replace_file(folder / "a.txt",
                                       [](detail::OutputFile& file) {
                                         file.write("half");
                                         throw Error("no more");
                                       }),
                  Error);
  CHECK(content_of(folder / "a.txt") == "first");
  std::filesystem::create_directories(folder / "full/inside");
  CHECK_THROWS_AS(detail::replace_file(folder / "full", "x"), Error);
  CHECK(files_in(folder) == 2);
}

TEST_CASE("a row for which the disk has no room is not in the history, and comes whole when there is room") {
  const ScratchFolder folder("file-full");
  History history{folder / "h.csv", {{"time", "ms"}, {"length", "mm"}}};
  history.row(0.125, 32.4);
  const std::string before = content_of(folder / "h.csv");
  {
    const FullDisk disk(before.size() + 3);
    CHECK_THROWS_WITH(history.row(0.25, 32.3), "strike: the file '" + (folder / "h.csv") +
                                                   "' cannot be written to the end: make room on its disk and run "
                                                   "again.");
    CHECK_THROWS_AS(detail::replace_file(folder / "a.txt", std::string(1000, 'x')), Error);
  }
  CHECK(content_of(folder / "h.csv") == before);
  CHECK(files_in(folder) == 1);
  CHECK(history.rows() == 1);
  history.row(0.25, 32.3);
  CHECK(content_of(folder / "h.csv") == before + "0.25,32.3\n");
}

TEST_CASE("what a killed program has left of a file goes when the file is written again, or its run resumed") {
  const ScratchFolder folder("file-left");
  const auto leave_half = [&] {
    const pid_t child = ::fork();
    if (child == 0)
      detail::replace_file(folder / "a.txt", [](detail::OutputFile& file) {
        file.write("a half that is longer than the whole");
        ::raise(SIGKILL);
      });
    ::waitpid(child, nullptr, 0);
    CHECK(std::filesystem::exists(folder / "a.txt.part"));
  };
  leave_half();
  detail::remove_part_of(folder / "a.txt");
  CHECK(files_in(folder) == 0);
  for (const std::string content : {"whole", ""}) {
    leave_half();
    detail::replace_file(folder / "a.txt", [&](detail::OutputFile& file) {
      if (!content.empty()) file.write(content);
    });
    CHECK(content_of(folder / "a.txt") == content);
  }
  CHECK(files_in(folder) == 1);
}

TEST_CASE("who writes the same file at once waits for the other, so that their texts do not mix") {
  const ScratchFolder folder("file-lock");
  const auto write = [&](char c, std::size_t size, int times) {
    for (int k = 0; k < times; ++k)
      detail::replace_file(folder / "a.txt", [&](detail::OutputFile& file) {
        for (std::size_t i = 0; i < size; ++i) file.write({&c, 1});
      });
  };
  int status = -1;
  const pid_t child = ::fork();
  if (child == 0) {
    write('c', 30, 200);
    std::_Exit(0);
  }
  std::thread other(write, 'a', 10, 200);
  std::size_t mixed = 0;
  for (int k = 0; k < 200; ++k) {
    detail::remove_part_of(folder / "a.txt");  // which is not that of a program that lives
    write('b', 20, 1);
    const std::string content = content_of(folder / "a.txt");
    mixed += content != std::string(10, 'a') && content != std::string(20, 'b') && content != std::string(30, 'c');
  }
  other.join();
  ::waitpid(child, &status, 0);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
  CHECK(mixed == 0);
  CHECK(files_in(folder) == 1);
}

TEST_CASE("csv_escaped follows RFC 4180") {
  CHECK(detail::csv_escaped("plain text") == "plain text");
  CHECK(detail::csv_escaped("a,b") == "\"a,b\"");
  CHECK(detail::csv_escaped("12\" rule") == "\"12\"\" rule\"");
}
