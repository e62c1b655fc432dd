// SPDX-License-Identifier: MIT
#include "body_contact/contact_solver.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace touchstone::sim {
namespace {

Matrix3 cross_matrix(const Vector3& r) {
  Matrix3 m;
  m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return m;
}

/// The relative velocity by an impulse, along the normal and across it.
struct Response {
  double normal = 0;  // 0: nothing of the pair gives way along it
  double across = 0;  // the largest one across the normal
};

Response response_of(const Movers& movers, const BodyContact& contact) {
  Response response;
  const Matrix3 both = movers.response(contact.a) + movers.response(contact.b);
  const Vector3& n = contact.normal;
  response.normal = n.dot(both * n);
  Eigen::Matrix<double, 3, 2> plane;
  plane << n.unitOrthogonal(), n.cross(n.unitOrthogonal());
  const Eigen::Matrix2d two = plane.transpose() * both * plane;
  const double half = (two(0, 0) - two(1, 1)) / 2;
  response.across = two.trace() / 2 + std::sqrt(half * half + two(0, 1) * two(0, 1));
  return response;
}

void apply(Movers& movers, const BodyContact& contact, const Vector3& impulse) {
  movers.apply(contact.a, impulse);
  movers.apply(contact.b, -impulse);
}

}  // namespace

void MovingBody::apply(const Vector3& impulse, const Vector3& arm) noexcept {
  velocity += inverse_mass * impulse;
  spin += inverse_inertia * arm.cross(impulse);
}

Vector3 Movers::velocity(const ContactSide& side) const noexcept {
  if (side.is_body()) {
    const MovingBody& body = bodies[side.body];
    return body.velocity + body.spin.cross(side.arm);
  }
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < side.count; ++i) sum += side.weights[i] * position(particles, side.particles[i]);
  return sum;
}

void Movers::apply(const ContactSide& side, const Vector3& impulse) noexcept {
  if (side.is_body()) {
    bodies[side.body].apply(impulse, side.arm);
    return;
  }
  for (std::size_t i = 0; i < side.count; ++i) {
    const auto at = 3 * static_cast<Eigen::Index>(side.particles[i]);
    particles.segment<3>(at) += side.weights[i] * inverse_mass.segment<3>(at).cwiseProduct(impulse);
  }
}

Matrix3 Movers::response(const ContactSide& side) const noexcept {
  if (side.is_body()) {
    const MovingBody& body = bodies[side.body];
    const Matrix3 arm = cross_matrix(side.arm);
    return body.inverse_mass * Matrix3::Identity() - arm * body.inverse_inertia * arm;
  }
  Matrix3 sum = Matrix3::Zero();
  for (std::size_t i = 0; i < side.count; ++i) {
    const auto at = 3 * static_cast<Eigen::Index>(side.particles[i]);
    sum.diagonal() += side.weights[i] * side.weights[i] * inverse_mass.segment<3>(at);
  }
  return sum;
}

int solve_contacts(Movers& movers, std::vector<SolverContact>& contacts, const SolverRule& rule) {
  std::vector<Response> responses;
  responses.reserve(contacts.size());
  for (SolverContact& c : contacts) {
    responses.push_back(response_of(movers, c.contact));
    c.friction -= c.friction.dot(c.contact.normal) * c.contact.normal;
    apply(movers, c.contact, c.normal_impulse * c.contact.normal + c.friction);
  }
  for (int sweep = 1; sweep <= rule.sweeps; ++sweep) {
    double change = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      SolverContact& c = contacts[i];
      const Response& response = responses[i];
      if (!(response.normal > 0)) continue;
      const Vector3& n = c.contact.normal;
      const Vector3 relative = movers.approach(c.contact);
      const double next = std::max(0.0, c.normal_impulse + (c.least - n.dot(relative)) / response.normal);
      const double along = next - c.normal_impulse;
      c.normal_impulse = next;
      change = std::max(change, std::abs(along) * response.normal);
      if (along != 0) apply(movers, c.contact, along * n);
      if (!(rule.friction > 0) || (next == 0 && c.friction.isZero(0))) continue;
      // One number for both directions across the normal: with the matrix, friction that slips would not settle against
      // the slip.
      if (!(response.across > 0)) continue;
      Vector3 slip = movers.approach(c.contact);
      slip -= slip.dot(n) * n;
      Vector3 friction = c.friction - slip / response.across;
      const double most = rule.friction * next, size = friction.norm();
      if (size > most) friction *= most / size;
      const Vector3 by = friction - c.friction;
      c.friction = friction;
      change = std::max(change, by.norm() * response.normal);
      apply(movers, c.contact, by);
    }
    if (change <= rule.tolerance) return sweep;
  }
  return rule.sweeps;
}

int bounce(Movers& movers, std::vector<SolverContact>& contacts, const BounceRule& rule) {
  // Of bodies that bounce between others for ever the rest is left to the impulses without restitution.
  constexpr int kMostImpacts = 64;
  constexpr double kTogether = 1.0 / 16;  // of the substep
  std::vector<double> room(contacts.size()), along(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    contacts[i].bounce.setZero();
    room[i] = contacts[i].room;
  }
  std::vector<std::size_t> hit;
  std::vector<SolverContact> impact;
  int sweeps = 0;
  double left = rule.h;
  for (int count = 0; count < kMostImpacts; ++count) {
    double first = left;
    const auto time = [&](std::size_t i) { return along[i] < -rule.resting ? room[i] / -along[i] : 2 * left; };
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      along[i] = contacts[i].contact.normal.dot(movers.approach(contacts[i].contact));
      first = std::min(first, time(i));
    }
    if (!(first < left)) break;
    hit.clear();
    impact.clear();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (!(time(i) <= first + kTogether * rule.h) || !(time(i) < left)) continue;
      hit.push_back(i);
      SolverContact& c = impact.emplace_back();
      c.contact = contacts[i].contact;
      c.least = -rule.restitution * along[i];
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) room[i] = std::max(0.0, room[i] + first * along[i]);
    left -= first;
    sweeps += solve_contacts(movers, impact, rule.solver);
    for (std::size_t k = 0; k < hit.size(); ++k) contacts[hit[k]].bounce += impact[k].impulse();
  }
  return sweeps;
}

void solve_pushes(Movers& movers, std::vector<SolverContact>& contacts, int sweeps) {
  std::vector<double> response(contacts.size(), 0);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    response[i] = response_of(movers, contacts[i].contact).normal;
    contacts[i].correction = 0;
  }
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      // A contact that needs no push must not be closed by those of others.
      SolverContact& c = contacts[i];
      if (!(response[i] > 0)) continue;
      const Vector3& n = c.contact.normal;
      const double next = std::max(0.0, c.correction + (c.push - n.dot(movers.approach(c.contact))) / response[i]);
      if (next != c.correction) apply(movers, c.contact, (next - c.correction) * n);
      c.correction = next;
    }
  }
}

}  // namespace touchstone::sim
