#pragma once
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/dynamics/advance.hpp>
#include <strike/dynamics/cloud.hpp>
#include <strike/dynamics/deal.hpp>
#include <strike/dynamics/debris.hpp>
#include <strike/dynamics/elements.hpp>
#include <strike/dynamics/mass_scaling.hpp>
#include <strike/dynamics/nodal_volume.hpp>
#include <strike/dynamics/part.hpp>
#include <strike/dynamics/part_checks.hpp>
#include <strike/dynamics/patches.hpp>
#include <strike/dynamics/plate_proportions.hpp>
#include <strike/motion/gather.hpp>
#include <strike/motion/ledger.hpp>
#include <strike/motion/node_share.hpp>
#include <strike/motion/nodes.hpp>
#include <strike/motion/ranks.hpp>
#include <strike/text.hpp>

namespace strike {

/// A part at work: its elements in blocks of lanes. T is the number in the formulas, `double` or a `Pack`.
template <class E, class M, class T, class Nodes = strike::Nodes<LaneOf<T>, LaneOf<T>, turns_nodes<E>()>,
          class Removal = NoErosion>
class RunningPart {
  using Elements = detail::Elements<E, M, T, Removal>;
  using Ranks = typename Nodes::Ranks;

 public:
  static constexpr std::size_t n = Elements::n, width = Elements::width;
  static constexpr bool erodes = Elements::erodes, averages_volume = Elements::averages_volume,
                        sees_neighbours = strike::sees_neighbours<E>(), is_born = Elements::is_born;
  using Element = E;
  using Number = T;
  using State = typename Elements::State;
  using Block = typename Elements::Block;
  /// Particles see each other, and are born of any element.
  static constexpr bool can_be_dealt = !sees_neighbours && !is_born;
  static constexpr bool scales_mass = requires(State state) { state.mass_factor; };
  /// Number of blocks that hold so many elements.
  static constexpr std::size_t blocks_of(std::size_t elements) { return (elements + width - 1) / width; }

  /// `order` names every element once, in the order in which they are to lie in memory. With its place in the scene
  /// the part is dealt to the processes of the run, else each works on all of it.
  RunningPart(Part<E, M, n, Removal> part, Nodes& nodes, std::size_t number, std::vector<Index> order,
              const std::optional<detail::PlaceInScene>& place = {})
      : elements_{std::move(part.element),       std::move(part.material), part.removal, part.cells.size(), number,
                  detail::Kept(std::move(order))},
        ranks_(nodes.ranks()) {
    detail::check_material(elements_.material, number);
    lay_out(part.cells, nodes);
    deal_ = can_be_dealt && place ? detail::Deal(patches_, size(), width, *place, ranks_) : detail::Deal(patches_);
    if constexpr (sees_neighbours) cloud_ = detail::Cloud<T>(elements_, part.cells.volumes);
    list_own_patches(std::vector<bool>(patches_.size()));
    outcomes_.resize(patches_.size());
    for (std::size_t p = 0; p < patches_.size(); ++p) {
      patches_.load(patches_[p], nodes);
      for (std::size_t b = patches_[p].first_block; b < patches_[p].last_block; ++b) begin(b, nodes, part.cells);
    }
    if constexpr (is_born) births_.begin(elements_, nodes);
    if constexpr (averages_volume) {
      volume_ = Volume(nodes.places());
      for (std::size_t p = 0; p < patches_.size(); ++p) add_volumes(p, nodes);
      volume_.begin(patches_);
    }
  }

