// The baselines with a separation: right on ordinary queries, in range on all, wrong where their idea is.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <touchstone/solve.hpp>

#include "baselines/separation_baseline.hpp"
#include "support/query_families.hpp"
#include "support/report.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 305;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Point p moves along x from x0 to x1 at height y; q rests at the origin.
Query passing_points(double x0, double x1, double y) { return PointPoint{{{{x0, y, 0}, {}}}, {{{x1, y, 0}, {}}}}; }

baselines::Result ask(const baselines::SeparationBaseline& method, const Query& query, double separation) {
  return method.solve(query, separation, 1, method.usual_tolerance);
}

TEST_CASE("baselines with a separation answer in range for every family, separation, t_max and tolerance") {
  Report report;
  for_each_case(
      kSeed, 20, [](const FamilyInfo&, Kind) { return true; },
      [&](const CaseId& id) {
        const Query query = make(id);
        Rng rng = rng_of(id);
        for (const auto& method : baselines::separation_methods()) {
          const double t_max = rng.pick(std::array<double, 4>{1.0, 0.0, 0.3, 0x1p-1074});
          const double separation = rng.pick(std::array<double, 6>{0.0, 0x1p-1074, 1e-3, 1.0, 1e9, 0x1p1023});
          const double tolerance = rng.pick(std::array<double, 6>{0.1, 0.0, 1e-9, 1e9, -1.0, std::nan("")});
          const baselines::Result result = method.solve(query, separation, t_max, tolerance);
          const bool in_range = result.contact ? result.toi >= 0 && result.toi <= t_max : result.toi == kInfinity;
          report.add(id, query, in_range ? std::string() : std::string(method.name) + " is out of range");
        }
      });
}

TEST_CASE("random ordinary queries with a separation are answered rightly by every baseline") {
  std::size_t contacts = 0;
  const auto check = [&](Kind kind) {
    Rng rng(kSeed + static_cast<std::uint64_t>(kind));
    for (int i = 0; i < 300; ++i) {
      Query query;
      query.kind = kind;
      for (std::size_t k = 0; k < corner_count(kind); ++k) {
        query.start[k] = {rng.symmetric(), rng.symmetric(), rng.symmetric()};
        query.end[k] = {rng.symmetric(), rng.symmetric(), rng.symmetric()};
      }
      const Separation separation = {0.1};
      const Answer truth = solve(query, {.separation = separation});
      contacts += truth.contact;
      for (const auto& method : baselines::separation_methods()) {
        CAPTURE(method.name, name_of(kind), i);
        const baselines::Result result = ask(method, query, separation.distance);
        if (method.name == "thick_advancement") {
          // A tenth of the first gap early, and never late but for rounding.
          if (truth.contact) REQUIRE(result.contact);
          if (truth.contact) REQUIRE(result.toi <= truth.toi + 1e-12);
          if (!solve(query, {.separation = Separation{0.5}}).contact) REQUIRE_FALSE(result.contact);
        } else {
          REQUIRE(result.contact == truth.contact);
          if (truth.contact) REQUIRE(std::fabs(result.toi - truth.toi) <= 1e-9);
        }
      }
    }
  };
  for (const Kind kind : kKinds) check(kind);
  CHECK(contacts > 200);
}

TEST_CASE("the polynomial in doubles fails: late by ulps, and where a square drowns") {
  const auto& method = *baselines::find_separation_method("thick_polynomial");
  // A root is off by two ulps: the coefficients are rounded, too.
  const Query edges(EdgeEdge{{{{0, 0, 0}, {1, 1, 1}, {0, 0, 1}, {0, 1, 0}}}, {{{0, 0, 0}, {1, 1, 1}, {0, 0, 1}, {}}}});
  const Answer truth = solve(edges, {.separation = Separation{0.1}});
  CHECK(ask(method, edges, 0.1).toi > truth.toi_upper);
  // At a height of d (1 + 2^-40), which no square of it in doubles keeps beside d^2 times 1e24.
  const Query near_miss = passing_points(-0x1p40, 0x1p40, 1 + 0x1p-40);
  CHECK_FALSE(solve(near_miss, {.separation = Separation{1}}).contact);
  CHECK(ask(method, near_miss, 1).contact);
}

TEST_CASE("conservative advancement with a separation claims contacts of elements that only come near") {
  const auto& method = *baselines::find_separation_method("thick_advancement");
  const Query near_miss = passing_points(-2, 2, 1.05);
  CHECK_FALSE(solve(near_miss, {.separation = Separation{1}}).contact);
  CHECK(ask(method, near_miss, 1).contact);
}

}  // namespace
}  // namespace touchstone::tests
