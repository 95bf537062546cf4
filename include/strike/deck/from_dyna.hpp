#pragma once
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <strike/deck/code.hpp>
#include <strike/deck/laminate.hpp>
#include <strike/deck/scene.hpp>
#include <strike/error.hpp>
#include <strike/input/dyna_cards.hpp>
#include <strike/mesh/frame.hpp>
#include <strike/mesh/inertia.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/select.hpp>
#include <strike/text.hpp>

namespace strike {

namespace detail {

/// Makes the scene of an LS-DYNA deck, card by card.
class FromDyna {
 public:
  explicit FromDyna(const DynaDeck& deck) : deck_(deck) {
    made_.title = deck.title, made_.nodes = deck.mesh.nodes;
    made_.watched = deck.history_nodes, made_.node_numbers = deck.node_numbers;
    if (deck.step_factor > 0) made_.options.step_factor = deck.step_factor;
    made_.end = deck.end_time, made_.interval = deck.end_time / 40;
    if (const double dt = deck.interval("D3PLOT"); dt > 0) made_.interval = dt;
    if (!(made_.end > 0)) cannot({"The deck has no end: give *CONTROL_TERMINATION its ENDTIM."});
    if (deck.mass_scaled_step != 0) cannot({"DT2MS: no mass is scaled."});
    for (const NamedSet& part : deck.parts) add_part(part);
    for (const NamedSet& part : deck.parts) add_body(part);
    for (std::size_t i = 0; i < deck.rigid_bodies.size(); ++i) add_body(i);
    for (std::size_t i = 0; i < deck.extra_nodes.size(); ++i)
      if (!has_owner(deck.extra_nodes[i].part))
        cannot({"The extra nodes of part ", std::to_string(deck.extra_nodes[i].part),
                " are left out: it is no rigid body here."});
    for (const RigidMergeCard& merge : deck.rigid_merges)
      if (!rigid(merge.lead) || !rigid(merge.constrained))
        cannot({"*CONSTRAINED_RIGID_BODIES of ", std::to_string(merge.lead), " and ", std::to_string(merge.constrained),
                " is left out: both must be parts of *MAT_RIGID here."});
    if (!deck.history_cells.empty())
      replaced({"*DATABASE_HISTORY of shells and solids: the history has columns of nodes alone."});
    for (const PartCard& card : deck.part_cards)
      if (card.contact) cannot({"The card of *PART_CONTACT of part ", std::to_string(card.number), " is left out."});
    const ShellControl usual;
    if (deck.shell_control.warping_angle != usual.warping_angle || deck.shell_control.warping != usual.warping ||
        deck.shell_control.projects != usual.projects)
      replaced({"*CONTROL_SHELL: plates that know their warping stand for WRPANG, BWC and PROJ."});
    if (deck.shell_control.thickness_update >= 1) cannot({"ISTUPD: shells keep their thickness."});
    if (deck.contact_stiffness != 0.1) replaced({"SLSFAC: the springs of contacts are as stiff as the step allows."});
    tell_detonations();
    for (std::size_t i = 0; i < deck.velocities.size(); ++i) add_velocity(i);
    for (std::size_t i = 0; i < deck.supports.size(); ++i) add_support(i);
    for (std::size_t i = 0; i < deck.motions.size(); ++i) add_motion(i);
    for (std::size_t i = 0; i < deck.body_loads.size(); ++i) add_body_force(i);
    for (std::size_t i = 0; i < deck.nodal_loads.size(); ++i) add_nodal_force(i);
    for (std::size_t i = 0; i < deck.pressures.size(); ++i) add_pressure(i);
    for (std::size_t i = 0; i < deck.blasts.size(); ++i) add_blast(i);
    for (std::size_t i = 0; i < deck.walls.size(); ++i) add_wall(i);
    for (std::size_t i = 0; i < deck.obstacles.size(); ++i) add_obstacle(i);
    for (std::size_t i = 0; i < deck.contacts.size(); ++i)
      if (deck.contacts[i].is_tied()) add_tie(i);
    add_contacts();
    for (const std::string& warning : deck.warnings)
      if (warning.find("(a RigidWall ") == warning.npos)  // told where the wall is
        (is_harmless(warning) ? made_.replaced : made_.cannot).push_back(warning);
  }
  DeckScene made() { return std::move(made_); }

 private:
  using Texts = std::initializer_list<std::string_view>;
  void becomes(Texts parts) { made_.becomes.push_back(joined(parts)); }
  void replaced(Texts parts) { made_.replaced.push_back(joined(parts)); }
  void cannot(Texts parts) { made_.cannot.push_back(joined(parts)); }

  /// It concerns files that are written, or numbers of another solver.
  static bool is_harmless(std::string_view warning) {
    constexpr std::array<std::string_view, 13> starts{"*DATABASE",
                                                      "*CONTROL",
                                                      "Nodes without",
                                                      "*PARAMETER",
                                                      "DA1 to DA4 of",
                                                      "IBQ of",
                                                      "VDC of",
                                                      "YM, of null",
                                                      "PR, of null",
                                                      "BSORT of *CONTACT",
                                                      "FRCFRQ of *CONTACT",
                                                      "MAXPAR of *CONTACT",
                                                      "SBOPT of *CONTACT"};
    constexpr std::array<std::string_view, 2> fields{" of *DATABASE", " of *CONTROL_CONTACT"};
    return !warning.starts_with("*CONTROL_EXPLOSIVE") &&
           (std::any_of(starts.begin(), starts.end(),
                        [&](std::string_view start) { return warning.starts_with(start); }) ||
            std::any_of(fields.begin(), fields.end(),
                        [&](std::string_view field) { return warning.find(field) != warning.npos; }));
  }

  // Parts

  static std::string name_of(const NamedSet& part) {
    const std::string number = std::to_string(part.number);
    return part.name.empty() ? joined({"Part ", number}) : joined({"Part ", number, ", ", part.name});
  }
  /// Its name as that of a variable, or one by its number.
  static std::string variable_of(const NamedSet& part) {
    std::string name;
    for (const char c : part.name) {
      const auto letter = static_cast<unsigned char>(c);
      name += std::isalnum(letter) && letter < 128 ? static_cast<char>(std::tolower(letter)) : '_';
    }
    const bool plain =
        !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) && name.find("__") == name.npos;
    return plain ? joined({name, "_", std::to_string(part.number)}) : joined({"part_", std::to_string(part.number)});
  }
  static std::string cells_of(const NamedSet& part, const char* kind) {
    return joined({"deck.part(", std::to_string(part.number), ").", kind});
  }
  template <class Entry>
  static const Entry* numbered(const std::vector<Entry>& entries, FileNumber number) {
    for (const Entry& entry : entries)
      if (entry.number == number) return &entry;
    return nullptr;
  }
  const PartCard* card_of(FileNumber part) const { return numbered(deck_.part_cards, part); }
  const MaterialCard* material_of(FileNumber part) const {
    const PartCard* const card = card_of(part);
    return card ? numbered(deck_.materials, card->material) : nullptr;
  }

