// Cards of LS-DYNA's materials with laws of their own: the value of each, and what of a card is told.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <strike/input/dyna.hpp>
#include <strike/load/rigid_body.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/cowper_symonds.hpp>

#include "input/dyna_cube.hpp"
#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

/// The names of the values that had no effect, one after the other.
std::string ignored(const DynaDeck& deck) {
  std::string all;
  for (const std::string& warning : deck.warnings) {
    CHECK_THAT(warning, ContainsSubstring(" had no effect: line"));
    all += warning.substr(0, warning.find(" of *")) + ";";
  }
  return all;
}
/// The material of the cube, of which nothing is told.
template <class M>
M material(const std::string& text) {
  INFO(text);
  const DynaDeck deck = read_cube(text);
  CHECK(ignored(deck) == "");
  return deck.material<M>("cube");
}

}  // namespace

TEST_CASE("dyna laws: kinematic hardening by BETA, isotropic with a rate") {
  for (const std::string name : {"*MAT_PLASTIC_KINEMATIC", "*MAT_003"}) {
    const auto m = material<KinematicMaterial>(name + "\n1,7.8e-9,210e3,.3,250,2100\n0,0,.4\n");
    CHECK(m.strength.shear_modulus == Approx(210e3 / 2.6));
    CHECK(m.strength.yield_stress == 250);
    CHECK(m.strength.hardening_modulus == Approx(210e3 * 2100 / (210e3 - 2100)));
    CHECK(m.strength.isotropic_share == 0);  // a blank
    CHECK(m.failure->failure_strain == .4);
    CHECK(Solid{m.eos, m.strength}.density() == 7.8e-9);
    CHECK(material<KinematicMaterial>(name + "\n1,1,210,.3,1,2,.25\n").strength.isotropic_share == .25);
  }
  CHECK(material<PlasticMaterial>("*MAT_003\n1,1,210,.3,1,2,1.\n").strength.hardening_modulus > 0);
  CHECK(material<PlasticMaterial>("*MAT_003\n1,1,210,.3,1\n").strength.hardening_modulus == 0);  // does not harden
  const DynaDeck rate = read_cube("*MAT_003\n1,1,210,.3,1,2,.5\n40,5,0,1\n");
  CHECK(ignored(rate) == "BETA (hardening with a rate is isotropic here);");
  CHECK(rate.material<PlasticMaterial>(1).strength.flow_stress(0., 40.) == Approx(2));
  refuses_cube("*MAT_003\n1,1,210,.3,1,2,1.5\n", "BETA is not between 0 and 1: correct it.");
}

TEST_CASE("dyna laws: plasticity without a rate by the moduli, and by a power of the strain") {
  for (const std::string name : {"*MAT_ISOTROPIC_ELASTIC_PLASTIC", "*MAT_012"}) {
    const auto m = material<PlasticMaterial>(name + "\n1,7.8e-9,80e3,250,900,170e3\n");
    CHECK(m.eos.bulk_modulus == 170e3);
    CHECK(m.strength.shear_modulus == 80e3);
    CHECK(m.strength.flow_stress(.1, 0.) == Approx(250 + .1 * 900));  // ETAN is the hardening modulus
  }
  refuses_cube("*MAT_012\n1,1,80,1\n", "BULK is not positive");

  const auto at_yield = [](const std::string& yield, const std::string& rate = "") {
    return material<PowerMaterial>("*MAT_POWER_LAW_PLASTICITY\n1,7.8e-9,200e3,.3,600,.2" + rate + "\n" + yield + "\n");
  };
  const auto elastic = at_yield("");
  CHECK(elastic.strength.flow_stress(0.) == Approx(200e3 * elastic.strength.initial_strain));  // meets E e
  CHECK(elastic.strength.flow_stress(.3) == Approx(600 * std::pow(elastic.strength.initial_strain + .3, .2)));
  CHECK(at_yield("350").strength.flow_stress(0.) == Approx(350));
  CHECK(at_yield(".01").strength.flow_stress(0.) == Approx(600 * std::pow(.01, .2)));  // a strain
  CHECK(at_yield("350,1,.7").failure->failure_strain == .7);
  const auto rated = at_yield("350,1", ",40,5");
  CHECK(CowperSymonds{rated.strength, rated.rate->D, rated.rate->p}.flow_stress(0., 40. * 32) == Approx(3 * 350));
  CHECK(material<PowerMaterial>("*MAT_018\n1,1,200,.3,1,.5\n").strength.exponent == .5);
  refuses_cube("*MAT_018\n1,1,200,.3,1\n", "K and N leave no strain at yield");
  refuses_cube("*MAT_018\n1,1,200,.3,1,2\n", "N is not between 0 and 1");
}

