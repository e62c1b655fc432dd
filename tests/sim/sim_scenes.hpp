// Small scenes, and measurements that several of these tests share.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "dynamics/stepper.hpp"
#include "rods/energy.hpp"
#include "scene/parts.hpp"

namespace touchstone::sim {

/// Collects second derivatives into one dense matrix.
class DenseSink final : public BlockSink {
 public:
  explicit DenseSink(const System& system);
  void stretch(std::size_t element, const Eigen::Matrix3d& block) override;
  void joint(std::size_t element, const JointMatrix& block) override;
  void membrane(std::size_t element, const MembraneMatrix& block) override;
  void hinge(std::size_t element, const HingeMatrix& block) override;

  Eigen::MatrixXd matrix;

 private:
  const System* system_;
};

double smallest_eigenvalue(const Eigen::MatrixXd& symmetric);

/// The state in which the scene comes to rest. The implicit steps are so long that inertia is negligible.
State at_rest(const System& system, const Scene& scene);
State at_rest(const Scene& scene);

/// The second derivatives of the energy in the coordinates that are free. Loads are constant, so they have none.
Eigen::MatrixXd stiffness_matrix(const System& system, const State& state);

/// The coordinates that are free, in the order of the matrix above.
std::vector<Eigen::Index> free_coordinates(const System& system);

/// The limit of infinitely many segments, from the values of n and 2 n of them, when errors fall with their square.
constexpr double limit_of_second_order(double coarse, double fine) { return fine + (fine - coarse) / 3; }

/// A straight cable of n equal segments from `from` to `to`; its particles come after those of the scene.
Cable& add_cable(Scene& scene, const Vector3& from, const Vector3& to, Index segments);

}  // namespace touchstone::sim
