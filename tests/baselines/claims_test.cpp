// Every baseline answers ordinary queries correctly, made by hand and at random.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "baselines/baseline.hpp"
#include "support/query_families.hpp"
#include "support/report.hpp"

namespace touchstone::tests {
namespace {

using baselines::Baseline;
using baselines::Result;

// No method at its usual tolerance is farther from an ordinary contact's time than this: the tolerances are 1e-6, and
// relative speeds at contact are at least 1e-2 where the queries below are ordinary.
constexpr double kTimeError = 1e-3;

Result answer_of(const Baseline& method, const Query& query, double t_max = 1.0) {
  return method.solve(query, t_max, method.usual_tolerance);
}

TEST_CASE("the registry names each baseline once, and says what it takes") {
  std::vector<std::string_view> names;
  for (const Baseline& method : baselines::methods()) {
    names.push_back(method.name);
    CHECK(baselines::find_method(method.name) == &method);
    CHECK_FALSE(method.about.empty());
    CHECK(method.has_tolerance() == (method.usual_tolerance > 0));
    CHECK(method.supports(Kind::edge_edge));
    CHECK(method.supports(Kind::vertex_face));
  }
  CHECK(names ==
        std::vector<std::string_view>{"paper", "closed_form", "newton", "interval", "conservative_advancement"});
  CHECK(baselines::find_method("exact") == nullptr);
}

TEST_CASE("a kind that a baseline does not take is an error, not an answer") {
  std::size_t refused = 0;
  for (const Baseline& method : baselines::methods()) {
    for (const Kind kind : kKinds) {
      Query query;
      query.kind = kind;
      INFO(method.name << " " << name_of(kind));
      if (method.supports(kind)) {
        CHECK_NOTHROW(answer_of(method, query));
      } else {
        CHECK_THROWS_AS(answer_of(method, query), InvalidQuery);
        ++refused;
      }
    }
  }
  CHECK(refused == 2);  // point-edge and point-point by the paper
}

struct Handmade {
  const char* name;
  Query query;
  double toi;  // negative without contact
};

std::vector<Handmade> handmade_queries() {
  const auto corner = [](double x, double y, double z) { return Vec3{x, y, z}; };
  // A cross of two edges: the first rests, the second falls through it at t = 1/3, or beside it. A little skewed, so
  // that neither the cubic's degree nor a coordinate of the normal vanishes.
  const auto cross = [&](double shift) {
    return EdgeEdge{
        {corner(-1, 0.125, 0.25), corner(1, -0.125, -0.25), corner(shift, -1, 1), corner(shift + 0.125, 1, 1.25)},
        {corner(-1, 0.25, 0.125), corner(1, -0.25, -0.125), corner(shift, -1, -2), corner(shift - 0.25, 1, -2.5)}};
  };
  // A vertex that falls through a face at t = 1/4, or beside it.
  const auto fall = [&](double x) {
    return VertexFace{{corner(x, 0.25, 1), corner(0, 0, 0), corner(1, 0, 0), corner(0, 1, 0)},
                      {corner(x, 0.25, -3), corner(0, 0, 0), corner(1, 0, 0), corner(0, 1, 0)}};
  };
  const auto point_edge = [&](double x) {
    return PointEdge{{corner(x, 1, 0.5), corner(-1, 0, 0), corner(1, 0, 0)},
                     {corner(x, -1, -0.5), corner(-1, 0, 0), corner(1, 0, 0)}};
  };
  const auto point_point = [&](double x) {
    return PointPoint{{corner(0, 0, 0), corner(4, 4, 4)}, {corner(3, 3, 3), corner(x, 0, 0)}};
  };
  return {{"edges cross", cross(0.25), 0.30},           {"edges pass each other", cross(1.5), -1},
          {"vertex falls on face", fall(0.25), 0.25},   {"vertex falls beside face", fall(0.875), -1},
          {"point crosses edge", point_edge(0.5), 0.5}, {"point passes edge", point_edge(1.5), -1},
          {"points meet", point_point(0), 4.0 / 7},     {"points pass", point_point(1), -1}};
}

TEST_CASE("hand-made ordinary queries are answered rightly by every baseline") {
  for (const Handmade& handmade : handmade_queries()) {
    const Answer truth = solve(handmade.query);
    CHECK(truth.contact == (handmade.toi >= 0));
    if (truth.contact) CHECK(std::fabs(truth.toi - handmade.toi) < 0.05);
    for (const Baseline& method : baselines::methods()) {
      if (!method.supports(handmade.query.kind)) continue;
      INFO(method.name << ": " << handmade.name << ", " << describe(truth));
      const Result result = answer_of(method, handmade.query);
      CHECK(result.contact == truth.contact);
      if (truth.contact) CHECK(std::fabs(result.toi - truth.toi) < kTimeError);
      // Before the time of impact, there is none.
      CHECK_FALSE(answer_of(method, handmade.query, truth.contact ? truth.toi - 2 * kTimeError : 1.0).contact);
    }
  }
}

/// The query with the elements stretched about their centres and the first one shifted.
Query varied(Query query, double stretch, const Vec3& shift) {
  const ElementSizes sizes = element_sizes(query.kind);
  for (auto* corners : {&query.start, &query.end}) {
    const auto stretched = [&](std::size_t first, std::size_t count) {
      Vec3 centre{};
      for (std::size_t i = 0; i < count; ++i) {
        centre = centre + (1.0 / static_cast<double>(count)) * (*corners)[first + i];
      }
      for (std::size_t i = 0; i < count; ++i) {
        Vec3& corner = (*corners)[first + i];
        corner = centre + stretch * (corner - centre);
      }
    };
    stretched(0, sizes.a);
    stretched(sizes.a, sizes.b);
    for (std::size_t i = 0; i < sizes.a; ++i) (*corners)[i] = (*corners)[i] + shift;
  }
  return query;
}

/// An ordinary query keeps its answer, the time within 1/20, when the elements grow, shrink or shift by 1/50: the
/// contact is not near an end of the step, a boundary of an element or another root of V, and a miss is no near miss.
bool is_ordinary(const Query& query, const Answer& truth) {
  constexpr double kShift = 0.02;
  const std::vector<Query> variations{varied(query, 1 - kShift, {}),    varied(query, 1 + kShift, {}),
                                      varied(query, 1, {kShift, 0, 0}), varied(query, 1, {-kShift, 0, 0}),
                                      varied(query, 1, {0, kShift, 0}), varied(query, 1, {0, -kShift, 0}),
                                      varied(query, 1, {0, 0, kShift}), varied(query, 1, {0, 0, -kShift})};
  return std::all_of(variations.begin(), variations.end(), [&](const Query& variation) {
    const Answer answer = solve(variation);
    if (answer.contact != truth.contact) return false;
    return !truth.contact || std::fabs(answer.toi - truth.toi) < 0.05;
  });
}

TEST_CASE("random ordinary edge-edge and vertex-face queries are answered rightly by every baseline") {
  constexpr std::uint64_t kSeed = 301;
  INFO("seed " << kSeed);
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
    Rng rng(kSeed);
    std::size_t contacts = 0;
    std::size_t misses = 0;
    for (std::size_t i = 0; i < effort(3000); ++i) {
      Query query;
      query.kind = kind;
      for_each_coordinate(query, [&](double& x) { x = rng.symmetric(); });
      const Answer truth = solve(query);
      if (!is_ordinary(query, truth)) continue;
      ++(truth.contact ? contacts : misses);
      for (const Baseline& method : baselines::methods()) {
        const Result result = answer_of(method, query);
        const bool right =
            result.contact == truth.contact && (!truth.contact || std::fabs(result.toi - truth.toi) < kTimeError);
        if (!right)
          FAIL_CHECK(method.name << " at " << result.toi << ", " << describe(truth) << "\n  "
                                 << cpp_initializer(query));
      }
    }
    CHECK(contacts >= effort(3000) / 100);
    CHECK(misses >= effort(3000) / 100);
  }
}

TEST_CASE("baselines that take points find contacts by construction, and none where a plane separates") {
  constexpr std::uint64_t kSeed = 302;
  for (const Baseline& method : baselines::methods()) {
    for (const Kind kind : {Kind::point_edge, Kind::point_point}) {
      if (!method.supports(kind)) continue;
      for (std::size_t index = 0; index < effort(300); ++index) {
        const CaseId id{Family::prescribed, kind, kSeed, index};
        Rng rng = rng_of(id);
        const Query query = make(id);
        const Answer truth = solve(query);
        INFO(method.name << " " << case_name(id) << ": " << describe(truth) << "\n  " << cpp_initializer(query));
        REQUIRE(truth.contact);
        const Result result = answer_of(method, query);
        CHECK(result.contact);
        CHECK(std::fabs(result.toi - truth.toi) < kTimeError);

        Query apart = query;
        for_each_coordinate(apart, [&](double& x) { x = rng.symmetric(); });
        for (auto* corners : {&apart.start, &apart.end}) {
          for (std::size_t i = 0; i < corner_count(kind); ++i) {
            double& z = (*corners)[i].z;
            z = i == 0 ? 0.01 + std::fabs(z) : -std::fabs(z);
          }
        }
        CHECK_FALSE(answer_of(method, apart).contact);
      }
    }
  }
}

}  // namespace
}  // namespace touchstone::tests
