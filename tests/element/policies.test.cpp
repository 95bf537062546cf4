#include <strike/element.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

/// A bulk viscosity that forgets the stable step.
struct WithoutCoefficient {
  template <class T>
  struct State {};
  template <class T>
  T pressure(const T&, const T&, const T&) const {
    return T(0.0);
  }
  template <class T>
  T work(State<T>&, const T&, const T&) const {
    return T(0.0);
  }
};
/// An instant that carries tensors and no vectors.
struct WithoutVectors : EndStep {
  template <class T>
  auto to_end(const Vector3<T>&) const {
    return [](const SymmetricTensor<T>& tensor) { return tensor; };
  }
};
/// A thickness that never advances.
struct Still {
  template <class T>
  struct State {};
  template <class T>
  T relative(const State<T>&) const {
    return T(1.0);
  }
};
/// A treatment of a warp without its transpose.
struct OneWay {
  static constexpr bool drills = false, projects_shear = false;
  template <class T>
  void rates(const Plate4Frame<T>&, const T&, const Plate4Drilling<T>&, Plate4Modes<T>&, const Plate4Modes<T>&) const {}
};
/// A stiffness against the drilling that remembers nothing.
struct Forgetful {
  template <class T>
  struct State {};
  template <class T>
  T stiffness(const T& in_plane_shear, const T& area) const {
    return in_plane_shear * area;
  }
};

}  // namespace

static_assert(ShockViscosity<BulkViscosity> && ShockViscosity<BulkViscosityBothWays> &&
              ShockViscosity<NoBulkViscosity>);
static_assert(!ShockViscosity<EndStep> && !ShockViscosity<HughesWinget> && !ShockViscosity<WithoutCoefficient> &&
              !ShockViscosity<int>);
static_assert(MeasuringInstant<MidStep> && MeasuringInstant<EndStep>);
static_assert(!MeasuringInstant<BulkViscosity> && !MeasuringInstant<Jaumann> && !MeasuringInstant<WithoutVectors> &&
              !MeasuringInstant<int>);
static_assert(TetrahedralPressure<NodalPressure> && TetrahedralPressure<ElementPressure>);
static_assert(!TetrahedralPressure<BulkViscosity> && !TetrahedralPressure<double>);
static_assert(PlateHourglassControl<PlateHourglass> && PlateHourglassControl<NoPlateHourglass> &&
              PlateHourglassControl<PhysicalHourglass>);
static_assert(!PlateHourglassControl<StiffnessHourglass> && !PlateHourglassControl<DrillingStiffness> &&
              !PlateHourglassControl<NoHourglass>);
static_assert(PlateWarping<BelytschkoWongChiang> && PlateWarping<NoWarping> && PlateWarping<RigidOffset>);
static_assert(!PlateWarping<OneWay> && !PlateWarping<ThicknessChange> && !PlateWarping<int>);
static_assert(PlateThickness<ConstantThickness> && PlateThickness<ThicknessChange>);
static_assert(!PlateThickness<Still> && !PlateThickness<FreeDrilling> && !PlateThickness<NoWarping>);
static_assert(PlateDrilling<DrillingStiffness> && PlateDrilling<FreeDrilling>);
static_assert(!PlateDrilling<Forgetful> && !PlateDrilling<ThicknessChange> && !PlateDrilling<PlateHourglass>);

// Policies in each other's places.
static_assert(Hex8<>::sound && Hex8<NoHourglass, Jaumann, NoBulkViscosity, EndStep>::sound);
static_assert(Hex8Full<>::sound && Hex8Full<Jaumann, NoBulkViscosity, EndStep>::sound);
static_assert(Tet4<>::sound && Tet4<ElementPressure, Jaumann, NoBulkViscosity, EndStep>::sound);
static_assert(Plate4<>::sound && Plate4<NoPlateHourglass, RigidOffset, ThicknessChange, FreeDrilling>::sound);

TEST_CASE("the thickness of a plate stays in a step without time") {
  ThicknessChange::State<double> state{.relative = 0.75};
  ThicknessChange{}.advance(state, 3.0, 0.0);
  CHECK(ThicknessChange{}.relative(state) == 0.75);
}
