#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/draw/chart.hpp>
#include <strike/draw/picture.hpp>
#include <strike/error.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/output/history.hpp>
#include <strike/output/results.hpp>
#include <strike/range.hpp>
#include <strike/text.hpp>
#include <strike/verify/distortion.hpp>
#include <strike/verify/eigenmodes.hpp>
#include <strike/verify/material_point.hpp>
#include <strike/verify/patch_test.hpp>

namespace strike::verify {

// Curves of a material point: any type with these four members serves.

/// Stress over logarithmic strain, along x.
struct AxialCurve {
  static constexpr const char *x_name = "strain xx", *y_name = "stress xx";
  static double x(const auto& record) { return record.strain().xx; }
  static double y(const auto& record) { return record.stress.xx; }
};
/// Shear stress over the shear of simple_shear.
struct ShearCurve {
  static constexpr const char *x_name = "shear", *y_name = "stress xy";
  static double x(const auto& record) { return record.deformation_gradient(0, 1); }
  static double y(const auto& record) { return record.stress.xy; }
};
/// Pressure over volumetric strain, ln V/V0.
struct VolumeCurve {
  static constexpr const char *x_name = "volumetric strain", *y_name = "pressure";
  static double x(const auto& record) { return std::log(record.relative_volume()); }
  static double y(const auto& record) { return -trace(record.stress) / 3; }
};
inline constexpr AxialCurve axial;
inline constexpr ShearCurve shear;
inline constexpr VolumeCurve volumetric;

/// The curve of a material point beside that of a formula.
struct CurveStudy {
  std::vector<double> x, y;
  std::vector<double> expected;  ///< NaN where the formula says nothing

  double largest() const { return extreme(expected); }
  /// |y - expected| of each record, relative to the largest expected.
  std::vector<double> errors() const {
    std::vector<double> all;
    const double scale = largest() > 0 ? largest() : extreme(y);
    for (std::size_t i = 0; i < y.size(); ++i)
      all.push_back(std::isnan(expected[i]) || y[i] == expected[i] ? 0 : std::abs(y[i] - expected[i]) / scale);
    return all;
  }
  /// The largest; NaN if the formula says nothing anywhere.
  double error() const {
    if (std::none_of(expected.begin(), expected.end(), [](double e) { return !std::isnan(e); }))
      return std::numeric_limits<double>::quiet_NaN();
    double largest = 0;
    for (const double e : errors())
      if (largest <= e || std::isnan(e)) largest = e;  // NaN stays
    return largest;
  }

 private:
  static double extreme(const std::vector<double>& values) {
    double largest = 0;
    for (const double v : values)
      if (std::abs(v) > largest) largest = std::abs(v);
    return largest;
  }
};

/// Compares a history with a formula: of the record, or of the x of the curve; NaN where it says nothing.
template <class M, class Curve, class Formula>
CurveStudy compare(const std::vector<Record<M>>& history, const Curve& curve, const Formula& formula) {
  CurveStudy study;
  for (const Record<M>& record : history) {
    study.x.push_back(curve.x(record)), study.y.push_back(curve.y(record));
    if constexpr (std::invocable<Formula, const Record<M>&>)
      study.expected.push_back(formula(record));
    else
      study.expected.push_back(formula(study.x.back()));
  }
  return study;
}

/// Tolerances of the studies of an element.
struct ElementTolerances {
  double patch = 1e-9, rotation = 1e-9;  ///< rounding
  double frequency = 1e-4;  ///< of a rigid motion, over the highest: the root of the rounding, with a margin
  double stiffness =
      1e-6;  ///< of uniform_strain_error: the rounding of the difference between two steps of a viscous control
  double step = 1e-6;  ///< by which a claimed step may exceed the exact one, relative

