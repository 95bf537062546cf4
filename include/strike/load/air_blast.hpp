#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/error.hpp>
#include <strike/load/kingery_bulmash.hpp>
#include <strike/load/loaded_faces.hpp>
#include <strike/range.hpp>
#include <strike/scalar/math.hpp>
#include <strike/text.hpp>

namespace strike {

/// Units of a run in those of SI.
struct BlastUnits {
  double mass = 1;      ///< kilograms
  double length = 1;    ///< metres
  double time = 1;      ///< seconds
  double pressure = 1;  ///< pascals

  void ranges(const auto& number) const {
    number("mass", mass, range::positive);
    number("length", length, range::positive);
    number("time", time, range::positive);
    number("pressure", pressure, range::positive);
  }
};

/// A charge of TNT in air at sea level.
struct Charge {
  double mass;             ///< of TNT [mass]
  Eigen::Vector3d centre;  ///< [length]
  double start = 0;        ///< when it detonates, which may be before the run [time]
  Burst burst = Burst::free_air;
  BlastUnits units{};
  double end = std::numeric_limits<double>::infinity();  ///< no pressure from here on [time]
  bool suction = true;  ///< after the positive phase the pressure falls below the air's, as Friedlander's formula does

  void ranges(const auto& number) const {
    number("mass", mass, range::positive);
    number("centre", centre, range::point);
    number("start", start, range::finite);
    number(units);
    number("end", end, range::or_infinite(range::finite));
  }

  /// The blast at a range [length], in the units of the charge (Hopkinson 1915, Cranz 1926: scaled by the cube root of
  /// the mass). Error: the scaled distance is outside of the formulas of Kingery and Bulmash.
  BlastWave wave(double range) const {
    const double root = std::cbrt(mass * units.mass), Z = range * units.length / root;
    const double nearest = detail::blast_fits(burst).nearest;
    if (!(Z >= nearest && Z <= detail::farthest_blast))
      throw Error(detail::joined({"strike: a range of ", detail::text(range), " from ", detail::text(mass),
                                  " of TNT is a scaled distance of ", detail::text(Z),
                                  " m/kg^(1/3), but the formulas of Kingery and Bulmash ", "hold from ",
                                  detail::text(nearest), " to ", detail::text(detail::farthest_blast),
                                  "; look at the units of the charge, move it, or leave out such faces."}));
    BlastWave wave = detail::scaled_blast(burst, Z);
    for (double* const time : {&wave.arrival, &wave.duration}) *time *= root / units.time;
    for (double* const pressure : {&wave.incident_pressure, &wave.reflected_pressure}) *pressure /= units.pressure;
    for (double* const impulse : {&wave.incident_impulse, &wave.reflected_impulse})
      *impulse *= root / (units.pressure * units.time);
    return wave;
  }
};

/// The blast of a charge on faces, which look to where their corners run counter-clockwise. The range of a face is that
/// of its middle at the start of the run; the angle of incidence theta is that of its normal now. With the incident and
/// the reflected history p_i and p_r of `BlastWave` the pressure is (Randers-Pehrson and Bannister 1997, ARL-TR-1310)
///   p = p_r cos^2 theta + p_i (1 + cos theta - 2 cos^2 theta)    where the face looks to the charge, else p_i,
/// at least minus that of the air. What stands between, or reflects, is not seen, nor that the blast flows around
/// edges. While waves pass, steps are 1/50 of the shortest i_r/p_r. It ends with the elements that have the face.
/// Errors: no such node; a face that is too near or too far.
class AirBlast {
 public:
  AirBlast(std::vector<Face> faces, const Charge& charge) : faces_(std::move(faces)), charge_(charge) {}

  void ranges(const auto& number) const { number(charge_, "charge"); }