TEST_CASE("dyna laws: the points of a material with an equation of state") {
  for (const std::string name : {"*MAT_ELASTIC_PLASTIC_HYDRO", "*MAT_010"}) {
    const DynaDeck deck = read_cube(name + "\n1,2e-6,10,.1,.2,-.5,1.5\n0,.1,.2,.3,.4,.5,.6,.7\n.9\n" +
                                    "1,2,3,4,5,6,7,8\n10\n*EOS_LINEAR_POLYNOMIAL\n1,0,2\n");
    CHECK(ignored(deck) == "");
    const auto& m = deck.material<TabulatedHydroMaterial>("cube");
    CHECK(m.strength.shear_modulus == 10);
    for (const double e : {0., .25, .8, .9, 1.2}) CHECK(m.strength.flow_stress(e) == Approx(1 + 10 * e));
    CHECK(m.failure->failure_strain == 1.5);
    const auto eos = deck.eos<PolynomialEos>("cube");
    CHECK(eos.density == 2e-6);
    CHECK(eos.pressure_cutoff == -.5);
    CHECK(Solid{eos, m.strength}.density() == 2e-6);
  }
  refuses_cube("*MAT_010\n1,1,1\n0,.1\n\n1,-1\n", "material 1 cannot follow its points: the stress of point 1");
}

TEST_CASE("dyna laws: Johnson and Cook without heat, Zerilli and Armstrong") {
  for (const std::string name : {"*MAT_SIMPLIFIED_JOHNSON_COOK_TITLE\nsteel", "*MAT_098_TITLE\nsteel"}) {
    const auto m =
        material<SimplifiedJohnsonCookMaterial>(name + "\n1,7.8e-9,210e3,.3,1\n300,500,.3,.02,.6,0,0,.001\n");
    CHECK(m.eos.bulk_modulus == Approx(210e3 / 1.2));
    CHECK(m.strength.flow_stress(.1, 1., 900.) ==
          Approx((300 + 500 * std::pow(.1, .3)) * (1 + .02 * std::log(1000))));  // at any temperature
    CHECK(m.failure->failure_strain == .6);
    CHECK(Solid{m.eos, m.strength}.density() == 7.8e-9);
  }
  CHECK(material<SimplifiedJohnsonCookMaterial>("*MAT_098\n1,1,2\n3\n").strength.reference_rate == 1);
  CHECK(material<SimplifiedJohnsonCookMaterial>("*MAT_098\n1,1,2\n3,4\n").strength.flow_stress(.5, 1., 300.) == 7);
  CHECK(ignored(read_cube("*MAT_098\n1,1,2\n3,0,0,.1,0,4,5\n")) ==
        "SIGMAX;SIGSAT;VP 0 (the rate is that of the plastic strain, as of VP 1);");

  const std::string names[]{"*MAT_MODIFIED_ZERILLI_ARMSTRONG\n", "*MAT_065\n"};
  for (const std::string& name : names) {  // copper, fcc, and iron, bcc; C3 and C4 by the kelvin
    const auto fcc = material<ZerilliArmstrongMaterial>(
        name + "1,8.9e-6,48,1,0,300,-9\n.05,.89,.0028,.000115,.015,0,.9,1\n1,0,0,400\n");
    CHECK(fcc.strength.flow_stress(.25, 100., 500.) ==
          Approx(.065 + .89 * .5 * std::exp((-.0028 + .000115 * std::log(100)) * 500)));
    CHECK(fcc.strength.heating == Approx(1 / (8.9e-6 * 400)));
    CHECK(fcc.failure->failure_strain == .9);
    const auto bcc = material<ZerilliArmstrongMaterial>(
        name + "1,7.8e-6,80,.001,.289,0,0\n.065,1.033,.00698,.000415,.266,.01,0,1\n");
    CHECK(bcc.strength.flow_stress(.1, 1., 400.) ==
          Approx(.075 + .266 * std::pow(.1, .289) + 1.033 * std::exp((-.00698 + .000415 * std::log(1e3)) * 400)));
    CHECK(bcc.strength.initial_temperature == 293);
  }
  const DynaDeck hot = read_cube(names[0] + "1,1,80,1,.3,300,-9,2\n1,2,3,4,5,6,0,1\n1.1,-.0002,0,4,5,6,7,8\n" +
                                 "*EOS_GRUNEISEN\n1,3940,1.5\n");
  CHECK(ignored(hot) == "SPALL;The change of B2 and B3 with the temperature;G2;G3;G4;BULK;");
  CHECK(hot.material<ZerilliArmstrongMaterial>(1).strength.C5 == Approx(5 * (1.1 - .0002 * 300)));
  CHECK(hot.eos<GruneisenEos>("cube").pressure_cutoff == -9);
}

