#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include <strike/dynamics/erosion.hpp>
#include <strike/dynamics/nodal_volume.hpp>
#include <strike/dynamics/patches.hpp>
#include <strike/element/element.hpp>
#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/motion/gather.hpp>
#include <strike/motion/ledger.hpp>
#include <strike/motion/motion.hpp>
#include <strike/motion/nodes.hpp>

namespace strike {

namespace detail {

template <class E>
concept HasNodesAndKinematics = requires {
  typename E::Kinematics;
  E::nodes;
};
template <class M>
concept HasKinematics = requires { typename M::Kinematics; };

/// What is wrong with a part, asked in this order.
enum class Flaw { none, reported, element, material, pair, corners, material_members, element_members, removal };

template <class R>
inline constexpr bool is_removal = std::same_as<R, NoErosion> || std::same_as<R, Erosion>;

template <class E, class M, std::size_t n, class Removal>
constexpr Flaw flaw() {
  if constexpr (!HasNodesAndKinematics<E>)
    return Flaw::element;
  else if constexpr (is_reported<E>() || is_reported<M>())
    return Flaw::reported;
  else if constexpr (!HasKinematics<M> || HasNodesAndKinematics<M>)
    return Flaw::material;
  else if constexpr (!std::same_as<typename E::Kinematics, typename M::Kinematics>)
    return Flaw::pair;
  else if constexpr (static_cast<std::size_t>(E::nodes) != n)
    return Flaw::corners;
  else if constexpr (!Material<M>)
    return Flaw::material_members;
  else if constexpr (!Element<E, M>)
    return Flaw::element_members;
  else if constexpr (!is_removal<Removal>)
    return Flaw::removal;
  else
    return Flaw::none;
}

}  // namespace detail

/// The elements of one kind and one material in a scene, and when they are deleted, if they are.
template <class E, class M, std::size_t n = 8, class Removal = NoErosion>
struct Part {
  static constexpr detail::Flaw flaw = detail::flaw<E, M, n, Removal>();
  static_assert(flaw != detail::Flaw::element, "strike: the first piece of a Part is its element, such as Hex8{}.");
  static_assert(flaw != detail::Flaw::material,
                "strike: the second piece of a Part is its material, such as Solid{...} or Elastic{...}.");
  static_assert(
      flaw != detail::Flaw::pair,
      "strike: this element and this material do not fit: their Kinematics differ, so one measures what the other "
      "does not know.");
  static_assert(flaw != detail::Flaw::corners,
                "strike: these cells do not have as many nodes as the element of the Part.");
  static_assert(flaw != detail::Flaw::material_members,
                "strike: this material lacks one of State<T>, density(), stress(state, rate, dt), stress(state) and "
                "moduli(state, rate), or it returns another type; see strike/material/material.hpp.");
  static_assert(
      flaw != detail::Flaw::element_members,
      "strike: this element lacks one of State<M, T>, begin(state, material, x) and advance(state, material, x, v, "
      "dt), or it returns another type; see strike/element/element.hpp.");
  static_assert(flaw != detail::Flaw::removal,
                "strike: the fourth piece of a Part is when its elements are deleted, such as Erosion{.strain = 5}.");

  E element;
  M material;
  Cells<n> cells;
  [[no_unique_address]] Removal removal{};
};
template <class E, class M, std::size_t n>
Part(E, M, std::vector<std::array<Index, n>>) -> Part<E, M, n>;
template <class E, class M, std::size_t n, class Removal>
Part(E, M, std::vector<std::array<Index, n>>, Removal) -> Part<E, M, n, Removal>;

/// The least stable step of some elements and the element that has it.
struct StableStep {
  double dt = std::numeric_limits<double>::infinity();
  std::size_t element = 0;
  std::size_t part = 0;
};

namespace detail {

/// Which blocks of a part are advanced after a step, over what time and with which velocities: all, over the step, with
/// those of the nodes. See RunningCycle for another.
struct EveryStep {
  double step;

  void load(const Patches&, const Patch&) const {}
  static constexpr bool comes(std::size_t) { return true; }
  double dt(std::size_t) const { return step; }
  template <class Motion>
  const Motion& velocities(std::size_t, const Motion& motion) const {
    return motion;
  }
  template <class T, class A>
  const A& times_multiple(std::size_t, const A& a) const {
    return a;
  }
};

}  // namespace detail

/// A part at work: its elements in blocks of lanes. T is the number in the formulas, `double` or a `Pack`.
template <class E, class M, class T, class Nodes = strike::Nodes<LaneOf<T>, LaneOf<T>, turns_nodes<E>()>,
          class Removal = NoErosion>
class RunningPart {
 public:
  static constexpr std::size_t n = static_cast<std::size_t>(E::nodes);
  static constexpr std::size_t width = lanes<T>;
  static constexpr bool erodes = std::same_as<Removal, Erosion>;
  static constexpr bool averages_volume = requires { requires E::averages_volume; };
  using State = typename E::template State<M, T>;
  static constexpr bool scales_mass = requires(State state) { state.mass_factor; };

