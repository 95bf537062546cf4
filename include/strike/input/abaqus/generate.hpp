#pragma once
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/input/abaqus/file.hpp>
#include <strike/input/abaqus/model.hpp>
#include <strike/tensor/tensor.hpp>

// Nodes and elements that are made of others (Abaqus Analysis User's Guide, "Node definition", "Element definition").
namespace strike::detail::abaqus {

/// x turned about an axis through a point by an angle, Rodrigues' formula.
inline Eigen::Matrix3d rotation(const Eigen::Vector3d& axis, double angle) {
  Eigen::Matrix3d turn;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Vector3d e = Eigen::Vector3d::Unit(i);
    turn.col(i) = std::cos(angle) * e + std::sin(angle) * cross(axis, e) + (1 - std::cos(angle)) * axis[i] * axis;
  }
  return turn;
}

/// The system of *SYSTEM in which nodes are given.
struct Frame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< in its columns
  bool turns = false;

  Eigen::Vector3d placed(const Eigen::Vector3d& x) const {
    return turns ? Eigen::Vector3d(origin + axes * x) : Eigen::Vector3d(x + origin);
  }
  bool is_global() const { return !turns && origin.isZero(0); }
};

inline Eigen::Vector3d vector(std::string_view& line, const File& file, std::string_view meaning) {
  Eigen::Vector3d v;
  for (Eigen::Index i = 0; i < 3; ++i) v[i] = file.number_or(taken(line, ','), 0, meaning);
  return v;
}
/// Coordinates of a local system: R of *NODE, SYSTEM is Cartesian, C radius, angle and height, S radius, angle and
/// height above the equator as an angle [degree].
inline Eigen::Vector3d cartesian(const Eigen::Vector3d& x, char system) {
  constexpr double degree = std::numbers::pi / 180;
  if (system == 'C') return {x[0] * std::cos(x[1] * degree), x[0] * std::sin(x[1] * degree), x[2]};
  if (system != 'S') return x;
  const double across = x[0] * std::cos(x[2] * degree);
  return {across * std::cos(x[1] * degree), across * std::sin(x[1] * degree), x[0] * std::sin(x[2] * degree)};
}
/// The letter of SYSTEM=. Error: another one.
inline char system_of(const File& file) {
  const std::string system = file.label_of("SYSTEM");
  if (system.empty() || system == "R" || system == "RC") return 'R';
  if (system != "C" && system != "S") file.refuse({"the nodes have the system ", shown(system), ": give R, C or S."});
  return system[0];
}

/// Keywords that make nodes and elements of those of a model.
class Generator {
 public:
  Generator(Model& model, File& file, Allowance& allowance) : model_(model), file_(file), allowance_(allowance) {}

