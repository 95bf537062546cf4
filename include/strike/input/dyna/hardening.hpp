#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <strike/input/dyna/curves.hpp>
#include <strike/input/dyna/draft.hpp>
#include <strike/input/raw_mesh.hpp>

// Hardening by points, curves and tables, which may stand after the material.
namespace strike::detail::dyna {

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
inline TabulatedHardening hardening_of(double G, const Points& points, FileNumber material, std::uint32_t line,
                                       const File& file) {
  return made_of_points(joined({"material ", std::to_string(material)}), line, file,
                        [&] { return TabulatedHardening(G, points); });
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

/// Error: a table of all strains at all rates that is larger than a file of this size may ask for.
inline void expect_small_table(const std::vector<TabulatedRates::Test>& tests, FileNumber material, std::uint32_t line,
                               const File& file, Allowance& allowance) {
  std::size_t strains = 0;
  for (const TabulatedRates::Test& test : tests) strains += test.points.size();
  const std::size_t numbers = 8 * strains * tests.size();
  if (!allowance.has(numbers))
    file.source().refuse(
        line, {"material ", std::to_string(material), " makes a table of ", std::to_string(tests.size()), " rates and ",
               std::to_string(strains), " strains of its curves, too large for its file: give fewer points."});
  allowance.take(numbers, line);
}

/// The materials that follow curves. Errors: a curve that is not there; points that no material can follow.
inline void complete_materials(Draft& draft, File& file, Allowance& allowance) {
  if (draft.hardenings.empty()) return;
  DynaDeck& deck = draft.deck;
  const Curves curves(deck, file, allowance);
  std::map<FileNumber, const TableCard*> tables;
  for (const TableCard& table : deck.tables) tables.try_emplace(table.number, &table);
  for (PendingHardening& pending : draft.hardenings) {
    MaterialCard& card = deck.materials[pending.material];
    const std::string owner = joined({"material ", std::to_string(card.number)});
    const auto curve = [&](FileNumber number) -> const CurveCard& { return curves.at(number, owner, pending.line); };
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
      expect_small_table(tests, card.number, pending.line, file, allowance);
      const auto between = has_logarithms ? TabulatedRates::Between::logarithms : TabulatedRates::Between::rates;
      card.material = TabulatedRatesMaterial{
          pending.eos, made_of_points(owner, pending.line, file, [&] { return TabulatedRates(G, tests, between); }),
          pending.failure};
    }
  }
}

}  // namespace strike::detail::dyna
