#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include <strike/error.hpp>
#include <strike/output/archive.hpp>
#include <strike/output/file.hpp>
#include <strike/output/wall_clock.hpp>
#include <strike/process.hpp>
#include <strike/range.hpp>
#include <strike/text.hpp>

namespace strike {

namespace detail {

// A checkpoint file: head, states of the objects, tail, in the machine's formats of numbers.
struct CheckpointHead {
  char magic[8] = {'s', 't', 'r', 'i', 'k', 'e', 'c', 'p'};
  std::uint32_t version = 1;
  std::uint32_t byte_order = 0x01020304;
};
struct CheckpointTail {
  std::uint64_t scene = 0;     ///< Fingerprint
  std::uint64_t size = 0;      ///< of the states between head and tail [bytes]
  std::uint64_t checksum = 0;  ///< Hash of the states, piece by piece
};
inline constexpr std::size_t checkpoint_piece = 1 << 20;  // bytes

class CheckpointWriter final : public Archive {
 public:
  explicit CheckpointWriter(OutputFile& file) : Archive(false), file_(file) {
    const CheckpointHead head;
    file_.write({reinterpret_cast<const char*>(&head), sizeof head});
  }
  void finish() {
    flush();
    tail_.scene = scene_.value();
    tail_.checksum = hash_.value();
    file_.write({reinterpret_cast<const char*>(&tail_), sizeof tail_});
    file_.sync();
  }

 private:
  void bytes(void* from, std::size_t count) override {
    const char* at = static_cast<const char*>(from);
    while (count > 0) {
      const std::size_t now = std::min(count, checkpoint_piece - piece_.size());
      piece_.append(at, now);
      at += now, count -= now;
      if (piece_.size() == checkpoint_piece) flush();
    }
  }
  void note(const void* at, std::size_t count) override { scene_.add(at, count); }
  void flush() {
    hash_.add(piece_.data(), piece_.size());
    tail_.size += piece_.size();
    file_.write(piece_);
    piece_.clear();
  }

  OutputFile& file_;
  std::string piece_;
  Hash hash_, scene_;
  CheckpointTail tail_;
};

/// Verifies the checksum before restoring anything.
class CheckpointReader final : public Archive {
 public:
  /// Errors: no such file; not a checkpoint, of another format or machine, damaged, or of another scene.
  CheckpointReader(const std::string& path, std::uint64_t scene)
      : Archive(true), path_(path), file_{std::fopen(path.c_str(), "rb")} {
    if (!file_.stream) refuse("cannot be opened; give the path of one that a run has written");
    CheckpointHead head;
    const CheckpointHead ours;
    if (!get(&head, sizeof head) || std::memcmp(head.magic, ours.magic, sizeof head.magic) != 0)
      refuse("is none; give the path of a file that a Checkpoint has written");
    if (head.byte_order != ours.byte_order) refuse("is of another kind of machine; continue where it was written");
    if (head.version != ours.version)
      refuse(joined({"has the format ", std::to_string(head.version), " but this version of strike reads ",
                     std::to_string(ours.version), "; continue with the version that wrote it"}));
    if (read_tail().scene != scene)
      refuse(
          "is of another scene: its mesh, its items, their constants or its observers differ; continue with the "
          "program that wrote it");
    std::fseek(file_.stream, sizeof head, SEEK_SET);
  }

  void finish() const {
    if (left_ > 0) refuse("holds more than the scene has; start anew");
  }

 private:
  void allow(std::uint64_t count) override {
    if (count > left_) refuse("holds less than the scene has; start anew");
  }
  void bytes(void* to, std::size_t count) override {
    allow(count);
    get(to, count);
    left_ -= count;
  }
  bool get(void* to, std::size_t count) { return std::fread(to, 1, count, file_.stream) == count; }

