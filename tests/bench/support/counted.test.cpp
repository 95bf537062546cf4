#include "bench/support/counted.hpp"

#include <strike/element/hex8.hpp>
#include <strike/scalar/dual.hpp>
#include <strike/tensor/tensor.hpp>

#include "bench/support/materials.hpp"
#include "conformance/element.hpp"

using namespace strike;
using bench::Counted;

namespace {

Counted variable(double value) {
  Counted a;
  a.set(0, value);
  return a;
}

/// What a formula asks for.
template <class Formula>
bench::Operations operations(Formula formula) {
  Counted::done = {};
  [[maybe_unused]] const auto result = formula();
  return Counted::done;
}

/// Of a hexahedron of hardening copper after one step.
template <class T>
Nodal<double, 8> force(const Nodal<double, 8>& x, const Nodal<double, 8>& v) {
  const Hex8 element;
  const Solid copper{bench::gruneisen, bench::hardening};
  Hex8<>::State<Solid<GruneisenEos, VonMises>, T> state;
  const Nodal<T, 8> x_T = x.cast<T>(), v_T = v.cast<T>();
  element.begin(state, copper, x_T);
  const Nodal<T, 8> f = element.advance(state, copper, x_T, v_T, 1e-6).force;
  return f.unaryExpr([](const T& a) { return lane(a, 0); });
}

}  // namespace

TEST_CASE("Counted counts what depends on variables, and no constants") {
  const Counted a = variable(2), b = variable(3), c = 5.0;
  const auto quotient = operations([&]() -> Counted { return (a * b - c) / b; });
  CHECK((quotient.products == 1 && quotient.sums == 1 && quotient.flops() == 2 && quotient.quotients == 1));
  CHECK(operations([&]() -> Counted { return -(1.0 * a); }).flops() == 0);
  const auto of_constants = operations([&]() -> Counted { return sqrt(c * c + 1.0) / max(c, Counted(2.0)); });
  CHECK((of_constants.flops() == 0 && of_constants.quotients == 0 && of_constants.roots == 0));
  const auto others = operations([&]() -> Counted { return select(a < b, sqrt(a), min(rsqrt(b), pow(a, 0.3))); });
  CHECK((others.roots == 2 && others.functions == 1 && others.selections == 2));
}

TEST_CASE("Counted counts in matrices and dual numbers") {
  const Matrix3<Counted> A = Matrix3<Counted>::Constant(variable(2));
  const auto product = operations([&]() -> Matrix3<Counted> { return A * A; });
  CHECK((product.products == 27 && product.sums == 18));
  using D = Dual<Counted, 1>;
  const D x = D::variable(variable(2), 0);
  const auto square = operations([&]() -> D { return 3.0 * (x * x) + 1.0; });
  CHECK((square.products == 1 + 2 && square.sums == 1 + 1));  // x' = 1 multiplies for nothing
}

TEST_CASE("an element of Counted gives what it gives in double") {
  testing::Shapes<8> shapes(7);
  for (int trial = 0; trial < 10; ++trial) {
    const Nodal<double, 8> x = shapes(), v = shapes.nodal(), expected = force<double>(x, v);
    CHECK((force<Counted>(x, v) - expected).norm() <= 1e-12 * expected.norm());
  }
}
