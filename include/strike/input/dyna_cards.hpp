#pragma once
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <strike/input/deck.hpp>
#include <strike/input/dyna_contact_cards.hpp>
#include <strike/input/dyna_control_cards.hpp>
#include <strike/input/dyna_load_cards.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/eos/gruneisen.hpp>
#include <strike/material/eos/jwl.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/eos/polynomial.hpp>
#include <strike/material/eos/tabulated.hpp>
#include <strike/material/explosive.hpp>
#include <strike/material/failing_ply.hpp>
#include <strike/material/failure/failure.hpp>
#include <strike/material/failure/johnson_cook_failure.hpp>
#include <strike/material/failure/principal_stress.hpp>
#include <strike/material/failure/tuler_butcher.hpp>
#include <strike/material/orthotropic_ply.hpp>
#include <strike/material/strength/johnson_cook.hpp>
#include <strike/material/strength/kinematic_hardening.hpp>
#include <strike/material/strength/mooney_rivlin.hpp>
#include <strike/material/strength/power_hardening.hpp>
#include <strike/material/strength/prony.hpp>
#include <strike/material/strength/rate_von_mises.hpp>
#include <strike/material/strength/tabulated_hardening.hpp>
#include <strike/material/strength/tabulated_rates.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/material/strength/zerilli_armstrong.hpp>
#include <strike/mesh/inertia.hpp>
#include <strike/tensor/tensor.hpp>

// The cards of an LS-DYNA deck as values (LS-DYNA Keyword User's Manual R13, volumes I and II). Numbers are in the
// units of the deck.
namespace strike {

namespace detail {
/// The axes, x, y and z in the columns of a system, that are chosen.
inline std::vector<Eigen::Vector3d> columns_of(const Eigen::Matrix3d& system, const std::array<bool, 3>& chosen) {
  std::vector<Eigen::Vector3d> all;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (chosen[static_cast<std::size_t>(axis)]) all.push_back(system.col(axis));
  return all;
}
}  // namespace detail

/// *MAT_PLASTIC_KINEMATIC with BETA 1 or a rate, *MAT_PIECEWISE_LINEAR_PLASTICITY without curves, and
/// *MAT_ISOTROPIC_ELASTIC_PLASTIC: `Solid{m.eos, m.strength}`.
struct PlasticMaterial {
  LinearEos eos;
  RateVonMises strength;  ///< H = E ETAN/(E - ETAN); Cowper and Symonds' D and p as D^(-1/p) and 1/p
  std::optional<FailureStrain> failure = {};
};

/// Cowper and Symonds' D, the rate that doubles the flow stress [1/time], and their exponent p.
struct RateConstants {
  double D, p;
};

/// *MAT_PIECEWISE_LINEAR_PLASTICITY with a curve or with EPS and ES, *ELASTIC and *PLASTIC of Abaqus with a table:
/// `Solid{m.eos, m.strength}`, or with a rate `Solid{m.eos, CowperSymonds{m.strength, m.rate->D, m.rate->p}}`.
struct TabulatedMaterial {
  LinearEos eos;
  TabulatedHardening strength;
  std::optional<RateConstants> rate = {};
  std::optional<FailureStrain> failure = {};
};

/// *MAT_PIECEWISE_LINEAR_PLASTICITY with a table of curves, or with LCSR: `Solid{m.eos, m.strength}`.
struct TabulatedRatesMaterial {
  LinearEos eos;
  TabulatedRates strength;
  std::optional<FailureStrain> failure = {};
};

/// *MAT_ELASTIC_PLASTIC_HYDRO with a table: `Solid{deck.eos<PolynomialEos>(part), m.strength}`.
struct TabulatedHydroMaterial {
  double density;
  TabulatedHardening strength;
  std::optional<FailureStrain> failure = {};
};

/// *MAT_ELASTIC_PLASTIC_HYDRO without a table: `Solid{deck.eos<PolynomialEos>(part), m.strength}`.
struct HydroMaterial {
  double density;
  VonMises strength;
  std::optional<FailureStrain> failure = {};
};

/// *MAT_JOHNSON_COOK: `Solid{deck.eos<GruneisenEos>(part), m.strength}`, or with damage
/// `Solid{deck.eos<GruneisenEos>(part), m.strength, m.fracture()}`.
struct JohnsonCookMaterial {
  double density;
  JohnsonCook strength;          ///< heated by all of its plastic work, 1/(RO CP)
  std::array<double, 5> damage;  ///< D1 to D5 of the strain at fracture
  double least_fracture = 1e-6;  ///< EFMIN, lower bound of that strain