TEST_CASE("dyna laws: rubber and viscoelastic materials") {
  for (const std::string name : {"*MAT_MOONEY-RIVLIN_RUBBER", "*MAT_027"}) {
    const auto m = material<RubberMaterial>(name + "\n1,1e-9,.49,.5,.1\n");
    CHECK(m.strength.C10 == .5);
    CHECK(m.strength.C01 == .1);
    CHECK(m.strength.shear_modulus == Approx(1.2));
    CHECK(m.eos.bulk_modulus == Approx(2 * 1.2 * 1.49 / (3 * .02)));
    CHECK(Solid{m.eos, m.strength}.density() == 1e-9);
  }
  refuses_cube("*MAT_027\n1,1,.49\n", "A and B are 0: give the material its A and B.");
  const DynaDeck fitted = read_cube("*MAT_027\n1,1,.49\n1,1,1,7\n");
  CHECK(fitted.warnings == std::vector<std::string>{"The material (no curve is fitted here) of *MAT_027 (1) had no "
                                                    "effect: line 17."});
  CHECK_THROWS_WITH(fitted.material<RubberMaterial>("cube"),
                    ContainsSubstring("which is not in the deck or was skipped"));
  CHECK(ignored(read_cube("*MAT_027\n1,1,.49,1,-.2\n")) == "The material (A or B is negative);");

  for (const std::string name : {"*MAT_VISCOELASTIC", "*MAT_006"}) {
    const auto m = material<ViscoelasticMaterial>(name + "\n1,1e-9,2000,10,4,.5\n");
    for (const double t : {0., 1., 3., 100.})
      CHECK(m.strength.relaxation(t) == Approx(4 + (10 - 4) * std::exp(-.5 * t)));
    CHECK(m.eos.bulk_modulus == 2000);
    CHECK(Solid{m.eos, m.strength}.density() == 1e-9);
  }
  CHECK(material<ViscoelasticMaterial>("*MAT_006\n1,1,20,10,4\n").strength.relaxation(9) == 10);  // no decay
  refuses_cube("*MAT_006\n1,1,20,10,14,1\n", "GI is not between 0 and G0");
  CHECK(ignored(read_cube("*MAT_006\n1,1,20,10,4,-7\n")) == "The material (BETA is a curve);");

  for (const std::string name : {"*MAT_GENERAL_VISCOELASTIC", "*MAT_076"}) {
    const auto m = material<PronyMaterial>(name + "\n1,1e-9,2000\n\n10,.5\n20,5\n3,0\n");
    for (const double t : {0., .1, 1., 100.}) {
      const double G = 10 * std::exp(-.5 * t) + 20 * std::exp(-5 * t) + 3;
      CHECK(m.strength<2>().relaxation(t) == Approx(G));
      CHECK(m.strength<4>().relaxation(t) == Approx(G));
    }
    CHECK(m.eos.bulk_modulus == 2000);
    CHECK(Solid{m.eos, m.strength<2>()}.density() == 1e-9);
    CHECK_THROWS_WITH(m.strength<1>(), "strike: the material has 2 terms of relaxation: read it by strength<2>().");
  }
  const DynaDeck bulk = read_cube("*MAT_076\n1,1,0,1\n\n10,.5,100,0\n20,5,50,2\n");
  CHECK(ignored(bulk) == "PCF;BETAKI;");
  CHECK(bulk.material<PronyMaterial>(1).eos.bulk_modulus == 150);
  CHECK(ignored(read_cube("*MAT_076\n1,1,9\n7\n")) == "The material (no curve is fitted here);");
  refuses_cube("*MAT_076\n1,1,9\n", "GI are all 0: give the material its terms.");
  refuses_cube("*MAT_076\n1,1,9\n\n-1,1\n", "a term of relaxation is negative");
}

