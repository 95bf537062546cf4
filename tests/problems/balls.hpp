#pragma once
// Point masses that fly freely but for a contact: what it does, without elements.
#include <cmath>
#include <numeric>
#include <vector>

#include <strike/mesh/mesh.hpp>
#include <strike/motion/ledger.hpp>
#include <strike/motion/nodes.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::testing {

template <class Contact>
class Balls {
 public:
  Balls(const std::vector<Eigen::Vector3d>& x, const std::vector<Eigen::Vector3d>& v, const std::vector<double>& mass,
        Contact contact_of_them)
      : contact(std::move(contact_of_them)), nodes(x, in_order(x.size())) {
    for (std::size_t i = 0; i < x.size(); ++i) nodes.add_mass(i, mass[i]), nodes.set_velocity(i, v[i]);
    contact.begin(nodes);
    begin_energy = energy();
  }

  /// One step; `force` acts on every node.
  void step(double dt, const Eigen::Vector3d& force = Eigen::Vector3d::Zero()) {
    const Step now{++number, time, dt, dt};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      nodes.set_velocity(i, nodes.v(i) + dt / nodes.mass(i) * force);
      nodes.add_force(i, force - nodes.f(i));
    }
    contact.resolve_contact(nodes, now, ledger);
    ledger.settle();
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes.set_position(i, nodes.x(i) + dt * nodes.v(i));
    time += dt;
  }

  double energy() const {
    double sum = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) sum += 0.5 * nodes.mass(i) * nodes.v(i).squaredNorm();
    return sum;
  }
  Eigen::Vector3d momentum() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < nodes.size(); ++i) sum += nodes.mass(i) * nodes.v(i);
    return sum;
  }
  Eigen::Vector3d angular_momentum() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < nodes.size(); ++i) sum += nodes.mass(i) * cross<double>(nodes.x(i), nodes.v(i));
    return sum;
  }

  Contact contact;
  Nodes<double> nodes;
  Ledger ledger;
  double time = 0, begin_energy;
  std::size_t number = 0;

 private:
  static std::vector<Index> in_order(std::size_t n) {
    std::vector<Index> order(n);
    std::iota(order.begin(), order.end(), Index{0});
    return order;
  }
};

}  // namespace strike::testing
