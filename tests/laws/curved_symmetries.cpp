// Maps of space, and other ways to write the same motion, that keep every answer to a curved query: mirrors and
// permuted axes, quarter turns, powers of two, translations, a common velocity, quaternions of another length or sign,
// and curves of a higher degree.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include "laws/curved_law.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 71;

/// A map that permutes the axes and changes signs: coordinate k of the image is sign[k] times coordinate from[k].
struct AxisMap {
  std::array<std::size_t, 3> from{0, 1, 2};
  std::array<double, 3> sign{1, 1, 1};

  Vec3 operator()(const Vec3& v) const {
    Vec3 image;
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3 source = v;
      coordinate(image, k) = sign[k] * coordinate(source, from[k]);
    }
    return image;
  }

  /// -1 for a map that mirrors.
  double determinant() const {
    const bool even = (from[0] + 1) % 3 == from[1] && (from[1] + 1) % 3 == from[2];
    return (even ? 1 : -1) * sign[0] * sign[1] * sign[2];
  }
};

AxisMap any_axis_map(Rng& rng) {
  static constexpr std::array<std::array<std::size_t, 3>, 6> kOrders{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}};
  AxisMap map;
  map.from = rng.pick(kOrders);
  for (double& sign : map.sign) sign = rng.one_in(2) ? -1 : 1;
  return map;
}

/// All of space mapped. A turn about an axis becomes the turn about its image, the other way round in a mirror.
CurvedQuery mapped(CurvedQuery query, const AxisMap& map) {
  for (CurvedCorner& corner : query.corners) {
    for (Vec3& point : corner.points) point = map(point);
  }
  const double direction = map.determinant();
  for (RigidMotion& motion : query.motions) {
    for (Quaternion* const q : {&motion.q0, &motion.q1}) {
      const Vec3 axis = map({(*q)[1], (*q)[2], (*q)[3]});
      *q = {(*q)[0], direction * axis.x, direction * axis.y, direction * axis.z};
    }
    motion.p0 = map(motion.p0);
    motion.p1 = map(motion.p1);
  }
  return query;
}

TEST_CASE("law of curves: permuted and mirrored axes change nothing") {
  check_curved_law(kSeed, 18, 1, [](const CurvedAsked& asked, Method method, Rng& rng) {
    return same_answer(asked, CurvedAsked{mapped(asked.query, any_axis_map(rng)), asked.separation, asked.t_max},
                       method);
  });
}

/// The 24 turns of a cube, as quaternions of integers that are not of unit length: quarter turns, half turns, and
/// thirds of a turn about a diagonal.
Quaternion cube_turn(Rng& rng) {
  Quaternion q{};
  const int parts = rng.pick(std::array<int, 3>{1, 2, 4});
  while (std::fabs(q[0]) + std::fabs(q[1]) + std::fabs(q[2]) + std::fabs(q[3]) != parts) {
    for (double& c : q) c = rng.between(-1, 1);
  }
  return q;
}

/// The signed permutation that such a turn is.
AxisMap axis_map_of(const Quaternion& turn) {
  const double length = dot(turn, turn);
  const std::array<Vec3, 3> images{turned(turn, {1, 0, 0}), turned(turn, {0, 1, 0}), turned(turn, {0, 0, 1})};
  AxisMap map;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3 image = images[axis];
      if (coordinate(image, k) == 0) continue;
      map.from[k] = axis;
      map.sign[k] = coordinate(image, k) / length;
    }
  }
  return map;
}

/// product(turn, q), where the turn's components are 0, 1 or -1.
Quaternion exact_product(const Quaternion& g, const Quaternion& q, Exactly& exactly) {
  const auto of_four = [&](double a, double b, double c, double d) {
    return exactly.sum(exactly.sum(a, b), exactly.sum(c, d));
  };
  return {of_four(g[0] * q[0], -g[1] * q[1], -g[2] * q[2], -g[3] * q[3]),
          of_four(g[0] * q[1], g[1] * q[0], g[2] * q[3], -g[3] * q[2]),
          of_four(g[0] * q[2], -g[1] * q[3], g[2] * q[0], g[3] * q[1]),
          of_four(g[0] * q[3], g[1] * q[2], -g[2] * q[1], g[3] * q[0])};
}

TEST_CASE("law of curves: a quarter turn of the bodies and of space around them changes nothing") {
  check_curved_law(kSeed, 18, 0.5, [](const CurvedAsked& asked, Method method, Rng& rng) -> Finding {
    const Quaternion turn = cube_turn(rng);
    const AxisMap map = axis_map_of(turn);
    Exactly exactly;
    CurvedAsked other = asked;
    for (CurvedCorner& corner : other.query.corners) {
      if (corner.motion != CurvedCorner::kOnCurve) continue;  // body points stay: the body turns
      for (Vec3& point : corner.points) point = map(point);
    }
    for_each_motion(other.query, [&](RigidMotion& motion) {
      motion.q0 = exact_product(turn, motion.q0, exactly);
      motion.q1 = exact_product(turn, motion.q1, exactly);
      motion.p0 = map(motion.p0);
      motion.p1 = map(motion.p1);
    });
    if (!exactly.holds()) return std::nullopt;
    return same_answer(asked, other, method);
  });
}

