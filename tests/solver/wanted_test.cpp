// Answers without what is not wanted: the same fields as in the whole answer, and nothing in the others.
// SPDX-License-Identifier: MIT
#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

constexpr std::array<Wanted, 4> kEveryWanted = {Wanted::contact, Wanted::time, Wanted::features, Wanted::all};

/// What is wrong with `some`, of which `whole` is the whole answer; empty when nothing is.
std::string wrong_in(const Answer& some, const Answer& whole, Wanted wanted) {
  if (some.contact != whole.contact) return "contact";
  if (!some.contact) {
    const bool none = std::isinf(some.toi) && std::isinf(some.toi_upper) && some.nature == Nature::none;
    return none ? "" : "fields without contact";
  }
  if (wanted == Wanted::contact) {
    if (!std::isnan(some.toi) || !std::isnan(some.toi_upper) || some.starts_within) return "unwanted times";
  } else if (some.toi != whole.toi || some.toi_upper != whole.toi_upper || some.starts_within != whole.starts_within) {
    return "times";
  }
  const bool features = wanted == Wanted::features || wanted == Wanted::all;
  if (some.nature != (features ? whole.nature : Nature::none)) return "nature";
  if (some.trend != (features ? whole.trend : Trend::none)) return "trend";
  if (some.feature_a != (features ? whole.feature_a : Feature::none)) return "feature_a";
  if (some.feature_b != (features ? whole.feature_b : Feature::none)) return "feature_b";
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = wanted == Wanted::all ? whole.weights_a[i] : 0, b = wanted == Wanted::all ? whole.weights_b[i] : 0;
    // Each is within 2^-50 of the true weight.
    if (std::fabs(some.weights_a[i] - a) > 0x1p-49 || std::fabs(some.weights_b[i] - b) > 0x1p-49) return "weights";
  }
  return "";
}

}  // namespace

TEST_CASE("what is wanted is as in the exact answer, and nothing else is there, for every family and time range") {
  long contacts = 0;
  for (const FamilyInfo& family : all_families()) {
    for (const Kind kind : kKinds) {
      for (std::uint64_t index = 0; index < 60; ++index) {
        const CaseId id{family.family, kind, 83, index};
        const Query query = make(id);
        const Answer first = solve(query, {.method = Method::exact});
        contacts += first.contact;
        const double t_max = first.contact && index % 3 == 1   ? first.toi_upper
                             : first.contact && index % 3 == 2 ? first.toi
                                                               : 1;
        const Answer whole = solve(query, {.t_max = t_max, .method = Method::exact});
        INFO(case_name(id) << " until " << t_max << "  " << cpp_initializer(query));
        for (const Wanted wanted : kEveryWanted) {
          INFO("wanted " << static_cast<int>(wanted));
          REQUIRE(wrong_in(solve(query, {.t_max = t_max, .wanted = wanted}), whole, wanted).empty());
        }
      }
    }
  }
  CHECK(contacts > 500);
}

TEST_CASE("separations, batches and columns leave out what is not wanted", "[slow]") {
  long contacts = 0;
  for (const Kind kind : kKinds) {
    std::vector<Query> queries;
    for (const FamilyInfo& family : all_families()) {
      for (std::uint64_t index = 0; index < 6; ++index) queries.push_back(make(CaseId{family.family, kind, 84, index}));
    }
    std::vector<double> numbers(queries.size() * 24);
    QueryColumns columns;
    columns.kind = kind;
    columns.count = queries.size();
    for (std::size_t c = 0; c < corner_count(kind); ++c) {
      for (std::size_t k = 0; k < 3; ++k) {
        double* const start = numbers.data() + (6 * c + k) * queries.size();
        double* const end = numbers.data() + (6 * c + 3 + k) * queries.size();
        columns.start[c][k] = start;
        columns.end[c][k] = end;
        for (std::size_t q = 0; q < queries.size(); ++q) {
          const Vec3 &from = queries[q].start[c], &to = queries[q].end[c];
          start[q] = k == 0 ? from.x : k == 1 ? from.y : from.z;
          end[q] = k == 0 ? to.x : k == 1 ? to.y : to.z;
        }
      }
    }
    for (const double distance : {0.0, 0x1p-6}) {
      BatchOptions options;
      options.separation.distance = distance;
      const std::vector<Answer> whole = solve_batch(queries, options);
      for (const Wanted wanted : kEveryWanted) {
        options.wanted = wanted;
        options.threads = wanted == Wanted::time ? 2 : 1;
        const std::vector<Answer> listed = solve_batch(queries, options);
        const std::vector<Answer> in_columns = solve_batch(columns, options);
        for (std::size_t q = 0; q < queries.size(); ++q) {
          INFO("wanted " << static_cast<int>(wanted) << ", distance " << distance << "  "
                         << cpp_initializer(queries[q]));
          contacts += whole[q].contact;
          REQUIRE(wrong_in(listed[q], whole[q], wanted).empty());
          REQUIRE(wrong_in(in_columns[q], whole[q], wanted).empty());
          REQUIRE(wrong_in(solve(queries[q], {.separation = {distance, Metric::euclidean}, .wanted = wanted}), whole[q],
                           wanted)
                      .empty());
        }
      }
    }
  }
  CHECK(contacts > 500);
}