  /// D1 or D2 is given.
  bool fractures() const { return damage[0] != 0 || damage[1] != 0; }
  /// With the reference rate and the temperatures of the strength.
  JohnsonCookFailure fracture() const {
    const auto& [D1, D2, D3, D4, D5] = damage;
    return {D1,
            D2,
            D3,
            D4,
            strength.reference_rate,
            D5,
            strength.initial_temperature,
            strength.melting_temperature,
            least_fracture};
  }
};

/// *MAT_NULL: `Fluid{deck.eos<PolynomialEos>(part), Newtonian{m.viscosity}}`.
struct NullMaterial {
  double density;
  double viscosity;  ///< MU, dynamic [stress time]
};

/// *MAT_PLASTIC_KINEMATIC with BETA below 1 and no rate: `Solid{m.eos, m.strength}`.
struct KinematicMaterial {
  LinearEos eos;
  KinematicHardening strength;  ///< BETA is the isotropic share
  std::optional<FailureStrain> failure = {};
};

/// *MAT_POWER_LAW_PLASTICITY: `Solid{m.eos, m.strength}`, or with a rate
/// `Solid{m.eos, CowperSymonds{m.strength, m.rate->D, m.rate->p}}`.
struct PowerMaterial {
  LinearEos eos;
  PowerHardening strength;
  std::optional<RateConstants> rate = {};
  std::optional<FailureStrain> failure = {};
};

/// *MAT_SIMPLIFIED_JOHNSON_COOK: `Solid{m.eos, m.strength}`.
struct SimplifiedJohnsonCookMaterial {
  LinearEos eos;
  JohnsonCook strength;  ///< not heated
  std::optional<FailureStrain> failure = {};
};

/// *MAT_MODIFIED_ZERILLI_ARMSTRONG: `Solid{deck.eos<GruneisenEos>(part), m.strength}`.
struct ZerilliArmstrongMaterial {
  double density;
  ZerilliArmstrong strength;  ///< heated by all of its plastic work, 1/(RO G1)
  std::optional<FailureStrain> failure = {};
};

/// *MAT_MOONEY-RIVLIN_RUBBER: `Solid{m.eos, m.strength}`, with the bulk modulus 2 G (1 + PR)/(3 (1 - 2 PR)).
struct RubberMaterial {
  LinearEos eos;
  MooneyRivlin strength;
};

/// *MAT_VISCOELASTIC: `Solid{m.eos, m.strength}`.
struct ViscoelasticMaterial {
  LinearEos eos;
  Prony<1> strength;
};

/// *MAT_GENERAL_VISCOELASTIC: `Solid{m.eos, m.strength<3>()}`, for up to three terms.
struct PronyMaterial {
  LinearEos eos;
  double shear_modulus;               ///< the sum of all GI [stress]
  std::vector<Prony<1>::Term> terms;  ///< GI over their sum, and 1/BETAI; without those whose BETAI is 0

  /// Error: there are more than n terms.
  template <std::size_t n>
  Prony<n> strength() const {
    if (terms.size() > n)
      throw Error(detail::joined({"strike: the material has ", std::to_string(terms.size()),
                                  " terms of relaxation: read it by strength<", std::to_string(terms.size()), ">()."}));
    Prony<n> law{.shear_modulus = shear_modulus, .terms = {}};
    for (std::size_t k = 0; k < n; ++k)
      law.terms[k] =
          k < terms.size() ? typename Prony<n>::Term{terms[k].share, terms[k].time} : typename Prony<n>::Term{0, 1};
    return law;
  }
};

/// *MAT_RIGID: `RigidBody{Mesh{deck.mesh.nodes, cells}, m.density, HeldBody{m.directions(), m.axes()}}`.
struct RigidMaterial {
  double density;
  double youngs_modulus, poissons_ratio;                 ///< of its contact
  std::array<bool, 3> held{}, held_turns{};              ///< along and about x, y, z, by CMO, CON1 and CON2
  Eigen::Matrix3d system = Eigen::Matrix3d::Identity();  ///< x, y and z in its columns, of CON1 where CMO is -1