  void add_part(const NamedSet& part) {
    const PartCells cells = deck_.part(part.number);
    const MaterialCard* const material = material_of(part.number);
    if (is_laminate(part.number, material)) return add_laminate(part, cells);
    if (!material) {
      cannot({name_of(part), " has no material that is known here: its elements are left out."});
      return;
    }
    std::visit([&](const auto& law) { add_part(part, cells, *card_of(part.number), *material, law); },
               material->material);
  }
  bool is_laminate(FileNumber part, const MaterialCard* material) const {
    return (material && std::holds_alternative<PlyMaterial>(material->material)) ||
           std::any_of(deck_.composites.begin(), deck_.composites.end(),
                       [&](const CompositeCard& composite) { return composite.part == part; });
  }
  void add_laminate(const NamedSet& part, const PartCells& cells) {
    const PartCard& card = *card_of(part.number);
    if (!cells.hexahedra.empty() || !cells.tetrahedra.empty())
      cannot({name_of(part), ": plies are of plates, its solids are left out."});
    if (cells.quadrilaterals.empty() && cells.triangles.empty()) return;
    const LaminateOfPart laminate(deck_, part, cells, card);
    for (const std::string& sentence : laminate.replaced) replaced({name_of(part), ": ", sentence});
    for (const std::string& sentence : laminate.cannot) cannot({name_of(part), ": ", sentence});
    if (!laminate.known) return;
    tell_plates(part, card, laminate.element_form);
    for (std::size_t k = 0; k < laminate.plies.size(); ++k) {
      const std::string name = LaminateOfPart::name_of(laminate.materials[k]);
      if (std::any_of(made_.materials.begin(), made_.materials.end(), [&](const auto& m) { return m.name == name; }))
        continue;
      made_.materials.push_back({name, code_of(laminate.plies[k].material)});
      becomes({"Material ", std::to_string(laminate.materials[k]), ": ", name, ", ", made_.materials.back().code});
    }
    const Layered section{PlyStack{laminate.plies}, Offset{laminate.offset}, FibreDirection{laminate.direction}};
    if (!cells.quadrilaterals.empty())
      place(part, Plate4{}, section, laminate.code(), cells.quadrilaterals, "quadrilaterals", Erosion{});
    if (!cells.triangles.empty())
      place(part, Plate3{}, section, laminate.code(), cells.triangles, "triangles", Erosion{});
  }
  /// The element and the hourglass control that plates are asked for and do not have.
  void tell_plates(const NamedSet& part, const PartCard& card, FileNumber form) {
    if (form == 0) form = deck_.shell_control.element_form;
    if (form != 2)
      replaced(
          {name_of(part), ": plates of one point with hourglass control stand for ELFORM ", std::to_string(form), "."});
    if (card.hourglass != 0 || deck_.hourglass_control)
      replaced({name_of(part), ": the usual hourglass control of Plate4 stands for that of the deck."});
  }
  /// f(the material of a card, the law by which its elements are deleted). False: there is none.
  template <class Card, class F>
  bool with_material(FileNumber part, const Card& m, const F& f) {
    if constexpr (std::is_same_v<Card, Elastic>)
      return f(m, NoErosion{}), true;
    else if constexpr (std::is_same_v<Card, NullMaterial>)
      return with_eos(part, [&](const auto& eos) { f(Fluid{eos, Newtonian{m.viscosity}}, NoErosion{}); });
    else if constexpr (std::is_same_v<Card, ExplosiveMaterial>)
      return with_explosive(part, m, f);
    else if constexpr (std::is_same_v<Card, ViscoelasticMaterial>)
      return with_relaxation(part, {m.eos, m.strength.shear_modulus, {m.strength.terms[0]}}, f), true;
    else if constexpr (std::is_same_v<Card, PronyMaterial>)
      return with_relaxation(part, m, f), true;
    else if constexpr (requires { Solid{m.eos, m.strength}; })
      return with_strength(part, m.eos, m, f), true;
    else if constexpr (requires { Solid{GruneisenEos{}, m.strength}; })
      return with_eos(part, [&](const auto& eos) { with_strength(part, eos, m, f); });
    else
      return false;
  }
  template <class F>
  void with_relaxation(FileNumber part, const PronyMaterial& m, const F& f) {
    if (m.terms.size() > deck_terms) {
      cannot({"Part ", std::to_string(part), " is left out: its material has ", std::to_string(m.terms.size()),
              " terms of relaxation, and this program holds ", std::to_string(deck_terms), "."});
      return;
    }
    struct Relaxing {
      Prony<deck_terms> strength;
    };
    with_strength(part, m.eos, Relaxing{m.strength<deck_terms>()}, f);
  }
  template <class Eos, class Card, class F>
  void with_strength(FileNumber part, const Eos& eos, const Card& m, const F& f) {
    const FileNumber number = card_of(part)->material;
    const auto erosion = std::find_if(deck_.erosions.begin(), deck_.erosions.end(),
                                      [&](const ErosionCard& card) { return card.material == number; });
    const bool erodes = erosion != deck_.erosions.end();
    if (erodes && (erosion->volume > 0 || erosion->equivalent_stress || erosion->principal_stress || erosion->impulse))
      cannot({"Of *MAT_ADD_EROSION of material ", std::to_string(number), " the strain EFFEPS alone counts."});
    const auto with_law = [&](const auto& law) {
      if constexpr (has_plastic_strain<Solid<Eos, std::remove_cvref_t<decltype(law)>>>()) {
        if (erodes && std::isfinite(erosion->strain)) {
          FailureStrain limit{erosion->strain};
          if constexpr (requires { *m.failure; })
            if (m.failure) limit.failure_strain = std::min(limit.failure_strain, m.failure->failure_strain);
          if constexpr (requires { m.damage; })
            if (m.fractures()) cannot({"The damage D1 to D5 of *MAT_JOHNSON_COOK is left out beside EFFEPS."});
          return f(Solid{eos, law, limit}, Erosion{});
        }
      } else if (erodes) {
        cannot({"*MAT_ADD_EROSION of material ", std::to_string(number), ", which does not flow, is left out."});
      }
      if constexpr (requires { *m.failure; })
        if (m.failure) return f(Solid{eos, law, *m.failure}, Erosion{});
      if constexpr (requires { m.damage; }) {
        if (m.fractures()) return f(Solid{eos, law, m.fracture()}, Erosion{});
        if (m.damage != std::array<double, 5>{})
          cannot({"D3 to D5 of *MAT_JOHNSON_COOK are left out: without D1 and D2 nothing breaks."});
      }
      f(Solid{eos, law}, NoErosion{});
    };
    if constexpr (requires { *m.rate; })
      if (m.rate) return with_law(CowperSymonds{m.strength, m.rate->D, m.rate->p});
    with_law(m.strength);
  }
  /// f(the equation of state of a part). False: it has none.
  template <class F>
  bool with_eos(FileNumber part, const F& f) {
    const EosCard* const eos = numbered(deck_.equations_of_state, card_of(part)->eos);
    if (!eos) return false;
    return std::visit(
        [&]<class Eos>(const Eos&) {
          if constexpr (requires(Eos e) { e.pressure_cutoff; }) f(deck_.eos<Eos>(part));
          return requires(Eos e) { e.pressure_cutoff; };
        },
        eos->eos);
  }

