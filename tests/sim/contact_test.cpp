// The laws of impulses on random contacts, and a contact's normal and weights.
// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>

#include <cmath>

#include <touchstone/solve.hpp>

#include "contact/contact.hpp"
#include "seeded/rng.hpp"
#include "sim/sim_scenes.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::sim;
using touchstone::seeded::Rng;

namespace {

Vector3 random_vector(Rng& random) { return {random.symmetric(), random.symmetric(), random.symmetric()}; }

/// Four particles in motion, as two edges or as a particle and a face, and the system that moves them.
struct Encounter {
  Scene scene;
  Pair pair;

  Encounter(Rng& random, Kind kind) {
    for (int i = 0; i < 4; ++i) {
      Particle p;
      p.position = random_vector(random);
      p.mass = std::exp2(6 * random.symmetric());
      scene.particles.push_back(p);
    }
    if (random.one_in(4)) scene.particles[static_cast<std::size_t>(random.between(0, 3))].fixed = {true, true, true};
    if (kind == Kind::edge_edge) {
      scene.wires = {{0, 1}, {2, 3}};
    } else {
      scene.faces = {{1, 2, 3}};
      scene.wires = {};
    }
    pair = {kind, 0, kind == Kind::edge_edge ? 1u : 0u};
  }
};

struct Sums {
  Vector3 momentum = Vector3::Zero(), angular = Vector3::Zero();
  double kinetic = 0;
};

/// Over a step of one second, so that displacements are velocities; angular momentum about the origin at time t.
Sums sums(const System& system, const VectorX& x0, const VectorX& x1, double t, const VectorX& moved_before) {
  Sums s;
  for (Index p = 0; p < 4; ++p) {
    const double m = system.mass[3 * p];
    const Vector3 v = position(x1, p) - position(x0, p);
    s.momentum += m * v;
    s.angular += m * (position(x0, p) + t * position(moved_before, p)).cross(v);
    s.kinetic += 0.5 * m * v.squaredNorm();
  }
  return s;
}

}  // namespace

