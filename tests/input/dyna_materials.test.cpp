// Materials of LS-DYNA that follow curves and tables, and those with laws of their own.
#include <cmath>
#include <string>
#include <vector>

#include <strike/input/dyna.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/cowper_symonds.hpp>

#include "input/dyna_cube.hpp"
#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

/// MAT_024 with E 210e3 and no SIGY: further fields of its first card, then its other cards.
std::string piecewise(const std::string& first, const std::string& others) {
  return "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.8e-9,210e3,.3" + first + "\n" + others;
}
const std::string rising = "*DEFINE_CURVE\n7\n0,300\n.1,400\n", fast = "*DEFINE_CURVE\n8\n0,500\n.05,520\n";

}  // namespace

TEST_CASE("dyna materials: a curve in the place of SIGY and ETAN, wherever it stands") {
  for (const std::string& text :
       {piecewise("", "0,0,7\n") + rising, rising + piecewise("", "0,0,7\n"),
        piecewise(",250,2000", "0,0,7\n0,.1\n250,260\n") + rising,  // SIGY, ETAN, EPS and ES are not taken
        "*MAT_024_TITLE\nsteel\n1,7.8e-9,210e3,.3\n0,0,7\n" + rising,
        piecewise("", "0,0,7\n") + "*DEFINE_CURVE\n7,0,.01,100\n0,3\n10,4\n",
        piecewise("", "0,0,7\n") + "*DEFINE_CURVE\n7,0,1,1,-.2,100\n.2,200\n.3,300\n",
        std::string("*PARAMETER\nR curve,7,R E,210e3\n*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.8e-9,&E,.3\n0,0,&curve\n") +
            rising,
        "*MAT_PIECEWISE_LINEAR_PLASTICITY +\n                   1             7.8E-09            210000.0            "
        "     0.3\n                 0.0                 0.0                   7\n" +
            rising,
        "*MAT_PIECEWISE_LINEAR_PLASTICITY %\n         1   7.8E-09  210000.0       0.3\n       0.0       0.0         "
        "7\n" +
            rising}) {
    INFO(text);
    const DynaDeck deck = read_cube(text);
    const auto& m = deck.material<TabulatedMaterial>("cube");
    CHECK(m.eos.density == 7.8e-9);
    CHECK(m.eos.bulk_modulus == Approx(210e3 / 1.2));
    CHECK(m.strength.shear_modulus == Approx(210e3 / 2.6));
    CHECK(m.strength.flow_stress(0.0) == Approx(300).epsilon(1e-14));
    CHECK(m.strength.flow_stress(.05) == Approx(350).epsilon(1e-14));
    CHECK(m.strength.flow_stress(.5) == Approx(800).epsilon(1e-12));  // the last line goes on
    CHECK_FALSE(m.rate);
    CHECK_FALSE(m.failure);
    CHECK(deck.warnings.empty());
    CHECK(Solid{m.eos, m.strength}.density() == 7.8e-9);
  }
}