  std::vector<Eigen::Vector3d> directions() const { return detail::columns_of(system, held); }
  std::vector<Eigen::Vector3d> axes() const { return detail::columns_of(system, held_turns); }
};

/// *MAT_HIGH_EXPLOSIVE_BURN: `Explosive{deck.eos<Jwl>(part), deck.detonations.at(0).start, m.burn(width)}`.
struct ExplosiveMaterial {
  double density;
  double detonation_velocity;  ///< D [length/time]
  double pressure_CJ;          ///< PCJ [stress], 0 if it does not burn by compression (BETA 2)

  /// The burning front is 3 to 6 elements wide [length].
  Burn burn(double front_width) const { return {detonation_velocity, front_width, pressure_CJ}; }
};

/// *MAT_COMPOSITE_DAMAGE and *MAT_ENHANCED_COMPOSITE_DAMAGE of plates: `FailingPly{m.ply, m.criterion}`.
struct PlyMaterial {
  OrthotropicPly ply;
  ChangChang criterion;                        ///< a strength that is 0 on the card is 1e18, none
  std::optional<Eigen::Vector3d> fibres = {};  ///< A of AOPT 2
};

/// A *MAT_... card.
struct MaterialCard {
  FileNumber number;
  std::string keyword;
  std::string title;
  std::variant<Elastic, PlasticMaterial, HydroMaterial, JohnsonCookMaterial, NullMaterial, TabulatedMaterial,
               TabulatedRatesMaterial, TabulatedHydroMaterial, KinematicMaterial, PowerMaterial,
               SimplifiedJohnsonCookMaterial, ZerilliArmstrongMaterial, RubberMaterial, ViscoelasticMaterial,
               PronyMaterial, RigidMaterial, ExplosiveMaterial, PlyMaterial>
      material;
  std::optional<double> pressure_cutoff = {};  ///< PC, where it is not 0
};

/// An *EOS_... card; its density and cut-off stand with the material.
struct EosCard {
  FileNumber number;
  std::string keyword;
  std::variant<PolynomialEos, GruneisenEos, Jwl, TabulatedEos> eos;
};

/// *MAT_ADD_EROSION of a material: limits of an `Erosion{.strain = e.strain, .volume = e.volume}`, and failure laws, of
/// which a Solid takes one.
struct ErosionCard {
  FileNumber material;
  double strain = std::numeric_limits<double>::infinity();  ///< EFFEPS
  double volume = 0;                                        ///< V/V0 at VOLEPS below 0, exp(VOLEPS)
  std::optional<UltimateStress> equivalent_stress = {};     ///< SIGVM
  std::optional<PrincipalStress> principal_stress = {};     ///< SIGP1
  std::optional<TulerButcher> impulse = {};                 ///< SIGTH and IMPULSE
};

/// *INITIAL_DETONATION: the start of a detonation in a part, in all explosives if that is 0.
struct DetonationCard {
  FileNumber part;
  DetonationPoint start;
};

/// *SECTION_SOLID, and *SECTION_SHELL with its thickness.
struct SectionCard {
  FileNumber number;
  FileNumber element_form;                 ///< ELFORM
  double thickness = 0;                    ///< T1 [length]
  FileNumber points = 2;                   ///< NIP, over the thickness
  double shear_factor = 1;                 ///< SHRF
  double reference = 0;                    ///< NLOC: 1 if the nodes lie in the top, -1 in the bottom
  std::array<double, 4> corner_thickness;  ///< T1 to T4 [length]
};

/// *HOURGLASS.
struct HourglassCard {
  FileNumber number;
  FileNumber type;                        ///< IHQ
  double coefficient = 0.1;               ///< QM
  double linear = 0.06, quadratic = 1.5;  ///< Q2 and Q1 of the bulk viscosity
  double bending = 0.1, warping = 0.1;    ///< QB and QW of plates
};

/// The card of *PART_CONTACT.
struct PartContact {
  double static_friction, dynamic_friction, decay;  ///< FS, FD, DC
  double thickness;                                 ///< OPTT, 0 for that of the section [length]
};

/// *PART: the numbers of its other cards, 0 if it has none.
struct PartCard {
  FileNumber number;
  std::string name;
  FileNumber section, material, eos, hourglass;
  std::optional<PartContact> contact = {};
};

/// The cards of *PART_INERTIA, in global axes: `RigidBody{cells, i.whole()}.moving(i.velocity, i.spin)`.
struct InertiaCard {
  FileNumber part;
  Eigen::Vector3d centre;
  double mass;              ///< TM
  Eigen::Matrix3d inertia;  ///< about the centre [mass length^2]
  Eigen::Vector3d velocity;
  Eigen::Vector3d spin;  ///< [1/time]

