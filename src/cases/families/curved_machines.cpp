// Curved queries of machines: gears, rods, screws, coins, and bodies of a simulation.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "families/curved_parts.hpp"
#include "families/makers.hpp"

namespace touchstone::families::makers {
namespace {

constexpr std::size_t kY = 1, kZ = 2;

Vec3 flat_point(Rng& rng, int reach) {
  Vec3 point = lattice_point(rng, reach);
  point.z = 0;
  return point;
}

/// A turn about an axis, from one small rational half angle to another.
RigidMotion turn_about(std::size_t axis, Rng& rng) {
  RigidMotion motion;
  const double c0 = rng.between(1, 3), s0 = small(rng, 2);
  const double c1 = rng.between(0, 2), s1 = rng.between(1, 3);
  motion.q0 = about_axis(axis, c0, s0);
  motion.q1 = about_axis(axis, c1, s1);
  return motion;
}

/// A turn about z that passes through no turn at all at `time`.
struct Swing {
  RigidMotion motion;
  double time;
};
Swing swing(Rng& rng) {
  struct Ends {
    double before, after, time;
  };
  static constexpr std::array<Ends, 6> ends{
      {{1, 1, 0.5}, {2, 2, 0.5}, {1, 3, 0.25}, {3, 1, 0.75}, {0, 1, 0}, {1, 0, 1}}};
  const Ends& chosen = rng.pick(ends);
  const double c = rng.between(1, 4);
  Swing result{{}, chosen.time};
  result.motion.q0 = about_axis(kZ, c, -chosen.before);
  result.motion.q1 = about_axis(kZ, c, chosen.after);
  return result;
}

/// The same turn about z the other way.
RigidMotion mirrored(RigidMotion motion) {
  motion.q0[3] = -motion.q0[3];
  motion.q1[3] = -motion.q1[3];
  return motion;
}

/// Any lattice orientation of space, half of the time.
void maybe_turn_space(CurvedQuery& query, Rng& rng) {
  if (rng.one_in(2)) turn_space(query, lattice_quaternion(rng, 1));
}

/// Moves the second element by much less than its size, half of the time. @returns whether it did
bool maybe_shift(CurvedQuery& query, Rng& rng) {
  if (rng.one_in(2)) return false;
  const double size = std::ldexp(1.0, -rng.between(20, 52));
  translate(query, 1, size * lattice_point(rng, 1));
  return true;
}

CurvedQuery of_bodies(Kind kind) {
  CurvedQuery query;
  query.kind = kind;
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    query.corners[i] = CurvedCorner::on_body(static_cast<int>(element_of(kind, i)), {});
  }
  return query;
}

/// Moves the second element so that both nearly meet at some time, half of the time: rotations round.
void maybe_nearly_meet(CurvedQuery& query, Rng& rng) {
  if (rng.one_in(2)) return;
  const double time = 0.125 * rng.between(0, 8);
  meet_at_random(query, rng, time, Where::anywhere);
}

CornerWeights first_corner() { return {1, 0, 0}; }

}  // namespace

// In the plane V is identically zero. As prisms, the teeth's edges are parallel to the axes of the turns.
CurvedSample gears(Kind kind, Rng& rng) {
  CurvedQuery query = of_bodies(kind);
  for (std::size_t m = 0; m < 2; ++m) {
    query.motions[m] = turn_about(kZ, rng);
    query.motions[m].p0 = flat_point(rng, 3);
    query.motions[m].p1 = rng.one_in(2) ? query.motions[m].p0 : flat_point(rng, 3);
  }
  if (rng.one_in(3)) {  // one drives the other
    const Vec3 p0 = query.motions[1].p0;
    query.motions[1] = mirrored(query.motions[0]);
    query.motions[1].p0 = p0;
    query.motions[1].p1 = p0;
  }
  const bool prisms = rng.one_in(2);
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    query.corners[i].points[0] = flat_point(rng, 4);
    if (!prisms) continue;
    const std::size_t element = element_of(kind, i);
    if (kind == Kind::edge_edge && i % 2 == 1 && rng.one_in(2)) {
      query.corners[i].points[0] = query.corners[i - 1].points[0];
    }
    query.corners[i].points[0].z = small(rng, element == 0 ? 1 : 2);
  }
  maybe_nearly_meet(query, rng);
  maybe_turn_space(query, rng);
  return {query, 1, {}};
}

