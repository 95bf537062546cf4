#include <limits>

#include <strike/output/results.hpp>

#include "scratch.hpp"
#include "support/catch.hpp"

using namespace strike;

namespace {
Results taylor() {
  Results results;
  results.add({.quantity = "final length",
               .value = 21.523,
               .unit = "mm",
               .reference = 21.47,
               .tolerance = 0.08,
               .source = "X3D, WL-TR-91-3006"});
  results.add({.quantity = "final radius", .value = 7.2, .unit = "mm", .reference = 7.08, .tolerance = 0.08});
  results.add({.quantity = "steps", .value = 8255});
  return results;
}
}  // namespace

TEST_CASE("results: passes within the tolerance, both ends included, and without a reference") {
  CHECK(Result{.quantity = "q", .value = 1.25, .reference = 1, .tolerance = 0.25}.passes());
  CHECK_FALSE(Result{.quantity = "q", .value = 0.5, .reference = 1, .tolerance = 0.25}.passes());
  CHECK(Result{.quantity = "q", .value = 5}.passes());
  CHECK_FALSE(Result{.quantity = "q", .value = std::numeric_limits<double>::quiet_NaN()}.passes());
  CHECK(Result{.quantity = "q", .value = -1.1, .reference = -1}.difference() == Approx(-10));
  CHECK_FALSE(taylor().passed());
}

TEST_CASE("results: results.csv") {
  const ScratchFolder folder("results");
  taylor().write(folder / "results.csv");
  CHECK(content_of(folder / "results.csv") ==
        "quantity,value,unit,reference,tolerance,source\n"
        "final length,21.523,mm,21.47,0.08,\"X3D, WL-TR-91-3006\"\n"
        "final radius,7.2,mm,7.08,0.08,\n"
        "steps,8255,,,,\n");
}

TEST_CASE("results: the table is aligned, with differences and marks") {
  CHECK(taylor().table() ==
        "quantity       value  unit  reference  difference  tolerance        source\n"
        "final length  21.523  mm        21.47     +0.25 %       0.08  pass  X3D, WL-TR-91-3006\n"
        "final radius     7.2  mm         7.08     +1.69 %       0.08  FAIL\n"
        "steps           8255\n");
}
