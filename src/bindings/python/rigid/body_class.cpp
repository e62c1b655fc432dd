// Body for Python.
// SPDX-License-Identifier: MIT
#include <touchstone/bodies.hpp>

#include <string>
#include <utility>

#include "python/answers.hpp"
#include "python/rigid/body_arguments.hpp"
#include "python/rigid/define_bodies.hpp"
#include "python/rigid/rigid_members.hpp"

namespace touchstone::python {
namespace {

constexpr char kBodyHelp[] = R"(A rigid body: a mesh with the positions of its vertices in the body's own frame.

It never changes, and several threads may use it. It is made once, for any number of questions of Bodies.

Body(points, faces=None, edges=None, loose_points=None, radii=None, *, mesh=None)

points        (n, 3): the positions, in the body's own frame. Or the mesh and the positions in one: a MeshFile, as
              read_mesh and as_mesh return it, or an object that as_mesh takes (of trimesh, meshio, PyVista, Open3D)
faces, edges  (m, 3) and (k, 2) whole numbers, as in Mesh
loose_points  the vertices in no edge that collide; None is every vertex in no edge
radii         n numbers: an element's radius is the largest of its vertices'. The radii of both elements are added to
              the separation
mesh          a Mesh of n vertices in place of faces, edges and loose_points. Neither its rules nor its separation
              count: the elements of a body do not move against each other. Its radii count, unless there are others

Raises TypeError and ValueError as Mesh does, and ValueError for a coordinate that is not finite, naming the vertex.

>>> import touchstone
>>> touchstone.Body([[0, 0, 0], [1, 0, 0], [0, 1, 0]], faces=[[0, 1, 2]])
<Body: 3 vertices, 1 faces, 3 edges, 0 loose points>)";

}  // namespace

BodyRecord record_of(const Body& body) { return {body.mesh().elements(), body.points()}; }

Body body_of(BodyRecord&& record) { return Body(Mesh(std::move(record.elements)), Positions(record.points)); }

void define_body(py::module_& module) {
  py::class_<Body> bound = define_class<Body>(module, "Body", kBodyHelp);
  define_pickle(bound, &record_of, [](BodyRecord&& record) { return body_of(std::move(record)); });
  const py::none none;
  bound
      .def(py::init([](const py::object& points, const py::object& faces, const py::object& edges,
                       const py::object& loose_points, const py::object& radii,
                       const py::object& mesh) { return body_of(points, faces, edges, loose_points, radii, mesh); }),
           py::arg("points"), py::arg("faces") = none, py::arg("edges") = none, py::arg("loose_points") = none,
           py::arg("radii") = none, py::kw_only(), py::arg("mesh") = none)
      .def_property_readonly(
          "points",
          [](const py::object& self) {
            const auto& points = self.cast<const Body&>().points();
            return column_of<double>(points, points.data(), self, 3);
          },
          "(n, 3) float64: the positions of the vertices in the body's own frame")
      .def_property_readonly(
          "mesh", [](const Body& self) { return self.mesh(); }, "the Mesh: faces, edges and loose points")
      .def("__repr__", [](const Body& self) {
        const std::string mesh = std::string(py::repr(py::cast(self.mesh())));
        return "<Body" + mesh.substr(mesh.find(':'));
      });
}

}  // namespace touchstone::python
