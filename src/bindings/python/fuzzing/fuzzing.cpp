// The fuzzer, for a solver that is a Python function.
// SPDX-License-Identifier: MIT
#include <touchstone/fuzz.hpp>

#include <pybind11/stl.h>

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

/// The corners as an array of doubles of shape (corners, 3), the caller's own.
py::array_t<double> corners_array(Kind kind, const std::array<Vec3, 4>& corners) {
  const auto count = static_cast<py::ssize_t>(corner_count(kind));
  py::array_t<double> array({count, static_cast<py::ssize_t>(3)});
  double* to = array.mutable_data();
  for (py::ssize_t i = 0; i < count; ++i) {
    const Vec3& x = corners[static_cast<std::size_t>(i)];
    *to++ = x.x;
    *to++ = x.y;
    *to++ = x.z;
  }
  return array;
}

/// @throws TypeError  always: the solver's reply is none
[[noreturn]] void refuse(const py::object& reply) {
  PyErr_Format(
      PyExc_TypeError,
      "the solver returned %.80R, of type %s; its reply must be a bool, a time, None for no contact, or a tuple "
      "(contact, toi) of a bool and a time or None",
      reply.ptr(), Py_TYPE(reply.ptr())->tp_name);
  throw py::error_already_set();
}

/// @param reply  what has the time
double time_of(const py::object& value, const py::object& reply) {
  return reply_number(value, [&reply] { refuse(reply); });
}

/// What the function returned: a bool, None for no contact, a time, or a pair of a bool and a time or None.
Claim claim_of(const py::object& reply) {
  if (reply.is_none()) return {};
  if (is_bool(reply)) return {reply.cast<bool>(), std::nullopt};
  if (py::isinstance<py::tuple>(reply)) {
    const auto pair = reply.cast<py::tuple>();
    if (pair.size() != 2 || !is_bool(pair[0])) refuse(reply);
    const py::object time = pair[1];
    const bool contact = py::object(pair[0]).cast<bool>();
    return {contact, time.is_none() || !contact ? std::nullopt : std::optional(time_of(time, reply))};
  }
  return {true, time_of(reply, reply)};
}

std::optional<std::uint64_t> ulps_or_none(py::handle value) {
  return value.is_none() ? std::nullopt : std::optional(value.cast<std::uint64_t>());
}

std::optional<double> fraction_or_none(py::handle value, const char* what) {
  return value.is_none() ? std::nullopt : std::optional(number_of(value, what));
}

FuzzReport fuzz(const py::object& solver, py::handle kinds, py::handle families, py::handle cases, py::handle seed,
                py::handle climb, py::handle distance, py::handle metric, py::handle early_ulps,
                py::handle early_fraction, py::handle late_ulps, py::handle late_fraction, py::handle near,
                py::handle failures, py::handle findings) {
  check_callable(solver, "kind, start, end");
  FuzzOptions options;
  options.cases = cases.cast<std::uint64_t>();
  options.seed = seed.cast<std::uint64_t>();
  options.climb = climb.cast<std::uint64_t>();
  options.findings = findings.cast<std::size_t>();
  options.separation = separation_of(distance, metric, 0, true).separation;
  options.early_ulps = ulps_or_none(early_ulps);
  options.early_fraction = fraction_or_none(early_fraction, "early_fraction");
  options.late_ulps = ulps_or_none(late_ulps);
  options.late_fraction = fraction_or_none(late_fraction, "late_fraction");
  options.near = number_of(near, "near");
  if (!failures.is_none()) {
    for (const py::handle name : failures) {
      const auto failure = from_name<FuzzFailure>(name.cast<std::string>());
      if (!failure) {
        std::string all;
        for (const std::string_view one : names_of<FuzzFailure>()) all.append(all.empty() ? "" : ", ").append(one);
        throw py::value_error("failures has '" + name.cast<std::string>() + "'; it must be of " + all);
      }
      options.failures.push_back(*failure);
    }
  }
  if (!kinds.is_none()) {
    for (const py::handle kind : kinds) options.kinds.push_back(kind_of(kind));
  }
  if (!families.is_none()) options.families = families.cast<std::vector<std::string>>();
  // The function runs under the lock: more threads than one would only wait for each other.
  std::optional<AskedFunction> asked;
  FuzzReport report = in_background(std::numeric_limits<std::size_t>::max(), [&](std::atomic<bool>& stop) {
    options.stop = &stop;
    asked.emplace(solver, stop);
    const auto ask = [&asked](const Query& query) {
      return asked->ask([&query](const py::object& function) {
        return claim_of(function(std::string(name_of(query.kind)), corners_array(query.kind, query.start),
                                 corners_array(query.kind, query.end)));
      });
    };
    return fuzz_solver(ask, options);
  });
  asked->rethrow();
  return report;
}

