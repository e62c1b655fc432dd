// Curved queries whose motion is special: lattices, equal motions, straight ones, and turns and lengths out of range.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "families/curved_parts.hpp"
#include "families/makers.hpp"

namespace touchstone::families::makers {
namespace {

int any_exponent(Rng& rng, int reach) { return rng.between(-reach, reach); }

CurvedCorner lattice_curve(Rng& rng, int reach) {
  CurvedCorner corner;
  corner.control_points = rng.between(1, 4);
  for (Vec3& point : corner.points) point = lattice_point(rng, reach);
  return corner;
}

RigidMotion lattice_turn(Rng& rng, int reach) {
  RigidMotion motion;
  motion.q0 = lattice_quaternion(rng, reach);
  motion.q1 = rng.one_in(4) ? motion.q0 : lattice_quaternion(rng, reach);
  if (dot(motion.q0, motion.q1) < 0 && !rng.one_in(4)) motion.q1 = -1.0 * motion.q1;
  motion.p0 = lattice_point(rng, reach);
  motion.p1 = rng.one_in(2) ? motion.p0 : lattice_point(rng, reach);
  return motion;
}

/// Two bodies on the lattice.
CurvedQuery lattice_bodies(Kind kind, Rng& rng, int reach) {
  CurvedQuery query;
  query.kind = kind;
  for (std::size_t m = 0; m < 2; ++m) query.motions[m] = lattice_turn(rng, reach);
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const Vec3 point = lattice_point(rng, reach);
    query.corners[i] = CurvedCorner::on_body(static_cast<int>(element_of(kind, i)), point);
  }
  return query;
}

/// A query of ordinary magnitude, most often one that touches.
CurvedSample curved_base(Kind kind, Rng& rng) {
  static constexpr std::array<Family, 14> bases{Family::curved_lattice, Family::gears,         Family::rod_tip,
                                                Family::screw,          Family::coin,          Family::turn_meets_half,
                                                Family::turn_meets_end, Family::pythagorean,   Family::near_meeting,
                                                Family::tangent_turn,   Family::turn_in_plane, Family::spline,
                                                Family::curved_random,  Family::turning_bodies};
  return make_curved(rng.pick(bases), kind, rng);
}

}  // namespace

CurvedSample curved_lattice(Kind kind, Rng& rng) {
  const int reach = rng.between(1, 2);
  CurvedQuery query;
  query.kind = kind;
  for (RigidMotion& motion : query.motions) motion = lattice_turn(rng, reach);
  if (rng.one_in(3)) query.motions[1] = query.motions[0];
  const int way = rng.between(0, 6);  // 0: curves; 1, 2: a body and curves; 3 to 5: two bodies; 6: any of three bodies
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const bool second = element_of(kind, i) == 1;
    const int motion = way == 6 ? rng.between(0, 2) : second ? 1 : 0;
    const bool on_curve = way == 0 || (way <= 2 && second);
    query.corners[i] = on_curve ? lattice_curve(rng, reach) : CurvedCorner::on_body(motion, lattice_point(rng, reach));
  }
  return {query, 1, {}};
}

// The elements are at rest relative to each other, or move along a line as seen from the body; or nearly so.
CurvedSample turn_alike(Kind kind, Rng& rng) {
  CurvedQuery query = lattice_bodies(kind, rng, 2);
  RigidMotion &first = query.motions[0], &second = query.motions[1];
  second = first;
  const double scale = dot(first.q0, first.q0);
  for (CurvedCorner& corner : query.corners) corner.points[0] = scale * corner.points[0];
  std::optional<double> touches_at;
  if (rng.one_in(2)) {
    meet_at_random(query, rng, 0, rng.one_in(3) ? Where::joint : Where::anywhere);
    touches_at = 0;
  }
  static constexpr std::array<double, 5> factors{2, -1, -4, 3, 0.5};
  switch (rng.between(0, 4)) {
    case 0: break;
    case 1:  // the same rotations, by quaternions of another length
      if (const double factor = rng.pick(factors); true) {
        second.q0 = factor * second.q0;
        second.q1 = factor * second.q1;
      }
      break;
    case 2:  // the same motion, not an equal one
      if (!touches_at) {
        for (CurvedCorner& corner : query.corners) corner.motion = 0;
      }
      break;
    case 3: second.p1 = second.p1 + lattice_point(rng, 2); break;  // and a translation
    default: {
      double& c = rng.one_in(2) ? second.q1[rng.below(4)] : coordinate(second.p1, rng.below(3));
      c += std::ldexp(1.0, -rng.between(30, 80));
      break;
    }
  }
  return {query, 1, touches_at};
}