TEST_CASE("dyna laws: rigid bodies with their constraints in space, and in axes of their own") {
  using Axes = std::vector<Eigen::Vector3d>;
  const Eigen::Vector3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const auto free = material<RigidMaterial>("*MAT_RIGID\n1,7.8e-9,210e3,.3\n");
  CHECK(free.density == 7.8e-9);
  CHECK(free.youngs_modulus == 210e3);
  CHECK(free.poissons_ratio == .3);
  CHECK(free.directions().empty());
  CHECK(free.axes().empty());
  const std::vector<Axes> codes{{}, {x}, {y}, {z}, {x, y}, {y, z}, {x, z}, {x, y, z}};
  for (std::size_t code = 0; code < 8; ++code) {
    const std::string cards =
        "*MAT_020\n1,7.8e-9,210e3,.3\n1.0," + std::to_string(code) + "," + std::to_string(7 - code) + "\n";
    const auto m = material<RigidMaterial>(cards);
    CHECK(m.directions() == codes[code]);
    CHECK(m.axes() == codes[7 - code]);
  }
  const auto local = material<RigidMaterial>(  // the system stands after it; its x is y
      "*MAT_020\n1,7.8e-9,210e3,.3\n-1,5,100001\n*DEFINE_COORDINATE_VECTOR\n5,0,1,0,-1,0,0\n");
  CHECK(local.directions() == Axes{y});
  CHECK(local.axes() == Axes{z});
  CHECK(ignored(read_cube("*MAT_020\n1,1,1,.3,1,2,3\n0\n1,2\n")) == "N;COUPLE;M;LCO or A and V;");
  refuses_cube("*MAT_020\n1,1,1,.3\n1,8\n", "the constraint 8 of a rigid material is none: give 0 to 7.");
  refuses_cube("*MAT_020\n1,1,1,.3\n-1,0,111112\n", "CON2 111112 is none: give six digits of 0 or 1");
  refuses_cube("*MAT_020\n1,1,1,.3\n-1,5,1\n", "coordinate system 5 is not in the file");
  refuses_cube("*MAT_020\n1,1,1,.3\n2\n", "CMO is neither 1, 0 nor -1");

  const DynaDeck deck = read_cube("*MAT_020\n1,7.8e-9,210e3,.3\n1,4,7\n");
  const auto& m = deck.material<RigidMaterial>("cube");
  const RigidBody body{Mesh{deck.mesh.nodes, deck.part("cube").hexahedra}, m.density,
                       HeldBody{m.directions(), m.axes()}};
  (void)body;
}

TEST_CASE("dyna laws: explosives, their products and where they are lit") {
  const std::string jwl = "*EOS_JWL\n1,3.712e5,3.231e3,4.15,.95,.3,7e3\n";
  for (const std::string name : {"*MAT_HIGH_EXPLOSIVE_BURN", "*MAT_008"}) {
    const DynaDeck deck =
        read_cube(name + "\n1,1.63e-9,6.93e6,2.1e4\n" + jwl + "*INITIAL_DETONATION\n1,.1,.2,.3,1e-6\n\n0,4,5,6\n");
    CHECK(ignored(deck) == "");
    const auto& m = deck.material<ExplosiveMaterial>("cube");
    CHECK(m.density == 1.63e-9);
    CHECK(m.burn(4).detonation_velocity == 6.93e6);
    CHECK(m.burn(4).front_width == 4);
    CHECK(m.burn(4).pressure_CJ == 2.1e4);
    const auto eos = deck.eos<Jwl>("cube");
    CHECK(eos.density == 1.63e-9);
    const double V = 1.5;
    CHECK(eos.A(1 / V - 1) + eos.B(1 / V - 1) * 7e3 ==
          Approx(3.712e5 * (1 - .3 / (4.15 * V)) * std::exp(-4.15 * V) +
                 3.231e3 * (1 - .3 / (.95 * V)) * std::exp(-.95 * V) + .3 * 7e3 / V));
    CHECK(eos.initial_energy == 7e3);
    REQUIRE(deck.detonations.size() == 2);
    CHECK(deck.detonations[0].part == 1);
    CHECK(deck.detonations[0].start.place == Eigen::Vector3d(.1, .2, .3));
    CHECK(deck.detonations[0].start.time == 1e-6);
    CHECK(deck.detonations[1].part == 0);
    CHECK(Explosive{eos, deck.detonations[0].start, m.burn(4)}.density() == 1.63e-9);
  }
  CHECK(material<ExplosiveMaterial>("*MAT_008\n1,1.6e-9,7e6,2e4,2\n").pressure_CJ == 0);
  CHECK(ignored(read_cube("*MAT_008\n1,1.6e-9,7e6,2e4,1,5,6,7\n*EOS_002\n1,1,1,1,1,1,1,2\n")) ==
        "BETA 1 (the front of a detonation lights it too);K;G;SIGY;VO;");
  const DynaDeck acoustic = read_cube("*INITIAL_DETONATION\n-1,1,2,3\n4,5,6\n1,7,8,9\n-3,1,2,3\n");
  CHECK(ignored(acoustic) == "PID below 0;");
  REQUIRE(acoustic.detonations.size() == 1);
  CHECK(acoustic.detonations[0].start.place == Eigen::Vector3d(7, 8, 9));
  refuses_cube("*MAT_008\n1,1e-9,1e3,2e4\n", "PCJ is not below RO D^2");
}

