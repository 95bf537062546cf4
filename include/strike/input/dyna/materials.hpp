#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

using Points = std::vector<TabulatedHardening::Point>;

/// EPS and ES: strains on so many cards of eight, and as many of stresses; none if all are 0 or blank.
inline Points points_of(File& file, int cards) {
  Points points(static_cast<std::size_t>(8 * cards));
  std::size_t count = 0;
  for (double TabulatedHardening::Point::*member :
       {&TabulatedHardening::Point::plastic_strain, &TabulatedHardening::Point::stress})
    for (std::size_t i = 0; i < points.size();) {
      Card card = file.card();
      for (int k = 0; k < 8; ++k, ++i) {
        points[i].*member = card.number("a point of the table");
        if (points[i].*member != 0) count = std::max(count, i + 1);
      }
    }
  points.resize(count);
  return points;
}
inline bool are_sorted(const Points& points) {
  const auto turn = [](const auto& a, const auto& b) { return !(a.plastic_strain < b.plastic_strain); };
  return std::adjacent_find(points.begin(), points.end(), turn) == points.end();
}
/// Points from the plastic strain 0 on. As LS-DYNA has it, the first and the last line go on beyond their ends; the
/// stress is at least 0.
inline Points from_zero(Points points) {
  constexpr double far = 1000;  // beyond any plastic strain
  if (points.empty() || !are_sorted(points)) return points;
  if (points.size() == 1) return {{0, points[0].stress}};
  const auto slope = [&](std::size_t i) {
    return (points[i + 1].stress - points[i].stress) / (points[i + 1].plastic_strain - points[i].plastic_strain);
  };
  std::size_t first = 0;  // point after 0, whose line begins at the one before, or else at itself
  while (first < points.size() && points[first].plastic_strain <= 0) ++first;
  const std::size_t line = std::min(first > 0 ? first - 1 : 0, points.size() - 2);
  Points all{{0, points[line].stress - points[line].plastic_strain * slope(line)}};
  if (first > 0 && points[first - 1].plastic_strain == 0) all[0].stress = points[first - 1].stress;
  all.insert(all.end(), points.begin() + static_cast<std::ptrdiff_t>(first), points.end());
  const double last = slope(points.size() - 2);
  const auto [strain, stress] = all.back();
  if (last > 0) all.push_back({strain + far, stress + far * last});
  if (last < 0 && stress > 0) all.push_back({strain - stress / last, 0});
  return all;
}
/// A law of points. Error: no material can follow these.
template <class Make>
auto made_of_points(FileNumber material, std::uint32_t line, const File& file, Make make) {
  try {
    return make();
  } catch (const Error& error) {
    std::string_view why = error.what();
    why.remove_prefix(std::min(why.size(), std::string_view("strike: ").size()));
    file.source().refuse(line, {"material ", std::to_string(material), " cannot follow its points: ", why});
  }
}
inline TabulatedHardening hardening_of(double G, const Points& points, FileNumber material, std::uint32_t line,
                                       const File& file) {
  return made_of_points(material, line, file, [&] { return TabulatedHardening(G, points); });
}
/// Points of a curve of stress over plastic strain.
inline Points points_of(const CurveCard& curve) {
  Points points;
  for (const auto& [strain, stress] : curve.points) points.push_back({strain, stress});
  return from_zero(std::move(points));
}
/// Raises the stresses of tests where they lie below those of the slower one before. True if any did where both are
/// given, and not only where their last lines go on.
inline bool uncross(std::vector<TabulatedRates::Test>& tests, Allowance& allowance, std::uint32_t line) {
  for (const TabulatedRates::Test& test : tests)
    if (test.points.empty() || !are_sorted(test.points)) return false;  // no law takes it
  bool crosses = false;
  for (std::size_t i = 1; i < tests.size(); ++i) {
    std::vector<double> strains;
    for (const Points& points : {std::cref(tests[i - 1].points), std::cref(tests[i].points)})
      for (const auto& point : points) strains.push_back(point.plastic_strain);
    std::sort(strains.begin(), strains.end());
    strains.erase(std::unique(strains.begin(), strains.end()), strains.end());
    allowance.take(strains.size(), line);
    const std::vector<double> slower = stresses_at(tests[i - 1].points, strains);
    const std::vector<double> stresses = stresses_at(tests[i].points, strains);
    Points raised;
    bool is_below = false;
    for (std::size_t j = 0; j < strains.size(); ++j) {
      const double lack = slower[j] - stresses[j], before = j > 0 ? slower[j - 1] - stresses[j - 1] : 0;
      if (lack * before < 0) {  // they cross between
        const double share = before / (before - lack), e = strains[j - 1] + share * (strains[j] - strains[j - 1]);
        if (e > strains[j - 1] && e < strains[j])
          raised.push_back({e, slower[j - 1] + share * (slower[j] - slower[j - 1])});
      }
      raised.push_back({strains[j], std::max(stresses[j], slower[j])});
      is_below |= lack > 0;
      crosses |= lack > 1e-9 * slower[j] && strains[j] < 100;
    }
    if (is_below) tests[i].points = std::move(raised);
  }
  return crosses;
}

