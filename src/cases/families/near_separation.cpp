// Queries with a distance of their own: at a known dyadic time the elements are exactly as far apart, or one ulp more
// or less. Lattice vectors of integer length make it exact.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "families/curved_parts.hpp"
#include "families/makers.hpp"

namespace touchstone::families::makers {
namespace {

constexpr double kGreatest = std::numeric_limits<double>::max();
constexpr double kLeast = std::numeric_limits<double>::denorm_min();

double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double largest_of(const Vec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }
bool is_zero(const Vec3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// The length in the metric, rounded to the nearest double where the squares are exact.
double length_of(const Vec3& v, Metric metric) {
  return metric == Metric::euclidean ? std::sqrt(dot(v, v)) : largest_of(v);
}

double beside(double distance, int ulps) {
  const double towards = ulps < 0 ? 0 : kGreatest;
  for (int i = std::abs(ulps); i > 0; --i) distance = std::nextafter(distance, towards);
  return distance;
}

/// An integer vector of integer length, its axes permuted and reflected.
Vec3 pythagorean(Rng& rng) {
  static constexpr std::array<Vec3, 9> vectors{
      {{0, 0, 1}, {0, 0, 2}, {0, 0, 3}, {3, 4, 0}, {1, 2, 2}, {2, 3, 6}, {1, 4, 8}, {4, 4, 7}, {2, 4, 4}}};
  Vec3 v = rng.pick(vectors);
  if (rng.one_in(2)) std::swap(v.x, v.y);
  if (rng.one_in(2)) std::swap(v.y, v.z);
  if (rng.one_in(2)) std::swap(v.x, v.z);
  for (std::size_t k = 0; k < 3; ++k) {
    if (rng.one_in(2)) coordinate(v, k) = 0 - coordinate(v, k);
  }
  return v;
}

/// A small integer vector that is perpendicular to n, and not zero.
Vec3 across(const Vec3& n, Rng& rng) {
  for (;;) {
    const Vec3 v = cross(n, lattice_point(rng, 1));
    if (!is_zero(v)) return v;
  }
}

/// Where the closest point is in its element.
enum class Foot { inside, border, anywhere };

/// An element's corners relative to its closest point, and the weights of that point.
struct Element {
  std::array<Vec3, 3> offset{};
  std::array<double, 3> weight{};
};

/// No point of the element is nearer to the plane through the closest point, across `away`, on the other side of it:
/// corners with a weight lie in that plane, and others in it or beyond.
/// @param line  null, or a vector that all of the offsets within the plane are multiples of
Element element(std::size_t corners, const Vec3& away, Foot foot, const Vec3* line, Rng& rng) {
  const auto offset = [&]() -> Vec3 {
    if (line == nullptr) return across(away, rng);
    const double factor = rng.between(1, 3);
    return (rng.one_in(2) ? factor : -factor) * *line;
  };
  const auto beyond = [&]() -> Vec3 {
    const double tilt = rng.one_in(2) ? 0 : rng.between(1, 4) / 4.0;
    return offset() + tilt * away;
  };
  Element e;
  e.weight[0] = 1;
  const bool inside = foot == Foot::inside || (foot == Foot::anywhere && rng.one_in(2));
  if (corners > 1 && (inside || (corners == 3 && rng.one_in(2)))) {  // inside the element or, of a face, an edge
    e.weight[1] = rng.between(1, 7) / 8.0;
    e.weight[0] = 1 - e.weight[1];
    const Vec3 along = offset();
    e.offset[0] = -e.weight[1] * along;
    e.offset[1] = e.weight[0] * along;
    if (corners == 3 && inside) {
      const Vec3 other = offset();  // from the point on the edge to the third corner, whose weight becomes 1/4
      for (std::size_t i = 0; i < 2; ++i) {
        e.offset[i] = e.offset[i] - 0.25 * other;
        e.weight[i] *= 0.75;
      }
      e.offset[2] = 0.75 * other;
      e.weight[2] = 0.25;
    } else if (corners == 3) {
      e.offset[2] = beyond();
    }
  } else {
    for (std::size_t i = 1; i < corners; ++i) e.offset[i] = beyond();
  }
  const int turn = rng.between(0, static_cast<int>(corners) - 1);
  std::rotate(e.offset.begin(), e.offset.begin() + turn, e.offset.begin() + static_cast<std::ptrdiff_t>(corners));
  std::rotate(e.weight.begin(), e.weight.begin() + turn, e.weight.begin() + static_cast<std::ptrdiff_t>(corners));
  return e;
}

/// The elements at one time, at which their closest points are n apart.
struct Placed {
  Kind kind;
  Vec3 n;
  Vec3 line;                     ///< of the offsets, if they are to be parallel, or along one of them
  std::array<Vec3, 4> offset{};  ///< of each corner from its element's closest point
};

Placed placed(Kind kind, const Vec3& n, Foot foot, bool parallel, Rng& rng) {
  Placed p{kind, n, across(n, rng), {}};
  const ElementSizes sizes = element_sizes(kind);
  const Vec3* const line = parallel ? &p.line : nullptr;
  const Element a = element(sizes.a, -1 * n, foot, line, rng);
  const Element b = element(sizes.b, n, foot == Foot::border && rng.one_in(2) ? Foot::anywhere : foot, line, rng);
  for (std::size_t i = 0; i < sizes.a; ++i) p.offset[i] = a.offset[i];
  for (std::size_t i = 0; i < sizes.b; ++i) p.offset[sizes.a + i] = b.offset[i];
  return p;
}

/// The velocities of the corners. `tangent` keeps the distance of the closest points to first order, `level` keeps
/// both elements' closest features in their planes across n, and `common` keeps everything.
enum class Course { any, approaching, leaving, tangent, level, sliding, common };

Query moving(const Placed& p, double time, Course course, Rng& rng) {
  const std::size_t first_of_b = element_sizes(p.kind).a;
  const Vec3 position = lattice_point(rng, 2);
  const Vec3 common = lattice_point(rng, 2);
  const Vec3 turn = lattice_point(rng, 2);
  const double speed = rng.between(1, 4);
  std::array<Moving, 4> corners{};
  for (std::size_t i = 0; i < corner_count(p.kind); ++i) {
    const bool in_b = i >= first_of_b;
    Vec3 velocity = common;
    switch (course) {
      case Course::any: velocity = lattice_point(rng, 4); break;
      case Course::approaching: velocity = velocity - (in_b ? speed : 0) * p.n; break;
      case Course::leaving: velocity = velocity + (in_b ? speed : 0) * p.n; break;
      case Course::tangent: {
        const Vec3 level = cross(p.n, lattice_point(rng, 2));
        velocity = velocity + level + dot(turn, p.offset[i]) / 64 * p.n;
        break;
      }
      case Course::level: velocity = velocity + cross(p.n, lattice_point(rng, 2)); break;
      case Course::sliding: velocity = velocity + (in_b ? speed : 0) * p.line; break;
      case Course::common: break;
    }
    const Vec3 at = position + (in_b ? p.n : Vec3{}) + p.offset[i];
    const Vec3 start = at - time * velocity;
    corners[i] = {start, start + velocity};
  }
  return query_of(p.kind, corners);
}

double some_time(Rng& rng) {
  static constexpr std::array<double, 4> ends{0, 1, 0.5, 0.5};
  return rng.one_in(4) ? rng.pick(ends) : dyadic_time(rng);
}

/// At `time` the elements are exactly as far apart as n is long in the Euclidean metric, and at most that in the other.
Separated separated(const Placed& p, Metric metric, double time, Course course, Rng& rng) {
  const Query query = moving(p, time, course, rng);
  const double unit = std::ldexp(1.0, -rng.between(0, 4));
  return {mapped_corners(query, [unit](const Vec3& corner) { return unit * corner; }), unit * length_of(p.n, metric),
          time};
}

Separated one_ulp_beside(Separated s, Rng& rng) {
  const int ulps = rng.between(1, 2);
  if (rng.one_in(2)) {
    s.distance = beside(s.distance, ulps);  // still within at that time
    return s;
  }
  s.distance = beside(s.distance, -ulps);
  s.within_at.reset();
  return s;
}

Separated scaled(Separated s, int exponent) {
  const double distance = std::ldexp(s.distance, exponent);
  bool exact = std::ldexp(distance, -exponent) == s.distance;
  for_each_coordinate(s.query, [&](double& x) {
    const double before = x;
    x = std::ldexp(x, exponent);
    exact = exact && std::ldexp(x, -exponent) == before;
  });
  s.distance = std::min(distance, kGreatest);
  if (!exact) s.within_at.reset();
  return s;
}

/// A query of ordinary magnitude with its distance.
Separated ordinary(Kind kind, Metric metric, Rng& rng) {
  static constexpr std::array<Family, 9> bases{Family::gap_crossing, Family::gap_tangent,    Family::gap_constant,
                                               Family::gap_border,   Family::gap_parallel,   Family::gap_turning,
                                               Family::gap_start,    Family::gap_irrational, Family::gap_lattice};
  return make_separated(rng.pick(bases), kind, metric, rng);
}

}  // namespace

Separated gap_crossing(Kind kind, Metric metric, Rng& rng) {
  const Placed p = placed(kind, pythagorean(rng), Foot::anywhere, false, rng);
  const double time = some_time(rng);
  return separated(p, metric, time, rng.one_in(2) ? Course::any : Course::approaching, rng);
}

Separated gap_tangent(Kind kind, Metric metric, Rng& rng) {
  const Placed p = placed(kind, pythagorean(rng), Foot::anywhere, false, rng);
  return separated(p, metric, some_time(rng), Course::tangent, rng);
}

Separated gap_constant(Kind kind, Metric metric, Rng& rng) {
  const bool parallel = rng.one_in(4);
  const Placed p = placed(kind, pythagorean(rng), Foot::anywhere, parallel, rng);
  const Course course = rng.one_in(3) ? Course::common : Course::level;
  return separated(p, metric, some_time(rng), course, rng);
}

Separated gap_border(Kind kind, Metric metric, Rng& rng) {
  Placed p = placed(kind, pythagorean(rng), Foot::border, false, rng);
  static constexpr std::array<Course, 5> courses{Course::level, Course::level, Course::any, Course::tangent,
                                                 Course::approaching};
  const double time = some_time(rng);
  return separated(p, metric, time, rng.pick(courses), rng);
}

Separated gap_parallel(Kind kind, Metric metric, Rng& rng) {
  const Placed p = placed(kind, pythagorean(rng), Foot::anywhere, true, rng);
  static constexpr std::array<Course, 4> courses{Course::sliding, Course::sliding, Course::approaching, Course::common};
  const double time = some_time(rng);
  return separated(p, metric, time, rng.pick(courses), rng);
}

Separated gap_turning(Kind kind, Metric metric, Rng& rng) {
  const Placed p = placed(kind, pythagorean(rng), Foot::anywhere, true, rng);
  static constexpr std::array<Course, 3> courses{Course::any, Course::tangent, Course::level};
  const double time = some_time(rng);
  return separated(p, metric, time, rng.pick(courses), rng);
}

Separated gap_irrational(Kind kind, Metric metric, Rng& rng) {
  Vec3 n = lattice_point(rng, 3);
  while (is_zero(n)) n = lattice_point(rng, 3);
  const bool parallel = rng.one_in(3);
  const Placed p = placed(kind, n, Foot::anywhere, parallel, rng);
  static constexpr std::array<Course, 4> courses{Course::any, Course::approaching, Course::tangent, Course::level};
  const double time = some_time(rng);
  Separated s = separated(p, metric, time, rng.pick(courses), rng);
  s.distance = beside(s.distance, rng.between(-1, 1));
  s.within_at.reset();  // the nearest double may be less than the distance
  return s;
}

Separated gap_start(Kind kind, Metric metric, Rng& rng) {
  const Vec3 n = rng.one_in(8) ? Vec3{} : pythagorean(rng);
  const bool parallel = rng.one_in(4);
  const Placed p = is_zero(n) ? Placed{kind, n, {1, 0, 0}, {}} : placed(kind, n, Foot::anywhere, parallel, rng);
  static constexpr std::array<Course, 6> courses{Course::any,     Course::approaching, Course::leaving,
                                                 Course::tangent, Course::level,       Course::common};
  static constexpr std::array<double, 4> factors{1, 1, 1.125, 2};
  const Course course = rng.pick(courses);
  Separated s = separated(p, metric, 0, course, rng);
  s.distance = is_zero(n) ? 1 : s.distance * rng.pick(factors);
  return s;
}

Separated gap_ulp(Kind kind, Metric metric, Rng& rng) {
  Separated s = ordinary(kind, metric, rng);
  if (!rng.one_in(3)) return one_ulp_beside(s, rng);
  auto& corners = rng.one_in(2) ? s.query.start : s.query.end;
  const auto corner = static_cast<std::size_t>(rng.between(0, static_cast<int>(corner_count(kind)) - 1));
  double& x = coordinate(corners[corner], static_cast<std::size_t>(rng.between(0, 2)));
  x = std::nextafter(x, rng.one_in(2) ? kGreatest : -kGreatest);
  s.within_at.reset();
  return s;
}

Separated gap_lattice(Kind kind, Metric metric, Rng& rng) {
  Separated s{lattice(kind, rng, rng.between(1, 4)), 0, {}};
  const double square = rng.between(1, 36);
  s.distance = metric == Metric::euclidean ? std::sqrt(square) : square;
  s.distance = std::ldexp(s.distance, -rng.between(0, 3));
  if (rng.one_in(4)) s.distance = beside(s.distance, rng.one_in(2) ? 1 : -1);
  return s;
}

Separated gap_scale(Kind kind, Metric metric, Rng& rng) {
  Separated s = ordinary(kind, metric, rng);
  if (rng.one_in(4)) s = one_ulp_beside(s, rng);
  // Half of the time near the limits of the filters: of squares, of products of five factors, of V against d |n|.
  static constexpr std::array<int, 10> telling{-537, -450, -400, -300, -200, -150, 133, 150, 200, 333};
  if (rng.one_in(2)) return scaled(s, rng.between(-1070, 1000));
  const int centre = rng.pick(telling);
  return scaled(s, centre + rng.between(-20, 20));
}

Separated gap_extreme(Kind kind, Metric metric, Rng& rng) {
  static constexpr std::array<Family, 5> others{Family::huge, Family::subnormal, Family::mixed_scale,
                                                Family::corner_scale, Family::axis_scale};
  Separated s;
  if (rng.one_in(2)) {
    s = ordinary(kind, metric, rng);
  } else {
    s.query = make(rng.pick(others), kind, rng);
  }
  s.within_at.reset();
  double largest = 0;
  for_each_coordinate(s.query, [&](double& x) { largest = std::max(largest, std::fabs(x)); });
  switch (rng.between(0, 5)) {
    case 0: s.distance = kLeast * rng.between(1, 3); break;
    case 1: s.distance = beside(0x1p-1022, rng.between(-1, 1)); break;
    case 2: s.distance = rng.one_in(2) ? kGreatest : beside(0x1p1023, -rng.between(0, 1)); break;
    case 3: s.distance = std::ldexp(largest, -rng.between(30, 60)); break;
    case 4: {
      const int exponent = rng.between(-1074, 1022);
      s.distance = std::ldexp(1 + rng.unit(), exponent);
      break;
    }
    default: s.distance = std::min(largest * rng.unit(), kGreatest); break;
  }
  s.distance = std::max(s.distance, kLeast);
  return s;
}

namespace {

/// @param largest  the query's largest coordinate
/// @param gap  gap(corner) draws a time, and is the vector there from the first corner to this one of the other element
template <typename Gap>
double distance_of_size(Kind kind, Metric metric, double largest, Rng& rng, Gap&& gap) {
  const std::size_t first_of_b = element_sizes(kind).a;
  const auto corner_of_b =
      static_cast<std::size_t>(rng.between(static_cast<int>(first_of_b), static_cast<int>(corner_count(kind)) - 1));
  double distance = 0;
  switch (rng.between(0, 4)) {
    case 0: distance = std::ldexp(rng.between(1, 8), -2); break;
    case 1: distance = largest * rng.unit() * 0.5; break;
    case 2: distance = std::ldexp(largest, -rng.between(1, 60)); break;
    default: {  // that of two corners at one time, or a fraction of it
      distance = length_of(gap(corner_of_b), metric);
      if (rng.one_in(3)) distance *= rng.unit();
      break;
    }
  }
  return distance > 0 && distance <= kGreatest ? distance : 1;
}

}  // namespace

double drawn_distance(const Query& query, Metric metric, Rng& rng) {
  double largest = 0;
  Query copy = query;
  for_each_coordinate(copy, [&](double& x) { largest = std::max(largest, std::fabs(x)); });
  return distance_of_size(query.kind, metric, largest, rng, [&](std::size_t corner) {
    const auto& corners = rng.one_in(2) ? query.start : query.end;
    return corners[corner] - corners[0];
  });
}

double drawn_distance(const CurvedQuery& query, Metric metric, Rng& rng) {
  double largest = 0;
  CurvedQuery copy = query;
  for_each_length(copy, [&](double& x) { largest = std::max(largest, std::fabs(x)); });
  return distance_of_size(query.kind, metric, largest, rng, [&](std::size_t corner) {
    static constexpr std::array<double, 3> round{0, 0.5, 1};
    const double t = rng.one_in(4) ? rng.unit() : rng.pick(round);
    return position(query, corner, t) - position(query, 0, t);
  });
}

}  // namespace touchstone::families::makers
