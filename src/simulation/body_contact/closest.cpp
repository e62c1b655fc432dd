// SPDX-License-Identifier: MIT
#include "body_contact/closest.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "contact/closest_points.hpp"
#include "geometry/kind_traits.hpp"

namespace touchstone::sim {
namespace {

using Corners = std::array<Vector3, 4>;

// The sine of the angle by which a neighbour may lean towards the other element before it counts as nearer. Neighbours
// in one plane do not lean, and a body that rests on a face rocks a little.
constexpr double kLean = 0.1;

constexpr double kParallel = 1e-7;  // the sine of an angle below which a cross product is no normal

ContactSide side_of(const Colliders& colliders, const Index* corners, std::size_t count,
                    const std::array<double, 3>& weights, const BodyStates& states, const Vector3& point) {
  ContactSide side;
  if (const Index group = colliders.group_of(*corners); group != kParticles) {
    side.body = group - 1;
    side.arm = point - states[side.body].pose.p;
    return side;
  }
  side.count = count;
  for (std::size_t i = 0; i < count; ++i) {
    side.particles[i] = corners[i];
    side.weights[i] = weights[i];
  }
  return side;
}

/// Whether something that is joined to this point of an element leans towards `towards`, of length 1.
bool leans(const Vector3& from, const Vector3& to, const Vector3& along, const Vector3& towards) {
  Vector3 way = to - from;
  if (const double square = along.squaredNorm(); square > 0) way -= way.dot(along) / square * along;
  return way.dot(towards) > kLean * way.norm();
}

/// Whether the faces at an edge, or the edges at its end that is closest, are nearer to the other element.
class Neighbourhood {
 public:
  Neighbourhood(const Colliders& colliders, const SceneMotion& motion) : colliders_(&colliders), motion_(&motion) {}

  bool edge_leans(Index edge, const Vector3& point, const Vector3& towards) const {
    const Edge& ends = colliders_->edges()[edge];
    const Vector3 along = at(ends[1]) - at(ends[0]);
    for (const Index corner : colliders_->opposite(edge)) {
      if (corner != Colliders::kNoCorner && leans(point, at(corner), along, towards)) return true;
    }
    return false;
  }
  bool vertex_leans(Index vertex, const Vector3& towards) const {
    const auto& others = colliders_->around(vertex);
    return std::any_of(others.begin(), others.end(),
                       [&](Index other) { return leans(at(vertex), at(other), Vector3::Zero(), towards); });
  }

 private:
  Vector3 at(Index vertex) const { return colliders_->at(vertex, *motion_->x0, *motion_->start); }

  const Colliders* colliders_;
  const SceneMotion* motion_;
};

bool neighbours_are_nearer(const Colliders& colliders, const Pair& pair, const std::array<Index, 4>& corners,
                           const SceneMotion& motion, const Weights& weights, const BodyContact& contact) {
  const Neighbourhood near(colliders, motion);
  const Vector3 point_a = contact.point + contact.gap * contact.normal;
  const auto end_of = [](const std::array<double, 3>& w) { return w[0] == 0 ? 1 : w[1] == 0 ? 0 : -1; };
  if (pair.kind == Kind::edge_edge) {
    const int end_a = end_of(weights.a), end_b = end_of(weights.b);
    // An end of an edge and a mesh are a vertex and a face of it.
    if (end_a >= 0 && !colliders.is_bare(pair.j)) return true;
    if (end_b >= 0 && !colliders.is_bare(pair.i)) return true;
    if (end_a >= 0 ? near.vertex_leans(corners[static_cast<std::size_t>(end_a)], -contact.normal)
                   : near.edge_leans(pair.i, point_a, -contact.normal)) {
      return true;
    }
    return end_b >= 0 ? near.vertex_leans(corners[2 + static_cast<std::size_t>(end_b)], contact.normal)
                      : near.edge_leans(pair.j, contact.point, contact.normal);
  }
  if (pair.kind == Kind::point_edge) {
    const int end_b = end_of(weights.b);
    return end_b >= 0 && near.vertex_leans(corners[1 + static_cast<std::size_t>(end_b)], contact.normal);
  }
  const auto zeros = std::count(weights.b.begin(), weights.b.end(), 0.0);
  if (zeros == 0) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (zeros == 2 && weights.b[k] != 0) return near.vertex_leans(corners[1 + k], contact.normal);
    if (zeros == 1 && weights.b[k] == 0) {
      const Index edge = colliders.edge_between(corners[1 + (k + 1) % 3], corners[1 + (k + 2) % 3]);
      return near.edge_leans(edge, contact.point, contact.normal);
    }
  }
  return false;
}

BodyContact contact_at(const Colliders& colliders, const Pair& pair, const std::array<Index, 4>& corners,
                       const Corners& x, const Weights& weights, const BodyStates& states) {
  BodyContact contact;
  contact.pair = pair;
  const std::size_t count = corner_count(pair.kind), of_first = geometry::corners_of_first(pair.kind);
  Vector3 a = Vector3::Zero(), b = Vector3::Zero();
  for (std::size_t c = 0; c < count; ++c)
    (c < of_first ? a : b) += (c < of_first ? weights.a[c] : weights.b[c - of_first]) * x[c];
  // Both impulses act at one point, or friction would turn the pair by the gap between.
  const auto of_particles = [&](std::size_t c) { return colliders.group_of(corners[c]) == kParticles; };
  const Vector3 at = of_particles(0) ? a : of_particles(of_first) ? b : Vector3(0.5 * (a + b));
  contact.a = side_of(colliders, corners.data(), of_first, weights.a, states, at);
  contact.b = side_of(colliders, corners.data() + of_first, count - of_first, weights.b, states, at);
  contact.point = b;
  contact.normal = a - b;
  contact.gap = contact.normal.norm();
  return contact;
}

}  // namespace

