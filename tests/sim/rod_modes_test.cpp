// Second derivatives at rest against theory: the modes of chains and cantilevers, the twist at which a rod leaves its
// axis, the stiffness of a helical spring.
// SPDX-License-Identifier: MIT
#include <Eigen/SVD>

#include <cmath>
#include <numbers>

#include "dynamics/energy_budget.hpp"
#include "sim/sim_scenes.hpp"
#include "support/catch.hpp"

using namespace touchstone::sim;

namespace {

/// The lowest frequency of small motion about a place of rest, rad/s.
double lowest_frequency(const System& system, const State& state) {
  Eigen::MatrixXd matrix = stiffness_matrix(system, state);
  const auto free = free_coordinates(system);
  VectorX weight(matrix.rows());
  for (Eigen::Index i = 0; i < weight.size(); ++i)
    weight[i] = 1 / std::sqrt(system.mass[free[static_cast<std::size_t>(i)]]);
  matrix = weight.asDiagonal() * matrix * weight.asDiagonal();
  return std::sqrt(smallest_eigenvalue(matrix));
}

/// The lowest frequency of a chain of length 1 that hangs from one end, over sqrt(g / L).
double hanging_chain_frequency(Index segments) {
  constexpr double kGravity = 9.81;
  Scene scene;
  scene.settings.gravity = {0, 0, -kGravity};
  scene.settings.newton_tolerance = 1e-10;
  Cable& cable = add_cable(scene, {0, 0, 0}, {0, 0, -1}, segments);
  set_material(cable, 1e10, 0.3, 0.005, 1000);
  cable.bend = cable.twist = 0;
  scene.particles.front().fixed = {true, true, true};
  const System system(scene);
  return lowest_frequency(system, at_rest(system, scene)) / std::sqrt(kGravity);
}

/// The lowest frequency of a cantilever of length 1 with E I = 1 and 0.1 kg.
double cantilever_frequency(Index segments) {
  Scene scene;
  scene.settings.gravity.setZero();
  Cable& cable = add_cable(scene, {0, 0, 0}, {1, 0, 0}, segments);
  cable.radius = 0.005;
  cable.density = 0.1 / (std::numbers::pi * cable.radius * cable.radius);
  cable.stretch = 1e5;
  cable.bend = 1;
  cable.start.clamped = true;
  scene.particles.front().fixed = {true, true, true};
  const System system(scene);
  return lowest_frequency(system, Stepper(system, scene.settings).initial());
}

/// How far from singular the equilibrium of a straight rod of length 1 with hinged ends and E I = 1 is, under a moment
/// about its axis at both ends: the least singular value of its sideways stiffness.
double distance_from_buckling(double moment, Index segments) {
  Scene scene;
  scene.settings.gravity.setZero();
  Cable& cable = add_cable(scene, {0, 0, 0}, {0, 0, 1}, segments);
  cable.radius = 0.01;
  cable.density = 1000;
  cable.stretch = 100;
  cable.bend = 1;
  cable.twist = 0.8;
  const System system(scene);
  State state = Stepper(system, scene.settings).initial();
  const double length = 1.0 / segments;
  for (Index j = 0; j < segments; ++j) state.q[system.angle(j)] = j * moment * length / cable.twist;
  DenseSink sink(system);
  VectorX gradient = VectorX::Zero(state.q.size());
  const Energy energy(system);
  energy.derivatives(state.q, state.frames, 0, energy.elastic(), Hessian::exact, gradient, &sink);
  // A twist angle about a tangent that itself tilts by w = t_x + i t_y is driven by a semi-tangential moment, which
  // leaves E I w' = i M w / 2 at the end (Ziegler, "Principles of Structural Stability", 1968). Greenhill's moment
  // keeps its direction: E I w' = i M w. The other half is added by hand; it has no potential.
  Eigen::MatrixXd matrix = sink.matrix;
  const auto add_half = [&](Index a, Index b, double sign) {
    const double share = sign * 0.5 * moment / (length * length);
    for (const auto& [row, row_sign] : {std::pair(a, -1.0), std::pair(b, 1.0)}) {
      for (const auto& [column, column_sign] : {std::pair(a, -1.0), std::pair(b, 1.0)}) {
        matrix(3 * row, 3 * column + 1) += share * row_sign * column_sign;
        matrix(3 * row + 1, 3 * column) -= share * row_sign * column_sign;
      }
    }
  };
  add_half(segments - 1, segments, 1);
  add_half(0, 1, -1);
  // Sideways only, and between the hinges: about the straight rod the rest decouples.
  const auto count = static_cast<Eigen::Index>(segments - 1);
  Eigen::MatrixXd sideways(2 * count, 2 * count);
  for (Eigen::Index i = 0; i < 2 * count; ++i) {
    for (Eigen::Index j = 0; j < 2 * count; ++j)
      sideways(i, j) = matrix(3 * (1 + i / 2) + i % 2, 3 * (1 + j / 2) + j % 2);
  }
  return Eigen::BDCSVD<Eigen::MatrixXd>(sideways).singularValues().minCoeff();
}

double hinged_buckling_moment(Index segments) {
  // The distance falls to zero and rises again.
  double low = 4, high = 8;
  for (int i = 0; i < 40; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    if (distance_from_buckling(a, segments) < distance_from_buckling(b, segments)) {
      high = b;
    } else {
      low = a;
    }
  }
  const double moment = 0.5 * (low + high);
  CHECK(distance_from_buckling(moment, segments) < 1e-6 * distance_from_buckling(4, segments));
  return moment;
}

constexpr double kCoilRadius = 0.05, kWire = 0.004, kTurns = 6, kPitch = 0.012, kYoung = 2e9, kPoisson = 0.3;

/// Force over elongation of a helix of wire whose ends are clamped, drawn by a hundredth of its length.
double helix_stiffness(Index segments_a_turn) {
  Scene scene;
  scene.settings.gravity.setZero();
  scene.settings.newton_tolerance = 1e-12;
  Cable cable;
  const auto segments = static_cast<Index>(kTurns * segments_a_turn);
  for (Index i = 0; i <= segments; ++i) {
    const double turn = static_cast<double>(i) / segments_a_turn;
    cable.particles.push_back(add_particle(scene,
                                           {kCoilRadius * std::cos(2 * std::numbers::pi * turn),
                                            kCoilRadius * std::sin(2 * std::numbers::pi * turn), kPitch * turn},
                                           0));
  }
  set_material(cable, kYoung, kPoisson, kWire, 1000);
  cable.rest_is_bent = true;
  cable.start.clamped = cable.end.clamped = true;
  scene.cables.push_back(cable);
  scene.particles.front().fixed = {true, true, true};
  const double drawn = 0.01 * kTurns * kPitch;
  const Vector3 end = scene.particles.back().position;
  scene.particles.back().path = {{0, end}, {1, end + Vector3(0, 0, drawn)}};
  const System system(scene);
  const Energies stored = energies(system, at_rest(system, scene));
  return 2 * stored.total() / (drawn * drawn);
}

}  // namespace

