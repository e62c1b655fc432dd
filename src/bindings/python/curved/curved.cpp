// Queries about bodies that turn and corners on curves.
// SPDX-License-Identifier: MIT
#include <touchstone/curved.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/kind_traits.hpp"
#include "python/answers.hpp"
#include "python/arguments.hpp"
#include "python/curved/curved_queries.hpp"
#include "python/curved/number_table.hpp"
#include "python/define.hpp"
#include "python/questions.hpp"

namespace touchstone::python {
namespace {

Vec3 vector_at(const double* x) { return {x[0], x[1], x[2]}; }

/// The corners of one element of each query: on a body, or on curves.
class Element {
 public:
  /// @param values  (corners, q0, q1, p0, p1), or (control_points,)
  Element(const py::tuple& values, const std::string& what, std::size_t corners) : corners_(corners) {
    const auto count = static_cast<py::ssize_t>(corners);
    const auto add = [&](std::size_t i, const char* name, const std::vector<py::ssize_t>& shape) {
      names_.push_back(what + "." + name);
      tables_.emplace_back(values[i], names_.back().c_str(), shape);
    };
    if (values.size() == 1) {
      const py::array given = exact_array(values[0], (what + ".control_points").c_str());
      points_ = given.ndim() >= 3 ? given.shape(given.ndim() - 2) : 0;
      if (points_ < 1 || points_ > 4) {
        throw py::value_error(what + ".control_points has the shape " + shape_text(given) + "; it must be (n, " +
                              std::to_string(corners) + ", m, 3) or (" + std::to_string(corners) +
                              ", m, 3), with 1 to 4 control points for each corner");
      }
      add(0, "control_points", {count, points_, 3});
      return;
    }
    add(0, "corners", {count, 3});
    add(1, "q0", {4});
    add(2, "q1", {4});
    add(3, "p0", {3});
    add(4, "p1", {3});
  }

  /// Compares the numbers of rows with those of other tables. @param count  the rows so far, and `first` has them
  void count_rows(std::optional<std::size_t>& count, std::string& first) const {
    for (std::size_t i = 0; i < tables_.size(); ++i) {
      const auto rows = tables_[i].count();
      if (!rows) continue;
      if (count && *count != *rows) {
        throw py::value_error(first + " has " + std::to_string(*count) + " rows and " + names_[i] + " has " +
                              std::to_string(*rows) + "; they must have the same");
      }
      if (!count) first = names_[i];
      count = rows;
    }
  }

  /// Sets the corners from `corner` on, and the motion with this index, to those of row i.
  void put(std::size_t i, CurvedQuery& query, std::size_t corner, int motion) const {
    const double* x = tables_[0].row(i);
    for (std::size_t c = corner; c < corner + corners_; ++c) {
      if (points_ == 0) {
        query.corners[c] = CurvedCorner::on_body(motion, vector_at(x));
        x += 3;
        continue;
      }
      query.corners[c].control_points = static_cast<int>(points_);
      for (std::size_t k = 0; k < static_cast<std::size_t>(points_); ++k, x += 3) {
        query.corners[c].points[k] = vector_at(x);
      }
    }
    if (points_ > 0) return;
    RigidMotion& to = query.motions[static_cast<std::size_t>(motion)];
    std::copy_n(tables_[1].row(i), 4, to.q0.begin());
    std::copy_n(tables_[2].row(i), 4, to.q1.begin());
    to.p0 = vector_at(tables_[3].row(i));
    to.p1 = vector_at(tables_[4].row(i));
  }

 private:
  std::size_t corners_;
  py::ssize_t points_ = 0;  ///< of each curve; 0 on a body
  std::vector<NumberTable> tables_;
  std::vector<std::string> names_;
};

/// Gives the bodies of a query the shorter turns. @returns whether one had the longer
bool shorten_turns(CurvedQuery& query) {
  bool longer = false;
  for (RigidMotion& motion : query.motions) {
    if (!takes_longer_turn(motion)) continue;
    motion = with_shorter_turn(motion);
    longer = true;
  }
  return longer;
}

CurvedQueries curved_queries(py::handle kind_name, const py::tuple& first, const py::tuple& second, bool shorter) {
  CurvedQueries queries;
  queries.kind = kind_of(kind_name);
  const std::size_t corners = geometry::corners_of_first(queries.kind);
  const Element a(first, "first", corners), b(second, "second", corner_count(queries.kind) - corners);
  std::optional<std::size_t> rows;
  std::string name;
  a.count_rows(rows, name);
  b.count_rows(rows, name);
  queries.single = !rows;
  queries.all.resize(rows.value_or(1));
  for (std::size_t i = 0; i < queries.all.size(); ++i) {
    queries.all[i].kind = queries.kind;
    a.put(i, queries.all[i], 0, 0);
    b.put(i, queries.all[i], corners, 1);
    CurvedQuery shortened = queries.all[i];
    if (!shorten_turns(shortened)) continue;
    if (queries.longer_turns++ == 0) queries.first_longer_turn = i;
    if (shorter) queries.all[i] = shortened;
  }
  return queries;
}

py::object solve_curved(const CurvedQueries& queries, py::handle t_max_number, py::handle distance, py::handle metric,
                        py::handle threads, py::handle method_name, py::handle wanted_name) {
  const SeparationArgument separation = separation_of(distance, metric, queries.all.size(), queries.single);
  const double t_max = number_of(t_max_number, "t_max");
  const int thread_count = threads_of(threads);
  const Method method = method_of(method_name);
  const Wanted wanted = wanted_of(wanted_name);
  std::vector<Answer> answers(queries.all.size());
  const auto ask = [&](std::size_t q) {
    answers[q] =
        solve(queries.all[q], {.t_max = t_max, .separation = separation.of(q), .method = method, .wanted = wanted});
  };
  if (queries.single) {
    unlocked([&] { ask(0); });
    return py::cast(answers[0]);
  }
  check_options(separation.separation, t_max);
  for_each_row(answers.size(), thread_count, ask);
  return py::cast(Answers(std::move(answers)));
}

}  // namespace

void define_curved(py::module_& module) {
  define_class<CurvedQueries>(module, "CurvedArrays", "The queries of a CurvedQueries.")
      .def("__len__", [](const CurvedQueries& queries) { return queries.all.size(); })
      .def_property_readonly("kind", [](const CurvedQueries& queries) { return std::string(name_of(queries.kind)); })
      .def_readonly("single", &CurvedQueries::single)
      .def_readonly("longer_turns", &CurvedQueries::longer_turns)
      .def_readonly("first_longer_turn", &CurvedQueries::first_longer_turn)
      .def("solve", &solve_curved)
      .def("contact_times", &contact_times_of<CurvedQueries>)
      .def("distance", &distances_of<CurvedQueries>)
      .def("contact_normal", &contact_normals_of<CurvedQueries>);
  module.def("curved_queries", &curved_queries);
}

}  // namespace touchstone::python