TEST_CASE("an impulse reverses the approach, keeps momenta, and takes the energy that the formula says") {
  Rng random(2024);
  int edges = 0, faces = 0, pinned = 0;
  for (int attempt = 0; attempt < 40000 && edges + faces < 1200; ++attempt) {
    const Kind kind = random.one_in(2) ? Kind::edge_edge : Kind::vertex_face;
    const Encounter encounter(random, kind);
    const System system(encounter.scene);
    const Colliders colliders(encounter.scene, system);
    const VectorX x0 = system.initial_position;
    VectorX x1 = x0;
    bool any_pinned = false;
    VectorX inverse_mass = VectorX::Zero(12);
    for (Index p = 0; p < 4; ++p) {
      if (encounter.scene.particles[p].pinned()) {
        any_pinned = true;
        continue;
      }
      x1.segment<3>(3 * p) += 2 * random_vector(random);
      inverse_mass.segment<3>(3 * p).setConstant(1 / system.mass[3 * p]);
    }
    const Answer answer = solve(colliders.query(encounter.pair, x0, x1));
    if (!answer.contact || answer.nature != Nature::crossing || answer.toi == 0) continue;
    const Contact contact = contact_of(colliders, encounter.pair, x0, x1, answer, true);
    // The normal has length 1, is across both elements, and points to the side that they came from.
    CHECK(contact.normal.norm() == Approx(1));
    CHECK(contact.gap > 0);
    double sum = 0;
    Vector3 together = Vector3::Zero();
    VectorX moved = x1 - x0;
    for (std::size_t c = 0; c < 4; ++c) {
      sum += contact.omega[c];
      together += contact.omega[c] *
                  (position(x0, contact.particles[c]) + contact.time * position(moved, contact.particles[c]));
    }
    CHECK(std::abs(sum) < 1e-14);
    CHECK(together.norm() < 1e-10);

    const auto relative = [&](const VectorX& x) {
      Vector3 at = Vector3::Zero();
      for (std::size_t c = 0; c < 4; ++c) at += contact.omega[c] * position(x, contact.particles[c]);
      return at;
    };
    if (kind == Kind::edge_edge) {
      // V'(t) = N . v_rel at the contact, with V = (AB x CD) . AC and N = AB x CD, not of length 1.
      const auto corner = [&](Index p, double t) -> Vector3 { return position(x0, p) + t * position(moved, p); };
      const auto normal = [&](double t) -> Vector3 {
        return (corner(1, t) - corner(0, t)).cross(corner(3, t) - corner(2, t));
      };
      const auto volume = [&](double t) { return normal(t).dot(corner(2, t) - corner(0, t)); };
      const double t = contact.time, step = 1e-5, slope = (volume(t + step) - volume(t - step)) / (2 * step);
      CHECK(normal(t).dot(relative(moved)) == Approx(slope).epsilon(1e-7).margin(1e-7));
    }

    ImpulseRule rule;
    rule.restitution = random.unit();
    rule.thickness = 0;
    const auto normal_speed = [&](const VectorX& end) {
      double speed = 0;
      for (std::size_t c = 0; c < 4; ++c) {
        speed += contact.omega[c] *
                 contact.normal.dot(position(end, contact.particles[c]) - position(x0, contact.particles[c]));
      }
      return speed;
    };
    double k = 0;
    for (std::size_t c = 0; c < 4; ++c)
      k += contact.omega[c] * contact.omega[c] * inverse_mass[3 * contact.particles[c]];
    const double before = normal_speed(x1);
    REQUIRE(before < 0);
    if (!(k > 1e-9)) continue;  // it touches pinned particles only
    const Sums start = sums(system, x0, x1, contact.time, moved);
    VectorX correction = VectorX::Zero(12), after = x1;
    CHECK(apply_impulse(contact, rule, {&x0, &after, &correction, &inverse_mass}));
    const double scale = 1 + std::abs(before) / k;
    CHECK(normal_speed(after) == Approx(-rule.restitution * before).margin(1e-11 * (1 + std::abs(before))));
    const Sums end = sums(system, x0, after, contact.time, moved);
    CHECK(end.kinetic == Approx(start.kinetic - (1 - rule.restitution * rule.restitution) * before * before / (2 * k))
                             .margin(1e-9 * (1 + start.kinetic) * scale));
    CHECK(correction.isZero(0));
    if (any_pinned) {
      ++pinned;
    } else {
      CHECK((end.momentum - start.momentum).norm() < 1e-10 * scale * 10);
      CHECK((end.angular - start.angular).norm() < 1e-9 * scale * 10);
      // About the start positions it changes by -t j (v_rel x n).
      const Vector3 change = sums(system, x0, after, 0, moved).angular - sums(system, x0, x1, 0, moved).angular;
      const double j = -(1 + rule.restitution) * before / k;
      CHECK((change + contact.time * j * relative(moved).cross(contact.normal)).norm() < 1e-9 * scale * 10);
    }
    // Once they separate there is nothing to do.
    const VectorX again = after;
    CHECK_FALSE(apply_impulse(contact, rule, {&x0, &after, &correction, &inverse_mass}));
    CHECK(after == again);
    (kind == Kind::edge_edge ? edges : faces) += 1;
  }
  CHECK(edges > 300);
  CHECK(faces > 100);
  CHECK(pinned > 50);
}

TEST_CASE("friction shrinks the slip by its coefficient times what the normal velocity changes by, in any contact") {
  Rng random(4242);
  int sticks = 0, slides = 0;
  for (int attempt = 0; attempt < 20000 && sticks + slides < 400; ++attempt) {
    const Encounter encounter(random, random.one_in(2) ? Kind::edge_edge : Kind::vertex_face);
    const System system(encounter.scene);
    const Colliders colliders(encounter.scene, system);
    const VectorX x0 = system.initial_position;
    VectorX x1 = x0, inverse_mass = VectorX::Zero(12), correction = VectorX::Zero(12);
    for (Index p = 0; p < 4; ++p) {
      if (encounter.scene.particles[p].pinned()) continue;
      x1.segment<3>(3 * p) += 2 * random_vector(random);
      inverse_mass.segment<3>(3 * p).setConstant(1 / system.mass[3 * p]);
    }
    const Answer answer = solve(colliders.query(encounter.pair, x0, x1));
    if (!answer.contact || answer.nature != Nature::crossing || answer.toi == 0) continue;
    const Contact contact = contact_of(colliders, encounter.pair, x0, x1, answer, true);
    const auto relative = [&](const VectorX& end) {
      Vector3 speed = Vector3::Zero();
      for (std::size_t c = 0; c < 4; ++c)
        speed += contact.omega[c] * (position(end, contact.particles[c]) - position(x0, contact.particles[c]));
      return speed;
    };
    double k = 0;
    for (std::size_t c = 0; c < 4; ++c)
      k += contact.omega[c] * contact.omega[c] * inverse_mass[3 * contact.particles[c]];
    if (!(k > 1e-9)) continue;
    ImpulseRule rule;
    rule.restitution = random.unit();
    rule.friction = random.unit();
    const Vector3 before = relative(x1);
    const double normal = contact.normal.dot(before);
    const Vector3 slip = before - normal * contact.normal;
    VectorX after = x1;
    REQUIRE(apply_impulse(contact, rule, {&x0, &after, &correction, &inverse_mass}));
    const double share = std::max(1 - rule.friction * (1 + rule.restitution) * std::abs(normal) / slip.norm(), 0.0);
    const Vector3 expected = -rule.restitution * normal * contact.normal + share * slip;
    CHECK((relative(after) - expected).norm() < 1e-10 * (1 + before.norm()));
    (share == 0 ? sticks : slides) += 1;
  }
  CHECK(sticks > 50);
  CHECK(slides > 50);
}

