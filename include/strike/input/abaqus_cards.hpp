#pragma once
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <strike/input/deck.hpp>
#include <strike/input/dyna_cards.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/eos/gruneisen.hpp>
#include <strike/material/eos/jwl.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/strength/tabulated_hardening.hpp>

// The cards of an Abaqus input file as values (Abaqus Keywords Reference Guide). Numbers are in the units of the deck.
namespace strike {

/// *MATERIAL, with what *ELASTIC or *EOS says of its volume.
struct NamedMaterial {
  std::string name;
  std::variant<Elastic, PlasticMaterial, TabulatedMaterial, HydroMaterial, JohnsonCookMaterial, NullMaterial> material;
  std::variant<LinearEos, GruneisenEos, Jwl> eos;
  double detonation_speed = 0;  ///< of *EOS, TYPE=JWL
};

/// *SOLID SECTION and *SHELL SECTION of a set of elements; form and number are 0.
struct SetSection {
  std::string set, material;
  SectionCard section;
};

/// *BOUNDARY with a value: `PrescribedVelocity{m.nodes, m.direction, ...}`, or a displacement.
struct MotionCard {
  enum class Kind { displacement, velocity, acceleration };
  std::vector<Index> nodes;
  Eigen::Vector3d direction;
  bool turns;  ///< about the direction, not along it
  Kind kind;
  double value;
  std::string amplitude;  ///< of the curve that multiplies it; empty for none
};

/// *DLOAD P and *DSLOAD: `Pressure{faces, value times curve}`, on faces that look out of what is pushed.
struct PressureCard {
  std::vector<std::array<Index, 4>> segments;
  double value;
  std::string amplitude;
};
/// *DLOAD GRAV on all or on some cells: `BodyForce{...}`.
struct GravityCard {
  std::string set;  ///< of cells; empty for all
  Eigen::Vector3d acceleration;
  std::string amplitude;
};
/// *CLOAD: `NodalForce{f.nodes, f.force, ...}` on each node.
struct ForceCard {
  std::vector<Index> nodes;
  Eigen::Vector3d force;
  std::string amplitude;
};

/// *SURFACE of faces of elements or of nodes.
struct SurfaceCard {
  std::string name;
  ContactSide side;
};

/// An Abaqus deck: its mesh and its cards, of the model and of the first step. Names are compared as Abaqus does.
struct AbaqusDeck : Deck {
  std::vector<NamedMaterial> materials = {};
  std::vector<SetSection> sections = {};
  std::vector<SupportCard> supports = {};
  std::vector<MotionCard> motions = {};
  std::vector<VelocityCard> velocities = {};
  std::vector<PressureCard> pressures = {};
  std::vector<GravityCard> gravities = {};
  std::vector<ForceCard> forces = {};
  std::vector<SurfaceCard> surfaces = {};
  std::vector<ContactCard> contacts = {};           ///< kind PAIR or INCLUSIONS
  std::vector<CurveCard> curves = {};               ///< *AMPLITUDE; the title is its name
  double end_time = 0;                              ///< period of the first step, 0 if there is none [time]
  std::array<double, 2> bulk_viscosity{1.2, 0.06};  ///< b2 and b1 of *BULK VISCOSITY, quadratic and linear

  /// The section of a part or a set of cells, which it covers. Error: none does.
  const SetSection& section(std::string_view part) const {
    const NamedSet* cells = find(parts, part);
    if (!cells) cells = find(cell_sets, part);
    if (!cells) throw Error(detail::joined({"strike: no part is called '", part, "': ", choice_of(parts)}));
    for (const SetSection& section : sections)
      if (const NamedSet* const covered = find(cell_sets, section.set);
          covered &&
          std::includes(covered->members.begin(), covered->members.end(), cells->members.begin(), cells->members.end()))
        return section;
    throw Error(detail::joined(
        {"strike: no section covers the part '", part, "': name the set of a *SOLID SECTION or *SHELL SECTION."}));
  }
  /// The material of a part, by the type of its card. Error: the part has none, or one of another type.
  template <class M>
  const M& material(std::string_view part) const {
    const NamedMaterial& card = named_material(part);
    if (const M* found = std::get_if<M>(&card.material)) return *found;
    throw Error(detail::joined({"strike: the material '", card.name, "' of part '", part,
                                "' is of another type: see the keywords of its *MATERIAL."}));
  }
  /// The equation of state of a part's material; a LinearEos for *ELASTIC.
  template <class E>
  const E& eos(std::string_view part) const {
    const NamedMaterial& card = named_material(part);
    if (const E* found = std::get_if<E>(&card.eos)) return *found;
    throw Error(detail::joined({"strike: the material '", card.name, "' of part '", part,
                                "' has an equation of state of another type: see its *EOS or *ELASTIC."}));
  }
  /// The material of a part with all it has.
  const NamedMaterial& named_material(std::string_view part) const {
    const SetSection& owner = section(part);
    for (const NamedMaterial& card : materials)
      if (same_name(card.name, owner.material)) return card;
    throw Error(detail::joined({"strike: part '", part, "' names the material '", owner.material,
                                "', which is not in the deck or was not read: read its warnings."}));
  }
  /// An *AMPLITUDE and a *SURFACE by name. Error: it is not in the deck.
  const CurveCard& curve(std::string_view name) const { return named(curves, name, &CurveCard::title, "amplitude"); }
  const SurfaceCard& surface(std::string_view name) const {
    return named(surfaces, name, &SurfaceCard::name, "surface");
  }

 private:
  /// As Abaqus compares names: without regard to capitals and blanks.
  static bool same_name(std::string_view a, std::string_view b) {
    std::string x = detail::upper(a), y = detail::upper(b);
    std::erase(x, ' '), std::erase(y, ' ');
    return x == y;
  }
  template <class Card>
  static const Card& named(const std::vector<Card>& cards, std::string_view name, std::string Card::*of,
                           const char* kind) {
    for (const Card& card : cards)
      if (same_name(card.*of, name)) return card;
    throw Error(detail::joined(
        {"strike: no ", kind, " is called '", name, "': read the warnings of the deck, or correct it."}));
  }
};

}  // namespace strike
