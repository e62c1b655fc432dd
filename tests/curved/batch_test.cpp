// Curved queries in batches, as yes-or-no questions, with normals and stories: each says what `solve` says.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <touchstone/contact_normal.hpp>
#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include "curved/queries.hpp"
#include "exact/exact.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/report.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 47;

/// Queries of all kinds and families, touching and apart.
std::vector<CurvedQuery> mixed_queries(std::size_t count) {
  static constexpr std::array<Maker, 6> kMakers = {lattice_query, gear_query, screw_query,
                                                   meeting_query, coin_query, random_query};
  std::vector<CurvedQuery> queries;
  for (std::uint64_t index = 0; index < count; ++index) {
    Rng rng(seeded::seed_of_stream(kSeed, index));
    const Kind kind = rng.pick(kKinds);
    queries.push_back(rng.pick(kMakers)(kind, rng));
  }
  return queries;
}

std::string message_of(const std::vector<CurvedQuery>& queries, const BatchOptions& options) {
  try {
    (void)solve_batch(queries, options);
  } catch (const InvalidQuery& error) {
    return error.what();
  }
  return "";
}

TEST_CASE("a batch of curved queries: the same bits as one by one, for any number of threads") {
  const std::vector<CurvedQuery> queries = mixed_queries(effort(1500));
  for (const double t_max : {1.0, 0.4}) {
    for (const Method method : {Method::fast, Method::exact}) {
      std::vector<Answer> expected;
      std::size_t contacts = 0;
      for (const CurvedQuery& query : queries) {
        expected.push_back(solve(query, {.t_max = t_max, .method = method}));
        contacts += expected.back().contact;
      }
      std::printf("%zu curved queries, %zu with contact, t_max %g\n", queries.size(), contacts, t_max);
      if (whole_effort("that many curved queries touch, and many do not")) {
        CHECK(contacts > queries.size() / 30);
        CHECK(contacts < queries.size() * 9 / 10);
      }
      for (const int threads : {1, 2, 5}) {
        BatchOptions options;
        options.t_max = t_max;
        options.method = method;
        options.threads = threads;
        const std::vector<Answer> answers = solve_batch(queries, options);
        REQUIRE(answers.size() == queries.size());
        for (std::size_t i = 0; i < queries.size(); ++i) {
          INFO("seed " << kSeed << ", index " << i << "\n" << text_of(queries[i]));
          REQUIRE(bit_difference(expected[i], answers[i], true) == "");
        }
      }
    }
  }
  CHECK(solve_batch(std::vector<CurvedQuery>()).empty());
}

TEST_CASE("whether curved elements touch at all") {
  const std::vector<CurvedQuery> queries = mixed_queries(effort(1000));
  for (const CurvedQuery& query : queries) {
    INFO(text_of(query));
    REQUIRE(solve(query, {.wanted = Wanted::contact}).contact == solve(query, {.method = Method::exact}).contact);
    REQUIRE(solve(query, {.t_max = 0.25, .wanted = Wanted::contact}).contact ==
            solve(query, {.t_max = 0.25, .method = Method::exact}).contact);
  }
}

TEST_CASE("a batch of curved queries names what has no meaning") {
  std::vector<CurvedQuery> queries = mixed_queries(200);
  queries[170].corners[0] = CurvedCorner::on_curve({{0, std::numeric_limits<double>::quiet_NaN(), 0}});
  const std::string message = message_of(queries, {});
  CAPTURE(message);
  CHECK(message.rfind("query 170: ", 0) == 0);
  CHECK(message.find("control point 0 has y = nan") != std::string::npos);
  queries.resize(100);
  CHECK(message_of(queries, {}).empty());
  BatchOptions options;
  options.t_max = 2;
  CHECK(message_of(queries, options).find("t_max") != std::string::npos);
  options = {};
  options.threads = -1;
  CHECK(message_of(queries, options).find("threads") != std::string::npos);
  options = {};
  options.method = static_cast<Method>(9);
  CHECK(message_of(queries, options).find("method") != std::string::npos);
  options = {};
  options.separation.distance = -1;
  CHECK(message_of(queries, options).find("the separation is -1") != std::string::npos);
  CHECK_THROWS_AS(solve(queries[0], {.t_max = -1, .wanted = Wanted::contact}), InvalidQuery);
}