TEST_CASE("dyna laws: failure and erosion that a material adds") {
  const DynaDeck deck =
      read_cube("*MAT_ELASTIC\n1,1,1\n*MAT_ADD_EROSION_TITLE\nfails\n1,0,0,0,1.5,-2\n0,50,60,0,0,20,800\n");
  CHECK(ignored(deck) == "");
  REQUIRE(deck.erosions.size() == 1);
  const ErosionCard& erosion = deck.erosions[0];
  CHECK(erosion.material == 1);
  CHECK(erosion.strain == 1.5);
  CHECK(erosion.volume == Approx(std::exp(-2)));
  CHECK(erosion.principal_stress->strength == 50);
  CHECK(erosion.equivalent_stress->ultimate_stress == 60);
  // (s1 - SIGTH)^2 t = IMPULSE
  const TulerButcher& law = *erosion.impulse;
  CHECK(law.threshold == 20);
  CHECK(std::pow(10 / law.strength, law.exponent) * (800 / 100.) / law.duration == Approx(1));
  const ErosionCard none = read_cube("*MAT_ADD_EROSION\n1,1234,1234,1234,1234,1234\n1234,1234,1234\n").erosions[0];
  CHECK(none.strain == std::numeric_limits<double>::infinity());
  CHECK(none.volume == 0);
  CHECK_FALSE(none.principal_stress);
  CHECK(read_cube("*MAT_ADD_EROSION\n1\n0,0,0,0,0,0,800\n").erosions[0].impulse->duration == 800);
  CHECK(ignored(read_cube("*MAT_ADD_EROSION\n1,0,2,3,-4,5,2,2\n6,0,-7,8,9,0,0,10\n")) ==
        "MXPRES;MNEPS;VOLEPS above 0;NUMFIP;NCS;MNPRES;SIGVM below 0;MXEPS;EPSSH;FAILTM;");
  refuses_cube("*MAT_ADD_EROSION\n0\n", "a material to erode has no number");
}

