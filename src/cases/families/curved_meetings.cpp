// Curved queries with a contact at a known dyadic time and known dyadic weights, exact in doubles, and their
// neighbours.
//
// At the time t, q(t) is a quaternion of integers, divided by a power of two, and body points are integers times N =
// |q(t)|^2: rotated, they are integers. So the positions at t are dyadics of few digits, and one element is moved so
// that a point of it meets a point of the other.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "families/curved_parts.hpp"
#include "families/makers.hpp"

namespace touchstone::families::makers {
namespace {

constexpr int kReach = 2;

RigidMotion lattice_motion(Rng& rng) {
  RigidMotion motion;
  motion.q0 = lattice_quaternion(rng, kReach);
  motion.q1 = rng.one_in(6) ? motion.q0 : lattice_quaternion(rng, kReach);
  if (dot(motion.q0, motion.q1) < 0 && !rng.one_in(4)) motion.q1 = -1.0 * motion.q1;
  motion.p0 = lattice_point(rng, 4);
  motion.p1 = rng.one_in(2) ? motion.p0 : lattice_point(rng, 4);
  return motion;
}

/// |q(t)|^2 times the square of the power of two that makes t an integer; 0 where q(t) = 0.
double scale_at(const RigidMotion& motion, double time) {
  double whole = 1;
  while (time * whole != std::floor(time * whole)) whole *= 2;
  const Quaternion q = (whole - whole * time) * motion.q0 + (whole * time) * motion.q1;
  return dot(q, q);
}

CurvedCorner lattice_curve(Rng& rng, int least, int most) {
  CurvedCorner corner;
  corner.control_points = rng.between(least, most);
  for (Vec3& point : corner.points) point = lattice_point(rng, 4);
  return corner;
}

}  // namespace

CornerWeights dyadic_weights(std::size_t corners, Rng& rng, Where where) {
  CornerWeights weights{};
  if (corners == 1 || where == Where::joint) {
    weights[rng.below(corners)] = 1;
    return weights;
  }
  static constexpr std::array<CornerWeights, 4> edge{{{0.5, 0.5}, {0.25, 0.75}, {0.125, 0.875}, {1, 0}}};
  static constexpr std::array<CornerWeights, 6> face{
      {{0.5, 0.25, 0.25}, {0.125, 0.5, 0.375}, {0.5, 0.5, 0}, {0.25, 0.75, 0}, {1, 0, 0}, {0.125, 0.125, 0.75}}};
  const CornerWeights& chosen = corners == 2 ? rng.pick(edge) : rng.pick(face);
  const std::size_t turn = rng.below(corners);
  for (std::size_t i = 0; i < corners; ++i) weights[(i + turn) % corners] = chosen[i];
  return weights;
}

void meet_at_random(CurvedQuery& query, Rng& rng, double time, Where where) {
  const ElementSizes sizes = element_sizes(query.kind);
  const CornerWeights wa = dyadic_weights(sizes.a, rng, where);
  const CornerWeights wb =
      dyadic_weights(sizes.b, rng, where == Where::joint && rng.one_in(2) ? Where::anywhere : where);
  meet(query, wa, wb, time);
}

CurvedSample turn_meets(Kind kind, Rng& rng, double time, Where where) {
  CurvedQuery query;
  query.kind = kind;
  std::array<bool, 2> on_curves{};
  std::array<double, 2> scale{};
  for (std::size_t element = 0; element < 2; ++element) {
    on_curves[element] = rng.one_in(element == 0 ? 8 : 3);
    do {
      query.motions[element] = lattice_motion(rng);
      scale[element] = scale_at(query.motions[element], time);
    } while (scale[element] == 0);
  }
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const std::size_t element = element_of(kind, i);
    query.corners[i] = on_curves[element] ? lattice_curve(rng, 1, 4)
                                          : CurvedCorner::on_body(static_cast<int>(element),
                                                                  scale[element] * lattice_point(rng, kReach));
  }
  meet_at_random(query, rng, time, where);
  return {query, 1, time};
}

CurvedSample pythagorean(Kind kind, Rng& rng) {
  const double time = 0.125 * rng.between(1, 7);
  return turn_meets(kind, rng, time, Where::joint);
}

