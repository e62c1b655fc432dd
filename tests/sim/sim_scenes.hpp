// Small scenes, and what several of these tests measure.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "sim/energy.hpp"
#include "sim/scene_parts.hpp"

namespace touchstone::sim {

/// Collects second derivatives into one dense matrix.
class DenseSink final : public BlockSink {
 public:
  explicit DenseSink(const System& system);
  void length(std::size_t element, const Eigen::Matrix3d& block) override;
  void joint(std::size_t element, const JointMatrix& block) override;

  Eigen::MatrixXd matrix;

 private:
  const System* system_;
};

double smallest_eigenvalue(const Eigen::MatrixXd& symmetric);

/// A straight cable of n equal segments from `from` to `to`; its particles come after those of the scene.
Cable& add_cable(Scene& scene, const Vector3& from, const Vector3& to, Index segments);

}  // namespace touchstone::sim
