// A corner of a body that turns is at P(t) / W(t), both of degree 3 in the Bernstein basis, with coefficients P_i and
// W_i. Where all W_i > 0, this is a convex combination of the points P_i / W_i with the weights B_i(t) W_i / W(t): the
// corner stays in their convex hull (Farin, "Curves and surfaces for CAGD", chapter on rational curves).
// SPDX-License-Identifier: MIT
#include "filters/curved/curved_paths.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "filters/step_frame.hpp"
#include "geometry/frame.hpp"
#include "geometry/kind_traits.hpp"

namespace touchstone::filters {
namespace {

using Point = geometry::Vector<double>;
using Quaternion = std::array<double, 4>;

// Bounds, with e = 2^-53; q is scaled by a power of two so that its largest component m at both ends is in [1/2, 1).
// Let L be the largest coordinate of body points plus the largest of positions, which are those relative to the moving
// origin: a difference of two doubles, with one rounding.
// - An entry of the bilinear rotation matrix sums 4 products, below 4 m^2 in all. A coordinate of M(a, b) X sums 3
//   entries times coordinates, below 12 m^2 L, with at most 7 roundings of each product.
// - A weight a . b sums 4 products, below 4 m^2, with at most 4 roundings of each.
// - A numerator sums at most M + 2 M' + 2 w p + w' p', below 48 m^2 L, with at most 7 + 3 roundings of each product: it
//   is off by at most 490 e m^2 L. A denominator w + 2 w' is below 12 m^2, and off by at most 5.1 * 12 e m^2, below
//   62 e m^2.
// - The denominator is required to be at least m^2 / 8. So with C the quotient as computed, it is off by at most
//   8.1 (490 e L + 62 e |C|) + 2.1 e |C| < 3970 e L + 510 e |C|, with two roundings of the quotient.
// 2^12 e = 4096 e times (L + |C|) leaves room for second-order terms and the rounding of the bound. What underflows is
// off by less than 100 * 2^-1074, times at most 8.1, and does not count for an L of at least kLeastLength. Nothing
// overflows for one of at most kMostLength.
constexpr double kPathBound = 0x1p12 * 0x1p-53;
constexpr double kLeastLength = 0x1p-900;
constexpr double kMostLength = 0x1p900;
constexpr double kLeastWeight = 0.125;

// Let D be the largest coordinate of a direction and C that of the points. A projection sums 3 products with at most 3
// roundings each: it is off by at most 9.1 e D C, and by 3 D times the points' error. The difference of two of them is
// off by twice this and e 6.1 D C: less than 6 D error + 25 e D C. The rest is for the rounding of the bound.
constexpr double kErrorFactor = 7;
constexpr double kMostSum = 4;  // of a direction's coordinates, none of which is larger than 1
constexpr double kProjectionBound = 32 * 0x1p-53;

// Points within a distance d of each other differ by at most |n| d along a direction n, and in the metric max by at
// most (|n_x| + |n_y| + |n_z|) d. At most 3 roundings of the length, 2 of the products and 1 of the sum with the bounds
// above follow: less than 8 e in all. Directions have a coordinate 1, and what underflows in a product with d is less
// than the room that the bounds above leave.
constexpr double kReachBound = 1 + 8 * 0x1p-53;

double largest_of(const Point& x) noexcept { return std::max({std::fabs(x[0]), std::fabs(x[1]), std::fabs(x[2])}); }

Point point_of(const Vec3& x) noexcept { return {{x.x, x.y, x.z}}; }

double dot(const Quaternion& a, const Quaternion& b) noexcept {
  return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]);
}

using Matrix = std::array<Point, 3>;  // of rows

/// M(a, b), the bilinear form of which M(q) = M(q, q) is the quadratic one.
Matrix bilinear(const Quaternion& a, const Quaternion& b) noexcept {
  const double ww = a[0] * b[0], xx = a[1] * b[1], yy = a[2] * b[2], zz = a[3] * b[3];
  const auto mixed = [&](std::size_t i, std::size_t j) { return a[i] * b[j] + a[j] * b[i]; };
  const double xy = mixed(1, 2), xz = mixed(1, 3), yz = mixed(2, 3);
  const double wx = mixed(0, 1), wy = mixed(0, 2), wz = mixed(0, 3);
  return {{{{(ww + xx) - (yy + zz), xy - wz, xz + wy}},
           {{xy + wz, (ww + yy) - (xx + zz), yz - wx}},
           {{xz - wy, yz + wx, (ww + zz) - (xx + yy)}}}};
}

