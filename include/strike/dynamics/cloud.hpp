#pragma once
#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/dynamics/advance.hpp>
#include <strike/dynamics/elements.hpp>
#include <strike/dynamics/mirror_images.hpp>
#include <strike/dynamics/neighbours.hpp>
#include <strike/dynamics/part_checks.hpp>
#include <strike/dynamics/patches.hpp>
#include <strike/dynamics/seen_particle.hpp>
#include <strike/element/particle.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/motion/execution.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike::detail {

/// The particles of a part as they see each other: place by place, and behind them their mirror images. In each step
/// they are gathered, sum over their neighbours, advance, answer, and sum over the answers. Each works for itself, in
/// the ascending order of its neighbours, so that the sums depend neither on threads nor on when lists were made.
template <class T, std::size_t width = lanes<T>>
class Cloud {
  using Real = LaneOf<T>;
  using Seen = SeenParticle<Real>;
  using Answer = SeenAnswer<Real>;
  using Self = ParticleBlock<T>;

 public:
  Cloud() = default;
  template <class All>
  Cloud(const All& elements, const std::vector<double>& volumes) : count_(elements.size) {
    check_particles(elements, volumes);
    images_ = MirrorImages(elements.element.mirrors);
    at_.resize(count_);
    set_spacing(elements, std::cbrt(*std::max_element(volumes.begin(), volumes.end())));
  }
  template <class All>
  void set_spacing(const All& elements, double spacing) {
    spacing_ = spacing;
    kernel_ = {elements.element.smoothing.length * spacing};
    images_.check_gaps(kernel_.reach() + skin(), elements.number);
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
        at_[p] = is_there(elements, p) ? nodes.x(nodes.number(place(elements, p))).template cast<double>() : nowhere;
    });
    if (has_moved(execution)) found_at_ = at_, is_found_ = false;
    if (!is_found_) find(execution);
    particles_.resize(count_ + images_.size());
    answers_.resize(count_ + images_.size());
    for_each_chunk(execution, count_, [&](std::size_t, std::size_t first, std::size_t last) {
      for (std::size_t p = first; p < last; ++p) {
        const auto& block = elements.blocks[p / width];
        const std::size_t l = p % width;
        const Index node = nodes.number(place(elements, p));
        const Eigen::Vector3d x = nodes.x(node).template cast<double>();
        const auto v = nodes.v(node);
        Seen& seen = particles_[p];
        for (int c = 0; c < 3; ++c) {
          seen.x[c] = static_cast<Real>(x(c) - origin_(c));
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
  [[gnu::__flatten__]] Outcome advance(All& elements, const Patch& patch, double dt) {
    Outcome outcome;
    LanesOfOutcome<T> sum;
    for (std::size_t b = patch.first_block; b < patch.last_block; ++b) {
      auto& block = elements.blocks[b];
      if constexpr (All::erodes)
        if (!any(block.removal.alive > 0.0)) {
          near_[b].clear();
          continue;
        }
      const Self self = in_block(b, elements.count(b));
      ParticleSums<T> sums;
      for (const Index j : near(b, self)) {
        const Seen& there = particles_[j];
        const Vector3<T> d = Self::difference(there.x, self.x);
        sums.add(d, T(there.weight) * kernel_.slope(sqrt(dot(d, d))), Self::difference(there.v, self.v));
      }
      sums *= T(kernel_.factor());
      using State = typename All::State;
      State state = block.state;
      ParticleStep<T> step = elements.element.advance(state, elements.material, sums, kernel_, dt, fill(elements, b));
      auto& response = step.response;
      auto& answer = step.answer;
      if constexpr (All::erodes) {
        Nodal<T, 1> x;
        set_column(x, 0, self.x);
        if constexpr (All::is_born)  // the elements from which it comes have done their half of the work
          response.internal_work -= std::exchange(block.birth.fresh, T(0.0)) *
                                    (response.internal_work + response.bulk_viscosity_work - step.end_work);
        erode(elements, b, state, x, dt, response, outcome.deletions, [&] { return step.end_work; });
      } else {
        block.state = state;
      }
      for (std::size_t l = 0; l < elements.count(b); ++l) {
        Answer& told = answers_[b * width + l];
        if constexpr (All::erodes)
          if (!(lane(block.removal.alive, l) > 0)) {
            told = {};
            continue;
          }
        told.take(answer, l);
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
  [[gnu::__flatten__]] void add_forces(All& elements, const Patch& patch, Motion& motion, double dt, Outcome& outcome) {
    T hourglass_work = T(0.0);
    for (std::size_t b = patch.first_block; b < patch.last_block; ++b) {
      auto& block = elements.blocks[b];
      if (near_[b].empty() && !any(dot(block.state.hourglass, block.state.hourglass) > 0.0)) continue;
      const Self self = in_block(b, elements.count(b));
      ParticleAnswer<T> here;
      for (std::size_t l = 0; l < width; ++l) {
        answers_[b * width + std::min(l, elements.count(b) - 1)].give(here, l);
      }
      ParticleForces<T> forces;
      for (const Index j : near_[b]) {
        const Seen& at = particles_[j];
        const Answer& there = answers_[j];
        const Vector3<T> d = Self::difference(at.x, self.x);
        const T square = dot(d, d);
        forces.add(d, square, T(at.weight) * kernel_.slope(sqrt(square)), Self::difference(at.v, self.v),
                   T(at.density) - self.density, here, there.template in_lanes<T>());
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

  /// Of those near a block when they were last found, those that are now.
  const std::vector<Index>& near(std::size_t b, const Self& self) {
    const std::vector<Index>& found = neighbours_.of(b);
    std::vector<Index>& near = near_[b];
    near.resize(any(self.weight > 0.0) ? found.size() : 0);
    if (near.empty()) return near;
    const T square = T(kernel_.reach() * kernel_.reach());
    std::size_t count = 0;
    for (const Index j : found) {
      const Vector3<T> d = Self::difference(particles_[j].x, self.x);
      near[count] = j;
      count += any(dot(d, d) < square);
    }
    near.resize(count);
    return near;
  }
  /// The shares of the cube of the spacing that the particles of a block fill in the whole body: those on mirrors have
  /// halves or quarters of their volumes.
  template <class All>
  T fill([[maybe_unused]] const All& elements, [[maybe_unused]] std::size_t b) const {
    T share = T(1.0);
    if constexpr (All::is_born)
      for (std::size_t l = 0; l < elements.count(b); ++l)
        set_lane(share, l,
                 std::min(Real(1), static_cast<Real>(images_.here(b * width + l) / std::pow(spacing_, 3)) *
                                       lane(elements.blocks[b].state.reference_volume, l)));
    return share;
  }
  Self in_block(std::size_t b, std::size_t count) const { return Self({particles_.data() + b * width, count}); }
  template <class All>
  static std::size_t place(const All& elements, std::size_t p) {
    return elements.blocks[p / width].nodes[0][p % width];
  }
  template <class All>
  static bool is_there([[maybe_unused]] const All& elements, [[maybe_unused]] std::size_t p) {
    if constexpr (All::erodes)
      return lane(elements.blocks[p / width].removal.alive, p % width) > 0;
    else
      return true;
  }

  /// Some have come, or so near to each other or to a mirror that their lists may not hold who sees whom.
  template <class Execution>
  bool has_moved(const Execution& execution) {
    if (found_at_.size() != count_) return true;
    if (!is_found_) find(execution);
    ways_.resize(count_ + images_.size());
    std::vector<char> comes(chunks(count_));
    for_each_chunk(execution, count_, [&](std::size_t k, std::size_t first, std::size_t last) {
      for (std::size_t p = first; p < last; ++p) {
        ways_[p] = at_[p] - found_at_[p];
        comes[k] =
            comes[k] || (at_[p].allFinite() && !found_at_[p].allFinite()) || images_.across(ways_[p]) > 0.5 * skin();
      }
    });
    for (std::size_t k = 0; k < images_.size(); ++k) {
      ways_[count_ + k] = ways_[images_.of(k)];
      images_.reflect(k, ways_[count_ + k].data());
    }
    return std::count(comes.begin(), comes.end(), true) > 0 ||
           !neighbours_.hold(ways_, kernel_.reach(), skin(), execution);
  }
  double skin() const { return 0.5 * spacing_; }
  /// The place of particles that are absent, near to none.
  static inline const Eigen::Vector3d nowhere = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());

  /// Finds images and neighbours.
  template <class Execution>
  void find(const Execution& execution) {
    is_found_ = true;
    origin_.setZero();
    if constexpr (sizeof(RealOf<T>) < sizeof(double)) {
      double there = 1e-30;
      for (const Eigen::Vector3d& x : found_at_)
        if (x.allFinite()) origin_ += x, there += 1;
      origin_ *= 1 / there;
    }
    const double reach = kernel_.reach() + skin();
    std::vector<Eigen::Vector3d> all = found_at_;
    images_.find(all, reach, 1e-6 * spacing_);
    neighbours_.find(all, count_, reach, execution);
    near_.resize((count_ + width - 1) / width);
  }

  double spacing_ = 0;
  Wendland kernel_{0};
  std::size_t count_ = 0;
  std::vector<Eigen::Vector3d> at_, found_at_, ways_;  // now, when neighbours were found, and from there
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  MirrorImages images_;
  std::vector<Seen> particles_;
  std::vector<Answer> answers_;
  Neighbours<width> neighbours_;
  std::vector<std::vector<Index>> near_;  // the neighbours of a block in this step
  bool is_found_ = false;
};

}  // namespace strike::detail