  /// Advances the elements that are due by the schedule, in a run without subcycling all over the step dt that led to
  /// the present positions, adds their forces to the nodes and their work to the ledger, and returns the least stable
  /// step. Error: an element is inverted; no node has moved by then.
  template <class Execution>
  StableStep compute_forces(Nodes& nodes, double dt, Ledger& ledger, const Execution& execution) {
    return compute_forces(nodes, ledger, execution, detail::EveryStep{dt});
  }
  template <class Execution, class Schedule>
  StableStep compute_forces(Nodes& nodes, Ledger& ledger, const Execution& execution, const Schedule& schedule) {
    if constexpr (averages_volume) {
      volume_.clear();
      work(
          execution, [&](std::size_t p) { add_volumes(p, nodes); }, [&] { return start_trade_of_volumes(); });
      update_volumes();
    }
    if constexpr (sees_neighbours)
      timed([&] { cloud_.compute_forces(elements_, patches_, nodes, outcomes_, schedule.dt(0), execution); });
    else
      work(
          execution,
          [&](std::size_t p) {
            if constexpr (!averages_volume) patches_.load(patches_[p], nodes);
            schedule.load(patches_, patches_[p]);
            outcomes_[p] = detail::advance(elements_, patches_[p], nodes.motion(), volume_, schedule);
            patches_.store(patches_[p], nodes);
          },
          [&] { return start_trade_of_forces(nodes); });
    name_slowest();
    exchange(nodes);
    patches_.store_ghosts(nodes, execution);
    return book(nodes, ledger);
  }

  /// Of Debris: the number of the part that erodes.
  std::size_t source() const
    requires is_born
  {
    return elements_.removal.of;
  }
  /// Prepares to take the elements that another part will lose. Errors: they cannot become particles.
  template <class Source>
  void follow(const Source& source, const Nodes& nodes) {
    cloud_.set_spacing(elements_, births_.follow(elements_, source, nodes));
  }
  /// Takes those that it has lost in the step dt.
  template <class Source>
  void take(const Source& source, const Nodes& nodes, double dt, Ledger& ledger) {
    births_.take(elements_, source, nodes, dt, ledger);
  }

  /// Sentences about the material, scaled mass, thick or thin plates and deleted elements, one after the other; empty:
  /// none.
  std::string warning() const {
    std::string text = detail::warning_of(material(), mass_, size());
    const auto add = [&](const std::string& sentence) {
      if (!sentence.empty()) text += (text.empty() ? "" : " ") + sentence;
    };
    if constexpr (scales_mass) add(scaled_.warning(number(), mass_));
    add(proportions_.warning(number(), size()));
    if (deletions_.count > 0)
      add(detail::joined({std::to_string(deletions_.count), " of ", std::to_string(size()), " elements of part ",
                          std::to_string(number()), " have been deleted."}));
    return text;
  }
  /// Mass that MassScaled has added to its elements [mass].
  double added_mass() const
    requires scales_mass
  {
    return scaled_.added();
  }
  /// Spacing of its particles, the edge of a cube of the volume of the largest [length].
  double spacing() const
    requires sees_neighbours
  {
    return cloud_.spacing();
  }
  /// Number of deleted elements.
  std::size_t deleted() const {
    static_assert(
        erodes,
        "strike: elements of this Part are never deleted: give it Erosion{...} after its cells, or do not ask "
        "for deleted().");
    return deletions_.count;
  }
  /// Number of elements that the last step has deleted; 0 of a part without a removal law.
  std::size_t newly_deleted() const { return newly_deleted_.count; }
  /// By the numbers of the elements, false if deleted.
  std::vector<bool> alive() const { return in_order<bool>(elements_.alive()); }
  /// The internal energy of the material at rest, such as that of a gas under pressure.
  double stored_energy() const { return detail::stored_energy(material(), mass_); }
  /// The place of the part among those of the scene, from 0.
  std::size_t number() const { return elements_.number; }
  /// Number of elements.
  std::size_t size() const { return elements_.size; }
  const E& element() const { return elements_.element; }
  const M& material() const { return elements_.material; }

  /// The blocks of elements in memory, the patches that they form, and the lanes of a block that hold elements.
  const detail::Kept<Block>& blocks() const { return elements_.blocks; }
  detail::Kept<Block>& blocks() { return elements_.blocks; }
  const detail::Patches& patches() const { return patches_; }
  std::size_t count(std::size_t b) const { return elements_.count(b); }
  /// The outcome of the last step for each patch.
  const std::vector<detail::Outcome>& outcomes() const { return outcomes_; }
  /// The cells by the numbers of elements and nodes as given; wedges and pyramids by canonical_hexahedron.
  Cells<n> cells(const Nodes& nodes) const {
    Cells<n> cells(size());
    for (std::size_t p = first_place(); p < last_place(); ++p) cells[p] = elements_.cell(nodes, p);
    return in_order(std::move(cells));
  }