Point product(const Matrix& m, const Point& x) noexcept {
  return {{geometry::dot(m[0], x), geometry::dot(m[1], x), geometry::dot(m[2], x)}};
}

/// Scales both quaternions by one power of two, so that the largest component is in [1/2, 1).
void scale(Quaternion& q0, Quaternion& q1) noexcept {
  double largest = 0;
  for (std::size_t i = 0; i < 4; ++i) largest = std::max({largest, std::fabs(q0[i]), std::fabs(q1[i])});
  if (largest >= 0.5 && largest < 1) return;
  int exponent = 0;
  std::frexp(largest, &exponent);
  constexpr int kOrdinary = 1000;
  if (std::abs(exponent) < kOrdinary) {
    const double factor = std::ldexp(1.0, -exponent);
    for (std::size_t i = 0; i < 4; ++i) {
      q0[i] *= factor;
      q1[i] *= factor;
    }
    return;
  }
  for (double& c : q0) c = std::ldexp(c, -exponent);
  for (double& c : q1) c = std::ldexp(c, -exponent);
}

/// A bound of what points within a separation differ by along a direction whose largest coordinate is 1.
double reach(const Point& direction, const Separation& separation) noexcept {
  if (separation.distance == 0) return 0;
  const double sum = std::fabs(direction[0]) + std::fabs(direction[1]) + std::fabs(direction[2]);
  const double length = separation.metric == Metric::max ? sum : std::sqrt(geometry::dot(direction, direction));
  return kReachBound * (length * separation.distance);
}

/// What the paths of all points of a body need.
struct Turn {
  bool known = false;           ///< the weights are certainly positive and far from 0
  Matrix m0, m1, m2;            ///< M(q0, q0), M(q0, q1), M(q1, q1)
  std::array<Point, 4> origin;  ///< of the body, times the weights
  std::array<double, 4> per_weight;
};

void make_turn(const RigidMotion& motion, const Point& p0, const Point& p1, Turn& turn) noexcept {
  turn.known = false;
  Quaternion q0 = motion.q0, q1 = motion.q1;
  scale(q0, q1);
  const double w0 = dot(q0, q0), w1 = dot(q0, q1), w2 = dot(q1, q1);
  const double weights[4] = {w0, w0 + 2 * w1, 2 * w1 + w2, w2};
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(weights[i] >= kLeastWeight)) return;
    turn.per_weight[i] = 1 / weights[i];
  }
  turn.m0 = bilinear(q0, q0);
  turn.m1 = bilinear(q0, q1);
  turn.m2 = bilinear(q1, q1);
  for (std::size_t k = 0; k < 3; ++k) {
    turn.origin[0][k] = w0 * p0[k];
    turn.origin[1][k] = 2 * w1 * p0[k] + w0 * p1[k];
    turn.origin[2][k] = w2 * p0[k] + 2 * w1 * p1[k];
    turn.origin[3][k] = w2 * p1[k];
  }
  turn.known = true;
}

void follow(const Turn& turn, const Vec3& body_point, CurvedPaths::Path& path) noexcept {
  const Point x = point_of(body_point);
  const Point n0 = product(turn.m0, x), n1 = product(turn.m1, x), n2 = product(turn.m2, x);
  for (std::size_t k = 0; k < 3; ++k) {
    path.points[0][k] = (n0[k] + turn.origin[0][k]) * turn.per_weight[0];
    path.points[1][k] = ((n0[k] + 2 * n1[k]) + turn.origin[1][k]) * turn.per_weight[1];
    path.points[2][k] = ((2 * n1[k] + n2[k]) + turn.origin[2][k]) * turn.per_weight[2];
    path.points[3][k] = (n2[k] + turn.origin[3][k]) * turn.per_weight[3];
  }
  path.count = 4;
}