TEST_CASE("dyna materials: EPS and ES, and lines that go on beyond the first and the last point") {
  const auto stress = [](const std::string& others, double e) {
    const DynaDeck deck = read_cube(piecewise("", others));
    CHECK(deck.warnings.empty());
    return deck.material<TabulatedMaterial>(1).strength.flow_stress(e);
  };
  const std::string eight = "0\n0,.01,.02,.03,.04,.05,.06,.08\n300,310,320,330,340,350,360,400\n";
  CHECK(stress(eight, 0) == 300);
  CHECK(stress(eight, .07) == Approx(380));
  CHECK(stress(eight, 1) == Approx(400 + 2000 * .92));
  CHECK(stress("0\n0,.1\n300,300\n", 5) == 300);
  CHECK(stress("0\n0\n300\n", 5) == 300);                    // one point
  CHECK(stress("0\n.02,.12\n320,420\n", 0) == Approx(300));  // does not begin at 0
  CHECK(stress("0\n.02,.12\n320,420\n", .02) == Approx(320));
  CHECK(stress("0\n-.1,.1\n200,400\n", 0) == Approx(300));  // begins before 0
  CHECK(stress("0\n-.2,-.1\n100,200\n", .1) == Approx(400));
  CHECK(stress("0\n0,.1,.2\n300,400,390\n", .3) == Approx(380));  // falls
  CHECK(stress("0\n0,.1,.2\n300,400,390\n", 50) == 0);            // never below 0
  refuses_cube(piecewise("", "0\n0,.1,.05\n300,400,420\n"),
               "line 16: material 1 cannot follow its points: the "
               "plastic_strain of point 2 of TabulatedHardening is 0.05");
  refuses_cube(piecewise("", "0\n0,.1\n300,-1\n"), "the stress of point 1 of TabulatedHardening is -1");
  refuses_cube(piecewise("", "0\n0,.001\n300,1\n"), "spread the fall over more than");
  refuses_cube(piecewise("", "0,0,7\n") + "*DEFINE_CURVE\n7\n.1,300\n0,400\n", "is below the one before it");
  refuses_cube(piecewise("", "0,0,7\n") + "*DEFINE_CURVE\n7\n", "has no points: give it at least one.");
  refuses_cube(piecewise("", "0,0,7\n"), "line 16: the curve 7 of material 1 is not in the file: define it");
  refuses_cube(piecewise("", "0,0,7\n") + "*DEFINE_CURVE_FUNCTION\n7\nx\n",
               "is not in the file (*DEFINE_CURVE_FUNCTION on line 18 was skipped): define it");
}

TEST_CASE("dyna materials: the rate of a curve by C and P, or by LCSR") {
  const DynaDeck deck = read_cube(piecewise(",,,.5", "40,5,7,0,1\n") + rising);
  CHECK(deck.warnings.empty());
  const auto& m = deck.material<TabulatedMaterial>("cube");
  CHECK(m.failure->failure_strain == .5);
  REQUIRE(m.rate);
  const Solid steel{m.eos, CowperSymonds{m.strength, m.rate->D, m.rate->p}};
  CHECK(steel.strength.flow_stress(.1, 40.) == Approx(2 * 400));             // D doubles the stress,
  CHECK(steel.strength.flow_stress(.1, 40. * 32) == Approx((1 + 2) * 400));  // 2^p D triples it

  // a factor over the rate, in the place of C and P
  const std::string factors = "*DEFINE_CURVE\n9\n0,1\n100,1.5\n1000,2\n";
  for (const std::string& first : {std::string("0,0,7,9,1\n") + rising, std::string("40,5,7,9,1\n") + rising}) {
    const DynaDeck scaled = read_cube(piecewise("", first) + factors);
    const auto& law = scaled.material<TabulatedRatesMaterial>("cube").strength;
    CHECK(law.flow_stress(.05, 0.) == Approx(350));
    CHECK(law.flow_stress(.05, 50.) == Approx(350 * 1.25));
    CHECK(law.flow_stress(.05, 550.) == Approx(350 * 1.75));
    CHECK(law.flow_stress(.05, 1e6) == Approx(350 * 2));
    CHECK(scaled.warnings.empty());
  }
  const DynaDeck linear = read_cube(piecewise(",200,2100", "0,0,0,9,1\n") + factors);  // of SIGY and ETAN
  CHECK(linear.material<TabulatedRatesMaterial>(1).strength.flow_stress(.1, 100.) ==
        Approx(1.5 * (200 + .1 * 210e3 * 2100 / (210e3 - 2100))));

  CHECK(read_cube(piecewise("", "40,5,7\n") + rising).warnings ==
        std::vector<std::string>{"VP 0 (the rate is that of the plastic strain, as of VP 1) of "
                                 "*MAT_PIECEWISE_LINEAR_PLASTICITY (1) had no effect: line 17."});
  CHECK(read_cube(piecewise(",250,100", "40,5,,,1\n")).warnings ==
        std::vector<std::string>{"VP 1 (the factor of the rate is that of SIGY alone) of "
                                 "*MAT_PIECEWISE_LINEAR_PLASTICITY (1) had no effect: line 17."});
  refuses_cube(piecewise("", "0,0,7,9\n") + rising, "the curve 9 of material 1 is not in the file");
  refuses_cube(piecewise("", "0,0,7,9\n") + rising + "*DEFINE_CURVE\n9\n-5,1\n",
               "the rate of test 1 of TabulatedRates is -5");
}

