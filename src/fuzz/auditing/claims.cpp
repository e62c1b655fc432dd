// SPDX-License-Identifier: MIT
#include "fuzz/auditing/claims.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <touchstone/solve.hpp>

#include "numbers/doubles/nearest_float.hpp"

namespace touchstone::fuzz {
namespace {

using Coordinates = std::array<double Vec3::*, 3>;
constexpr Coordinates kCoordinates{&Vec3::x, &Vec3::y, &Vec3::z};

// Motions are differences and sums of coordinates of this size or less, so that none of them overflows or is subnormal.
constexpr double kLeast = 0x1p-900, kGreatest = 0x1p900;

std::size_t first_corners(Kind kind) { return kind == Kind::edge_edge ? 2 : 1; }

template <class Visit>
void for_each_number(Query& query, Visit&& visit) {
  for (auto* const corners : {&query.start, &query.end}) {
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
      for (const auto axis : kCoordinates) visit((*corners)[i].*axis);
    }
  }
}

double greatest_number(Query query) {
  double greatest = 0;
  for_each_number(query, [&](double& x) { greatest = std::max(greatest, std::fabs(x)); });
  return greatest;
}

void scale(Query& query, double least, double greatest) {
  double size = greatest_number(query);
  if (size == 0) return;
  int power = 0;
  for (; size < least; size *= 2) ++power;
  for (; size > greatest; size /= 2) --power;
  if (power != 0) for_each_number(query, [&](double& x) { x = std::ldexp(x, power); });
}

/// Each element moves as its first corner does, or not at all.
void move_elements(Query& query, ClaimedMotion motion) {
  const std::size_t first = first_corners(query.kind);
  for (const auto axis : kCoordinates) {
    const double a = query.end[0].*axis - query.start[0].*axis, b = query.end[first].*axis - query.start[first].*axis;
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
      const bool moves = motion == ClaimedMotion::translations || (motion == ClaimedMotion::cast && i < first);
      const double way = i >= first ? b : motion == ClaimedMotion::cast ? a - b : a;
      query.end[i].*axis = query.start[i].*axis + (moves ? way : 0);
    }
  }
}

/// Numbers become multiples of one power of two, with a few bits to spare, so that the motion of every corner of an
/// element is the same number exactly.
void round(Query& query, bool floats) {
  const std::size_t count = corner_count(query.kind), first = first_corners(query.kind);
  std::array<Vec3, 2> motions{};
  double greatest = 0;
  for (const auto axis : kCoordinates) {
    for (std::size_t i = 0; i < count; ++i) {
      if (i == 0 || i == first) motions[i == 0 ? 0 : 1].*axis = query.end[i].*axis - query.start[i].*axis;
      greatest = std::max(greatest, std::fabs(query.start[i].*axis) + std::fabs(motions[i < first ? 0 : 1].*axis));
    }
  }
  if (greatest == 0) return;
  const int bits = floats ? 23 : 51;
  const double unit = std::ldexp(1.0, std::ilogb(greatest) + 1 - bits);
  const auto rounded = [unit](double x) { return std::nearbyint(x / unit) * unit; };
  for (const auto axis : kCoordinates) {
    for (std::size_t i = 0; i < count; ++i) {
      query.start[i].*axis = rounded(query.start[i].*axis);
      query.end[i].*axis = query.start[i].*axis + rounded(motions[i < first ? 0 : 1].*axis);
    }
  }
}

Query nearer(Query query, const Claims& claims) {
  if (claims.in_plane) {
    for (auto* const corners : {&query.start, &query.end}) {
      for (Vec3& corner : *corners) corner.z = 0;
    }
  }
  if (claims.motion == ClaimedMotion::straight) {
    if (claims.floats || claims.greatest < kGreatest || claims.least > 0) scale(query, claims.least, claims.greatest);
    if (claims.floats) {
      for_each_number(query, [](double& x) { x = numbers::nearest_float(x); });
    }
    return query;
  }
  const double least = std::max(claims.least, kLeast), greatest = std::min(claims.greatest, kGreatest);
  scale(query, least, greatest);
  move_elements(query, claims.motion);
  scale(query, least, greatest);  // what moved may have been the greatest, and the rest tiny
  round(query, claims.floats);
  scale(query, least, greatest);
  return query;
}

bool same(const Query& a, const Query& b) {
  const auto equal = [](const Vec3& x, const Vec3& y) { return x.x == y.x && x.y == y.y && x.z == y.z; };
  return std::equal(a.start.begin(), a.start.end(), b.start.begin(), equal) &&
         std::equal(a.end.begin(), a.end.end(), b.end.begin(), equal);
}

double distance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

/// The least height of a triangle; 0 for one without an area.
double least_height(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
  if (longest == 0) return 0;
  const auto from_a = [&](const Vec3& p) {  // in units of the longest side, so that no product overflows
    return Vec3{(p.x - a.x) / longest, (p.y - a.y) / longest, (p.z - a.z) / longest};
  };
  const Vec3 u = from_a(b), w = from_a(c);
  return longest * std::hypot(u.y * w.z - u.z * w.y, u.z * w.x - u.x * w.z, u.x * w.y - u.y * w.x);
}

/// The least length of the query's edges and height of its face; infinite where it has neither.
double least_element(Kind kind, const std::array<Vec3, 4>& c) {
  switch (kind) {
    case Kind::edge_edge: return std::min(distance(c[0], c[1]), distance(c[2], c[3]));
    case Kind::vertex_face: return least_height(c[1], c[2], c[3]);
    case Kind::point_edge: return distance(c[1], c[2]);
    case Kind::point_point: break;
  }
  return std::numeric_limits<double>::infinity();
}

double extent(const Query& query) {
  double extent = 0;
  for (const auto* const corners : {&query.start, &query.end}) {
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
      extent = std::max(extent, distance((*corners)[i], query.start[0]));
    }
  }
  return extent;
}

bool moves(const Query& query) {
  constexpr double kLeastMotion = 0.001;  // as a part of the extent
  const std::size_t b = first_corners(query.kind);
  const Vec3 &a0 = query.start[0], &a1 = query.end[0], &b0 = query.start[b], &b1 = query.end[b];
  const double motion =
      std::hypot((a1.x - a0.x) - (b1.x - b0.x), (a1.y - a0.y) - (b1.y - b0.y), (a1.z - a0.z) - (b1.z - b0.z));
  return motion > kLeastMotion * extent(query);
}

}  // namespace

Query nearest_claimed(const Query& query, const Claims& claims) {
  // A sum may round to the next power of two, and then the unit of rounding doubles once more.
  constexpr int kRounds = 8;
  Query nearest = nearer(query, claims);
  for (int i = 0; i < kRounds; ++i) {
    const Query next = nearer(nearest, claims);
    if (same(next, nearest)) break;
    nearest = next;
  }
  return nearest;
}

bool is_claimed(const Query& nearest, const Claims& claims, const Separation& separation) {
  if (claims.least_element > 0) {
    const double least = claims.least_element * extent(nearest);
    if (least_element(nearest.kind, nearest.start) <= least) return false;
    if (least_element(nearest.kind, nearest.end) <= least) return false;
  }
  const bool whole = claims.motion == ClaimedMotion::translations || claims.motion == ClaimedMotion::cast;
  if (whole && !moves(nearest)) return false;
  if (!claims.starts_apart) return true;
  Query at_start = nearest;
  at_start.end = at_start.start;
  return !solve(at_start, {.separation = separation}).contact;
}

}  // namespace touchstone::fuzz
