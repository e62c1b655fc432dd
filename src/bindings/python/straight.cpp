// Questions about straight queries, and the times and distances of all sorts.
// SPDX-License-Identifier: MIT
#include "python/define.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/solve.hpp>
#include <touchstone/toi_gradient.hpp>

#include "python/answers.hpp"
#include "python/arguments.hpp"
#include "python/background.hpp"
#include "python/items.hpp"
#include "python/pickles.hpp"
#include "python/query_arrays.hpp"
#include "python/questions.hpp"
#include "threads/for_each_range.hpp"

namespace touchstone::python {

QueryArrays::QueryArrays(py::handle kind_name, py::handle start_values, py::handle end_values)
    : kind(kind_of(kind_name)), start(start_values, kind, "start"), end(end_values, kind, "end") {
  if (start.count() != end.count() || start.is_single() != end.is_single()) {
    const auto rows = [](const CornerArray& corners) {
      return corners.is_single() ? std::string("one query") : std::to_string(corners.count()) + " queries";
    };
    throw py::value_error("start has " + rows(start) + " and end has " + rows(end) + "; they must have the same");
  }
  if (start.is_plane() != end.is_plane()) {
    throw py::value_error(std::string("start has ") + (start.is_plane() ? "2" : "3") +
                          " coordinates a corner and end " + (end.is_plane() ? "2" : "3") +
                          "; they must have the same");
  }
}

Query QueryArrays::at(std::size_t q) const noexcept {
  Query query;
  query.kind = kind;
  start.read(q, query.start);
  end.read(q, query.end);
  return query;
}

namespace {

constexpr std::size_t kBlock = 256;  // queries whose columns stay in a core's cache: 48 KiB

/// Answers queries [first, last) into answers[first] and so on.
class Batch {
 public:
  Batch(const QueryArrays& queries, const SeparationArgument& separation, const BatchOptions& options)
      : queries_(queries), separation_(separation), options_(options) {
    direct_ = queries.start.has_columns() && queries.end.has_columns();
  }

  void solve(std::size_t first, std::size_t last, Answer* answers) const {
    if (direct_) return solve_columns(first, last, answers);
    threads::for_each_range(last - first, kBlock, options_.threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t at = first + begin; at < first + end; at += kBlock) {
        solve_copied(at, std::min(kBlock, first + end - at), answers);
      }
    });
  }

 private:
  /// The options of a batch of queries from `first` on.
  BatchOptions options_for(std::size_t first, std::size_t size, int threads) const {
    BatchOptions options = options_;
    options.threads = threads;
    if (!separation_.separations.empty()) {
      options.separation.distance = 0;
      options.separations = separation_.separations.data() + first;
      options.separation_count = size;
    }
    return options;
  }

  void solve_columns(std::size_t first, std::size_t last, Answer* answers) const {
    const std::vector<double> zeros(queries_.start.is_plane() || queries_.end.is_plane() ? last - first : 0);
    QueryColumns columns;
    columns.kind = queries_.kind;
    columns.count = last - first;
    for (std::size_t c = 0; c < corner_count(queries_.kind); ++c) {
      for (std::size_t k = 0; k < 3; ++k) {
        columns.start[c][k] = queries_.start.column(first, c, k, zeros.data());
        columns.end[c][k] = queries_.end.column(first, c, k, zeros.data());
      }
    }
    solve_batch(columns, answers + first, options_for(first, columns.count, options_.threads));
  }

  void solve_copied(std::size_t first, std::size_t size, Answer* answers) const {
    std::array<double, 24 * kBlock> values;
    const std::size_t corners = corner_count(queries_.kind);
    double* const starts = values.data();
    double* const ends = starts + 3 * corners * size;
    queries_.start.copy_columns(first, size, starts);
    queries_.end.copy_columns(first, size, ends);
    QueryColumns columns;
    columns.kind = queries_.kind;
    columns.count = size;
    for (std::size_t i = 0; i < 3 * corners; ++i) {
      columns.start[i / 3][i % 3] = starts + i * size;
      columns.end[i / 3][i % 3] = ends + i * size;
    }
    solve_batch(columns, answers + first, options_for(first, size, 1));
  }

  const QueryArrays& queries_;
  const SeparationArgument& separation_;
  const BatchOptions& options_;
  bool direct_ = false;
};