  /// A value per element, the mean over its points of f(state of a point), a number or a tensor:
  ///   part.field([](const auto& s) { return s.stress.zz; })      part.field([](const auto& s) { return s.stress; })
  /// Of a plate also of f(section, its state), such as Delamination.
  template <class F>
  auto field(F f) const {
    return in_order(elements_.field(f));
  }
  /// The same for layer k of a plate, from 0 at its bottom; also of f(section, its state, k). Error: no such layer.
  template <class F>
  auto field(std::size_t k, F f) const {
    return in_order(elements_.field(k, f));
  }

  void ranges(const auto& number) const {
    number(elements_.element), number(elements_.material), number(elements_.removal);
  }
  /// "element 7 of part 0 at (x, y, z)", by its number as given. Error: no such element.
  std::string describe(const Nodes& nodes, std::size_t e) const { return describe_at(nodes, elements_.place_of(e)); }

  /// The same of the first element whose state is NaN; empty: there is none.
  std::string describe_nan(const Nodes& nodes) const {
    const std::string mine = elements_.describe_nan(nodes);
    return deal_.is_dealt() ? detail::first_of_ranks(ranks_, mine) : mine;
  }

  /// The time that this process has taken for the elements since the start [s]; 0 in a run without processes.
  double seconds() const { return seconds_; }
  /// The processes of the run, and the patches that each works on.
  const Ranks& ranks() const { return ranks_; }
  const detail::Deal& deal() const { return deal_; }
  /// Its nodes may be shared: elements do not see more of them than their own.
  bool can_share_nodes() const { return deal_.is_dealt(); }
  /// Tells what the elements of each process need, ...
  void add_needs(detail::NodeShare& share) const {
    each_named([&](std::size_t rank, std::size_t, Index place, Index) { share.need(rank, place); });
  }
  /// ... and, when that is known, leaves other nodes and ghosts to them: from now on places are those here. Kept are
  /// the ghosts of its own patches and those of its own nodes, whose places among all it adds to a list.
  void share_nodes(const std::shared_ptr<const detail::NodeShare>& share, std::vector<Index>& ghosts) {
    share_ = share;
    for (detail::PlaceLists* lists : {&due_, &due_ghosts_, &told_}) lists->clear(ranks_.size());
    std::vector<bool> is_awaited(patches_.size());
    const auto first_ghost = static_cast<Index>(share_->size() + ghosts.size());
    std::vector<Index> kept;
    each_named([&](std::size_t rank, std::size_t p, Index place, Index at) {
      const std::size_t owner = share_->owner(place);
      const bool is_mine = rank == ranks_.rank(), is_ghost = at != place;
      if (!is_mine && owner != ranks_.rank()) return;
      if (is_ghost) kept.push_back(at);
      if (rank == owner) return;
      const Index here = share_->here(place), due = is_ghost ? first_ghost + static_cast<Index>(kept.size()) - 1 : here;
      detail::PlaceLists& lists = is_ghost ? due_ghosts_ : due_;
      if (is_mine)
        lists.to[owner].push_back(due), told_.from[owner].push_back(here), is_awaited[p] = true;
      else
        lists.from[rank].push_back(due), told_.to[rank].push_back(here);
    });
    list_own_patches(is_awaited);
    for (auto* lists : {&told_.to, &told_.from})
      for (std::vector<Index>& places : *lists) places = detail::ascending(std::move(places));
    if (deal_.size() > 0) own_ghosts_ = {patches_[deal_.first()].first_ghost, patches_[deal_.last() - 1].last_ghost};
    patches_.keep(deal_.first(), deal_.last(), kept, first_ghost, *share_);
    if (deal_.size() > 0) ghosts_here_ = patches_[deal_.first()].first_ghost;
    for (Block& block : elements_.blocks)
      for (auto& corner : block.nodes)
        for (Index& place : corner) place = deal_.size() > 0 ? here(place) : 0;
    if constexpr (averages_volume)
      volume_.each_field([&](auto& field, auto usual) {
        std::decay_t<decltype(field)> of_kept(first_ghost + kept.size(), usual);
        share_->each_kept([&](std::size_t place, std::size_t here) { of_kept[here] = field[place]; });
        for (std::size_t k = 0; k < kept.size(); ++k) of_kept[first_ghost + k] = field[kept[k]];
        field = std::move(of_kept);
      });
    ghosts.insert(ghosts.end(), kept.begin(), kept.end());
  }
  /// Leaves the states of the elements of other processes to them.
  void keep_own() {
    if (!deal_.is_dealt()) return;
    elements_.blocks.keep(first_block(deal_.first()), first_block(deal_.last()));
    elements_.order.keep(first_place(), last_place());
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.same(detail::name_of<RunningPart>(), elements_.size, order());
    serialize_blocks(archive);
    if constexpr (averages_volume)
      volume_.each_remembered([&](auto& field, auto usual) { serialize_at_nodes(archive, field, usual); });
    archive(cloud_, births_, newly_deleted_, deletions_);
  }

