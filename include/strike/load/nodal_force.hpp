#pragma once
#include <utility>
#include <vector>

#include <strike/load/curve.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/range.hpp>

namespace strike {

/// A force on each of some nodes, times a history; its direction is fixed in space. Error: no such node.
template <class History = Constant>
class NodalForce {
 public:
  using LoadHistory = History;

  NodalForce(Eigen::Vector3d force, std::vector<Index> nodes, History history = {})
      : force_(std::move(force)), nodes_(std::move(nodes)), history_(std::move(history)) {}

  void ranges(const auto& number) const {
    number("force", force_, range::point);
    number(history_);
  }

  template <class N>
  void begin(const N& nodes) const {
    for (const Index i : nodes_) nodes.check_number(i);
  }
  const std::vector<Index>& nodes_named() const { return nodes_; }

  template <class N>
  void apply_loads(N& nodes, double time) {
    now_ = history_(time) * force_;
    for (const Index i : nodes_) nodes.add_force(i, now_.cast<typename N::Number>());
  }
  template <class N>
  double power(const N& nodes) const {
    double sum = 0;
    for (const Index i : nodes_) sum += now_.dot(nodes.v(i).template cast<double>());
    return sum;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.same(nodes_);
    archive(now_);
  }

 private:
  Eigen::Vector3d force_, now_ = Eigen::Vector3d::Zero();
  std::vector<Index> nodes_;
  History history_;
};

}  // namespace strike