  void ranges(const auto& number) const {
    number("patch", patch, range::or_infinite(range::not_negative));
    number("rotation", rotation, range::or_infinite(range::not_negative));
    number("frequency", frequency, range::or_infinite(range::not_negative));
    number("stiffness", stiffness, range::or_infinite(range::not_negative));
    number("step", step, range::or_infinite(range::not_negative));
  }
};

/// Studies of materials and elements, as printed tables, CSV files, charts and pictures. The exit code of the program
/// follows from its expectations:
///   Workbench bench{"out"};
///   bench.follow("tension", copper, uniaxial_stress({.strain = 0.1}), axial, [](double e) { return E * e; }, 1e-3);
///   bench.element("Hex8", Hex8{}, copper);
///   return bench.finish();
/// A study that ends with an Error has failed and does not stop the others.
class Workbench {
 public:
  /// Files go into the folder, which is made; "" is the present one.
  explicit Workbench(std::string folder = "") : folder_(std::move(folder)) {}

  /// One material point along a path: NAME.csv with its records and NAME.svg.
  template <class M, class Curve>
  void follow(const std::string& name, const M& material, const Path& path, const Curve& curve) {
    follow(
        name, material, path, curve, [](double) { return std::numeric_limits<double>::quiet_NaN(); }, 0);
  }
  /// A curve beside a formula, of the curve's x or of the record, that must hold within `tolerance` times its largest
  /// value; NAME_error.svg shows the difference.
  template <class M, class Curve, class Formula>
  void follow(const std::string& name, const M& material, const Path& path, const Curve& curve, const Formula& formula,
              double tolerance) {
    attempt(name, [&] {
      const auto history = MaterialPoint{material}.run(path);
      verify::write(file(name, ".csv"), history);
      report(name, compare(history, curve, formula), curve.x_name, curve.y_name, tolerance);
    });
  }

  /// All studies of a hexahedron, tetrahedron, quadrilateral or triangular plate that stands at the undistorted
  /// `corners`: modes, steps, patch tests, rotation, and distortions until it fails.
  template <class E, class M>
  void element(const std::string& name, const E& element, const M& material,
               const Nodal<double, E::nodes>& corners = unit_corners<E>(), const SweepOptions& options = {},
               const ElementTolerances& tolerances = {}) {
    std::printf("\n%s\n", name.c_str());
    attempt(name, [&] {
      detail::check_ranges(options), detail::check_ranges(tolerances);
      const SingleElement single{element, material, corners};
      const std::vector<Eigenmode> modes = eigenmodes(single);
      report(name, modes, tolerances);
      draw<E>(name, modes, corners);
      expect_below(name + ": stiffness under uniform strains", uniform_strain_error(single), tolerances.stiffness,
                   "V C of the material");
      report(name, step_study(single), step_in_compression(single), tolerances);
      report(name, patch_tests(element, material), tolerances);
      report(name, rotation_study(element, material, corners), tolerances);
      std::vector<DistortionSweep> sweeps;
      for (const Distortion& distortion : distortions_of<E>())
        sweeps.push_back(distortion_sweep(element, material, corners, distortion, options));
      report(name, sweeps, tolerances);
    });
  }

  /// A number beside its reference.
  void expect(Result result) { results_.add(std::move(result)); }
  /// A value that must lie below a limit, under the name of what is measured.
  void expect_below(const std::string& quantity, double value, double limit, const std::string& source) {
    expect({quantity, value, "1", 0, limit, source});
  }

  const Results& results() const { return results_; }

  /// Prints everything expected, writes it to results.csv, and returns the program's exit code: 0, or 1 after one
  /// sentence about the expectations that are not met.
  [[nodiscard]] int finish() const {
    std::printf("\n");
    results_.print();
    results_.write(path("results.csv"));
    const std::string sentence = failure();
    if (!sentence.empty()) std::fprintf(stderr, "%s\n", sentence.c_str());
    return sentence.empty() ? 0 : 1;
  }
  /// The sentence; empty if all was met.
  [[gnu::cold]] std::string failure() const {
    std::size_t failed = 0;
    const Result* first = nullptr;
    for (const Result& r : results_.rows())
      if (!r.passes() && failed++ == 0) first = &r;
    if (failed == 0) return {};
    return detail::joined({"strike: ", std::to_string(failed), " of ", std::to_string(results_.rows().size()),
                           " expectations are not met, the first of them '", first->quantity, "', which is ",
                           detail::text(first->value), " where ", detail::text(first->reference), " within ",
                           detail::text(first->tolerance),
                           " was expected: correct the law or the element, or what you expect of it."});
  }