TEST_CASE("friction takes at most its coefficient times the normal impulse, and never reverses the slip") {
  // A particle meets a pinned face in the plane z = 0.
  Scene scene;
  scene.particles.resize(4);
  scene.particles[0].position = {0, 0, 0.5};
  scene.particles[0].mass = 2;
  scene.particles[1].position = {-5, -5, 0};
  scene.particles[2].position = {5, -5, 0};
  scene.particles[3].position = {0, 5, 0};
  for (Index p = 1; p < 4; ++p) scene.particles[p].fixed = {true, true, true};
  scene.faces = {{1, 2, 3}};
  const System system(scene);
  const Colliders colliders(scene, system);
  const VectorX x0 = system.initial_position;
  VectorX inverse_mass = VectorX::Zero(12);
  inverse_mass.head<3>().setConstant(0.5);
  for (const double slip : {0.1, 0.59, 0.61, 3.0}) {
    VectorX x1 = x0, correction = VectorX::Zero(12);
    x1.head<3>() += Vector3(slip, 0, -1);
    const Answer answer = solve(colliders.query({Kind::vertex_face, 0, 0}, x0, x1));
    REQUIRE(answer.contact);
    const Contact contact = contact_of(colliders, {Kind::vertex_face, 0, 0}, x0, x1, answer, true);
    ImpulseRule rule;
    rule.restitution = 0.5;
    rule.friction = 0.4;
    apply_impulse(contact, rule, {&x0, &x1, &correction, &inverse_mass});
    CHECK(x1[2] - x0[2] == Approx(0.5));
    CHECK(x1[0] - x0[0] == Approx(std::max(0.0, slip - 0.4 * 1.5)).margin(1e-12));  // |dv_n| = 1.5
  }
}

TEST_CASE("elements nearer than the thickness are pushed apart, without velocity") {
  Scene scene;
  scene.particles.resize(4);
  scene.particles[0].position = {-1, 0, 0};
  scene.particles[1].position = {1, 0, 0};
  scene.particles[2].position = {0, -1, 0.01};
  scene.particles[3].position = {0, 1, 0.01};
  for (Particle& p : scene.particles) p.mass = 1;
  scene.wires = {{0, 1}, {2, 3}};
  const System system(scene);
  const Colliders colliders(scene, system);
  const VectorX x0 = system.initial_position, inverse_mass = VectorX::Ones(12);
  Contact contact;
  CHECK_FALSE(proximity(colliders, {Kind::edge_edge, 0, 1}, x0, 0.0099, contact));
  REQUIRE(proximity(colliders, {Kind::edge_edge, 0, 1}, x0, 0.03, contact));
  CHECK(contact.gap == Approx(0.01));
  CHECK(contact.normal.z() == Approx(1));
  ImpulseRule rule;
  rule.thickness = 0.03;
  rule.recovery = 0.1;
  VectorX x1 = x0, correction = VectorX::Zero(12);
  CHECK(apply_impulse(contact, rule, {&x0, &x1, &correction, &inverse_mass}));
  CHECK(x1[8] - x1[2] == Approx(0.01 + 0.1 * 0.02));
  CHECK((x1 - x0 - correction).lpNorm<Eigen::Infinity>() < 1e-15);
}
