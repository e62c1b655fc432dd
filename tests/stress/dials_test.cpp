// Each dial makes queries as stiff as its setting, with contacts and misses at every setting.
// SPDX-License-Identifier: MIT
#include "stress/dials.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <string>

#include <touchstone/contact_times.hpp>
#include <touchstone/solve.hpp>

#include "stress/configuration.hpp"
#include "stress/separation_dials.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::stress;

namespace {

constexpr std::size_t kQueries = 60;

bool same_bits(const Query& one, const Query& other) {
  return std::memcmp(&one.start, &other.start, sizeof one.start) == 0 &&
         std::memcmp(&one.end, &other.end, sizeof one.end) == 0;
}

double largest(const Query& query) {
  double most = 0;
  for (const auto* corners : {&query.start, &query.end}) {
    for (const Vec3& c : *corners) most = std::max({most, std::fabs(c.x), std::fabs(c.y), std::fabs(c.z)});
  }
  return most;
}

}  // namespace

TEST_CASE("every dial goes as far as it says, from a gentle setting") {
  const auto reaches = [](const char* name, int low, int high) {
    const Dial* const dial = find_dial(name);
    REQUIRE(dial != nullptr);
    CAPTURE(name);
    CHECK(std::is_sorted(dial->settings.begin(), dial->settings.end()));
    CHECK(dial->settings.front() == low);
    CHECK(dial->settings.back() == high);
    CHECK(std::count(dial->settings.begin(), dial->settings.end(), dial->gentle) == 1);
  };
  reaches("scale", -1070, 1020);
  reaches("offset", 0, 60);
  reaches("sliver", -60, 0);
  reaches("parallel", -100, 0);
  reaches("separation", -200, -4);
  reaches("speed", 0, 60);
  CHECK(dials().size() == 6);
  CHECK(find_dial("sl") == nullptr);
  CHECK(find_dial("") == nullptr);
}

TEST_CASE("at every setting there are contacts and misses, finite and different, and no method of ours errs") {
  for (const Dial& dial : dials()) {
    for (const Kind kind : kAskedKinds) {
      for (const int setting : dial.settings) {
        CAPTURE(dial.name, name_of(kind), setting);
        const auto set = make_set(dial, kind, setting, 3, kQueries);
        REQUIRE(set.queries.size() == kQueries);
        REQUIRE(set.kind == kind);
        std::size_t contacts = 0;
        for (const Query& query : set.queries) {
          REQUIRE(query.kind == kind);
          REQUIRE(std::isfinite(largest(query)));
          const Answer answer = solve(query);
          const Answer exact = solve(query, {.method = Method::exact});
          REQUIRE(answer.contact == exact.contact);
          if (exact.contact) REQUIRE(answer.toi == exact.toi);
          contacts += answer.contact;
        }
        CHECK(contacts >= kQueries / 5);
        // Where all corners are rounded to one place, everything touches.
        const bool collapsed = dial.name == "offset" && setting >= 56;
        if (!collapsed) CHECK(contacts < kQueries);
      }
    }
  }
}

TEST_CASE("a seed makes the same queries again, and another one others") {
  for (const Dial& dial : dials()) {
    const auto one = make_set(dial, Kind::edge_edge, dial.settings.front(), 1, 20);
    const auto again = make_set(dial, Kind::edge_edge, dial.settings.front(), 1, 20);
    const auto other = make_set(dial, Kind::edge_edge, dial.settings.front(), 2, 20);
    std::size_t differ = 0;
    for (std::size_t i = 0; i < one.queries.size(); ++i) {
      CHECK(same_bits(one.queries[i], again.queries[i]));
      differ += !same_bits(one.queries[i], other.queries[i]);
    }
    CAPTURE(dial.name);
    CHECK(differ > 10);
  }
}

TEST_CASE("a configuration inside both elements touches, and at its time at the latest") {
  seeded::Rng rng(4);
  std::size_t touching = 0, exactly = 0;
  for (int i = 0; i < 400; ++i) {
    const Configuration made = random_configuration(i % 2 == 0 ? Kind::edge_edge : Kind::vertex_face, rng);
    const Answer answer = solve(query_of(made));
    if (!answer.contact) continue;
    ++touching;
    exactly += answer.toi == made.time;
  }
  CHECK(touching > 250);  // three quarters are inside or on a border
  CHECK(exactly > 150);   // some touch earlier as well
}

TEST_CASE("two roots are as near to each other as asked, and different") {
  // Where all is in the first quadrant of time, h and g are read off the query: V's factors, linear in t.
  seeded::Rng rng(9);
  for (const int bits : {4, 10, 40, 54, 80, 100, 130, 200}) {
    for (int i = 0; i < 50; ++i) {
      const Query query = separated_roots(Kind::vertex_face, bits, rng);
      // The vertex' height is the coordinate in which the face has none; the face's rise is at its last corner.
      double height[2]{}, rise[2]{};
      const std::array<Vec3, 4>* const sides[2] = {&query.start, &query.end};
      for (int side = 0; side < 2; ++side) {
        const auto& c = *sides[side];
        // The axes are turned; the face's second corner is at (1, -rise, 0).
        const double one[3] = {c[2].x, c[2].y, c[2].z};
        const int x = one[0] == 1 ? 0 : one[1] == 1 ? 1 : 2;
        const double vertex[3] = {c[0].x, c[0].y, c[0].z}, top[3] = {c[3].x, c[3].y, c[3].z};
        height[side] = vertex[(x + 2) % 3];
        rise[side] = top[(x + 1) % 3];
      }
      const long double h = static_cast<long double>(height[0]) / (static_cast<long double>(height[0]) - height[1]);
      const long double g = static_cast<long double>(rise[0]) / (static_cast<long double>(rise[0]) - rise[1]);
      CAPTURE(bits, i, static_cast<double>(h), static_cast<double>(g));
      // h0 g1 - h1 g0 is exact in integers, and 1 in units of the last places: here in doubles it is small or 0.
      CHECK(std::fabs(static_cast<double>(h - g)) <= std::ldexp(1.0, 5 - std::min(bits, 60)));
      CHECK((height[0] != rise[0] || height[1] != rise[1]));
      const auto times = contact_times(query);
      CHECK(times.size() <= 1);
    }
  }
}