 private:
  /// Fills the blocks with the places of their nodes and cuts them into patches.
  template <class Cells>
  void lay_out(const Cells& cells, Nodes& nodes) {
    auto& blocks = elements_.blocks;
    blocks.resize(blocks_of(size()));
    std::vector<Index> corners;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      std::array<std::array<Index, n>, width> in_lanes;
      for (std::size_t l = 0; l < width; ++l)  // idle lanes repeat the last element
        in_lanes[l] = elements_.take(cells, std::min(b * width + l, size() - 1));
      for (std::size_t i = 0; i < n; ++i)
        for (const auto& cell : in_lanes) corners.push_back(nodes.place(cell[i]));
    }
    const auto unnamed = std::find(nodes.mass().begin(), nodes.mass().end(), 0) - nodes.mass().begin();
    patches_ = detail::Patches(corners, blocks.size(), width, static_cast<Index>(unnamed), nodes.places());
    nodes.add_ghosts(patches_.sources());
    for (std::size_t b = 0; b < blocks.size(); ++b)
      for (std::size_t i = 0; i < n; ++i) std::copy_n(&corners[(b * n + i) * width], width, blocks[b].nodes[i].data());
  }

  /// Sets the elements of a block at rest and gives their masses to the nodes.
  template <class Cells>
  void begin(std::size_t b, Nodes& nodes, const Cells& cells) {
    Block& block = elements_.blocks[b];
    const Nodal<T, E::nodes> x = gather<T, n>(nodes.motion().position, block.nodes);
    const auto given = [&] {
      if constexpr (sees_neighbours)
        return element().begin(block.state, material(), x, is_born ? T(0.0) : elements_.in_lanes(b, cells.volumes));
      else
        return (void)cells, elements_.begin_block(b, x, nodes.motion().position);
    }();
    const T mass = mass_of(given);
    T own = mass;
    if constexpr (scales_mass) own = mass / block.state.mass_factor;
    if constexpr (is_born) block.removal.alive = T(0.0);
    if constexpr (erodes) block.removal.energy = detail::stored_energy(material(), T(T(static_cast<double>(n)) * own));
    if constexpr (Elements::has_geometry)
      block.removal.reference.inverse = detail::inverse_of_columns(detail::element_axes<E, T>(x));
    const bool well_shaped = detail::are_well_shaped<E, T>(x);
    for (std::size_t l = 0; l < count(b); ++l) {
      const std::size_t place = b * width + l;
      const std::array<Index, n> cell = elements_.cell(nodes, place);
      detail::check_cell(elements_, nodes, place, cell, well_shaped);
      proportions_.add(elements_.order[place], nodes, cell, material());
      if constexpr (!is_born) detail::check_mass(elements_, nodes, place, static_cast<double>(lane(mass, l)));
      detail::check_direction(elements_, nodes, place, block.state, l);
      const std::array<double, n> shares = detail::corner_shares(cell, Elements::merges);
      for (std::size_t i = 0; i < n; ++i) {
        nodes.add_mass(cell[i], shares[i] * static_cast<double>(lane(mass, l)));
        if constexpr (turns_nodes<E>()) nodes.add_inertia(cell[i], static_cast<double>(lane(given.inertia, l)));
      }
      const auto corners = static_cast<double>(n);
      mass_ += corners * static_cast<double>(lane(own, l));
      if constexpr (scales_mass)
        scaled_.add(elements_.order[place], corners * static_cast<double>(lane(mass, l)),
                    corners * static_cast<double>(lane(own, l)), static_cast<double>(lane(block.state.mass_factor, l)));
    }
  }
  static double now() {
    if constexpr (std::is_same_v<Ranks, Alone>)
      return 0;
    else
      return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  template <class F>
  void timed(const F& f) {
    const double begin = now();
    f();
    seconds_ += now() - begin;
  }
  static T mass_of(const T& mass) { return mass; }
  static T mass_of(const NodalInertia<T>& given) { return given.mass; }

  /// f(a span of numbers) for the numbers of a block that a step changes.
  template <class F>
  static void each_number(Block& block, const F& f) {
    visit_numbers<T>(block.state, block.state, [&](auto numbers, auto) { f(numbers); });
    if constexpr (erodes) f(numbers_of<T>(block.removal));
  }
  template <class Archive>
  void serialize_blocks(Archive& archive) {
    const auto keep = [&](auto numbers) { archive(numbers); };
    if (deal_.is_dealt()) return serialize_dealt_blocks(archive, keep);
    for (Block& block : elements_.blocks) {
      archive.same(block.nodes);
      each_number(block, keep);
    }
  }
  /// The same bytes, process after process.
  template <class Archive, class Keep>
  void serialize_dealt_blocks(Archive& archive, const Keep& keep) {
    Block of_others = *blocks().begin();
    const auto append = [](std::string& bytes, const void* from, std::size_t count) {
      bytes.append(static_cast<const char*>(from), count);
    };
    for (std::size_t r = 0; r < ranks_.size(); ++r) {
      const std::size_t first = first_block(deal_.first_of(r)), last = first_block(deal_.last_of(r));
      const bool is_mine = r == ranks_.rank();
      std::string nodes, numbers;
      if (is_mine)
        for (std::size_t b = first; b < last; ++b) {
          Block& block = blocks()[b];
          auto places = block.nodes;
          if (share_)
            for (auto& corner : places)
              for (Index& place : corner) place = among_all(place);
          append(nodes, &places, sizeof places);
          if (!archive.reads())
            each_number(block, [&](const auto& some) { append(numbers, some.data(), some.size_bytes()); });
        }
      nodes = detail::of_rank(ranks_, r, std::move(nodes));
      for (std::size_t at = 0; at < nodes.size(); at += sizeof of_others.nodes)
        archive.same(std::string_view(nodes).substr(at, sizeof of_others.nodes));
      if (archive.reads()) {
        for (std::size_t b = first; b < last; ++b) each_number(is_mine ? blocks()[b] : of_others, keep);
      } else {
        numbers = detail::of_rank(ranks_, r, std::move(numbers));
        keep(std::span(numbers));
      }
    }
  }
  std::size_t first_block(std::size_t p) const {
    return p < patches_.size() ? patches_[p].first_block : blocks().size();
  }

  /// Adds the volumes of the elements of a patch at its nodes.
  void add_volumes(std::size_t p, Nodes& nodes) {
    patches_.load(patches_[p], nodes);
    detail::add_volumes(elements_, patches_[p], nodes.motion(), volume_);
  }
  auto start_trade_of_volumes() {
    if constexpr (Elements::loses_elements)
      return ranks_.start_trade(due_, volume_.sum(), due_ghosts_, volume_.sum(), due_, volume_.reference(), due_ghosts_,
                                volume_.reference());
    else
      return ranks_.start_trade(due_, volume_.sum(), due_ghosts_, volume_.sum());
  }
  /// Adds them up there, of which patches learn the ratios.
  void update_volumes() {
    if (share_) {
      volume_.update(patches_, {deal_.first(), deal_.last()}, [&](auto& ratio) { ranks_.trade(told_, ratio); });
    } else {
      volume_.exchange(deal_, ranks_);
      volume_.update(patches_);
    }
  }
  /// A field at the places of all nodes and ghosts, of which this process may keep some.
  template <class Archive, class T1>
  void serialize_at_nodes(Archive& archive, std::vector<T1>& field, T1 usual) {
    if (!share_) return archive(field);
    std::vector<T1> all(deal_.places(), usual);
    const std::size_t ghosts = own_ghosts_.last - own_ghosts_.first;
    const auto at = [](auto& list, std::size_t place) { return list.begin() + static_cast<std::ptrdiff_t>(place); };
    std::copy(at(field, share_->own().first), at(field, share_->own().last), at(all, share_->own_among_all().first));
    std::copy_n(at(field, ghosts_here_), ghosts, at(all, own_ghosts_.first));
    share_->exchange(ranks_, all);
    deal_.exchange_ghosts(ranks_, all);
    archive(all);
    if (!archive.reads()) return;
    share_->each_kept([&](std::size_t place, std::size_t here) { field[here] = all[place]; });
    std::copy_n(at(all, own_ghosts_.first), ghosts, at(field, ghosts_here_));
  }
  /// The place here of a node or ghost of an own patch by that among all, and back.
  Index here(Index place) const {
    return place < own_ghosts_.first ? share_->here(place)
                                     : static_cast<Index>(place - own_ghosts_.first + ghosts_here_);
  }
  Index among_all(Index here) const {
    return here < share_->size() ? share_->among_all(here)
                                 : static_cast<Index>(here - ghosts_here_ + own_ghosts_.first);
  }
  /// The slowest elements of own patches, if any element is left there, by their numbers, which other processes have
  /// not.
  void name_slowest() {
    for (std::size_t p = deal_.first(); p < deal_.last(); ++p)
      if (detail::Outcome& outcome = outcomes_[p]; outcome.critical_rate > 0)
        outcome.slowest = elements_.order[outcome.slowest];
  }
  auto start_trade_of_forces(Nodes& nodes) {
    auto& motion = nodes.motion();
    if constexpr (Nodes::nodes_turn)
      return ranks_.start_trade(due_, nodes.force(), due_ghosts_, motion.force, due_, nodes.moment(), due_ghosts_,
                                motion.moment);
    else
      return ranks_.start_trade(due_, nodes.force(), due_ghosts_, motion.force);
  }
  /// f(patch) for the patches of this process. Those on which others wait come first, and what they tell these is on
  /// its way while the rest are at work.
  template <class Execution, class F, class StartTrade>
  void work(const Execution& execution, const F& f, const StartTrade& start_trade) {
    const auto work_on = [&](std::size_t first, std::size_t last) {
      timed([&] { execution.for_each(last - first, [&](std::size_t k) { f(own_patches_[first + k]); }); });
    };
    work_on(0, awaited_);
    auto trade = start_trade();
    work_on(awaited_, own_patches_.size());
    trade.finish();
  }
  void list_own_patches(const std::vector<bool>& is_awaited) {
    own_patches_.resize(deal_.size());
    std::iota(own_patches_.begin(), own_patches_.end(), deal_.first());
    const auto rest =
        std::stable_partition(own_patches_.begin(), own_patches_.end(), [&](std::size_t p) { return is_awaited[p]; });
    awaited_ = static_cast<std::size_t>(rest - own_patches_.begin());
  }
  /// Gives all processes the outcomes of the patches of each, and the forces if all move all nodes.
  void exchange(Nodes& nodes) {
    if (!deal_.is_dealt()) return;
    deal_.exchange_patches(ranks_, outcomes_);
    if (share_) return;
    auto& motion = nodes.motion();
    deal_.exchange_nodes(ranks_, nodes.force());
    deal_.exchange_ghosts(ranks_, motion.force);
    if constexpr (Nodes::nodes_turn) {
      deal_.exchange_nodes(ranks_, nodes.moment());
      deal_.exchange_ghosts(ranks_, motion.moment);
    }
  }

  /// f(rank, patch, the place of a node, that of the node or ghost where its elements add forces) for the patches of
  /// each.
  template <class F>
  void each_named(const F& f) const {
    for (std::size_t r = 0; r < ranks_.size(); ++r)
      for (std::size_t p = deal_.first_of(r); p < deal_.last_of(r); ++p) {
        const detail::Patch& patch = patches_[p];
        for (Index i = patch.first_node; i < patch.last_node; ++i) f(r, p, i, i);
        for (Index g = patch.first_ghost; g < patch.last_ghost; ++g) f(r, p, patches_.source(g), g);
      }
  }
  /// The places of the elements of this process.
  std::size_t first_place() const { return std::min(first_block(deal_.first()) * width, size()); }
  std::size_t last_place() const { return std::min(first_block(deal_.last()) * width, size()); }
  /// The numbers of all elements, place by place.
  std::vector<Index> order() const {
    std::vector<Index> all(size());
    std::copy(elements_.order.begin(), elements_.order.end(),
              all.begin() + static_cast<std::ptrdiff_t>(elements_.order.first()));
    deal_.exchange_elements(ranks_, all);
    return all;
  }
  /// Values that each process has of its elements, place by place, by the numbers of all elements.
  template <class To = void, class Value>
  auto in_order(std::vector<Value> values) const {
    deal_.exchange_elements(ranks_, values);
    const std::vector<Index> order = this->order();
    std::vector<std::conditional_t<std::is_void_v<To>, Value, To>> ordered(values.size());
    for (std::size_t p = 0; p < size(); ++p) ordered[order[p]] = values[p];
    return ordered;
  }
  std::string describe_at(const Nodes& nodes, std::size_t place) const {
    if (!deal_.is_dealt()) return elements_.describe(nodes, place);
    const std::size_t b = place / width;
    const bool is_mine = deal_.size() > 0 && place < size() && b >= blocks().first() && b < blocks().last();
    return detail::first_of_ranks(ranks_, is_mine ? elements_.describe(nodes, place) : std::string{});
  }

  /// Books the work of the patches in their order and returns the least stable step.
  StableStep book(const Nodes& nodes, Ledger& ledger) {
    StableStep stable{.part = number()};
    detail::Deletions deletions;
    double internal = 0, hourglass = 0, bulk_viscosity = 0;
    for (const detail::Outcome& outcome : outcomes_) {
      if (!(outcome.inverted_volume > 0))
        detail::explain_inversion(describe_at(nodes, outcome.inverted), outcome.inverted_volume);
      if (const double dt = 1 / outcome.critical_rate; dt < stable.dt) stable.dt = dt, stable.element = outcome.slowest;
      internal += outcome.internal_work;
      hourglass += outcome.hourglass_work;
      bulk_viscosity += outcome.bulk_viscosity_work;
      deletions.add(outcome.deletions);
    }
    newly_deleted_ = deletions;
    deletions_.add(deletions);
    if (deletions.count > 0) {
      ledger.internal.book(-deletions.energy);
      ledger.eroded.book(deletions.energy);
    }
    ledger.internal.book(internal);
    ledger.hourglass.book(hourglass);
    ledger.bulk_viscosity.book(bulk_viscosity);
    return stable;
  }

  struct Nothing {
    void serialize(auto&) {}
  };
  using Volume = std::conditional_t<averages_volume, detail::NodalVolume<LaneOf<T>, Elements::loses_elements>, Nothing>;
  struct NothingScaled {};

  Elements elements_;
  [[no_unique_address]] Ranks ranks_;
  detail::Deal deal_;
  // If processes share the nodes: what is added up, at nodes and at ghosts, goes to the owners of the nodes, and sums
  // go back; and where ghosts of own patches are, among all and here.
  std::shared_ptr<const detail::NodeShare> share_;
  detail::PlaceLists due_, due_ghosts_, told_;
  std::vector<std::size_t> own_patches_;
  std::size_t awaited_ = 0;  // of these, the first ones
  detail::Places own_ghosts_;
  std::size_t ghosts_here_ = 0;
  double mass_ = 0, seconds_ = 0;
  detail::Patches patches_;
  std::vector<detail::Outcome> outcomes_;
  [[no_unique_address]] std::conditional_t<scales_mass, detail::ScaledMass, NothingScaled> scaled_;
  [[no_unique_address]] Volume volume_;
  [[no_unique_address]] std::conditional_t<sees_neighbours, detail::Cloud<T>, Nothing> cloud_;
  [[no_unique_address]] std::conditional_t<is_born, detail::Births, detail::NoBirths> births_;
  [[no_unique_address]] detail::PlateProportions<E, M> proportions_;
  detail::Deletions newly_deleted_{}, deletions_{};
};

}  // namespace strike
