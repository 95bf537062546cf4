#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <strike/element/particle.hpp>
#include <strike/error.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// The images of points behind planes of symmetry, and of images behind the next plane.
class MirrorImages {
 public:
  MirrorImages() = default;
  explicit MirrorImages(const Mirrors& mirrors) {
    for (const Mirror& plane : mirrors.planes()) planes_.push_back({plane.normal.normalized(), plane.point});
  }
  /// Error: parallel planes so near to each other that a particle of the part, which sees as far as `reach`, would see
  /// images of images.
  [[gnu::cold]] void check_gaps(double reach, std::size_t part) const {
    for (std::size_t k = 0; k < planes_.size(); ++k)
      for (std::size_t l = 0; l < k; ++l) {
        const double gap = std::abs(planes_[l].normal.dot(planes_[k].point - planes_[l].point));
        if (std::abs(planes_[l].normal.dot(planes_[k].normal)) > 0.5 && gap < reach)
          throw Error(joined({"strike: the parallel mirrors ", std::to_string(k), " and ", std::to_string(l),
                              " of part ", std::to_string(part), " are ", text(gap),
                              " apart, and its particles see as far as ", text(reach), "; put them farther apart."}));
      }
  }
  std::size_t size() const { return images_.size(); }
  /// Number of the point or image that image k is of; points are counted first.
  Index of(std::size_t k) const { return images_[k].of; }

  /// How many of a point and its images are where it is.
  double here(std::size_t point) const { return here_[point]; }

  /// Appends to points the images that are within `reach` of a point; those at infinity have none. Points within
  /// `on_plane` of a plane are on it.
  void find(std::vector<Eigen::Vector3d>& points, double reach, double on_plane = 0) {
    images_.clear();
    here_.assign(points.size(), 1);
    for (std::size_t k = 0; k < planes_.size(); ++k) {
      const Plane& plane = planes_[k];
      const auto height = [&](std::size_t j) { return plane.normal.dot(points[j] - plane.point); };
      double least = 0, most = 0;  // points may be on either side
      for (std::size_t j = 0; j < points.size(); ++j)
        if (points[j].allFinite()) {
          least = std::min(least, height(j));
          most = std::max(most, height(j));
        }
      const double depth = std::min(-least, most);
      for (std::size_t j = 0, last = points.size(); j < last; ++j)
        if (const double a = height(j); std::abs(a) <= reach + depth) {
          if (j < here_.size() && std::abs(a) <= on_plane) here_[j] *= 2;
          images_.push_back({static_cast<Index>(j), static_cast<Index>(k)});
          points.push_back(points[j] - 2 * a * plane.normal);
        }
    }
  }

  /// The largest component of a way across a plane; 0 if it is not finite.
  double across(const Eigen::Vector3d& way) const {
    double most = 0;
    for (const Plane& plane : planes_)
      if (const double across = std::abs(way.dot(plane.normal)); std::isfinite(across)) most = std::max(most, across);
    return most;
  }
  /// Reflects a vector of image k, whose components are `stride` apart: a - 2 (a . n) n.
  template <int stride = 1, class Real>
  void reflect(std::size_t k, Real* a) const {
    const Eigen::Vector3d& normal = planes_[images_[k].plane].normal;
    Real along = 0;
    for (int c = 0; c < 3; ++c) along += static_cast<Real>(normal(c)) * a[stride * c];
    for (int c = 0; c < 3; ++c) a[stride * c] -= Real(2) * along * static_cast<Real>(normal(c));
  }
  /// The same of a place, given relative to an origin.
  template <class Real>
  void reflect_place(std::size_t k, Real* x, const Eigen::Vector3d& origin) const {
    const Eigen::Vector3d from = planes_[images_[k].plane].point - origin;
    for (int c = 0; c < 3; ++c) x[c] -= static_cast<Real>(from(c));
    reflect(k, x);
    for (int c = 0; c < 3; ++c) x[c] += static_cast<Real>(from(c));
  }
  /// The same of a tensor, column by column.
  template <class Real>
  void reflect_tensor(std::size_t k, Real* A) const {
    for (Real* column = A; column < A + 9; column += 3) reflect(k, column);
    for (int row = 0; row < 3; ++row) reflect<3>(k, A + row);
  }

 private:
  struct Plane {
    Eigen::Vector3d normal, point;
  };
  struct Image {
    Index of, plane;
  };

  std::vector<Plane> planes_;
  std::vector<Image> images_;
  std::vector<double> here_;
};

}  // namespace strike::detail