  template <class N>
  void begin(const N& nodes, std::span<const PartFaces> parts = {}) {
    faces_.begin(nodes, parts);
    waves_.clear();
    passed_ = charge_.start, step_ = std::numeric_limits<double>::infinity();
    looking_ = 0;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const Face& face = faces_[i];
      const auto x = [&](std::size_t k) -> Eigen::Vector3d { return nodes.x(face.nodes[k]).template cast<double>(); };
      const Eigen::Vector3d way = charge_.centre - middle(nodes, i).template cast<double>();
      waves_.push_back(wave(way.norm(), i));
      const BlastWave& blast = waves_.back();
      passed_ = std::max(passed_, charge_.start + blast.arrival + blast.duration);
      step_ = std::min(step_, blast.reflected_impulse / blast.reflected_pressure / 50);
      const Eigen::Vector3d along = x(2) - x(0), across = x(3) - x(1);
      looking_ += along.cross(across).dot(way) > 0;
    }
  }
  std::string warning() const {
    if (looking_ > 0 || faces_.size() == 0) return {};
    return "AirBlast: no face looks to the charge, so that all feel the incident pressure alone; the corners of a face "
           "run counter-clockwise seen from the charge.";
  }
  double stable_step(double dt) const { return time_ < passed_ ? std::min(dt, step_) : dt; }

  std::vector<Index> nodes_named() const { return faces_.nodes_named(); }

  template <class N>
  void apply_loads(N& nodes, double time) {
    time_ = time;
    const double since = time < charge_.end ? time - charge_.start : -1;
    faces_.apply(nodes, [&](std::size_t i, const typename N::Vector& normal) {
      return pressure(nodes, i, normal, since - waves_[i].arrival);
    });
  }
  template <class N>
  double power(const N& nodes) const {
    return faces_.power(nodes);
  }
  /// Ends on the faces all of whose elements are gone.
  void remove(std::size_t part, const std::vector<bool>& alive) { faces_.remove(part, alive); }

  template <class Archive>
  void serialize(Archive& archive) {
    faces_.serialize(archive);
    archive.same(waves_, charge_.suction);
    archive(time_);
  }

 private:
  static constexpr double air = 101325;  // [Pa]

  /// Mean position of the corners of a face.
  template <class N>
  typename N::Vector middle(const N& nodes, std::size_t i) const {
    const auto& corner = faces_[i].nodes;
    typename N::Vector sum = nodes.x(corner[0]) + nodes.x(corner[1]) + nodes.x(corner[2]);
    if (corner[2] == corner[3]) return 1.0 / 3 * sum;
    sum += nodes.x(corner[3]);
    return 0.25 * sum;
  }
  BlastWave wave(double range, std::size_t face) const try { return charge_.wave(range); } catch (const Error& error) {
    const std::string sentence = error.what();
    throw Error(detail::joined({"strike: face ", std::to_string(face), " of AirBlast: ", sentence.substr(8)}));
  }
  /// The pressure on a face a while after the arrival.
  template <class N>
  typename N::Number pressure(const N& nodes, std::size_t i, const typename N::Vector& normal, double after) const {
    using T = typename N::Number;
    const BlastWave& blast = waves_[i];
    const double s = after / blast.duration;
    if (after < 0 || (s > 1 && !charge_.suction)) return T(0.0);
    const double p_i = blast.incident_pressure * (1 - s) * std::exp(-blast.incident_decay * s);
    const double p_r = blast.reflected_pressure * (1 - s) * std::exp(-blast.reflected_decay * s);
    const typename N::Vector way = charge_.centre.template cast<T>() - middle(nodes, i);
    const T projected = normal.dot(way);
    if (!(projected > 0.0)) return T(std::max(p_i, -air / charge_.units.pressure));
    const T cosine = projected / sqrt(T(normal.squaredNorm() * way.squaredNorm()));
    const T p = p_r * cosine * cosine + p_i * (1.0 + cosine - 2.0 * cosine * cosine);
    return max(p, T(-air / charge_.units.pressure));
  }

  detail::LoadedFaces faces_;
  Charge charge_;
  std::vector<BlastWave> waves_;  // at each face
  double passed_ = 0, step_ = 0;  // the time when the last positive phase has ended, and the longest step until then
  double time_ = -std::numeric_limits<double>::infinity();
  std::size_t looking_ = 0;  // faces that look to the charge at the start
};

}  // namespace strike
