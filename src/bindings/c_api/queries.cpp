// Queries by the C interface: one at a time, in rows and in columns.
// SPDX-License-Identifier: MIT
#include <algorithm>
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

constexpr unsigned kOfQueries = kHasTMax | kHasSeparation | kHasWanted | kHasMethod;

Separation separation_of(const touchstone_options& options) { return {options.separation, metric_of(options.metric)}; }

BatchOptions batch_options(const touchstone_options* given) {
  const touchstone_options options = options_of(given, kOfQueries | kHasSeparations);
  BatchOptions batch;
  batch.t_max = options.t_max;
  batch.threads = options.threads;
  batch.separation = separation_of(options);
  batch.separations = array(options.separations, options.separation_count, 1, "separations");
  batch.separation_count = options.separation_count;
  batch.wanted = wanted_of(options.wanted);
  batch.method = method_of(options.method);
  return batch;
}

/// Room for the answers, as C++ writes them. The layouts are the same.
Answer* room_for(touchstone_answer* answers, std::size_t count) {
  array(answers, count, 1, "answers");
  return reinterpret_cast<Answer*>(answers);
}

/// Writes the rows of one end of the step into columns: coordinate by coordinate.
void transpose(const double* rows, std::size_t count, std::size_t coordinates, double* columns) {
  for (std::size_t q = 0; q < count; ++q) {
    for (std::size_t k = 0; k < coordinates; ++k) columns[k * count + q] = rows[q * coordinates + k];
  }
}

/// Queries in rows, answered by way of columns, a block of queries after another.
struct Rows {
  Kind kind;
  std::size_t count;
  const double* start;
  const double* end;

  void solve(Answer* answers, const BatchOptions& options, std::size_t block) const {
    const std::size_t coordinates = 3 * corner_count(kind);
    std::vector<double> values(2 * std::min(block, count) * coordinates);
    for (std::size_t first = 0; first < count; first += block) {
      QueryColumns columns;
      columns.kind = kind;
      columns.count = std::min(block, count - first);
      double* const starts = values.data();
      double* const ends = starts + columns.count * coordinates;
      transpose(start + first * coordinates, columns.count, coordinates, starts);
      transpose(end + first * coordinates, columns.count, coordinates, ends);
      for (std::size_t i = 0; i < coordinates; ++i) {
        columns.start[i / 3][i % 3] = starts + i * columns.count;
        columns.end[i / 3][i % 3] = ends + i * columns.count;
      }
      BatchOptions of_block = options;
      if (options.separations != nullptr) {
        of_block.separations = options.separations + first;
        of_block.separation_count = columns.count;
      }
      solve_batch(columns, answers + first, of_block);
    }
  }
};

/// The queries of a block of each thread: their columns stay in a core's cache.
constexpr std::size_t kBlock = 1024;

}  // namespace

}  // namespace touchstone::c_api

using namespace touchstone;
using namespace touchstone::c_api;

extern "C" {

int touchstone_solve(int kind, const double* start, const double* end, const touchstone_options* given,
                     touchstone_answer* answer) {
  return guarded([&] {
    const Query query = query_of(kind, start, end);
    const touchstone_options options = options_of(given, kOfQueries);
    required(answer, "answer") = c_answer(solve(query, {.t_max = options.t_max,
                                                        .separation = separation_of(options),
                                                        .method = method_of(options.method),
                                                        .wanted = wanted_of(options.wanted)}));
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
    const Rows rows{kind_of(kind), count, start, end};
    const std::size_t coordinates = 3 * corner_count(rows.kind);
    array(start, count, coordinates, "start");
    array(end, count, coordinates, "end");
    Answer* room = room_for(answers, count);
    const BatchOptions batch = batch_options(options);
    const bool separations_fit = batch.separations == nullptr || batch.separation_count == count;
    try {
      if (count > 0 && separations_fit) return rows.solve(room, batch, batch.threads == 1 ? kBlock : 64 * kBlock);
    } catch (const InvalidQuery&) {
      // The message would count from the first query of the block: ask again in one block, for its message.
    }
    if (count > 0 && separations_fit) return rows.solve(room, batch, count);
    solve_batch(static_cast<const Query*>(nullptr), count, room, batch);  // options without meaning
  });
}

}  // extern "C"
