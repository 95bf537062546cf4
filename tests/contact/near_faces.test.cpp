#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <vector>

#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/near_faces.hpp>
#include <strike/contact/target.hpp>
#include <strike/contact/touched_faces.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/nodes.hpp>

#include "support/catch.hpp"

namespace {

using namespace strike;

constexpr double dt = 1;

/// Nodes that swing above a sheet of faces, of edge 1, that waves, one half of it more widely. Impulses, which no
/// velocity tells, move all of them a little.
class Swing {
 public:
  Swing() {
    const Mesh sheet = rectangle({.size = {12, 12}, .cells = {12, 12}});
    faces_.assign(sheet.quadrilaterals.begin(), sheet.quadrilaterals.end());
    std::mt19937 random(7);
    std::uniform_real_distribution<double> along(0, 12), above(0.1, 1.5);
    middle_ = sheet.nodes;
    for (int i = 0; i < 300; ++i) {
      nodes_.push_back(static_cast<Index>(middle_.size()));
      middle_.emplace_back(along(random), along(random), above(random));
    }
    std::vector<Index> numbers(middle_.size());
    std::iota(numbers.begin(), numbers.end(), Index{0});
    Nodes<double> nodes(middle_, numbers);
    for (const Index i : numbers) nodes.add_mass(i, 1);
    all.begin(nodes, numbers, {}, {});
    faces = {Target(faces_, numbers.size()), std::vector<double>(numbers.size(), 0.0)};
    faces.size = std::sqrt(2);
    move(), all.x_before = all.x;
    near.sort(all, nodes_, faces, 0.5 * faces.size, never);
  }

  /// The next step; calls look(s, f) for the faces that a node looks at.
  template <class Look>
  void step(const Look& look) {
    move();
    near.update(all, nodes_, faces, dt, never, Serial{});
    for (Index s = 0; s < nodes_.size(); ++s)
      near.each_awake(s, false, [&](Index f) {
        look(s, f);
        return distance(s, f);
      });
  }
  double distance(Index s, Index f) const {
    return std::sqrt(faces.target.closest(f, faces.target.corners(f, all.x), all.x[nodes_[s]]).distance2);
  }
  /// True if the node may come as far as the face in this step.
  bool may_meet(Index s, Index f) const {
    double way = 0;
    for (const Index k : faces_[f]) way = std::max(way, dt * (all.v[nodes_[s]] - all.v[k]).norm());
    return distance(s, f) <= way;
  }
  std::size_t nodes() const { return nodes_.size(); }
  std::size_t count_of_faces() const { return faces_.size(); }

  ContactNodes all;
  detail::TouchedFaces faces;
  detail::NearFaces<false> near;

 private:
  using Target = detail::Target;
  static constexpr auto never = [](Index, Index) { return false; };

  void move() {
    for (Index i = 0; i < all.x.size(); ++i) {
      const double phase = 0.7 * middle_[i].x() + 1.3 * middle_[i].y(), wide = middle_[i].x() > 6 ? 3 : 1;
      const auto at = [&](double n) {
        return Eigen::Vector3d(wide * 0.2 * std::sin(0.02 * n + 3 * phase), 0, wide * 0.4 * std::sin(0.03 * n + phase));
      };
      all.x_before[i] = all.x[i];
      all.x[i] = middle_[i] + at(n_);
      all.v[i] = (at(n_ + 1) - at(n_)) * 0.9 / dt;  // a tenth of the way is by impulses
    }
    n_ += 1;
  }

  double n_ = 0;
  std::vector<Eigen::Vector3d> middle_;
  std::vector<std::array<Index, 4>> faces_;
  std::vector<Index> nodes_;
};

}  // namespace

TEST_CASE("no face rests that a node may meet in the step to come") {
  Swing swing;
  std::size_t meetings = 0;
  for (int n = 0; n < 300; ++n) {
    std::vector<std::vector<Index>> looked(swing.nodes());
    swing.step([&](Index s, Index f) { looked[s].push_back(f); });
    for (Index s = 0; s < swing.nodes(); ++s)
      for (const Index f : swing.near.of(s))
        if (swing.may_meet(s, f)) {
          ++meetings;
          CHECK(std::binary_search(looked[s].begin(), looked[s].end(), f));
        }
    if (n % 50 == 0)  // those that are not near do not meet at all
      for (Index s = 0; s < swing.nodes(); ++s)
        for (Index f = 0; f < swing.count_of_faces(); ++f)
          if (swing.may_meet(s, f)) CHECK(std::binary_search(swing.near.of(s).begin(), swing.near.of(s).end(), f));
  }
  CHECK(meetings > 1000);
}
