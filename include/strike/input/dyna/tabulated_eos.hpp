#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <strike/input/dyna/curves.hpp>
#include <strike/input/dyna/material_head.hpp>

// Equations of state by points and curves, which may stand after them.
namespace strike::detail::dyna {

using EosPoints = std::vector<TabulatedEos::Point>;

/// EV, C and T, ten of each on two cards. Points of zeros that end the table are none; but where strains rise to one
/// below 0 whose T is 0, the first of them is the point at rest.
inline EosPoints eos_points_of(File& file) {
  using Point = TabulatedEos::Point;
  EosPoints points(10, Point{0, 0, 0});
  std::size_t count = 0;
  for (double Point::*member : {&Point::volumetric_strain, &Point::C, &Point::T})
    for (std::size_t i = 0; i < points.size();) {
      Card card = file.card();
      for (int k = 0; k < 5; ++k, ++i) {
        points[i].*member = card.number("a point of the table", 0, 16);
        if (points[i].*member != 0) count = std::max(count, i + 1);
      }
    }
  const auto rises_to_rest = [&] {
    const auto& [e, C, T] = points[count - 1];
    return e < 0 && T == 0 && (count == 1 || points[count - 2].volumetric_strain < e);
  };
  if (count > 0 && count < points.size() && rises_to_rest()) ++count;
  points.resize(count);
  return points;
}
inline void tabulated_eos(File& file, Draft& draft) {
  auto [card, number] = eos_head(file, draft);
  PendingEos eos{.place = draft.deck.equations_of_state.size(), .line = file.line()};
  eos.gamma = card.number("GAMA"), eos.initial_energy = card.number("E0");
  if (const double V0 = card.number("V0"); V0 != 0) file.ignore(V0 - 1, "V0");
  eos.curve_C = card.tag("LCC", Id::curve), eos.curve_T = card.tag("LCT", Id::curve);
  file.ignore_rest(card);
  eos.points = eos_points_of(file);
  draft.tabulated_eos.push_back(std::move(eos));
  draft.deck.equations_of_state.push_back({number, file.name(), PolynomialEos{.density = 0}});  // until it is completed
}

/// C or T over strains that rise.
using EosColumn = std::vector<std::array<double, 2>>;

/// Linear between points, and beyond them as the first and the last piece; 0 of none.
inline double value_at(const EosColumn& column, double e) {
  if (column.empty()) return 0;
  const auto above = std::upper_bound(column.begin() + 1, column.end() - 1, e,
                                      [](double strain, const auto& point) { return strain < point[0]; });
  const auto& [e0, y0] = *(above - 1);
  const auto& [e1, y1] = *above;
  return e == e1 ? y1 : y0 + (y1 - y0) / (e1 - e0) * (e - e0);
}
/// The tables of equations of state, with those of C and T that are curves at the strains of both. Errors: a curve that
/// is not there, or does not rise in its strains; points that no law can follow.
inline void complete_equations_of_state(Draft& draft, File& file, Allowance& allowance) {
  if (draft.tabulated_eos.empty()) return;
  const Curves curves(draft.deck, file, allowance);
  for (PendingEos& pending : draft.tabulated_eos) {
    EosCard& card = draft.deck.equations_of_state[pending.place];
    const std::string owner = joined({"equation of state ", std::to_string(card.number)});
    const auto column = [&](FileNumber number, double TabulatedEos::Point::*member) {
      EosColumn points;
      if (number != 0)
        points = curves.at(number, owner, pending.line).points;
      else if (std::any_of(pending.points.begin(), pending.points.end(), [&](auto& p) { return p.*member != 0; }))
        for (const auto& point : pending.points) points.push_back({point.volumetric_strain, point.*member});
      if (number == 0 && points.size() > 1 && points[1][0] < points[0][0]) std::reverse(points.begin(), points.end());
      const std::string of = number != 0 ? joined({"curve ", std::to_string(number), " of ", owner}) : owner;
      if (points.size() < 2 && (number != 0 || !points.empty()))
        file.source().refuse(pending.line, {of, " has ", std::to_string(points.size()),
                                            points.size() == 1 ? " point" : " points", ": give it at least two."});
      for (std::size_t i = 1; i < points.size(); ++i)
        if (!(points[i][0] > points[i - 1][0]))
          file.source().refuse(pending.line, {of, " does not rise from the strain ", text(points[i - 1][0]), " to ",
                                              text(points[i][0]), ": sort its points by their strain, each once."});
      return points;
    };
    if (pending.curve_C != 0 || pending.curve_T != 0) {
      const EosColumn C = column(pending.curve_C, &TabulatedEos::Point::C),
                      T = column(pending.curve_T, &TabulatedEos::Point::T);
      allowance.take(C.size() + T.size(), pending.line);
      std::vector<double> strains;
      for (const auto& [e, y] : C) strains.push_back(e);
      for (const auto& [e, y] : T) strains.push_back(e);
      std::sort(strains.begin(), strains.end());
      strains.erase(std::unique(strains.begin(), strains.end()), strains.end());
      pending.points.clear();
      for (const double e : strains) pending.points.push_back({e, value_at(C, e), value_at(T, e)});
    }
    card.eos = made_of_points(owner, pending.line, file, [&] {
      return TabulatedEos(0, std::move(pending.points), pending.gamma, pending.initial_energy);
    });
  }
}

inline constexpr Meaning of_tabulated_eos{
    "`deck.eos<TabulatedEos>(part)`, of its points or of the curves LCC and LCT, with density and cut-off (PC, none if "
    "0) of the material",
    "that of `Solid` of `VonMises` and of `Fluid`, in hexahedra", "V0; in a scene: other strengths"};

}  // namespace strike::detail::dyna
