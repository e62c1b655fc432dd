// The C interface gives the answers of the C++ one, and an error is a status with a message.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include <touchstone/c.h>
#include <touchstone/touchstone.hpp>

#include "c_api/c_api_support.hpp"
#include "seeded/rng.hpp"
#include "support/catch.hpp"

using touchstone::Answer;
using touchstone::Kind;
using touchstone::Method;
using touchstone::Query;
using touchstone::Vec3;
using touchstone::seeded::Rng;
using namespace touchstone::tests;

namespace {

/// Queries of one kind on a lattice of small integers, as rows of doubles.
struct Rows {
  Kind kind = Kind::edge_edge;
  std::size_t width = 0;
  std::vector<double> start, end;

  Rows(Kind of, std::size_t count, std::uint64_t seed) : kind(of), width(3 * touchstone::corner_count(of)) {
    Rng rng(seed);
    for (std::size_t i = 0; i < count * width; ++i) {
      start.push_back(rng.between(-3, 3));
      end.push_back(rng.between(-3, 3));
    }
  }

  std::size_t count() const { return start.size() / width; }

  Query operator[](std::size_t q) const {
    Query query;
    query.kind = kind;
    for (std::size_t i = 0; i < width / 3; ++i) {
      const double* s = &start[q * width + 3 * i];
      const double* e = &end[q * width + 3 * i];
      query.start[i] = {s[0], s[1], s[2]};
      query.end[i] = {e[0], e[1], e[2]};
    }
    return query;
  }
};

}  // namespace

TEST_CASE("one query, rows and columns give the answers of C++") {
  for (const Kind kind : touchstone::kKinds) {
    const Rows rows(kind, 300, 7);
    const int c_kind = static_cast<int>(kind);
    std::vector<double> distances;
    for (std::size_t q = 0; q < rows.count(); ++q) distances.push_back(0.125 * static_cast<double>(q % 5));
    std::vector<std::vector<double>> columns;
    std::vector<const double*> start, end;
    for (const auto* side : {&rows.start, &rows.end}) {
      for (std::size_t k = 0; k < rows.width; ++k) {
        columns.emplace_back();
        for (std::size_t q = 0; q < rows.count(); ++q) columns.back().push_back((*side)[q * rows.width + k]);
      }
    }
    for (std::size_t k = 0; k < rows.width; ++k) {
      start.push_back(columns[k].data());
      end.push_back(columns[rows.width + k].data());
    }

    for (const int metric : {TOUCHSTONE_METRIC_EUCLIDEAN, TOUCHSTONE_METRIC_MAX}) {
      touchstone_options options = default_options();
      options.t_max = 0.75;
      options.threads = 2;
      options.metric = metric;
      options.separations = distances.data();
      options.separation_count = distances.size();
      std::vector<touchstone_answer> by_rows(rows.count()), by_columns(rows.count());
      REQUIRE(touchstone_solve_rows(c_kind, rows.count(), rows.start.data(), rows.end.data(), &options,
                                    by_rows.data()) == TOUCHSTONE_OK);
      REQUIRE(touchstone_solve_columns(c_kind, rows.count(), start.data(), end.data(), &options, by_columns.data()) ==
              TOUCHSTONE_OK);
      int contacts = 0;
      for (std::size_t q = 0; q < rows.count(); ++q) {
        CAPTURE(c_kind, metric, q);
        const touchstone::Separation separation{distances[q], static_cast<touchstone::Metric>(metric)};
        const Answer expected = touchstone::solve(rows[q], {.t_max = 0.75, .separation = separation});
        CHECK(same(expected, by_rows[q]));
        CHECK(same(expected, by_columns[q]));

        touchstone_options single = default_options();
        single.t_max = 0.75;
        single.metric = metric;
        single.separation = distances[q];
        touchstone_answer answer;
        const double* row_start = &rows.start[q * rows.width];
        const double* row_end = &rows.end[q * rows.width];
        REQUIRE(touchstone_solve(c_kind, row_start, row_end, &single, &answer) == TOUCHSTONE_OK);
        CHECK(same(expected, answer));
        single.wanted = TOUCHSTONE_WANTED_CONTACT;
        REQUIRE(touchstone_solve(c_kind, row_start, row_end, &single, &answer) == TOUCHSTONE_OK);
        CHECK(answer.contact == (expected.contact ? 1 : 0));
        contacts += expected.contact;
      }
      CHECK(contacts > 0);
      CHECK(contacts < 300);
    }
  }
}

