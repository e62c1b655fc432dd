// Rational coordinates: the overloads agree, and the level names the arithmetic that decided.
// SPDX-License-Identifier: MIT
#include <touchstone/solve.hpp>

#include <string>
#include <vector>

#include <touchstone/error.hpp>

#include "support/catch.hpp"

using namespace touchstone;

namespace {

/// p moves from 0 to 1 along x and q rests at x: they meet at t = x.
RationalQuery meeting_at(const std::string& numerator, const std::string& denominator) {
  RationalQuery query;
  query.kind = Kind::point_point;
  query.end[0][0] = Fraction{"1", "1"};
  query.start[1][0] = query.end[1][0] = Fraction{numerator, denominator};
  return query;
}

}  // namespace

TEST_CASE("a rational query takes t_max in second place, as a query in doubles does") {
  const RationalQuery query = meeting_at("1", "3");
  CHECK(solve(query).contact);
  CHECK(solve(query, 0.5).contact);
  CHECK_FALSE(solve(query, 0.25).contact);
  CHECK(solve(query, 0.5).toi == solve(query, {.t_max = 0.5, .method = Method::fast}).toi);
}

TEST_CASE("coordinates that are no doubles go to the exact level, or to CGAL where the method says so") {
  for (const auto& [method, level] :
       {std::pair(Method::fast, Level::exact), std::pair(Method::exact, Level::exact),
        std::pair(Method::oracle, Level::oracle), std::pair(Method::fast_cgal, Level::oracle)}) {
    const Answer answer = solve(meeting_at("1", "3"), {.method = method});
    CHECK(answer.contact);
    CHECK(answer.level == level);
    CHECK(answer.toi == 0x1.5555555555555p-2);
    CHECK(answer.toi_upper == 0x1.5555555555556p-2);
    CHECK_FALSE(solve(meeting_at("-1", "3"), {.method = method}).contact);
  }
}

TEST_CASE("a batch of rational queries has the answers of each, and names the one without meaning") {
  std::vector<RationalQuery> queries = {meeting_at("1", "3"), meeting_at("-1", "3"), meeting_at("2", "7")};
  BatchOptions options;
  for (const double distance : {0.0, 0.25}) {
    options.separation.distance = distance;
    const std::vector<Answer> answers = solve_batch(queries, options);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const Answer one = solve(queries[i], {.separation = {distance}});
      CHECK(answers[i].contact == one.contact);
      CHECK(answers[i].toi == one.toi);
      CHECK(answers[i].toi_upper == one.toi_upper);
    }
  }
  const std::vector<double> separations = {0, 0.5, 0};
  options.separation = {};
  options.separations = separations.data();
  options.separation_count = separations.size();
  options.threads = 2;
  CHECK(solve_batch(queries, options)[1].contact);  // -1/3 is within 1/2 of 0
  queries[2].end[1][0].denominator = "0";
  try {
    solve_batch(queries, options);
    FAIL("a zero denominator was taken");
  } catch (const InvalidQuery& error) {
    CHECK(std::string(error.what()).rfind("query 2: ", 0) == 0);
  }
}
