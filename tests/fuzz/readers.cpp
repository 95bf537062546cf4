// What no input may do: crash a reader, or leave it with anything but a deck or an Error.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <variant>
#include <vector>

#include <strike/input.hpp>

namespace {

void expect(bool holds) {
  if (!holds) std::abort();
}
void expect_below(const std::vector<strike::Index>& members, std::size_t count) {
  for (const strike::Index member : members) expect(member < count);
}

/// Every number in a deck names something that is there.
void expect_whole(const strike::Deck& deck) {
  const std::size_t nodes = deck.mesh.nodes.size();
  const std::size_t cells = deck.mesh.hexahedra.size() + deck.mesh.tetrahedra.size() + deck.mesh.quadrilaterals.size() +
                            deck.mesh.triangles.size();
  const auto expect_cells = [&](const auto& list) {
    for (const auto& cell : list)
      for (const strike::Index node : cell) expect(node < nodes);
  };
  expect_cells(deck.mesh.hexahedra), expect_cells(deck.mesh.tetrahedra), expect_cells(deck.mesh.quadrilaterals);
  expect_cells(deck.mesh.triangles);
  expect(deck.node_numbers.size() == nodes && deck.cell_numbers.size() == cells);
  for (const auto& x : deck.mesh.nodes) expect(x.allFinite());
  const auto expect_members = [&](const auto& sets, std::size_t count) {
    for (const strike::NamedSet& set : sets) expect_below(set.members, count);
  };
  expect_members(deck.parts, cells), expect_members(deck.cell_sets, cells), expect_members(deck.node_sets, nodes);
}
void expect_whole(const strike::DynaDeck& deck) {
  expect_whole(static_cast<const strike::Deck&>(deck));
  const auto expect_nodes = [&](const auto& cards) {
    for (const auto& card : cards) expect_below(card.nodes, deck.mesh.nodes.size());
  };
  expect_nodes(deck.supports), expect_nodes(deck.velocities), expect_nodes(deck.walls);
  expect_nodes(deck.nodal_loads), expect_nodes(deck.motions);
  expect_nodes(deck.rigid_bodies), expect_nodes(deck.extra_nodes), expect_nodes(deck.obstacles);
  const auto expect_segments = [&](const auto& cards) {
    for (const auto& card : cards)
      for (const auto& segment : card.segments)
        for (const strike::Index node : segment) expect(node < deck.mesh.nodes.size());
  };
  expect_segments(deck.pressures), expect_segments(deck.blasts);
  for (const auto& motion : deck.motions) expect(std::abs(motion.direction.norm() - 1) < 1e-6);
  for (const auto& load : deck.body_loads)
    expect(!std::isnan(load.history(1)) && !std::isnan(load.history.integral(1)));
  expect_below(deck.history_nodes, deck.mesh.nodes.size()), expect_below(deck.history_cells, deck.cell_numbers.size());
  for (const auto& set : deck.part_sets) expect_below(set.members, deck.parts.size());
  for (const auto& set : deck.segment_sets)
    for (const auto& segment : set.segments)
      for (const strike::Index node : segment) expect(node < deck.mesh.nodes.size());
  for (const auto& shell : deck.shells) expect(shell.cell < deck.cell_numbers.size());
  for (const auto& curve : deck.curves)
    for (const auto& [a, o] : curve.points) expect(std::isfinite(a) && std::isfinite(o));
  for (const auto& table : deck.tables) expect(table.values.size() == table.curves.size());
  for (const auto& system : deck.coordinate_systems) expect(system.axes.isUnitary(1e-6));
  for (const auto& contact : deck.contacts) expect_nodes(std::array{contact.slave, contact.master});
  for (const auto& card : deck.materials) {
    if (const auto* rigid = std::get_if<strike::RigidMaterial>(&card.material)) expect(rigid->system.isUnitary(1e-6));
    if (const auto* table = std::get_if<strike::TabulatedRatesMaterial>(&card.material))
      for (const double strain : {0.0, 0.01, 100.0})
        for (const double rate : {0.0, 10.0, 1e30}) (void)table->strength.flow_stress(strain, rate);
  }
}
void expect_whole(const strike::AbaqusDeck& deck) {
  expect_whole(static_cast<const strike::Deck&>(deck));
  const auto expect_nodes = [&](const auto& cards) {
    for (const auto& card : cards) expect_below(card.nodes, deck.mesh.nodes.size());
  };
  const auto expect_segments = [&](const auto& cards) {
    for (const auto& card : cards)
      for (const auto& segment : card.segments)
        for (const strike::Index node : segment) expect(node < deck.mesh.nodes.size());
  };
  expect_nodes(deck.supports), expect_nodes(deck.motions), expect_nodes(deck.velocities), expect_nodes(deck.forces);
  expect_segments(deck.pressures);
  for (const auto& surface : deck.surfaces) {
    expect_nodes(std::array{surface.side});
    expect_segments(std::array{surface.side});
  }
  for (const auto& contact : deck.contacts) {
    expect_nodes(std::array{contact.slave, contact.master});
    expect_segments(std::array{contact.slave, contact.master});
  }
  for (const auto& curve : deck.curves)
    for (const auto& [time, value] : curve.points) expect(std::isfinite(time) && std::isfinite(value));
  for (const auto& gravity : deck.gravities) expect(gravity.acceleration.allFinite());
}

template <class Reader>
void expect_deck_or_error(Reader reader) {
  try {
    expect_whole(reader());
  } catch (const strike::Error&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  static const char* const chosen = std::getenv("READER");  // one of them; all without it
  int readers = 0;
  const auto feed = [&](std::string_view name, auto reader) {
    if (chosen && chosen != name) return;
    expect_deck_or_error([&] { return reader(text, "input"); });
    ++readers;
  };
  static const char* const decks = std::getenv("DECKS");  // the folder of included files; none without it
  const strike::ReadOptions options{
      .folder = decks ? decks : "",
      .leave_out_elements = true,
      .second_order = size % 2 == 0 ? strike::SecondOrder::in_pieces : strike::SecondOrder::to_corners};
  feed("gmsh", [&](auto... source) { return strike::read_gmsh(source..., options); });
  feed("abaqus", [&](auto... source) { return strike::read_abaqus(source..., options); });
  feed("dyna", [&](auto... source) { return strike::read_dyna(source..., options); });
  expect(readers > 0);
  return 0;
}
