#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <strike/dynamics/advance.hpp>
#include <strike/dynamics/elements.hpp>
#include <strike/dynamics/mirror_images.hpp>
#include <strike/dynamics/neighbours.hpp>
#include <strike/dynamics/patches.hpp>
#include <strike/element/particle.hpp>
#include <strike/error.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/motion/execution.hpp>
#include <strike/scalar/scalar.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// The particles of a part as they see each other: place by place, and behind them their mirror images. In each step
/// they are gathered, sum over their neighbours, advance, answer, and sum over the answers. Each works for itself, in
/// the ascending order of its neighbours, so that the sums depend neither on threads nor on when lists were made.
template <class T, std::size_t width = lanes<T>>
class Cloud {
  using Real = LaneOf<T>;

 public:
  Cloud() = default;
  template <class All>
  Cloud(const All& elements, const std::vector<double>& volumes) : count_(elements.size) {
    check_volumes(elements, volumes);
    if constexpr (requires { elements.removal.strain; } && !All::measures_strain)
      if (std::isfinite(elements.removal.strain))
        throw Error(joined({"strike: the particles of part ", std::to_string(elements.number),
                            " have no plastic strain by which Erosion{.strain = ", text(elements.removal.strain),
                            "} could delete them; limit them by .volume or .step."}));
    spacing_ = std::cbrt(*std::max_element(volumes.begin(), volumes.end()));
    kernel_ = {elements.element.smoothing.length * spacing_};
    images_ = MirrorImages(elements.element.mirrors);
    images_.check_gaps(kernel_.reach() + skin(), elements.number);
    at_.resize(count_);
  }
  double spacing() const { return spacing_; }

  /// Advances all particles over the step dt and adds their forces to the nodes.
  template <class All, class Nodes, class Execution>
  void compute_forces(All& elements, const Patches& patches, Nodes& nodes, std::vector<Outcome>& outcomes, double dt,
                      const Execution& execution) {
    gather(elements, nodes, execution);
    execution.for_each(patches.size(), [&](std::size_t p) {
      patches.load(patches[p], nodes);
      outcomes[p] = advance(elements, patches[p], dt);
    });
    reflect_answers();
    execution.for_each(patches.size(), [&](std::size_t p) {
      add_forces(elements, patches[p], nodes.motion(), dt, outcomes[p]);
      patches.store(patches[p], nodes);
    });
  }
  template <class Archive>
  void serialize(Archive& archive) {
    archive(found_at_);
    is_found_ = false;
  }

 private:
  /// Gathers the motion of the particles and their images; finds their neighbours anew once they have moved too far.
  template <class All, class Nodes, class Execution>
  void gather(const All& elements, const Nodes& nodes, const Execution& execution) {
    for_each_chunk(execution, count_, [&](std::size_t, std::size_t first, std::size_t last) {
      for (std::size_t p = first; p < last; ++p)
        at_[p] = nodes.x(nodes.number(place(elements, p))).template cast<double>();
    });
    if (has_moved(execution)) found_at_ = at_, is_found_ = false;
    if (!is_found_) find(execution);
    particles_.resize(count_ + images_.size());
    answers_.resize(count_ + images_.size());
    for_each_chunk(execution, count_, [&](std::size_t, std::size_t first, std::size_t last) {
      for (std::size_t p = first; p < last; ++p) {
        const auto& block = elements.blocks[p / width];
        const std::size_t l = p % width;
        const auto v = nodes.v(nodes.number(place(elements, p)));
        Seen& seen = particles_[p];
        for (int c = 0; c < 3; ++c) {
          seen.x[c] = static_cast<Real>(at_[p](c) - origin_(c));
          seen.v[c] = static_cast<Real>(v(c));
        }
        seen.weight = lane(block.state.reference_volume, l);
        seen.density = Real(1) / lane(block.state.relative_volume, l);
        if constexpr (All::erodes) seen.weight *= lane(block.removal.alive, l);
      }
    });
    for (std::size_t k = 0; k < images_.size(); ++k) {
      Seen& image = particles_[count_ + k];
      image = particles_[images_.of(k)];
      images_.reflect_place(k, image.x, origin_), images_.reflect(k, image.v);
    }
  }