TEST_CASE("curved queries leave out what is not wanted") {
  // A point turns a quarter about the origin, through an edge that stands on the diagonal.
  CurvedQuery query;
  query.kind = Kind::point_edge;
  query.motions[0].q1 = {1, 0, 0, 1};
  query.corners[0] = CurvedCorner::on_body(0, {1, 0, 0});
  query.corners[1] = CurvedCorner::on_curve({Vec3{0.5, 0.5, 0}});
  query.corners[2] = CurvedCorner::on_curve({Vec3{1, 1, 0}});
  for (const double distance : {0.0, 0.125}) {
    const Separation separation{distance};
    const Answer whole = solve(query, {.separation = separation});
    REQUIRE(whole.contact);
    for (const Wanted wanted : kEveryWanted) {
      INFO("wanted " << static_cast<int>(wanted) << ", distance " << distance);
      CHECK(wrong_in(solve(query, {.separation = separation, .wanted = wanted}), whole, wanted) == "");
      if (distance == 0) CHECK(wrong_in(solve(query, {.wanted = wanted}), whole, wanted) == "");
    }
  }
}

TEST_CASE("options in braces are the defaults, and a number in them is t_max") {
  const Query falling = VertexFace{{{{0.25, 0.25, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                                   {{{0.25, 0.25, -1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
  CHECK(solve(falling).toi == 0.5);
  CHECK(solve(falling, {}).toi == 0.5);
  CHECK(solve(falling, 1).toi == 0.5);
  CHECK(solve(falling, {0.5}).toi == 0.5);
  CHECK_FALSE(solve(falling, {0.25}).contact);
  CHECK_FALSE(solve(falling, 0.25f).contact);
  CHECK(solve(CurvedQuery(falling), {}).toi == 0.5);
}

TEST_CASE("what is not wanted of a rational contact is left out, too") {
  RationalQuery thirds;
  thirds.kind = Kind::vertex_face;
  thirds.start[0] = {Fraction{"1", "3"}, Fraction{"1", "3"}, Fraction{"1", "3"}};
  thirds.end[0] = {Fraction{"1", "3"}, Fraction{"1", "3"}, Fraction{"-1", "3"}};
  for (auto* corners : {&thirds.start, &thirds.end}) {
    (*corners)[2][0] = {"1", "1"};
    (*corners)[3][1] = {"1", "1"};
  }
  RationalQuery halves = thirds;  // of doubles
  for (auto* corners : {&halves.start, &halves.end}) {
    for (Fraction& coordinate : (*corners)[0]) coordinate.denominator = "4";
  }
  for (const RationalQuery& query : {thirds, halves}) {
    for (const Method method : {Method::fast, Method::exact, Method::oracle}) {
      const Answer whole = solve(query, {.method = method});
      REQUIRE(whole.toi == 0.5);
      for (const Wanted wanted : {Wanted::features, Wanted::time, Wanted::contact}) {
        CHECK(wrong_in(solve(query, {.method = method, .wanted = wanted}), whole, wanted) == "");
      }
    }
  }
}

TEST_CASE("a value that is none of Wanted's is refused") {
  const auto wrong = static_cast<Wanted>(4);
  CHECK_THROWS_AS(solve(Query(), {.wanted = wrong}), InvalidQuery);
  CHECK_THROWS_AS(solve(Query(), {.separation = Separation{1}, .wanted = wrong}), InvalidQuery);
  CHECK_THROWS_AS(solve(CurvedQuery(), {.wanted = wrong}), InvalidQuery);
  CHECK_THROWS_AS(solve(RationalQuery(), {.wanted = wrong}), InvalidQuery);
  BatchOptions options;
  options.wanted = wrong;
  CHECK_THROWS_AS(solve_batch(std::vector<Query>(), options), InvalidQuery);
}