 private:
  template <class F>
  void attempt(const std::string& name, F study) {
    try {
      study();
    } catch (const Error& error) {
      std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
      expect({.quantity = name + ": runs to the end",
              .value = std::numeric_limits<double>::quiet_NaN(),
              .reference = 0,
              .tolerance = 0,
              .source = error.what()});
    }
  }

  std::string path(const std::string& file) const { return folder_.empty() ? file : folder_ + "/" + file; }
  std::string file(std::string name, const char* ending) const {
    std::replace(name.begin(), name.end(), ' ', '_');
    return path(name + ending);
  }

  template <class E>
  static std::vector<Distortion> distortions_of() {
    using namespace distortions;
    if constexpr (E::nodes == 3)
      return {skew};
    else if constexpr (E::nodes == 4 && !turns_nodes<E>())
      return {skew, twist, flatten};
    else
      return {skew, taper, twist, dent};
  }

  [[gnu::cold]] void report(const std::string& name, const CurveStudy& study, const char* x, const char* y,
                            double tolerance) {
    const double error = study.error();
    const bool known = !std::isnan(error) || tolerance > 0;
    Chart chart{{.title = name, .x = {.label = x}, .y = {.label = y}}};
    chart.curve("one point", study.x, study.y);
    if (known) chart.curve("formula", study.x, study.expected, {.line = Line::dashed});
    chart.write(file(name, ".svg"));
    std::printf("%-24s %zu steps, to %s %g, %s %g", name.c_str(), study.x.size() - 1, x, study.x.back(), y,
                study.y.back());
    if (known) {
      std::printf(", largest difference from the formula %.1e", error);
      Chart errors{{.title = name + ": difference from the formula",
                    .x = {.label = x},
                    .y = {.label = "share of the largest value"}}};
      errors.curve("", study.x, study.errors());
      errors.write(file(name + " error", ".svg"));
      expect_below(name + ": error", error, tolerance, "the formula");
    }
    std::printf("\n");
  }

  [[gnu::cold]] void report(const std::string& name, const std::vector<Eigenmode>& modes,
                            const ElementTolerances& tolerances) {
    std::printf("  %5s  %-9s  %12s  %12s  %14s\n", "modes", "kind", "frequency", "decay", "critical step");
    History csv(file(name + " modes", ".csv"), {{"kind"}, {"frequency"}, {"decay"}, {"critical step"}});
    const double highest = modes.back().frequency;
    const auto same = [&](double a, double b) { return std::abs(a - b) <= 1e-6 * highest; };
    std::size_t rigid = 0;
    double rigid_frequency = 0;
    for (std::size_t i = 0; i < modes.size();) {
      const auto& mode = modes[i];
      std::size_t count = 0;
      for (; i < modes.size() && modes[i].kind == mode.kind && same(modes[i].frequency, mode.frequency) &&
             same(modes[i].decay, mode.decay);
           ++i, ++count)
        csv.row(static_cast<int>(modes[i].kind), modes[i].frequency, modes[i].decay, modes[i].critical_step());
      const bool damped = mode.decay > 1e-9 * highest;
      std::printf("  %5zu  %-9s  %12.6g  %12.6g  %14.6g\n", count, to_string(mode.kind), mode.frequency,
                  damped ? mode.decay : 0, damped || mode.frequency > 0 ? mode.critical_step() : INFINITY);
      if (mode.kind == ModeKind::rigid) rigid += count, rigid_frequency = std::max(rigid_frequency, mode.frequency);
    }
    expect({name + ": rigid modes", static_cast<double>(rigid), "1", 6, 0, "three translations, three rotations"});
    expect_below(name + ": frequency of rigid modes", rigid_frequency / highest, tolerances.frequency, "no strain");
  }

