// The bracket level of curved queries with a separation: its answers against the exact level's.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>
#include <string>

#include "curved/expected.hpp"
#include "filters/curved/curved_bracket.hpp"
#include "seeded/rng.hpp"
#include "support/query_families.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {
namespace {

using seeded::Rng;

constexpr std::uint64_t kSeed = 71;

Kind some_kind(Rng& rng) { return static_cast<Kind>(rng.between(0, 3)); }

}  // namespace

TEST_CASE("curved bracket: with a separation its answers are the exact level's") {
  struct Tally {
    std::size_t entries = 0, starts = 0, exact_entries = 0, exact_starts = 0, misses = 0, exact_misses = 0;
  };
  for (const Family family : {Family::turning_bodies, Family::curved_random, Family::near_meeting, Family::spline}) {
    Tally tally;
    for (const Kind kind : kKinds) {
      for (std::uint64_t index = 0; index < effort(100); ++index) {
        const CaseId id{family, kind, kSeed + 4, index};
        const CurvedSample sample = make_curved(id);
        Rng rng(seeded::seed_of_stream(kSeed + 5, index));
        const Separation separation = {std::ldexp(1 + rng.unit(), -rng.between(0, 12)),
                                       rng.one_in(2) ? Metric::euclidean : Metric::max};
        const Answer exact =
            solve(sample.query, {.t_max = sample.t_max, .separation = separation, .method = Method::exact});
        Answer bracket;
        const auto finding = filters::decide_in_brackets(sample.query, separation, sample.t_max, bracket);
        if (finding == filters::Outcome::uncertain) {
          ++(!exact.contact ? tally.exact_misses : exact.starts_within ? tally.exact_starts : tally.exact_entries);
          continue;
        }
        ++(!exact.contact ? tally.misses : exact.starts_within ? tally.starts : tally.entries);
        INFO(case_name(id) << ", t_max " << hexfloat(sample.t_max) << ", distance " << hexfloat(separation.distance)
                           << " " << name_of(separation.metric) << "\n"
                           << curved_text(sample.query));
        INFO("exact:   " << describe(exact) << "\nbracket: " << describe(bracket));
        REQUIRE((finding == filters::Outcome::contact) == exact.contact);
        REQUIRE(decision_difference(exact, bracket) == "");
        REQUIRE(weight_difference(exact, bracket) == "");
        REQUIRE(bracket.trend == exact.trend);
        REQUIRE(bracket.starts_within == exact.starts_within);
        if (exact.contact) REQUIRE(bracket.level == Level::bracket);
      }
    }
    std::printf(
        "%-15s with a separation, by the bracket level and not: entries %zu, %zu; from the start %zu, %zu; "
        "misses %zu, %zu\n",
        std::string(info(family).name).c_str(), tally.entries, tally.exact_entries, tally.starts, tally.exact_starts,
        tally.misses, tally.exact_misses);
    if (!whole_effort("that the bracket level decides most queries with a separation")) continue;
    CHECK(tally.entries > 0);
    CHECK(tally.starts > 0);
    const bool ordinary = family == Family::turning_bodies || family == Family::curved_random;
    if (!ordinary) continue;
    CHECK(tally.exact_entries < tally.entries / 10);
    CHECK(tally.exact_starts < tally.starts / 10);
    CHECK(tally.exact_misses < tally.misses / 10);
  }
}

namespace {

/// The corner at t = 0, about.
Vec3 start_of(const CurvedQuery& query, std::size_t corner) {
  const CurvedCorner& c = query.corners[corner];
  const Vec3& x = c.points[0];
  if (c.motion == CurvedCorner::kOnCurve) return x;
  const RigidMotion& motion = query.motions[static_cast<std::size_t>(c.motion)];
  const auto& [w, a, b, d] = motion.q0;
  const double size = w * w + a * a + b * b + d * d;
  const auto cross = [&, a = a, b = b, d = d](const Vec3& v) {
    return Vec3{b * v.z - d * v.y, d * v.x - a * v.z, a * v.y - b * v.x};
  };
  const Vec3 once = cross(x), twice = cross(once);
  return {x.x + 2 * (w * once.x + twice.x) / size + motion.p0.x, x.y + 2 * (w * once.y + twice.y) / size + motion.p0.y,
          x.z + 2 * (w * once.z + twice.z) / size + motion.p0.z};
}

/// Moves the first element's body such that both elements touch at t = 0, up to rounding.
void let_touch(CurvedQuery& query, Rng& rng) {
  const std::size_t first_corners = query.kind == Kind::edge_edge ? 2 : 1;
  const auto somewhere = [&](std::size_t begin, std::size_t end) {
    Vec3 sum;
    double rest = 1;
    for (std::size_t i = begin; i < end; ++i) {
      const double weight = i + 1 == end ? rest : rest * rng.unit();
      rest -= weight;
      const Vec3 x = start_of(query, i);
      sum = {sum.x + weight * x.x, sum.y + weight * x.y, sum.z + weight * x.z};
    }
    return sum;
  };
  const Vec3 from = somewhere(0, first_corners), to = somewhere(first_corners, corner_count(query.kind));
  Vec3& place = query.motions[static_cast<std::size_t>(query.corners[0].motion)].p0;
  place = {place.x + (to.x - from.x), place.y + (to.y - from.y), place.z + (to.z - from.z)};
}

void agrees_from_the_start(const CurvedQuery& query, const Separation& separation, std::size_t& starts) {
  Answer bracket;
  const auto finding = filters::decide_in_brackets(query, separation, 1, bracket);
  const Answer exact = solve(query, {.separation = separation, .method = Method::exact});
  INFO("distance " << hexfloat(separation.distance) << " " << name_of(separation.metric) << "\n" << curved_text(query));
  INFO("exact:   " << describe(exact) << "\nbracket: " << describe(bracket));
  starts += exact.starts_within;
  if (finding == filters::Outcome::uncertain) return;
  REQUIRE((finding == filters::Outcome::contact) == exact.contact);
  REQUIRE(decision_difference(exact, bracket) == "");
  REQUIRE(weight_difference(exact, bracket) == "");
  REQUIRE(bracket.trend == exact.trend);
  REQUIRE(bracket.starts_within == exact.starts_within);
}

}  // namespace