py::object solve_arrays(py::handle kind, py::handle start, py::handle end, py::handle t_max, py::handle separation,
                        py::handle metric, py::handle threads, py::handle method, py::handle wanted) {
  const QueryArrays queries(kind, start, end);
  const SeparationArgument kept = separation_of(separation, metric, queries.count(), queries.is_single());
  BatchOptions options;
  options.t_max = number_of(t_max, "t_max");
  options.threads = threads_of(threads);
  options.method = method_of(method);
  options.wanted = wanted_of(wanted);
  options.separation = kept.separation;
  if (queries.is_single()) {
    const Query query = queries.at(0);
    return py::cast(unlocked([&] {
      return solve(
          query,
          {.t_max = options.t_max, .separation = kept.separation, .method = options.method, .wanted = options.wanted});
    }));
  }
  check_options(kept.separation, options.t_max);
  std::vector<Answer> answers(queries.count());
  const Batch batch(queries, kept, options);
  const auto ask = [&](std::size_t q) {
    solve(queries.at(q), {.t_max = options.t_max, .separation = kept.of(q), .method = options.method});
  };
  in_chunks(answers.size(), kFirst, [&](std::size_t first, std::size_t last) {
    naming_the_row(
        first, last, [&] { batch.solve(first, last, answers.data()); }, ask);
  });
  return py::cast(Answers(std::move(answers)));
}

/// Negative, zero or positive, as `time` is before, at or after the other one, a number or an ExactTime.
std::optional<int> compare(const ExactTime& time, py::handle other) {
  if (py::isinstance<ExactTime>(other)) return time.compare(other.cast<const ExactTime&>());
  if (PyFloat_Check(other.ptr())) {
    const double number = PyFloat_AS_DOUBLE(other.ptr());
    if (number == std::numeric_limits<double>::infinity()) return -1;
    if (number == -std::numeric_limits<double>::infinity()) return 1;
    if (number != number) return std::nullopt;
    return time.compare(number);
  }
  if (py::hasattr(other, "numerator") && py::hasattr(other, "denominator")) {  // int, Fraction
    return time.compare(Fraction{py::str(other.attr("numerator")), py::str(other.attr("denominator"))});
  }
  return std::nullopt;
}

template <class Holds>
auto comparison(const Holds& holds) {
  return [holds](const ExactTime& time, py::handle other) -> py::object {
    const std::optional<int> order = compare(time, other);
    if (!order) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
    return py::bool_(holds(*order));
  };
}

void define_times(py::module_& module) {
  define_class<ExactTime>(
      module, "ExactTime",
      "An exact time in [0, 1]: a rational or algebraic number. Comparisons with another one, an int,\n"
      "a float or a fractions.Fraction are exact. str() gives '1/3', or the polynomial whose root it "
      "is.")
      .def_property_readonly("lower", &ExactTime::lower, "the largest double <= this time; float() gives it too")
      .def_property_readonly("upper", &ExactTime::upper, "the smallest double >= this time")
      .def("__float__", &ExactTime::lower)
      .def("__str__", &ExactTime::to_string)
      .def("__copy__", [](const py::object& self) { return self; })
      .def("__deepcopy__", [](const py::object& self, py::handle) { return self; })
      .def("__repr__", [](const ExactTime& time) { return "<ExactTime " + time.to_string() + ">"; })
      .def("__eq__", comparison([](int order) { return order == 0; }))
      .def("__ne__", comparison([](int order) { return order != 0; }))
      .def("__lt__", comparison([](int order) { return order < 0; }))
      .def("__le__", comparison([](int order) { return order <= 0; }))
      .def("__gt__", comparison([](int order) { return order > 0; }))
      .def("__ge__", comparison([](int order) { return order >= 0; }))
      .attr("__hash__") = py::none();
}