  /// LS-DYNA takes it in place of the masses that cells, and other elements at the nodes, give the body.
  TotalInertia whole() const {
    const Eigen::Matrix3d& J = inertia;
    return TotalInertia{{mass, centre, {J(0, 0), J(1, 1), J(2, 2), J(0, 1), J(1, 2), J(2, 0)}}};
  }
  /// Its tensor has been given in these axes.
  void turn(const Eigen::Matrix3d& axes) { inertia = (axes * inertia * axes.transpose()).eval(); }
};

/// *PART_COMPOSITE: layers from the bottom to the top, and what a section says of other plates.
struct CompositeCard {
  struct Layer {
    FileNumber material;
    double thickness, angle;  ///< [length], [degree]
  };
  FileNumber part;
  FileNumber element_form;  ///< ELFORM
  double shear_factor;      ///< SHRF
  double reference;         ///< NLOC
  std::vector<Layer> layers;
};

/// The values of *ELEMENT_SHELL_THICKNESS, _BETA and _OFFSET for one plate; 0 where the file has none.
struct ShellCard {
  Index cell;                                ///< its number in the mesh, among all cells
  std::array<double, 4> corner_thickness{};  ///< THIC1 to THIC4 [length]
  double angle = 0;                          ///< BETA [degree]
  double offset = 0;                         ///< of its middle from the nodes along the normal [length]
};

/// *DEFINE_CURVE, with its scales and offsets in the points: SFA (a + OFFA), SFO (o + OFFO).
struct CurveCard {
  FileNumber number;
  std::string title;
  std::vector<std::array<double, 2>> points;
  FileNumber phase = 0;  ///< SIDR: 0 in the run, 1 before it, 2 both
};

/// *DEFINE_TABLE: a curve for each value.
struct TableCard {
  FileNumber number;
  std::string title;
  std::vector<double> values;
  std::vector<FileNumber> curves;
};

/// *DEFINE_COORDINATE_SYSTEM, _NODES and _VECTOR.
struct CoordinateCard {
  FileNumber number;
  std::string title;
  Eigen::Vector3d origin;
  Eigen::Matrix3d axes;  ///< x, y and z in its columns
};

/// *BOUNDARY_SPC_..., and TC and RC of *NODE: `Support{s.nodes, s.directions(), s.axes()}`.
struct SupportCard {
  std::vector<Index> nodes;
  std::array<bool, 3> held, held_turns;                  ///< along and about x, y, z
  Eigen::Matrix3d system = Eigen::Matrix3d::Identity();  ///< x, y and z of CID in its columns

  std::vector<Eigen::Vector3d> directions() const { return detail::columns_of(system, held); }
  std::vector<Eigen::Vector3d> axes() const { return detail::columns_of(system, held_turns); }
};

/// *INITIAL_VELOCITY_...: `InitialVelocity{v.velocity, Spin{v.spin, v.centre}, v.nodes}`; `v.at(x)` is the velocity of
/// a node.
struct VelocityCard {
  std::vector<Index> nodes;
  Eigen::Vector3d velocity;
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();    ///< [1/time]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< a point of its axis

