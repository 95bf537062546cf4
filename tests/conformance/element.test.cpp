#include "conformance/element.hpp"

#include <strike/element/solid_point.hpp>
#include <strike/element/stable_step.hpp>
#include <strike/verify/workbench.hpp>

#include "output/scratch.hpp"

using namespace strike;
using namespace strike::verify;
using testing::conforms;
using testing::FiniteRotations;

namespace {

/// An element of a user's own, as short as they come: the tetrahedron with four nodes.
struct Tetrahedron {
  using Kinematics = SolidKinematics;
  static constexpr int nodes = 4;

  template <class M, class T>
  struct State {
    T initial_volume;
    typename M::template State<T> material{};

    template <class F>
    void each_point(F f) const {
      f(material);
    }
  };

  template <class M, class T>
  T begin(State<M, T>& state, const M& material, const Nodal<T, 4>& x) const {
    state.initial_volume = Gradient<T>(x).volume;
    return 0.25 * density_of(material) * state.initial_volume;
  }

  template <class M, class T>
  Response<T, 4> advance(State<M, T>& state, const M& material, const Nodal<T, 4>& x, const Nodal<T, 4>& v,
                         double dt) const {
    const Gradient<T> g(x);
    const Nodal<T, 4> b = (1.0 / g.volume) * g.B;
    const Matrix3<T> L = MidStep{}(Matrix3<T>(v.lazyProduct(b.transpose())), dt);
    const Vector3<T> spin = T(dt) * axial_vector(L);
    turn_tensors(HughesWinget{}.turn(spin), state.material);
    const SolidKinematics::Rate<T> rate{MidStep{}.to_end(spin)(symmetric_part(L)), g.volume / state.initial_volume};
    const T dV = volume_increment<T>(g.volume, dt * trace(rate.rate_of_deformation));
    const auto [sigma, work] = advance_point(material, state.material, rate, dt, g.volume, dV);

    const Matrix3<T> bb = b.lazyProduct(b.transpose());
    const SymmetricTensor<T> S = T(0.5) * symmetric_part(bb);  // nodal masses of rho V/4, not rho V/8
    const Stability<T> stability{trace(S), largest_eigenvalue(S), rate.relative_volume / density_of(material)};
    Response<T, 4> response{sigma.matrix().lazyProduct(g.B), g.volume, T(0.0), work, T(0.0), T(0.0)};
    response.critical_rate =
        stability.vibration(material, material.moduli(state.material, rate), T(0.0)).critical_rate();
    if constexpr (requires { material.intact(state.material); })
      zero_if_failed(material.intact(state.material) > 0.0, response);
    return response;
  }

 private:
  template <class T>
  struct Gradient {
    Nodal<T, 4> B;  ///< dV/dx
    T volume;

    explicit Gradient(const Nodal<T, 4>& x) {
      const Vector3<T> a = x.col(1) - x.col(0), b = x.col(2) - x.col(0), c = x.col(3) - x.col(0);
      B.col(1) = cross(b, c), B.col(2) = cross(c, a), B.col(3) = cross(a, b);
      B *= T(1.0 / 6.0);
      B.col(0) = -(B.col(1) + B.col(2) + B.col(3));
      volume = a.dot(B.col(1));
    }
  };
};

}  // namespace

TEST_CASE("conformance: an element of a test's own") {
  conforms(Tetrahedron{}, FiniteRotations::exact, unit_tetrahedron());
}

TEST_CASE("the workbench passes an element of a test's own") {
  const ScratchFolder folder("own-element");
  Workbench bench{folder / "out"};
  bench.element("Tetrahedron", Tetrahedron{}, Elastic{1, 1, 0.3});
  CHECK(bench.finish() == 0);
}

static_assert(Element<Tetrahedron>);
static_assert(!Element<int> && !Element<Elastic> && !Element<HughesWinget>);