TEST_CASE("dyna laws: plies") {
  for (const std::string name : {"*MAT_ENHANCED_COMPOSITE_DAMAGE", "*MAT_054"}) {
    const auto m = material<PlyMaterial>(name +
                                         "\n1,1.6e-9,140e3,9e3,,.0193,,.4\n5e3,3e3,4e3,0,2\n0,0,0,0,1,0,30\n"
                                         "0,0,0,0,0,0\n\n1200,2000,200,50,90,54,.5\n");
    CHECK(m.ply.density == 1.6e-9);
    CHECK(m.ply.E1 == 140e3);
    CHECK(m.ply.E2 == 9e3);
    CHECK(m.ply.nu12 == Approx(.0193 * 140 / 9));
    CHECK(m.ply.G12 == 5e3);
    CHECK(m.ply.G23 == 3e3);
    CHECK(m.ply.G13 == 4e3);
    CHECK(m.ply.nu23 == .4);
    CHECK(m.ply.angle == 30);
    CHECK(*m.fibres == Eigen::Vector3d(0, 1, 0));
    CHECK(m.criterion.Xc == 1200);
    CHECK(m.criterion.Xt == 2000);
    CHECK(m.criterion.Yc == 200);
    CHECK(m.criterion.Yt == 50);
    CHECK(m.criterion.S == 90);
    CHECK(m.criterion.beta == .5);
    CHECK(FailingPly{m.ply, m.criterion}.density() == 1.6e-9);
  }
  for (const std::string name : {"*MAT_COMPOSITE_DAMAGE", "*MAT_022"}) {
    const auto m =
        material<PlyMaterial>(name + "\n1,1.6e-9,140e3,9e3,9e3,.0193\n5e3,3e3,4e3\n\n0,0,0,0,0,0,45\n90,2000,50,200\n");
    CHECK(m.criterion.S == 90);
    CHECK(m.criterion.Xt == 2000);
    CHECK(m.criterion.Yt == 50);
    CHECK(m.criterion.Yc == 200);
    CHECK(m.criterion.Xc == 1e18);  // the card has none
    CHECK(m.ply.angle == 45);
    CHECK_FALSE(m.fibres);
  }
  CHECK(ignored(read_cube(
            "*MAT_054\n1,1,2,2\n1,1,1,0,3,1\n\n0,0,0,0,0,0,.1,.2\n1e-7,.1,.5,.5,2,.1,.2,.3\n1,1,1,1,1,55\n")) ==
        "2WAY;AOPT (the direction of fibres is that of the section);DFAILM;DFAILS;TFAIL;ALPH;SOFT;FBRT;YCFAC;DFAILT;"
        "DFAILC;EFS;CRIT;");
  refuses_cube("*MAT_022\n1,1,140,9,1,.9\n1,1,1\n", "PRBA squared is not below EB/EA");
}

TEST_CASE("dyna laws: a table of pressures by points, falling or rising, in every format") {
  // p = C + GAMA T E: 0 at rest, 1 and 3 at the strains -0.1 and -0.2, with GAMA T of 0.8, 1.2 and 2
  const std::string falls = "0,-.1,-.2\n\n0,1,3\n\n.4,.6,1\n", rises = "-.2,-.1,0\n\n3,1,0\n\n1,.6,.4\n";
  const auto wide = [](const std::string& keyword, std::size_t head, std::size_t width) {
    std::string text = keyword + "\n";
    const auto add = [&](const std::string& field, std::size_t w) {
      text += std::string(w - field.size(), ' ') + field;
    };
    for (const char* field : {"1", "2.0", "7.0", "1.0"}) add(field, head);
    text += "\n$ volumetric strains\n";
    for (const char* row : {"0.0 -0.1 -0.2", "0.0 1.0 3.0", "0.4 0.6 1.0"}) {
      for (const char* c = row;; ++c) {
        std::string field;
        for (; *c != ' ' && *c != '\0'; ++c) field += *c;
        add(field, width);
        if (*c == '\0') break;
      }
      add("0.0", width), text += "\n";
      for (int i = 0; i < 5; ++i) add("0.0", width);
      text += "\n";
    }
    return text;
  };
  for (const std::string& text :
       {"*EOS_TABULATED\n1,2,7\n" + falls, "*EOS_009\n1,2,7,1\n" + rises, "*EOS_TABULATED_TITLE\nclay\n1,2,7\n" + falls,
        wide("*EOS_TABULATED", 10, 16), wide("*EOS_TABULATED +", 20, 20)}) {
    INFO(text);
    const DynaDeck deck = read_cube("*MAT_NULL\n1,2e-6,-.5\n" + text);
    CHECK(ignored(deck) == "");
    const auto eos = deck.eos<TabulatedEos>("cube");
    CHECK(eos.density == 2e-6);
    CHECK(eos.pressure_cutoff == -.5);
    CHECK(eos.gamma == 2);
    CHECK(eos.initial_energy == 7);
    CHECK(eos.points().size() == 3);
    for (const auto& [e, C, B] :
         {std::array{0., 0., .8}, {-.1, 1., 1.2}, {-.15, 2., 1.6}, {-.3, 5., 2.8}, {.2, -2., 0.}}) {
      CHECK(eos.A(std::expm1(-e)) == Approx(C).margin(1e-14));
      CHECK(eos.B(std::expm1(-e)) == Approx(B).margin(1e-14));
    }
  }
  const auto points = [](const std::string& rows) {
    const DynaDeck deck = read_cube("*MAT_NULL\n1,2e-6\n*EOS_TABULATED\n1\n" + rows);
    CHECK(ignored(deck) == "");
    return deck.eos<TabulatedEos>(1).points();
  };
  // Zeros end a table, but a rising one of C alone ends at rest; the first point may be at rest, or one between.
  CHECK(points("-.2,-.1\n\n3,1\n").size() == 3);
  CHECK(points("-.2,-.1\n\n3,1\n\n.5,.4\n").size() == 2);
  CHECK(points("0,-.1\n\n0,1\n").size() == 2);
  CHECK(points(".1,0,-.1\n\n-1,0,1\n").size() == 3);
  CHECK(points("-.1,0,.1\n\n1,0,-1\n").size() == 3);
  CHECK(points("0,-.1,-.2,-.3,-.4\n-.5,-.6,-.7,-.8,-.9\n0,1,2,3,4\n5,6,7,8,9\n").size() == 10);
  CHECK(ignored(read_cube("*MAT_NULL\n1,1\n*EOS_009\n1,,,.9,,,3\n0,-.1\n\n0,1\n")) == "V0;Further fields;");

  refuses_cube("*EOS_TABULATED\n1\n",
               "line 16: equation of state 1 cannot follow its points: a TabulatedEos has 0 points");
  refuses_cube("*EOS_TABULATED\n1\n0,-.1,-.05,-.2\n\n0,1,2,3\n",
               "line 16: equation of state 1 cannot follow its points: the volumetric_strain of point 2");
  refuses_cube("*EOS_TABULATED\n1\n0,-.1\n\n0,-1\n", "the bulk modulus from point 0 to point 1 is -10");
  CHECK_THROWS_WITH(read_cube("*MAT_NULL\n1,2e-6\n*EOS_TABULATED\n1\n0,-.1\n\n0,1\n").eos<PolynomialEos>(1),
                    "strike: the equation of state 1 of part 1 is *EOS_TABULATED: read it as TabulatedEos.");
}