  Eigen::Vector3d at(const Eigen::Vector3d& x) const { return velocity + cross<double>(spin, x - centre); }
};

/// *CONSTRAINED_NODAL_RIGID_BODY, with _SPC and _INERTIA: `RigidBody{b.nodes, {}, HeldBody{b.held.directions(),
/// b.held.axes()}}`, or with `b.inertia->whole()`; without elements at its nodes it needs an inertia.
struct RigidBodyCard {
  FileNumber number;  ///< PID
  std::vector<Index> nodes;
  std::optional<InertiaCard> inertia = {};  ///< of the body as a whole, with the masses that its nodes have
  SupportCard held = {};                    ///< CON1 and CON2, without nodes
};

/// *CONSTRAINED_RIGID_BODIES: a rigid body that moves with another, by the numbers of their parts.
struct RigidMergeCard {
  FileNumber lead, constrained;
};

/// *CONSTRAINED_EXTRA_NODES_NODE and _SET: nodes that move with a part that is rigid.
struct ExtraNodesCard {
  FileNumber part;
  std::vector<Index> nodes;
};

/// *SET_SEGMENT: faces by their corners; a triangle repeats its last one.
struct SegmentSet {
  FileNumber number;
  std::string name;
  std::vector<std::array<Index, 4>> segments;
};

/// An LS-DYNA deck: its mesh and its cards. The cards of a part are found by its name or number.
struct DynaDeck : Deck {
  std::vector<PartCard> part_cards = {};
  std::vector<MaterialCard> materials = {};
  std::vector<EosCard> equations_of_state = {};
  std::vector<ErosionCard> erosions = {};
  std::vector<DetonationCard> detonations = {};
  std::vector<SectionCard> sections = {};
  std::vector<HourglassCard> hourglass_controls = {};
  std::vector<SupportCard> supports = {};
  std::vector<VelocityCard> velocities = {};
  std::vector<BodyLoadCard> body_loads = {};
  std::vector<NodalLoadCard> nodal_loads = {};
  std::vector<PressureLoadCard> pressures = {};
  std::vector<BlastCard> blasts = {};
  std::vector<PrescribedMotionCard> motions = {};
  std::vector<WallCard> walls = {};
  std::vector<ObstacleCard> obstacles = {};
  std::vector<ContactCard> contacts = {};
  std::vector<NamedSet> part_sets = {};  ///< members are places in `parts`
  std::vector<SegmentSet> segment_sets = {};
  std::vector<InertiaCard> inertias = {};
  std::vector<RigidBodyCard> rigid_bodies = {};
  std::vector<RigidMergeCard> rigid_merges = {};
  std::vector<ExtraNodesCard> extra_nodes = {};
  std::vector<CompositeCard> composites = {};
  std::vector<ShellCard> shells = {};  ///< of plates that have values of their own, in ascending order
  std::vector<CurveCard> curves = {};
  std::vector<TableCard> tables = {};
  std::vector<CoordinateCard> coordinate_systems = {};
  double end_time = 0;                                  ///< ENDTIM, 0 if there is none [time]
  double step_factor = 0;                               ///< TSSFAC, 0 if there is none
  double mass_scaled_step = 0;                          ///< DT2MS, 0 if there is none [time]
  std::array<double, 2> bulk_viscosity{1.5, 0.06};      ///< Q1 and Q2 of *CONTROL_BULK_VISCOSITY, quadratic and linear
  std::optional<HourglassCard> hourglass_control = {};  ///< *CONTROL_HOURGLASS, of parts without one, its number 0
  ShellControl shell_control = {};
  double contact_stiffness = 0.1;                             ///< SLSFAC of *CONTROL_CONTACT
  std::vector<OutputCard> outputs = {};                       ///< of those with an interval
  std::vector<Index> history_nodes = {}, history_cells = {};  ///< *DATABASE_HISTORY, in ascending order