TEST_CASE("law of curves: bodies that have been turned by a quarter and move straight are a straight query") {
  std::size_t checked = 0;
  const auto dyadic = [](const FamilyInfo& family, Kind) { return family.dyadic; };
  Report report;
  for_each_case(kSeed, 25, dyadic, [&](const CaseId& id) {
    Rng rng = rng_of(id);
    const Query query = make(id.family, id.kind, rng);
    CurvedQuery curved;
    curved.kind = query.kind;
    Exactly exactly;
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
      // A body of its own for each corner, which it has at X: start = R X + p0, end = R X + p1.
      RigidMotion& motion = curved.motions[i];
      motion.q0 = motion.q1 = cube_turn(rng);
      const Vec3 x{static_cast<double>(rng.between(-8, 8)), static_cast<double>(rng.between(-8, 8)),
                   static_cast<double>(rng.between(-8, 8))};
      const Vec3 placed = axis_map_of(motion.q0)(x);
      const Vec3 back{-placed.x, -placed.y, -placed.z};
      motion.p0 = exactly.sum(query.start[i], back);
      motion.p1 = exactly.sum(query.end[i], back);
      curved.corners[i] = CurvedCorner::on_body(static_cast<int>(i), x);
    }
    if (!exactly.holds()) return;
    ++checked;
    for (const Method method : {Method::fast, Method::exact}) {
      report.add(id, query, difference(solve(query, {.method = method}), solve(curved, {.method = method}), query));
    }
  });
  CHECK(checked > 0);
  report.finish();
}

TEST_CASE("law of curves: a power of two changes nothing") {
  check_curved_law(kSeed, 18, 0.4, [](const CurvedAsked& asked, Method method, Rng& rng) -> Finding {
    const int exponent = rng.one_in(2) ? rng.between(-60, 60) : rng.between(-500, 500);
    Exactly exactly;
    CurvedAsked other = asked;
    for_each_length(other.query, [&](double& x) { x = exactly.times_power(x, exponent); });
    other.separation.distance = exactly.times_power(asked.separation.distance, exponent);
    if (!exactly.holds()) return std::nullopt;
    return same_answer(asked, other, method);
  });
}

TEST_CASE("law of curves: a quaternion's length and sign change nothing") {
  check_curved_law(kSeed, 18, 0.4, [](const CurvedAsked& asked, Method method, Rng& rng) -> Finding {
    Exactly exactly;
    CurvedAsked other = asked;
    for_each_motion(other.query, [&](RigidMotion& motion) {
      const int exponent = rng.between(-200, 200);
      const double sign = rng.one_in(2) ? -1 : 1;
      for (Quaternion* const q : {&motion.q0, &motion.q1}) {
        for (double& c : *q) c = sign * exactly.times_power(c, exponent);
      }
    });
    if (!exactly.holds()) return std::nullopt;
    return same_answer(asked, other, method);
  });
}

/// Adds a vector that moves from `at_start` to `at_end`, whose coordinates are multiples of 6, to everything.
CurvedQuery carried(CurvedQuery query, const Vec3& at_start, const Vec3& at_end, Exactly& exactly) {
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    CurvedCorner& corner = query.corners[i];
    if (corner.motion != CurvedCorner::kOnCurve) continue;
    if (corner.control_points == 1) {  // a corner at rest begins to move
      corner.control_points = 2;
      corner.points[1] = corner.points[0];
    }
    const int degree = corner.control_points - 1;
    for (int k = 0; k <= degree; ++k) {
      Vec3& point = corner.points[static_cast<std::size_t>(k)];
      const auto between = [&](double a, double b) { return (a * (degree - k) + b * k) / degree; };
      point = exactly.sum(
          point, {between(at_start.x, at_end.x), between(at_start.y, at_end.y), between(at_start.z, at_end.z)});
    }
  }
  for_each_motion(query, [&](RigidMotion& motion) {
    motion.p0 = exactly.sum(motion.p0, at_start);
    motion.p1 = exactly.sum(motion.p1, at_end);
  });
  return query;
}

TEST_CASE("law of curves: an exact translation and a common velocity change nothing") {
  check_curved_law(kSeed, 18, 0.2, [](const CurvedAsked& asked, Method method, Rng& rng) -> Finding {
    const auto multiple_of_six = [&] { return 6.0 * rng.between(-20, 20); };
    const auto vector = [&] {
      const double x = multiple_of_six(), y = multiple_of_six();
      return Vec3{x, y, multiple_of_six()};
    };
    const Vec3 at_start = vector();
    const Vec3 at_end = rng.one_in(2) ? at_start : vector();
    Exactly exactly;
    const CurvedAsked other{carried(asked.query, at_start, at_end, exactly), asked.separation, asked.t_max};
    if (!exactly.holds()) return std::nullopt;
    return same_answer(asked, other, method);
  });
}

TEST_CASE("law of curves: a straight path written as a parabola changes nothing") {
  check_curved_law(kSeed, 18, 0.05, [](const CurvedAsked& asked, Method method, Rng&) -> Finding {
    Exactly exactly;
    CurvedAsked other = asked;
    bool any = false;
    for (std::size_t i = 0; i < corner_count(asked.query.kind); ++i) {
      CurvedCorner& corner = other.query.corners[i];
      if (corner.motion != CurvedCorner::kOnCurve || corner.control_points > 2) continue;
      const Vec3 from = corner.points[0], to = corner.points[static_cast<std::size_t>(corner.control_points - 1)];
      corner.points = {from, exactly.middle(from, to), to};
      corner.control_points = 3;
      any = true;
    }
    if (!any || !exactly.holds()) return std::nullopt;
    return same_answer(asked, other, method);
  });
}

}  // namespace
}  // namespace touchstone::tests
