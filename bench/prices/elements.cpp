#include <limits>

#include <strike/element/hex8_full.hpp>

#include "feature.hpp"

namespace prices {

namespace {

/// An element that tells nothing of its works, so that the compiler leaves them out.
template <class E>
struct Silent : E {
  template <class M, class T, class Velocities>
  Response<T, E::nodes> advance(typename E::template State<M, T>& state, const M& material, const Nodal<T, E::nodes>& x,
                                const Velocities& v, double dt) const {
    Response<T, E::nodes> response = E::advance(state, material, x, v, dt);
    response.internal_work = response.hourglass_work = response.bulk_viscosity_work = T(0.0);
    return response;
  }
};

}  // namespace

Group elements() {
  constexpr ViscousHourglass hourglass;
  constexpr BulkViscosity viscosity;
  return {"Element",
          {hexahedra.of_element("no hourglass control", Hex8{NoHourglass{}}),
           hexahedra.of_element("physical hourglass control, as Hex8{} has it", Hex8{PhysicalHourglass{}}),
           hexahedra.of_element("stiffness hourglass control", Hex8{StiffnessHourglass{}}),
           hexahedra.of_element("Jaumann", Hex8{hourglass, Jaumann{}}),
           hexahedra.of_element("end of step", Hex8{hourglass, HughesWinget{}, viscosity, EndStep{}}),
           hexahedra.of_element("Jaumann, end of step", Hex8{hourglass, Jaumann{}, viscosity, EndStep{}}),
           hexahedra.of_element("bulk viscosity both ways", Hex8{hourglass, HughesWinget{}, BulkViscosityBothWays{}}),
           hexahedra.of_element("no bulk viscosity", Hex8{hourglass, HughesWinget{}, NoBulkViscosity{}}),
           hexahedra.of_element("the least: no control, Jaumann, no bulk viscosity, end of step",
                                Hex8{NoHourglass{}, Jaumann{}, NoBulkViscosity{}, EndStep{}}),
           hexahedra.of_element("Hex8Full, eight points", Hex8Full{})}};
}

Group tetrahedron_elements() {
  const ElementPressure own{};
  return {"Tetrahedron",
          {tetrahedra.of_element("its own pressure", Tet4{own}),
           tetrahedra.of_element("its own pressure, Jaumann", Tet4{own, Jaumann{}}),
           tetrahedra.of_element("its own pressure, no bulk viscosity", Tet4{own, HughesWinget{}, NoBulkViscosity{}}),
           tetrahedra.of_material("water", bench::water)}};
}

Group ledger() {
  const ExplicitOptions unbalanced{.energy_tolerance = std::numeric_limits<double>::infinity()};
  return {"Energy ledger, always there", {feature("without the works of the elements", [=] {
            return started(hexahedra.scene(Silent<Hex8<ViscousHourglass>>{Hex8{ViscousHourglass{}}}, copper),
                           unbalanced);
          })}};
}

}  // namespace prices
