#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include <strike/deck/code.hpp>
#include <strike/deck/scene.hpp>
#include <strike/input/dyna_cards.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// The values that all plates of a part have on their own cards, zeros where none has any. Nothing: they differ.
inline std::optional<ShellCard> common_values(const DynaDeck& deck, const NamedSet& part, std::size_t plates) {
  ShellCard common{};
  std::size_t count = 0;
  for (const ShellCard& card : deck.shells) {
    if (!std::binary_search(part.members.begin(), part.members.end(), card.cell)) continue;
    if (count == 0) common = card;
    if (card.corner_thickness != common.corner_thickness || card.angle != common.angle || card.offset != common.offset)
      return std::nullopt;
    ++count;
  }
  const auto& t = common.corner_thickness;
  const bool one_thickness = t[1] == t[0] && t[2] == t[0] && (t[3] == t[0] || t[3] == 0);
  return (count == 0 || count == plates) && one_thickness ? std::optional(common) : std::nullopt;
}

/// The plies of a part: of *PART_COMPOSITE, or of *MAT_COMPOSITE_DAMAGE or *MAT_ENHANCED_COMPOSITE_DAMAGE in a section.
class LaminateOfPart {
 public:
  LaminateOfPart(const DynaDeck& deck, const NamedSet& part, const PartCells& cells, const PartCard& card)
      : deck_(deck), plates_(cells.quadrilaterals.size() + cells.triangles.size()) {
    const auto own = common_values(deck, part, plates_);
    if (!own) tell(cannot, {"the values of shells of their own differ: those of the section count."});
    const ShellCard values = own.value_or(ShellCard{});
    const auto composite = std::find_if(deck.composites.begin(), deck.composites.end(),
                                        [&](const CompositeCard& one) { return one.part == part.number; });
    if (composite != deck.composites.end()) {
      if (values.corner_thickness[0] > 0)
        tell(cannot, {"*ELEMENT_SHELL_THICKNESS: its layers are as thick as *PART_COMPOSITE says."});
      for (const CompositeCard::Layer& layer : composite->layers)
        add(layer.material, layer.thickness, layer.angle, values.angle);
      element_form = composite->element_form;
      place(composite->reference, composite->shear_factor, values.offset);
    } else if (const auto section = std::find_if(deck.sections.begin(), deck.sections.end(),
                                                 [&](const SectionCard& one) { return one.number == card.section; });
               section != deck.sections.end()) {
      const auto& t = section->corner_thickness;
      const double thickness = values.corner_thickness[0] > 0 ? values.corner_thickness[0] : t[0];
      if (values.corner_thickness[0] == 0 && std::any_of(t.begin(), t.end(), [&](double at) { return at != t[0]; }))
        tell(cannot, {"the thickness is that of the first corner, T1."});
      const FileNumber count = std::max<FileNumber>(section->points, 1);
      if (thickness > 0)
        for (FileNumber k = 0; k < count; ++k)
          add(card.material, thickness / static_cast<double>(count), 0, values.angle);
      tell(replaced,
           {std::to_string(count), count == 1 ? " ply" : " equal plies", " of two points each by Gauss' rule ",
            count == 1 ? "stands" : "stand", " for NIP ", std::to_string(section->points), "."});
      element_form = section->element_form;
      place(section->reference, section->shear_factor, values.offset);
    }
    if (plies.empty()) known = false, tell(cannot, {"it has no plies of a thickness: its shells are left out."});
    if (known) find_direction(cells);
  }

  bool known = true;  ///< all layers are plies here
  std::vector<Ply<DeckPly>> plies;
  std::vector<FileNumber> materials;  ///< of each ply
  Eigen::Vector3d direction{1, 0, 0};
  double offset = 0;
  FileNumber element_form = 2;
  std::vector<std::string> replaced, cannot;  ///< sentences without the name of the part

  std::string code() const {
    std::string all;
    for (std::size_t k = 0; k < plies.size(); ++k)
      all += joined({all.empty() ? "Ply{" : ", Ply{", name_of(materials[k]), ", ", code_of(plies[k].thickness),
                     plies[k].angle != 0 ? ", " : "", plies[k].angle != 0 ? code_of(plies[k].angle) : "", "}"});
    return joined(
        {"Layered{PlyStack{{", all, "}}, Offset{", code_of(offset), "}, FibreDirection{", code_of(direction), "}}"});
  }
  static std::string name_of(FileNumber material) { return joined({"ply_", std::to_string(material)}); }

 private:
  static void tell(std::vector<std::string>& sentences, std::initializer_list<std::string_view> parts) {
    std::string sentence = joined(parts);
    if (std::find(sentences.begin(), sentences.end(), sentence) == sentences.end())
      sentences.push_back(std::move(sentence));
  }

