#include <strike/element/hex8_points.hpp>

#include "conformance/element.hpp"
#include "element/nodal_hex8.hpp"

using namespace strike;
using namespace strike::verify;

namespace {

/// dN_I/d(xi, eta, zeta) of N_I = (1 + xi_I xi)(1 + eta_I eta)(1 + zeta_I zeta)/8, a row per corner.
Eigen::Matrix<double, 8, 3> shape_derivatives(const Hex8Point& p) {
  const Nodal<double, 8> corner = (2 * unit_cube().array() - 1).matrix();
  const Eigen::Vector3d at(p.xi, p.eta, p.zeta);
  Eigen::Matrix<double, 8, 3> d;
  for (int I = 0; I < 8; ++I)
    for (int j = 0; j < 3; ++j) {
      const int k = (j + 1) % 3, l = (j + 2) % 3;
      d(I, j) = corner(j, I) * (1 + corner(k, I) * at(k)) * (1 + corner(l, I) * at(l)) / 8;
    }
  return d;
}

}  // namespace

TEST_CASE("the derivatives at a point are those of the trilinear shape functions, its forces their transpose") {
  testing::Shapes<8> shapes(4);
  for (std::size_t i = 0; i < 8; ++i) {
    const Hex8Point point(i);
    CHECK(3 * point.xi * point.xi == Approx(1).epsilon(1e-15));
    const Nodal<double, 8> x = shapes();
    const Eigen::Matrix3d A = x * shape_derivatives(point);
    CHECK((point.derivatives(to_modes<double>(x)) - A).norm() <= 1e-14 * x.norm());

    const Hex8Map<double> map(A);
    CHECK(map.volume == Approx(A.determinant()).epsilon(1e-13));
    const Eigen::Matrix3d L = shapes.matrix();
    CHECK((map.gradient(L * A, 1 / map.volume) - L).norm() <= 1e-13 * A.norm() / map.volume);

    const Eigen::Matrix3d t = shapes.matrix();
    const Vector3<double> none = Vector3<double>::Zero();
    Hex8Modes<double> F{none, none, none, none, none, none, none};
    point.add_forces(Matrix3<double>(t), F);
    CHECK((to_nodes(F) - t * shape_derivatives(point).transpose()).norm() <= 1e-15 * 10);
  }
}

TEST_CASE("the points add up to the volume and the mean gradient of the element") {
  testing::Shapes<8> shapes(5);
  for (int trial = 0; trial < 50; ++trial) {
    const Nodal<double, 8> x = shapes();
    Nodal<double, 8> B = Nodal<double, 8>::Zero();
    double V = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      const Hex8Point point(i);
      const Hex8Map<double> map(point.derivatives(to_modes<double>(x)));
      V += map.volume;
      B += map.cofactors * shape_derivatives(point).transpose();
    }
    CHECK(V == Approx(nodal_hex8::volume(x)).epsilon(1e-13));
    CHECK((B - nodal_hex8::gradient(x)).norm() <= 1e-13 * B.norm());
  }
}

TEST_CASE("the largest eigenvalue of the Laplacian is bounded, sharply") {
  const auto ratio = [](const Nodal<double, 8>& x) {
    Hex8Laplacian<double> laplacian;
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(8, 8);
    for (std::size_t i = 0; i < 8; ++i) {
      const Hex8Point point(i);
      const Hex8Map<double> map(point.derivatives(to_modes<double>(x)));
      laplacian.add(point, map, 1 / map.volume);
      const Eigen::Matrix<double, 3, 8> gradient = map.cofactors * shape_derivatives(point).transpose() / map.volume;
      H += map.volume * gradient.transpose() * gradient;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(H, Eigen::EigenvaluesOnly);
    return laplacian.largest_eigenvalue() / modes.eigenvalues()(7);
  };
  CHECK(ratio(unit_cube()) == Approx(1).epsilon(2e-3));  // what largest_eigenvalue may give too much
  for (const double thin : {0.3, 1e-2, 1e-4}) {
    Nodal<double, 8> plate = unit_cube(), needle = unit_cube();
    plate.row(1) *= thin;
    needle.bottomRows(2) *= thin;
    CHECK(ratio(plate) == Approx(1).epsilon(2e-3));
    CHECK(ratio(needle) == Approx(1).epsilon(2e-3));
  }
  testing::Shapes<8> shapes(6);
  for (int trial = 0; trial < 300; ++trial) {
    const double r = ratio(shapes());
    CHECK(r >= 1 - 1e-12);
    CHECK(r <= 1.2);
  }
}
