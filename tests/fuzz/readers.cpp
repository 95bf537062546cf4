// What no input may do: crash a reader, or leave it with anything but a deck or an Error.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <strike/input.hpp>

namespace {

/// Every number in a deck names something that is there.
void expect_whole(const strike::Deck& deck) {
  const auto expect = [](bool holds) {
    if (!holds) std::abort();
  };
  const std::size_t nodes = deck.mesh.nodes.size();
  const std::size_t cells = deck.mesh.hexahedra.size() + deck.mesh.tetrahedra.size() + deck.mesh.quadrilaterals.size();
  const auto expect_cells = [&](const auto& list) {
    for (const auto& cell : list)
      for (const strike::Index node : cell) expect(node < nodes);
  };
  expect_cells(deck.mesh.hexahedra), expect_cells(deck.mesh.tetrahedra), expect_cells(deck.mesh.quadrilaterals);
  expect(deck.node_numbers.size() == nodes && deck.cell_numbers.size() == cells);
  for (const auto& x : deck.mesh.nodes) expect(x.allFinite());
  const auto expect_members = [&](const auto& sets, std::size_t count) {
    for (const strike::NamedSet& set : sets)
      for (const strike::Index member : set.members) expect(member < count);
  };
  expect_members(deck.parts, cells), expect_members(deck.cell_sets, cells), expect_members(deck.node_sets, nodes);
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
  expect_deck_or_error([&] { return strike::read_gmsh(text, "input"); });
  expect_deck_or_error([&] { return strike::read_abaqus(text, "input"); });
  expect_deck_or_error([&] { return strike::read_dyna(text, "input"); });
  return 0;
}
