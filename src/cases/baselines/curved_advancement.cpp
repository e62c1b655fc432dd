// Conservative advancement with motion bounds: nothing can touch before the distance has been travelled.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include <touchstone/error.hpp>

#include "baselines/curved_baseline.hpp"
#include "baselines/curved_position.hpp"
#include "baselines/distance.hpp"
#include "geometry/kind_traits.hpp"

namespace touchstone::baselines {
namespace {

Vector vector_of(const Vec3& x) { return {{x.x, x.y, x.z}}; }

double length_of(const Vector& x) { return std::sqrt(geometry::dot(x, x)); }

/// What an element's corners do: one velocity for all of them, and a bound on their speed beside it.
struct Speeds {
  Vector velocity{};
  double beside = 0;
};

Speeds speeds_of(const CurvedQuery& query, std::size_t first, std::size_t last) {
  Speeds speeds;
  const int motion = query.corners[first].motion;
  for (std::size_t i = first; i < last; ++i) {
    const CurvedCorner& corner = query.corners[i];
    if (motion == CurvedCorner::kOnCurve || corner.motion != motion) {  // not one body: no velocity for all
      speeds = {};
      break;
    }
    const RigidMotion& body = query.motions[static_cast<std::size_t>(motion)];
    speeds.velocity = vector_of(body.p1) - vector_of(body.p0);
    speeds.beside = std::max(speeds.beside, angular_speed(body) * length_of(vector_of(corner.points[0])));
    if (i + 1 == last) return speeds;
  }
  for (std::size_t i = first; i < last; ++i) {
    const CurvedCorner& corner = query.corners[i];
    double speed = 0;
    if (corner.motion != CurvedCorner::kOnCurve) {
      const RigidMotion& body = query.motions[static_cast<std::size_t>(corner.motion)];
      speed = length_of(vector_of(body.p1) - vector_of(body.p0)) +
              angular_speed(body) * length_of(vector_of(corner.points[0]));
    } else {  // a Bezier curve's derivative lies in the hull of n times the differences of its control points
      for (std::size_t k = 1; k < static_cast<std::size_t>(corner.control_points); ++k) {
        const Vector way = vector_of(corner.points[k]) - vector_of(corner.points[k - 1]);
        speed = std::max(speed, (corner.control_points - 1) * length_of(way));
      }
    }
    speeds.beside = std::max(speeds.beside, speed);
  }
  return speeds;
}

double distance_at(const CurvedCorners& corners, double t) {
  const Vector c0 = corners.at(0, t), c1 = corners.at(1, t), c2 = corners.at(2, t), c3 = corners.at(3, t);
  if (corners.query().kind == Kind::edge_edge) return segment_distance(c1 - c0, c3 - c2, c2 - c0);
  return point_triangle_distance(c2 - c1, c3 - c1, c0 - c1);
}

}  // namespace

Result solve_curved_advancement(const CurvedQuery& query, double t_max, double tolerance) {
  if (query.kind != Kind::edge_edge && query.kind != Kind::vertex_face) {
    throw InvalidQuery("curved_advancement takes no " + std::string(name_of(query.kind)) + " queries");
  }
  const CurvedCorners corners(query);
  const std::size_t first_of_b = geometry::corners_of_first(query.kind);
  const Speeds a = speeds_of(corners.query(), 0, first_of_b);
  const Speeds b = speeds_of(corners.query(), first_of_b, corner_count(query.kind));
  const double speed = length_of(b.velocity - a.velocity) + a.beside + b.beside;
  const double near = std::scalbn(tolerance, -corners.exponent());
  double t = 0;
  for (int step = 0; step < kCurvedAdvancementSteps; ++step) {
    const double distance = distance_at(corners, t);
    if (distance <= near) return {true, t};
    const double next = t + distance / speed;  // infinite or no number at all when nothing moves
    if (!(next <= t_max)) return {};
    t = next;
  }
  return {true, t};
}

}  // namespace touchstone::baselines