  // Explosives

  /// f(an explosive that is lit where the deck says). False: its products are not those of *EOS_JWL.
  template <class F>
  bool with_explosive(FileNumber part, const ExplosiveMaterial& m, const F& f) {
    const EosCard* const eos = numbered(deck_.equations_of_state, card_of(part)->eos);
    if (!eos || !std::holds_alternative<Jwl>(eos->eos)) return false;
    std::vector<DetonationPoint> points;
    for (const DetonationCard& card : deck_.detonations)
      if (card.part == part || card.part == 0) points.push_back(card.start);
    const double width = 3 * longest_edge(deck_.part(part).hexahedra);
    const std::string of = joined({"Part ", std::to_string(part)});
    if (points.empty()) becomes({of, ": no *INITIAL_DETONATION lights it, so that all of it burns from the time 0"});
    replaced({of, ": the burning front is ", text(width), " wide, three elements, and not one and a half."});
    f(Explosive{deck_.eos<Jwl>(part), DetonationPoints{points}, m.burn(width)}, NoErosion{});
    return true;
  }
  /// The largest cube root of a volume, 1 if there are no cells.
  double longest_edge(const Cells<8>& cells) const {
    double volume = 0;
    for (const auto& cell : cells) volume = std::max(volume, hexahedron_volume(deck_.mesh.nodes, cell));
    return volume > 0 ? std::cbrt(volume) : 1;
  }
  void tell_detonations() {
    const auto explodes = [&](FileNumber part) {
      const MaterialCard* const material = material_of(part);
      return material && std::holds_alternative<ExplosiveMaterial>(material->material);
    };
    const bool any = std::any_of(deck_.parts.begin(), deck_.parts.end(),
                                 [&](const NamedSet& part) { return explodes(part.number); });
    for (const DetonationCard& card : deck_.detonations)
      if (card.part == 0 ? !any : !explodes(card.part))
        cannot(
            {"*INITIAL_DETONATION at ", code_of(card.start.place), " lights nothing: ",
             card.part == 0 ? std::string("no part") : joined({"part ", std::to_string(card.part), ", which is not"}),
             " of *MAT_HIGH_EXPLOSIVE_BURN."});
  }

  template <class Law>
  void add_part(const NamedSet& part, const PartCells& cells, const PartCard& card, const MaterialCard& material,
                const Law& law) {
    if constexpr (std::is_same_v<Law, RigidMaterial>) return;
    if constexpr (std::is_same_v<Law, Elastic> || std::is_same_v<Law, NullMaterial>)
      if (std::any_of(deck_.erosions.begin(), deck_.erosions.end(),
                      [&](const ErosionCard& erosion) { return erosion.material == card.material; }))
        cannot({name_of(part), ": *MAT_ADD_EROSION of a material that does not flow is left out."});
    const bool fits = with_material(part.number, law, [&](const auto& m, const auto& removal) {
      add_solids(part, cells, card, m, removal);
      add_plates(part, cells, card, m, removal);
    });
    if (!fits)
      cannot({name_of(part), ": ", material.keyword, " has no material here, or lacks its equation of state."});
  }

  BulkViscosity viscosity_of(const HourglassCard* control) const {
    return control ? BulkViscosity{control->quadratic, control->linear}
                   : BulkViscosity{deck_.bulk_viscosity[0], deck_.bulk_viscosity[1]};
  }

  template <class M, class Removal>
  void add_solids(const NamedSet& part, const PartCells& cells, const PartCard& card, const M& material,
                  const Removal& removal) {
    const SectionCard* const section = numbered(deck_.sections, card.section);
    const HourglassCard* const control = card.hourglass == 0 && deck_.hourglass_control
                                             ? &*deck_.hourglass_control
                                             : numbered(deck_.hourglass_controls, card.hourglass);
    const BulkViscosity viscosity = viscosity_of(control);
    if (!cells.hexahedra.empty()) {
      const FileNumber form = section ? section->element_form : 1, type = control ? control->type : 1;
      const bool is_fluid = !requires { material.strength; } && !std::is_same_v<M, Elastic>;
      const double coefficient = control ? control->coefficient : 0.1;
      if (is_fluid || (form == 1 && type <= 3)) {
        if (form != 1)
          replaced({name_of(part), ": hexahedra of one point stand for ELFORM ", std::to_string(form), "."});
        place(part, Hex8{ViscousHourglass{coefficient}, HughesWinget{}, viscosity}, material, code_of(material),
              cells.hexahedra, "hexahedra", removal);
      } else {
        const std::string asked =
            form == 1 ? joined({"IHQ ", std::to_string(type)}) : joined({"ELFORM ", std::to_string(form)});
        if (form != 1 || type < 6 || type > 7)
          replaced({name_of(part), ": hexahedra whose hourglass control follows the material stand for ", asked,
                    "; they bend in one layer as it should be."});
        place(part, Hex8{PhysicalHourglass{}, HughesWinget{}, viscosity}, material, code_of(material), cells.hexahedra,
              "hexahedra", removal);
      }
    }
    if (!cells.tetrahedra.empty())
      place(part, Tet4{NodalPressure{}, HughesWinget{}, viscosity}, material, code_of(material), cells.tetrahedra,
            "tetrahedra", removal);
  }

  /// That of all its plates on their own cards, else T1 of its section.
  double thickness_of(const NamedSet& part, const SectionCard& section, const PartCells& cells) {
    const auto own = common_values(deck_, part, cells.quadrilaterals.size() + cells.triangles.size());
    if (!own) cannot({name_of(part), ": the values of shells of their own differ: those of the section count."});
    if ((own && own->offset != 0) || section.reference != 0)
      cannot({name_of(part), ": the nodes lie in the middle of the shells, NLOC and OFFSET are left out."});
    if (own && own->corner_thickness[0] > 0) return own->corner_thickness[0];
    const auto& t = section.corner_thickness;
    if (std::any_of(t.begin(), t.end(), [&](double corner) { return corner != t[0]; }))
      cannot({name_of(part), ": the thickness is that of the first corner, T1."});
    return section.thickness;
  }
  template <class M, class Removal>
  void add_plates(const NamedSet& part, const PartCells& cells, const PartCard& card, const M& material,
                  const Removal& removal) {
    if (cells.quadrilaterals.empty() && cells.triangles.empty()) return;
    const SectionCard* const section = numbered(deck_.sections, card.section);
    const double thickness = section ? thickness_of(part, *section, cells) : 0;
    if (!(thickness > 0)) {
      cannot({name_of(part), " has no thickness: its shells are left out."});
      return;
    }
    if constexpr (LinearSolid<M>::is) {
      if (section->points != 5)
        replaced({name_of(part), ": five points over the thickness by Simpson's rule stand for NIP ",
                  std::to_string(section->points), "."});
      if (std::abs(section->shear_factor - 5.0 / 6) > 1e-3)
        replaced(
            {name_of(part), ": the transverse shear factor 5/6 stands for SHRF ", code_of(section->shear_factor), "."});
      tell_plates(part, card, section->element_form);
      const PlaneStress plane{material};
      const std::string code = joined({"Homogeneous{", code_of(plane), ", ", code_of(thickness), "}"});
      if (!cells.quadrilaterals.empty())
        place(part, Plate4{}, Homogeneous{plane, thickness}, code, cells.quadrilaterals, "quadrilaterals", removal);
      if (!cells.triangles.empty())
        place(part, Plate3{}, Homogeneous{plane, thickness}, code, cells.triangles, "triangles", removal);
    } else {
      cannot({name_of(part), ": no plates here are of its material: they are left out."});
    }
  }

