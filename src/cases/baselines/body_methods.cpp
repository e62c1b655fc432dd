// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "baselines/body_baseline.hpp"
#include "baselines/curved_position.hpp"

namespace touchstone::baselines {
namespace {

double between(double start, double end, double t) { return start + t * (end - start); }

std::vector<Pose> poses_at(const MovingBodies& step, double t) {
  std::vector<Pose> poses;
  for (const RigidMotion& motion : step.motions) {
    Pose& pose = poses.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) pose.orientation[k] = between(motion.q0[k], motion.q1[k], t);
    pose.position = {between(motion.p0.x, motion.p1.x, t), between(motion.p0.y, motion.p1.y, t),
                     between(motion.p0.z, motion.p1.z, t)};
  }
  return poses;
}

/// A bound on how fast a point of one of two bodies comes nearer to a point of the other one.
double relative_speed(const MovingBodies& step, std::size_t a, std::size_t b) {
  const auto turning = [&](std::size_t i) {
    double radius = 0;
    for (const Vec3& p : step.bodies.bodies[i].points()) radius = std::max(radius, std::hypot(p.x, p.y, p.z));
    return radius * angular_speed(step.motions[i]);
  };
  const RigidMotion &first = step.motions[a], &second = step.motions[b];
  const auto difference = [&](double Vec3::*axis) {
    return (second.p1.*axis - second.p0.*axis) - (first.p1.*axis - first.p0.*axis);
  };
  return std::hypot(difference(&Vec3::x), difference(&Vec3::y), difference(&Vec3::z)) + turning(a) + turning(b);
}

}  // namespace

Result solve_waypoints(const MovingBodies& step, double tolerance) {
  const int count = static_cast<int>(std::lround(1 / tolerance));
  for (int i = 0; i <= count; ++i) {
    if (intersections(step.bodies, poses_at(step, static_cast<double>(i) / count)).empty()) continue;
    return {true, static_cast<double>(std::max(0, i - 1)) / count};
  }
  return {};
}

Result solve_body_advancement(const MovingBodies& step, double tolerance) {
  double speed = 0;
  for (std::size_t b = 0; b < step.motions.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) speed = std::max(speed, relative_speed(step, a, b));
  }
  double t = 0;
  for (int i = 0; i < kBodyAdvancementSteps; ++i) {
    const double apart = distance(step.bodies, poses_at(step, t)).distance;
    if (apart <= tolerance) break;
    const double next = t + apart / speed;  // infinite when nothing moves
    if (!(next <= 1)) return {};
    t = next;
  }
  return {true, t};
}

const std::vector<BodyBaseline>& body_methods() {
  static const std::vector<BodyBaseline> all{
      {"waypoints",
       "poses at even times are asked whether bodies intersect, as motion planners do, here exactly, which takes "
       "longer than in doubles; misses what lies between",
       Tolerance::fraction,
       0.01,
       {0.1, 0.01, 0.001},
       solve_waypoints},
      {"body_advancement",
       "steps of distance over a bound on speed, here of exact distances, which take longer than doubles; phantoms "
       "within the tolerance, and wherever it is after 1000 steps",
       Tolerance::length,
       1e-6,
       {1e-3, 1e-6},
       solve_body_advancement},
  };
  return all;
}

}  // namespace touchstone::baselines