void define_distances(py::module_& module) {
  const auto weights = [](const std::array<double, 3>& w) { return py::make_tuple(w[0], w[1], w[2]); };
  py::class_<Distance> one = define_class<Distance>(
      module, "Distance", "The distance of two elements at one instant, and their closest points.");
  define_pickle(one);
  one.def_readonly("value", &Distance::value, "the double nearest to the exact distance")
      .def_property_readonly("feature_a", [](const Distance& d) { return name_object(d.feature_a); })
      .def_property_readonly("feature_b", [](const Distance& d) { return name_object(d.feature_b); })
      .def_property_readonly("weights_a", [weights](const Distance& d) { return weights(d.weights_a); })
      .def_property_readonly("weights_b", [weights](const Distance& d) { return weights(d.weights_b); })
      .def("__float__", [](const Distance& d) { return d.value; })
      .def("__repr__", [](const Distance& d) {
        return "Distance(value=" + std::string(py::repr(py::float_(d.value))) +
               ", feature_a=" + std::string(name_of(d.feature_a)) + ", feature_b=" + std::string(name_of(d.feature_b)) +
               ")";
      });
  py::class_<Distances> distances =
      define_class<Distances>(module, "Distances", "The distances of n queries: arrays that cannot be written to.");
  define_pickle(
      distances, [](const Distances& self) { return self.all; },
      [](std::vector<Distance>&& all) { return Distances{std::move(all)}; });
  const auto items = [](const Distances& self) -> const std::vector<Distance>& { return self.all; };
  define_items(
      distances, "distance", items, [](const Distance& distance) { return distance; },
      [](const Distances& self, const std::vector<std::size_t>& chosen) {
        return Distances{items_at(self.all, chosen)};
      });
  distances.def("__repr__",
                [](const Distances& self) { return "<Distances: " + std::to_string(self.all.size()) + ">"; });
  const auto column = [&](const char* name, auto member, auto number, std::size_t width, const char* help) {
    const auto get = [member, number, width](const py::object& self) {
      static_cast<void>(number);
      const auto& all = self.cast<const Distances&>().all;
      return column_of<decltype(number)>(all, all.empty() ? nullptr : &(all[0].*member), self, width);
    };
    distances.def_property_readonly(name, get, help);
  };
  column("value", &Distance::value, double(), 0, "(n,) float64: the doubles nearest to the exact distances");
  column("feature_a", &Distance::feature_a, std::uint8_t(), 0, "(n,) uint8: codes of Feature");
  column("feature_b", &Distance::feature_b, std::uint8_t(), 0, "(n,) uint8: codes of Feature");
  column("weights_a", &Distance::weights_a, double(), 3, "(n, 3) float64: closest points of the first elements");
  column("weights_b", &Distance::weights_b, double(), 3, "(n, 3) float64: closest points of the second elements");
}

/// A gradient that does not exist is NaN.
py::object gradients_of(const QueryArrays& queries, py::handle t_max, py::handle separation, py::handle threads) {
  const std::size_t corners = corner_count(queries.kind);
  return numbers_of(queries, t_max, separation, threads, {2, static_cast<py::ssize_t>(corners), 3},
                    [corners](const Query& query, const Separation& kept, double until, double* to) {
                      const ToiGradient gradient = toi_gradient(query, kept, until);
                      for (const auto* side : {&gradient.start, &gradient.end}) {
                        for (std::size_t c = 0; c < corners; ++c) {
                          const Vec3& g = (*side)[c];
                          for (const double x : {g.x, g.y, g.z}) {
                            *to++ = gradient.exists ? x : std::numeric_limits<double>::quiet_NaN();
                          }
                        }
                      }
                    });
}

}  // namespace

void define_queries(py::module_& module) {
  define_times(module);
  define_distances(module);
  module.def("kind_name", [](py::handle kind) { return std::string(name_of(kind_of(kind))); });
  module.def("solve", &solve_arrays);
  module.def("contact_times", [](py::handle kind, py::handle start, py::handle end, py::handle t_max,
                                 py::handle separation, py::handle metric, py::handle threads) {
    return contact_times_of(QueryArrays(kind, start, end), t_max, separation, metric, threads);
  });
  module.def("distance",
             [](py::handle kind, py::handle start, py::handle end, py::handle t, py::handle metric,
                py::handle threads) { return distances_of(QueryArrays(kind, start, end), t, metric, threads); });
  module.def("contact_normal", [](py::handle kind, py::handle start, py::handle end, py::handle t_max,
                                  py::handle separation, py::handle threads) {
    return contact_normals_of(QueryArrays(kind, start, end), t_max, separation, threads);
  });
  module.def("toi_gradient", [](py::handle kind, py::handle start, py::handle end, py::handle t_max,
                                py::handle separation, py::handle threads) {
    return gradients_of(QueryArrays(kind, start, end), t_max, separation, threads);
  });
}

}  // namespace touchstone::python
