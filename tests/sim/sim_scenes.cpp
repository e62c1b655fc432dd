// SPDX-License-Identifier: MIT
#include "sim/sim_scenes.hpp"

#include <Eigen/Eigenvalues>

#include "support/catch.hpp"

namespace touchstone::sim {

DenseSink::DenseSink(const System& system)
    : matrix(Eigen::MatrixXd::Zero(system.size(), system.size())), system_(&system) {}

void DenseSink::stretch(std::size_t element, const Eigen::Matrix3d& block) {
  const Eigen::Index a = 3 * system_->stretch_elements[element].a, b = 3 * system_->stretch_elements[element].b;
  matrix.block<3, 3>(a, a) += block;
  matrix.block<3, 3>(b, b) += block;
  matrix.block<3, 3>(a, b) -= block;
  matrix.block<3, 3>(b, a) -= block;
}

void DenseSink::joint(std::size_t element, const JointMatrix& block) {
  const Joint& j = system_->joints[element];
  std::array<Eigen::Index, 11> at{};
  for (Eigen::Index c = 0; c < 3; ++c) {
    for (std::size_t k = 0; k < 3; ++k)
      at[4 * k + static_cast<std::size_t>(c)] = 3 * static_cast<Eigen::Index>(j.p[k]) + c;
  }
  at[3] = system_->angle(j.e);
  at[7] = system_->angle(j.f);
  for (std::size_t r = 0; r < 11; ++r) {
    for (std::size_t c = 0; c < 11; ++c) matrix(at[r], at[c]) += block(static_cast<int>(r), static_cast<int>(c));
  }
}

namespace {

template <std::size_t N, class Block>
void add_block(const std::array<Index, N>& particles, const Block& block, Eigen::MatrixXd& matrix) {
  for (std::size_t a = 0; a < N; ++a) {
    for (std::size_t b = 0; b < N; ++b) {
      const auto row = static_cast<Eigen::Index>(3 * a), column = static_cast<Eigen::Index>(3 * b);
      matrix.block<3, 3>(3 * static_cast<Eigen::Index>(particles[a]), 3 * static_cast<Eigen::Index>(particles[b])) +=
          block.template block<3, 3>(row, column);
    }
  }
}

}  // namespace

void DenseSink::membrane(std::size_t element, const MembraneMatrix& block) {
  add_block(system_->cloth.membranes[element].p, block, matrix);
}

void DenseSink::hinge(std::size_t element, const HingeMatrix& block) {
  add_block(system_->cloth.hinges[element].p, block, matrix);
}

double smallest_eigenvalue(const Eigen::MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues().minCoeff();
}

Cable& add_cable(Scene& scene, const Vector3& from, const Vector3& to, Index segments) {
  Cable cable;
  for (Index i = 0; i <= segments; ++i) {
    cable.particles.push_back(static_cast<Index>(scene.particles.size()));
    Particle p;
    p.position = from + (to - from) * (static_cast<double>(i) / segments);
    scene.particles.push_back(p);
  }
  scene.cables.push_back(cable);
  return scene.cables.back();
}

State at_rest(const System& system, const Scene& scene) {
  Settings settings = scene.settings;
  settings.integrator = Integrator::implicit_euler;
  Stepper stepper(system, settings);
  State state = stepper.initial();
  double h = 0.2;
  for (int step = 0; step < 200; ++step) {
    const Advance advance = stepper.advance(state, h);
    if (!advance.converged) {
      h /= 4;
      continue;
    }
    const double moved = (advance.state.q - state.q).lpNorm<Eigen::Infinity>();
    state = advance.state;
    state.v.setZero();
    if (moved < 1e-10 && h > 10) return state;
    h = std::min(1e3, h * 1.5);
  }
  FAIL("it does not come to rest");
  return state;
}

State at_rest(const Scene& scene) { return at_rest(System(scene), scene); }

std::vector<Eigen::Index> free_coordinates(const System& system) {
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < system.size(); ++i) {
    if (!system.fixed[static_cast<std::size_t>(i)]) free.push_back(i);
  }
  return free;
}

Eigen::MatrixXd stiffness_matrix(const System& system, const State& state) {
  DenseSink sink(system);
  VectorX gradient = VectorX::Zero(state.q.size());
  const Energy energy(system);
  energy.derivatives(state.q, state.frames, state.time, energy.elastic(), Hessian::exact, gradient, &sink);
  const std::vector<Eigen::Index> free = free_coordinates(system);
  const auto count = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd matrix(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      matrix(i, j) = sink.matrix(free[static_cast<std::size_t>(i)], free[static_cast<std::size_t>(j)]);
    }
  }
  return matrix;
}

}  // namespace touchstone::sim