  /// Advances the particles of a patch.
  template <class All>
  [[gnu::flatten]] Outcome advance(All& elements, const Patch& patch, double dt) {
    Outcome outcome;
    LanesOfOutcome<T> sum;
    for (std::size_t b = patch.first_block; b < patch.last_block; ++b) {
      auto& block = elements.blocks[b];
      const Self self(*this, b, elements.count(b));
      ParticleSums<T> sums;
      for (const Index j : near(b, self)) {
        const Seen& there = particles_[j];
        const Vector3<T> d = difference(there.x, self.x);
        sums.add(d, T(there.weight) * kernel_.slope(sqrt(dot(d, d))), difference(there.v, self.v));
      }
      sums *= T(kernel_.factor());
      using State = typename All::State;
      State state = block.state;
      ParticleStep<T> step = elements.element.advance(state, elements.material, sums, kernel_, dt);
      auto& response = step.response;
      auto& answer = step.answer;
      if constexpr (All::erodes) {
        Nodal<T, 1> x;
        set_column(x, 0, self.x);
        erode(elements, b, state, x, dt, response, outcome.deletions, [&] { return step.end_work; });
      } else {
        block.state = state;
      }
      for (std::size_t l = 0; l < elements.count(b); ++l) {
        Answer& told = answers_[b * width + l];
        for (int i = 0; i < 9; ++i) told.stress[i] = lane(answer.stress(i), l);
        const SymmetricTensor<T>& D = answer.half_rate;
        const Real rate[] = {lane(D.xx, l), lane(D.yy, l), lane(D.zz, l), lane(D.xy, l), lane(D.yz, l), lane(D.zx, l)};
        std::copy(std::begin(rate), std::end(rate), told.rate);
        told.impedance = lane(answer.impedance, l);
      }
      sum.add(T(static_cast<double>(b - patch.first_block)), response, response.critical_rate,
              b + 1 < elements.blocks.size() ? T(1.0) : elements.busy());
    }
    sum.reduce(outcome, patch.first_block, elements.size);
    return outcome;
  }

  /// Gives the images the answers of their particles.
  void reflect_answers() {
    for (std::size_t k = 0; k < images_.size(); ++k) {
      Answer& image = answers_[count_ + k];
      image = answers_[images_.of(k)];
      images_.reflect_tensor(k, image.stress);
      Real D[9];
      constexpr int of[] = {0, 3, 5, 3, 1, 4, 5, 4, 2}, at[] = {0, 4, 8, 1, 5, 2};
      for (int i = 0; i < 9; ++i) D[i] = image.rate[of[i]];
      images_.reflect_tensor(k, D);
      for (int i = 0; i < 6; ++i) image.rate[i] = D[at[i]];
    }
  }

  /// Subtracts the forces of the particles of a patch from those of its nodes and adds their hourglass work.
  template <class All, class Motion>
  [[gnu::flatten]] void add_forces(All& elements, const Patch& patch, Motion& motion, double dt, Outcome& outcome) {
    T hourglass_work = T(0.0);
    for (std::size_t b = patch.first_block; b < patch.last_block; ++b) {
      auto& block = elements.blocks[b];
      const Self self(*this, b, elements.count(b));
      ParticleAnswer<T> here;
      for (std::size_t l = 0; l < width; ++l) {
        const Answer& own = answers_[b * width + std::min(l, elements.count(b) - 1)];
        set_lanes(here, l, own);
      }
      ParticleForces<T> forces;
      for (const Index j : near_[b]) {
        const Seen& at = particles_[j];
        const Answer& there = answers_[j];
        const Vector3<T> d = difference(at.x, self.x);
        const T square = dot(d, d);
        forces.add(d, square, T(at.weight) * kernel_.slope(sqrt(square)), difference(at.v, self.v),
                   T(at.density) - self.density, here, answer_of(there));
      }
      forces *= T(kernel_.factor());
      T work = T(0.0);
      Nodal<T, 1> force =
          elements.element.force(block.state, elements.material, forces, here, kernel_, self.weight, self.v, dt, work);
      hourglass_work += (b + 1 < elements.blocks.size() ? T(1.0) : elements.busy()) * work;
      scatter_subtract<T, 1>(force, motion.force, block.nodes, elements.count(b));
    }
    outcome.hourglass_work += static_cast<double>(reduce_sum(hourglass_work));
  }

  /// Errors: a particle without a volume, or with one that is not positive.
  template <class All>
  [[gnu::cold]] static void check_volumes(const All& elements, const std::vector<double>& volumes) {
    const std::string part = std::to_string(elements.number);
    if (volumes.size() != elements.size)
      throw Error(joined({"strike: part ", part, " has ", std::to_string(elements.size), " particles, but ",
                          std::to_string(volumes.size()), " volumes; give one for each."}));
    for (std::size_t e = 0; e < volumes.size(); ++e)
      if (!(volumes[e] > 0 && std::isfinite(volumes[e])))
        throw Error(joined({"strike: particle ", std::to_string(e), " of part ", part, " has the volume ",
                            text(volumes[e]), "; it must be positive and finite."}));
  }

  /// A particle as its neighbours see it: position less the origin, velocity, reference volume, 0 if it had been
  /// deleted before the step, and relative density.
  struct Seen {
    Real x[3], weight, v[3], density;
  };
  /// ParticleAnswer of one particle.
  struct Answer {
    Real stress[9], rate[6], impedance;
  };
  /// The particles of a block; idle lanes repeat the last.
  struct Self {
    Vector3<T> x, v;
    T density, weight;

