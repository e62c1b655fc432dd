// Queries that come near the limits of the entry filter's bounds.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <touchstone/distance.hpp>

#include "support/query_families.hpp"

namespace touchstone::tests {

/// A question with a separation.
struct EntryCase {
  Query query;
  Separation separation;
  double t_max;
};

/// Where the difficulty of an entry lies.
enum class Difficulty : std::uint8_t {
  plain,       ///< ordinary sizes and motions
  border,      ///< feet near the border of a feature
  multiplier,  ///< other corners hardly farther away than the closest feature
  small_gap,   ///< a separation far below the elements' size
  large_gap,   ///< a separation far above the elements' size
  needle,      ///< edges and faces of very different lengths
  slow,        ///< an approach that is slow beside the motion
  violent,     ///< elements that move and turn by many times their size
  early,       ///< an entry just after t = 0
  late,        ///< an entry just before t = 1 or t_max
  within,      ///< a start within the separation by a hair, or beside it
  extreme,     ///< coordinates near the limits of the filter's range, far offsets
  rigid,       ///< a motion of both that roundings alone make one of the elements to each other
  hovering,    ///< a distance that hardly changes, hardly more than the separation
  lattice,     ///< small integers
  turning,     ///< a separation that is the distance's least value, or hardly less
  tied,        ///< small integers, and a start within the separation
  exact        ///< an entry at a double, of coordinates whose products fill more than two doubles
};
inline constexpr std::array<Difficulty, 15> kDifficulties = {
    Difficulty::lattice,   Difficulty::plain,  Difficulty::border,  Difficulty::multiplier, Difficulty::small_gap,
    Difficulty::large_gap, Difficulty::needle, Difficulty::slow,    Difficulty::violent,    Difficulty::early,
    Difficulty::late,      Difficulty::within, Difficulty::extreme, Difficulty::rigid,      Difficulty::hovering};
/// At these an entry's conditions fail, rather than its bounds.
inline constexpr std::array<Difficulty, 3> kFailingConditions = {Difficulty::exact, Difficulty::tied,
                                                                 Difficulty::turning};
inline constexpr std::array<const char*, 18> kDifficultyNames = {
    "plain", "border", "multiplier", "small gap", "large gap", "needle",  "slow",    "violent", "early",
    "late",  "within", "extreme",    "rigid",     "hovering",  "lattice", "turning", "tied",    "exact"};

namespace entry_cases {

inline Vec3 sum(const Vec3& a, const Vec3& b, double factor) {
  return {a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z};
}
inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 random_vector(Rng& rng) { return {rng.symmetric(), rng.symmetric(), rng.symmetric()}; }
inline double power(Rng& rng, int low, int high) { return std::ldexp(1 + rng.unit(), rng.between(low, high)); }

inline Vec3 direction(Rng& rng) {
  if (rng.one_in(6)) return rng.one_in(2) ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 v = random_vector(rng);
  const double length = std::sqrt(dot(v, v));
  return length > 0.1 ? Vec3{v.x / length, v.y / length, v.z / length} : Vec3{0, 1, 0};
}

/// An element with its closest point at the origin, below the plane through it, and the weights of that point.
struct Element {
  std::size_t count;
  std::array<Vec3, 3> corner;
  std::array<double, 3> weight{};
};

inline Element element(std::size_t count, const Vec3& normal, Difficulty difficulty, double size, Rng& rng) {
  Element e;
  e.count = count;
  std::size_t support = 0;
  do {  // corners of the closest feature
    support = 0;
    for (std::size_t i = 0; i < count; ++i) {
      e.weight[i] = rng.one_in(3) ? 0 : 0.05 + rng.unit();
      if (difficulty == Difficulty::border && e.weight[i] != 0 && rng.one_in(3)) e.weight[i] = power(rng, -22, -15);
      support += e.weight[i] != 0;
    }
  } while (support == 0);
  const double total = e.weight[0] + e.weight[1] + e.weight[2];
  Vec3 foot = {0, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    e.weight[i] /= total;
    Vec3 a = random_vector(rng);
    if (difficulty == Difficulty::needle) {
      const double length = power(rng, -30, 0);
      a = i > 0 && rng.one_in(2) ? sum(e.corner[i - 1], a, size * length) : sum({0, 0, 0}, a, size * length);
    } else {
      a = sum({0, 0, 0}, a, size);
    }
    a = sum(a, normal, -dot(a, normal));
    e.corner[i] = a;
    foot = sum(foot, a, e.weight[i]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    e.corner[i] = sum(e.corner[i], foot, -1);
    if (e.weight[i] != 0) continue;
    double depth = rng.unit();
    if (difficulty == Difficulty::multiplier) depth = power(rng, -50, -5);
    e.corner[i] = sum(e.corner[i], normal, -size * depth);
  }
  return e;
}

inline double time_of(Difficulty difficulty, Rng& rng) {
  if (difficulty == Difficulty::early) return power(rng, rng.one_in(4) ? -300 : -60, -20);
  if (difficulty == Difficulty::late) return 1 - power(rng, -54, -20);
  switch (rng.between(0, 3)) {
    case 0: return std::ldexp(rng.between(1, 15), -4);
    case 1: return std::ldexp(1 + rng.between(0, 1000), -11);
    default: return rng.unit();
  }
}

inline double nudged(double x, int steps) {
  for (; steps > 0; --steps) x = std::nextafter(x, 0x1p1023);
  for (; steps < 0; ++steps) x = std::nextafter(x, 0);
  return x;
}

/// The least distance near the best of some times.
inline double least_distance(const Query& query, Metric metric) {
  constexpr int kTimes = 16, kSteps = 50;
  const auto at = [&](double t) { return distance(query, t, metric).value; };
  int best = 0;
  for (int i = 1; i <= kTimes; ++i) best = at(i / double{kTimes}) < at(best / double{kTimes}) ? i : best;
  double low = std::max(best - 1, 0) / double{kTimes}, high = std::min(best + 1, kTimes) / double{kTimes};
  for (int i = 0; i < kSteps; ++i) {
    const double third = (high - low) / 3;
    (at(low + third) < at(high - third) ? high : low) += at(low + third) < at(high - third) ? -third : third;
  }
  return at(0.5 * (low + high));
}

/// Elements whose closest points are exactly as far apart as the separation at a double. All coordinates are multiples
/// of 2^-44.
inline EntryCase exact_entry(Kind kind, Metric metric, Rng& rng) {
  const auto on_grid = [](const Vec3& v) {
    const auto put = [](double x) { return std::ldexp(std::rint(std::ldexp(x, 40)), -40); };
    return Vec3{put(v.x), put(v.y), put(v.z)};
  };
  const std::size_t corners = corner_count(kind), first = kind == Kind::edge_edge ? 2 : 1;
  EntryCase result;
  result.t_max = 1;
  result.query.kind = kind;
  result.separation = {on_grid({rng.unit(), 0, 0}).x, metric};
  const double d = result.separation.distance;
  Vec3 c = {d, d, d};
  if (metric == Metric::euclidean) c = {0.75 * d, 0, 0}, result.separation.distance *= 1.25, c.y = d;
  // The elements' edges lead away from c, or along it.
  std::array<Vec3, 4> at{}, velocity{};
  const auto edge = [&] { return on_grid(sum(random_vector(rng), c, -dot(random_vector(rng), c))); };
  const auto put = [&](std::size_t begin, std::size_t end, const Vec3& foot) {
    const Vec3 u = edge(), w = edge();
    if (end - begin == 1) at[begin] = foot;
    if (end - begin == 2) at[begin] = sum(foot, u, -0.25), at[begin + 1] = sum(foot, u, 0.75);
    if (end - begin != 3) return;
    at[begin] = sum(sum(foot, u, -0.25), w, -0.5);
    at[begin + 1] = sum(at[begin], u, 1);
    at[begin + 2] = sum(at[begin], w, 1);
  };
  put(0, first, c);
  put(first, corners, {0, 0, 0});
  const double t = std::ldexp(rng.between(1, 7), -3);
  for (std::size_t i = 0; i < corners; ++i) {
    const Vec3 way = {std::ldexp(rng.between(-7, 7), -3), std::ldexp(rng.between(-7, 7), -3), 0.5};
    velocity[i] = rng.one_in(2) ? way : Vec3{0, 0, 0};
    if (i < first) velocity[i] = sum(velocity[i], {1, 1, 1}, -2);
    result.query.start[i] = sum(at[i], velocity[i], -t);
    result.query.end[i] = sum(at[i], velocity[i], 1 - t);
  }
  return result;
}

}  // namespace entry_cases

/// A query whose closest points at some time are chosen first, and a separation near their distance. In the
/// largest-axis metric other points may be closest.
inline EntryCase make_entry(Kind kind, Difficulty difficulty, Metric metric, Rng& rng) {
  namespace ec = entry_cases;
  if (difficulty == Difficulty::exact) return ec::exact_entry(kind, metric, rng);
  const bool tied = difficulty == Difficulty::tied;
  EntryCase result;
  result.t_max = rng.one_in(4) ? rng.unit() : 1;
  Query& query = result.query;
  query.kind = kind;
  const std::size_t corners = corner_count(kind), first = kind == Kind::edge_edge ? 2 : 1;
  const double offset = difficulty == Difficulty::extreme ? ec::power(rng, -10, 40) : rng.one_in(4) ? 4 : 0;
  const Vec3 away = ec::sum({0, 0, 0}, ec::random_vector(rng), offset);
  const Vec3 normal = ec::direction(rng);
  double gap = rng.one_in(2) ? 0.25 : ec::power(rng, -10, 2);
  if (difficulty == Difficulty::small_gap) gap = ec::power(rng, -41, -10);
  if (difficulty == Difficulty::large_gap) gap = ec::power(rng, 3, 45);
  const double size = rng.one_in(4) ? ec::power(rng, -8, 4) : 1;
  const Vec3 opposite = ec::sum({0, 0, 0}, normal, -1);
  ec::Element a = ec::element(first, opposite, difficulty, rng.one_in(3) ? ec::power(rng, -12, 0) : size, rng);
  ec::Element b = ec::element(corners - first, normal, difficulty, size, rng);
  std::array<Vec3, 4> at{}, velocity{};
  double speed = rng.one_in(3) ? ec::power(rng, -24, 0) : 1;
  if (difficulty == Difficulty::violent) speed = ec::power(rng, 0, 14);
  if (difficulty == Difficulty::small_gap && rng.one_in(2)) speed = ec::power(rng, -45, -10);
  const bool hovers = difficulty == Difficulty::hovering;
  const bool rigid = difficulty == Difficulty::rigid;
  const double turn = hovers || rigid ? 0 : rng.one_in(2) ? 1 : rng.one_in(2) ? 0 : ec::power(rng, -20, 0);
  const Vec3 common = ec::random_vector(rng);
  double normal_speed = 0;
  for (std::size_t i = 0; i < corners; ++i) {
    const ec::Element& e = i < first ? a : b;
    const std::size_t k = i < first ? i : i - first;
    at[i] = i < first ? ec::sum(e.corner[k], normal, gap) : e.corner[k];
    at[i] = ec::sum(at[i], away, 1);
    velocity[i] = ec::sum({0, 0, 0}, ec::random_vector(rng), turn * speed);
    if (i < first || rigid) velocity[i] = ec::sum(velocity[i], common, speed);
    normal_speed += (i < first ? 1 : -1) * e.weight[k] * ec::dot(velocity[i], normal);
  }
  double approach = speed * (rng.one_in(2) ? 1 : ec::power(rng, -6, 0));
  if (difficulty == Difficulty::slow) approach = speed * ec::power(rng, -26, -4);
  if (rng.one_in(16) || (difficulty == Difficulty::within && rng.one_in(2))) approach = -approach;
  if (rigid) approach = normal_speed = 0;
  if (hovers) approach = rng.one_in(2) ? 0 : speed * ec::power(rng, -56, -20);
  for (std::size_t i = 0; i < first; ++i) velocity[i] = ec::sum(velocity[i], normal, -approach - normal_speed);
  double t = ec::time_of(difficulty, rng);
  if (difficulty == Difficulty::within && rng.one_in(2)) t = 0;
  if (difficulty == Difficulty::late && rng.one_in(2)) result.t_max = std::min(ec::nudged(t, rng.between(-2, 2)), 1.0);
  for (std::size_t i = 0; i < corners; ++i) {
    query.start[i] = ec::sum(at[i], velocity[i], -t);
    query.end[i] = ec::sum(at[i], velocity[i], 1 - t);
  }
  const bool grid = difficulty == Difficulty::lattice || tied || rng.one_in(10);
  int exponent = 0;
  if (difficulty == Difficulty::extreme) {
    exponent = rng.one_in(3) ? rng.between(-153, -140) : rng.one_in(2) ? rng.between(105, 152) : rng.between(-30, 30);
  }
  const int bits = difficulty == Difficulty::lattice ? rng.between(1, 4) : tied ? rng.between(0, 2) : 12;
  const auto put = [&](double x) {
    return std::ldexp(grid ? std::ldexp(std::rint(std::ldexp(x, bits)), -bits) : x, exponent);
  };
  for (auto* side : {&query.start, &query.end}) {
    for (std::size_t i = 0; i < corners; ++i) {
      Vec3& x = (*side)[i];
      x = {put(x.x), put(x.y), put(x.z)};
    }
  }
  if (difficulty == Difficulty::within) t = 0;
  Separation& separation = result.separation;
  separation.metric = metric;
  if (hovers) {
    const double least =
        std::min(distance(query, 0, separation.metric).value, distance(query, 1, separation.metric).value);
    separation.distance =
        rng.one_in(3) ? ec::nudged(least, -rng.between(0, 40)) : least * (1 - ec::power(rng, -54, -40));
    return result;
  }
  if (difficulty == Difficulty::turning) {
    const double least = ec::least_distance(query, metric);
    separation.distance =
        rng.one_in(2) ? ec::nudged(least, rng.between(-20, 1)) : least * (1 - ec::power(rng, -50, -30));
    return result;
  }
  if (tied) {
    separation.distance = distance(query, 0, metric).value + std::ldexp(rng.between(1, 8), -2);
    return result;
  }
  if (rigid && rng.one_in(4)) query.end = query.start;
  if (rigid && rng.one_in(2)) {
    separation.distance = distance(query, 0, metric).value * (1 + rng.unit());
    return result;
  }
  switch (rng.between(0, 7)) {
    case 0: separation.distance = std::ldexp(gap, exponent); break;
    case 1: separation.distance = distance(query, rng.unit(), metric).value; break;
    case 2:
      separation.distance = distance(query, t, metric).value * (1 + std::ldexp(rng.symmetric(), -rng.between(1, 50)));
      break;
    default: separation.distance = ec::nudged(distance(query, t, metric).value, rng.between(-2, 2));
  }
  if (difficulty == Difficulty::lattice && rng.one_in(2)) separation.distance = std::ldexp(rng.between(1, 20), -3);
  return result;
}

}  // namespace touchstone::tests