// The tip is farthest out just when its rod points at the wall: V has a double root there.
CurvedSample rod_tip(Kind kind, Rng& rng) {
  CurvedQuery query = of_bodies(kind);
  const Swing turn = swing(rng);
  query.motions[0] = turn.motion;
  const double length = rng.between(1, 8);
  const bool flush = kind == Kind::edge_edge && rng.one_in(3);  // an edge along the axis, not a tip alone
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    Vec3& point = query.corners[i].points[0];
    point = lattice_point(rng, 4);
    if (element_of(kind, i) == 1 || i == 0) {
      point.x = length;
      if (i == 0) point.y = 0;
    } else {
      point.x = flush ? length : small(rng, 1);
      if (flush) point.y = 0;
    }
  }
  if (rng.one_in(4)) query.motions[1].p1 = {0, small(rng, 2), small(rng, 2)};  // the wall moves along itself
  if (rng.one_in(4)) query.motions[0].p1 = {0, 0, small(rng, 2)};
  const std::size_t wall_corners = element_sizes(kind).b;
  meet(query, first_corner(), dyadic_weights(wall_corners, rng, Where::anywhere), turn.time);
  maybe_turn_space(query, rng);
  if (maybe_shift(query, rng)) return {query, 1, {}};
  return {query, 1, turn.time};
}

CurvedSample screw(Kind kind, Rng& rng) {
  CurvedQuery query = of_bodies(kind);
  for (std::size_t m = 0; m < 2; ++m) {
    query.motions[m] = turn_about(kZ, rng);
    query.motions[m].p0 = {0, 0, small(rng, 2)};
    query.motions[m].p1 = {0, 0, small(rng, 2)};
  }
  switch (rng.between(0, 3)) {
    case 0: query.motions[1] = RigidMotion(); break;
    case 1: query.motions[1] = query.motions[0]; break;
    case 2: query.motions[1].q1 = query.motions[1].q0; break;  // the nut only moves along
    default: break;
  }
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const Vec3 point = {small(rng, 4), small(rng, 4), small(rng, 1)};
    query.corners[i].points[0] = point;
    // A thread: the corner before, a quarter of a turn further and higher up.
    if (i > 0 && element_of(kind, i) == element_of(kind, i - 1) && rng.one_in(2)) {
      const Vec3& before = query.corners[i - 1].points[0];
      query.corners[i].points[0] = {-before.y, before.x, before.z + small(rng, 1)};
    }
  }
  if (rng.one_in(2)) maybe_nearly_meet(query, rng);
  maybe_turn_space(query, rng);
  return {query, 1, {}};
}

// A coin of radius 5, whose rim's points are those of the right triangle 3, 4, 5. It turns about its axis y as it moves
// over the floor z = 0, and touches that with its lowest point, or passes just above.
CurvedSample coin(Kind kind, Rng& rng) {
  static constexpr std::array<Vec3, 8> kRim = {
      {{5, 0, 0}, {4, 0, 3}, {3, 0, 4}, {0, 0, 5}, {-3, 0, -4}, {0, 0, -5}, {4, 0, -3}, {3, 0, -4}}};
  CurvedQuery query = of_bodies(kind);
  RigidMotion& coin = query.motions[0];
  const double c0 = rng.between(1, 3), s0 = small(rng, 1);
  const double c1 = rng.between(0, 2), s1 = rng.between(1, 3);
  coin.q0 = about_axis(kY, c0, s0);
  coin.q1 = about_axis(kY, c1, s1);
  const double height = rng.one_in(4) ? std::nextafter(5, rng.one_in(2) ? 6 : 4) : 5;
  coin.p0 = {small(rng, 4), 0, height};
  coin.p1 = {small(rng, 4), small(rng, 1), rng.one_in(4) ? 4.0 : height};
  if (rng.one_in(3)) {  // it rolls without slip, but for the rounding of pi, by a quarter turn or a half
    constexpr double kPi = 0x1.921fb54442d18p+1;
    const bool half = rng.one_in(2);
    coin.q0 = kNoTurn;
    coin.q1 = about_axis(kY, half ? 0 : 1, 1);
    coin.p1.x = coin.p0.x + 5 * (half ? kPi : kPi / 2);
  }
  const Vec3 rim = rng.pick(kRim);
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    Vec3 point = {8 * small(rng, 2), 8 * small(rng, 2), 0};
    if (element_of(kind, i) == 0) {
      point = i == 0 ? rim : rng.pick(kRim);
      if (i > 0 && rng.one_in(2)) point = rim + Vec3{0, 1, 0};  // an edge across the rim
    }
    query.corners[i].points[0] = point;
    if (element_of(kind, i) == 1 && rng.one_in(2)) query.corners[i] = CurvedCorner::on_curve({point});
  }
  if (rng.one_in(3)) return {query, 1, {}};
  // The floor's element lies below the rim's point at some time.
  const double time = 0.125 * rng.between(0, 8);
  const Vec3 above = position(query, 0, time);
  const std::size_t first_of_b = element_sizes(kind).a;
  const CornerWeights weights = dyadic_weights(element_sizes(kind).b, rng, Where::anywhere);
  Vec3 below;
  for (std::size_t i = first_of_b; i < corner_count(kind); ++i) {
    below = below + weights[i - first_of_b] * query.corners[i].points[0];
  }
  translate(query, 1, {above.x - below.x, above.y - below.y, 0});
  return {query, 1, {}};
}

