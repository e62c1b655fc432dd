// The fuzzer of whole steps, for a broad phase or a step that is a Python function.
// SPDX-License-Identifier: MIT
#include <touchstone/fuzz.hpp>

#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "python/arguments.hpp"
#include "python/background.hpp"
#include "python/define.hpp"
#include "python/fuzzing/asked_function.hpp"
#include "python/pickles.hpp"

namespace touchstone::python {
namespace {

/// Positions as an array of doubles of shape (vertices, 3), the caller's own.
py::array_t<double> position_array(const double* from, std::size_t vertices) {
  py::array_t<double> array({static_cast<py::ssize_t>(vertices), static_cast<py::ssize_t>(3)});
  std::copy_n(from, 3 * vertices, array.mutable_data());
  return array;
}

/// The fuzzer's own positions: three doubles a vertex, one after another.
py::array_t<double> position_array(const Positions& positions) {
  return position_array(positions.data, positions.count);
}

/// @throws TypeError  always: the solver's reply is none
[[noreturn]] void refuse_step(const py::object& reply) {
  PyErr_Format(PyExc_TypeError,
               "the solver returned %.80R, of type %s; its reply must be the length of a free step, a number, or a "
               "dict with 'free', 'first_contact' and 'candidates', or some of them",
               reply.ptr(), Py_TYPE(reply.ptr())->tp_name);
  throw py::error_already_set();
}

/// What the function returned.
StepReply reply_of(const py::object& given) {
  const auto number = [&given](py::handle value) { return reply_number(value, [&given] { refuse_step(given); }); };
  StepReply reply;
  if (!py::isinstance<py::dict>(given)) {
    reply.free = number(given);
    return reply;
  }
  for (const auto& [key, value] : given.cast<py::dict>()) {
    const auto word = py::str(key).cast<std::string>();
    if (word == "free") {
      reply.free = number(value);
    } else if (word == "first_contact") {
      reply.first_contact = value.is_none() ? std::numeric_limits<double>::infinity() : number(value);
    } else if (word == "candidates") {
      reply.candidates.emplace();
      for (const py::handle pair : value) reply.candidates->push_back(pair_of(pair));
    } else {
      refuse_step(given);
    }
  }
  if (!reply.free && !reply.first_contact && !reply.candidates) refuse_step(given);
  return reply;
}

StepFuzzReport fuzz_steps_of(const py::object& solver, py::handle cases, py::handle seconds, py::handle families,
                             py::handle seed, py::handle separations, py::handle groups, py::handle may_end_in_contact,
                             py::handle stall, py::handle early_fraction, py::handle late_fraction, py::handle twice,
                             py::handle findings) {
  check_callable(solver, "mesh, x0, x1");
  StepFuzzOptions options;
  options.cases = cases.cast<std::uint64_t>();
  options.seed = seed.cast<std::uint64_t>();
  options.findings = findings.cast<std::size_t>();
  options.separations = separations.cast<bool>();
  options.groups = groups.cast<bool>();
  options.may_end_in_contact = may_end_in_contact.cast<bool>();
  options.twice = twice.cast<bool>();
  options.stall = number_of(stall, "stall");
  options.late_fraction = number_of(late_fraction, "late_fraction");
  if (!seconds.is_none()) options.seconds = number_of(seconds, "seconds");
  if (!early_fraction.is_none()) options.early_fraction = number_of(early_fraction, "early_fraction");
  if (!families.is_none()) options.families = families.cast<std::vector<std::string>>();
  // The function runs under the lock: more threads than one would only wait for each other.
  std::optional<AskedFunction> asked;
  StepFuzzReport report = in_background(std::numeric_limits<std::size_t>::max(), [&](std::atomic<bool>& stop) {
    options.stop = &stop;
    asked.emplace(solver, stop);
    return fuzz_steps(
        [&asked](const Mesh& mesh, const Positions& x0, const Positions& x1) {
          return asked->ask([&](const py::object& function) {
            return reply_of(function(mesh, position_array(x0), position_array(x1)));
          });
        },
        options);
  });
  asked->rethrow();
  if (report.steps == 0 && !report.stopped)
    throw py::value_error("no step was asked in this time: give more seconds, or cases");
  return report;
}

}  // namespace

void define_step_fuzzing(py::module_& module) {
  py::class_<StepFuzzFinding> finding = define_class<StepFuzzFinding>(
      module, "StepFinding", "All failures of one sort of whole steps, with the simplest step.");
  define_pickle(finding);
  const auto positions = [](std::vector<double> StepFuzzFinding::*of) {
    return [of](const StepFuzzFinding& found) { return position_array((found.*of).data(), found.mesh.vertex_count()); };
  };
  finding
      .def_property_readonly(
          "failure", [](const StepFuzzFinding& found) { return std::string(name_of(found.failure)); },
          "'crash', 'malformed', 'missed', 'late', 'phantom', 'early' or 'differs'")
      .def_readonly("question", &StepFuzzFinding::question, "'free', 'first contact', 'candidates' or 'all'")
      .def_readonly("detail", &StepFuzzFinding::detail, "the elements and the times in words")
      .def_readonly("count", &StepFuzzFinding::count, "how many steps failed in this way")
      .def_readonly("mesh", &StepFuzzFinding::mesh, "the shrunk Mesh")
      .def_property_readonly("x0", positions(&StepFuzzFinding::x0), "(vertices, 3) float64: the positions at t = 0")
      .def_property_readonly("x1", positions(&StepFuzzFinding::x1), "(vertices, 3) float64: the positions at t = 1")
      .def_readonly("case_name", &StepFuzzFinding::case_name, "the step before it was shrunk")
      .def("__repr__", [](const StepFuzzFinding& found) {
        std::string text = to_string(found);
        text.pop_back();  // the end of the last line
        return text;
      });
  py::class_<StepFuzzReport> report = define_class<StepFuzzReport>(module, "StepReport", "What fuzz_steps found.");
  define_pickle(report);
  report.def_readonly("steps", &StepFuzzReport::steps, "how many steps were asked and judged")
      .def_readonly("failures", &StepFuzzReport::failures, "how many of them had a wrong reply")
      .def_readonly("kinds_of_failure", &StepFuzzReport::kinds_of_failure, "how many findings there are in all")
      .def_readonly("left_out", &StepFuzzReport::left_out, "what meshes did not have: separations, groups")
      .def_readonly("findings", &StepFuzzReport::findings, "a list of StepFinding, worst first")
      .def("__repr__", [](const StepFuzzReport& found) {
        std::string text = "<StepReport: " + std::to_string(found.steps) + " steps, " + std::to_string(found.failures) +
                           " failures of " + std::to_string(found.kinds_of_failure) + " kinds";
        for (const std::string& what : found.left_out) text += "; " + what + " were left out";
        return text + ">";
      });
  module.def("fuzz_steps", &fuzz_steps_of);
}

}  // namespace touchstone::python