TEST_CASE("each method gives the answers of C++, and one that the library has not is refused") {
  const Rows rows(Kind::vertex_face, 40, 10);
  touchstone_options options = default_options();
  for (const Method method : {Method::fast, Method::exact, Method::oracle, Method::fast_cgal}) {
    options.method = static_cast<int>(method);
    for (std::size_t q = 0; q < rows.count(); ++q) {
      touchstone_answer answer;
      const int status = touchstone_solve(1, &rows.start[q * rows.width], &rows.end[q * rows.width], &options, &answer);
      CAPTURE(options.method, q);
      REQUIRE(status == (touchstone::has_method(method) ? TOUCHSTONE_OK : TOUCHSTONE_INVALID_QUERY));
      if (status == TOUCHSTONE_OK) CHECK(same(touchstone::solve(rows[q], {.method = method}), answer));
    }
  }
  // The structure of version 5, which ended with bytes of no meaning where the next member is now.
  options.method = 4;
  options.reserved = 0x7fff;
  options.size = offsetof(touchstone_options, method);
  touchstone_answer answer;
  CHECK(options.size == 72);
  CHECK(touchstone_solve(1, rows.start.data(), rows.end.data(), &options, &answer) == TOUCHSTONE_OK);
  options.size = sizeof options;
  CHECK(touchstone_solve(1, rows.start.data(), rows.end.data(), &options, &answer) == TOUCHSTONE_INVALID_ARGUMENT);
}