  struct Block {
    BlockNodes<n, width> nodes;
    State state;
    [[no_unique_address]] typename Removal::template Block<T> removal{};
  };

  /// `order` names every element once, in the order in which they are to lie in memory.
  RunningPart(Part<E, M, n, Removal> part, Nodes& nodes, std::size_t number, std::vector<Index> order)
      : element_(std::move(part.element)),
        material_(std::move(part.material)),
        removal_(part.removal),
        size_(part.cells.size()),
        number_(number),
        order_(std::move(order)) {
    check_material();
    blocks_.resize((size_ + width - 1) / width);
    std::vector<Index> corners;
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t l = 0; l < width; ++l)  // idle lanes repeat the last element
          corners.push_back(nodes.place(part.cells[order_[std::min(b * width + l, size_ - 1)]][i]));
    const auto unnamed = std::find(nodes.mass().begin(), nodes.mass().end(), 0) - nodes.mass().begin();
    patches_ = detail::Patches(corners, blocks_.size(), width, static_cast<Index>(unnamed), nodes.places());
    nodes.add_ghosts(patches_.sources());
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      for (std::size_t i = 0; i < n; ++i) std::copy_n(&corners[(b * n + i) * width], width, blocks_[b].nodes[i].data());
    outcomes_.resize(patches_.size());
    for (std::size_t p = 0; p < patches_.size(); ++p) {
      patches_.load(patches_[p], nodes);
      for (std::size_t b = patches_[p].first_block; b < patches_[p].last_block; ++b) begin(b, nodes);
    }
    if constexpr (averages_volume) {
      volume_ = Volume(nodes.places());
      for (std::size_t p = 0; p < patches_.size(); ++p) {
        patches_.load(patches_[p], nodes);
        add_volumes(patches_[p], nodes.motion());
      }
      volume_.begin(patches_);
    }
  }

  /// Advances every element, or those whose `turn` it is, over the step dt that led to the present positions, adds its
  /// forces to the nodes and its work to the ledger, and returns the least stable step. Throws if an element is
  /// inverted; no node has moved by then.
  template <class Execution>
  StableStep compute_forces(Nodes& nodes, double dt, Ledger& ledger, const Execution& execution) {
    return compute_forces(nodes, ledger, execution, detail::EveryStep{dt});
  }
  template <class Execution, class Turn>
  StableStep compute_forces(Nodes& nodes, Ledger& ledger, const Execution& execution, const Turn& turn) {
    if constexpr (averages_volume) {
      volume_.clear();
      execution.for_each(patches_.size(), [&](std::size_t p) {
        patches_.load(patches_[p], nodes);
        add_volumes(patches_[p], nodes.motion());
      });
      volume_.update(patches_);
    }
    execution.for_each(patches_.size(), [&](std::size_t p) {
      if constexpr (!averages_volume) patches_.load(patches_[p], nodes);
      turn.load(patches_, patches_[p]);
      outcomes_[p] = advance(patches_[p], nodes.motion(), turn);
      patches_.store(patches_[p], nodes);
    });
    patches_.store_ghosts(nodes, execution);

    StableStep stable{.part = number_};
    [[maybe_unused]] Tally deleted{};
    double internal = 0, hourglass = 0, bulk_viscosity = 0;
    for (const Outcome& outcome : outcomes_) {
      if (!(outcome.inverted_volume > 0)) explain_inversion(nodes, outcome.inverted, outcome.inverted_volume);
      if (const double dt_p = 1 / outcome.critical_rate; dt_p < stable.dt)
        stable.dt = dt_p, stable.element = order_[outcome.slowest];
      internal += outcome.internal_work;
      hourglass += outcome.hourglass_work;
      bulk_viscosity += outcome.bulk_viscosity_work;
      if constexpr (erodes) deleted.deleted += outcome.deleted, deleted.energy += outcome.energy;
    }
    if constexpr (erodes) {
      newly_deleted_ = deleted;
      deleted_ += deleted.deleted;
      ledger.internal.book(-deleted.energy);
      ledger.eroded.book(deleted.energy);
    }
    ledger.internal.book(internal);
    ledger.hourglass.book(hourglass);
    ledger.bulk_viscosity.book(bulk_viscosity);
    return stable;
  }