TEST_CASE("dyna laws: a table of pressures by curves, wherever they stand") {
  const std::string null = "*MAT_NULL\n1,2e-6\n", cold = "*DEFINE_CURVE\n7\n-.2,3\n-.1,1\n0,0\n",
                    hot = "*DEFINE_CURVE\n8\n-.3,2\n0,.5\n", both = "*EOS_TABULATED\n1,2,7,1,7,8\n";
  for (const std::string& text : {null + both + cold + hot, cold + null + hot + both + "0,-.1\n\n0,50\n"}) {
    const auto eos = read_cube(text).eos<TabulatedEos>("cube");
    CHECK(eos.points().size() == 4);  // the strains of both
    for (const auto& [e, C, T] :
         {std::array{0., 0., .5}, {-.1, 1., 1.}, {-.2, 3., 1.5}, {-.25, 4., 1.75}, {.1, -1., 0.}}) {
      CHECK(eos.A(std::expm1(-e)) == Approx(C).margin(1e-14));
      CHECK(eos.B(std::expm1(-e)) == Approx(2 * T).margin(1e-14));
    }
    CHECK(eos.A(0.) == 0);
  }
  // The other one by points, or none.
  const auto by_C = read_cube(null + "*EOS_009\n1,2,7,1,7\n0,-.3\n\n\n\n.5,2\n" + cold).eos<TabulatedEos>(1);
  CHECK(by_C.A(std::expm1(.2)) == Approx(3));
  CHECK(by_C.B(std::expm1(.2)) == Approx(3));
  const auto by_T = read_cube(null + "*EOS_009\n1,2,7,1,,8\n0,-.1\n\n0,1\n" + hot).eos<TabulatedEos>(1);
  CHECK(by_T.A(std::expm1(.2)) == Approx(2));
  CHECK(by_T.B(std::expm1(.2)) == Approx(3));
  CHECK(read_cube(null + "*EOS_009\n1,2,7,1,7\n" + cold).eos<TabulatedEos>(1).B(1.) == 0);

  refuses_cube(both + hot, "line 16: the curve 7 of equation of state 1 is not in the file: define it");
  refuses_cube(both + hot + "*DEFINE_CURVE\n7\n0,0\n",
               "curve 7 of equation of state 1 has 1 point: give it at least two");
  refuses_cube(both + hot + "*DEFINE_CURVE\n7\n-.1,3\n-.1,1\n",
               "curve 7 of equation of state 1 does not rise from the strain -0.1 to -0.1");
}
