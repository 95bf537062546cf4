#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include <strike/contact/carried.hpp>
#include <strike/contact/contact.hpp>
#include <strike/contact/friction.hpp>
#include <strike/contact/law.hpp>
#include <strike/contact/pairing.hpp>
#include <strike/contact/rigid.hpp>
#include <strike/contact/rigid_wall.hpp>
#include <strike/contact/tied.hpp>
#include <strike/dynamics/any_part.hpp>
#include <strike/dynamics/erosion.hpp>
#include <strike/dynamics/explicit_options.hpp>
#include <strike/dynamics/part.hpp>
#include <strike/dynamics/scene.hpp>
#include <strike/element/bulk_viscosity.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/plate3.hpp>
#include <strike/element/plate4.hpp>
#include <strike/element/tet4.hpp>
#include <strike/input/dyna_load_cards.hpp>
#include <strike/load/air_blast.hpp>
#include <strike/load/body_force.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/nodal_force.hpp>
#include <strike/load/prescribed_motion.hpp>
#include <strike/load/pressure.hpp>
#include <strike/load/rigid_body.hpp>
#include <strike/load/support.hpp>
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
#include <strike/material/fluid.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/cowper_symonds.hpp>
#include <strike/material/strength/johnson_cook.hpp>
#include <strike/material/strength/mooney_rivlin.hpp>
#include <strike/material/strength/power_hardening.hpp>
#include <strike/material/strength/prony.hpp>
#include <strike/material/strength/rate_von_mises.hpp>
#include <strike/material/strength/tabulated_hardening.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/material/strength/zerilli_armstrong.hpp>
#include <strike/section/layered.hpp>