  /// What the user should know of the material and of what was deleted, if anything: a sentence each.
  std::string warning() const {
    std::string text = material_notice();
    if constexpr (scales_mass)
      if (added_mass() > 0)
        text += detail::joined({text.empty() ? "" : " ", "Mass scaling has added ", detail::text(added_mass()),
                                " to part ", std::to_string(number_), ", ", detail::text(100 * added_mass() / mass_),
                                " % of its mass; most to element ", std::to_string(scaling_.element), ", which has ",
                                detail::text(scaling_.largest), " times its own."});
    if constexpr (erodes)
      if (deleted() > 0)
        text += detail::joined({text.empty() ? "" : " ", std::to_string(deleted()), " of ", std::to_string(size_),
                                " elements of part ", std::to_string(number_), " have been deleted."});
    return text;
  }
  /// What MassScaled has added to its elements [mass].
  double added_mass() const
    requires scales_mass
  {
    return scaling_.added;
  }
  /// How many elements have been deleted, and in the last step.
  std::size_t deleted() const
    requires erodes
  {
    return deleted_;
  }
  std::size_t newly_deleted() const
    requires erodes
  {
    return newly_deleted_.deleted;
  }
  /// Whether an element is there, by the numbers as given.
  std::vector<bool> alive() const
    requires erodes
  {
    std::vector<bool> alive(size_);
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      for (std::size_t l = 0; l < count(b); ++l) alive[order_[b * width + l]] = lane(blocks_[b].removal.alive, l) > 0;
    return alive;
  }
  std::string material_notice() const {
    if constexpr (requires { material_.warning(0.0); })  // of a section: over half waves of four elements
      return material_.warning(4 * std::sqrt(mass_ / density_of(material_) / static_cast<double>(size_)));
    else if constexpr (requires { material_.warning(); })
      return material_.warning();
    else
      return {};
  }
  /// The internal energy that a material has before anything deforms it, such as that of a gas under pressure.
  double stored_energy() const { return stored_energy(mass_); }
  /// Its place among the parts of the scene, from 0.
  std::size_t number() const { return number_; }
  std::size_t size() const { return size_; }
  const E& element() const { return element_; }
  const M& material() const { return material_; }

  // Its blocks of elements in memory, the patches that they form, and how many lanes of a block are elements.
  const std::vector<Block>& blocks() const { return blocks_; }
  const detail::Patches& patches() const { return patches_; }
  std::size_t count(std::size_t b) const { return b + 1 < blocks_.size() ? width : size_ - b * width; }

  /// A number per element, f(material state), the mean over the element's points: part.field([](const auto& s) { return
  /// s.stress.zz; }).
  template <class F>
  std::vector<double> field(F f) const {
    return mean_over_points([&](const State& state, auto add) { state.each_point([&](const auto& s) { add(f(s)); }); });
  }
  /// The same for layer k of a plate, from 0 at its bottom.
  template <class F>
  std::vector<double> field(std::size_t k, F f) const {
    return mean_over_points(
        [&](const State& state, auto add) { state.each_point(k, [&](const auto& s) { add(f(s)); }); });
  }