TEST_CASE("curved bracket: elements that touch at the start up to rounding, with a separation") {
  std::size_t starts = 0, queries = 0;
  for (const Kind kind : kKinds) {
    for (std::uint64_t index = 0; index < effort(40); ++index) {
      Rng rng(seeded::seed_of_stream(kSeed + 7, index));
      CurvedQuery query = make_curved({Family::turning_bodies, kind, kSeed + 7, index}).query;
      if (query.corners[0].motion == CurvedCorner::kOnCurve) continue;
      let_touch(query, rng);
      const double distance = std::ldexp(1 + rng.unit(), -rng.between(2, 8));
      for (const Metric metric : {Metric::euclidean, Metric::max}) {
        ++queries;
        agrees_from_the_start(query, {distance, metric}, starts);
      }
    }
  }
  CHECK(queries > 0);
  CHECK(2 * starts > queries);

  // Its plane's side was told by the sign of a rounding error: the trend was wrong.
  CurvedQuery plane;
  plane.kind = Kind::vertex_face;
  plane.corners[0] = CurvedCorner::on_body(0, {-0x1.de0e80e6d942cp-3, -0x1.4c5d5ab0dd224p-3, 0x1.e3f0ae03805b4p-3});
  plane.corners[1] = CurvedCorner::on_body(1, {-0x1.d952c44b0e208p-3, 0x1.835a6c92ebab8p-4, -0x1.6b4f99a9fe328p-5});
  plane.corners[2] = CurvedCorner::on_body(1, {0x1.7e07d4b9c8bdap-3, -0x1.418aa7c1c101cp-4, -0x1.c25f38f450c98p-3});
  plane.corners[3] = CurvedCorner::on_body(1, {-0x1.c94b48caa2b24p-4, -0x1.8fa0e292cbe52p-3, -0x1.37c0a7da85c7p-5});
  plane.motions[0] = {{-0x1.7106ff3e1b634p-1, 0x1.74cdcac71dfcp-6, -0x1.8a82dc46221ep-5, 0x1.4aeebfb3b6114p-2},
                      {-0x1.19151011bfc3fp-2, 0x1.77a884b9fa35p-6, -0x1.09161ede61c64p-1, 0x1.06d464a250216p-1},
                      {0x1.487a9595371f8p-2, -0x1.fb2949fcef6ap-3, 0x1.3d7747d3e221p-2},
                      {-0x1.6ecfdf8b58a6p-4, -0x1.81dfc9812341p-2, -0x1.79825406a54ap-6}};
  plane.motions[1] = {{0x1.1c1394413b784p-1, 0x1.5ddcff5c267d6p-1, -0x1.697a79685f5fp-3, 0x1.0e14fd172da92p-1},
                      {0x1.354499f2c4a1cp-3, 0x1.33f7ee26928a8p-2, 0x1.078d54f9ee938p-4, 0x1.0a1cb0de138a2p+0},
                      {0x1.cf7540d750184p-4, -0x1.f720ebfe7c4bcp-3, 0x1.62b506d65e984p-1},
                      {-0x1.a0f41e02f113ap-3, -0x1.9527b39e0afb8p-3, 0x1.9b82e9812ae91p-1}};
  for (const Metric metric : {Metric::euclidean, Metric::max}) {
    agrees_from_the_start(plane, {0x1.2c7c935c01469p-4, metric}, starts);
  }
}

TEST_CASE("curved bracket: separations that are just reached are not denied") {
  // The least distance of a random pair, by bisection between doubles, of which the greater one is a contact.
  std::size_t found = 0, denied = 0;
  for (std::uint64_t index = 0; index < effort(40); ++index) {
    Rng rng(seeded::seed_of_stream(kSeed + 6, index));
    const CurvedQuery query = make_curved({Family::turning_bodies, some_kind(rng), kSeed + 6, index}).query;
    const Metric metric = rng.one_in(2) ? Metric::euclidean : Metric::max;
    const auto exact_contact = [&](double d) {
      return solve(query, {.separation = Separation{d, metric}, .method = Method::exact}).contact;
    };
    double low = 0x1p-30, high = 4;
    if (exact_contact(low) || !exact_contact(high)) continue;
    ++found;
    while (high > std::nextafter(low, 5)) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) break;
      (exact_contact(middle) ? high : low) = middle;
    }
    INFO("seed " << kSeed + 6 << ", index " << index);
    for (int bits = 53; bits >= 20; bits -= 3) {
      const double more = high * (1 + std::ldexp(1.0, -bits)), less = low * (1 - std::ldexp(1.0, -bits));
      Answer answer;
      REQUIRE(filters::decide_in_brackets(query, {more, metric}, 1, answer) != filters::Outcome::no_contact);
      if (answer.contact)
        REQUIRE(decision_difference(solve(query, {.separation = Separation{more, metric}, .method = Method::exact}),
                                    answer) == "");
      const filters::Outcome below = filters::decide_in_brackets(query, {less, metric}, 1, answer);
      REQUIRE(below != filters::Outcome::contact);
      denied += below == filters::Outcome::no_contact;
    }
  }
  std::printf("%zu least distances; %zu a little less are proved to be kept\n", found, denied);
  CHECK(found > effort(40) / 2);
  CHECK(denied > found);
}

}  // namespace touchstone::tests
