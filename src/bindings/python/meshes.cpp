// Whole meshes: Mesh, intersections, first_contact, all_contacts, candidates, free_step.
// SPDX-License-Identifier: MIT
#include <touchstone/mesh.hpp>
#include <touchstone/mesh_steps.hpp>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>

#include "python/answers.hpp"
#include "python/arguments.hpp"
#include "python/background.hpp"
#include "python/define.hpp"
#include "python/step_arguments.hpp"

namespace touchstone::python {
namespace {

/// Pairs of elements and, of contacts, the answers to their queries.
struct Pairs {
  using BoundToPython = void;

  std::vector<MeshPair> pairs;
  std::vector<double> separations;
  std::vector<Answer> answers;
};

Pairs pairs_of(const std::vector<MeshContact>& contacts) {
  Pairs all;
  for (const MeshContact& contact : contacts) {
    all.pairs.push_back(contact.pair);
    all.separations.push_back(contact.separation.distance);
    all.answers.push_back(contact.answer);
  }
  return all;
}

MeshPair pair_at(const Pairs& pairs, py::ssize_t i) {
  const auto size = static_cast<py::ssize_t>(pairs.pairs.size());
  if (i < -size || i >= size) {
    throw py::index_error("there is no pair " + std::to_string(i) + "; there are " + std::to_string(size));
  }
  return pairs.pairs[static_cast<std::size_t>(i < 0 ? i + size : i)];
}

py::tuple tuple_of(const MeshPair& pair) {
  return py::make_tuple(std::string(name_of(pair.kind)), pair.first, pair.second);
}

/// A pair as Python gives it: (kind, first, second).
MeshPair pair_of(py::handle given) {
  if (!py::isinstance<py::tuple>(given) || py::len(given) != 3) {
    throw py::value_error("a pair is a tuple (kind, first, second), not " + std::string(py::str(py::repr(given))));
  }
  const auto pair = py::reinterpret_borrow<py::tuple>(given);
  const auto number = [&](std::size_t i) {
    constexpr long long kMost = 4294967294;
    int too_long = 0;
    const long long value = PyLong_AsLongLongAndOverflow(pair[i].ptr(), &too_long);
    if (PyErr_Occurred() != nullptr) throw py::error_already_set();
    if (too_long != 0 || value < 0 || value > kMost) {
      throw py::value_error("the pair " + std::string(py::str(py::repr(given))) +
                            " has an index outside [0, 2^32 - 2]");
    }
    return static_cast<MeshIndex>(value);
  };
  return {kind_of(pair[0]), number(1), number(2)};
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
  if (!given.dimension.is_none()) elements.dimension = given.dimension.cast<int>();
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

/// MeshSteps for Python, where several threads may use one object: their questions are asked one after another.
struct SharedSteps {
  using BoundToPython = void;

  explicit SharedSteps(const Mesh& mesh) : steps(mesh) {}
  MeshSteps steps;
  std::mutex lock;
};

const Mesh& mesh_of(const Mesh& mesh) { return mesh; }
const Mesh& mesh_of(const SharedSteps& shared) { return shared.steps.mesh(); }

template <class Ask>
auto asked(const Mesh&, const Ask& ask) {
  return ask();
}
template <class Ask>
auto asked(SharedSteps& shared, const Ask& ask) {
  const std::lock_guard<std::mutex> guard(shared.lock);
  return ask();
}

/// Asks a question about a step of a mesh, or of its SharedSteps. The function reads of the options what it has.
template <class Of, class Options, class Function>
auto ask_about_step(Of& of, py::handle x0, py::handle x1, Options options, const Function& function) {
  const Mesh& mesh = mesh_of(of);
  const PositionArray start(x0, mesh, "x0"), end(x1, mesh, "x1");
  return in_background(mesh.vertex_count(), [&](const std::atomic<bool>& stop) {
    options.stop = &stop;
    return asked(of, [&] { return function(of, start.view(), end.view(), options); });
  });
}

template <class Of = const Mesh, class Function>
auto of_step(const Function& function) {
  return [function](Of& of, py::handle x0, py::handle x1, py::handle t_max, py::handle threads, bool check_start) {
    FirstContactOptions options = options_of(t_max, threads);
    options.check_start = check_start;
    return ask_about_step(of, x0, x1, options, function);
  };
}

struct Intersections {
  using BoundToPython = void;

  std::vector<Intersection> all;
};

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

void define_mesh(py::module_& module) {
  define_class<Mesh>(module, "Mesh", kMeshHelp)
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
          "Whether a pair (kind, first, second) is one that is asked about.")
      .def(
          "separation_of", [](const Mesh& mesh, py::handle pair) { return mesh.separation(pair_of(pair)).distance; },
          "The separation of a pair (kind, first, second).")
      .def(
          "corners",
          [](const Mesh& mesh, py::handle given) {
            const MeshPair pair = pair_of(given);
            const auto corners = mesh.corners(pair);
            py::list list;
            for (std::size_t c = 0; c < corner_count(pair.kind); ++c) list.append(corners[c]);
            return list;
          },
          "The vertices of a pair (kind, first, second), in the order of a query's corners.")
      .def(
          "describe", [](const Mesh& mesh, py::handle pair) { return mesh.describe(pair_of(pair)); },
          "A pair (kind, first, second) for a person: 'edge 7 (3-4) and edge 9 (10-11)'.")
      .def("__repr__", [](const Mesh& mesh) {
        return "<Mesh: " + std::to_string(mesh.vertex_count()) + " vertices, " + std::to_string(mesh.faces().size()) +
               " faces, " + std::to_string(mesh.edges().size()) + " edges, " + std::to_string(mesh.points().size()) +
               " loose points>";
      });
}

void define_pairs(py::module_& module) {
  py::class_<Pairs> pairs = define_class<Pairs>(
      module, "Pairs", "Pairs of elements: arrays that cannot be written to. pairs[i] is (kind, first, second).");
  pairs.def("__len__", [](const Pairs& self) { return self.pairs.size(); })
      .def("__getitem__", [](const Pairs& self, py::ssize_t i) { return tuple_of(pair_at(self, i)); })
      .def("__repr__", [](const Pairs& self) { return "<Pairs: " + std::to_string(self.pairs.size()) + ">"; })
      .def_property_readonly(
          "kind",
          [](const Pairs& self) {
            py::list kinds;
            for (const MeshPair& pair : self.pairs) kinds.append(py::str(std::string(name_of(pair.kind))));
            return kinds;
          },
          "a list of the kinds: 'edge-edge', 'vertex-face', 'point-edge' or 'point-point'")
      .def_property_readonly(
          "first",
          [](const py::object& self) {
            const auto& all = self.cast<const Pairs&>().pairs;
            return column_of<MeshIndex>(all, all.empty() ? nullptr : &all[0].first, self);
          },
          "(n,) uint32: the numbers of the first elements, edges or vertices")
      .def_property_readonly(
          "second",
          [](const py::object& self) {
            const auto& all = self.cast<const Pairs&>().pairs;
            return column_of<MeshIndex>(all, all.empty() ? nullptr : &all[0].second, self);
          },
          "(n,) uint32: the numbers of the second elements, edges, faces or vertices")
      .def_property_readonly(
          "separation",
          [](const py::object& self) {
            const auto& all = self.cast<const Pairs&>().separations;
            return column_of<double>(all, all.data(), self);
          },
          "of contacts: (n,) float64, the separations that they are about")
      .def_property_readonly(
          "answers", [](const Pairs& self) { return Answers(self.answers); },
          "of contacts: the Answers to the pairs' queries");
}

void define_intersections(py::module_& module) {
  py::class_<Intersections> found = define_class<Intersections>(
      module, "Intersections", "Where a mesh intersects itself: arrays that cannot be written to.");
  found.def("__len__", [](const Intersections& self) { return self.all.size(); })
      .def("__repr__",
           [](const Intersections& self) { return "<Intersections: " + std::to_string(self.all.size()) + ">"; });
  const auto names = [&](const char* name, auto member, const char* help) {
    const auto get = [member](const Intersections& self) {
      py::list elements;
      for (const Intersection& one : self.all) elements.append(std::string(name_of(one.*member)));
      return elements;
    };
    found.def_property_readonly(name, get, help);
  };
  names("first_element", &Intersection::first_element, "a list of 'edge' or 'vertex'");
  names("second_element", &Intersection::second_element, "a list of 'face', 'edge' or 'vertex'");
  const auto column = [&](const char* name, auto member, auto number, std::size_t width, const char* help) {
    const auto get = [member, number, width](const py::object& self) {
      static_cast<void>(number);
      const auto& all = self.cast<const Intersections&>().all;
      return column_of<decltype(number)>(all, all.empty() ? nullptr : &(all[0].*member), self, width);
    };
    found.def_property_readonly(name, get, help);
  };
  column("first", &Intersection::first, MeshIndex(), 0, "(n,) uint32: the numbers of the first elements");
  column("second", &Intersection::second, MeshIndex(), 0, "(n,) uint32: the numbers of the second elements");
  found.def_property_readonly(
      "sort",
      [](const Intersections& self) {
        py::list sorts;
        for (const Intersection& one : self.all) sorts.append(std::string(name_of(one.sort)));
        return sorts;
      },
      "a list of 'touches', 'pierces', 'folds' or 'inside'");
  found.def_property_readonly(
      "pierces",
      [](const Intersections& self) {
        py::array_t<bool> pierces(static_cast<py::ssize_t>(self.all.size()));
        bool* next = pierces.mutable_data();
        for (const Intersection& one : self.all) *next++ = one.sort == IntersectionSort::pierces;
        py::detail::array_proxy(pierces.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
        return pierces;
      },
      "(n,) bool: whether the edge passes through");
  column("weights_first", &Intersection::weights_first, double(), 3,
         "(n, 3) float64: a common point, as barycentric coordinates on the first element");
  column("weights_second", &Intersection::weights_second, double(), 3, "(n, 3) float64: on the second element");
}

void define_first_contact(py::module_& module) {
  define_class<FirstContact>(module, "FirstContact", "The first contact of a mesh in a step.")
      .def_readonly("contact", &FirstContact::contact,
                    "whether elements that are not in contact at the start come into contact")
      .def_readonly("toi", &FirstContact::toi, "the largest double <= the exact first time of it; inf without one")
      .def_readonly("toi_upper", &FirstContact::toi_upper, "the smallest double >= it")
      .def_property_readonly("free", &FirstContact::free,
                             "whether there is no contact at all in the step, and no intersection at the start, if "
                             "start_checked")
      .def_readonly("start_checked", &FirstContact::start_checked,
                    "whether the start was asked about, by check_start=True")
      .def_property_readonly(
          "start_intersections", [](const FirstContact& self) { return Intersections{self.start_intersections}; },
          "Intersections: where the mesh intersects itself at the start; empty when that was not asked")
      .def_property_readonly(
          "first", [](const FirstContact& self) { return pairs_of(self.first); },
          "Pairs: every pair whose contact begins at exactly that time")
      .def_property_readonly(
          "at_start", [](const FirstContact& self) { return pairs_of(self.at_start); },
          "Pairs: every pair in contact at t = 0")
      .def("__repr__", [](const FirstContact& self) {
        if (self.free()) {
          return std::string(self.start_checked ? "<FirstContact: free>" : "<FirstContact: free, start not checked>");
        }
        if (!self.start_intersections.empty()) {
          return "<FirstContact: " + std::to_string(self.start_intersections.size()) + " intersections at the start>";
        }
        return "<FirstContact: toi " + std::string(py::repr(py::float_(self.toi))) + ", " +
               std::to_string(self.first.size()) + " first, " + std::to_string(self.at_start.size()) + " at the start>";
      });
}

/// The outcome's name, in which '_' stands for '-' as in Python's own names.
std::string outcome_text(StepOutcome outcome) {
  std::string name(name_of(outcome));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// A free step, and how many coordinates a vertex has.
struct Step {
  using BoundToPython = void;

  FreeStep step;
  int dimension;
};

void define_free_step(py::module_& module) {
  define_class<Step>(module, "FreeStep", "A step that is proved free of contact.")
      .def_property_readonly(
          "outcome", [](const Step& self) { return outcome_text(self.step.outcome); },
          "'whole', 'shortened', 'no_room', 'contact_at_start' or 'intersects_at_start'")
      .def_property_readonly(
          "length", [](const Step& self) { return self.step.length; }, "the fraction of the step, in [0, 1]")
      .def_property_readonly(
          "positions",
          [](const py::object& self) {
            const Step& step = self.cast<const Step&>();
            const auto& all = step.step.positions;
            return py::array(py::dtype::of<double>(),
                             {static_cast<py::ssize_t>(all.size()) / step.dimension, py::ssize_t{step.dimension}}, {},
                             all.data(), self);
          },
          "(n, dimension) float64: the end; the path to it, rounded as it is, is free")
      .def_property_readonly(
          "first_contact", [](const Step& self) { return self.step.first_contact; },
          "FirstContact: that of the whole step, about the distances to keep")
      .def_property_readonly(
          "proofs", [](const Step& self) { return self.step.proofs; },
          "the number of times that all pairs were asked about")
      .def("__repr__", [](const Step& self) {
        return std::string("<FreeStep: ") + outcome_text(self.step.outcome) + ", length " +
               std::string(py::repr(py::float_(self.step.length))) +
               (self.step.first_contact.start_checked ? ">" : ", start not checked>");
      });
}

template <class Of, class Function>
auto of_free_step(const Function& function) {
  return [function](Of& of, py::handle x0, py::handle x1, py::handle fraction, py::handle threads, bool check_start,
                    bool float32) {
    FreeStepOptions options;
    options.kept_fraction = number_of(fraction, "kept_fraction");
    options.threads = threads_of(threads);
    options.check_start = check_start;
    options.float32 = float32;
    const auto step = [&](auto& asked_of, const Positions& start, const Positions& end, const FreeStepOptions& with) {
      return Step{function(asked_of, start, end, with), mesh_of(of).dimension()};
    };
    return ask_about_step(of, x0, x1, options, step);
  };
}

std::size_t searches_of(SharedSteps& shared) {
  const py::gil_scoped_release released;
  return asked(shared, [&] { return shared.steps.searches(); });
}

constexpr char kStepsHelp[] = R"(Questions about many steps of one mesh, such as the tries of a line search.

The methods are the functions first_contact, all_contacts and free_step without their first argument. The results are
the same, bit for bit, and come sooner where a step is much like an earlier one, because memory and the pairs that may
meet are kept. Several threads may use one object: their calls are answered one after another.

>>> import touchstone
>>> steps = touchstone.MeshSteps(touchstone.Mesh(2))
>>> x0, x1 = [[0, 0, 0], [1, 0, 0]], [[4, 0, 0], [1, 0, 0]]
>>> [steps.first_contact(x0, [[4 * s, 0, 0], [1, 0, 0]]).toi for s in (1, 0.5)]
[0.25, 0.5]
>>> steps
<MeshSteps: searches=1>)";

void define_steps(py::module_& module) {
  const auto t_max = py::arg("t_max") = 1.0;
  const auto threads = py::arg("threads") = 1;
  const auto check_start = py::arg("check_start") = false;
  define_class<SharedSteps>(module, "MeshSteps", kStepsHelp)
      .def(py::init<const Mesh&>(), py::arg("mesh"))
      .def("first_contact",
           of_step<SharedSteps>(
               [](SharedSteps& shared, const Positions& x0, const Positions& x1, const FirstContactOptions& options) {
                 return shared.steps.first_contact(x0, x1, options);
               }),
           py::arg("x0"), py::arg("x1"), t_max, threads, py::kw_only(), check_start,
           "As the function first_contact, without its mesh.")
      .def(
          "all_contacts",
          [](SharedSteps& shared, py::handle x0, py::handle x1, py::handle until, py::handle thread_count) {
            const auto ask = of_step<SharedSteps>(
                [](SharedSteps& of, const Positions& start, const Positions& end, const StepOptions& options) {
                  return pairs_of(of.steps.all_contacts(start, end, options));
                });
            return ask(shared, x0, x1, until, thread_count, false);
          },
          py::arg("x0"), py::arg("x1"), t_max, threads, "As the function all_contacts, without its mesh.")
      .def("free_step",
           of_free_step<SharedSteps>(
               [](SharedSteps& shared, const Positions& x0, const Positions& x1, const FreeStepOptions& options) {
                 return shared.steps.free_step(x0, x1, options);
               }),
           py::arg("x0"), py::arg("x1"), py::arg("kept_fraction") = 0.0, threads, py::kw_only(), check_start,
           py::arg("float32") = false, "As the function free_step, without its mesh.")
      .def(
          "release",
          [](SharedSteps& shared) {
            const py::gil_scoped_release released;
            asked(shared, [&] { shared.steps.release(); });
          },
          "Gives the memory back. The next question is as the first one.")
      .def_property_readonly(
          "mesh", [](const SharedSteps& shared) { return shared.steps.mesh(); }, "the Mesh")
      .def_property_readonly("searches", &searches_of, "how many times the boxes of all elements were compared")
      .def("__repr__",
           [](SharedSteps& shared) { return "<MeshSteps: searches=" + std::to_string(searches_of(shared)) + ">"; });
}

/// A question about positions: ask(mesh, x, options).
template <class Ask>
auto of_positions(const Ask& ask) {
  return [ask](const Mesh& mesh, py::handle x, py::handle threads) {
    const PositionArray positions(x, mesh, "x");
    MeshOptions options;
    options.threads = threads_of(threads);
    return in_background(mesh.vertex_count(), [&](const std::atomic<bool>& stop) {
      options.stop = &stop;
      return ask(mesh, positions.view(), options);
    });
  };
}

}  // namespace

void define_meshes(py::module_& module) {
  define_mesh(module);
  define_pairs(module);
  define_intersections(module);
  define_first_contact(module);
  define_free_step(module);
  define_steps(module);
  module.def("first_contact",
             of_step([](const Mesh& mesh, const Positions& x0, const Positions& x1,
                        const FirstContactOptions& options) { return first_contact(mesh, x0, x1, options); }));
  module.def("all_contacts",
             of_step([](const Mesh& mesh, const Positions& x0, const Positions& x1, const StepOptions& options) {
               return pairs_of(all_contacts(mesh, x0, x1, options));
             }));
  module.def("candidates",
             of_step([](const Mesh& mesh, const Positions& x0, const Positions& x1, const MeshOptions& options) {
               return Pairs{candidates(mesh, x0, x1, options), {}, {}};
             }));
  module.def("intersections", of_positions([](const Mesh& mesh, const Positions& x, const MeshOptions& options) {
               return Intersections{intersections(mesh, x, options)};
             }));
  module.def("intersects", of_positions([](const Mesh& mesh, const Positions& x, const MeshOptions& options) {
               return intersects(mesh, x, options);
             }));
  module.def("free_step",
             of_free_step<const Mesh>([](const Mesh& mesh, const Positions& x0, const Positions& x1,
                                         const FreeStepOptions& options) { return free_step(mesh, x0, x1, options); }));
}

}  // namespace touchstone::python
