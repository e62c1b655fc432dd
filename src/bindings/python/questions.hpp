// The questions about queries of any sort: straight ones in arrays, and curved ones.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include <touchstone/contact_normal.hpp>
#include <touchstone/contact_times.hpp>
#include <touchstone/curved.hpp>
#include <touchstone/distance.hpp>

#include "python/arguments.hpp"
#include "python/background.hpp"
#include "python/rows.hpp"

namespace touchstone::python {

/// Whether the options have a meaning, before the first row is looked at. The one query is at rest and valid.
inline void check_options(const Separation& separation, double t_max) {
  solve(Query(), {.t_max = t_max, .separation = separation});
}

/// Intervals of contact as a list of pairs of ExactTime.
inline py::list list_of(const std::vector<ContactInterval>& intervals) {
  py::list list;
  for (const ContactInterval& interval : intervals) list.append(py::make_tuple(interval.first, interval.last));
  return list;
}

/// The distances of many queries.
struct Distances {
  using BoundToPython = void;

  std::vector<Distance> all;
};

// Queries has count(), is_single() and at(q).

template <class Queries>
py::list contact_times_of(const Queries& queries, py::handle t_max_number, py::handle separation, py::handle metric,
                          py::handle threads) {
  const SeparationArgument kept = separation_of(separation, metric, queries.count(), queries.is_single());
  const double t_max = number_of(t_max_number, "t_max");
  const int thread_count = threads_of(threads);
  check_options(kept.separation, t_max);
  if (queries.is_single()) {
    return list_of(unlocked([&] { return contact_times(queries.at(0), kept.separation, t_max); }));
  }
  std::vector<std::vector<ContactInterval>> times(queries.count());
  for_each_row(queries.count(), thread_count,
               [&](std::size_t q) { times[q] = contact_times(queries.at(q), kept.of(q), t_max); });
  py::list all;
  for (const auto& intervals : times) all.append(list_of(intervals));
  return all;
}

template <class Queries>
py::object distances_of(const Queries& queries, py::handle t_number, py::handle metric_text, py::handle threads) {
  const double t = number_of(t_number, "t");
  const Metric metric = metric_of(metric_text);
  const int thread_count = threads_of(threads);
  if (queries.is_single()) return py::cast(unlocked([&] { return distance(queries.at(0), t, metric); }));
  distance(Query(), t, metric);  // whether they have a meaning
  Distances distances{std::vector<Distance>(queries.count())};
  for_each_row(queries.count(), thread_count,
               [&](std::size_t q) { distances.all[q] = distance(queries.at(q), t, metric); });
  return py::cast(std::move(distances));
}

/// An array of numbers for each query, or for a single one. write(query, separation, t_max, numbers) writes them.
/// @param shape  of the numbers of a query
template <class Queries, class Write>
py::object numbers_of(const Queries& queries, py::handle t_max_number, py::handle separation, py::handle threads,
                      std::vector<py::ssize_t> shape, const Write& write) {
  const SeparationArgument kept = separation_of(separation, py::str("euclidean"), queries.count(), queries.is_single());
  const double t_max = number_of(t_max_number, "t_max");
  const int thread_count = threads_of(threads);
  check_options(kept.separation, t_max);
  std::size_t each = 1;
  for (const py::ssize_t extent : shape) each *= static_cast<std::size_t>(extent);
  if (!queries.is_single()) shape.insert(shape.begin(), static_cast<py::ssize_t>(queries.count()));
  py::array_t<double> numbers(shape);
  double* const to = numbers.mutable_data();
  const auto ask = [&](std::size_t q) { write(queries.at(q), kept.of(q), t_max, to + each * q); };
  if (queries.is_single()) {
    unlocked([&] { ask(0); });
  } else {
    for_each_row(queries.count(), thread_count, ask);
  }
  return py::object(numbers);
}

/// A normal that does not exist is NaN.
template <class Queries>
py::object contact_normals_of(const Queries& queries, py::handle t_max, py::handle separation, py::handle threads) {
  return numbers_of(queries, t_max, separation, threads, {3},
                    [](const auto& query, const Separation& kept, double until, double* to) {
                      constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
                      const auto normal = contact_normal(query, kept, until);
                      const std::array<double, 3> none = {kNone, kNone, kNone};
                      const std::array<double, 3> value = normal.value_or(none);
                      std::copy(value.begin(), value.end(), to);
                    });
}

}  // namespace touchstone::python