// Two tips on circles that touch each other from outside or from inside, where both are at the same time.
CurvedSample tangent_turn(Kind kind, Rng& rng) {
  CurvedQuery query = of_bodies(kind);
  const Swing turn = swing(rng);
  query.motions[0] = turn.motion;
  query.motions[1] = rng.one_in(2) ? mirrored(turn.motion) : turn.motion;
  const double inside = rng.one_in(3) ? 1 : -1;
  const bool along_axis = rng.one_in(3);
  const std::size_t first_of_b = element_sizes(kind).a;
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const bool first = element_of(kind, i) == 0;
    const double radius = rng.between(1, 6);
    Vec3& point = query.corners[i].points[0];
    point = lattice_point(rng, 3);
    if (i == 0 || i == first_of_b) {
      point.x = first ? radius : inside * radius;
      point.y = 0;
    } else if (along_axis) {
      point.x = query.corners[i - 1].points[0].x;
      point.y = query.corners[i - 1].points[0].y;
    }
  }
  if (rng.one_in(3)) query.motions[1].p1.z = small(rng, 3);
  meet(query, first_corner(), first_corner(), turn.time);
  maybe_turn_space(query, rng);
  if (maybe_shift(query, rng)) return {query, 1, {}};
  return {query, 1, turn.time};
}

// Both elements stay in planes z = constant, the same one or two, as they turn about z.
CurvedSample turn_in_plane(Kind kind, Rng& rng) {
  CurvedQuery query = of_bodies(kind);
  const bool cross = rng.one_in(3);
  const bool second_rests = rng.one_in(2);
  for (std::size_t m = 0; m < 2; ++m) {
    query.motions[m].p0 = flat_point(rng, 3);
    query.motions[m].p1 = rng.one_in(2) ? query.motions[m].p0 : flat_point(rng, 3);
    if (m == 1 && second_rests) continue;
    const RigidMotion turn = turn_about(kZ, rng);
    query.motions[m].q0 = turn.q0;
    query.motions[m].q1 = turn.q1;
  }
  if (cross) {
    query.motions[0].p0.z = small(rng, 2);
    query.motions[0].p1.z = small(rng, 2);
  }
  for (std::size_t i = 0; i < corner_count(kind); ++i) query.corners[i].points[0] = flat_point(rng, 4);
  maybe_nearly_meet(query, rng);
  maybe_turn_space(query, rng);
  if (rng.one_in(4)) translate(query, 1, std::ldexp(1.0, -rng.between(40, 60)) * lattice_point(rng, 1));
  return {query, 1, {}};
}

// Two bodies of size 1 with their centres about 1 apart. Their elements, of size 0.1, are near each other at t = 0.
CurvedSample turning_bodies(Kind kind, Rng& rng) {
  CurvedQuery query = of_bodies(kind);
  const auto vector = [&](double size) {
    const double x = size * rng.symmetric();
    const double y = size * rng.symmetric();
    return Vec3{x, y, size * rng.symmetric()};
  };
  constexpr double kElement = 0.1, kWay = 0.03, kGap = 0.03;
  for (RigidMotion* motion : {&query.motions[0], &query.motions[1]}) {
    for (double& c : motion->q0) c = rng.symmetric();
    const double length = std::sqrt(dot(motion->q0, motion->q0));
    motion->q0 = (1 / length) * motion->q0;
    const Vec3 half_turn = vector(0.03);  // so long as the tangent of half the angle: at most about 6 degrees
    motion->q1 = product({1, half_turn.x, half_turn.y, half_turn.z}, motion->q0);
    motion->p0 = vector(0.7);
    const Vec3 way = vector(kWay);
    motion->p1 = motion->p0 + way;
  }
  const Vec3 apart = vector(kGap);
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const std::size_t element = element_of(kind, i);
    const RigidMotion& motion = query.motions[element];
    Vec3 position = vector(kElement);
    if (element == 1) position = position + apart;
    const Quaternion back = {motion.q0[0], -motion.q0[1], -motion.q0[2], -motion.q0[3]};
    query.corners[i].points[0] = turned(back, position - motion.p0);
  }
  return {query, 1, {}};
}

}  // namespace touchstone::families::makers
