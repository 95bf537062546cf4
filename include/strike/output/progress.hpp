#pragma once
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>

#include <strike/cxx20.hpp>

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

#include <strike/output/wall_clock.hpp>
#include <strike/process.hpp>
#include <strike/range.hpp>

namespace strike {

/// Condition under which the progress line is shown.
enum class Show { on_terminal, always, never };

/// Options of a progress line.
struct ProgressOptions {
  double end = 0;                 ///< time at which the run ends; 0: the end of its `until` [time]
  std::string unit = {};          ///< of time
  Show show = Show::on_terminal;  ///< by default only on a terminal
  std::FILE* stream = stderr;

  void ranges(const auto& number) const { number("end", end, range::or_infinite(range::not_negative)); }
};

/// An observer with a progress line on a terminal: percent, time, step number, dt, energy error, estimated rest of the
/// wall-clock time.
///   run.until(0.08, Progress{{.unit = "ms"}});
/// The line is drawn at most four times a second, and at the end; the clock is read about forty times a second; a call
/// between costs two comparisons. A loop of your own calls update(time, step, dt, error), where the relative error is a
/// number, or a function that is called only if a line is drawn.
class Progress {
 public:
  /// Error: a number out of its range.
  explicit Progress(const ProgressOptions& options = {}) : options_(detail::in_range(options)) {
    bool shown = options.show == Show::always;
#if __has_include(<unistd.h>)
    if (options.show == Show::on_terminal) shown = ::isatty(::fileno(options.stream)) == 1;
#endif
    if (!shown || !detail::this_process.is_first) next_look_ = never;
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() {
    if (drawn_) std::fputc('\n', options_.stream);
  }

  template <class Run>
  void operator()(const Run& run) {
    if (!(options_.end > 0)) options_.end = run.end();
    update(run.time(), run.steps(), run.dt(), [&] { return run.energy().error(); });
  }
  template <class Number>
    requires std::convertible_to<Number, double> || std::invocable<Number&>
  void update(double time, std::uint64_t step, double dt, Number&& energy_error) {
    if (++calls_ < next_look_ && (time < options_.end || next_look_ == never)) return;
    const double now = seconds();
    // Looks spread over calls so that about 25 ms lie between two.
    const double since_look = now - last_look_;
    stride_ = since_look < 0.0125 ? 2 * stride_ : since_look > 0.05 && stride_ > 1 ? stride_ / 2 : stride_;
    next_look_ = calls_ + stride_;
    last_look_ = now;
    if (drawn_ && now - last_drawn_ < 0.25 && time < options_.end) return;
    last_drawn_ = now;
    if constexpr (std::invocable<Number&>)
      draw(time, step, dt, energy_error(), now);
    else
      draw(time, step, dt, energy_error, now);
  }

 private:
  static constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();

  double seconds() const { return detail::wall_clock() - start_; }

  void draw(double time, std::uint64_t step, double dt, double energy_error, double now) {
    const double done = options_.end > 0 ? time / options_.end : 1;
    char rest[48] = "";
    if (done >= 1)
      std::snprintf(rest, sizeof rest, "%s in all", duration(now).c_str());
    else if (done > 0 && now > 0.5)
      std::snprintf(rest, sizeof rest, "%s left", duration(now / done - now).c_str());
    std::fprintf(options_.stream,
                 "\r\033[K%3.0f %%  t = %.4g of %.4g %s  step %llu  dt = %.3g  energy error %.2g %%  %s",
                 std::floor(100 * done), time, options_.end, options_.unit.c_str(),
                 static_cast<unsigned long long>(step), dt, 100 * energy_error, rest);
    std::fflush(options_.stream);
    drawn_ = true;
  }

  static std::string duration(double s) {
    char text[32];
    if (s < 90)
      std::snprintf(text, sizeof text, "%.0f s", s);
    else if (s < 5400)
      std::snprintf(text, sizeof text, "%.0f min", s / 60);
    else
      std::snprintf(text, sizeof text, "%.1f h", s / 3600);
    return text;
  }

  ProgressOptions options_;
  double start_ = detail::wall_clock();
  std::uint64_t calls_ = 0, next_look_ = 1, stride_ = 1;
  double last_look_ = 0, last_drawn_ = 0;
  bool drawn_ = false;
};

}  // namespace strike
