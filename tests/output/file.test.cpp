#include <filesystem>

#include <strike/output/file.hpp>

#include "scratch.hpp"
#include "support/catch.hpp"

using namespace strike;

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
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 2);
}

TEST_CASE("csv_escaped follows RFC 4180") {
  CHECK(detail::csv_escaped("plain text") == "plain text");
  CHECK(detail::csv_escaped("a,b") == "\"a,b\"");
  CHECK(detail::csv_escaped("12\" rule") == "\"12\"\" rule\"");
}