  /// *NGEN: nodes on a line or an arc between two.
  void nodes_between(const Frame& frame) {
    const std::string line_kind = file_.label_of("LINE");
    if (!line_kind.empty() && line_kind != "C")
      file_.refuse({"*NGEN with LINE=", line_kind.substr(0, 20), " is not read: write its nodes with *NODE."});
    const char system = system_of(file_);
    std::string_view line;
    while (file_.data(line)) {
      const FileNumber first = number(line), last = number(line);
      const FileNumber step = file_.tag_or(field(line), 1, "the increment of numbers", 1 - number_limit);
      if (step == 0 || (last - first) % step != 0 || (last - first) / step < 0)
        file_.refuse({"the numbers from ", std::to_string(first), " do not reach ", std::to_string(last),
                      " by steps of ", std::to_string(step), ": correct them."});
      const FileNumber count = (last - first) / step;
      const Eigen::Vector3d a = place(first), b = place(last);
      std::optional<Arc> arc;
      if (line_kind == "C") arc = arc_between(a, b, line, frame, system);
      take(static_cast<std::size_t>(count));
      for (FileNumber i = 1; i < count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count);
        add_node(first + i * step, arc ? arc->at(part) : Eigen::Vector3d((1 - part) * a + part * b));
      }
      add_to_set("NSET", std::min(first, last), std::max(first, last), std::abs(step));
    }
  }

  /// *NFILL: nodes on lines between those of two sets.
  void nodes_filled() {
    for (const char* key : {"SINGULAR", "TWOSTEP"})
      if (file_.find(key)) file_.refuse({"*NFILL with ", key, " is not read: write its nodes with *NODE."});
    if (const std::string* const bias = file_.find("BIAS"); bias && file_.number(*bias, "BIAS") != 1)
      file_.refuse({"*NFILL with BIAS=", bias->substr(0, 20), " is not read: write its nodes with *NODE."});
    std::string_view line;
    while (file_.data(line)) {
      const std::string name = std::string(field(line)), other = std::string(field(line));
      const auto from = nodes_of(name), to = nodes_of(other);
      const FileNumber intervals = file_.tag_or(field(line), 1, "the number of intervals");
      const FileNumber step = file_.tag_or(field(line), 1, "the increment of numbers", 1 - number_limit);
      if (from.size() != to.size() || from.empty())
        file_.refuse({"the sets ", shown(name), " and ", shown(other), " have ", std::to_string(from.size()), " and ",
                      std::to_string(to.size()), " nodes: give each as many."});
      for (std::size_t i = 0; i < from.size(); ++i) {
        take(static_cast<std::size_t>(intervals));
        const Eigen::Vector3d a = place(from[i]), b = place(to[i]);
        for (FileNumber k = 1; k < intervals; ++k) {
          const double part = static_cast<double>(k) / static_cast<double>(intervals);
          add_node(from[i] + k * step, (1 - part) * a + part * b);
          add_to_set("NSET", from[i] + k * step, from[i] + k * step, 1);
        }
        for (const FileNumber n : {from[i], to[i]}) add_to_set("NSET", n, n, 1);
      }
    }
  }

  /// *NCOPY: nodes of a set, moved or mirrored.
  void nodes_copied(const Frame& frame) {
    for (const char* key : {"POLE", "MULTIPLE"})
      if (file_.find(key)) file_.refuse({"*NCOPY with ", key, " is not read: write its nodes with *NODE."});
    if (!frame.is_global())
      file_.refuse({"*NCOPY within a *SYSTEM is not read: write *SYSTEM without data before it."});
    const auto old = nodes_of(file_.required("OLDSET"));
    const FileNumber shift = file_.tag(file_.required("CHANGENUMBER"), "CHANGE NUMBER", 1 - number_limit);
    Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    std::string_view line;
    if (file_.find("SHIFT")) {
      if (file_.data(line)) b = vector(line, file_, "a coordinate of the shift");
      if (file_.data(line)) {
        const Eigen::Vector3d point = vector(line, file_, "a coordinate of the axis");
        const Eigen::Vector3d axis = vector(line, file_, "a coordinate of the axis") - point;
        const double angle = file_.number_or(field(line), 0, "the angle");
        if (angle != 0 && !(axis.norm() > 0)) file_.refuse({"the axis has no length: give two different points."});
        if (angle != 0) {
          A = rotation(axis / axis.norm(), angle * std::numbers::pi / 180);
          b = Eigen::Vector3d(point + A * (b - point));
        }
      }
    } else if (file_.find("REFLECT")) {
      reflect(A, b);
    }
    take(2 * old.size());
    for (const FileNumber n : old) {
      add_node(n + shift, A * place(n) + b);
      add_to_set("NEWSET", n + shift, n + shift, 1);
    }
  }

  /// *ELGEN: rows and layers of an element.
  void elements_repeated() {
    std::string_view line;
    while (file_.data(line)) {
      const RawMesh::Element master = element(file_.tag(field(line), "the number of an element"));
      std::array<FileNumber, 3> counts{}, of_nodes{}, of_elements{};
      for (std::size_t i = 0; i < 3; ++i) {
        counts[i] = file_.tag_or(field(line), 1, "the number of elements");
        of_nodes[i] = file_.tag_or(field(line), 1, "the increment of nodes", 1 - number_limit);
        of_elements[i] = file_.tag_or(field(line), 1, "the increment of elements", 1 - number_limit);
      }
      take(static_cast<std::size_t>(counts[0]));
      take(static_cast<std::size_t>(counts[1]));
      take(static_cast<std::size_t>(counts[2]));  // each is small, so that their product is exact
      take(4 * static_cast<std::size_t>(counts[0] * counts[1]));
      take(4 * static_cast<std::size_t>(counts[0] * counts[1] * counts[2]));
      for (FileNumber k = 0; k < counts[2]; ++k)
        for (FileNumber j = 0; j < counts[1]; ++j)
          for (FileNumber i = 0; i < counts[0]; ++i) {
            const FileNumber number = master.number + i * of_elements[0] + j * of_elements[1] + k * of_elements[2];
            if (i + j + k > 0) add_element(master, number, i * of_nodes[0] + j * of_nodes[1] + k * of_nodes[2]);
            add_to_element_set("ELSET", number);
          }
    }
  }

  /// *ELCOPY: elements of a set with other nodes.
  void elements_copied() {
    if (file_.find("REFLECT")) file_.refuse({"*ELCOPY with REFLECT is not read: write its elements with *ELEMENT."});
    const std::string name = file_.required("OLDSET");
    const FileNumber shift = file_.tag(file_.required("ELEMENTSHIFT"), "ELEMENT SHIFT", 1 - number_limit);
    const FileNumber of_nodes = file_.tag(file_.required("SHIFTNODES"), "SHIFT NODES", 1 - number_limit);
    const auto found = model_.element_sets.find(label(name));
    if (found == model_.element_sets.end())
      file_.refuse({"the set of elements ", shown(name), " is not above: define it before it is copied."});
    const auto old = members(model_.raw.element_sets, found->second, model_.element_places(), allowance_, file_.line());
    take(8 * old.size());
    for (const FileNumber n : old) {
      const RawMesh::Element master = element(n);
      add_element(master, n + shift, of_nodes);
      add_to_element_set("NEWSET", n + shift);
    }
  }

 private:
  struct Arc {
    Eigen::Vector3d centre, axis, from;
    double angle;

    Eigen::Vector3d at(double part) const { return centre + rotation(axis, part * angle) * from; }
  };
  Arc arc_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b, std::string_view line, const Frame& frame,
                  char system) {
    const std::string_view third = field(line);
    Eigen::Vector3d centre = vector(line, file_, "a coordinate of the centre");
    centre = third.empty() || file_.number(third, "the number of the centre") == 0
                 ? frame.placed(cartesian(centre, system))
                 : place(file_.tag(third, "the number of the centre"));
    const bool has_normal = !trimmed(line).empty();
    Eigen::Vector3d normal = vector(line, file_, "a component of the normal");
    const Eigen::Vector3d from = a - centre, to = b - centre;
    const double radius = from.norm();
    if (!(radius > 0) || std::abs(to.norm() - radius) > 1e-3 * radius)
      file_.refuse({"the two nodes are not as far from the centre: correct the centre of the arc."});
    if (frame.turns) normal = frame.axes * normal;
    if (!has_normal || normal.isZero(0)) {
      normal = cross(from, to);
      if (!(normal.norm() > 1e-6 * radius * radius))
        file_.refuse({"an arc of 180 degrees and more has no plane without its normal: give it in fields 8 to 10."});
    }
    normal /= normal.norm();
    if (std::abs(normal.dot(from)) > 1e-3 * radius || std::abs(normal.dot(to)) > 1e-3 * radius)
      file_.refuse({"the normal is not square to the arc: correct it."});
    double angle = std::atan2(cross(from, to).dot(normal), from.dot(to));
    if (angle <= 1e-9) angle += 2 * std::numbers::pi;
    return {centre, normal, from, angle};
  }
  /// x becomes A x + b: mirrored in the plane of three points, in a line of two or in a point.
  void reflect(Eigen::Matrix3d& A, Eigen::Vector3d& b) {
    const std::string kind = file_.label_of("REFLECT");
    std::string_view line;
    if (!file_.data(line)) file_.refuse({"*NCOPY with REFLECT has no points: give them on the lines after it."});
    const Eigen::Vector3d p = vector(line, file_, "a coordinate of a point");
    const Eigen::Vector3d along = vector(line, file_, "a coordinate of a point") - p;
    if (kind == "POINT") {
      A = -Eigen::Matrix3d::Identity();
    } else if (kind == "LINE" || kind == "MIRROR") {
      Eigen::Vector3d axis = along;
      if (kind == "MIRROR") {
        if (!file_.data(line)) file_.refuse({"the mirror has two points: give the third on the next line."});
        axis = cross(along, Eigen::Vector3d(vector(line, file_, "a coordinate of a point") - p));
      }
      if (!(axis.norm() > 0)) file_.refuse({"the points of REFLECT lie on each other or on a line: correct them."});
      axis /= axis.norm();
      const Eigen::Matrix3d twice = 2 * axis * axis.transpose();
      A = kind == "LINE" ? Eigen::Matrix3d(twice - Eigen::Matrix3d::Identity())
                         : Eigen::Matrix3d(Eigen::Matrix3d::Identity() - twice);
    } else {
      file_.refuse({"*NCOPY reflects by ", shown(kind), ": give REFLECT=MIRROR, LINE or POINT."});
    }
    b = p - A * p;
  }

  FileNumber number(std::string_view& line) { return file_.tag(field(line), "the number of a node"); }
  void take(std::size_t count) {
    if (!allowance_.has(count))
      file_.refuse({file_.name(), " makes more nodes and elements than a file of ",
                    std::to_string(file_.source().size()), " bytes may: write them with *NODE and *ELEMENT."});
    allowance_.take(count, file_.line());
  }
  Eigen::Vector3d place(FileNumber node) {
    const auto& places = model_.node_places();
    const auto found = places.find(node);
    if (found == places.end())
      file_.refuse({"node ", std::to_string(node), " is not above: define it before it is used here."});
    return model_.raw.nodes[found->second].x;
  }
  RawMesh::Element element(FileNumber number) {
    const auto& places = model_.element_places();
    const auto found = places.find(number);
    if (found == places.end())
      file_.refuse({"element ", std::to_string(number),
                    " is not above, or of a type that is not read: define it before it is used here."});
    return model_.raw.elements[found->second];
  }
  std::vector<FileNumber> nodes_of(const std::string& name) {
    const auto& known = model_.node_places();
    if (to_integer(name)) {
      place(file_.tag(name, "the number of a node"));
      return {*to_integer(name)};
    }
    const auto found = model_.node_sets.find(label(name));
    if (found == model_.node_sets.end())
      file_.refuse({"the set of nodes ", shown(name), " is not above: define it before it is used here."});
    if (model_.unsorted.contains(label(name)))
      file_.refuse({"the set of nodes ", shown(name), " is UNSORTED, and its order is not kept: sort it."});
    return members(model_.raw.node_sets, found->second, known, allowance_, file_.line());
  }
  /// A node that is there already takes the new place, as the last definition of a node counts.
  void add_node(FileNumber number, const Eigen::Vector3d& x) {
    expect_in_bounds(number, "a node");
    const auto& places = model_.node_places();
    if (const auto known = places.find(number); known != places.end())
      model_.raw.nodes[known->second].x = x;
    else
      model_.raw.nodes.push_back({number, x, file_.line()});
  }
  void add_element(RawMesh::Element element, FileNumber number, FileNumber shift) {
    expect_in_bounds(number, "an element");
    element.number = number, element.line = file_.line();
    for (std::size_t i = 0; i < corner_count(element.shape); ++i) {
      element.corners[i] += shift;
      expect_in_bounds(element.corners[i], "a node");
    }
    if (element.second != SecondOrderKind::none) {
      allowance_.take(mid_nodes(element.second).size(), file_.line());
      for (const FileNumber mid : model_.raw.mids_of(element)) expect_in_bounds(mid + shift, "a node");
      model_.raw.set_mids(element, model_.raw.mids_of(element), shift);
    }
    model_.raw.elements.push_back(element);
  }
  void expect_in_bounds(FileNumber number, std::string_view thing) const {
    if (number < 1 || number >= number_limit)
      file_.refuse({file_.name(), " gives ", thing, " the number ", std::to_string(number),
                    ", which is out of bounds: number from 1 to 10^12."});
  }
  void add_to_set(std::string_view key, FileNumber first, FileNumber last, FileNumber step) {
    if (const std::string* const name = file_.find(key))
      set_of(model_.raw.node_sets, model_.node_sets, shown_label(*name), file_.line())
          .sequences.push_back({first, last, step, file_.line()});
  }
  void add_to_element_set(std::string_view key, FileNumber number) {
    if (const std::string* const name = file_.find(key))
      set_of(model_.raw.element_sets, model_.element_sets, shown_label(*name), file_.line())
          .sequences.push_back({number, number, 1, file_.line()});
  }

  Model& model_;
  File& file_;
  Allowance& allowance_;
};

}  // namespace strike::detail::abaqus