  template <class E, class M, class Cells, class Removal>
  void place(const NamedSet& part, const E& element, const M& material, const std::string& code_of_material,
             const Cells& cells, const char* kind, const Removal& removal) {
    using Made = PartOf<E, M, Removal>;
    if constexpr (std::is_constructible_v<DeckPart, std::in_place_type_t<Made>, Made>) {
      owners_.push_back({part.number});
      made_.parts.push_back({Made{element, material, cells, removal}, variable_of(part), code_of(element),
                             code_of_material, cells_of(part, kind),
                             std::is_same_v<Removal, NoErosion> ? "" : "Erosion{}"});
      becomes({name_of(part), ": ", std::to_string(cells.size()), " ", kind, ", ", code_of(element), ", ",
               code_of_material});
    } else {
      cannot({name_of(part), ": ", kind, " of ", class_name<E>(), " with ", class_name<M>(),
              " are not among the pairs that this program holds: they are left out."});
    }
  }

  // Rigid bodies

  const RigidMaterial* rigid(FileNumber part) const {
    const MaterialCard* const material = material_of(part);
    return material ? std::get_if<RigidMaterial>(&material->material) : nullptr;
  }
  /// The part with which it moves.
  FileNumber lead_of(FileNumber part) const {
    for (std::size_t turns = 0; turns <= deck_.rigid_merges.size(); ++turns)
      for (const RigidMergeCard& merge : deck_.rigid_merges)
        if (merge.constrained == part) part = merge.lead;
    return part;
  }
  /// The rigid body of a part, with the parts that move with it.
  void add_body(const NamedSet& part) {
    const RigidMaterial* const material = rigid(part.number);
    if (!material || lead_of(part.number) != part.number) return;
    std::vector<FileNumber> members;
    std::array<std::vector<FileNumber>, 3> outsides;  // the parts whose solids, quadrilaterals and triangles it shows
    double thickness = 0;
    std::string numbers;
    for (const NamedSet& other : deck_.parts) {
      const RigidMaterial* const its = rigid(other.number);
      if (!its || lead_of(other.number) != part.number) continue;
      const PartCells cells = deck_.part(other.number);
      members.push_back(other.number);
      numbers += joined({numbers.empty() ? "" : ", ", std::to_string(other.number)});
      if (its->density != material->density)
        cannot(
            {name_of(other), ": the density is that of part ", std::to_string(part.number), ", with which it moves."});
      const SectionCard* const section = numbered(deck_.sections, card_of(other.number)->section);
      const bool has_plates = !cells.quadrilaterals.empty() || !cells.triangles.empty();
      if (has_plates && section) thickness = thickness_of(other, *section, cells);
      for (const auto& [has, of] : {std::pair{!cells.hexahedra.empty() || !cells.tetrahedra.empty(), 0},
                                    {!cells.quadrilaterals.empty(), 1},
                                    {!cells.triangles.empty(), 2}})
        if (has) outsides[static_cast<std::size_t>(of)].push_back(other.number);
    }
    for (std::vector<FileNumber>& parts : outsides)
      if (!parts.empty()) owners_.push_back(std::move(parts));
    const Mesh mesh = deck_.cells_of(members);
    const std::optional<std::size_t> own = inertia_of(part, members);
    const std::string of = own ? joined({"deck.inertias[", std::to_string(*own), "]"}) : "";
    std::string code =
        joined({"RigidBody{deck.cells_of({", numbers, "}), ", own ? of + ".whole()" : code_of(material->density)});
    if (!mesh.quadrilaterals.empty() || !mesh.triangles.empty()) code += ", " + code_of(thickness);
    const std::vector<std::size_t> extra = extra_nodes_of(members);
    std::string last = with_nodes(extra);
    if (own) last += joined({".moving(", of, ".velocity, ", of, ".spin)"});
    add_guided(
        part.number, HeldBody{material->directions(), material->axes()}, code,
        [&](const auto&... guides) {
          if (!own) return carrying(RigidBody{mesh, material->density, thickness, guides...}, extra);
          const InertiaCard& card = deck_.inertias[*own];
          return carrying(RigidBody{mesh, card.whole(), thickness, guides...}, extra).moving(card.velocity, card.spin);
        },
        last);
    becomes({name_of(part), ": a rigid body of ", std::to_string(mesh.hexahedra.size() + mesh.tetrahedra.size()),
             " solids and ", std::to_string(mesh.quadrilaterals.size() + mesh.triangles.size()), " plates",
             own ? ", with mass, inertia and velocity of its own card" : "", told_with(extra)});
  }
  /// The card of *PART_INERTIA that counts for a body: that of the part that leads.
  std::optional<std::size_t> inertia_of(const NamedSet& lead, const std::vector<FileNumber>& members) {
    std::optional<std::size_t> own;
    for (std::size_t i = 0; i < deck_.inertias.size(); ++i) {
      const InertiaCard& card = deck_.inertias[i];
      if (card.part == lead.number) {
        if (const std::string fault = fault_of(card.whole(), true); !fault.empty())
          cannot({name_of(lead), ": ", fault, ". Until then mass, inertia and velocity are those of its cells."});
        else
          own = i;
      } else if (std::find(members.begin(), members.end(), card.part) != members.end()) {
        cannot({"*PART_INERTIA of part ", std::to_string(card.part), " is left out, which moves with part ",
                std::to_string(lead.number), ": give that one the inertia of both."});
      }
    }
    if (own && members.size() > 1)
      replaced({name_of(lead), ": its *PART_INERTIA is that of all the parts that move with it."});
    return own;
  }
  /// The places of the cards of extra nodes of parts, or bodies, of these numbers.
  std::vector<std::size_t> extra_nodes_of(const std::vector<FileNumber>& members) {
    std::vector<std::size_t> cards;
    for (std::size_t i = 0; i < deck_.extra_nodes.size(); ++i)
      if (std::find(members.begin(), members.end(), deck_.extra_nodes[i].part) != members.end()) cards.push_back(i);
    return cards;
  }
  template <class Body>
  Body carrying(Body body, const std::vector<std::size_t>& cards) const {
    for (const std::size_t i : cards) body = body.with_nodes(deck_.extra_nodes[i].nodes);
    return body;
  }
  static std::string with_nodes(const std::vector<std::size_t>& cards) {
    std::string code;
    for (const std::size_t i : cards) code += joined({".with_nodes(deck.extra_nodes[", std::to_string(i), "].nodes)"});
    return code;
  }
  std::string told_with(const std::vector<std::size_t>& cards) const {
    std::size_t count = 0;
    for (const std::size_t i : cards) count += deck_.extra_nodes[i].nodes.size();
    return count > 0 ? joined({", and ", std::to_string(count), " extra nodes"}) : "";
  }
  /// The number is that of a rigid part, or of a rigid body of nodes.
  bool has_owner(FileNumber number) const { return rigid(number) || numbered(deck_.rigid_bodies, number); }
  void add_body(std::size_t i) {
    const RigidBodyCard& card = deck_.rigid_bodies[i];
    const std::string of = joined({"deck.rigid_bodies[", std::to_string(i), "]"});
    bool has_own = card.inertia.has_value();
    if (has_own)
      if (const std::string fault = fault_of(card.inertia->whole(), true); !fault.empty()) {
        cannot({"Rigid body ", std::to_string(card.number), ": ", fault,
                ". Until then mass, inertia and velocity are those of its nodes."});
        has_own = false;
      }
    const std::vector<std::size_t> extra = extra_nodes_of({card.number});
    std::string last = with_nodes(extra);
    if (has_own) last += joined({".moving(", of, ".inertia->velocity, ", of, ".inertia->spin)"});
    add_guided(
        card.number, HeldBody{card.held.directions(), card.held.axes()},
        joined({"RigidBody{", of, ".nodes, ", has_own ? of + ".inertia->whole()" : "Inertia{}"}),
        [&](const auto&... guides) {
          if (!has_own) return carrying(RigidBody{card.nodes, Inertia{}, guides...}, extra);
          const InertiaCard& own = *card.inertia;
          return carrying(RigidBody{card.nodes, own.whole(), guides...}, extra).moving(own.velocity, own.spin);
        },
        last);
    becomes({"Rigid body ", std::to_string(card.number), " of ", std::to_string(card.nodes.size()), " nodes",
             has_own ? ", with mass, inertia and velocity of its own card" : "", told_with(extra)});
  }
  /// A body with what holds it and moves it; `make` takes the guides, `last` is the code behind them.
  template <class Make>
  void add_guided(FileNumber number, const HeldBody& held, std::string code, const Make& make,
                  const std::string& last) {
    const bool holds = !held.directions().empty() || !held.axes().empty();
    std::optional<std::size_t> driven;
    for (std::size_t i = 0; i < deck_.motions.size(); ++i)
      if (deck_.motions[i].body == number && number != 0) {
        if (driven || !is_usual(deck_.motions[i]))
          cannot({"Rigid body ", std::to_string(number), ": one of its prescribed motions is left out."});
        else
          driven = i;
      }
    if (holds || driven) code += joined({", HeldBody{", code_of(held.directions()), ", ", code_of(held.axes()), "}"});
    if (!driven) {
      code += "}" + last;
      made_.bodies.push_back(holds ? Stated<DeckBody>{make(held), code} : Stated<DeckBody>{make(), code});
      return;
    }
    const PrescribedMotionCard& motion = deck_.motions[*driven];
    const std::string of = joined({"deck.motions[", std::to_string(*driven), "]"});
    const auto end = [&](const char* name) {
      return joined({code, ", ", name, "{", of, ".direction, ", of, ".history}}", last});
    };
    if (motion.kind == PrescribedMotionCard::Kind::velocity)
      made_.bodies.push_back({make(held, BodyVelocity{motion.direction, motion.history}), end("BodyVelocity")});
    else
      made_.bodies.push_back({make(held, BodyDisplacement{motion.direction, motion.history}), end("BodyDisplacement")});
  }
  /// A velocity or a displacement along a direction, all over the run.
  bool is_usual(const PrescribedMotionCard& motion) const {
    return !motion.turns && !motion.holds_others && motion.kind != PrescribedMotionCard::Kind::acceleration &&
           motion.history.birth <= 0 && motion.history.death >= deck_.end_time;
  }

