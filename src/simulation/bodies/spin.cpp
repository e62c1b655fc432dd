// Euler's equations for the angular momentum P in the body's frame, P' = P x w with w = I^-1 P, by the implicit
// midpoint rule: P1 - P0 = h (Pm x wm), Pm = (P0 + P1) / 2. It keeps each quadratic invariant, so both |P| and the
// energy P . I^-1 P / 2. Written as P1 = (1 + h/2 [wm])^-1 (1 - h/2 [wm]) P0, it is the inverse of the Cayley rotation
// C = cay(h [wm]); so with q1 = q0 C the angular momentum in the world's frame, q P q*, stays as it is (Austin,
// Krishnaprasad and Wang, "Almost Poisson integration of rigid body systems", 1993). As a quaternion C is (1, h wm / 2)
// over its length. Three such steps of lengths g, 1 - 2 g, g with g = 1 / (2 - 2^(1/3)) are of the fourth order
// (Yoshida 1990), and keep what each keeps.
// SPDX-License-Identifier: MIT
#include "bodies/spin.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace touchstone::sim {
namespace {

constexpr double kInnerTurn = 0.05;  // rad: the fixed-point iteration gains a factor of 20 or so each time

Quaternion midpoint_step(const Inertia& inertia, const Quaternion& q, const Vector3& momentum, double h) {
  const Vector3 start = turned_back(q, momentum);
  Vector3 middle = start, velocity = inertia.inverse * middle;
  constexpr int kMostIterations = 60;
  double last = 0;
  for (int i = 0; i < kMostIterations; ++i) {
    const Vector3 next = start + (h / 2) * middle.cross(velocity);
    const double change = (next - middle).lpNorm<Eigen::Infinity>();
    middle = next;
    velocity = inertia.inverse * middle;
    if (change == 0 || (i > 2 && change >= last)) break;  // rounding
    last = change;
  }
  return normalised(product(q, {1, h / 2 * velocity.x(), h / 2 * velocity.y(), h / 2 * velocity.z()}));
}

}  // namespace

Inertia::Inertia(const Matrix3& given) : moments(given), inverse(given.inverse()) {
  inverse = (0.5 * (inverse + inverse.transpose())).eval();
  least = Eigen::SelfAdjointEigenSolver<Matrix3>(given, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

Vector3 angular_velocity(const Inertia& inertia, const Quaternion& q, const Vector3& momentum) {
  return turned(q, inertia.inverse * turned_back(q, momentum));
}

Vector3 angular_momentum(const Inertia& inertia, const Quaternion& q, const Vector3& velocity) {
  return turned(q, inertia.moments * turned_back(q, velocity));
}

double spin_energy(const Inertia& inertia, const Quaternion& q, const Vector3& momentum) {
  const Vector3 own = turned_back(q, momentum);
  return 0.5 * own.dot(inertia.inverse * own);
}

double most_turn(const Inertia& inertia, const Vector3& momentum, double h) {
  return momentum.norm() / inertia.least * h;
}

Quaternion free_spin(const Inertia& inertia, const Quaternion& q, const Vector3& momentum, double h) {
  const double turn = most_turn(inertia, momentum, h);
  if (turn == 0) return q;
  const double substeps = std::max(1.0, std::ceil(turn / kInnerTurn));
  const double step = h / substeps, root = std::cbrt(2.0), outer = 1 / (2 - root);
  Quaternion end = q;
  for (double i = 0; i < substeps; ++i) {
    end = midpoint_step(inertia, end, momentum, outer * step);
    end = midpoint_step(inertia, end, momentum, (1 - 2 * outer) * step);
    end = midpoint_step(inertia, end, momentum, outer * step);
  }
  return dot(q, end) < 0 ? negated(end) : end;
}

}  // namespace touchstone::sim
