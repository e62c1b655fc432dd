// The matrix of second derivatives of Newton's method.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "contact/contact_potential.hpp"
#include "linear/sparse_solver.hpp"
#include "rods/energy.hpp"

namespace touchstone::sim {

/// Second derivatives in the free coordinates.
class NewtonMatrix final : public BlockSink {
 public:
  NewtonMatrix(const System& system, linear::PatternCache& cache, const linear::Cancellation& cancel);

  /// The contacts of the next minimisation.
  void set_contacts(std::span<const ContactTerm> contacts);

  int free_count() const noexcept { return solver_->size(); }

  /// Sets the matrix to this diagonal, which has a number for each coordinate.
  void start(const VectorX& diagonal);
  void stretch(std::size_t element, const Eigen::Matrix3d& block) override;
  void joint(std::size_t element, const JointMatrix& block) override;
  void membrane(std::size_t element, const MembraneMatrix& block) override;
  void hinge(std::size_t element, const HingeMatrix& block) override;
  void contact(std::size_t number, const ContactTerm& term, const Eigen::Matrix3d& block) {
    solver_->add_contact(number, term.omega, block);
  }

  /// False when the matrix is known not to be positive definite.
  bool factorise() { return solver_->factorise(); }

  /// -H^-1 gradient, zero in the fixed coordinates; approximate where SparseSolver::solve is.
  VectorX direction(const VectorX& gradient);

 private:
  std::vector<int> free_;  // the unknown of each coordinate, -1 for a fixed one
  std::size_t joint_offset_ = 0, membrane_offset_ = 0, hinge_offset_ = 0;
  std::size_t contact_count_ = 0;
  std::unique_ptr<linear::SparseSolver> solver_;
};

}  // namespace touchstone::sim