  // Conditions

  void add_velocity(std::size_t i) {
    const VelocityCard& card = deck_.velocities[i];
    const std::string from = joined({"deck.velocities[", std::to_string(i), "].nodes"});
    const bool spins = card.spin.norm() > 0;
    made_.velocities.push_back(
        {spins ? InitialVelocity{card.velocity, Spin{card.spin, card.centre}, card.nodes}
               : InitialVelocity{card.velocity, card.nodes},
         joined({"InitialVelocity{", code_of(card.velocity), ", ",
                 spins ? joined({"Spin{", code_of(card.spin), ", ", code_of(card.centre), "}, "}) : "", from, "}"})});
    becomes({"Velocity ", code_of(card.velocity), spins ? " with a spin" : "", " of ",
             std::to_string(card.nodes.size()), " nodes"});
  }
  void add_support(std::size_t i) {
    const SupportCard& card = deck_.supports[i];
    made_.supports.push_back({Support{card.nodes, card.directions(), card.axes()},
                              joined({"Support{deck.supports[", std::to_string(i), "].nodes, ",
                                      code_of(card.directions()), ", ", code_of(card.axes()), "}"})});
    becomes({"Support of ", std::to_string(card.nodes.size()), " nodes along ", code_of(card.directions()), ", about ",
             code_of(card.axes())});
  }
  void add_motion(std::size_t i) {
    const PrescribedMotionCard& card = deck_.motions[i];
    if (card.body != 0) return;
    if (!is_usual(card)) {
      cannot({"A prescribed motion of ", std::to_string(card.nodes.size()),
              " nodes is left out: it is an acceleration or a turn, holds other directions, or begins or ends in the "
              "run."});
      return;
    }
    const std::string of = joined({"deck.motions[", std::to_string(i), "]"});
    const bool is_velocity = card.kind == PrescribedMotionCard::Kind::velocity;
    const char* const name = is_velocity ? "PrescribedVelocity" : "PrescribedDisplacement";
    const std::string code = joined({name, "{", of, ".direction, ", of, ".nodes, ", of, ".history}"});
    made_.motions.push_back(
        is_velocity ? Stated<DeckMotion>{PrescribedVelocity{card.direction, card.nodes, card.history}, code}
                    : Stated<DeckMotion>{PrescribedDisplacement{card.direction, card.nodes, card.history}, code});
    becomes({name, " of ", std::to_string(card.nodes.size()), " nodes along ", code_of(card.direction)});
  }
  void add_body_force(std::size_t i) {
    const BodyLoadCard& card = deck_.body_loads[i];
    if (!card.parts.empty()) cannot({"*LOAD_BODY_PARTS: all parts feel the body force."});
    const std::string of = joined({"deck.body_loads[", std::to_string(i), "]"});
    made_.body_forces.push_back(
        {BodyForce{card.direction, card.history}, joined({"BodyForce{", of, ".direction, ", of, ".history}"})});
    becomes({"Body force along ", code_of(card.direction)});
  }
  void add_nodal_force(std::size_t i) {
    const NodalLoadCard& card = deck_.nodal_loads[i];
    if (card.turns) {
      cannot({"A moment on ", std::to_string(card.nodes.size()), " nodes is left out."});
      return;
    }
    const std::string of = joined({"deck.nodal_loads[", std::to_string(i), "]"});
    made_.nodal_forces.push_back({NodalForce{card.direction, card.nodes, card.history},
                                  joined({"NodalForce{", of, ".direction, ", of, ".nodes, ", of, ".history}"})});
    becomes({"Force on ", std::to_string(card.nodes.size()), " nodes along ", code_of(card.direction)});
  }
  void add_pressure(std::size_t i) {
    const PressureLoadCard& card = deck_.pressures[i];
    const std::string of = joined({"deck.pressures[", std::to_string(i), "]"});
    made_.pressures.push_back(
        {Pressure{card.faces(), card.history}, joined({"Pressure{", of, ".faces(), ", of, ".history}"})});
    becomes({"Pressure on ", std::to_string(card.segments.size()), " faces"});
  }
  void add_blast(std::size_t i) {
    const BlastCard& card = deck_.blasts[i];
    const std::string name =
        card.number == 0 ? std::string("*LOAD_BLAST") : joined({"*LOAD_BLAST_ENHANCED ", std::to_string(card.number)});
    if (card.segments.empty()) {
      cannot({name, " has no faces: give it *LOAD_BLAST_SEGMENT."});
      return;
    }
    if (card.kind != BlastCard::Kind::on_ground && card.kind != BlastCard::Kind::in_air) {
      cannot({name, " is left out: its charge moves, or bursts above the ground (BLAST 3, 4)."});
      return;
    }
    const auto& [mass, length, time, pressure] = card.si;
    if (const double own = mass / (length * time * time); std::abs(pressure / own - 1) > 1e-3)
      replaced({name, ": its pressures are in ", code_of(pressure), " Pa, as UNIT says, its other units would give ",
                code_of(own), "."});
    const std::string of = joined({"deck.blasts[", std::to_string(i), "]"});
    made_.blasts.push_back(
        {AirBlast{card.faces(), card.charge()}, joined({"AirBlast{", of, ".faces(), ", of, ".charge()}"})});
    becomes({"Blast of ", code_of(card.mass), " of TNT ",
             card.kind == BlastCard::Kind::in_air ? "in air" : "on the ground", " at ", code_of(card.centre), " on ",
             std::to_string(card.segments.size()), " faces"});
  }
  void add_wall(std::size_t i) {
    const WallCard& card = deck_.walls[i];
    const std::string of = joined({"deck.walls[", std::to_string(i), "]"});
    const bool moves = card.motion || card.mass != 0 || card.speed != 0;
    if (moves && !card.motion && !(card.mass > 0)) {
      cannot({"A rigid wall that moves is left out: it has no mass."});
      return;
    }
    const std::string kind = joined({"Rigid wall ", moves ? "that moves " : ""});
    const std::string told = joined({code_of(card.point), ", normal ", code_of(card.normal), ", friction ",
                                     code_of(card.friction), moves ? way_of(card) : ""});
    const bool ends = card.edges && (card.edges->length > 0 || card.edges->width > 0);
    const bool is_strip = ends && !(card.edges->length > 0 && card.edges->width > 0);
    const double far = is_strip ? distance_to_nodes(card.point) + 10 * extent() : 0;
    const std::vector<Eigen::Vector3d> corners = card.corners(far);
    const std::string code_of_corners = joined({of, ".corners(", is_strip ? code_of(far) : "", ")"});
    const std::string plane = joined({"RigidPlane{", code_of(card.point), ", ", code_of(card.normal), "}"});
    if (ends && moves) {
      const auto first = static_cast<Index>(made_.nodes.size());
      made_.nodes.insert(made_.nodes.end(), corners.begin(), corners.end());
      made_.more_nodes.push_back(
          joined({"for (const Eigen::Vector3d& corner : ", code_of_corners, ") nodes.push_back(corner);"}));
      const std::vector<Index> own{first, first + 1, first + 2, first + 3};
      const std::string numbers = joined({std::to_string(first), ", ", std::to_string(first + 1), ", ",
                                          std::to_string(first + 2), ", ", std::to_string(first + 3)});
      add_mover(card, own, joined({"std::vector<Index>{", numbers, "}"}), 0.5 * (corners[0] + corners[2]),
                (corners[2] - corners[0]).norm());
      if (card.sticks) cannot({"A rigid wall to which nodes stick has friction 0."});
      made_.obstacles.push_back(
          {Contact{NodeToSurface{card.nodes, Surface{{Face{{own[0], own[1], own[2], own[3]}, 0}}}},
                   Coulomb{card.friction}},
           joined({"Contact{NodeToSurface{", of, ".nodes, Surface{{Face{{", numbers, "}, 0}}}}, ",
                   code_of(Coulomb{card.friction}), "}"})});
    } else if (ends) {
      add_obstacle(card.nodes, RigidSurface{corners, {Face{{0, 1, 2, 3}, 0}}}, card, of,
                   joined({"RigidSurface{", code_of_corners, ", {Face{{0, 1, 2, 3}, 0}}}"}));
    } else if (moves) {
      add_carried(card, RigidPlane{card.point, card.normal}, of, plane, card.point, 0.5 * extent());
    } else {
      if (card.sticks) cannot({"A rigid wall to which nodes stick has friction 0."});
      made_.walls.push_back({RigidWall{card.point, card.normal, card.nodes, card.friction},
                             joined({"RigidWall{", code_of(card.point), ", ", code_of(card.normal), ", ", of,
                                     ".nodes, ", code_of(card.friction), "}"})});
    }
    becomes({kind,
             is_strip ? joined({"with two edges, and ", text(far), " long to both sides, from "})
             : ends   ? "with four edges from "
                      : "at ",
             told});
  }
  void add_obstacle(std::size_t i) {
    const ObstacleCard& card = deck_.obstacles[i];
    const std::string of = joined({"deck.obstacles[", std::to_string(i), "]"});
    const auto add = [&](const auto& shape, const char* type, const Eigen::Vector3d& centre) {
      const std::string code = joined({"std::get<", type, ">(", of, ".shape)"});
      if (card.motion)
        add_carried(card, shape, of, code, centre, shape.radius);
      else
        add_obstacle(card.nodes, shape, card, of, code);
    };
    const std::string way = card.motion ? way_of(card) : "";
    if (const auto* const sphere = std::get_if<RigidSphere>(&card.shape)) {
      add(*sphere, "RigidSphere", sphere->centre);
      becomes({"Rigid sphere of radius ", code_of(sphere->radius), " about ", code_of(sphere->centre), way});
    } else if (const auto* const cylinder = std::get_if<RigidCylinder>(&card.shape)) {
      add(*cylinder, "RigidCylinder", cylinder->point);
      becomes({"Rigid cylinder of radius ", code_of(cylinder->radius), " about ", code_of(cylinder->point), " along ",
               code_of(cylinder->axis),
               std::isinf(cylinder->length) ? "" : joined({", of the length ", code_of(cylinder->length)}), way});
    }
  }
  static std::string way_of(const auto& card) {
    if (card.motion) return joined({", driven along ", code_of(card.motion->direction)});
    if constexpr (requires { card.mass; })
      return joined({", of the mass ", code_of(card.mass), ", at the speed ", code_of(card.speed)});
    else
      return {};
  }
  /// The diagonal of the box around all nodes of the deck.
  double extent() const {
    Eigen::Vector3d lower = deck_.mesh.nodes.front(), upper = lower;
    for (const Eigen::Vector3d& x : deck_.mesh.nodes) lower = lower.cwiseMin(x), upper = upper.cwiseMax(x);
    return (upper - lower).norm();
  }
  double distance_to_nodes(const Eigen::Vector3d& point) const {
    double most = 0;
    for (const Eigen::Vector3d& x : deck_.mesh.nodes) most = std::max(most, (x - point).norm());
    return most;
  }
  /// The rigid body that a wall is: it has the mass of the wall and moves along the normal, or is driven.
  template <class Card>
  void add_mover(const Card& card, const std::vector<Index>& nodes, const std::string& code,
                 const Eigen::Vector3d& centre, double size) {
    double mass = 1e-9;  // of a wall that is driven; it counts nowhere
    Eigen::Vector3d way{0, 0, 0}, velocity = way;
    if (card.motion) way = card.motion->direction;
    if constexpr (requires { card.mass; })
      if (!card.motion) {
        mass = card.mass, way = card.normal, velocity += card.speed * card.normal;  // never -0
        if (!deck_.body_loads.empty()) replaced({"*LOAD_BODY acts on the rigid wall that has a mass, too."});
      }
    Eigen::Index least = 0;
    way.cwiseAbs().minCoeff(&least);
    const Eigen::Vector3d aside = way.cross(Eigen::Vector3d::Unit(least)).normalized();
    const HeldBody held{{aside, way.cross(aside)}, {unit(Axis::x), unit(Axis::y), unit(Axis::z)}};
    const double moment = mass * size * size;
    const Inertia own{mass, centre, SymmetricTensor<double>::isotropic(moment)};
    const std::string body = joined({"RigidBody{", code, ", Inertia{", code_of(mass), ", ", code_of(centre),
                                     ", SymmetricTensor<double>::isotropic(", code_of(moment), ")}, HeldBody{",
                                     code_of(held.directions()), ", ", code_of(held.axes()), "}"});
    if (!card.motion) {
      made_.bodies.push_back(
          {RigidBody{nodes, own, held}.moving(velocity), joined({body, "}.moving(", code_of(velocity), ")"})});
      return;
    }
    const std::string motion = joined({std::is_same_v<Card, WallCard> ? "deck.walls[" : "deck.obstacles[",
                                       std::to_string(number_of(card)), "].motion"});
    const auto with = [&](const char* name, const auto& guide) {
      made_.bodies.push_back({RigidBody{nodes, own, held, guide},
                              joined({body, ", ", name, "{", motion, "->direction, ", motion, "->history}}"})});
    };
    if (card.motion->displaces)
      with("BodyDisplacement", BodyDisplacement{card.motion->direction, card.motion->history});
    else
      with("BodyVelocity", BodyVelocity{card.motion->direction, card.motion->history});
  }
  std::size_t number_of(const WallCard& card) const { return static_cast<std::size_t>(&card - deck_.walls.data()); }
  std::size_t number_of(const ObstacleCard& card) const {
    return static_cast<std::size_t>(&card - deck_.obstacles.data());
  }
  /// An obstacle that a rigid body of its own carries.
  template <class Body, class Card>
  void add_carried(const Card& card, const Body& body, const std::string& of, const std::string& code,
                   const Eigen::Vector3d& centre, double size) {
    const std::string name = joined({"frame_", std::to_string(frames_++)});
    const Frame frame = add_frame(made_.nodes, centre, size);
    made_.more_nodes.push_back(
        joined({"const Frame ", name, " = add_frame(nodes, ", code_of(centre), ", ", code_of(size), ");"}));
    add_mover(card, frame.nodes, name + ".nodes", centre, size);
    add_obstacle(card.nodes, Carried{body, frame}, card, of, joined({"Carried{", code, ", ", name, "}"}));
  }
  template <class Body, class Card>
  void add_obstacle(const std::vector<Index>& nodes, const Body& body, const Card& card, const std::string& of,
                    const std::string& code) {
    if (card.sticks) cannot({"A rigid wall to which nodes stick has friction 0."});
    made_.obstacles.push_back(
        {Contact{NodeToRigid{nodes, body}, Coulomb{card.friction}},
         joined({"Contact{NodeToRigid{", of, ".nodes, ", code, "}, ", code_of(Coulomb{card.friction}), "}"})});
  }