/// The position of a corner at t, in long doubles.
std::array<long double, 3> position(const CurvedQuery& query, const CurvedCorner& corner, long double t) {
  std::array<long double, 3> x{};
  if (corner.motion == CurvedCorner::kOnCurve) {
    const int n = corner.control_points - 1;
    long double binomial = 1;
    for (int i = 0; i <= n; ++i) {
      const long double factor = binomial * std::pow(1 - t, n - i) * std::pow(t, i);
      const Vec3& b = corner.points[static_cast<std::size_t>(i)];
      x[0] += factor * b.x, x[1] += factor * b.y, x[2] += factor * b.z;
      binomial = binomial * (n - i) / (i + 1);
    }
    return x;
  }
  const RigidMotion& motion = query.motions[static_cast<std::size_t>(corner.motion)];
  long double q[4], square = 0;
  for (std::size_t i = 0; i < 4; ++i) q[i] = (1 - t) * motion.q0[i] + t * motion.q1[i], square += q[i] * q[i];
  // x + 2 v x (v x x + w x) / |q|^2 + p, v the vector part.
  const Vec3& body = corner.points[0];
  const long double b[3] = {body.x, body.y, body.z};
  const long double p0[3] = {motion.p0.x, motion.p0.y, motion.p0.z}, p1[3] = {motion.p1.x, motion.p1.y, motion.p1.z};
  long double c[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    c[k] = q[1 + l] * b[m] - q[1 + m] * b[l] + q[0] * b[k];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    x[k] = b[k] + 2 * (q[1 + l] * c[m] - q[1 + m] * c[l]) / square + (1 - t) * p0[k] + t * p1[k];
  }
  return x;
}

TEST_CASE("the normal at the first contact of curved elements") {
  SECTION("straight motion as curves") {
    std::size_t compared = 0;
    const auto wanted = [](const FamilyInfo& family, Kind) { return family.group != Group::separation; };
    for_each_case(kSeed, 20, wanted, [&](const CaseId& id) {
      const Query query = make(id);
      const auto expected = contact_normal(query);
      const auto found = contact_normal(CurvedQuery(query));
      INFO(cpp_initializer(query));
      REQUIRE(found.has_value() == expected.has_value());
      if (!found) return;
      ++compared;
      for (std::size_t k = 0; k < 3; ++k) REQUIRE(std::fabs((*found)[k] - (*expected)[k]) <= 0x1p-48);
    });
    if (whole_effort("that many straight queries have a normal")) CHECK(compared > 100);
  }
  SECTION("perpendicular to both edges or to the face at the time") {
    std::size_t checked = 0;
    for (std::uint64_t index = 0; index < effort(300); ++index) {
      Rng rng(seeded::seed_of_stream(kSeed, index));
      const Kind kind = rng.one_in(2) ? Kind::edge_edge : Kind::vertex_face;
      const CurvedQuery query = rng.one_in(2) ? meeting_query(kind, rng) : random_query(kind, rng);
      const Answer answer = solve(query);
      const auto normal = contact_normal(query);
      INFO(text_of(query));
      if (!answer.contact) {
        REQUIRE(!normal);
        continue;
      }
      if (!normal) continue;
      ++checked;
      std::array<std::array<long double, 3>, 4> x;
      for (std::size_t i = 0; i < 4; ++i) x[i] = position(query, query.corners[i], answer.toi);
      const auto along = [&](std::size_t i, std::size_t j) {
        long double sum = 0, square = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const long double e = x[j][k] - x[i][k];
          sum += e * (*normal)[k];
          square += e * e;
        }
        return square > 0 ? std::fabs(sum) / std::sqrt(square) : 0;
      };
      // The times are 2^-53 apart, and the elements turn by less than 2 pi in the step.
      const std::size_t pairs[2][2] = {{kind == Kind::edge_edge ? 0U : 1U, kind == Kind::edge_edge ? 1U : 2U}, {2, 3}};
      for (const auto& pair : pairs) REQUIRE(along(pair[0], pair[1]) < 0x1p-44L);
    }
    if (whole_effort("that many curved elements touch")) CHECK(checked > 50);
  }
  SECTION("it points from the first element to the second") {
    // The face falls on the vertex from above, and then from below.
    CurvedQuery query;
    query.kind = Kind::vertex_face;
    query.corners[0] = CurvedCorner::on_curve({{0, 0, 0}});
    for (const double way : {1.0, -1.0}) {
      const auto corner = [&](double x, double y) {
        return CurvedCorner::on_curve({{x, y, way}, {x, y, way}, {x, y, -3 * way}});
      };
      query.corners[1] = corner(-1, -1);
      query.corners[2] = corner(2, -1);
      query.corners[3] = corner(-1, 2);
      const auto normal = contact_normal(query);
      REQUIRE(normal);
      CHECK(*normal == std::array<double, 3>{0, 0, way});
      CHECK(!contact_normal(query, {}, 0.25));
    }
  }
}

TEST_CASE("the story of a curved query tells the exact level's answer") {
  const numbers::DefaultFloatEnvironment environment;
  for (const CurvedQuery& query : mixed_queries(effort(300))) {
    INFO(text_of(query));
    const exact::Story story = exact::explain(query, 1);
    Answer expected = solve(query, {.method = Method::exact});
    expected.starts_within = story.answer.starts_within;  // the cascade adds it
    REQUIRE(decision_difference(expected, story.answer) == "");
    REQUIRE(story.has_cubic == (query.kind == Kind::edge_edge || query.kind == Kind::vertex_face));
    REQUIRE((!story.candidates.empty() && story.candidates.back().touching) == expected.contact);
  }
}

}  // namespace
}  // namespace touchstone::tests