TEST_CASE("a hanging chain swings with omega_1 = 1.20241 sqrt(g / L)") {
  // The first zero of the Bessel function J0, halved (Daniel Bernoulli 1732).
  const double coarse = hanging_chain_frequency(10), middle = hanging_chain_frequency(20),
               fine = hanging_chain_frequency(40);
  CAPTURE(coarse, middle, fine);
  CHECK(fine == Approx(1.20241).epsilon(1e-3));
  CHECK(limit_of_second_order(middle, fine) == Approx(1.20241).epsilon(1e-5));
  CHECK(std::log2((coarse - 1.20241) / (middle - 1.20241)) == Approx(2).margin(0.3));
  CHECK(std::log2((coarse - middle) / (middle - fine)) == Approx(2).margin(0.3));
}

TEST_CASE("a cantilever swings with omega_1 = 1.8751^2 sqrt(E I / (rho A L^4))") {
  const double known = 1.8751 * 1.8751 * std::sqrt(1 / 0.1);
  const double coarse = cantilever_frequency(20), fine = cantilever_frequency(40);
  CAPTURE(coarse / known, fine / known);
  CHECK(fine == Approx(known).epsilon(2e-3));
  CHECK(limit_of_second_order(coarse, fine) == Approx(known).epsilon(1e-4));
}

TEST_CASE("a rod with hinged ends buckles under a moment of 2 pi E I / L about its axis") {
  // Greenhill 1883.
  const double coarse = hinged_buckling_moment(24), fine = hinged_buckling_moment(48);
  CAPTURE(coarse, fine);
  CHECK(fine == Approx(2 * std::numbers::pi).epsilon(6e-3));
  CHECK(limit_of_second_order(coarse, fine) == Approx(2 * std::numbers::pi).epsilon(5e-4));
  CHECK(std::log2((coarse - 2 * std::numbers::pi) / (fine - 2 * std::numbers::pi)) == Approx(2).margin(0.2));
}

TEST_CASE("a helical spring's stiffness is G d^4 / (8 D^3 n)") {
  const double wire = 2 * kWire, coil = 2 * kCoilRadius, shear = kYoung / (2 * (1 + kPoisson));
  const double expected = shear * std::pow(wire, 4) / (8 * std::pow(coil, 3) * kTurns);
  const double coarse = helix_stiffness(16), middle = helix_stiffness(32), fine = helix_stiffness(64);
  CAPTURE(coarse / expected, middle / expected, fine / expected);
  // The limit of infinitely many segments. The formula is that of a coil without slope; this one's is 2.2 degrees.
  CHECK(limit_of_second_order(middle, fine) == Approx(expected).epsilon(4e-3));
  CHECK(std::log2((coarse - middle) / (middle - fine)) == Approx(2).margin(0.3));
}