  // Ties

  /// Nodes and surfaces of a tie, each with its code, and the greatest thickness of their plates.
  struct TieSide {
    std::vector<Index> nodes = {};
    std::optional<Surface> surface = {};
    std::string code_of_nodes = {}, code_of_surface = {};
    double thickness = 0;

    void add(const Surface& more, const std::string& code) {
      surface = surface ? *surface + more : more;
      code_of_surface += (code_of_surface.empty() ? "" : " + ") + code;
    }
  };
  /// `of` is its code.
  TieSide side_of_tie(const ContactSide& side, const std::string& of) const {
    TieSide made;
    const std::vector<Face> faces = side.faces();
    if (!faces.empty()) {
      made.nodes = surface_nodes(faces), made.code_of_nodes = joined({"surface_nodes(", of, ".faces())"});
      made.add(Surface{faces}, joined({"Surface{", of, ".faces()}"}));
    } else if (!side.nodes.empty()) {
      made.nodes = side.nodes, made.code_of_nodes = of + ".nodes";
    } else if (!side.parts.empty()) {
      made.nodes = surface_nodes(surface(deck_.cells_of(side.parts)));
      made.code_of_nodes = joined({"surface_nodes(surface(deck.cells_of(", of, ".parts)))"});
    }
    std::vector<bool> is_of_side(deck_.mesh.nodes.size());
    for (const Index node : made.nodes) is_of_side[node] = true;
    const auto has_any = [&](const auto& cells) {
      return std::any_of(cells.begin(), cells.end(), [&](const auto& corners) {
        return std::any_of(corners.begin(), corners.end(), [&](Index node) { return is_of_side[node]; });
      });
    };
    for (std::size_t p = 0; p < made_.parts.size(); ++p)
      std::visit(
          [&](const auto& part) {
            const std::string& cells = made_.parts[p].cells;
            const bool is_named =
                std::find(side.parts.begin(), side.parts.end(), owners_[p].front()) != side.parts.end();
            double thickness = 0;
            if constexpr (requires { part.material.thickness(); }) thickness = part.material.thickness();
            if (thickness > made.thickness && (is_named || (side.parts.empty() && has_any(part.cells))))
              made.thickness = thickness;
            if (!is_named) return;
            if constexpr (requires { part.material.thickness(); })
              made.add(plate_surface(part.cells, thickness, p),
                       joined({"plate_surface(", cells, ", ", code_of(thickness), ", ", std::to_string(p), ")"}));
            else
              made.add(solid_surface(part.cells, p), joined({"solid_surface(", cells, ", ", std::to_string(p), ")"}));
          },
          made_.parts[p].item);
    if (side.thickness != 0)
      made.thickness = std::abs(side.thickness);
    else
      made.thickness *= side.thickness_scale;
    return made;
  }
  /// The nodes of the slave within 0.6 of the sum of the thicknesses, or a twentieth of the least diagonal of a face,
  /// of the master are tied, as in LS-DYNA (Keyword User's Manual R13, volume I, *CONTACT_TIED).
  void add_tie(std::size_t i) {
    const ContactCard& card = deck_.contacts[i];
    const std::string of = joined({"deck.contacts[", std::to_string(i), "]"});
    if (card.birth > 0 || card.death < deck_.end_time) cannot({"Contact ", card.kind, " acts all over the run."});
    if (card.kind.find("SHELL_EDGE") != card.kind.npos) cannot({"Contact ", card.kind, " ties no rotations."});
    const auto is_rigid = [&](FileNumber part) { return rigid(part) != nullptr; };
    for (const ContactSide* const side : {&card.slave, &card.master})
      if (std::any_of(side->parts.begin(), side->parts.end(), is_rigid)) {
        cannot({"Contact ", card.kind, " of a rigid part is left out: give its nodes to the part."});
        return;
      }
    const TieSide slave = side_of_tie(card.slave, of + ".slave"), master = side_of_tie(card.master, of + ".master");
    if (slave.nodes.empty() || !master.surface) {
      cannot(
          {"Contact ", card.kind, " is left out: give it the nodes or parts, and the faces or parts, that it ties."});
      return;
    }
    double least = std::numeric_limits<double>::infinity();
    for (const Face& face : master.surface->faces()) {
      const auto x = [&](std::size_t corner) { return deck_.mesh.nodes[face.nodes[corner]]; };
      least = std::min({least, (x(2) - x(0)).norm(), (x(3) - x(1)).norm()});
    }
    double reach = 0.6 * (slave.thickness + master.thickness);
    if (card.slave.thickness >= 0 && card.master.thickness >= 0) reach = std::max(reach, 0.05 * least);
    const std::vector<Index> nodes = nodes_near(deck_.mesh.nodes, slave.nodes, *master.surface, reach);
    if (nodes.empty()) {
      cannot({"Contact ", card.kind, " ties nothing: no node is within ", text(reach), " of its master."});
      return;
    }
    const double tolerance = 1.001 * reach;  // apart from rounding
    made_.ties.push_back(
        {Tied{nodes, *master.surface, tolerance},
         joined({"Tied{nodes_near(deck.mesh.nodes, ", slave.code_of_nodes, ", ", master.code_of_surface, ", ",
                 code_of(reach), "), ", master.code_of_surface, ", ", code_of(tolerance), "}"})});
    becomes({"Contact ", card.kind, ": of ", std::to_string(slave.nodes.size()), " nodes, ",
             std::to_string(nodes.size()), " within ", text(reach), " of the master are tied, at their distance"});
  }