void define_finding(py::module_& module) {
  py::class_<FuzzFinding> bound = define_class<FuzzFinding>(
      module, "Finding", "All failures of one sort on queries that are degenerate in one way, with the simplest one.");
  define_pickle(bound);
  bound
      .def_property_readonly(
          "failure", [](const FuzzFinding& found) { return std::string(name_of(found.failure)); },
          "'crash', 'malformed', 'missed', 'late', 'nan', 'phantom' or 'early'")
      .def_readonly("degeneracy", &FuzzFinding::degeneracy, "the degeneracy in words")
      .def_readonly("count", &FuzzFinding::count, "how many queries failed in this way")
      .def_property_readonly(
          "kind", [](const FuzzFinding& found) { return std::string(name_of(found.query.kind)); },
          "the kind of the shrunk query")
      .def_property_readonly(
          "start", [](const FuzzFinding& found) { return corners_array(found.query.kind, found.query.start); },
          "(corners, 3) float64: its corners at t = 0")
      .def_property_readonly(
          "end", [](const FuzzFinding& found) { return corners_array(found.query.kind, found.query.end); },
          "(corners, 3) float64: its corners at t = 1")
      .def_property_readonly(
          "contact", [](const FuzzFinding& found) { return found.claim.contact; },
          "whether the solver claims a contact")
      .def_property_readonly(
          "toi", [](const FuzzFinding& found) { return found.claim.toi; }, "the claimed time, or None")
      .def_readonly("truth", &FuzzFinding::truth, "the exact Answer")
      .def_readonly("detail", &FuzzFinding::detail, "more about it, such as the text of an exception")
      .def_readonly("case_name", &FuzzFinding::case_name, "the query before it was shrunk, for touchstone fuzz --case")
      .def_property_readonly(
          "separation", [](const FuzzFinding& found) { return found.separation.distance; }, "what the solver was asked")
      .def_property_readonly(
          "metric",
          [](const FuzzFinding& found) { return found.separation.metric == Metric::max ? "max" : "euclidean"; },
          "'euclidean' or 'max'")
      .def("__repr__", [](const FuzzFinding& found) {
        std::string text = to_string(found);
        text.pop_back();  // the end of the last line
        return text;
      });
}

}  // namespace

void define_fuzzing(py::module_& module) {
  define_finding(module);
  py::class_<FuzzReport> bound = define_class<FuzzReport>(module, "FuzzReport", "What fuzz found.");
  define_pickle(bound);
  bound.def_readonly("queries", &FuzzReport::queries, "how many queries were asked and judged")
      .def_readonly("failures", &FuzzReport::failures, "how many replies were wrong")
      .def_readonly("allowed", &FuzzReport::allowed,
                    "how many wrong replies late_ulps, late_fraction, near and failures let pass")
      .def_readonly("kinds_of_failure", &FuzzReport::kinds_of_failure, "how many findings there are in all")
      .def_readonly("findings", &FuzzReport::findings, "a list of Finding, worst first")
      .def("__repr__", [](const FuzzReport& report) {
        return "<FuzzReport: " + std::to_string(report.queries) + " queries, " + std::to_string(report.failures) +
               " failures of " + std::to_string(report.kinds_of_failure) + " kinds" +
               (report.allowed > 0 ? ", " + std::to_string(report.allowed) + " allowed>" : ">");
      });
  module.def("fuzz", &fuzz);
}

}  // namespace touchstone::python