  /// Every mode but the rigid ones, six to a row, coloured by frequency.
  template <class E>
  [[gnu::cold]] void draw(const std::string& name, const std::vector<Eigenmode>& modes,
                          const Nodal<double, E::nodes>& corners) {
    constexpr int n = E::nodes;
    const Nodal<double, n> x = corners.colwise() - corners.rowwise().mean();
    const double size = (corners.rowwise().maxCoeff() - corners.rowwise().minCoeff()).maxCoeff();
    Picture picture{{.title = name + ": modes",
                     .caption = "From the lowest frequency at the upper left. Rotations of nodes are not drawn.",
                     .quantity = "frequency",
                     .from = {1, -4, 2}}};
    std::size_t drawn = 0;
    for (const auto& mode : modes) {
      if (mode.kind == ModeKind::rigid) continue;
      const Nodal<double, n> u = mode.shape.leftCols(n);
      const double column = static_cast<double>(drawn % 6), row = static_cast<double>(drawn / 6);
      const Eigen::Vector3d place = 2 * size * Eigen::Vector3d(column, 0, -row);
      std::vector<Eigen::Vector3d> positions;
      const double amplitude = 0.35 * size / std::max(u.colwise().norm().maxCoeff(), 1e-3);
      for (int i = 0; i < n; ++i) positions.push_back(place + x.col(i) + amplitude * u.col(i));
      const std::array value{mode.frequency};
      picture.add(faces<E>(), positions, value, Sides::both);
      ++drawn;
    }
    if (drawn > 0) picture.write(file(name + " modes", ".svg"));
  }
  template <class E>
  static std::vector<Face> faces() {
    std::vector<Face> all;
    if constexpr (E::nodes == 8)
      detail::append_faces<8>(all, {{0, 1, 2, 3, 4, 5, 6, 7}}, detail::hexahedron_faces, 0);
    else if constexpr (E::nodes == 3)
      all = triangle_surface({{0, 1, 2}});
    else if constexpr (turns_nodes<E>())
      all.push_back({{0, 1, 2, 3}, 0});
    else
      detail::append_faces<4>(all, {{0, 1, 2, 3}}, detail::tetrahedron_faces, 0);
    return all;
  }

  [[gnu::cold]] void report(const std::string& name, const StepStudy& rest, const StepStudy& squeezed,
                            const ElementTolerances& tolerances) {
    std::printf("\n  %-16s %12s %12s %12s %15s\n", "stable step", "claimed", "exact", "2/w_max", "exact/claimed");
    for (const auto& [state, step] : {std::pair{"at rest", rest}, {"in compression", squeezed}}) {
      std::printf("  %-16s %12.6g %12.6g %12.6g %15.4f\n", state, step.claimed, step.exact, step.undamped,
                  step.ratio());
      expect_below(detail::joined({name, ": step ", state, ", beyond the exact one"}), beyond(1 / step.ratio()),
                   tolerances.step, "2/w_max, damped");
    }
  }

  [[gnu::cold]] void report(const std::string& name, const std::vector<PatchResult>& patches,
                            const ElementTolerances& tolerances) {
    std::printf("\n  %-20s %18s %18s\n", "patch test", "error of stress", "of equilibrium");
    for (const PatchResult& patch : patches) {
      std::printf("  %-20s %18.1e %18.1e\n", patch.motion, patch.stress, patch.force);
      expect_below(detail::joined({name, ": patch test, ", patch.motion}), patch.error(), tolerances.patch,
                   "uniform stress");
    }
  }

