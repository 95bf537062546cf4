#pragma once
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <strike/input/dyna/blasts.hpp>
#include <strike/input/dyna/contacts.hpp>
#include <strike/input/dyna/controls.hpp>
#include <strike/input/dyna/definitions.hpp>
#include <strike/input/dyna/draft.hpp>
#include <strike/input/dyna/file.hpp>
#include <strike/input/dyna/forces.hpp>
#include <strike/input/dyna/loads.hpp>
#include <strike/input/dyna/materials.hpp>
#include <strike/input/dyna/mesh.hpp>
#include <strike/input/dyna/parameter_cards.hpp>
#include <strike/input/dyna/resolved.hpp>
#include <strike/input/dyna/rigid_bodies.hpp>
#include <strike/input/dyna/sections.hpp>
#include <strike/input/dyna/sets.hpp>
#include <strike/input/dyna/transformations.hpp>
#include <strike/input/dyna/walls.hpp>
#include <strike/input/dyna_cards.hpp>
#include <strike/input/source.hpp>

namespace strike {
namespace detail::dyna {

/// Keywords that are read, as docs/deck_cards.md groups them.
struct KeywordGroup {
  std::string_view title;
  std::span<const Keyword> keywords;
  std::span<const Family> families = {};
};
inline constexpr auto keyword_groups = std::to_array<KeywordGroup>({
    {"Parameters", parameter_keywords, parameter_families},
    {"Mesh", mesh_keywords, mesh_families},
    {"Sets", set_keywords},
    {"Transformations", transformation_keywords},
    {"Materials", material_keywords},
    {"Sections, and the run's title", section_keywords},
    {"Supports and initial velocities", load_keywords},
    {"Loads and motions", force_keywords},
    {"Blasts", blast_keywords},
    {"Definitions", definition_keywords},
    {"Rigid bodies", rigid_keywords, rigid_families},
    {"Rigid walls", {}, wall_families},
    {"Contacts", {}, contact_families},
    {"Control and output", control_keywords, output_families},
});

/// The reader of a keyword's cards; null if there is none.
inline const Keyword* find_keyword(std::string_view name) {
  for (const KeywordGroup& group : keyword_groups) {
    for (const Keyword& keyword : group.keywords)
      if (keyword.name == name) return &keyword;
    for (const Family& family : group.families)
      if (const Keyword* const found = family.find(name)) return found;
  }
  return nullptr;
}
/// Error: the cards would be others in the units or at the place that *INCLUDE_TRANSFORM gives them.
inline void expect_invariant(const Keyword& keyword, const File& file) {
  if (keyword.invariant == Invariant::everywhere || file.motion() == 0) return;
  const Motion& motion = file.motions()[file.motion() - 1];
  if (motion.has_units)
    file.refuse({file.name(),
                 " is not converted by FCTMAS, FCTTIM and FCTLEN: give it in the units of the deck, in "
                 "a file without them."});
  if (keyword.invariant == Invariant::none)
    file.refuse({file.name(), " is not moved by TRANID: write it as it should be, in a file without it."});
}
/// Keywords by their beginnings without which a deck would be another one, and what to do.
struct Refusal {
  std::string_view beginning, advice;
};
inline constexpr auto refusals = std::to_array<Refusal>({
    {"*CASE", "makes several runs of one deck: write a deck for each case"},
    {"*CONTROL_IMPLICIT", "makes the run implicit, and this one is explicit: take it out"},
    {"*NODE_MERGE", "is not read: write the nodes as they are after it"},
    {"*NODE_TRANSFORM", "is not read: write the nodes as they are after it"},
    {"*NODE_THICKNESS", "is not read: write the thickness with *ELEMENT_SHELL_THICKNESS"},
    {"*PART_MOVE", "is not read: write the nodes as they are after it"},
    {"*PART_DUPLICATE", "is not read: write the nodes and elements that it makes"},
    {"*PART_STACKED_ELEMENTS", "is not read: write the nodes and elements that it makes"},
    {"*PARAMETER", "is not read: write the values of its parameters with *PARAMETER"},
    {"*ELEMENT_SOLID", "is not read: write the elements as *ELEMENT_SOLID"},
    {"*ELEMENT_SHELL", "is not read: write the elements as *ELEMENT_SHELL"},
    {"*ELEMENT_GENERALIZED", "is not read: write the elements as *ELEMENT_SOLID or *ELEMENT_SHELL"},
    {"*CHANGE_", "belongs to a restart: write the whole deck as it should be"},
    {"*DELETE_", "belongs to a restart: write the whole deck as it should be"},
    {"*STRESS_INITIALIZATION", "belongs to a restart: write the whole deck as it should be"},
});
/// Comments, passed in silence.
inline constexpr std::string_view comment = "*COMMENT";
/// Elements without mass or stiffness, skipped with a warning.
inline constexpr auto marks =
    std::to_array<std::string_view>({"*ELEMENT_PLOTEL", "*ELEMENT_SEATBELT_ACCELEROMETER", "*ELEMENT_SEATBELT_SENSOR"});
/// Lines of an element: one, and one more for each option; 0 if that is not known.
inline std::size_t lines_of_element(std::string_view name) {
  for (const std::string_view kind : {"*ELEMENT_BEAM", "*ELEMENT_TSHELL", "*ELEMENT_DISCRETE", "*ELEMENT_MASS",
                                      "*ELEMENT_SPH", "*ELEMENT_SEATBELT", "*ELEMENT_LANCING"})
    if (name == kind) return 1;
  for (const std::string_view option : {"_THICKNESS", "_SECTION", "_OFFSET", "_ORIENTATION", "_SCALAR"})
    if (name.substr(std::min<std::size_t>(name.size(), 13)) == option && name.starts_with("*ELEMENT_BEAM")) return 2;
  return name == "*ELEMENT_TSHELL_BETA" ? 2 : 0;
}
/// Passes a keyword that is not read. Error: the deck would be another one without it.
inline void pass_keyword(File& file) {
  const std::string_view name = file.base();
  for (const auto& [beginning, advice] : refusals)
    if (name.starts_with(beginning)) file.refuse({name, " ", advice, "."});
  const bool is_mark = std::any_of(marks.begin(), marks.end(), [&](auto mark) { return name.starts_with(mark); });
  if (name.starts_with("*ELEMENT_") && !is_mark)
    file.leave_out_elements(lines_of_element(name));
  else if (name.starts_with(comment))
    file.pass();
  else
    file.skip();
}

}  // namespace detail::dyna

/// The mesh and the cards of an LS-DYNA keyword file (.k, .key, .dyn) in the standard, long or I10 format, of fixed
/// columns or with commas. docs/deck_cards.md lists the keywords that are read; others, and values without a
/// counterpart here, are skipped with a warning. `name` is the file in messages. Included files are read below the
/// folder of the deck. Errors: a file that is not there, or elsewhere; elements of second order, unless the options cut
/// them; text in the place of a number; a number given twice; a node, set or part that is not there; a material without
/// a density or a modulus.
inline DynaDeck read_dyna(std::string_view text, const std::string& name, const ReadOptions& options = {}) {
  return detail::within_memory(name, [&] {
    detail::dyna::File file(detail::Source(text, name, options));
    detail::dyna::Draft draft;
    draft.raw.second_order = options.second_order;
    while (file.next_keyword()) {
      if (const auto* const keyword = detail::dyna::find_keyword(file.base())) {
        detail::dyna::expect_invariant(*keyword, file);
        keyword->read(file, draft);
      } else {
        detail::dyna::pass_keyword(file);
      }
    }
    if (!options.leave_out_elements) file.expect_all_elements();
    return detail::dyna::resolved(std::move(draft), file);
  });
}
inline DynaDeck read_dyna(const std::string& path, ReadOptions options = {}) {
  if (options.folder.empty()) options.folder = detail::folder_of(path);
  return read_dyna(detail::content_of_file(path), path, options);
}

}  // namespace strike