// As two control points; as three, where the middle is a double; and as a body that only moves.
CurvedSample straight_curves(Kind kind, Rng& rng) {
  const FamilyInfo& family = all_families()[rng.below(all_families().size())];
  const Sample sample = make_sample(family.family, kind, rng);
  CurvedQuery query(sample.query);
  const int way = rng.between(0, 3);
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const Vec3 &start = sample.query.start[i], &end = sample.query.end[i];
    const int chosen = way == 3 ? rng.between(0, 2) : way;
    if (chosen == 1) {
      Vec3 middle;
      bool exact = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double a = coordinate(start, axis), b = coordinate(end, axis);
        const double sum = a + b, back = sum - a;
        // Exact sums (Knuth's two-sum has no remainder), and a half that is no rounded subnormal.
        exact = exact && std::isfinite(sum) && (a - (sum - back)) + (b - back) == 0 && 2 * (sum / 2) == sum;
        coordinate(middle, axis) = sum / 2;
      }
      if (exact) query.corners[i] = CurvedCorner::on_curve({start, middle, end});
    }
    if (chosen == 2) {
      query.corners[i] = CurvedCorner::on_body(static_cast<int>(i), {});
      query.motions[i].p0 = start;
      query.motions[i].p1 = end;
    }
  }
  return {query, 1, sample.touches_at};
}

// q1 is orthogonal to q0, a turn by 180 degrees, or nearly; or nearly -q0, a turn by almost 360 degrees.
CurvedSample large_turn(Kind kind, Rng& rng) {
  CurvedSample sample =
      rng.one_in(3) ? turn_meets(kind, rng, 0, Where::anywhere) : CurvedSample{lattice_bodies(kind, rng, 2), 1, {}};
  const int which = rng.between(1, 3);
  for (std::size_t m = 0; m < 2; ++m) {
    if ((which >> m & 1) == 0) continue;
    RigidMotion& motion = sample.query.motions[m];
    const Vec3 axis = lattice_point(rng, 2);
    const Quaternion off = lattice_quaternion(rng, 2);
    switch (rng.between(0, 3)) {
      case 0: motion.q1 = product({0, axis.x, axis.y, axis.z}, motion.q0); break;
      case 1: {
        const double size = std::ldexp(1.0, -rng.between(1, 60));
        motion.q1 = product({size, axis.x, axis.y, axis.z}, motion.q0);
        motion.q1[0] -= rng.one_in(2) ? 2 * size : 0;
        break;
      }
      case 2: motion.q1 = -1.0 * motion.q0 + std::ldexp(1.0, -rng.between(0, 12)) * off; break;
      default: motion.q1 = -1.0 * motion.q0 + std::ldexp(1.0, -rng.between(12, 60)) * off; break;
    }
    if (sample.touches_at || !rng.one_in(4)) continue;
    motion.p0 = 0.25 * motion.p0;  // so that elements meet more often
    motion.p1 = 0.25 * motion.p1;
  }
  return sample;
}