  [[gnu::cold]] void report(const std::string& name, const RotationStudy& rotation,
                            const ElementTolerances& tolerances) {
    std::printf("\n  %.2f revolutions: force %.1e unstrained, error %.1e strained\n", rotation.revolutions,
                rotation.unstrained, rotation.strained);
    expect_below(name + ": force of a rotation", rotation.unstrained, tolerances.rotation, "no strain");
    expect_below(name + ": force that turns", rotation.strained, tolerances.rotation, "turned with it");
  }

  [[gnu::cold]] void report(const std::string& name, const std::vector<DistortionSweep>& sweeps,
                            const ElementTolerances& tolerances) {
    std::printf("\n  %-10s %8s  %-22s %-26s\n", "distortion", "aspect", "fails at", "least exact/claimed");
    Chart envelope{{.title = name + ": stability envelope",
                    .caption = "Below a curve the element is sound: not inverted, its step stable, its stiffness "
                               "under uniform strains right.",
                    .x = {.label = "aspect ratio", .scale = Scale::logarithmic},
                    .y = {.label = "distortion, share of the largest tried", .lower = 0, .upper = 1}}};
    for (const DistortionSweep& sweep : sweeps) {
      History csv(file(detail::joined({name, " ", sweep.distortion.name}), ".csv"),
                  {{"aspect ratio"},
                   {sweep.distortion.name, sweep.distortion.unit},
                   {"volume"},
                   {"claimed step"},
                   {"exact step"},
                   {"exact over claimed"},
                   {"error of uniform strains"},
                   {"soundness"}});
      Chart ratios{{.title = detail::joined({name, ": exact over claimed step"}),
                    .caption = "Below 1 the element claims a step at which it is unstable. A curve ends where the "
                               "element fails.",
                    .x = {.label = sweep.distortion.name, .unit = sweep.distortion.unit},
                    .y = {.label = "exact over claimed step"}}};
      ratios.reference(1, "unstable below");
      std::vector<double> aspects, shares;
      for (const DistortionLimit& limit : sweep.limits) {
        std::vector<double> amounts, ratio;
        double least = std::numeric_limits<double>::infinity();
        for (const DistortedElement& e : sweep.elements) {
          if (e.aspect != limit.aspect) continue;
          csv.row(e.aspect, e.amount, e.volume, e.claimed, e.exact, e.ratio(), e.uniform_error,
                  static_cast<int>(e.soundness));
          if (e.soundness == Soundness::inverted) continue;
          amounts.push_back(e.amount), ratio.push_back(e.ratio()), least = std::min(least, e.ratio());
        }
        char fails[48] = "not";
        if (limit.reason != Soundness::sound)
          std::snprintf(fails, sizeof fails, "%.4g %s %s", limit.amount,
                        sweep.distortion.unit == "1" ? "" : sweep.distortion.unit.c_str(), to_string(limit.reason));
        std::printf("  %-10s %8g  %-22s %-26.4f\n", sweep.distortion.name.c_str(), limit.aspect, fails, least);
        if (!amounts.empty()) ratios.curve("aspect " + detail::shortest(limit.aspect), amounts, ratio);
        aspects.push_back(limit.aspect), shares.push_back(limit.amount / sweep.distortion.largest);
      }
      expect_below(detail::joined({name, ": step under ", sweep.distortion.name, ", beyond the exact one"}),
                   beyond(1 / sweep.least_ratio()), tolerances.step, "2/w_max, damped");
      if (std::isfinite(sweep.least_ratio()))
        ratios.write(file(detail::joined({name, " ", sweep.distortion.name}), ".svg"));
      envelope.curve(detail::joined({sweep.distortion.name, " to ", detail::shortest(sweep.distortion.largest),
                                     sweep.distortion.unit == "1" ? "" : " " + sweep.distortion.unit}),
                     aspects, shares, {.marker = Marker::circle});
    }
    envelope.write(file(name + " envelope", ".svg"));
  }

  /// Excess of a ratio over 1, 0 below; NaN stays.
  static double beyond(double ratio) { return ratio < 1 ? 0 : ratio - 1; }

  std::string folder_;
  Results results_;
};

}  // namespace strike::verify