TEST_CASE("what is not wanted is left out, and a program that knew no such option gets everything") {
  const Rows rows(Kind::edge_edge, 200, 9);
  std::vector<touchstone_answer> answers(rows.count());
  touchstone_options options = default_options();
  int contacts = 0;
  for (const int wanted : {TOUCHSTONE_WANTED_ALL, TOUCHSTONE_WANTED_FEATURES, TOUCHSTONE_WANTED_TIME}) {
    options.wanted = wanted;
    REQUIRE(touchstone_solve_rows(0, rows.count(), rows.start.data(), rows.end.data(), &options, answers.data()) ==
            TOUCHSTONE_OK);
    for (std::size_t q = 0; q < rows.count(); ++q) {
      CAPTURE(wanted, q);
      const Answer expected = touchstone::solve(rows[q], {.wanted = static_cast<touchstone::Wanted>(wanted)});
      contacts += expected.contact;
      CHECK(same(expected, answers[q]));
      touchstone_answer one;
      const double *start = &rows.start[q * rows.width], *end = &rows.end[q * rows.width];
      REQUIRE(touchstone_solve(0, start, end, &options, &one) == TOUCHSTONE_OK);
      CHECK(same(expected, one));
      options.wanted = TOUCHSTONE_WANTED_CONTACT;
      REQUIRE(touchstone_solve(0, start, end, &options, &one) == TOUCHSTONE_OK);
      CHECK((one.contact != 0) == expected.contact);
      CHECK(std::isnan(one.toi) == expected.contact);
      options.size = offsetof(touchstone_options, wanted);  // the structure of an older program
      REQUIRE(touchstone_solve(0, start, end, &options, &one) == TOUCHSTONE_OK);
      CHECK(same(touchstone::solve(rows[q]), one));
      options.size = sizeof options;
      options.wanted = wanted;
    }
  }
  CHECK(contacts > 0);
  options.wanted = 4;
  CHECK(touchstone_solve_rows(0, 1, rows.start.data(), rows.end.data(), &options, answers.data()) ==
        TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(message_has("what is wanted is 4"));
}

TEST_CASE("many rows, on any number of threads, are the columns' answers, and an error counts from the first row") {
  const Rows rows(Kind::point_point, 5000, 8);
  std::vector<Query> queries;
  for (std::size_t q = 0; q < rows.count(); ++q) queries.push_back(rows[q]);
  const std::vector<Answer> expected = touchstone::solve_batch(queries);
  for (const int threads : {1, 2, 0}) {
    touchstone_options options = default_options();
    options.threads = threads;
    std::vector<touchstone_answer> answers(rows.count());
    REQUIRE(touchstone_solve_rows(TOUCHSTONE_KIND_POINT_POINT, rows.count(), rows.start.data(), rows.end.data(),
                                  &options, answers.data()) == TOUCHSTONE_OK);
    std::size_t differences = 0;
    for (std::size_t q = 0; q < rows.count(); ++q) differences += !same(expected[q], answers[q]);
    CHECK(differences == 0);

    std::vector<double> with_nan = rows.end;
    with_nan[rows.width * 4321 + 4] = std::nan("");
    CHECK(touchstone_solve_rows(TOUCHSTONE_KIND_POINT_POINT, rows.count(), rows.start.data(), with_nan.data(), &options,
                                answers.data()) == TOUCHSTONE_INVALID_QUERY);
    CHECK(message_has("query 4321"));
  }
}

TEST_CASE("numbers have the names of C++, and others have none") {
  CHECK(touchstone_version() == std::string(touchstone::version()));
  for (int i = 0; i < 30; ++i) {
    CHECK(touchstone_nature_name(i) == touchstone::name_of(static_cast<touchstone::Nature>(i)));
    CHECK(touchstone_feature_name(i) == touchstone::name_of(static_cast<touchstone::Feature>(i)));
    CHECK(touchstone_level_name(i) == touchstone::name_of(static_cast<touchstone::Level>(i)));
    CHECK(touchstone_trend_name(i) == touchstone::name_of(static_cast<touchstone::Trend>(i)));
  }
  for (const int none : {-1, 255, 256, 257, 1 << 20, std::numeric_limits<int>::min()}) {
    CHECK(touchstone_nature_name(none) == std::string());
    CHECK(touchstone_feature_name(none) == std::string());
    CHECK(touchstone_level_name(none) == std::string());
    CHECK(touchstone_trend_name(none) == std::string());
  }
}

TEST_CASE("what has no meaning is a status and a message") {
  const Rows rows(Kind::edge_edge, 2, 1);
  const double* start = rows.start.data();
  const double* end = rows.end.data();
  touchstone_answer answer;
  std::vector<touchstone_answer> answers(2);
  constexpr std::size_t kHuge = std::numeric_limits<std::size_t>::max();

  CHECK(touchstone_solve(0, nullptr, end, nullptr, &answer) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(message_has("start is a null pointer"));
  CHECK(touchstone_solve(0, start, nullptr, nullptr, &answer) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_solve(0, start, end, nullptr, nullptr) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(message_has("answer"));
  for (const int kind : {-1, 4, 1 << 20}) {
    CHECK(touchstone_solve(kind, start, end, nullptr, &answer) == TOUCHSTONE_INVALID_ARGUMENT);
    CHECK(message_has("the kind is " + std::to_string(kind)));
    CHECK(touchstone_solve_rows(kind, 2, start, end, nullptr, answers.data()) == TOUCHSTONE_INVALID_ARGUMENT);
    CHECK(touchstone_solve_columns(kind, 0, &start, &end, nullptr, answers.data()) == TOUCHSTONE_INVALID_ARGUMENT);
  }
  CHECK(touchstone_solve_rows(0, 2, nullptr, end, nullptr, answers.data()) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_solve_rows(0, 2, start, end, nullptr, nullptr) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_solve_rows(0, 0, nullptr, nullptr, nullptr, nullptr) == TOUCHSTONE_OK);
  for (const std::size_t count : {kHuge, kHuge / 8, kHuge / 96, kHuge / 192 + 1}) {
    CHECK(touchstone_solve_rows(0, count, start, end, nullptr, answers.data()) == TOUCHSTONE_INVALID_ARGUMENT);
    CHECK(message_has("more than memory"));
  }
  const std::vector<const double*> columns(12, start);
  CHECK(touchstone_solve_columns(0, kHuge, columns.data(), columns.data(), nullptr, answers.data()) ==
        TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_solve_columns(0, 2, nullptr, columns.data(), nullptr, answers.data()) ==
        TOUCHSTONE_INVALID_ARGUMENT);
  std::vector<const double*> one_missing = columns;
  one_missing[11] = nullptr;
  CHECK(touchstone_solve_columns(0, 2, columns.data(), one_missing.data(), nullptr, answers.data()) ==
        TOUCHSTONE_INVALID_ARGUMENT);

  std::vector<double> with_nan = rows.start;
  with_nan[12 + 3] = std::nan("");
  CHECK(touchstone_solve_rows(0, 2, with_nan.data(), end, nullptr, answers.data()) == TOUCHSTONE_INVALID_QUERY);
  CHECK(message_has("1"));
  CHECK(touchstone_solve(0, with_nan.data() + 12, end, nullptr, &answer) == TOUCHSTONE_INVALID_QUERY);
  CHECK(message_has("a1"));

  touchstone_options options = default_options();
  options.t_max = 2;
  CHECK(touchstone_solve(0, start, end, &options, &answer) == TOUCHSTONE_INVALID_QUERY);
  options = default_options();
  options.metric = 2;
  CHECK(touchstone_solve(0, start, end, &options, &answer) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(message_has("the metric is 2"));
  options = default_options();
  options.separation = -1;
  CHECK(touchstone_solve(0, start, end, &options, &answer) == TOUCHSTONE_INVALID_QUERY);
  options = default_options();
  options.separation_count = 2;
  CHECK(touchstone_solve(0, start, end, &options, &answer) == TOUCHSTONE_INVALID_ARGUMENT);
  CHECK(touchstone_solve_rows(0, 2, start, end, &options, answers.data()) == TOUCHSTONE_INVALID_ARGUMENT);
  options.separations = start;
  options.separation_count = 1;
  CHECK(touchstone_solve_rows(0, 2, start, end, &options, answers.data()) == TOUCHSTONE_INVALID_QUERY);
  options = default_options();
  options.threads = -1;
  CHECK(touchstone_solve_rows(0, 2, start, end, &options, answers.data()) == TOUCHSTONE_INVALID_QUERY);
  for (const std::size_t size : {std::size_t{0}, offsetof(touchstone_options, wanted) - 1, sizeof options + 1, kHuge}) {
    options = default_options();
    options.size = size;
    CHECK(touchstone_solve(0, start, end, &options, &answer) == TOUCHSTONE_INVALID_ARGUMENT);
    CHECK(message_has("size"));
  }

  const std::string before = touchstone_last_error();
  CHECK(touchstone_solve(0, start, end, nullptr, &answer) == TOUCHSTONE_OK);
  CHECK(touchstone_last_error() == before);
  std::string elsewhere = "not asked";
  std::thread([&] { elsewhere = touchstone_last_error(); }).join();
  CHECK(elsewhere.empty());
}
