#pragma once
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include <strike/input/dyna/draft.hpp>
#include <strike/input/dyna/file.hpp>
#include <strike/input/dyna/loads.hpp>
#include <strike/input/dyna/materials.hpp>
#include <strike/input/dyna/mesh.hpp>
#include <strike/input/dyna/parameter_cards.hpp>
#include <strike/input/dyna/resolved.hpp>
#include <strike/input/dyna/sections.hpp>
#include <strike/input/dyna/sets.hpp>
#include <strike/input/dyna/transformations.hpp>
#include <strike/input/dyna_cards.hpp>
#include <strike/input/source.hpp>

namespace strike {
namespace detail::dyna {

/// The reader of a keyword's cards; null if there is none.
inline const Keyword* find_keyword(std::string_view name) {
  const Keyword* found = parameter_keyword(name);
  const auto search = [&](const auto& keywords) {
    for (const Keyword& keyword : keywords)
      if (keyword.name == name) found = &keyword;
  };
  search(mesh_keywords), search(set_keywords), search(transformation_keywords), search(material_keywords);
  search(section_keywords), search(load_keywords);
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
/// Passes a keyword that is not read. Error: the mesh would be another one without it.
inline void pass_keyword(File& file) {
  const std::string_view name = file.base();
  for (const std::string_view read : {"*ELEMENT_SOLID", "*ELEMENT_SHELL"})
    if (name.starts_with(read)) file.refuse({name, " is not read: write the elements as ", read, "."});
  if (name.starts_with("*NODE_MERGE") || name.starts_with("*NODE_TRANSFORM"))
    file.refuse({name, " is not read: write the nodes as they are after it."});
  constexpr std::string_view element = "*ELEMENT_";
  if (name.starts_with(element) && name.find('_', element.size()) == name.npos)
    file.ignore_elements();
  else
    file.skip();
}

}  // namespace detail::dyna

/// The mesh and the cards of an LS-DYNA keyword file (.k, .key, .dyn) in the standard format, of fixed columns or with
/// commas. docs/read_a_mesh.md lists the keywords that are read; others, and values without a counterpart here, are
/// skipped with a warning. `name` is the file in messages. Included files are read below the folder of the deck.
/// Errors: a file that is not there, or elsewhere; the long formats; elements of higher order, wedges; text in the
/// place of a number; a number given twice; a node, set or part that is not there; a material without a density or a
/// modulus.
inline DynaDeck read_dyna(std::string_view text, const std::string& name, const ReadOptions& options = {}) {
  return detail::within_memory(name, [&] {
    detail::dyna::File file(detail::Source(text, name, options));
    detail::dyna::Draft draft;
    while (file.next_keyword()) {
      if (const auto* const keyword = detail::dyna::find_keyword(file.base())) {
        detail::dyna::expect_invariant(*keyword, file);
        keyword->read(file, draft);
      } else {
        detail::dyna::pass_keyword(file);
      }
    }
    return detail::dyna::resolved(std::move(draft), file);
  });
}
inline DynaDeck read_dyna(const std::string& path, ReadOptions options = {}) {
  if (options.folder.empty()) options.folder = detail::folder_of(path);
  return read_dyna(detail::content_of_file(path), path, options);
}

}  // namespace strike