  /// The tail of a file whose checksum fits.
  CheckpointTail read_tail() {
    Hash hash;
    CheckpointTail tail;
    std::string piece(checkpoint_piece + sizeof tail, '\0');
    std::size_t kept = 0;  // bytes held back, since they may be the tail
    for (std::size_t got = 1; got > 0;) {
      got = std::fread(piece.data() + kept, 1, piece.size() - kept, file_.stream);
      kept += got;
      if (kept < piece.size()) break;
      hash.add(piece.data(), checkpoint_piece);
      left_ += checkpoint_piece;
      piece.erase(0, checkpoint_piece), piece.resize(checkpoint_piece + sizeof tail);
      kept = sizeof tail;
    }
    if (kept >= sizeof tail) {
      hash.add(piece.data(), kept - sizeof tail);
      left_ += kept - sizeof tail;
      std::memcpy(&tail, piece.data() + kept - sizeof tail, sizeof tail);
    }
    if (kept < sizeof tail || tail.size != left_ || tail.checksum != hash.value())
      refuse("is cut short or damaged; take an older one, or start anew");
    return tail;
  }

  [[noreturn]] void refuse(const std::string& why) const {
    throw Error(joined({"strike: the checkpoint '", path_, "' ", why, "."}));
  }

  std::string path_;
  struct File {
    std::FILE* stream;
    ~File() {
      if (stream) std::fclose(stream);
    }
  };
  File file_;
  std::uint64_t left_ = 0;
};

/// Includes the type of a run, with its items and policies, in the fingerprint.
template <class Object>
void identify(Archive& archive, const Object& object) {
  if constexpr (requires { object.run.items(); })
    identify(archive, object.run);
  else if constexpr (requires { object.items(); })
    archive.same(name_of<Object>());
}
template <class... Objects>
std::uint64_t fingerprint_of(Objects&... objects) {
  Fingerprint fingerprint;
  (identify(fingerprint, objects), ...);
  fingerprint(objects...);
  return fingerprint.value();
}

/// Error: the motion of a run is not finite, so that no run could go on from it.
template <class Object>
void expect_finite(const Object& object, std::string_view consequence) {
  if constexpr (requires { object.run.positions(); }) {
    expect_finite(object.run, consequence);
  } else if constexpr (requires { object.positions(), object.velocities(); }) {
    for (const auto& [what, vectors] : {std::pair("position", object.positions()), {"velocity", object.velocities()}})
      for (std::size_t n = 0; n < vectors.size(); ++n)
        if (!vectors[n].allFinite())
          throw Error(joined({"strike: the ", what, " of node ", std::to_string(n), " is not finite", consequence}));
  }
}

/// True if every item of a run has a serialize function; else one sentence of the compiler.
template <class Object>
constexpr bool remembers() {
  if constexpr (requires { Object::template remembers<Archive>(); }) {
    constexpr bool all = Object::template remembers<Archive>();
    static_assert(all,
                  "strike: an item of this Scene has no function serialize for a checkpoint: give it template <class "
                  "Archive> void serialize(Archive& archive) { archive(...); }, with empty braces if it has no state.");
    return all;
  } else {
    return true;
  }
}

}  // namespace detail

/// Writes the states of a run, its history and film, and numbers of your own (see Archive) into one file with a version
/// and a checksum. Errors: a motion that is not finite; a disk that does not take the file. The old file stays then.
template <class... Objects>
void write_checkpoint(const std::string& path, Objects&... objects) {
  if constexpr ((detail::remembers<Objects>() && ...)) {
    const std::string stays =
        detail::joined({", so that the checkpoint '", path, "' is not written: go on from the one before."});
    (detail::expect_finite(objects, stays), ...);
    detail::replace_file(path, [&](detail::OutputFile& file) {
      detail::CheckpointWriter archive(file);
      (detail::identify(archive, objects), ...);
      archive(objects...);
      archive.finish();
    });
  }
}

/// Restores the states of the same objects, made anew by the same program. Errors, before anything is changed: no such
/// file; a damaged file; a file of another scene. Error, after it: a motion that is not finite.
template <class... Objects>
void read_checkpoint(const std::string& path, Objects&... objects) {
  if constexpr ((detail::remembers<Objects>() && ...)) {
    detail::CheckpointReader archive(path, detail::fingerprint_of(objects...));
    archive(objects...);
    archive.finish();
    const std::string there = detail::joined({" in the checkpoint '", path, "': take an older one, or start anew."});
    (detail::expect_finite(objects, there), ...);
  }
}

/// Start of a run: always anew, or from its checkpoint if there is one.
enum class Restart { never, if_there };

/// Times at which a Checkpoint is written: when either interval since the last has passed.
struct CheckpointOptions {
  double interval = std::numeric_limits<double>::infinity();  ///< of the run [time]
  double seconds = 60;                                        ///< of wall-clock time
  Restart restart = Restart::never;

