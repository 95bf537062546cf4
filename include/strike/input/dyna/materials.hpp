#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <strike/input/dyna/draft.hpp>
#include <strike/input/dyna/explosives.hpp>
#include <strike/input/dyna/hardening.hpp>
#include <strike/input/dyna/material_head.hpp>
#include <strike/input/dyna/soft_materials.hpp>
#include <strike/input/dyna/tabulated_eos.hpp>

// Materials and equations of state (LS-DYNA Keyword User's Manual R13, volume II).
namespace strike::detail::dyna {

/// H = E ETAN/(E - ETAN).
inline double hardening_modulus(const Elastic& m, double tangent, const File& file) {
  if (!(tangent < m.youngs_modulus)) file.refuse({"ETAN is not below E: correct the tangent modulus."});
  return m.youngs_modulus * tangent / (m.youngs_modulus - tangent);
}
inline std::optional<RateConstants> rate_constants(double D, double p) {
  return D > 0 && p > 0 ? std::optional(RateConstants{D, p}) : std::nullopt;
}
inline PlasticMaterial plastic(const LinearEos& eos, double G, double yield, double hardening,
                               const std::optional<RateConstants>& rate) {
  RateVonMises strength{G, yield, hardening};
  if (rate) strength.rate_factor = std::pow(rate->D, -1 / rate->p), strength.rate_exponent = 1 / rate->p;
  return {eos, strength};
}
/// VP of a material with a rate, which is that of the plastic strain here (VP 1).
inline void expect_plastic_rate(File& file, double VP, bool has_rate) {
  if (VP != 1 && has_rate) file.ignore(1, "VP 0 (the rate is that of the plastic strain, as of VP 1)");
}

inline void elastic(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  const Elastic material = elastic_of(head, file);
  file.ignore_rest(head.card);
  add(file, draft, head, material);
}
inline void plastic_kinematic(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  const Elastic m = elastic_of(head, file);
  const double yield = head.card.number("SIGY"), tangent = head.card.number("ETAN"), beta = head.card.number("BETA");
  if (!(beta >= 0 && beta <= 1)) file.refuse({"BETA is not between 0 and 1: correct it."});
  const std::uint32_t line = file.line();
  Card rate = file.card();
  const double D = rate.number("SRC"), p = rate.number("SRP");
  const auto constants = rate_constants(D, p);
  const double hardening = hardening_modulus(m, tangent, file);
  const auto failure = failure_at(rate.number("FS"));
  expect_plastic_rate(file, rate.number("VP"), constants.has_value());
  file.ignore_rest(head.card, rate);
  const LinearEos eos{m.density, m.bulk_modulus()};
  if (hardening > 0 && beta < 1 && !constants) {
    add(file, draft, head, KinematicMaterial{eos, {m.shear_modulus(), yield, hardening, beta}, failure});
    return;
  }
  if (hardening > 0 && beta < 1)
    file.ignore_on_line(line, joined({"BETA (hardening with a rate is isotropic here) of ", file.name()}));
  PlasticMaterial material = plastic(eos, m.shear_modulus(), yield, hardening, constants);
  material.failure = failure;
  add(file, draft, head, material);
}
inline void isotropic_plastic(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  const double G = head.card.positive("G"), yield = head.card.number("SIGY"), hardening = head.card.number("ETAN");
  const double K = head.card.positive("BULK");
  file.ignore_rest(head.card);
  add(file, draft, head, plastic({head.density, K}, G, yield, hardening, std::nullopt));
}
/// K (e0 + e)^N: e0 is SIGY below 0.02, (SIGY/K)^(1/N) of a larger one, that of the elastic line, (E/K)^(1/(N - 1)), of
/// none.
inline void power_law(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  const Elastic m = elastic_of(head, file);
  const double K = head.card.positive("K"), n = head.card.number("N", 1);
  if (!(n > 0 && n <= 1)) file.refuse({"N is not between 0 and 1: correct it."});
  const double D = head.card.number("SRC"), p = head.card.number("SRP");
  const auto constants = rate_constants(D, p);
  Card more = file.card();
  const double yield = more.number("SIGY");
  expect_plastic_rate(file, more.number("VP"), constants.has_value());
  const auto failure = failure_at(more.number("EPSF"));
  file.ignore_rest(head.card, more);
  const double e0 = yield == 0     ? std::pow(m.youngs_modulus / K, 1 / (n - 1))
                    : yield < 0.02 ? yield
                                   : std::pow(yield / K, 1 / n);
  if (!(e0 > 0) || !std::isfinite(e0)) file.refuse({"K and N leave no strain at yield: give the material its SIGY."});
  add(file, draft, head,
      PowerMaterial{{m.density, m.bulk_modulus()}, {m.shear_modulus(), K, n, e0}, constants, failure});
}
inline void simplified_johnson_cook(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  const Elastic m = elastic_of(head, file);
  const double VP = head.card.number("VP");
  Card law = file.card();
  JohnsonCook s{.shear_modulus = m.shear_modulus(), .A = law.number("A"), .B = law.number("B"), .n = 1};
  const double n = law.number("N");
  if (n != 0)
    s.n = n;
  else
    s.A += s.B, s.B = 0;
  s.C = law.number("C");
  const auto failure = failure_at(law.number("PSFAIL"));
  file.ignore(law.number("SIGMAX"), "SIGMAX");
  file.ignore(law.number("SIGSAT"), "SIGSAT");
  s.reference_rate = law.number("EPS0", 1);
  expect_plastic_rate(file, VP, s.C != 0);
  file.ignore_rest(head.card);
  add(file, draft, head, SimplifiedJohnsonCookMaterial{{m.density, m.bulk_modulus()}, s, failure});
}
/// Of fcc metals N is 0: C1 + {C2 sqrt(e) exp[(-C3 + C4 ln r) T] + C5} m; of bcc metals
/// C1 + C2 exp[(-C3 + C4 ln r) T] + [C5 e^N + C6] m, where m = B1 + B2 T + B3 T^2 stays that of TROOM; 1 without any.
inline void zerilli_armstrong(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  ZerilliArmstrong s{.shear_modulus = head.card.positive("G"), .C0 = 0, .C3 = 0, .C4 = 0};
  s.reference_rate = head.card.number("E0", 1);
  const double n = head.card.number("N");
  s.initial_temperature = head.card.number("TROOM", 293);
  const double cutoff = head.card.number("PC");
  file.ignore(head.card.number("SPALL", 1) - 1, "SPALL");
  Card law = file.card();
  std::array<double, 7> C{};
  for (std::size_t i = 1; i <= 6; ++i) C[i] = law.number("C1 to C6");
  const auto failure = failure_at(law.number("EFAIL"));
  expect_plastic_rate(file, law.number("VP"), true);
  Card heat = file.card();
  const double B1 = heat.number("B1"), B2 = heat.number("B2"), B3 = heat.number("B3"), T = s.initial_temperature;
  const double m = B1 == 0 && B2 == 0 && B3 == 0 ? 1 : B1 + T * (B2 + T * B3);
  file.ignore(std::abs(B2) + std::abs(B3), "The change of B2 and B3 with the temperature");
  const double capacity = heat.number("G1");
  s.heating = capacity > 0 ? 1 / (head.density * capacity) : 0;
  for (const char* name : {"G2", "G3", "G4"}) file.ignore(heat.number(name), name);
  file.ignore(heat.number("BULK"), "BULK");
  s.C3 = C[3], s.C4 = C[4];
  if (n == 0)
    s.C0 = C[1] + m * C[5], s.C2 = m * C[2];
  else
    s.C0 = C[1] + m * C[6], s.C1 = C[2], s.C5 = m * C[5], s.n = n;
  if (Card last = file.card(); n == 0 && last.number("M", 0.5) != 0.5) file.ignore(1, "M");
  add(file, draft, head, ZerilliArmstrongMaterial{head.density, s, failure}, cutoff);
}
inline void rigid(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  RigidMaterial material{head.density, head.card.number("E"), poissons_ratio(head.card, file)};
  for (const char* name : {"N", "COUPLE", "M"}) file.ignore(head.card.number(name), name);
  if (!head.card.text().empty()) file.ignore(1, "ALIAS");
  Card constraint = file.card();
  if (const FileNumber system = held_by_body(constraint, material, "a rigid material", file); system != 0)
    draft.rigid_systems.push_back({draft.deck.materials.size(), system, file.line()});
  Card axes = file.card();
  file.ignore(axes.says_more(), "LCO or A and V");
  add(file, draft, head, material);
}
/// The axis A where AOPT is 2; other ways to tell the fibres are not read.
inline std::optional<Eigen::Vector3d> fibres_of(File& file, double aopt, Card& card) {
  card.pass(3);
  const Eigen::Vector3d A = card.vector("A1 to A3");
  if (aopt == 2 && A.norm() > 0) return A;
  file.ignore(aopt, "AOPT (the direction of fibres is that of the section)");
  return std::nullopt;
}
/// EA, EB, EC, PRBA, PRCA, PRCB, then GAB, GBC, GCA and the fourth field of their card; AOPT follows.
inline OrthotropicPly ply_of(File& file, MaterialHead& head, Card& shear) {
  OrthotropicPly ply{
      .density = head.density, .E1 = head.card.positive("EA"), .E2 = 0, .nu12 = 0, .G12 = 0, .G13 = 0, .G23 = 0};
  ply.E2 = head.card.positive("EB");
  head.card.pass(1);  // EC
  ply.nu12 = head.card.number("PRBA") * ply.E1 / ply.E2;
  if (!(ply.nu12 * ply.nu12 < ply.E1 / ply.E2)) file.refuse({"PRBA squared is not below EB/EA: correct it."});
  head.card.pass(1);  // PRCA
  if (const double ratio = head.card.number("PRCB"); ratio > -1 && ratio < 1 && ratio != 0) ply.nu23 = ratio;
  ply.G12 = shear.positive("GAB");
  ply.G23 = shear.number("GBC", ply.G12), ply.G13 = shear.number("GCA", ply.G12);
  shear.pass(1);  // KFAIL, of solids
  return ply;
}
inline constexpr double unlimited = 1e18;  ///< a strength without limit, of which numbers of float may have the square
inline double strength_of(Card& card, const char* name) { return std::abs(card.number(name, unlimited)); }
inline void composite_damage(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  Card shear = file.card();
  PlyMaterial material{ply_of(file, head, shear), {}};
  const double aopt = shear.number("AOPT");
  file.ignore(shear.number("MACF", 1) - 1, "MACF");
  Card place = file.card(), vectors = file.card(), strengths = file.card();
  material.fibres = fibres_of(file, aopt, place);
  vectors.pass(6);
  material.ply.angle = vectors.number("BETA");
  ChangChang& c = material.criterion;
  c.Xc = unlimited, c.S = strength_of(strengths, "SC"), c.Xt = strength_of(strengths, "XT");
  c.Yt = strength_of(strengths, "YT"), c.Yc = strength_of(strengths, "YC");
  file.ignore(strengths.number("ALPH"), "ALPH");
  strengths.pass(3);  // SN, SYZ, SZX, of solids
  add(file, draft, head, material);
}
inline void enhanced_composite_damage(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  Card shear = file.card();
  PlyMaterial material{ply_of(file, head, shear), {}};
  const double aopt = shear.number("AOPT");
  file.ignore(shear.number("2WAY"), "2WAY");
  Card place = file.card(), vectors = file.card(), failure = file.card(), strengths = file.card();
  material.fibres = fibres_of(file, aopt, place);
  material.ply.angle = place.number("MANGLE");
  vectors.pass(6);
  file.ignore(vectors.number("DFAILM"), "DFAILM");
  file.ignore(vectors.number("DFAILS"), "DFAILS");
  file.ignore(failure.number("TFAIL"), "TFAIL");
  file.ignore(failure.number("ALPH"), "ALPH");
  file.ignore(failure.number("SOFT", 1) - 1, "SOFT");
  for (const char* name : {"FBRT", "YCFAC", "DFAILT", "DFAILC", "EFS"}) file.ignore(failure.number(name), name);
  ChangChang& c = material.criterion;
  c.Xc = strength_of(strengths, "XC"), c.Xt = strength_of(strengths, "XT"), c.Yc = strength_of(strengths, "YC");
  c.Yt = strength_of(strengths, "YT"), c.S = strength_of(strengths, "SC");
  if (const double criterion = strengths.number("CRIT", 54); criterion != 54) file.ignore(criterion, "CRIT");
  c.beta = strengths.number("BETA");
  if (!(c.beta >= 0 && c.beta <= 1)) file.refuse({"BETA is not between 0 and 1: correct it."});
  add(file, draft, head, material);
}
/// A criterion that is 0 or EXCL is none.
inline void add_erosion(File& file, Draft& draft) {
  file.title();
  Card card = file.card(), more = file.card();
  ErosionCard erosion{.material = card.own_tag("MID", "material to erode", Id::material)};
  const double excluded = card.number("EXCL");
  const auto limit = [&](Card& from, const char* name) {
    const double value = from.number(name);
    return value == excluded ? 0 : value;
  };
  const auto ignored = [&](Card& from, const char* name) { file.ignore(limit(from, name), name); };
  ignored(card, "MXPRES"), ignored(card, "MNEPS");
  if (const double strain = std::abs(limit(card, "EFFEPS")); strain != 0) erosion.strain = strain;
  const double volume = limit(card, "VOLEPS");
  if (volume < 0) erosion.volume = std::exp(volume);
  if (volume > 0) file.ignore(volume, "VOLEPS above 0");
  if (const double points = card.number("NUMFIP", 1); points != 1) file.ignore(points, "NUMFIP");
  if (const double count = card.number("NCS", 1); count != 1) file.ignore(count, "NCS");
  ignored(more, "MNPRES");
  if (const double stress = limit(more, "SIGP1"); stress > 0) erosion.principal_stress = PrincipalStress{stress};
  if (const double stress = limit(more, "SIGVM"); stress > 0)
    erosion.equivalent_stress = UltimateStress{stress};
  else
    file.ignore(stress, "SIGVM below 0");
  ignored(more, "MXEPS"), ignored(more, "EPSSH");
  const double threshold = limit(more, "SIGTH"), impulse = limit(more, "IMPULSE");
  if (impulse > 0 && threshold >= 0) {  // int max(0, s1 - SIGTH)^2 dt = IMPULSE
    const double S = threshold > 0 ? threshold : 1;
    erosion.impulse = TulerButcher{.threshold = threshold, .strength = S, .duration = impulse / (S * S), .exponent = 2};
  }
  ignored(more, "FAILTM");
  draft.deck.erosions.push_back(erosion);
}
/// LCSS counts before EPS and ES, these before SIGY and ETAN; a table before LCSR, that before C and P.
inline void piecewise_plastic(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  const std::uint32_t line = file.line();
  const Elastic m = elastic_of(head, file);
  const double yield = head.card.number("SIGY"), tangent = head.card.number("ETAN");
  const double fails = head.card.number("FAIL");
  if (fails < 0) file.ignore(1, "FAIL below 0");
  const auto failure = failure_at(fails);
  Card rate = file.card();
  const double D = rate.number("C"), p = rate.number("P");
  const auto constants = rate_constants(D, p);
  const FileNumber curve = rate.tag("LCSS", Id::curve), rate_curve = rate.tag("LCSR", Id::curve);
  const double VP = rate.number("VP");
  expect_plastic_rate(file, VP, constants || rate_curve != 0);
  file.ignore_rest(head.card, rate);
  const std::uint32_t rate_line = file.line();
  Points points = from_zero(points_of(file, 1));
  const LinearEos eos{m.density, m.bulk_modulus()};
  const bool follows = curve != 0 || !points.empty();
  const double hardening = follows ? 0 : hardening_modulus(m, tangent, file);
  if (VP == 1 && constants && rate_curve == 0 && yield > 0 && (follows || hardening != 0))
    file.ignore_on_line(rate_line, joined({"VP 1 (the factor of the rate is that of SIGY alone) of ", file.name()}));
  if (!follows && rate_curve == 0) {
    PlasticMaterial material = plastic(eos, m.shear_modulus(), yield, hardening, constants);
    material.failure = failure;
    add(file, draft, head, material);
    return;
  }
  if (!follows) points = from_zero({{0, yield}, {1, yield + hardening}});
  draft.hardenings.push_back({draft.deck.materials.size(), line, eos, m.shear_modulus(), curve, rate_curve,
                              file.base().ends_with("_LOG_INTERPOLATION"), std::move(points), constants, failure});
  add(file, draft, head, m);
}
inline void plastic_hydro(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  const double G = head.card.positive("G"), yield = head.card.number("SIGY"), hardening = head.card.number("EH");
  const double cutoff = head.card.number("PC");
  const auto failure = failure_at(head.card.number("FS"));
  file.ignore_rest(head.card);
  const std::uint32_t line = file.line();
  if (Points points = from_zero(points_of(file, 2)); !points.empty())
    add(file, draft, head,
        TabulatedHydroMaterial{head.density, hardening_of(G, points, head.number, line, file), failure}, cutoff);
  else
    add(file, draft, head, HydroMaterial{head.density, {G, yield, hardening}, failure}, cutoff);
}
inline void johnson_cook(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  double G = head.card.number("G");
  const double E = head.card.number("E"), ratio = poissons_ratio(head.card, file);
  file.ignore(head.card.number("DTF"), "DTF");
  const double VP = head.card.number("VP");
  if (G == 0) G = E / (2 * (1 + ratio));
  if (!(G > 0)) file.refuse({"G is not positive: give the material its G, or E and PR."});
  Card law = file.card(), heat = file.card(), last = file.card();
  JohnsonCookMaterial material{head.density, {.shear_modulus = G, .A = 0, .B = 0, .n = 0}, {}};
  JohnsonCook& s = material.strength;
  s.A = law.number("A"), s.B = law.number("B"), s.n = law.number("N"), s.C = law.number("C"), s.m = law.number("M");
  expect_plastic_rate(file, VP, s.C != 0);
  const double melting = law.number("TM");
  s.initial_temperature = law.number("TR");
  s.melting_temperature = melting > s.initial_temperature ? melting : 1e30;
  s.reference_rate = law.number("EPS0", 1);
  const double capacity = heat.number("CP");
  s.heating = capacity > 0 ? 1 / (head.density * capacity) : 0;
  const double cutoff = heat.number("PC");
  file.ignore(heat.number("SPALL"), "SPALL");
  heat.pass(1);
  for (std::size_t i = 0; i < 4; ++i) material.damage[i] = heat.number("D1 to D4");
  material.damage[4] = last.number("D5");
  for (const char* name : {"C2/P/XNP", "EROD"}) file.ignore(last.number(name), name);
  material.least_fracture = last.number("EFMIN", 1e-6);
  file.ignore_rest(head.card, law, last);
  add(file, draft, head, material, cutoff);
}
inline void null(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  const double cutoff = head.card.number("PC");
  const NullMaterial material{head.density, head.card.number("MU")};
  file.ignore(head.card.number("TEROD"), "TEROD");
  file.ignore(head.card.number("CEROD"), "CEROD");
  file.ignore(head.card.number("YM"), "YM, of null shells,");
  file.ignore(head.card.number("PR"), "PR, of null shells,");
  add(file, draft, head, material, cutoff);
}

inline void linear_polynomial(File& file, Draft& draft) {
  auto [card, number] = eos_head(file, draft);
  PolynomialEos eos{.density = 0};
  for (double* C : {&eos.C0, &eos.C1, &eos.C2, &eos.C3, &eos.C4, &eos.C5, &eos.C6}) *C = card.number("C0 to C6");
  Card start = file.card();
  eos.initial_energy = start.number("E0");
  if (const double V0 = start.number("V0"); V0 != 0) file.ignore(V0 - 1, "V0");
  file.ignore_rest(card, start);
  draft.deck.equations_of_state.push_back({number, file.name(), eos});
}
inline void gruneisen(File& file, Draft& draft) {
  auto [card, number] = eos_head(file, draft);
  GruneisenEos eos{.density = 0, .sound_speed = card.positive("C"), .S1 = card.number("S1"), .gamma = 0};
  eos.S2 = card.number("S2"), eos.S3 = card.number("S3"), eos.gamma = card.number("GAMAO"), eos.a = card.number("A");
  eos.initial_energy = card.number("E0");
  if (const double V0 = file.card().number("V0"); V0 != 0) file.ignore(V0 - 1, "V0");
  draft.deck.equations_of_state.push_back({number, file.name(), eos});
}

inline constexpr Meaning of_elastic{"`deck.material<Elastic>(part)`", "`Elastic`", "DA, DB, K"};
inline constexpr Meaning of_plastic_kinematic{
    "`PlasticMaterial`: `LinearEos`, `RateVonMises`, `FailureStrain`; of BETA below 1 without a rate "
    "`KinematicMaterial`",
    "`Solid` of `RateVonMises` of BETA 1, of a rate or of ETAN 0, with `FailureStrain` and `Erosion{}` if it fails",
    "VP 0; BETA beside a rate, where hardening is isotropic; in a scene: BETA below 1 without a rate"};
inline constexpr Meaning of_piecewise_plastic{
    "`PlasticMaterial`; with LCSS of a curve, or EPS and ES, `TabulatedMaterial` with C and P as its `rate`; with LCSS "
    "of a table, or LCSR, `TabulatedRatesMaterial`",
    "`Solid` of `RateVonMises` by SIGY, `TabulatedHardening` of a curve or points, with `FailureStrain` and "
    "`Erosion{}` if it fails",
    "TDEL; FAIL below 0; VP 0; in a scene: the rate of a curve or points, tables, LCSR"};
inline constexpr Meaning of_plastic_hydro{
    "`HydroMaterial`: `VonMises`, needs an equation of state; `TabulatedHydroMaterial` of EPS and ES",
    "`Solid` of `VonMises` and `PolynomialEos`, in hexahedra", "CHARL; in a scene: FS, EPS and ES"};
inline constexpr Meaning of_johnson_cook{
    "`JohnsonCookMaterial`: `JohnsonCook`, `m.fracture()`, needs an equation of state",
    "`Solid` of `JohnsonCook` and `GruneisenEos`, in hexahedra; `JohnsonCookFailure` of D1 to D5 and EFMIN, with "
    "`Erosion{}`",
    "DTF, VP 0, RATEOP, SPALL, C2/P/XNP, EROD, NUMINT; in a scene: D3 to D5 without D1 and D2, or beside EFFEPS of "
    "`*MAT_ADD_EROSION`"};
inline constexpr Meaning of_null{"`NullMaterial`: density, viscosity, needs an equation of state",
                                 "`Fluid` with `Newtonian{MU}`, in hexahedra",
                                 "TEROD, CEROD; YM and PR, of null shells"};
inline constexpr Meaning of_isotropic_plastic{"`PlasticMaterial`: `LinearEos`, `RateVonMises`",
                                              "`Solid` of `RateVonMises`", "further fields"};
inline constexpr Meaning of_power_law{
    "`PowerMaterial`: `PowerHardening`, SRC and SRP as its `rate`",
    "`Solid` of `PowerHardening`, with a rate of `CowperSymonds{PowerHardening{...}, SRC, SRP}`, with `FailureStrain` "
    "and `Erosion{}` if it fails; in hexahedra and plates",
    "VP 0; in a scene: triangles with a rate or that fail"};
inline constexpr Meaning of_simplified_johnson_cook{
    "`SimplifiedJohnsonCookMaterial`: `JohnsonCook` without heat",
    "`Solid` of `JohnsonCook`, with `FailureStrain` and `Erosion{}` if it fails; in hexahedra and plates",
    "SIGMAX, SIGSAT, VP 0; in a scene: triangles that fail"};
inline constexpr Meaning of_zerilli_armstrong{
    "`ZerilliArmstrongMaterial`: `ZerilliArmstrong`, needs an equation of state",
    "`Solid` of `ZerilliArmstrong` and `GruneisenEos`, in hexahedra, with `FailureStrain` and `Erosion{}` if it fails",
    "SPALL, VP 0, G2 to G4, BULK, M of fcc metals, the change of B2 and B3 with the temperature; in a scene: other "
    "equations of state"};
inline constexpr Meaning of_mooney_rivlin{"`RubberMaterial`: `MooneyRivlin`", "`Solid` of `MooneyRivlin`, in hexahedra",
                                          "REF; the material if A or B is negative, or fitted to LCID"};
inline constexpr Meaning of_viscoelastic{"`ViscoelasticMaterial`: `Prony<1>`", "`Solid` of `Prony<1>`, in hexahedra",
                                         "the material if BETA is a curve"};
inline constexpr Meaning of_general_viscoelastic{
    "`PronyMaterial`: `m.strength<3>()`", "`Solid` of `Prony` of up to six terms, in hexahedra",
    "PCF, EF, TREF, A, B, LCID, LCIDK, BETAKI; the material if fitted to LCID; in a scene: more terms"};
inline constexpr Meaning of_rigid{
    "`RigidMaterial`: density, and the axes of CMO, CON1 and CON2", "`RigidBody` of the part's cells, with `HeldBody`",
    "N, COUPLE, M, ALIAS, LCO, A and V; in a scene: a density other than that of the part with which it moves"};
inline constexpr Meaning of_explosive{
    "`ExplosiveMaterial`: `m.burn(width)`",
    "`Explosive{Jwl{...}, DetonationPoints{...}, Burn{...}}` of hexahedra, whose front is three elements wide: told",
    "BETA 1, K, G, SIGY; in a scene: other cells, and other products than those of `*EOS_JWL`"};
inline constexpr Meaning of_composite_damage{
    "`PlyMaterial`: `OrthotropicPly`, `ChangChang`",
    "`FailingPly` of a layer of `*PART_COMPOSITE`, or of NIP equal plies of a section; with `Erosion{}`",
    "MACF, ALPH, AOPT other than 0 and 2; EC, PRCA, SN, SYZ and SZX, of solids, passed in silence; in a scene: solids, "
    "fibres in several directions"};
inline constexpr Meaning of_enhanced_composite_damage{
    "`PlyMaterial`: `OrthotropicPly`, `ChangChang`",
    "`FailingPly` of a layer of `*PART_COMPOSITE`, or of NIP equal plies of a section; with `Erosion{}`",
    "2WAY, DFAILM, DFAILS, TFAIL, ALPH, SOFT, FBRT, YCFAC, DFAILT, DFAILC, EFS, CRIT 55, AOPT other than 0 and 2; EC "
    "and PRCA, of solids, passed in silence; in a scene: solids, fibres in several directions"};
inline constexpr Meaning of_erosion{
    "`erosions`: EFFEPS, VOLEPS below 0; SIGVM, SIGP1, SIGTH with IMPULSE as laws of failure",
    "`FailureStrain{EFFEPS}` of materials that flow, with `Erosion{}`",
    "MXPRES, MNEPS, VOLEPS above 0, NUMFIP, NCS, MNPRES, SIGVM below 0, MXEPS, EPSSH, FAILTM; in a scene: all but "
    "EFFEPS, materials that do not flow"};
inline constexpr Meaning of_jwl{"`deck.eos<Jwl>(part)`", "the products of an `Explosive`", "VO"};
inline constexpr Meaning of_detonations{"`detonations`: the part, 0 for all, and a `DetonationPoint`",
                                        "a point of `DetonationPoints`; an explosive without one burns from the time 0",
                                        "PID below 0, MMGSET"};
inline constexpr Meaning of_polynomial{
    "`deck.eos<PolynomialEos>(part)`, with density and cut-off (PC, none if 0) of the material",
    "that of the part's `Solid` or `Fluid`", "V0"};
inline constexpr Meaning of_gruneisen{
    "`deck.eos<GruneisenEos>(part)`, with density and cut-off (PC, none if 0) of the material",
    "that of the part's `Solid` or `Fluid`", "V0"};
inline constexpr auto material_keywords = std::to_array<Keyword>({
    {"*MAT_ELASTIC", elastic, Invariant::moved, &of_elastic},
    {"*MAT_001", elastic, Invariant::moved, &of_elastic},
    {"*MAT_PLASTIC_KINEMATIC", plastic_kinematic, Invariant::moved, &of_plastic_kinematic},
    {"*MAT_003", plastic_kinematic, Invariant::moved, &of_plastic_kinematic},
    {"*MAT_PIECEWISE_LINEAR_PLASTICITY", piecewise_plastic, Invariant::moved, &of_piecewise_plastic},
    {"*MAT_024", piecewise_plastic, Invariant::moved, &of_piecewise_plastic},
    {"*MAT_PIECEWISE_LINEAR_PLASTICITY_LOG_INTERPOLATION", piecewise_plastic, Invariant::moved, &of_piecewise_plastic},
    {"*MAT_024_LOG_INTERPOLATION", piecewise_plastic, Invariant::moved, &of_piecewise_plastic},
    {"*MAT_ELASTIC_PLASTIC_HYDRO", plastic_hydro, Invariant::moved, &of_plastic_hydro},
    {"*MAT_010", plastic_hydro, Invariant::moved, &of_plastic_hydro},
    {"*MAT_JOHNSON_COOK", johnson_cook, Invariant::moved, &of_johnson_cook},
    {"*MAT_015", johnson_cook, Invariant::moved, &of_johnson_cook},
    {"*MAT_NULL", null, Invariant::moved, &of_null},
    {"*MAT_009", null, Invariant::moved, &of_null},
    {"*MAT_ISOTROPIC_ELASTIC_PLASTIC", isotropic_plastic, Invariant::moved, &of_isotropic_plastic},
    {"*MAT_012", isotropic_plastic, Invariant::moved, &of_isotropic_plastic},
    {"*MAT_POWER_LAW_PLASTICITY", power_law, Invariant::moved, &of_power_law},
    {"*MAT_018", power_law, Invariant::moved, &of_power_law},
    {"*MAT_SIMPLIFIED_JOHNSON_COOK", simplified_johnson_cook, Invariant::moved, &of_simplified_johnson_cook},
    {"*MAT_098", simplified_johnson_cook, Invariant::moved, &of_simplified_johnson_cook},
    {"*MAT_MODIFIED_ZERILLI_ARMSTRONG", zerilli_armstrong, Invariant::moved, &of_zerilli_armstrong},
    {"*MAT_065", zerilli_armstrong, Invariant::moved, &of_zerilli_armstrong},
    {"*MAT_MOONEY-RIVLIN_RUBBER", mooney_rivlin, Invariant::moved, &of_mooney_rivlin},
    {"*MAT_027", mooney_rivlin, Invariant::moved, &of_mooney_rivlin},
    {"*MAT_VISCOELASTIC", viscoelastic, Invariant::moved, &of_viscoelastic},
    {"*MAT_006", viscoelastic, Invariant::moved, &of_viscoelastic},
    {"*MAT_GENERAL_VISCOELASTIC", general_viscoelastic, Invariant::moved, &of_general_viscoelastic},
    {"*MAT_076", general_viscoelastic, Invariant::moved, &of_general_viscoelastic},
    {"*MAT_RIGID", rigid, Invariant::moved, &of_rigid},
    {"*MAT_020", rigid, Invariant::moved, &of_rigid},
    {"*MAT_HIGH_EXPLOSIVE_BURN", explosive, Invariant::moved, &of_explosive},
    {"*MAT_008", explosive, Invariant::moved, &of_explosive},
    {"*MAT_COMPOSITE_DAMAGE", composite_damage, Invariant::none, &of_composite_damage},
    {"*MAT_022", composite_damage, Invariant::none, &of_composite_damage},
    {"*MAT_ENHANCED_COMPOSITE_DAMAGE", enhanced_composite_damage, Invariant::none, &of_enhanced_composite_damage},
    {"*MAT_054", enhanced_composite_damage, Invariant::none, &of_enhanced_composite_damage},
    {"*MAT_ADD_EROSION", add_erosion, Invariant::moved, &of_erosion},
    {"*EOS_JWL", jwl, Invariant::moved, &of_jwl},
    {"*EOS_002", jwl, Invariant::moved, &of_jwl},
    {"*INITIAL_DETONATION", detonations, Invariant::none, &of_detonations},
    {"*EOS_LINEAR_POLYNOMIAL", linear_polynomial, Invariant::moved, &of_polynomial},
    {"*EOS_001", linear_polynomial, Invariant::moved, &of_polynomial},
    {"*EOS_GRUNEISEN", gruneisen, Invariant::moved, &of_gruneisen},
    {"*EOS_004", gruneisen, Invariant::moved, &of_gruneisen},
    {"*EOS_TABULATED", tabulated_eos, Invariant::moved, &of_tabulated_eos},
    {"*EOS_009", tabulated_eos, Invariant::moved, &of_tabulated_eos},
});

}  // namespace strike::detail::dyna