  /// "element 7 of part 0 at (x, y, z)", its number as given.
  std::string describe(const Nodes& nodes, std::size_t e) const { return describe_at(nodes, place_of(e)); }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.same(detail::name_of<RunningPart>(), size_, order_);
    for (Block& block : blocks_) {
      archive.same(block.nodes);
      archive(numbers_of<T>(block.state));
      if constexpr (erodes) archive(block.removal);
    }
    if constexpr (averages_volume) archive(volume_);
    if constexpr (erodes) archive(newly_deleted_, deleted_);
  }

 private:
  template <class Visit>
  std::vector<double> mean_over_points(const Visit& visit) const {
    std::vector<double> values(size_);
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      T sum = T(0.0);
      double points = 0;
      visit(blocks_[b].state, [&](const T& value) { sum += value, points += 1; });
      for (std::size_t l = 0; l < count(b); ++l)
        values[order_[b * width + l]] = static_cast<double>(lane(sum, l)) / points;
    }
    return values;
  }
  using Tally = typename Removal::Tally;

  /// Of the material of a mass.
  template <class Number>
  Number stored_energy(const Number& mass) const {
    typename M::template State<double> state{};
    if constexpr (requires { state.internal_energy; }) {
      if constexpr (requires { material_.begin(state); }) material_.begin(state);
      return mass * (state.internal_energy / density_of(material_));
    } else {
      return (void)mass, Number(0.0);
    }
  }

  /// Sets the elements of a block at rest and gives their masses to the nodes.
  void begin(std::size_t b, Nodes& nodes) {
    Block& block = blocks_[b];
    const auto given = element_.begin(block.state, material_, gather<T, n>(nodes.motion().position, block.nodes));
    const T mass = mass_of(given);
    T own = mass;
    if constexpr (scales_mass) own = mass / block.state.mass_factor;
    if constexpr (erodes) block.removal.energy = stored_energy(T(static_cast<double>(n)) * own);
    for (std::size_t l = 0; l < count(b); ++l) {
      check_resolution(nodes, b * width + l);
      if (!(lane(mass, l) > 0))
        throw Error(detail::joined({"strike: ", describe_at(nodes, b * width + l),
                                    " has no positive mass; its corners are in the wrong order or coincide."}));
      for (const Index i : cell(nodes, b * width + l)) {
        nodes.add_mass(i, static_cast<double>(lane(mass, l)));
        if constexpr (turns_nodes<E>()) nodes.add_inertia(i, static_cast<double>(lane(given.inertia, l)));
      }
      mass_ += static_cast<double>(n) * static_cast<double>(lane(own, l));
      if constexpr (scales_mass) {
        scaling_.added += static_cast<double>(n) * static_cast<double>(lane(mass, l) - lane(own, l));
        if (const auto factor = static_cast<double>(lane(block.state.mass_factor, l)); factor > scaling_.largest)
          scaling_.largest = factor, scaling_.element = order_[b * width + l];
      }
    }
  }

  /// Asks for a block before its turn: what streams from memory comes late if the machine guesses alone. Inline always:
  /// g++ finds that a function which only asks does nothing, and leaves out its calls.
  template <class Data>
  [[gnu::always_inline]] static void prefetch(const Data& data) {
    const char* begin = reinterpret_cast<const char*>(&data);
    for (std::size_t line = 0; line < sizeof(Data) / 64; ++line) __builtin_prefetch(begin + 64 * line, 1);
  }

  static T mass_of(const T& mass) { return mass; }
  static T mass_of(const NodalInertia<T>& given) { return given.mass; }

  using Motion = std::decay_t<decltype(std::declval<Nodes&>().motion())>;
  using Vectors = Nodal<T, motions<E>>;

  /// Velocities that are gathered when an element that knows how to wait asks for them.
  struct Velocities {
    const Motion& motion;
    const BlockNodes<n, width>& nodes;

    operator Vectors() const {
      if constexpr (turns_nodes<E>())
        return gather<T, n>(motion.velocity, motion.angular_velocity, nodes);
      else
        return gather<T, n>(motion.velocity, nodes);
    }
  };

  /// What a patch tells after a step; elements by their places.
  struct Outcome : Tally {
    double critical_rate = 0, inverted_volume = 1;
    std::size_t slowest = 0, inverted = 0;
    double internal_work = 0, hourglass_work = 0, bulk_viscosity_work = 0;
  };

  template <class Turn>
  [[gnu::flatten]] Outcome advance(const detail::Patch& patch, Motion& motion, const Turn& turn) {
    T rate = T(0.0), slowest = T(0.0);
    T inverted_volume = T(1.0), inverted = T(0.0);
    T internal = T(0.0), hourglass = T(0.0), bulk_viscosity = T(0.0);
    Outcome outcome;
    Local<E> element = element_;
    Local<M> material = material_;
    for (std::size_t b = patch.first_block; b < patch.last_block; ++b) {
      if (!turn.comes(b)) continue;
      Block& block = blocks_[b];
      const double dt = turn.dt(b);
      prefetch(blocks_[std::min(b + 2, blocks_.size() - 1)]);
      if constexpr (erodes)
        if (!any(block.removal.alive > 0.0)) continue;
      std::conditional_t<state_is_small || erodes, State, State&> state = block.state;
      const Nodal<T, E::nodes> x = gather<T, n>(motion.position, block.nodes);
      const Velocities v{turn.velocities(b, motion), block.nodes};
      std::conditional_t<erodes, Response<T, motions<E>>, const Response<T, motions<E>>> response = [&] {
        if constexpr (averages_volume)
          return element.advance(state, material, x, Vectors(v), volume_.template mean<T, n>(block.nodes), dt);
        else if constexpr (requires { element.advance(state, material, x, v, dt); })
          return element.advance(state, material, x, v, dt);
        else
          return element.advance(state, material, x, Vectors(v), dt);
      }();
      if constexpr (erodes)
        erode(block, state, response, v, dt, b, outcome);
      else if constexpr (state_is_small)
        block.state = state;
      const auto& force = turn.template times_multiple<T>(b, response.force);
      scatter_subtract<T, n>(force, motion.force, block.nodes, count(b));
      if constexpr (turns_nodes<E>()) scatter_subtract<T, n>(force, motion.moment, block.nodes, count(b), n);

      const T number = T(static_cast<double>(b - patch.first_block));
      const T critical_rate = turn.template times_multiple<T>(b, response.critical_rate);
      slowest = select(rate < critical_rate, number, slowest);
      rate = max(rate, critical_rate);
      const auto sound = response.volume > 0.0;
      inverted = select(sound, inverted, number);
      inverted_volume = select(sound, inverted_volume, response.volume);
      const T mine = b + 1 < blocks_.size() ? T(1.0) : busy();
      internal += mine * response.internal_work;
      hourglass += mine * response.hourglass_work;
      bulk_viscosity += mine * response.bulk_viscosity_work;
    }

    for (std::size_t l = 0; l < width; ++l) {
      const auto element_of = [&](const T& block) {
        return std::min((patch.first_block + static_cast<std::size_t>(static_cast<double>(lane(block, l)))) * width + l,
                        size_ - 1);
      };
      if (const double rate_l = static_cast<double>(lane(rate, l)); outcome.critical_rate < rate_l)
        outcome.critical_rate = rate_l, outcome.slowest = element_of(slowest);
      if (const double V_l = static_cast<double>(lane(inverted_volume, l)); !(V_l > 0))
        outcome.inverted_volume = V_l, outcome.inverted = element_of(inverted);
    }
    outcome.internal_work = static_cast<double>(reduce_sum(internal));
    outcome.hourglass_work = static_cast<double>(reduce_sum(hourglass));
    outcome.bulk_viscosity_work = static_cast<double>(reduce_sum(bulk_viscosity));
    return outcome;
  }

  /// Deletes what is beyond the limits, and keeps the state that it had before. In its last step the forces at the
  /// begin have done their half of the work, and those at the end do none.
  void erode(Block& block, const State& state, Response<T, motions<E>>& response, const Vectors& v, double dt,
             std::size_t b, Tally& deleted) const {
    auto& removal = block.removal;
    if (!(dt > 0)) removal.initial_volume = response.volume;
    const auto there = removal.alive > 0.0;
    const auto stays = there && removal_.keeps(removal, state, response);
    if (all(stays)) {
      block.state = state;
      removal.energy += response.internal_work;
      return;
    }
    const T last = response.internal_work - 0.5 * dt * response.force.cwiseProduct(v).sum();
    const T finite = select(abs(last) <= std::numeric_limits<RealOf<T>>::max(), last, T(0.0));
    zero_if_failed(stays, response);
    response.internal_work = select(stays, response.internal_work, select(there, finite, T(0.0)));
    removal.energy += response.internal_work;
    const T left = select(stays, T(1.0), T(0.0));
    for (std::size_t l = 0; l < count(b); ++l)
      if (lane(left, l) < lane(removal.alive, l))
        ++deleted.deleted, deleted.energy += static_cast<double>(lane(removal.energy, l));
    removal.alive = left;
    const auto now = numbers_of<T>(state);
    auto kept = numbers_of<T>(block.state);
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = select(stays, now[i], kept[i]);
    if constexpr (requires { block.state.own_rate; })
      block.state.own_rate = select(stays, block.state.own_rate, T(0.0));
  }

  void add_volumes(const detail::Patch& patch, const Motion& motion) {
    for (std::size_t b = patch.first_block; b < patch.last_block; ++b) {
      const Block& block = blocks_[b];
      prefetch(blocks_[std::min(b + 4, blocks_.size() - 1)].nodes);
      const T V = element_.volume(gather<T, n>(motion.position, block.nodes));
      if constexpr (loses_elements) {
        T share = intact_share<T>(material_, block.state.material);
        if constexpr (erodes) share = share * block.removal.alive;
        volume_.template add<T, n>(select(share > 0.0, V, T(0.0)), share / block.state.inverse_volume, block.nodes,
                                   count(b));
      } else {
        volume_.template add<T, n>(V, block.nodes, count(b));
      }
    }
  }

  // Elements are known by their places, lane after lane and block after block, but for what the user sees.
  std::size_t place_of(std::size_t e) const {
    return static_cast<std::size_t>(std::find(order_.begin(), order_.end(), e) - order_.begin());
  }
  std::array<Index, n> cell(const Nodes& nodes, std::size_t p) const {
    std::array<Index, n> c;
    for (std::size_t i = 0; i < n; ++i) c[i] = nodes.number(blocks_[p / width].nodes[i][p % width]);
    return c;
  }
  std::string describe_at(const Nodes& nodes, std::size_t p) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Index i : cell(nodes, p)) sum += nodes.x(i).template cast<double>();
    return detail::joined({"element ", std::to_string(order_[p]), " of part ", std::to_string(number_), " at ",
                           detail::text((1.0 / static_cast<double>(n)) * sum)});
  }

  static constexpr bool loses_elements = erodes || requires(const M m, const State s) { m.intact(s.material); };
  /// A state whose numbers may stay in registers while its element works on them.
  static constexpr bool state_is_small = sizeof(State) < 32 * sizeof(T);

  /// A model whose numbers no store into a block can change, so that they stay in registers; one that owns tables is
  /// not copied.
  template <class Model>
  using Local = std::conditional_t<std::is_trivially_copyable_v<Model>, const Model, const Model&>;

  T busy() const {
    T ones = T(0.0);
    for (std::size_t l = 0; l < count(blocks_.size() - 1); ++l) set_lane(ones, l, RealOf<T>(1));
    return ones;
  }

  /// Constants from which no wave follows are refused.
  [[gnu::cold]] void check_material() const {
    typename M::template State<double> state{};
    if constexpr (requires { material_.begin(state); }) material_.begin(state);
    const double density = density_of(material_),
                 wave = material_.moduli(state, typename M::Kinematics::template Rate<double>{}).wave();
    if (!(density > 0 && wave > 0 && std::isfinite(density) && std::isfinite(wave)))
      throw Error(detail::joined({"strike: the material of part ", std::to_string(number_), " has the density ",
                                  detail::text(density), " and at rest the wave modulus K + 4/3 G = ",
                                  detail::text(wave), "; both must be positive: correct its constants."}));
  }

  /// An element so far from the origin that the spacing of the numbers there would strain it by more than a thousandth.
  void check_resolution(const Nodes& nodes, std::size_t p) const {
    const std::array<Index, n> c = cell(nodes, p);
    double spacing = 0, gap = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n; ++i) {
      const Eigen::Vector3d x = nodes.x(c[i]).template cast<double>();
      spacing = std::max(spacing, nodes.resolution(c[i]));
      for (std::size_t j = 0; j < i; ++j)
        if (const double d = Eigen::Vector3d(x - nodes.x(c[j]).template cast<double>()).norm(); d > 0)
          gap = std::min(gap, d);
    }
    if (spacing > 1e-3 * gap)
      throw Error(
          detail::joined({"strike: ", describe_at(nodes, p), " is only ", detail::text(gap), " wide where numbers are ",
                          detail::text(spacing), " apart; move the mesh to the origin or compute in double."}));
  }

  [[noreturn, gnu::cold, gnu::noinline]] void explain_inversion(const Nodes& nodes, std::size_t p,
                                                                double volume) const {
    throw Error(detail::joined({describe_at(nodes, p), " is inverted (volume ", detail::text(volume),
                                "); refine the mesh there, use a smaller step factor or let the material fail"}));
  }

  E element_;
  M material_;
  [[no_unique_address]] Removal removal_;
  std::size_t size_;
  std::size_t number_;
  std::vector<Index> order_;
  double mass_ = 0;
  std::vector<Block> blocks_;
  detail::Patches patches_;
  std::vector<Outcome> outcomes_;
  struct Scaling {
    double added = 0, largest = 1;
    std::size_t element = 0;
  };
  struct NoScaling {};
  [[no_unique_address]] std::conditional_t<scales_mass, Scaling, NoScaling> scaling_;
  struct NoVolume {};
  struct NoCount {};
  using Volume = detail::NodalVolume<LaneOf<T>, loses_elements>;
  [[no_unique_address]] std::conditional_t<averages_volume, Volume, NoVolume> volume_;
  [[no_unique_address]] Tally newly_deleted_{};
  [[no_unique_address]] std::conditional_t<erodes, std::size_t, NoCount> deleted_{};
};

}  // namespace strike
