// SPDX-License-Identifier: MIT
#include "contact/contact.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "contact/closest_points.hpp"
#include "geometry/frame.hpp"
#include "geometry/kind_traits.hpp"
#include "scene/features.hpp"

namespace touchstone::sim {
namespace {

using Corners = std::array<Vector3, 4>;

// The sine of the angle between two edges below which their cross product is no normal.
constexpr double kParallel = 1e-7;

// Fraction of the elements' displacement. Where less of it lies along the normal, the contact is a grazing one, and the
// positions before, not the motion, tell on which side the elements were.
constexpr double kGrazing = 1e-9;

// Fraction of the thickness: elements that are too near by less than this get no position correction, or a resting
// contact would never be at rest.
constexpr double kMissing = 1e-3;

std::array<double, 4> signed_weights(Kind kind, const Weights& weights) {
  const auto& [a, b] = weights;
  switch (kind) {
    case Kind::edge_edge: return {-a[0], -a[1], b[0], b[1]};
    case Kind::vertex_face: return {1, -b[0], -b[1], -b[2]};
    case Kind::point_edge: return {1, -b[0], -b[1], 0};
    case Kind::point_point: return {1, -1, 0, 0};
  }
  return {};
}

/// The elements' common normal, not oriented; zero where they have none.
Vector3 common_normal(Kind kind, const Corners& c) {
  if (kind == Kind::edge_edge || kind == Kind::vertex_face) {
    const auto [u, w, r] =
        geometry::frame_of(kind, [&c](std::size_t i, std::size_t j) { return Vector3(c[i] - c[j]); });
    const Vector3 n = u.cross(w);
    if (n.norm() > kParallel * u.norm() * w.norm()) return n.normalized();
  }
  return Vector3::Zero();
}

Vector3 weighted(const Contact& contact, const VectorX& x) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t c = 0; c < contact.corners; ++c) sum += contact.omega[c] * position(x, contact.particles[c]);
  return sum;
}

Contact empty_contact(const Colliders& colliders, const Pair& pair) {
  Contact contact;
  contact.pair = pair;
  contact.particles = colliders.corners(pair);
  contact.corners = corner_count(pair.kind);
  return contact;
}

}  // namespace

Contact contact_of(const Colliders& colliders, const Pair& pair, const VectorX& x0, const VectorX& x1,
                   const Answer& answer, bool exact_weights) {
  Contact contact = empty_contact(colliders, pair);
  contact.time = answer.toi;
  Corners at{};
  for (std::size_t c = 0; c < contact.corners; ++c) {
    const Vector3 start = position(x0, contact.particles[c]), end = position(x1, contact.particles[c]);
    at[c] = start + contact.time * (end - start);
  }
  contact.omega = signed_weights(
      pair.kind, exact_weights ? Weights{answer.weights_a, answer.weights_b} : closest_weights(pair.kind, at));
  const Vector3 before = weighted(contact, x0), moved = weighted(contact, x1) - before;
  if (const double separation = colliders.separation(pair); kSeparations && separation > 0) {
    // The elements are that far apart at the contact, and their closest points say where the other one is.
    const Vector3 between = before + contact.time * moved;
    const Vector3& along = between.squaredNorm() > 0 ? between : before;
    contact.normal = along.squaredNorm() > 0 ? Vector3(along.normalized()) : Vector3::UnitZ();
    contact.gap = std::max(contact.normal.dot(before) - separation, 0.0);
    return contact;
  }
  Vector3 n = common_normal(pair.kind, at);
  if (n.isZero()) {
    // Parallel edges, or a point: the normal is across the edge, towards the side that the elements came from.
    n = before;
    if (pair.kind == Kind::point_edge || pair.kind == Kind::edge_edge) {
      const Vector3 along = (pair.kind == Kind::edge_edge ? at[1] - at[0] : at[2] - at[1]).normalized();
      n -= n.dot(along) * along;
    }
    if (!(n.norm() > 0)) n = -moved;
    if (!(n.norm() > 0)) n = Vector3::UnitZ();
    n.normalize();
  }
  // The side that the elements came from is against the way they moved, by the weights of the contact. A grazing one
  // moves along the elements, and only the positions before tell.
  const double side = std::abs(n.dot(moved)) > kGrazing * moved.norm() ? -n.dot(moved) : n.dot(before);
  contact.normal = side < 0 ? Vector3(-n) : n;
  contact.gap = std::max(contact.normal.dot(before), 0.0);
  return contact;
}

