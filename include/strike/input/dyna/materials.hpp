#pragma once
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <strike/input/dyna/draft.hpp>

// Materials and equations of state (LS-DYNA Keyword User's Manual R13, volume II).
namespace strike::detail::dyna {

/// First fields of every material card.
struct MaterialHead {
  std::string title;
  Card card;
  FileNumber number;
  double density;
};
inline MaterialHead material_head(File& file, Draft& draft) {
  std::string title = file.title();
  Card card = file.card();
  const FileNumber number = draft.own_number("material", Id::material, card, file);
  const double density = card.positive("RO");
  return {std::move(title), card, number, density};
}
inline void add(const File& file, Draft& draft, const MaterialHead& head, decltype(MaterialCard::material) material,
                double cutoff = 0) {
  draft.deck.materials.push_back(
      {head.number, file.name(), head.title, material, cutoff != 0 ? std::optional(-std::abs(cutoff)) : std::nullopt});
}

inline double poissons_ratio(Card& card, const File& file) {
  const double ratio = card.number("PR");
  if (!(ratio > -1) || !(ratio < 0.5)) file.refuse({"PR is not between -1 and 0.5: correct it."});
  return ratio;
}
inline Elastic elastic_of(MaterialHead& head, const File& file) {
  const double E = head.card.positive("E");
  return {head.density, E, poissons_ratio(head.card, file)};
}
inline std::optional<FailureStrain> failure_at(double strain) {
  return strain > 0 && strain < 1e6 ? std::optional(FailureStrain{strain}) : std::nullopt;
}
/// From Young's modulus and the tangent ETAN, and Cowper and Symonds' D and p.
inline PlasticMaterial plastic(const Elastic& m, double yield, double tangent, double D, double p, const File& file) {
  if (!(tangent < m.youngs_modulus)) file.refuse({"ETAN is not below E: correct the tangent modulus."});
  const double hardening = m.youngs_modulus * tangent / (m.youngs_modulus - tangent);
  RateVonMises strength{m.shear_modulus(), yield, hardening};
  if (D > 0 && p > 0) strength.rate_factor = std::pow(D, -1 / p), strength.rate_exponent = 1 / p;
  return {{m.density, m.bulk_modulus()}, strength};
}
/// Cards of eight strains or stresses, which have no counterpart. True if there are any.
inline bool ignore_table(File& file, std::string_view what, int cards) {
  bool any = false;
  for (; cards > 0; --cards) {
    Card card = file.card();
    double sum = 0;
    for (int i = 0; i < 8; ++i) sum += std::abs(card.number("a point of the table"));
    file.ignore(sum, what);
    any |= sum != 0;
  }
  return any;
}
inline void expect_yield_stress(double yield, bool has_curve, const File& file) {
  if (yield == 0 && has_curve)
    file.refuse(
        {"SIGY is 0, and no material here follows the curve in its place: give the material its SIGY and tangent."});
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
  if (tangent != 0) file.ignore(1 - beta, "BETA (hardening is isotropic here)");
  Card rate = file.card();
  const double D = rate.number("SRC"), p = rate.number("SRP");
  PlasticMaterial material = plastic(m, yield, tangent, D, p, file);
  material.failure = failure_at(rate.number("FS"));
  file.ignore_rest(head.card, rate);
  add(file, draft, head, material);
}
inline void piecewise_plastic(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  const Elastic m = elastic_of(head, file);
  const double yield = head.card.number("SIGY"), tangent = head.card.number("ETAN"), fails = head.card.number("FAIL");
  Card rate = file.card();
  const double D = rate.number("C"), p = rate.number("P");
  PlasticMaterial material = plastic(m, yield, tangent, D, p, file);
  material.failure = failure_at(fails);
  const double curve = rate.number("LCSS");
  file.ignore(curve, "LCSS (SIGY and ETAN are taken)");
  file.ignore(rate.number("LCSR"), "LCSR");
  file.ignore_rest(head.card, rate);
  const bool has_table = ignore_table(file, "EPS and ES (SIGY and ETAN are taken)", 2);
  expect_yield_stress(yield, has_table || curve != 0, file);
  add(file, draft, head, material);
}
inline void plastic_hydro(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  const double G = head.card.positive("G"), yield = head.card.number("SIGY"), hardening = head.card.number("EH");
  const double cutoff = head.card.number("PC");
  const HydroMaterial material{head.density, {G, yield, hardening}, failure_at(head.card.number("FS"))};
  file.ignore_rest(head.card);
  expect_yield_stress(yield, ignore_table(file, "EPS and ES (SIGY and EH are taken)", 4), file);
  add(file, draft, head, material, cutoff);
}
inline void johnson_cook(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  double G = head.card.number("G");
  const double E = head.card.number("E"), ratio = poissons_ratio(head.card, file);
  if (G == 0) G = E / (2 * (1 + ratio));
  if (!(G > 0)) file.refuse({"G is not positive: give the material its G, or E and PR."});
  Card law = file.card(), heat = file.card(), last = file.card();
  JohnsonCookMaterial material{head.density, {.shear_modulus = G, .A = 0, .B = 0, .n = 0}, {}};
  JohnsonCook& s = material.strength;
  s.A = law.number("A"), s.B = law.number("B"), s.n = law.number("N"), s.C = law.number("C"), s.m = law.number("M");
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
  file.ignore_rest(head.card, law, last);
  add(file, draft, head, material, cutoff);
}
inline void null(File& file, Draft& draft) {
  MaterialHead head = material_head(file, draft);
  const double cutoff = head.card.number("PC");
  const NullMaterial material{head.density, head.card.number("MU")};
  file.ignore(head.card.number("TEROD"), "TEROD");
  file.ignore(head.card.number("CEROD"), "CEROD");
  add(file, draft, head, material, cutoff);
}

inline void linear_polynomial(File& file, Draft& draft) {
  file.title();
  Card card = file.card();
  const FileNumber number = draft.own_number("equation of state", Id::material, card, file);
  PolynomialEos eos{.density = 0};
  for (double* C : {&eos.C0, &eos.C1, &eos.C2, &eos.C3, &eos.C4, &eos.C5, &eos.C6}) *C = card.number("C0 to C6");
  Card start = file.card();
  eos.initial_energy = start.number("E0");
  if (const double V0 = start.number("V0"); V0 != 0) file.ignore(V0 - 1, "V0");
  file.ignore_rest(card, start);
  draft.deck.equations_of_state.push_back({number, file.name(), eos});
}
inline void gruneisen(File& file, Draft& draft) {
  file.title();
  Card card = file.card();
  const FileNumber number = draft.own_number("equation of state", Id::material, card, file);
  GruneisenEos eos{.density = 0, .sound_speed = card.positive("C"), .S1 = card.number("S1"), .gamma = 0};
  eos.S2 = card.number("S2"), eos.S3 = card.number("S3"), eos.gamma = card.number("GAMAO"), eos.a = card.number("A");
  eos.initial_energy = card.number("E0");
  if (const double V0 = file.card().number("V0"); V0 != 0) file.ignore(V0 - 1, "V0");
  draft.deck.equations_of_state.push_back({number, file.name(), eos});
}

inline constexpr auto material_keywords = std::to_array<Keyword>({
    {"*MAT_ELASTIC", elastic},
    {"*MAT_001", elastic},
    {"*MAT_PLASTIC_KINEMATIC", plastic_kinematic},
    {"*MAT_003", plastic_kinematic},
    {"*MAT_PIECEWISE_LINEAR_PLASTICITY", piecewise_plastic},
    {"*MAT_024", piecewise_plastic},
    {"*MAT_ELASTIC_PLASTIC_HYDRO", plastic_hydro},
    {"*MAT_010", plastic_hydro},
    {"*MAT_JOHNSON_COOK", johnson_cook},
    {"*MAT_015", johnson_cook},
    {"*MAT_NULL", null},
    {"*MAT_009", null},
    {"*EOS_LINEAR_POLYNOMIAL", linear_polynomial},
    {"*EOS_001", linear_polynomial},
    {"*EOS_GRUNEISEN", gruneisen},
    {"*EOS_004", gruneisen},
});

}  // namespace strike::detail::dyna