std::optional<BodyContact> closest(const Colliders& colliders, const Pair& pair, const SceneMotion& motion,
                                   double reach) {
  const auto corners = colliders.corners(pair);
  Corners x{};
  for (std::size_t c = 0; c < corner_count(pair.kind); ++c) x[c] = colliders.at(corners[c], *motion.x0, *motion.start);
  const Weights weights = closest_weights(pair.kind, x);
  BodyContact contact = contact_at(colliders, pair, corners, x, weights, *motion.start);
  const double separation = colliders.separation(pair);
  if (!(contact.gap < reach + separation) || !(contact.gap > 0)) return std::nullopt;
  contact.normal /= contact.gap;
  if (neighbours_are_nearer(colliders, pair, corners, motion, weights, contact)) return std::nullopt;
  // Rounding may make a gap negative that is not.
  if (separation > 0) contact.gap = std::max(0.0, contact.gap - separation);
  return contact;
}

BodyContact touching(const Colliders& colliders, const Pair& pair, const SceneMotion& motion, const Answer& answer) {
  const auto corners = colliders.corners(pair);
  const double t = answer.toi;
  BodyStates states(*motion.start);
  for (std::size_t i = 0; i < states.size(); ++i)
    states[i].pose = between((*motion.start)[i].pose, (*motion.end)[i].pose, t);
  const VectorX q = *motion.x0 + t * (*motion.x1 - *motion.x0);
  Corners x{}, before{};
  const std::size_t count = corner_count(pair.kind);
  for (std::size_t c = 0; c < count; ++c) {
    x[c] = colliders.at(corners[c], q, states);
    before[c] = colliders.at(corners[c], *motion.x0, *motion.start);
  }
  const Weights weights{answer.weights_a, answer.weights_b};
  BodyContact contact = contact_at(colliders, pair, corners, x, weights, states);
  contact.at_touch = true;
  const BodyContact start =
      contact_at(colliders, pair, corners, before, closest_weights(pair.kind, before), *motion.start);
  Vector3 normal = Vector3::Zero();
  // At a distance, the closest points say it.
  if (colliders.separation(pair) > 0 && contact.gap > 0) {
    contact.normal /= contact.gap;
    contact.gap = 0;
    return contact;
  }
  if (pair.kind == Kind::edge_edge)
    normal = (x[1] - x[0]).cross(x[3] - x[2]) / ((x[1] - x[0]).norm() * (x[3] - x[2]).norm());
  if (pair.kind == Kind::vertex_face)
    normal = (x[2] - x[1]).cross(x[3] - x[1]) / ((x[2] - x[1]).norm() * (x[3] - x[1]).norm());
  if (!(normal.norm() > kParallel)) normal = start.normal;
  if (!(normal.norm() > 0)) normal = Vector3::UnitZ();
  contact.normal = normal.normalized();
  if (contact.normal.dot(start.normal) < 0) contact.normal = -contact.normal;
  contact.gap = 0;
  return contact;
}

}  // namespace touchstone::sim
