// The laws of Plate4 with sections of fibres.
#include <cmath>
#include <cstddef>

#include <strike/element/plate4.hpp>

#include "conformance/plate.hpp"
#include "support/catch.hpp"
#include "support/plies.hpp"
#include "support/sanitized.hpp"

using namespace strike;
using testing::Quadrilaterals;

namespace {

/// Fibres in units of the suites.
constexpr OrthotropicPly unit_ply{.density = 1, .E1 = 1, .E2 = 0.1, .nu12 = 0.3, .G12 = 0.05, .G13 = 0.05, .G23 = 0.03};
constexpr Hashin unit_strengths{.Xt = 2e-4, .Xc = 2e-4, .Yt = 1e-4, .Yc = 2e-4, .SL = 1e-4, .ST = 1e-4};
const FailingPly failing{unit_ply, unit_strengths};
const Eigen::Vector3d somewhere(0.3, 0.5, 0.4);

template <class M>
auto of_three(const M& ply, double h, double a, double b, double c, double offset = 0) {
  return Layered{LayUp{ply, h, {a, b, c}}, FibreDirection{somewhere}, Offset{offset}};
}

}  // namespace

static_assert(Element<Plate4<>, decltype(of_three(unit_ply, 1, 0, 0, 0))>);

TEST_CASE("plates with fibres: the laws of elements") {
  const Quadrilaterals shapes(1);
  const Plate4 element{};
  const auto unsymmetric = of_three(unit_ply, 0.07, 10, 70, -35, 0.05);
  testing::rigid_motions_give_no_force(element, unsymmetric, shapes, testing::FiniteRotations::exact);
  testing::forces_and_moments_sum_to_zero(element, unsymmetric, shapes);
  testing::books_its_work(element, unsymmetric, shapes);
  testing::lanes_agree<Pack<double, 8>>(element, unsymmetric, shapes);
  testing::lanes_agree<Pack<float, 16>>(element, unsymmetric, shapes);
  testing::failed_elements_are_silent(element, of_three(failing, 0.07, 0, 90, 0), shapes);
}

TEST_CASE("plates with fibres: their direction does not depend on the numbering") {
  const auto crossed = of_three(unit_ply, 0.07, 0, 90, 0);  // from above as from below
  testing::numbering_does_not_matter(Plate4{}, Quadrilaterals(2), crossed);
  testing::numbering_does_not_matter(Plate4{PlateHourglass{}, RigidOffset{}, ThicknessChange{}}, Quadrilaterals(3),
                                     crossed);
}

// 600 plates, plane and warped, of h/sqrt(A) from 1e-3 to 10 and E1/E2 from 1 to 1000.
TEST_CASE("plates with fibres: the step is never beyond the exact one") {
  Quadrilaterals shapes(4);
  double least = 10;
  for (int trial = 0; trial < testing::repeated(600); ++trial) {
    const Nodal<double, 4> x = trial % 2 == 0 ? shapes() : shapes.plane();
    const Plate4Modes<double> m = to_plate_modes<double>(x);
    const double h = std::pow(10, 2 * shapes.unit() - 1) * std::sqrt(Plate4Frame<double>(m.xi, m.eta).area);
    OrthotropicPly ply = unit_ply;
    ply.E2 = std::pow(10, -1.5 * (1 + shapes.unit()));
    ply.nu12 = 0.45 * shapes.unit();
    ply.G12 = ply.E2 * (0.6 + 0.4 * shapes.unit()), ply.G13 = ply.G12, ply.G23 = ply.E2 * (0.5 + 0.3 * shapes.unit());
    const auto angle = [&] { return 90 * shapes.unit(); };
    const double a = angle(), b = angle();
    const auto section =
        of_three(ply, h / 3, a, b, trial % 3 == 0 ? a : angle(), trial % 5 == 0 ? h * shapes.unit() : 0);
    const verify::SingleElement single{Plate4{}, section, x};
    const double exact = 2 / single.vibration().frequencies()(23), ratio = exact / single.now().stable_step;
    least = std::min(least, ratio);
  }
  CHECK(least >= 1 - 1e-9);

  // Of squares it gives as much away as that of isotropic plates.
  const auto given_away = [](const auto& section) {
    const verify::SingleElement single{Plate4{}, section, verify::unit_square()};
    return 2 / single.vibration().frequencies()(23) / single.now().stable_step;
  };
  CHECK(given_away(of_three(unit_ply, 0.01, 0, 90, 0)) < 1.02 * given_away(testing::elastic_plate));
}