/// A curve of one point at least, relative to the moving origin; that is a curve with the points from + (i / n) (to -
/// from), for any degree n >= 1. Off by a few e times the sum of the coordinates: far less than kPathBound counts.
void follow(const CurvedCorner& corner, const Point& from, const Point& to, CurvedPaths::Path& path) noexcept {
  const std::size_t last = static_cast<std::size_t>(corner.control_points) - 1, degree = std::max<std::size_t>(last, 1);
  path.count = degree + 1;
  for (std::size_t i = 0; i <= degree; ++i) {
    const Point x = point_of(corner.points[std::min(i, last)]);
    const double fraction = static_cast<double>(i) / static_cast<double>(degree);
    for (std::size_t k = 0; k < 3; ++k) path.points[i][k] = x[k] - ((1 - fraction) * from[k] + fraction * to[k]);
  }
}

/// The points of both elements.
struct Hulls {
  std::array<Point, 16> points;
  std::size_t first = 0;  // so many of the first element, and the others after them
  std::size_t count = 0;
};

/// The points of each element that are nearest to the other one along a direction from the first to the second.
struct Nearest {
  std::size_t a = 0, b = 0;
  double gap = 0;  // of no meaning for a direction that is not finite
};

Nearest nearest_along(const Hulls& hulls, const Point& direction) noexcept {
  Nearest nearest;
  double most = -std::numeric_limits<double>::infinity(), least = -most;
  for (std::size_t i = 0; i < hulls.count; ++i) {
    const double projection = geometry::dot(direction, hulls.points[i]);
    if (i < hulls.first && projection > most) {
      most = projection;
      nearest.a = i;
    }
    if (i >= hulls.first && projection < least) {
      least = projection;
      nearest.b = i;
    }
  }
  nearest.gap = least - most;
  return nearest;
}

}  // namespace

CurvedPaths curved_paths(const CurvedQuery& query) noexcept {
  CurvedPaths paths;
  const std::size_t count = corner_count(query.kind);
  const auto on_body = [&](std::size_t i) { return query.corners[i].motion != CurvedCorner::kOnCurve; };
  std::size_t leader = 0;  // the first corner of a body, or the first of all
  while (leader < count && !on_body(leader)) ++leader;
  if (leader < count) {
    const RigidMotion& motion = query.motions[static_cast<std::size_t>(query.corners[leader].motion)];
    paths.from = motion.p0;
    paths.to = motion.p1;
  } else {
    paths.from = query.corners[0].points[0];
    paths.to = query.corners[0].points[static_cast<std::size_t>(query.corners[0].control_points) - 1];
  }
  const Point from = point_of(paths.from), to = point_of(paths.to);
  double points = 0, positions = 0;
  std::array<Turn, 4> turns;
  std::array<bool, 4> seen{};
  for (std::size_t i = 0; i < count; ++i) {
    const CurvedCorner& corner = query.corners[i];
    CurvedPaths::Path& path = paths.corners[i];
    if (on_body(i)) {
      const std::size_t m = static_cast<std::size_t>(corner.motion);
      points = std::max(points, largest_of(point_of(corner.points[0])));
      if (!seen[m]) {
        seen[m] = true;
        const RigidMotion& motion = query.motions[m];
        const Point p0 = point_of(motion.p0) - from, p1 = point_of(motion.p1) - to;
        positions = std::max({positions, largest_of(p0), largest_of(p1)});
        make_turn(motion, p0, p1, turns[m]);
      }
      if (!(points + positions <= kMostLength) || !turns[m].known) return paths;
      follow(turns[m], corner.points[0], path);
    } else {
      follow(corner, from, to, path);
      paths.size = std::max({paths.size, largest_of(from), largest_of(to)});
      for (std::size_t k = 0; k < path.count; ++k) {
        const auto point = std::min(k, static_cast<std::size_t>(corner.control_points) - 1);
        paths.size = std::max(paths.size, largest_of(point_of(corner.points[point])));
      }
    }
    for (std::size_t k = 0; k < path.count; ++k) paths.size = std::max(paths.size, largest_of(path.points[k]));
  }
  const double length = points + positions;
  paths.size = std::max(paths.size, length);
  paths.known = paths.size >= kLeastLength && paths.size <= kMostLength;
  paths.error = kPathBound * (2 * paths.size);
  return paths;
}

