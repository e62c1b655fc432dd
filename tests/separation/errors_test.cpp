// Separations without meaning.
// SPDX-License-Identifier: MIT
#include <limits>
#include <string>
#include <vector>

#include <touchstone/contact_times.hpp>
#include <touchstone/distance.hpp>
#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "support/catch.hpp"

using namespace touchstone;

namespace {

template <class F>
std::string message_of(const F& f) {
  try {
    f();
  } catch (const InvalidQuery& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a distance that is negative or not finite, and an unknown metric, are refused everywhere") {
  const Query query;
  const double inf = std::numeric_limits<double>::infinity();
  for (const double d : {-1.0, -0x1p-1074, inf, -inf, std::numeric_limits<double>::quiet_NaN()}) {
    const Separation separation = {d, Metric::euclidean};
    for (const std::string& message :
         {message_of([&] { solve(query, {.separation = separation}); }),
          message_of([&] { solve(RationalQuery(), {.separation = separation}); }),
          message_of([&] { solve(query, {.separation = separation, .wanted = Wanted::contact}); }),
          message_of([&] { contact_times(query, separation); }),
          message_of([&] { compare_distance(query, 0, separation); }), message_of([&] {
            BatchOptions options;
            options.separation = separation;
            solve_batch(std::vector<Query>{query}, options);
          })}) {
      INFO(d << ": " << message);
      CHECK(contains(message, "it must be finite and not negative"));
    }
  }
  const Separation odd = {1, static_cast<Metric>(7)};
  CHECK(contains(message_of([&] { solve(query, {.separation = odd}); }),
                 "the metric is 7; it must be 0 or 1: euclidean or max"));
  CHECK(contains(message_of([&] { distance(query, 0, static_cast<Metric>(7)); }), "the metric is 7"));
  CHECK(contains(message_of([&] { distance(query, 1.5); }), "the time is 1.5; it must be in [0, 1]"));
  CHECK(contains(message_of([&] { compare_distance(query, -1, {}); }), "the time is -1; it must be in [0, 1]"));
}

TEST_CASE("a column of separations has one for each query, each with a meaning") {
  const std::vector<Query> queries(3);
  std::vector<double> distances = {1, 2, 3};
  BatchOptions options;
  options.separations = distances.data();
  options.separation_count = 2;
  CHECK(contains(message_of([&] { solve_batch(queries, options); }), "there are 2 separations for 3 queries"));
  options.separation_count = 3;
  CHECK(message_of([&] { solve_batch(queries, options); }).empty());
  distances[1] = -1;
  CHECK(contains(message_of([&] { solve_batch(queries, options); }), "query 1: the separation is -1"));
  distances[1] = 0;
  options.separation.distance = 1;
  CHECK(contains(message_of([&] { solve_batch(queries, options); }), "give one of them"));
  options.separations = nullptr;
  CHECK(contains(message_of([&] { solve_batch(queries, options); }), "separation_count is 3, but separations is null"));
}