  /// The material of a part, by the type of its card. Error: the part has none, or one of another type.
  template <class M, class Part>
  const M& material(const Part& part) const {
    const MaterialCard& card = material_card(part);
    if (const M* found = std::get_if<M>(&card.material)) return *found;
    throw Error(detail::joined({"strike: the material ", std::to_string(card.number), " of part ", text_of(part),
                                " is ", card.keyword, ": read it as ", type_in(card.material), "."}));
  }
  /// The equation of state of a part, with the density and the cut-off of its material.
  template <class E, class Part>
  E eos(const Part& part) const {
    const MaterialCard& material = material_card(part);
    const EosCard& card = card_of(equations_of_state, card_of_part(part).eos, "equation of state", text_of(part));
    const E* const found = std::get_if<E>(&card.eos);
    if (!found)
      throw Error(detail::joined({"strike: the equation of state ", std::to_string(card.number), " of part ",
                                  text_of(part), " is ", card.keyword, ": read it as ", type_in(card.eos), "."}));
    E eos = *found;
    eos.density = std::visit(
        [](const auto& m) -> double {
          if constexpr (requires { m.density; })
            return m.density;
          else if constexpr (requires { m.eos; })
            return m.eos.density;
          else
            return m.ply.density;
        },
        material.material);
    if constexpr (requires { eos.pressure_cutoff; })
      if (material.pressure_cutoff) eos.pressure_cutoff = *material.pressure_cutoff;
    return eos;
  }
  /// The interval of an output, such as "D3PLOT"; 0 if the deck has none [time].
  double interval(std::string_view output) const {
    for (const OutputCard& card : outputs)
      if (card.name == output) return card.interval;
    return 0;
  }
  /// A curve or a table by its number. Error: it is not in the deck.
  const CurveCard& curve(FileNumber number) const { return numbered(curves, number, "curve"); }
  const TableCard& table(FileNumber number) const { return numbered(tables, number, "table"); }
  /// The section, and the hourglass control, of a part. Error: it has none.
  template <class Part>
  const SectionCard& section(const Part& part) const {
    return card_of(sections, card_of_part(part).section, "section", text_of(part));
  }
  template <class Part>
  const HourglassCard& hourglass(const Part& part) const {
    if (hourglass_control && card_of_part(part).hourglass == 0) return *hourglass_control;
    return card_of(hourglass_controls, card_of_part(part).hourglass, "hourglass control", text_of(part));
  }

 private:
  template <class Entry>
  static const Entry& numbered(const std::vector<Entry>& entries, FileNumber number, const char* kind) {
    for (const Entry& entry : entries)
      if (entry.number == number) return entry;
    throw Error(detail::joined({"strike: no ", kind, " has the number ", std::to_string(number),
                                ": read the warnings of the deck, or correct it."}));
  }
  template <class Variant>
  static std::string type_in(const Variant& variant) {
    return std::visit([]<class Type>(const Type&) { return detail::class_name<Type>(); }, variant);
  }
  static std::string text_of(std::string_view name) { return detail::joined({"'", name, "'"}); }
  static std::string text_of(FileNumber number) { return std::to_string(number); }

  const PartCard& card_of_part(std::string_view name) const {
    if (const NamedSet* const part = find(parts, name)) return card_of_part(part->number);
    throw Error(detail::joined({"strike: no *PART is called '", name, "': ", choice_of(parts)}));
  }
  const PartCard& card_of_part(FileNumber number) const {
    for (const PartCard& card : part_cards)
      if (card.number == number) return card;
    throw Error(detail::joined({"strike: no *PART has the number ", std::to_string(number), ": ", choice_of(parts)}));
  }
  template <class Part>
  const MaterialCard& material_card(const Part& part) const {
    return card_of(materials, card_of_part(part).material, "material", text_of(part));
  }
  template <class Entry>
  static const Entry& card_of(const std::vector<Entry>& entries, FileNumber number, const char* kind,
                              const std::string& part) {
    for (const Entry& entry : entries)
      if (entry.number == number) return entry;
    throw Error(detail::joined({"strike: part ", part, " names the ", kind, " ", std::to_string(number),
                                ", which is not in the deck or was skipped: read its warnings."}));
  }
};

}  // namespace strike