/// The materials that follow curves. Errors: a curve that is not there; points that no material can follow.
inline void complete_materials(Draft& draft, File& file, Allowance& allowance) {
  if (draft.hardenings.empty()) return;
  DynaDeck& deck = draft.deck;
  std::map<FileNumber, const CurveCard*> curves;
  std::map<FileNumber, const TableCard*> tables;
  for (const CurveCard& curve : deck.curves) curves.try_emplace(curve.number, &curve);
  for (const TableCard& table : deck.tables) tables.try_emplace(table.number, &table);
  for (PendingHardening& pending : draft.hardenings) {
    MaterialCard& card = deck.materials[pending.material];
    const auto curve = [&](FileNumber number) -> const CurveCard& {
      if (const auto found = curves.find(number); found != curves.end()) {
        allowance.take(found->second->points.size(), pending.line);
        return *found->second;
      }
      const std::string skipped = file.skipped("*DEFINE_");
      file.source().refuse(pending.line,
                           {"the curve ", std::to_string(number), " of material ", std::to_string(card.number),
                            " is not in the file", skipped.empty() ? "" : " (", skipped,
                            skipped.empty() ? "" : " was skipped)", ": define it or correct the card."});
    };
    std::vector<TabulatedRates::Test> tests;
    bool has_logarithms = pending.has_logarithms;
    const auto found = tables.find(pending.curve);
    const bool has_rates = found != tables.end() || pending.rate_curve != 0;
    if (found != tables.end()) {
      const TableCard& table = *found->second;
      const bool are_logarithms = !table.values.empty() && table.values.front() < 0;  // values of LS-DYNA
      has_logarithms |= are_logarithms;
      for (std::size_t i = 0; i < table.values.size(); ++i)
        tests.push_back(
            {are_logarithms ? std::exp(table.values[i]) : table.values[i], points_of(curve(table.curves[i]))});
    } else {
      if (pending.curve != 0) pending.points = points_of(curve(pending.curve));
      if (pending.rate_curve != 0)
        for (const auto& [rate, factor] : curve(pending.rate_curve).points) {
          allowance.take(pending.points.size(), pending.line);
          tests.push_back({rate, pending.points});
          for (auto& point : tests.back().points) point.stress *= factor;
        }
    }
    if (uncross(tests, allowance, pending.line))
      file.ignore_on_line(pending.line, "A stress below that of a slower curve (which is taken) of a table");
    const double G = pending.shear_modulus;
    if (!has_rates) {
      card.material = TabulatedMaterial{pending.eos, hardening_of(G, pending.points, card.number, pending.line, file),
                                        pending.rate, pending.failure};
    } else {
      const auto between = has_logarithms ? TabulatedRates::Between::logarithms : TabulatedRates::Between::rates;
      card.material = TabulatedRatesMaterial{
          pending.eos,
          made_of_points(card.number, pending.line, file, [&] { return TabulatedRates(G, tests, between); }),
          pending.failure};
    }
  }
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
  const auto constants = rate_constants(D, p);
  PlasticMaterial material =
      plastic({m.density, m.bulk_modulus()}, m.shear_modulus(), yield, hardening_modulus(m, tangent, file), constants);
  material.failure = failure_at(rate.number("FS"));
  expect_plastic_rate(file, rate.number("VP"), constants.has_value());
  file.ignore_rest(head.card, rate);
  add(file, draft, head, material);
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
    {"*MAT_PIECEWISE_LINEAR_PLASTICITY_LOG_INTERPOLATION", piecewise_plastic},
    {"*MAT_024_LOG_INTERPOLATION", piecewise_plastic},
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
