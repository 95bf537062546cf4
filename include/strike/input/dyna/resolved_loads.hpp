#pragma once
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <strike/input/dyna/draft.hpp>
#include <strike/input/dyna/lookup.hpp>

// Loads and motions in a deck that is complete but for them.
namespace strike::detail::dyna {

/// Takes the points of the curve. Errors: it is not there; its times do not ascend.
inline void follow_curve(CardHistory& history, std::uint32_t line, const Lookup& lookup, const DynaDeck& deck,
                         File& file) {
  const CurveCard& curve = lookup.curve({Named::all, history.curve, line});
  const auto earlier = [](const auto& a, const auto& b) { return a[0] < b[0]; };
  const std::string number = std::to_string(curve.number);
  if (curve.points.empty() || !std::is_sorted(curve.points.begin(), curve.points.end(), earlier))
    file.source().refuse(line,
                         {"curve ", number, curve.points.empty() ? " has no points" : " does not go forward in time",
                          ", as a history must: correct it, or name another curve."});
  history.points = curve.points;
  if (curve.phase == 1) {
    history.scale = 0;
    file.ignore_on_line(line, joined({"A load by curve ", number, " (SIDR 1, before the run alone)"}));
  } else if (const double last = curve.points.back()[0] + history.birth;
             last < std::min(deck.end_time, history.death) && curve.points.size() > 1) {
    file.ignore_on_line(line,
                        joined({"The end of curve ", number, " before that of the run (its last value goes on)"}));
  }
}

inline void resolve_bodies(Draft& draft, const Lookup& lookup, DynaDeck& deck) {
  for (const PendingInertia& pending : draft.inertia_systems)
    draft.inertia(pending).turn(lookup.axes({Named::all, pending.number, pending.line}));
  for (auto& [card, choices, system, line] : draft.rigid_bodies) {
    card.nodes = lookup.nodes(choices);
    if (system != 0) card.held.system = lookup.axes({Named::all, system, line});
    deck.rigid_bodies.push_back(std::move(card));
  }
  for (const auto& [card, choices, system, line] : draft.rigid_merges) {
    lookup.expect_body({Named::part, card.lead, line}), lookup.expect_body({Named::part, card.constrained, line});
    deck.rigid_merges.push_back(card);
  }
  for (auto& [card, choices, system, line] : draft.extra_nodes) {
    lookup.expect_body({Named::part, card.part, line});
    card.nodes = lookup.nodes(choices);
    deck.extra_nodes.push_back(std::move(card));
  }
}
inline void resolve_walls(Draft& draft, const Lookup& lookup, DynaDeck& deck, File& file) {
  const auto add = [&](auto& cards, auto& pending) {
    for (auto& [card, choices, system, line] : pending) {
      card.nodes = lookup.nodes(choices);
      if (card.motion) follow_curve(card.motion->history, line, lookup, deck, file);
      cards.push_back(std::move(card));
    }
  };
  add(deck.walls, draft.walls), add(deck.obstacles, draft.obstacles);
}
/// Cells and nodes of histories, and what a deck says for all of its sections.
inline void resolve_controls(Draft& draft, const Lookup& lookup, DynaDeck& deck) {
  deck.history_nodes = lookup.nodes(draft.history_nodes);
  for (const Choice& choice : draft.history_cells) {
    const std::vector<Index> cells = lookup.cells_of(choice);
    deck.history_cells.insert(deck.history_cells.end(), cells.begin(), cells.end());
  }
  deck.history_cells = ascending(std::move(deck.history_cells));
  if (draft.plots > 0)
    for (OutputCard& output : deck.outputs)
      if (output.name == "D3PLOT") output.interval = deck.end_time / draft.plots;
  std::erase_if(deck.outputs, [](const OutputCard& output) { return !(output.interval > 0); });
  if (deck.hourglass_control) {
    deck.hourglass_control->quadratic = deck.bulk_viscosity[0];
    deck.hourglass_control->linear = deck.bulk_viscosity[1];
  }
  for (SectionCard& section : deck.sections)
    if (section.element_form == 0) section.element_form = deck.shell_control.element_form;
  for (CompositeCard& composite : deck.composites)
    if (composite.element_form == 0) composite.element_form = deck.shell_control.element_form;
}
inline void resolve_loads(Draft& draft, const Lookup& lookup, DynaDeck& deck, File& file) {
  std::vector<FileNumber> loaded;
  for (const Choice& set : draft.body_load_parts)
    for (const Index part : lookup.parts(set)) loaded.push_back(deck.parts[part].number);
  loaded = ascending(std::move(loaded));
  for (auto& [card, choices, system, line] : draft.body_loads) {
    follow_curve(card.history, line, lookup, deck, file);
    if (system != 0) card.direction = (lookup.axes({Named::all, system, line}) * card.direction).eval();
    card.parts = loaded;
    deck.body_loads.push_back(std::move(card));
  }
  for (auto& [card, choices, system, line] : draft.nodal_loads) {
    follow_curve(card.history, line, lookup, deck, file);
    if (system != 0) card.direction = (lookup.axes({Named::all, system, line}) * card.direction).eval();
    lookup.expect_forces(choices);
    card.nodes = lookup.nodes(choices);
    deck.nodal_loads.push_back(std::move(card));
  }
  for (auto& [card, segments, choices, line] : draft.pressures) {
    follow_curve(card.history, line, lookup, deck, file);
    card.segments = lookup.segments(segments, file);
    for (const Choice& choice : choices) lookup.add_faces(choice, card.segments);
    deck.pressures.push_back(std::move(card));
  }
  for (auto& [card, choices, vector, line] : draft.motions) {
    follow_curve(card.history, line, lookup, deck, file);
    if (vector != 0) card.direction = lookup.direction({Named::all, vector, line});
    if (card.body == 0)
      card.nodes = lookup.nodes(choices);
    else
      lookup.expect_body(choices.front());
    deck.motions.push_back(std::move(card));
  }
}

}  // namespace strike::detail::dyna