namespace strike {

// The pairs of element and material that decks are run with.

using DeckHexahedron = Hex8<ViscousHourglass>;
using DeckMetal = Solid<LinearEos, RateVonMises>;
using DeckFailingMetal = Solid<LinearEos, RateVonMises, FailureStrain>;
using DeckCurve = Solid<LinearEos, TabulatedHardening>;
using DeckFailingCurve = Solid<LinearEos, TabulatedHardening, FailureStrain>;
using DeckPower = Solid<LinearEos, PowerHardening>;
using DeckFailingPower = Solid<LinearEos, PowerHardening, FailureStrain>;
using DeckRatePower = Solid<LinearEos, CowperSymonds<PowerHardening>>;
using DeckFailingRatePower = Solid<LinearEos, CowperSymonds<PowerHardening>, FailureStrain>;
using DeckColdJohnsonCook = Solid<LinearEos, JohnsonCook>;
using DeckFailingColdJohnsonCook = Solid<LinearEos, JohnsonCook, FailureStrain>;
inline constexpr std::size_t deck_terms = 6;  ///< of relaxation, at most
using DeckRelaxing = Solid<LinearEos, Prony<deck_terms>>;
template <class M>
using DeckSection = Homogeneous<PlaneStress<M>>;
using DeckPly = FailingPly<ChangChang>;
using DeckLaminate = Layered<PlyStack<DeckPly>, Offset, FibreDirection>;

/// A part of a deck.
using DeckPart = AnyPart<
    PartOf<DeckHexahedron, Elastic>, PartOf<DeckHexahedron, DeckMetal>,
    PartOf<DeckHexahedron, DeckFailingMetal, Erosion>, PartOf<DeckHexahedron, DeckCurve>,
    PartOf<DeckHexahedron, Solid<GruneisenEos, JohnsonCook>>, PartOf<DeckHexahedron, Solid<PolynomialEos, VonMises>>,
    PartOf<DeckHexahedron, Fluid<PolynomialEos, Newtonian>>, PartOf<DeckHexahedron, Fluid<GruneisenEos, Newtonian>>,  //
    PartOf<Hex8<>, Elastic>, PartOf<Hex8<>, DeckMetal>, PartOf<Hex8<>, DeckFailingMetal, Erosion>,
    PartOf<Tet4<>, Elastic>, PartOf<Tet4<>, DeckMetal>, PartOf<Tet4<>, DeckFailingMetal, Erosion>,
    PartOf<Plate4<>, DeckSection<Elastic>>, PartOf<Plate4<>, DeckSection<DeckMetal>>,
    PartOf<Plate4<>, DeckSection<DeckFailingMetal>, Erosion>, PartOf<Plate4<>, DeckSection<DeckCurve>>,
    PartOf<Plate4<>, DeckSection<DeckFailingCurve>, Erosion>, PartOf<Plate3<>, DeckSection<Elastic>>,
    PartOf<Plate3<>, DeckSection<DeckMetal>>, PartOf<Plate3<>, DeckSection<DeckCurve>>,
    PartOf<Plate4<>, DeckLaminate, Erosion>,
    PartOf<DeckHexahedron, Solid<GruneisenEos, JohnsonCook, JohnsonCookFailure>, Erosion>,
    PartOf<DeckHexahedron, Explosive<Jwl, DetonationPoints>>, PartOf<DeckHexahedron, Solid<TabulatedEos, VonMises>>,
    PartOf<DeckHexahedron, Fluid<TabulatedEos, Newtonian>>,  //
    PartOf<DeckHexahedron, DeckPower>, PartOf<DeckHexahedron, DeckFailingPower, Erosion>,
    PartOf<DeckHexahedron, DeckRatePower>, PartOf<DeckHexahedron, DeckFailingRatePower, Erosion>,
    PartOf<DeckHexahedron, DeckColdJohnsonCook>, PartOf<DeckHexahedron, DeckFailingColdJohnsonCook, Erosion>,
    PartOf<DeckHexahedron, DeckRelaxing>, PartOf<DeckHexahedron, Solid<LinearEos, MooneyRivlin>>,
    PartOf<DeckHexahedron, Solid<GruneisenEos, ZerilliArmstrong>>,
    PartOf<DeckHexahedron, Solid<GruneisenEos, ZerilliArmstrong, FailureStrain>, Erosion>,  //
    PartOf<Plate4<>, DeckSection<DeckPower>>, PartOf<Plate4<>, DeckSection<DeckFailingPower>, Erosion>,
    PartOf<Plate4<>, DeckSection<DeckRatePower>>, PartOf<Plate4<>, DeckSection<DeckFailingRatePower>, Erosion>,
    PartOf<Plate4<>, DeckSection<DeckColdJohnsonCook>>,
    PartOf<Plate4<>, DeckSection<DeckFailingColdJohnsonCook>, Erosion>, PartOf<Plate3<>, DeckSection<DeckPower>>,
    PartOf<Plate3<>, DeckSection<DeckColdJohnsonCook>>>;

using DeckBody = std::variant<RigidBody<>, RigidBody<HeldBody>, RigidBody<HeldBody, BodyVelocity<CardHistory>>,
                              RigidBody<HeldBody, BodyDisplacement<CardHistory>>>;
using DeckMotion = std::variant<PrescribedVelocity<CardHistory>, PrescribedDisplacement<CardHistory>>;
using DeckContact = Contact<Everything, Penalty, Coulomb>;
template <class Body>
using DeckContactWith = decltype(Contact{NodeToRigid{std::vector<Index>{}, std::declval<Body>()}, Coulomb{}});
/// A rigid wall that is round, ends or moves.
using DeckObstacle =
    std::variant<DeckContactWith<RigidSphere>, DeckContactWith<RigidCylinder>, DeckContactWith<RigidSurface>,
                 DeckContactWith<Carried<RigidPlane>>, DeckContactWith<Carried<RigidSphere>>,
                 DeckContactWith<Carried<RigidCylinder>>, Contact<NodeToSurface, Kinematic, Coulomb>>;

/// An item of a deck's scene with the C++ that makes it.
template <class Item>
struct Stated {
  Item item;
  std::string code;
};

/// A part of a deck's scene, with the pieces of that C++.
struct StatedPart {
  DeckPart item;
  std::string name, element, material, cells, removal;  ///< of its material, and the code of its pieces
};

/// A material that several parts, or plies, share, by its name in the program.
struct StatedMaterial {
  std::string name, code;
};

/// The scene that a deck describes, in the deck's units: items in lists, each with the code that makes it from the
/// deck, and sentences for its user.
struct DeckScene {
  std::string title;
  std::vector<Eigen::Vector3d> nodes;        ///< those of the deck, and behind them those of walls that move
  std::vector<std::string> more_nodes = {};  ///< lines of C++ that append these to `nodes`
  std::vector<StatedMaterial> materials = {};
  std::vector<StatedPart> parts = {};
  std::vector<Stated<DeckBody>> bodies = {};
  std::vector<Stated<InitialVelocity>> velocities = {};
  std::vector<Stated<Support>> supports = {};
  std::vector<Stated<DeckMotion>> motions = {};
  std::vector<Stated<BodyForce<CardHistory>>> body_forces = {};
  std::vector<Stated<NodalForce<CardHistory>>> nodal_forces = {};
  std::vector<Stated<Pressure<CardHistory>>> pressures = {};
  std::vector<Stated<AirBlast>> blasts = {};
  std::vector<Stated<RigidWall>> walls = {};
  std::vector<Stated<DeckObstacle>> obstacles = {};
  std::vector<Stated<Tied>> ties = {};
  std::vector<Stated<DeckContact>> contacts = {};
  ExplicitOptions options = {};
  double end = 0;                             ///< [time]
  double interval = 0;                        ///< between two states of the film [time]
  std::vector<Index> watched = {};            ///< nodes whose displacements are recorded
  std::vector<FileNumber> node_numbers = {};  ///< of each node, that in the deck

  std::vector<std::string> becomes = {};   ///< a line for each item: what of the deck, and what it is here
  std::vector<std::string> replaced = {};  ///< another law or element stands for what the deck asks for
  std::vector<std::string> cannot = {};    ///< what is left out; the answer would be another one

  /// Parts, rigid bodies, initial velocities, supports, motions, loads, walls, ties and contacts, in the order of the
  /// deck.
  auto scene() const {
    return Scene{nodes,          items(parts),       items(bodies),       items(velocities), items(supports),
                 items(motions), items(body_forces), items(nodal_forces), items(pressures),  items(blasts),
                 items(walls),   items(obstacles),   items(ties),         items(contacts)};
  }

 private:
  template <class Stated, class Item = decltype(Stated::item)>
  static std::vector<Item> items(const std::vector<Stated>& all) {
    std::vector<Item> items;
    for (const Stated& one : all) items.push_back(one.item);
    return items;
  }
};

}  // namespace strike
