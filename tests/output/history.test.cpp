#include <cmath>
#include <csignal>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <vector>

#include <strike/output/history.hpp>

#include "scratch.hpp"
#include "support/catch.hpp"
#include <sys/wait.h>
#include <unistd.h>

using namespace strike;

TEST_CASE("history: heads carry units, numbers read back bit for bit, rows are there at once") {
  const ScratchFolder folder("history");
  const std::string path = folder / "runs/bar.csv";
  History history{path, {{"time", "ms"}, {"length", "mm"}, {"steps"}, {"force, total", "kN"}}};

  const std::vector<double> odd{0.1, 1.0 / 3, -5e-324, 1.7976931348623157e308};
  history.row(odd);
  CHECK(content_of(path).starts_with("time [ms],length [mm],steps,\"force, total [kN]\"\n"));
  std::istringstream lines(content_of(path));
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  std::istringstream fields(line);
  for (const double value : odd) {
    std::string field;
    std::getline(fields, field, ',');
    CHECK(std::strtod(field.c_str(), nullptr) == value);
  }
  history.row(1.5, 2.5f, 3, 4u);  // any arithmetic type
  history.row(0, 0, 0, std::numeric_limits<double>::quiet_NaN());
  CHECK(content_of(path).ends_with("\n1.5,2.5,3,4\n0,0,0,nan\n"));
  CHECK(history.rows() == 3);
}

TEST_CASE("history: a killed run leaves only whole rows, and all of them") {
  const ScratchFolder folder("history-killed");
  const std::string path = folder / "h.csv";
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    History history{path, {{"i"}, {"root"}}};
    for (int i = 0; i < 1000; ++i) history.row(i, std::sqrt(i));
    std::raise(SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  REQUIRE(WIFSIGNALED(status));
  std::istringstream lines(content_of(path));
  std::string line;
  std::getline(lines, line);
  for (int i = 0; i < 1000; ++i) {
    REQUIRE(std::getline(lines, line));
    CHECK(std::strtod(line.substr(line.find(',') + 1).c_str(), nullptr) == std::sqrt(i));
  }
  CHECK_FALSE(std::getline(lines, line));
}

TEST_CASE("history: a row of another length and a path that cannot be are errors") {
  const ScratchFolder folder("history-error");
  History history{folder / "h.csv", {{"t", "s"}, {"x", "m"}}};
  history.row(1, 2);
  CHECK_THROWS_WITH(history.row(1), "strike: the History '" + (folder / "h.csv") +
                                        "' has 2 columns, but row 1 brings 1 values: give one for each column.");
  CHECK(content_of(folder / "h.csv") == "t [s],x [m]\n1,2\n");  // what was written stays
  CHECK_THROWS_WITH((History{folder / "h.csv/x.csv", {{"t"}}}),
                    Catch::Matchers::ContainsSubstring("cannot be opened for writing"));
  CHECK_THROWS_WITH((History{folder / "n.csv", {}}),
                    "strike: the History '" + (folder / "n.csv") + "' has no columns: name at least one.");
}