  // Contacts

  /// Pairs of parts of the scene that touch with one coefficient of friction.
  struct Touching {
    double friction;
    std::set<std::array<std::size_t, 2>> pairs;
  };

  /// The places of the parts of a side, rigid bodies behind the others.
  std::vector<std::size_t> places_of(const ContactSide& side) const {
    std::vector<std::size_t> places;
    const auto is_named = [&](FileNumber part) {
      return side.parts.empty() || std::find(side.parts.begin(), side.parts.end(), part) != side.parts.end();
    };
    for (std::size_t i = 0; i < owners_.size(); ++i)
      if (std::any_of(owners_[i].begin(), owners_[i].end(), is_named)) places.push_back(i);
    return places;
  }
  /// FS, or FD where the friction falls with the speed.
  double friction_of(const ContactCard& card) {
    if (card.decay == 0 || card.static_friction == card.dynamic_friction) return card.static_friction;
    replaced({"Contact ", card.kind, ": friction does not fall with the speed, FD is taken."});
    return card.dynamic_friction;
  }
  void add_contacts() {
    std::vector<Touching> all;
    std::set<std::array<std::size_t, 2>> taken;
    for (const ContactCard& card : deck_.contacts) {
      if (card.is_tied()) continue;
      if (card.birth > 0 || card.death < deck_.end_time) cannot({"Contact ", card.kind, " acts all over the run."});
      if (card.slave.thickness != 0 || card.master.thickness != 0 || card.slave.thickness_scale != 1 ||
          card.master.thickness_scale != 1)
        replaced({"Contact ", card.kind, ": plates are as thick as their sections say."});
      if (card.damping != 0 || card.soft != 0 || card.slave.stiffness != 1 || card.master.stiffness != 1)
        replaced({"Contact ", card.kind,
                  ": springs as stiff as the step allows, without damping, stand for SOFT, SOFSCL, DEPTH, SFS, SFM and "
                  "VDC."});
      const auto by_parts = [](const ContactSide& side) { return side.nodes.empty() && side.segments.empty(); };
      if (!by_parts(card.slave) || !by_parts(card.master)) {
        cannot({"Contact ", card.kind, " of nodes or segments is left out: give it parts or sets of parts."});
        continue;
      }
      const bool single = card.kind.find("SINGLE_SURFACE") != card.kind.npos || card.kind == "GENERAL";
      const std::vector<std::size_t> slaves = places_of(card.slave), masters = single ? slaves : places_of(card.master);
      const double friction = friction_of(card);
      auto same = std::find_if(all.begin(), all.end(), [&](const Touching& one) { return one.friction == friction; });
      if (same == all.end()) same = all.insert(all.end(), {friction, {}});
      for (const std::size_t i : slaves)
        for (const std::size_t j : masters) {
          const std::array pair{std::min(i, j), std::max(i, j)};
          if (taken.insert(pair).second) same->pairs.insert(pair);
        }
      becomes({"Contact ", card.kind, ": by springs, friction ", code_of(friction)});
    }
    for (const Touching& one : all) {
      std::vector<std::array<std::size_t, 2>> except;
      std::string code;
      for (std::size_t i = 0; i < owners_.size(); ++i)
        for (std::size_t j = i; j < owners_.size(); ++j)
          if (!one.pairs.contains({i, j})) {
            except.push_back({i, j});
            code += joined({code.empty() ? "{" : ", {", std::to_string(i), ", ", std::to_string(j), "}"});
          }
      if (!code.empty()) code = joined({".except = {", code, "}"});
      made_.contacts.push_back(
          {Contact{Everything{except}, Penalty{}, Coulomb{one.friction}},
           joined({"Contact{Everything{", code, "}, Penalty{}, ", code_of(Coulomb{one.friction}), "}"})});
    }
  }

  const DynaDeck& deck_;
  DeckScene made_;
  std::size_t frames_ = 0;  // of walls that move
  std::vector<std::vector<FileNumber>>
      owners_;  // of each part of the scene, then of each outside of a body: of the deck
};

}  // namespace detail

/// The scene of an LS-DYNA deck.
inline DeckScene deck_scene(const DynaDeck& deck) { return detail::FromDyna(deck).made(); }

}  // namespace strike