  /// A layer of a material, at the angle of its card; BETA of its plates counts before the angle of the material.
  void add(FileNumber number, double thickness, double angle, double beta) {
    const auto material = std::find_if(deck_.materials.begin(), deck_.materials.end(),
                                       [&](const MaterialCard& one) { return one.number == number; });
    const std::string of = joined({"Material ", std::to_string(number)});
    if (std::any_of(deck_.erosions.begin(), deck_.erosions.end(),
                    [&](const ErosionCard& erosion) { return erosion.material == number; }))
      tell(cannot, {of, ": *MAT_ADD_EROSION of plies is left out."});
    if (material == deck_.materials.end()) {
      known = false, tell(cannot, {of, " of a layer is not known here: its shells are left out."});
    } else if (const auto* const fibres = std::get_if<PlyMaterial>(&material->material)) {
      Ply<DeckPly> ply{{fibres->ply, fibres->criterion}, thickness, angle};
      if (!fibres->fibres)
        ply.angle += beta != 0 ? beta : fibres->ply.angle;
      else if (beta != 0 || fibres->ply.angle != 0)
        tell(replaced, {of, ": its angle, or BETA of its plates, counts for AOPT 0 and 3 alone."});
      ply.material.ply.angle = 0;
      if (material->keyword.find("ENHANCED") == std::string::npos && material->keyword.find("054") == std::string::npos)
        tell(replaced, {of, ": plates whose points have all failed are deleted."});
      directions_.push_back(fibres->fibres);
      add(number, ply);
    } else if (const auto* const elastic = std::get_if<Elastic>(&material->material)) {
      const double E = elastic->youngs_modulus, nu = elastic->poissons_ratio, G = elastic->shear_modulus();
      const OrthotropicPly same{
          .density = elastic->density, .E1 = E, .E2 = E, .nu12 = nu, .G12 = G, .G13 = G, .G23 = G, .nu23 = nu};
      add(number, {{same, ChangChang{.Xt = 1e18, .Xc = 1e18, .Yt = 1e18, .Yc = 1e18, .S = 1e18}}, thickness});
    } else {
      known = false;
      tell(cannot,
           {of, " of a layer, ", material->keyword, ", is neither a ply nor elastic: its shells are left out."});
    }
  }
  void add(FileNumber number, const Ply<DeckPly>& ply) { materials.push_back(number), plies.push_back(ply); }

  void place(double reference, double shear_factor, double own_offset) {
    double thickness = 0;
    for (const auto& ply : plies) thickness += ply.thickness;
    offset = own_offset != 0 ? own_offset : reference != 0 ? -0.5 * reference * thickness : 0;
    tell(replaced, {"the transverse shear by equilibrium stands for SHRF ", code_of(shear_factor), "."});
  }

  /// A of AOPT 2, or of AOPT 0 the side from the first to the second node where it is the same for all plates.
  void find_direction(const PartCells& cells) {
    if (directions_.empty()) return;
    const auto& first = directions_.front();
    if (std::any_of(directions_.begin(), directions_.end(), [&](const auto& other) { return other != first; }))
      tell(cannot, {"the fibres of its materials have several directions (AOPT, A): those of the lowest ply count."});
    if (first) {
      direction = *first;
      return;
    }
    bool has_side = false;
    double most = 0;
    const auto visit = [&](const auto& corners) {
      const auto x = [&](std::size_t i) { return deck_.mesh.nodes[corners[i]]; };
      const Eigen::Vector3d side = x(1) - x(0);
      if (!has_side) direction = side.normalized(), has_side = true;
      const Eigen::Vector3d n =
          cross<double>(Eigen::Vector3d(x(2) - x(0)), Eigen::Vector3d(x(corners.size() - 1) - x(1))).normalized();
      const auto in_plane = [&](const Eigen::Vector3d& d) -> Eigen::Vector3d { return d - d.dot(n) * n; };
      const Eigen::Vector3d a = in_plane(direction), b = in_plane(side);
      const double angle = std::atan2(cross<double>(a, b).norm(), std::abs(a.dot(b)));  // fibres have no sense
      most = std::max(most, a.norm() > 1e-3 ? angle * 180 / std::numbers::pi : 90);
    };
    for (const auto& corners : cells.quadrilaterals) visit(corners);
    for (const auto& corners : cells.triangles) visit(corners);
    if (most > 1)
      tell(cannot, {"its fibres follow the first side of each plate (AOPT 0), and these turn by up to ", text(most),
                    " degrees: here they have the direction of the first plate."});
    else
      for (Eigen::Index a = 0; a < 3; ++a) direction(a) = std::abs(direction(a)) < 1e-12 ? 0 : direction(a);
  }

  const DynaDeck& deck_;
  std::size_t plates_;
  std::vector<std::optional<Eigen::Vector3d>> directions_;  // A of each ply with fibres
};

}  // namespace strike::detail
