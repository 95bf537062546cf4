#pragma once
#include <algorithm>
#include <array>
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

/// The reader of a keyword's cards; null if there is none.
inline const Keyword* find_keyword(std::string_view name) {
  const Keyword* found = parameter_keyword(name);
  if (!found) found = keyword_with_options(name);
  if (!found) found = rigid_body_keyword(name);
  if (!found) found = wall_keyword(name);
  if (!found) found = contact_keyword(name);
  if (!found) found = output_keyword(name);
  const auto search = [&](const auto& keywords) {
    for (const Keyword& keyword : keywords)
      if (keyword.name == name) found = &keyword;
  };
  search(mesh_keywords), search(set_keywords), search(transformation_keywords), search(material_keywords);
  search(section_keywords), search(load_keywords), search(definition_keywords), search(force_keywords);
  search(rigid_keywords), search(control_keywords), search(blast_keywords);
  return found;
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
/// Elements without mass or stiffness.
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
  else if (name.starts_with("*COMMENT"))
    file.pass();
  else
    file.skip();
}

}  // namespace detail::dyna

/// The mesh and the cards of an LS-DYNA keyword file (.k, .key, .dyn) in the standard, long or I10 format, of fixed
/// columns or with commas. docs/read_a_mesh.md lists the keywords that are read; others, and values without a
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