bool proximity(const Colliders& colliders, const Pair& pair, const VectorX& x0, double thickness, Contact& contact) {
  contact = empty_contact(colliders, pair);
  Corners at{};
  for (std::size_t c = 0; c < contact.corners; ++c) at[c] = position(x0, contact.particles[c]);
  const double separation = colliders.separation(pair), reach = separation + thickness;
  // Most candidate pairs of a substep are far apart along an axis.
  const std::size_t first = geometry::corners_of_first(pair.kind);
  for (Eigen::Index k = 0; k < 3; ++k) {
    double low_a = at[0][k], high_a = low_a, low_b = at[first][k], high_b = low_b;
    for (std::size_t c = 1; c < contact.corners; ++c) {
      double& low = c < first ? low_a : low_b;
      double& high = c < first ? high_a : high_b;
      low = std::min(low, at[c][k]);
      high = std::max(high, at[c][k]);
    }
    if (low_a - high_b >= reach || low_b - high_a >= reach) return false;
  }
  contact.omega = signed_weights(pair.kind, closest_weights(pair.kind, at));
  const Vector3 between = weighted(contact, x0);
  const double distance = between.norm();
  if (!(distance < reach) || distance == 0) return false;
  contact.gap = std::max(distance - separation, 0.0);
  contact.normal = between / distance;
  return true;
}

Vector3 contact_point(const Contact& contact, const VectorX& q) {
  // The weights of the first element have one sign, and their magnitudes sum to 1.
  const std::size_t of_first = geometry::corners_of_first(contact.pair.kind);
  Vector3 point = Vector3::Zero();
  for (std::size_t c = 0; c < of_first; ++c) point += std::abs(contact.omega[c]) * position(q, contact.particles[c]);
  return point;
}

bool apply_impulse(const Contact& contact, const ImpulseRule& rule, const Displacements& motion) {
  const Vector3& n = contact.normal;
  Vector3 moved = Vector3::Zero(), response = Vector3::Zero();  // response: to a unit impulse along each axis
  for (std::size_t c = 0; c < contact.corners; ++c) {
    const auto at = 3 * static_cast<Eigen::Index>(contact.particles[c]);
    moved += contact.omega[c] * (motion.x1->segment<3>(at) - motion.x0->segment<3>(at));
    response += contact.omega[c] * contact.omega[c] * motion.inverse_mass->segment<3>(at);
  }
  const double k_normal = response.dot(n.cwiseProduct(n));
  if (!(k_normal > 0)) return false;
  const auto apply = [&](const Vector3& impulse, VectorX& to) {
    for (std::size_t c = 0; c < contact.corners; ++c) {
      const auto at = 3 * static_cast<Eigen::Index>(contact.particles[c]);
      to.segment<3>(at) += contact.omega[c] * motion.inverse_mass->segment<3>(at).cwiseProduct(impulse);
    }
  };
  bool changed = false;
  double approach = n.dot(moved);
  if (approach < 0) {
    const double after = approach < -rule.rest ? -rule.restitution * approach : 0;
    const double j = (after - approach) / k_normal;
    Vector3 impulse = j * n;
    if (kFriction && rule.friction > 0) {
      const Vector3 slip = moved - approach * n;
      const double speed = slip.norm();
      if (speed > 0) {
        const Vector3 t = slip / speed;
        impulse -= std::min(speed / response.dot(t.cwiseProduct(t)), rule.friction * j) * t;
      }
    }
    for (std::size_t c = 0; c < contact.corners; ++c) {
      const auto at = 3 * static_cast<Eigen::Index>(contact.particles[c]);
      for (Eigen::Index k = 0; k < 3; ++k) {
        if (motion.driven != nullptr && (*motion.inverse_mass)[at + k] == 0)
          *motion.driven -= contact.omega[c] * impulse[k] * ((*motion.x1)[at + k] - (*motion.x0)[at + k]);
      }
    }
    if (motion.impulses != nullptr) {
      ContactImpulses::add(contact, j * n, motion.impulses->normal);
      ContactImpulses::add(contact, impulse - j * n, motion.impulses->friction);
    }
    apply(impulse, *motion.x1);
    approach = after;
    changed = true;
  }
  const double missing = rule.thickness - (contact.gap + approach);
  if (missing > kMissing * rule.thickness) {
    const Vector3 push = rule.recovery * missing / k_normal * n;
    apply(push, *motion.x1);
    apply(push, *motion.correction);
    changed = true;
  }
  return changed;
}

}  // namespace touchstone::sim