TEST_CASE("dyna materials: a table of curves by the rate") {
  const std::string table = "*DEFINE_TABLE\n3\n0\n100\n";
  const auto law = [](const std::string& text) {
    const DynaDeck deck = read_cube(text);
    CHECK(deck.warnings.empty());
    return deck.material<TabulatedRatesMaterial>("cube").strength;
  };
  // C and P are not taken with a table
  for (const std::string& text :
       {piecewise("", "0,0,3,0,1\n") + table + rising + fast, table + rising + fast + piecewise("", "40,5,3,9,1\n"),
        fast + rising + piecewise("", "0,0,3,0,1\n") + "*DEFINE_TABLE_2D\n3,2\n0,7\n50,8\n"}) {
    INFO(text);
    const auto rates = law(text);
    CHECK(rates.flow_stress(.05, 0.) == Approx(350));
    CHECK(rates.flow_stress(.05, 25.) == Approx(.75 * 350 + .25 * 520));
    CHECK(rates.flow_stress(.05, 1e5) == Approx(520));
    CHECK(rates.flow_stress(.15, 100.) == Approx(520 + .1 * 400));  // each curve goes on
  }
  // a first rate below 0 makes all of them logarithms
  const auto logarithmic = law(piecewise("", "0,0,3,0,1\n") + "*DEFINE_TABLE\n3\n-2\n4\n" + rising + fast);
  CHECK(logarithmic.flow_stress(0., std::exp(1.)) == Approx(400));
  CHECK(logarithmic.flow_stress(0., std::exp(-5.)) == 300);
  const auto between =
      law("*MAT_PIECEWISE_LINEAR_PLASTICITY_LOG_INTERPOLATION\n1,1,210e3\n0,0,3,0,1\n*DEFINE_TABLE\n"
          "3\n1\n100\n" +
          rising + fast);
  CHECK(between.flow_stress(0., 10.) == Approx(400));
  // a table of one curve
  CHECK(law(piecewise("", "0,0,3,0,1\n") + "*DEFINE_TABLE\n3\n5\n" + rising).flow_stress(.05, 1e3) == Approx(350));

  // curves that cross: that of the lower rate counts where it is above
  const DynaDeck crossing =
      read_cube(piecewise("", "0,0,3,0,1\n") + table + rising + "*DEFINE_CURVE\n8\n0,350\n.1,380\n");
  CHECK(crossing.warnings ==
        std::vector<std::string>{"A stress below that of a slower curve (which is taken) of a table (1) had no effect: "
                                 "line 16."});
  CHECK(crossing.material<TabulatedRatesMaterial>(1).strength.flow_stress(.1, 100.) == Approx(400));

  refuses_cube(piecewise("", "0,0,3\n") + "*DEFINE_TABLE_2D\n3\n0,7\n", "the curve 7 of material 1 is not in the file");
  refuses_cube(piecewise("", "0,0,3\n") + "*DEFINE_TABLE\n3\n5\n1\n" + rising + fast,
               "material 1 cannot follow its points: the rate of test 2 of TabulatedRates is 1; it must be above 5");
  std::string many = "*DEFINE_TABLE\n3\n", curves;
  for (int i = 0; i < 300; ++i) {
    many += std::to_string(i) + "\n";
    curves += "*DEFINE_CURVE\n" + std::to_string(100 + i) + "\n";
    for (int k = 0; k < 100; ++k) curves += std::to_string(300 * k + i) + "e-5,300\n";
  }
  refuses_cube(piecewise("", "0,0,3\n") + many + curves,
               "material 1 makes a table of 300 rates and 30299 strains of its curves, too large for its file");
  refuses_cube(piecewise("", "0,0,3\n") + "*DEFINE_TABLE\n3\n", "a TabulatedRates has no tests");
}
