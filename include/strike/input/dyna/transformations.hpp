#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <strike/input/dyna/draft.hpp>

// *DEFINE_TRANSFORMATION, and the nodes that it moves.
namespace strike::detail::dyna {

/// One line after the other, in their order (LS-DYNA Keyword User's Manual R13, volume I, *DEFINE_TRANSFORMATION).
inline void transformation(File& file, Draft& draft) {
  file.title();
  Card head = file.card();
  Transformation& all = draft.transformations[draft.own_number("transformation", Id::define, head, file)];
  std::map<FileNumber, Eigen::Vector3d> points;
  file.for_each_card([&](Card card) {
    const std::string option = upper(card.text());
    std::array<double, 7> a;
    for (double& value : a) value = card.number("A1 to A7");
    const Eigen::Vector3d first(a[0], a[1], a[2]), second(a[3], a[4], a[5]);
    const auto point = [&](double number) -> const Eigen::Vector3d& {
      const auto known = points.find(static_cast<FileNumber>(std::clamp(number, -1e15, 1e15)));
      if (known == points.end())
        file.refuse({"point ", text(number), " is not defined above: give a POINT line before this one."});
      return known->second;
    };
    Transformation next;
    if (option == "POINT") {
      points[static_cast<FileNumber>(std::clamp(a[0], -1e15, 1e15))] = {a[1], a[2], a[3]};
    } else if (option == "TRANSL") {
      next.b = first;
    } else if (option == "SCALE") {
      for (Eigen::Index i = 0; i < 3; ++i) next.A(i, i) = first[i] == 0 ? 1 : first[i];
    } else if (option == "ROTATE") {
      const bool by_points = second == Eigen::Vector3d::Zero() && a[6] == 0;  // points A1 and A2, angle A3
      const Eigen::Vector3d through = by_points ? point(a[0]) : second;
      const Eigen::Vector3d axis = by_points ? Eigen::Vector3d(point(a[1]) - through) : first;
      if (!(axis.norm() > 0)) file.refuse({"the axis of ROTATE has no direction: correct A1 to A3."});
      const double angle = (by_points ? a[2] : a[6]) * std::numbers::pi / 180;
      next.A = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
      next.b = through - next.A * through;
    } else {
      file.refuse({"the option ", shown(option), " of ", file.name(),
                   " is not read: give POINT, SCALE, ROTATE or TRANSL, or write the nodes where they belong."});
    }
    all.b = next.A * all.b + next.b;
    all.A = next.A * all.A;
    if (!all.A.allFinite() || !all.b.allFinite())
      file.refuse({"the transformation is not finite: give smaller numbers."});
  });
}

/// Moves the nodes of included files. Errors: a transformation is not there, or turns cells inside out; TC and RC of
/// nodes that are turned.
inline void move_nodes(Draft& draft, const File& file) {
  std::vector<Transformation> total;  // of each motion, with those around it
  for (const Motion& motion : file.motions()) {
    Transformation here;
    here.A *= motion.length;
    if (motion.transformation != 0) {
      const auto known = draft.transformations.find(motion.transformation);
      if (known == draft.transformations.end())
        file.source().refuse(motion.line, {"transformation ", std::to_string(motion.transformation),
                                           " is not in the file: define it with *DEFINE_TRANSFORMATION."});
      here = known->second;
      if (!(here.A.determinant() > 0))
        file.source().refuse(motion.line, {"transformation ", std::to_string(motion.transformation),
                                           " mirrors, which turns cells inside out: mirror the mesh itself."});
    }
    if (motion.outer != 0) {
      const Transformation& outer = total[motion.outer - 1];
      here.b = outer.A * here.b + outer.b;
      here.A = outer.A * here.A;
    }
    total.push_back(here);
  }
  for (const MovedNodes& nodes : draft.moved) {
    const auto& [A, b] = total[nodes.motion - 1];
    if (nodes.held != 0 && !(Eigen::Matrix3d(A.diagonal().asDiagonal()) - A).isZero(0))
      file.source().refuse(nodes.held, {"TC or RC holds a node that its file's transformation turns: write it as "
                                        "*BOUNDARY_SPC_NODE in the deck."});
    for (std::size_t n = nodes.first; n < nodes.last; ++n) {
      RawMesh::Node& node = draft.raw.nodes[n];
      node.x = (A * node.x + b).eval();
      if (!node.x.allFinite())
        file.source().refuse(node.line, {"the node is moved out of all bounds: give a smaller transformation."});
    }
  }
}

inline constexpr Meaning of_transformations{"nodes of `*INCLUDE_TRANSFORM`: SCALE, ROTATE, TRANSL, POINT", "the same",
                                            "other options, and one that mirrors, which are refused"};
inline constexpr auto transformation_keywords = std::to_array<Keyword>({
    {"*DEFINE_TRANSFORMATION", transformation, Invariant::none, &of_transformations},
});

}  // namespace strike::detail::dyna