// The elements are as far apart as the turn moves them.
CurvedSample tiny_turn(Kind kind, Rng& rng) {
  CurvedSample sample = turn_meets(kind, rng, 0, rng.one_in(4) ? Where::joint : Where::anywhere);
  const double size = std::ldexp(1.0, -rng.between(20, 80));
  for (std::size_t m = 0; m < 2; ++m) {
    RigidMotion& motion = sample.query.motions[m];
    motion.q1 = motion.q0 + size * lattice_quaternion(rng, 2);
    motion.p1 = motion.p0;
    if (rng.one_in(3)) motion.p1 = motion.p1 + size * lattice_point(rng, 4);
  }
  if (rng.one_in(8)) return sample;
  const double length = size * rng.between(1, 16);
  translate(sample.query, 1, length * lattice_point(rng, 1));
  sample.touches_at.reset();
  return sample;
}

CurvedSample long_quaternion(Kind kind, Rng& rng) {
  CurvedSample sample = curved_base(kind, rng);
  const int way = rng.between(0, 3);
  bool exact = true;
  for_each_motion(sample.query, [&](RigidMotion& motion) {
    const int reach = way == 3 ? 1074 : 1000;
    const int first = any_exponent(rng, reach);
    const int second = way == 0 ? first : way == 1 ? first + rng.between(-60, 60) : any_exponent(rng, reach);
    const double factor = way == 0 || rng.one_in(2) ? 1 : 1 + 0.5 * rng.unit();
    for (Quaternion* const q : {&motion.q0, &motion.q1}) {
      const int exponent = q == &motion.q0 ? first : second;
      for (double& c : *q) {
        const double before = c;
        c = std::ldexp(factor * c, exponent);
        if (!std::isfinite(c)) c = std::copysign(std::numeric_limits<double>::max(), before);
        exact = exact && std::ldexp(c, -exponent) == before;
      }
    }
    exact = exact && first == second;
  });
  if (!exact) sample.touches_at.reset();
  return sample;
}

CurvedSample curved_scale(Kind kind, Rng& rng) {
  CurvedSample sample = curved_base(kind, rng);
  const int way = rng.between(0, 4);
  const int all = any_exponent(rng, 1060);
  std::array<int, 4> pool{};
  for (int& exponent : pool) exponent = any_exponent(rng, way == 2 ? 60 : 1000);
  bool exact = true;
  for_each_length(sample.query, [&](double& x) {
    const double before = x;
    int exponent = all;                                     // ways 0 and 1: the same for all
    if (way == 2 || way == 3) exponent = rng.pick(pool);    // of a few
    if (way == 4) exponent = rng.one_in(3) ? -1074 : 1020;  // subnormal among huge
    x = std::ldexp(x, exponent);
    if (!std::isfinite(x)) x = std::copysign(std::numeric_limits<double>::max(), before);
    exact = exact && exponent == all && std::ldexp(x, -exponent) == before;
  });
  if (!exact) sample.touches_at.reset();
  return sample;
}

CurvedSample curved_random(Kind kind, Rng& rng) {
  CurvedQuery query;
  query.kind = kind;
  const auto vector = [&](double size) {
    const double x = size * rng.symmetric();
    const double y = size * rng.symmetric();
    return Vec3{x, y, size * rng.symmetric()};
  };
  for (RigidMotion& motion : query.motions) {
    for (double& c : motion.q0) c = rng.symmetric();
    for (double& c : motion.q1) c = rng.symmetric();
    if (dot(motion.q0, motion.q1) < 0 && !rng.one_in(4)) motion.q1 = -1.0 * motion.q1;
    motion.p0 = vector(0.5);
    motion.p1 = vector(0.5);
  }
  const bool curves = rng.one_in(3);
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const std::size_t element = element_of(kind, i);
    query.corners[i] = CurvedCorner::on_body(static_cast<int>(element), vector(2));
    if (!curves || element == 0) continue;
    query.corners[i].motion = CurvedCorner::kOnCurve;
    query.corners[i].control_points = rng.between(1, 4);
    for (Vec3& point : query.corners[i].points) point = vector(2);
  }
  if (rng.one_in(2)) {
    const double time = rng.unit();
    meet_at_random(query, rng, time, Where::anywhere);  // nearly: positions round
  }
  return {query, 1, {}};
}

}  // namespace touchstone::families::makers
