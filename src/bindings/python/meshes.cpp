// Questions about whole meshes: intersections, first_contact, all_contacts, closest_approach, candidates,
// free_step, and MeshSteps.
// SPDX-License-Identifier: MIT
#include <touchstone/mesh.hpp>
#include <touchstone/mesh_steps.hpp>

#include <atomic>
#include <mutex>
#include <string>

#include "python/arguments.hpp"
#include "python/background.hpp"
#include "python/define.hpp"
#include "python/mesh_results.hpp"
#include "python/step_arguments.hpp"

namespace touchstone::python {
namespace {

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
      .def("__reduce__",  // a copy begins anew
           [](const py::object& self) { return py::make_tuple(py::type::of(self), py::make_tuple(self.attr("mesh"))); })
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
  define_mesh_results(module);
  define_steps(module);
  const py::arg of("mesh"), at("x"), from("x0"), to("x1"), until("t_max"), threads("threads"), check("check_start");
  module.def("first_contact",
             of_step([](const Mesh& mesh, const Positions& x0, const Positions& x1,
                        const FirstContactOptions& options) { return first_contact(mesh, x0, x1, options); }),
             of, from, to, until, threads, check);
  module.def("all_contacts",
             of_step([](const Mesh& mesh, const Positions& x0, const Positions& x1, const StepOptions& options) {
               return pairs_of(all_contacts(mesh, x0, x1, options));
             }),
             of, from, to, until, threads, check);
  module.def("closest_approach",
             of_step([](const Mesh& mesh, const Positions& x0, const Positions& x1, const StepOptions& options) {
               return closest_approach(mesh, x0, x1, options);
             }),
             of, from, to, until, threads, check);
  module.def("candidates",
             of_step([](const Mesh& mesh, const Positions& x0, const Positions& x1, const MeshOptions& options) {
               return Pairs{candidates(mesh, x0, x1, options), {}, {}};
             }),
             of, from, to, until, threads, check);
  module.def("intersections", of_positions([](const Mesh& mesh, const Positions& x, const MeshOptions& options) {
               return Intersections{intersections(mesh, x, options)};
             }),
             of, at, threads);
  module.def("intersects", of_positions([](const Mesh& mesh, const Positions& x, const MeshOptions& options) {
               return intersects(mesh, x, options);
             }),
             of, at, threads);
  module.def("free_step",
             of_free_step<const Mesh>([](const Mesh& mesh, const Positions& x0, const Positions& x1,
                                         const FreeStepOptions& options) { return free_step(mesh, x0, x1, options); }),
             of, from, to, py::arg("kept_fraction"), threads, check, py::arg("float32"));
}

}  // namespace touchstone::python