    Self(const Cloud& cloud, std::size_t b, std::size_t count) {
      for (std::size_t l = 0; l < width; ++l) {
        const Seen& seen = cloud.particles_[b * width + std::min(l, count - 1)];
        for (int c = 0; c < 3; ++c) set_lane(x(c), l, seen.x[c]), set_lane(v(c), l, seen.v[c]);
        set_lane(density, l, seen.density), set_lane(weight, l, seen.weight);
      }
    }
  };
  /// Of those near a block when they were last found, those that are now.
  const std::vector<Index>& near(std::size_t b, const Self& self) {
    const std::vector<Index>& found = neighbours_.of(b);
    std::vector<Index>& near = near_[b];
    near.clear();
    if (!any(self.weight > 0.0)) return near;
    near.resize(found.size());
    const T square = T(kernel_.reach() * kernel_.reach());
    std::size_t count = 0;
    for (const Index j : found) {
      const Vector3<T> d = difference(particles_[j].x, self.x);
      near[count] = j;
      count += any(dot(d, d) < square);
    }
    near.resize(count);
    return near;
  }
  static Vector3<T> difference(const Real* there, const Vector3<T>& here) {
    return {T(there[0]) - here(0), T(there[1]) - here(1), T(there[2]) - here(2)};
  }
  static ParticleAnswer<T> answer_of(const Answer& a) {
    ParticleAnswer<T> answer;
    for (int i = 0; i < 9; ++i) answer.stress(i) = T(a.stress[i]);
    answer.half_rate = {T(a.rate[0]), T(a.rate[1]), T(a.rate[2]), T(a.rate[3]), T(a.rate[4]), T(a.rate[5])};
    answer.impedance = T(a.impedance);
    return answer;
  }
  static void set_lanes(ParticleAnswer<T>& answer, std::size_t l, const Answer& a) {
    for (int i = 0; i < 9; ++i) set_lane(answer.stress(i), l, a.stress[i]);
    SymmetricTensor<T>& D = answer.half_rate;
    set_lane(D.xx, l, a.rate[0]), set_lane(D.yy, l, a.rate[1]), set_lane(D.zz, l, a.rate[2]);
    set_lane(D.xy, l, a.rate[3]), set_lane(D.yz, l, a.rate[4]), set_lane(D.zx, l, a.rate[5]);
    set_lane(answer.impedance, l, a.impedance);
  }

  template <class All>
  static std::size_t place(const All& elements, std::size_t p) {
    return elements.blocks[p / width].nodes[0][p % width];
  }

  /// Some have moved by more than half the skin since their neighbours were found, less their common motion along the
  /// mirrors.
  template <class Execution>
  bool has_moved(const Execution& execution) const {
    if (found_at_.size() != count_) return true;
    std::vector<Eigen::Vector3d> sums(chunks(count_), Eigen::Vector3d::Zero());
    for_each_chunk(execution, count_, [&](std::size_t k, std::size_t first, std::size_t last) {
      for (std::size_t p = first; p < last; ++p) sums[k] += at_[p] - found_at_[p];
    });
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& sum : sums) mean += sum / static_cast<double>(count_);
    mean = images_.along(mean);
    std::vector<double> most(sums.size());
    for_each_chunk(execution, count_, [&](std::size_t k, std::size_t first, std::size_t last) {
      for (std::size_t p = first; p < last; ++p)
        most[k] = std::max(most[k], (at_[p] - found_at_[p] - mean).squaredNorm());
    });
    const double most_of_all = *std::max_element(most.begin(), most.end());
    return !(4 * most_of_all < skin() * skin());
  }
  double skin() const { return 0.5 * spacing_; }

  /// Finds images and neighbours.
  template <class Execution>
  void find(const Execution& execution) {
    is_found_ = true;
    origin_.setZero();
    if constexpr (sizeof(RealOf<T>) < sizeof(double)) {
      for (const Eigen::Vector3d& x : found_at_) origin_ += x;
      origin_ *= 1 / static_cast<double>(count_);
    }
    const double reach = kernel_.reach() + skin();
    std::vector<Eigen::Vector3d> all = found_at_;
    images_.find(all, reach);
    neighbours_.find(all, count_, reach, execution);
    near_.resize((count_ + width - 1) / width);
  }

  double spacing_ = 0;
  Wendland kernel_{0};
  std::size_t count_ = 0;
  std::vector<Eigen::Vector3d> at_, found_at_;  // positions now, and when neighbours were found
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  MirrorImages images_;
  std::vector<Seen> particles_;
  std::vector<Answer> answers_;
  Neighbours<width> neighbours_;
  std::vector<std::vector<Index>> near_;  // the neighbours of a block in this step
  bool is_found_ = false;
};

}  // namespace strike::detail
