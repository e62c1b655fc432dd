// The names of elements and corners of curved queries are the caller's, as those of straight ones are.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "laws/curved_law.hpp"
#include "laws/names.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 72;

CurvedQuery relabelled(const CurvedQuery& query, const Relabelling& relabelling) {
  CurvedQuery result = query;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) result.corners[i] = query.corners[relabelling[i]];
  return result;
}

double length_of(const Vec3& v) { return std::hypot(v.x, v.y, v.z); }

/// Whether the element of `count` corners from `first` on has nearly no length or no area at the time. Positions are in
/// doubles, which are good to far better than this.
bool seems_degenerate(const CurvedQuery& query, std::size_t first, std::size_t count, double time) {
  constexpr double kNearly = 0x1p-40;
  if (count == 1) return false;
  std::array<Vec3, 4> at;
  double size = 0;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    at[i] = position(query, i, time);
    size = std::max(size, length_of(at[i]));
  }
  const Vec3 u = at[first + 1] - at[first];
  if (count == 2) return length_of(u) <= kNearly * size;
  const Vec3 w = at[first + 2] - at[first], v = at[first + 2] - at[first + 1];
  const double longest = std::max({length_of(u), length_of(w), length_of(v)});
  if (longest <= kNearly * size) return true;
  const Vec3 a{u.x / longest, u.y / longest, u.z / longest}, b{w.x / longest, w.y / longest, w.z / longest};
  return length_of({a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}) <= kNearly * (size / longest);
}

TEST_CASE("law of curves: relabelling corners and swapping elements changes the names alone") {
  NameTally tally;
  check_curved_law(kSeed, 12, 0.8, [&](const CurvedAsked& asked, Method method, Rng&) -> Finding {
    if (asked.separation.distance > 0) return std::nullopt;  // it has several nearest points
    const Answer expected = answer_to(asked, method);
    const auto degenerate = [&](std::size_t first, std::size_t count) {
      return seems_degenerate(asked.query, first, count, expected.toi);
    };
    for (const Relabelling& relabelling : relabellings(asked.query.kind)) {
      const CurvedAsked other{relabelled(asked.query, relabelling), asked.separation, asked.t_max};
      const Answer found = answer_to(other, method);
      const std::string wrong = name_difference(asked.query.kind, relabelling, expected, found, degenerate, tally);
      if (wrong.empty()) continue;
      return wrong + "\n    expected " + describe(expected) + "\n    found    " + describe(found) + "\n    asked\n" +
             curved_text(other.query);
    }
    return "";
  });
  std::printf("elements touched under the same name %zu, under another %zu\n", tally.same_names, tally.other_names);
  CHECK(tally.same_names > 10 * tally.other_names);
}

TEST_CASE("law of curves: other names change no time, nature or trend of a separation") {
  check_curved_law(kSeed, 12, 0.1, [](const CurvedAsked& asked, Method method, Rng& rng) -> Finding {
    if (asked.separation.distance == 0) return std::nullopt;
    const auto& all = relabellings(asked.query.kind);
    const Relabelling& relabelling = all[static_cast<std::size_t>(rng.below(all.size()))];
    const CurvedAsked other{relabelled(asked.query, relabelling), asked.separation, asked.t_max};
    const Answer expected = answer_to(asked, method), found = answer_to(other, method);
    const bool same = expected.contact == found.contact && expected.toi == found.toi &&
                      expected.toi_upper == found.toi_upper && expected.nature == found.nature &&
                      expected.trend == found.trend && expected.starts_within == found.starts_within;
    return same ? "" : "expected " + describe(expected) + "\n    found    " + describe(found);
  });
}

}  // namespace
}  // namespace touchstone::tests
