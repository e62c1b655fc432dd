// Queries by the C interface: one at a time, in rows and in columns.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <vector>

#include <touchstone/c.h>
#include <touchstone/solve.hpp>

#include "c_api/answers.hpp"
#include "c_api/guard.hpp"

namespace touchstone::c_api {

namespace {

Query query_of(int kind, const double* start, const double* end) {
  Query query;
  query.kind = kind_of(kind);
  required(start, "start");
  required(end, "end");
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    query.start[i] = {start[3 * i], start[3 * i + 1], start[3 * i + 2]};
    query.end[i] = {end[3 * i], end[3 * i + 1], end[3 * i + 2]};
  }
  return query;
}

Separation separation_of(const touchstone_options& options) { return {options.separation, metric_of(options.metric)}; }

/// The options of one query, which takes no list of separations.
touchstone_options single_options(const touchstone_options* given) {
  const touchstone_options options = options_of(given);
  if (options.separations != nullptr || options.separation_count != 0) {
    throw InvalidArgument("separations are for a batch; one query takes separation");
  }
  return options;
}

BatchOptions batch_options(const touchstone_options* given) {
  const touchstone_options options = options_of(given);
  BatchOptions batch;
  batch.t_max = options.t_max;
  batch.threads = options.threads;
  batch.separation = separation_of(options);
  batch.distances = array(options.separations, options.separation_count, 1, "separations");
  batch.distance_count = options.separation_count;
  return batch;
}

/// Room for the answers, as C++ writes them. The layouts are the same.
Answer* room_for(touchstone_answer* answers, std::size_t count) {
  array(answers, count, 1, "answers");
  return reinterpret_cast<Answer*>(answers);
}

/// The rows of one end of the step as columns: coordinate by coordinate.
std::vector<double> columns_of(const double* rows, std::size_t count, std::size_t coordinates) {
  std::vector<double> columns(count * coordinates);
  for (std::size_t q = 0; q < count; ++q) {
    for (std::size_t k = 0; k < coordinates; ++k) columns[k * count + q] = rows[q * coordinates + k];
  }
  return columns;
}

}  // namespace

}  // namespace touchstone::c_api

using namespace touchstone;
using namespace touchstone::c_api;

extern "C" {

int touchstone_solve(int kind, const double* start, const double* end, const touchstone_options* given,
                     touchstone_answer* answer) {
  return guarded([&] {
    const Query query = query_of(kind, start, end);
    const touchstone_options options = single_options(given);
    required(answer, "answer") = c_answer(solve(query, separation_of(options), options.t_max));
  });
}

int touchstone_contact(int kind, const double* start, const double* end, const touchstone_options* given,
                       int* contact) {
  return guarded([&] {
    const Query query = query_of(kind, start, end);
    const touchstone_options options = single_options(given);
    required(contact, "contact") = solve_any(query, separation_of(options), options.t_max) ? 1 : 0;
  });
}

int touchstone_solve_columns(int kind, std::size_t count, const double* const* start, const double* const* end,
                             const touchstone_options* options, touchstone_answer* answers) {
  return guarded([&] {
    QueryColumns columns;
    columns.kind = kind_of(kind);
    columns.count = count;
    required(start, "start");
    required(end, "end");
    for (std::size_t i = 0; i < 3 * corner_count(columns.kind); ++i) {
      columns.start[i / 3][i % 3] = array(start[i], count, 1, "a column of start");
      columns.end[i / 3][i % 3] = array(end[i], count, 1, "a column of end");
    }
    Answer* room = room_for(answers, count);
    solve_batch(columns, room, batch_options(options));
  });
}

int touchstone_solve_rows(int kind, std::size_t count, const double* start, const double* end,
                          const touchstone_options* options, touchstone_answer* answers) {
  return guarded([&] {
    QueryColumns columns;
    columns.kind = kind_of(kind);
    columns.count = count;
    const std::size_t coordinates = 3 * corner_count(columns.kind);
    array(start, count, coordinates, "start");
    array(end, count, coordinates, "end");
    Answer* room = room_for(answers, count);
    const BatchOptions batch = batch_options(options);
    const std::vector<double> starts = columns_of(start, count, coordinates);
    const std::vector<double> ends = columns_of(end, count, coordinates);
    for (std::size_t i = 0; i < coordinates; ++i) {
      columns.start[i / 3][i % 3] = starts.data() + i * count;
      columns.end[i / 3][i % 3] = ends.data() + i * count;
    }
    solve_batch(columns, room, batch);
  });
}

}  // extern "C"