CurvedSample near_meeting(Kind kind, Rng& rng) {
  const double time = 0.25 * rng.between(0, 4);
  CurvedSample sample = turn_meets(kind, rng, time, rng.one_in(3) ? Where::joint : Where::anywhere);
  sample.touches_at.reset();
  CurvedQuery& query = sample.query;
  if (rng.one_in(3)) {  // by much less than an ulp of the coordinates: one body, or curve, moves off the origin
    const int exponent = rng.one_in(3) ? -rng.between(55, 140) : -rng.between(38, 54);
    const Vec3 off = std::ldexp(1.0, exponent) * lattice_point(rng, 1);
    const Vec3 to_origin = -1.0 * position(query, 0, time);
    translate(query, 0, to_origin);
    translate(query, 1, to_origin);
    translate(query, 1, off);
    return sample;
  }
  std::uint64_t count = 0;
  for_each_number(query, [&](double&) { ++count; });
  for (int moves = rng.one_in(4) ? 2 : 1; moves > 0; --moves) {
    const std::uint64_t moved = rng.below(count);
    const double away =
        rng.one_in(2) ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
    std::uint64_t i = 0;
    for_each_number(query, [&](double& x) {
      if (i++ == moved) x = x == 0 ? std::copysign(0x1p-52, away) : std::nextafter(x, away);
    });
  }
  return sample;
}

// Parabolas: a corner, or all of the first element, flies with one acceleration. At its apex it is as high as the other
// element, an ulp below, or it passes through at any time.
CurvedSample ballistic(Kind kind, Rng& rng) {
  CurvedQuery query;
  query.kind = kind;
  const bool apex = rng.one_in(2);
  Vec3 fall = lattice_point(rng, 2);  // half of b0 - 2 b1 + b2
  if (apex) fall = {0, 0, -4};
  const Vec3 shared = apex ? Vec3{2.0 * rng.between(-2, 2), 2.0 * rng.between(-2, 2), 0} : lattice_point(rng, 4);
  const bool both_fly = rng.one_in(4);
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const bool flies = element_of(kind, i) == 0 || both_fly;
    Vec3 point = lattice_point(rng, 4);
    if (apex && rng.one_in(2)) point.z = 0;
    if (!flies) {
      if (apex) point.z = 0;
      query.corners[i] = CurvedCorner::on_curve({point});
      continue;
    }
    // b1 = b0 + v / 2 and b2 = b0 + v + 2 fall, with v_z = -2 fall_z so that the apex is at t = 1/2 where asked for.
    const Vec3 spin = rng.one_in(3) ? lattice_point(rng, 2) : Vec3{};
    Vec3 half = shared + spin;
    if (apex) half = {half.x, half.y, -fall.z};
    query.corners[i] = CurvedCorner::on_curve({point, point + half, point + 2.0 * half + 2.0 * fall});
  }
  const double time = apex ? 0.5 : 0.125 * rng.between(0, 8);
  meet_at_random(query, rng, time, rng.one_in(3) ? Where::joint : Where::anywhere);
  if (!apex || !rng.one_in(4)) return {query, 1, time};
  translate(query, 1, Vec3{0, 0, std::ldexp(rng.one_in(2) ? 1.0 : -1.0, -rng.between(40, 60))});
  return {query, 1, {}};
}

CurvedSample spline(Kind kind, Rng& rng) {
  CurvedQuery query;
  query.kind = kind;
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    query.corners[i] = lattice_curve(rng, rng.one_in(4) ? 1 : 4, 4);
    if (i > 0 && rng.one_in(3)) {  // the same velocity as the corner before
      const CurvedCorner& before = query.corners[i - 1];
      const Vec3 beside = lattice_point(rng, 2);
      query.corners[i].control_points = before.control_points;
      for (std::size_t k = 0; k < before.points.size(); ++k) query.corners[i].points[k] = before.points[k] + beside;
    }
  }
  if (rng.one_in(4)) return {query, 1, {}};
  const double time = 0.125 * rng.between(0, 8);
  meet_at_random(query, rng, time, rng.one_in(3) ? Where::joint : Where::anywhere);
  return {query, 1, time};
}

}  // namespace touchstone::families::makers