  void ranges(const auto& number) const {
    number("interval", interval, range::or_infinite(range::positive));
    number("seconds", seconds, range::or_infinite(range::positive));
  }
};

/// An observer that saves a run, the observers of the same `until` and its companions to a file, from which the run
/// continues after any interruption with bitwise the same results:
///
///   History history{"history.csv", {{"time", "ms"}, {"length", "mm"}}};
///   run.until(0.08, Every{0.001, [&] { history.row(run.time(), length()); }},
///             Checkpoint{"bar.checkpoint", {.restart = Restart::if_there}, history});
///
/// Rows of a History after the checkpoint are removed and written anew, so that no row is missing or doubled. Constants
/// of materials and options of the run are not in the file: the program may change them in between.
template <class... Companions>
class Checkpoint {
 public:
  explicit Checkpoint(std::string path, Companions&... companions)
      : Checkpoint(std::move(path), CheckpointOptions{}, companions...) {}
  Checkpoint(std::string path, const CheckpointOptions& options, Companions&... companions)
      : path_(std::move(path)), options_(detail::in_range(options)), companions_(companions...) {}

  /// False if an item of a run has no function serialize; until(end, ...) says so in one sentence.
  template <class Run>
  static constexpr bool keeps = Run::template remembers<Archive>();

  void operator()() const {}  // `save` runs after the other observers
  /// Restores the run before it starts; true if there was a file.
  template <class Run, class Observers>
  bool resume(Run& run, Observers observers) {
    start_clocks(run);
    detail::remove_part_of(path_);
    if (options_.restart == Restart::never || !detail::first_says([&] { return detail::file_exists(path_); }))
      return false;
    All<Run, Observers> all{run, companions_, observers};
    read_checkpoint(path_, all);
    start_clocks(run);
    return true;
  }
  /// Writes the file if it is due: after each step, after the other observers.
  template <class Run, class Observers>
  void save(Run& run, Observers observers) {
    if (run.time() < next_ && !is_time()) return;
    All<Run, Observers> all{run, companions_, observers};
    write_checkpoint(path_, all);
    start_clocks(run);
  }

 private:
  /// By the clock of the first process.
  bool is_time() const {
    return alarm_ < std::numeric_limits<double>::infinity() &&
           detail::first_says([&] { return detail::wall_clock() >= alarm_; });
  }
  template <class Run>
  void start_clocks(const Run& run) {
    next_ = run.time() + options_.interval;
    alarm_ = detail::wall_clock() + options_.seconds;
  }

  /// The run, the companions, and the observers that have a state.
  template <class Run, class Observers>
  struct All {
    Run& run;
    std::tuple<Companions&...>& companions;
    Observers& observers;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(run);
      [&]<std::size_t... i>(std::index_sequence<i...>) {
        archive(std::get<i>(companions)...);
      }(std::index_sequence_for<Companions...>{});
      [&]<std::size_t... i>(std::index_sequence<i...>) {
        (keep(archive, std::get<i>(observers)), ...);
      }(std::make_index_sequence<std::tuple_size_v<Observers>>{});
    }

   private:
    template <class Archive, class Observer>
    static void keep(Archive& archive, Observer& observer) {
      if constexpr (requires { observer.serialize(archive); }) archive(observer);
    }
  };

  std::string path_;
  CheckpointOptions options_;
  std::tuple<Companions&...> companions_;
  double next_ = 0;
  double alarm_ = std::numeric_limits<double>::infinity();
};

}  // namespace strike