bool certainly_apart(const CurvedQuery& query) noexcept { return certainly_farther(query, Separation()); }

bool certainly_farther(const CurvedQuery& query, const Separation& separation) noexcept {
  const CurvedPaths paths = curved_paths(query);
  if (!paths.known) return false;
  Hulls hulls;
  const std::size_t first = geometry::corners_of_first(query.kind);
  Point middle[2] = {};
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const CurvedPaths::Path& path = paths.corners[i];
    for (std::size_t k = 0; k < path.count; ++k) {
      hulls.points[hulls.count++] = path.points[k];
      for (std::size_t axis = 0; axis < 3; ++axis) middle[i < first ? 0 : 1][axis] += path.points[k][axis];
    }
    if (i + 1 == first) hulls.first = hulls.count;
  }
  const auto separates = [&](const Point& direction, double gap) {
    // A direction that overflowed has no projections: every comparison with them is false.
    const double sum = std::fabs(direction[0]) + std::fabs(direction[1]) + std::fabs(direction[2]);
    if (!(sum <= kMostSum)) return false;
    const double largest = largest_of(direction);
    const double product = largest * paths.size;
    if (!(product >= kLeastLength && product <= kMostLength)) return false;
    return gap > kErrorFactor * (largest * paths.error) + kProjectionBound * product + reach(direction, separation);
  };
  // Along the axes, of which the projections are the coordinates.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low[2], high[2];
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t begin = side == 0 ? 0 : hulls.first, end = side == 0 ? hulls.first : hulls.count;
      low[side] = high[side] = hulls.points[begin][axis];
      for (std::size_t i = begin + 1; i < end; ++i) {
        low[side] = std::min(low[side], hulls.points[i][axis]);
        high[side] = std::max(high[side], hulls.points[i][axis]);
      }
    }
    Point direction = {};
    direction[axis] = 1;
    if (separates(direction, std::max(low[1] - high[0], low[0] - high[1]))) return true;
  }
  // Along n at about half the time: between edges or a vertex and a face that are near each other.
  if (has_cubic(query.kind)) {
    std::array<Point, 4> at;
    for (std::size_t i = 0; i < 4; ++i) {
      const CurvedPaths::Path& path = paths.corners[i];
      at[i] = path.points[0];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double sum = 0;
        for (std::size_t k = 0; k < path.count; ++k) sum += path.points[k][axis];
        at[i][axis] = sum / static_cast<double>(path.count);
      }
    }
    Point n =
        geometry::normal(geometry::frame_of(query.kind, [&](std::size_t i, std::size_t j) { return at[i] - at[j]; }));
    const double largest = largest_of(n);
    if (largest > 0) {
      const double sign = geometry::dot(n, at[first] - at[0]) < 0 ? -1 : 1;
      for (std::size_t k = 0; k < 3; ++k) n[k] *= sign / largest;
      if (separates(n, nearest_along(hulls, n).gap)) return true;
    }
  }
  // From the line between the middles, the direction is mirrored until it separates (Chung and Wang, "Quick collision
  // detection of polytopes in virtual environments", 1996). It is a hint: each one is tested.
  Point direction;
  const double second_count = static_cast<double>(hulls.count - hulls.first),
               first_count = static_cast<double>(hulls.first);
  for (std::size_t k = 0; k < 3; ++k) direction[k] = middle[1][k] / second_count - middle[0][k] / first_count;
  constexpr int kMirrorings = 12;
  for (int i = 0; i < kMirrorings; ++i) {
    const double largest = largest_of(direction);
    if (!(largest > 0)) return false;
    for (std::size_t k = 0; k < 3; ++k) direction[k] /= largest;
    const Nearest nearest = nearest_along(hulls, direction);
    if (separates(direction, nearest.gap)) return true;
    const Point between = hulls.points[nearest.b] - hulls.points[nearest.a];
    const double length = largest_of(between);
    if (!(length > 0)) return false;
    const Point unit = {{between[0] / length, between[1] / length, between[2] / length}};
    const double factor = 2 * geometry::dot(unit, direction) / geometry::dot(unit, unit);
    for (std::size_t k = 0; k < 3; ++k) direction[k] -= factor * unit[k];
  }
  return false;
}

}  // namespace touchstone::filters
