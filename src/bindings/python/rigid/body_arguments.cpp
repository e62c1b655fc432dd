// SPDX-License-Identifier: MIT
#include "python/rigid/body_arguments.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include "python/step_arguments.hpp"
#include "rigid/body_data.hpp"

namespace touchstone::python {
namespace {

constexpr py::ssize_t kPoseNumbers = 7;

/// Whether a word is the second of two.
bool is_second(py::handle word, const char* what, const std::string& first, const std::string& second) {
  if (!PyUnicode_Check(word.ptr())) {
    throw py::type_error(std::string(what) + " is of type " + Py_TYPE(word.ptr())->tp_name + "; it must be '" + first +
                         "' or '" + second + "'");
  }
  auto given = word.cast<std::string>();
  std::replace(given.begin(), given.end(), '_', '-');
  if (given == first || given == second) return given == second;
  throw py::value_error(std::string(what) + " is " + std::string(py::str(py::repr(word))) + "; it must be '" + first +
                        "' or '" + second + "'");
}

/// The column of each component of {w, x, y, z} in a row of seven numbers.
std::array<std::size_t, 4> columns_of(QuaternionOrder order) noexcept {
  if (order == QuaternionOrder::wxyz) return {3, 4, 5, 6};
  return {6, 3, 4, 5};
}

Pose pose_at(const double* numbers, QuaternionOrder order) noexcept {
  Pose pose;
  pose.position = {numbers[0], numbers[1], numbers[2]};
  const auto columns = columns_of(order);
  for (std::size_t i = 0; i < 4; ++i) pose.orientation[i] = numbers[columns[i]];
  return pose;
}

std::vector<py::ssize_t> shape_for(const Bodies& bodies) {
  return {static_cast<py::ssize_t>(bodies.bodies.size()), kPoseNumbers};
}

/// How many control points `inner` has for each body.
std::size_t inner_points_of(py::handle inner) {
  const py::array given = exact_array(inner, "inner");
  const py::ssize_t points = given.ndim() < 3 ? 0 : given.shape(given.ndim() - 2);
  if (points == 1 || points == 2) return static_cast<std::size_t>(points);
  throw py::value_error("inner has the shape " + shape_text(given) +
                        "; it must be (k, m, 3) or (n, k, m, 3) for k bodies, with m = 1 or 2 control points each");
}

void bend(RigidMotion& motion, const double* x, std::size_t points) {
  motion.control_points = static_cast<int>(points) + 2;
  for (std::size_t i = 0; i < points; ++i, x += 3) motion.inner[i] = {x[0], x[1], x[2]};
}

Body body_of_mesh(const Mesh& mesh, py::handle points, py::handle radii) {
  const PositionArray positions(points, mesh, "points");
  return in_background(mesh.vertex_count(), [&, own = numbers(radii, "radii")](const std::atomic<bool>&) {
    if (own.empty()) return Body(mesh, positions.view());
    MeshElements elements = mesh.elements();
    elements.separation = {};
    elements.radii = own;
    return Body(Mesh(std::move(elements)), positions.view());
  });
}

}  // namespace

Body body_of(const py::object& points, const py::object& faces, const py::object& edges, const py::object& loose_points,
             const py::object& radii, const py::object& mesh) {
  const bool has_elements = !faces.is_none() || !edges.is_none() || !loose_points.is_none();
  const auto no_elements = [&](const char* what) {
    if (!has_elements) return;
    throw py::type_error(std::string(what) + " has the elements already; faces, edges and loose_points must be None");
  };
  if (!mesh.is_none()) {
    const py::object own = mesh_object(mesh);
    no_elements("mesh");
    return body_of_mesh(own.cast<const Mesh&>(), points, radii);
  }
  if (py::isinstance<Mesh>(points)) {
    throw py::type_error("points is a Mesh, which has no positions; Body(positions, mesh=mesh) takes both");
  }
  // A MeshFile, or an object that as_mesh makes one of: arrays and tensors have none of these attributes.
  const bool is_file = py::hasattr(points, "mesh") && py::hasattr(points, "positions");
  if (is_file || py::hasattr(points, "vertices") || py::hasattr(points, "points")) {
    no_elements("points");
    const py::object file = is_file ? points : py::module_::import("touchstone._mesh_files").attr("as_mesh")(points);
    return body_of_mesh(file.attr("mesh").cast<const Mesh&>(), file.attr("positions"), radii);
  }
  const py::array positions = exact_array(points, "points");
  if (positions.ndim() != 2 || positions.shape(1) != 3) {
    throw py::value_error("points has the shape " + shape_text(positions) + "; it must be (n, 3)");
  }
  MeshElements elements;
  elements.vertex_count = static_cast<std::size_t>(positions.shape(0));
  elements.faces = index_rows<3>(faces, "faces");
  elements.edges = index_rows<2>(edges, "edges");
  if (!loose_points.is_none()) elements.points = indices(loose_points, "loose_points");
  return body_of_mesh(Mesh(std::move(elements)), positions, radii);
}

QuaternionOrder order_of(py::handle quaternion) {
  if (quaternion.is_none()) {
    throw py::type_error(
        "quaternion is not given; it must be 'wxyz', for poses x y z and the quaternion w x y z (Eigen's constructor, "
        "Blender, MuJoCo), or 'xyzw' (SciPy, ROS, Unity, Bullet)");
  }
  return is_second(quaternion, "quaternion", "wxyz", "xyzw") ? QuaternionOrder::xyzw : QuaternionOrder::wxyz;
}

Turn turn_of(py::handle turn) {
  return is_second(turn, "turn", "shorter", "as-given") ? Turn::as_given : Turn::shorter;
}

std::array<double, 7> pose_numbers(const Pose& pose, QuaternionOrder order) {
  std::array<double, 7> numbers{pose.position.x, pose.position.y, pose.position.z};
  const auto columns = columns_of(order);
  for (std::size_t i = 0; i < 4; ++i) numbers[columns[i]] = pose.orientation[i];
  return numbers;
}

BodySteps::BodySteps(const Bodies& bodies, py::handle start, py::handle end, QuaternionOrder order, Turn turn,
                     py::handle inner) {
  read(bodies, NumberTable(start, "start", shape_for(bodies)), NumberTable(end, "end", shape_for(bodies)), order, turn,
       inner);
}

BodySteps::BodySteps(const Bodies& bodies, py::handle poses, QuaternionOrder order) {
  const NumberTable table(poses, "poses", shape_for(bodies));
  read(bodies, table, table, order, Turn::as_given, py::none());
}

void BodySteps::read(const Bodies& bodies, const NumberTable& start, const NumberTable& end, QuaternionOrder order,
                     Turn turn, py::handle inner) {
  if (start.count() && end.count() && *start.count() != *end.count()) {
    throw py::value_error("start has " + std::to_string(*start.count()) + " motions and end has " +
                          std::to_string(*end.count()) + "; they must have the same");
  }
  single_ = !start.count() && !end.count();
  all_.resize(start.count().value_or(end.count().value_or(1)));
  const std::size_t count = bodies.bodies.size();
  std::optional<NumberTable> curves;
  std::size_t points = 0;  // of a curve, between both positions
  if (!inner.is_none()) {
    points = inner_points_of(inner);
    curves.emplace(inner, "inner", std::vector<py::ssize_t>{py::ssize_t(count), py::ssize_t(points), 3});
    if (curves->count() && *curves->count() != all_.size()) {
      throw py::value_error("inner has " + std::to_string(*curves->count()) + " motions and the poses have " +
                            std::to_string(all_.size()) + "; they must have the same");
    }
    if (curves->count() && single_) throw py::value_error("inner is for many motions, and the poses are for one");
  }
  for (std::size_t m = 0; m < all_.size(); ++m) {
    AskedMotions& one = all_[m];
    one.motions.reserve(count);
    for (BodyIndex b = 0; b < count; ++b) {
      const Pose from = pose_at(start.row(m) + kPoseNumbers * b, order);
      const Pose to = pose_at(end.row(m) + kPoseNumbers * b, order);
      one.motions.push_back(motion_between(from, to, turn));
      if (one.motions[b].q1 != to.orientation) one.turned.push_back(b);
      if (points > 0) bend(one.motions[b], curves->row(m) + 3 * points * b, points);
    }
    try {
      rigid::validate(bodies, one.motions, 1, solver::OriginPath::curved);
    } catch (const InvalidQuery& error) {
      if (single_) throw;
      throw InvalidQuery("motion " + std::to_string(m) + ": " + error.what());
    }
  }
  constexpr std::size_t kTurning = 16;  // a question about a body that turns takes longer than one about a mesh
  for (const Body& body : bodies.bodies) size_ += kTurning * all_.size() * body.points().size();
}

}  // namespace touchstone::python
