#pragma once
#include <algorithm>
#include <string>
#include <utility>

#include <strike/input/abaqus.hpp>
#include <strike/input/deck.hpp>
#include <strike/input/dyna.hpp>
#include <strike/input/gmsh.hpp>

namespace strike {

/// The mesh of a file by the ending of its name: .msh gmsh, .inp Abaqus, .k, .key or .dyn LS-DYNA. Errors: another
/// ending; those of the reader.
inline Deck read_mesh(const std::string& path, const ReadOptions& options = {}) {
  const std::string ending = detail::upper(std::string_view(path).substr(std::min(path.rfind('.'), path.size())));
  if (ending == ".MSH") return read_gmsh(path, options);
  if (ending == ".INP") {
    AbaqusDeck deck = read_abaqus(path, options);
    return std::move(static_cast<Deck&>(deck));
  }
  if (ending == ".K" || ending == ".KEY" || ending == ".DYN") {
    DynaDeck deck = read_dyna(path, options);
    return std::move(static_cast<Deck&>(deck));
  }
  throw Error(detail::joined({"strike: the file '", path,
                              "' has an ending that is not read: give a .msh (gmsh), an .inp (Abaqus) or a .k "
                              "(LS-DYNA)."}));
}

}  // namespace strike
