// Mesh for Python: its elements and its rules.
// SPDX-License-Identifier: MIT
#include <touchstone/mesh.hpp>

#include <array>
#include <atomic>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "python/answers.hpp"
#include "python/arguments.hpp"
#include "python/background.hpp"
#include "python/define.hpp"
#include "python/pickles.hpp"

namespace touchstone::python {
namespace {

/// An element for a person, as Mesh::describe has it.
std::string text_of(const Mesh& mesh, MeshElement element, MeshIndex number) {
  const std::size_t count = element == MeshElement::vertex ? mesh.vertex_count()
                            : element == MeshElement::edge ? mesh.edges().size()
                                                           : mesh.faces().size();
  std::string text = std::string(name_of(element)) + " " + std::to_string(number);
  if (number >= count) throw py::value_error("the mesh has no " + text + "; it has " + std::to_string(count));
  const auto with_corners = [&](const auto& corners) {
    for (const MeshIndex& corner : corners) text.append(&corner == &corners[0] ? " (" : "-") += std::to_string(corner);
    return text + ")";
  };
  return element == MeshElement::vertex ? text
         : element == MeshElement::edge ? with_corners(mesh.edges()[number])
                                        : with_corners(mesh.faces()[number]);
}

/// A pair, or an intersection (first_element, first, second_element, second, sort), for a person.
std::string description(const Mesh& mesh, py::handle given) {
  if (!py::isinstance<py::tuple>(given) || py::len(given) != 5) return mesh.describe(pair_of(given));
  const auto found = py::reinterpret_borrow<py::tuple>(given);
  const auto element = [&](std::size_t i) { return text_of(mesh, element_of(found[i]), number_in(found, i + 1)); };
  const std::string first = element(0), second = element(2);
  return first + " " + std::string(intersection_verb(intersection_sort_of(found[4]))) + " " + second;
}

struct MeshArguments {
  py::object vertices, faces, edges, points, separation, metric, radii, dimension, excluded_vertices, excluded_pairs,
      groups, group_pairs;
  bool only_listed_groups;
  py::object pair_separations;
};

std::size_t whole_number(py::handle number, const char* what) {
  const std::size_t value = PyLong_AsSize_t(number.ptr());
  if (PyErr_Occurred() == nullptr) return value;
  if (PyErr_ExceptionMatches(PyExc_TypeError) != 0) throw py::error_already_set();
  PyErr_Clear();
  throw py::value_error(std::string(what) + " is " + std::string(py::str(number)) +
                        "; it must be a number of vertices");
}

MeshElements elements_of(const MeshArguments& given) {
  MeshElements elements;
  if (PyIndex_Check(given.vertices.ptr()) != 0 && !py::hasattr(given.vertices, "__len__")) {
    const py::object number = py::reinterpret_steal<py::object>(PyNumber_Index(given.vertices.ptr()));
    if (!number) throw py::error_already_set();
    elements.vertex_count = whole_number(number, "vertices");
  } else {
    const py::array positions = exact_array(given.vertices, "vertices");
    if (positions.ndim() != 2 || (positions.shape(1) != 2 && positions.shape(1) != 3)) {
      throw py::value_error("vertices has the shape " + shape_text(positions) +
                            "; it must be (n, 3) or (n, 2), or a number of vertices");
    }
    elements.vertex_count = static_cast<std::size_t>(positions.shape(0));
    elements.dimension = static_cast<int>(positions.shape(1));
  }
  if (!given.dimension.is_none()) elements.dimension = whole_in(given.dimension, "dimension", 2, 3, "2 or 3");
  elements.faces = index_rows<3>(given.faces, "faces");
  elements.edges = index_rows<2>(given.edges, "edges");
  if (!given.points.is_none()) elements.points = indices(given.points, "points");
  elements.separation = {number_of(given.separation, "separation"), metric_of(given.metric)};
  elements.radii = numbers(given.radii, "radii");
  elements.rules.vertex_pairs = index_rows<2>(given.excluded_vertices, "excluded_vertices");
  for (const py::handle pair : given.excluded_pairs) elements.rules.element_pairs.push_back(pair_of(pair));
  elements.rules.groups = indices(given.groups, "groups");
  elements.rules.group_pairs = index_rows<2>(given.group_pairs, "group_pairs");
  if (given.only_listed_groups) elements.rules.group_rule = GroupRule::only_listed;
  for (const auto& [pair, distance] : given.pair_separations.cast<py::dict>()) {
    elements.pair_separations.push_back({pair_of(pair), number_of(distance, "a pair's separation")});
  }
  return elements;
}

template <std::size_t N>
py::array rows_of(const std::vector<std::array<MeshIndex, N>>& rows, py::handle owner) {
  py::array array(py::dtype::of<MeshIndex>(), {static_cast<py::ssize_t>(rows.size()), static_cast<py::ssize_t>(N)}, {},
                  rows.empty() ? nullptr : rows.data(), owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

constexpr char kMeshHelp[] = R"(A mesh whose elements were checked. It never changes, and several threads may use it.

Mesh(vertices, faces=None, edges=None, points=None, separation=0.0, metric='euclidean', radii=None, *, dimension=None,
     excluded_vertices=None, excluded_pairs=(), groups=None, group_pairs=None, only_listed_groups=False,
     pair_separations={})

vertices            the number of vertices, or their positions, an array of shape (n, 3) or (n, 2) of which only the
                    shape counts
faces               (m, 3) whole numbers: the corners of triangles, of any orientation
edges               (k, 2) whole numbers: edges. Those of the faces need not be given, and come after those given
points              the loose points: vertices in no edge that collide; None is every vertex in no edge
separation          the distance that every pair is to keep, in the unit of the positions
metric              'euclidean' or 'max'
radii               n numbers in place of separation: a pair keeps the sum of its two elements' radii, and an
                    element's radius is the largest of its vertices'
dimension           2 or 3, where vertices is a number
excluded_vertices   (k, 2): vertices that never collide with each other
excluded_pairs      pairs (kind, first, second) of elements that never collide
groups              n whole numbers: the group of each vertex
group_pairs         (k, 2): the pairs of groups that never collide, or with only_listed_groups the only ones that do
pair_separations    a dict from pairs (kind, first, second) to their own separations

Raises ValueError for an index out of range, an element that is given twice or has a repeated corner, and so on; the
message names the element.

>>> import touchstone
>>> touchstone.Mesh(7, faces=[[0, 1, 2], [3, 4, 5]])
<Mesh: 7 vertices, 2 faces, 6 edges, 1 loose points>)";

}  // namespace

py::object mesh_object(py::handle given) {
  if (py::isinstance<Mesh>(given)) return py::reinterpret_borrow<py::object>(given);
  return py::module_::import("touchstone._mesh_files").attr("as_argument")(given);
}

void define_mesh(py::module_& module) {
  py::class_<Mesh> bound = define_class<Mesh>(module, "Mesh", kMeshHelp);
  define_pickle(
      bound, [](const Mesh& mesh) { return mesh.elements(); },
      [](MeshElements&& elements) { return Mesh(std::move(elements)); });
  bound
      .def(py::init([](py::object vertices, py::object faces, py::object edges, py::object points,
                       py::object separation, py::object metric, py::object radii, py::object dimension,
                       py::object excluded_vertices, py::object excluded_pairs, py::object groups,
                       py::object group_pairs, bool only_listed_groups, py::object pair_separations) {
             MeshElements elements =
                 elements_of({vertices, faces, edges, points, separation, metric, radii, dimension, excluded_vertices,
                              excluded_pairs, groups, group_pairs, only_listed_groups, pair_separations});
             const std::size_t size = elements.vertex_count;
             Mesh mesh = in_background(size, [&](const std::atomic<bool>&) { return Mesh(std::move(elements)); });
             if (!mesh.has_pairs() &&
                 PyErr_WarnEx(PyExc_UserWarning,
                              "no two elements of this mesh may collide, so no question about it asks anything",
                              1) != 0) {
               throw py::error_already_set();
             }
             return mesh;
           }),
           py::arg("vertices"), py::arg("faces") = py::none(), py::arg("edges") = py::none(),
           py::arg("points") = py::none(), py::arg("separation") = 0.0, py::arg("metric") = "euclidean",
           py::arg("radii") = py::none(), py::kw_only(), py::arg("dimension") = py::none(),
           py::arg("excluded_vertices") = py::none(), py::arg("excluded_pairs") = py::tuple(),
           py::arg("groups") = py::none(), py::arg("group_pairs") = py::none(), py::arg("only_listed_groups") = false,
           py::arg("pair_separations") = py::dict())
      .def_property_readonly("vertex_count", &Mesh::vertex_count, "the number of vertices")
      .def_property_readonly("dimension", &Mesh::dimension, "2 or 3")
      .def_property_readonly(
          "metric", [](const Mesh& mesh) { return std::string(name_of(mesh.metric())); }, "'euclidean' or 'max'")
      .def_property_readonly(
          "faces", [](const py::object& self) { return rows_of(self.cast<const Mesh&>().faces(), self); },
          "(m, 3) uint32: the faces as they were given")
      .def_property_readonly(
          "edges", [](const py::object& self) { return rows_of(self.cast<const Mesh&>().edges(), self); },
          "(k, 2) uint32: the edges that were given, then those of the faces")
      .def_property_readonly(
          "points",
          [](const py::object& self) {
            const auto& points = self.cast<const Mesh&>().points();
            return column_of<MeshIndex>(points, points.data(), self);
          },
          "(p,) uint32: the loose points, in ascending order")
      .def("has_pairs", &Mesh::has_pairs,
           "Whether there are two elements that could meet, and two groups that may collide, if there are groups.")
      .def(
          "may_collide", [](const Mesh& mesh, py::handle pair) { return mesh.may_collide(pair_of(pair)); },
          py::arg("pair"), "Whether a pair (kind, first, second) is one that is asked about.")
      .def(
          "separation_of", [](const Mesh& mesh, py::handle pair) { return mesh.separation(pair_of(pair)).distance; },
          py::arg("pair"), "The separation of a pair (kind, first, second).")
      .def(
          "corners",
          [](const Mesh& mesh, py::handle given) {
            const MeshPair pair = pair_of(given);
            const auto corners = mesh.corners(pair);
            py::list list;
            for (std::size_t c = 0; c < corner_count(pair.kind); ++c) list.append(corners[c]);
            return list;
          },
          py::arg("pair"), "The vertices of a pair (kind, first, second), in the order of a query's corners.")
      .def("describe", &description, py::arg("pair"),
           "A pair (kind, first, second) for a person: 'edge 7 (3-4) and edge 9 (10-11)'; or one of Intersections:\n"
           "'edge 7 (3-4) pierces face 9 (10-11-12)'.")
      .def("__repr__", [](const Mesh& mesh) {
        return "<Mesh: " + std::to_string(mesh.vertex_count()) + " vertices, " + std::to_string(mesh.faces().size()) +
               " faces, " + std::to_string(mesh.edges().size()) + " edges, " + std::to_string(mesh.points().size()) +
               " loose points>";
      });
}

}  // namespace touchstone::python
