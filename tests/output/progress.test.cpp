#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>

#include <strike/output/progress.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {
struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using TemporaryFile = std::unique_ptr<std::FILE, Close>;

std::string content_of(std::FILE* file) {
  std::rewind(file);
  std::string text;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
  return text;
}
}  // namespace

TEST_CASE("progress: percent, time, step, error, and the last line at the end, and then a new line") {
  const TemporaryFile file(std::tmpfile());
  {
    Progress progress{{.end = 80, .unit = "us", .show = Show::always, .stream = file.get()}};
    progress.update(20, 1000, 0.02, 5e-4);
    progress.update(80, 4000, 0.02, 7e-4);
  }
  const std::string text = content_of(file.get());
  CHECK(text.find("\r\033[K 25 %  t = 20 of 80 us  step 1000  dt = 0.02  energy error 0.05 %") == 0);
  CHECK(text.find("100 %  t = 80 of 80 us  step 4000  dt = 0.02  energy error 0.07 %  0 s in all\n") !=
        std::string::npos);
}

TEST_CASE("progress: nothing at all where no person looks") {
  const TemporaryFile file(std::tmpfile());  // no terminal
  int asked = 0;
  {
    Progress progress{{.end = 1, .stream = file.get()}};
    for (std::uint64_t step = 0; step <= 1000; ++step)
      progress.update(double(step) / 1000, step, 1e-3, [&] {
        ++asked;
        return 0.0;
      });
  }
  CHECK(content_of(file.get()).empty());
  CHECK(asked == 0);
}

TEST_CASE("progress: at most four lines a second, the error asked for no more often, other calls cheap") {
  const TemporaryFile file(std::tmpfile());
  int asked = 0;
  std::uint64_t calls = 0;
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  {
    Progress progress{{.end = 1, .show = Show::always, .stream = file.get()}};
    while (elapsed() < 1.1)
      for (int i = 0; i < 1000; ++i)
        progress.update(0.5, ++calls, 1e-3, [&] {
          ++asked;
          return 0.0;
        });
  }
  const std::string text = content_of(file.get());
  const auto lines = std::count(text.begin(), text.end(), '\r');
  CHECK(lines == asked);
  CHECK(lines >= 2);
  CHECK(lines <= 5);         // at 0, .25, .5, .75, 1 s
  CHECK(calls > 2'000'000);  // under half a microsecond a call, even where the machine is shared
}
