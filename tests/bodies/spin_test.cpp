// Free spin: the angular momentum in the world's frame is an argument and cannot change; energy, order, and the flip of
// an asymmetric body.
// SPDX-License-Identifier: MIT
#include "bodies/spin.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

const Matrix3 kMoments = Vector3(1, 2, 3).asDiagonal();

/// Euler's equations by the classical Runge-Kutta method, in tiny steps: another method in other variables.
Vector3 own_momentum_after(Vector3 p, double time, int steps) {
  const auto rate = [](const Vector3& x) { return Vector3(x.cross(Vector3(kMoments.inverse() * x))); };
  const double h = time / steps;
  for (int i = 0; i < steps; ++i) {
    const Vector3 a = rate(p), b = rate(p + h / 2 * a), c = rate(p + h / 2 * b), d = rate(p + h * c);
    p += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return p;
}

Quaternion spun(const Inertia& inertia, Quaternion q, const Vector3& momentum, double time, int steps) {
  for (int i = 0; i < steps; ++i) q = free_spin(inertia, q, momentum, time / steps);
  return q;
}

double angle_between(const Quaternion& a, const Quaternion& b) { return turn_between(a, b).norm(); }

}  // namespace

TEST_CASE("a racket flips again and again, and keeps its energy") {
  const Inertia inertia(kMoments);
  const Vector3 momentum(0.001, 2 * 5.0, 0);  // about the middle axis, at 5 rad/s
  Quaternion q{1, 0, 0, 0};
  const double energy = spin_energy(inertia, q, momentum);
  int flips = 0;
  double side = 1, worst = 0, shortest = 0;
  for (int i = 0; i < 60 * 100; ++i) {
    const Quaternion next = free_spin(inertia, q, momentum, 1.0 / 60);
    REQUIRE(dot(q, next) >= 0);
    q = next;
    worst = std::max(worst, std::abs(spin_energy(inertia, q, momentum) / energy - 1));
    shortest = std::max(shortest, std::abs(dot(q, q) - 1));
    const double along = turned_back(q, momentum).y() / momentum.norm();
    if (along * side < -0.9) {
      side = -side;
      ++flips;
    }
  }
  CHECK(flips >= 10);
  CHECK(worst < 1e-12);
  CHECK(shortest < 1e-15 * 4);
}

TEST_CASE("the spin agrees with Euler's equations, and converges with the fourth power of the step") {
  const Inertia inertia(kMoments);
  const Vector3 momentum(0.3, -0.4, 0.5);
  const Quaternion start = rotation_by({0.2, 1.0, -0.6});
  const Vector3 own = own_momentum_after(turned_back(start, momentum), 10, 20'000);
  // Steps that turn it by less than an inner step, so that each is one.
  const Quaternion fine = spun(inertia, start, momentum, 10, 6400);
  CHECK((turned_back(fine, momentum) - own).norm() < 1e-9);
  const double coarse = angle_between(spun(inertia, start, momentum, 10, 200), fine);
  const double half = angle_between(spun(inertia, start, momentum, 10, 400), fine);
  CHECK(half < coarse / 14);
  CHECK(half > coarse / 18);
  CHECK(coarse < 1e-6);
}

TEST_CASE("a body that turns about a principal axis turns evenly") {
  const Inertia inertia(kMoments);
  for (int axis = 0; axis < 3; ++axis) {
    Vector3 momentum = Vector3::Zero();
    momentum[axis] = kMoments(axis, axis) * 0.7;
    const Quaternion q = spun(inertia, {1, 0, 0, 0}, momentum, 1, 100);
    Vector3 turn = Vector3::Zero();
    turn[axis] = 0.7;
    CHECK((turn_between({1, 0, 0, 0}, q) - turn).norm() < 1e-9);
  }
}

TEST_CASE("a body with very different moments keeps its energy, too") {
  const Inertia inertia(Vector3(1e-3, 1, 1.0005).asDiagonal().toDenseMatrix());
  const Vector3 momentum(2e-3, 0.2, -0.1);
  Quaternion q{1, 0, 0, 0};
  const double energy = spin_energy(inertia, q, momentum);
  for (int i = 0; i < 1000; ++i) q = free_spin(inertia, q, momentum, 1e-3);
  CHECK(std::abs(spin_energy(inertia, q, momentum) / energy - 1) < 1e-11);
}

TEST_CASE("turns and orientations are each other's inverse") {
  for (const Vector3& turn : {Vector3(0, 0, 0), Vector3(1e-12, 0, 0), Vector3(0.1, -0.2, 0.3), Vector3(0, 3.1, 0)}) {
    const Quaternion from = rotation_by({0.4, -1, 2});
    CHECK((turn_between(from, product(rotation_by(turn), from)) - turn).norm() < 1e-14);
    const Vector3 x(1, 2, 3);
    const Vector3 expected = turn.norm() > 0 ? Vector3(Eigen::AngleAxisd(turn.norm(), turn.normalized()) * x) : x;
    CHECK((turned(rotation_by(turn), x) - expected).norm() < 1e-14);
  }
}
