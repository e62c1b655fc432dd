// Symmetric positive definite systems: sums of small dense blocks, whose pattern never changes, and of contacts, which
// come and go. Eigen's sparse Cholesky factorises them.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>
#include <memory>
#include <vector>

#include "linear/cancellation.hpp"
#include "linear/sparse_pattern.hpp"

namespace touchstone::linear {

class SparseSolver {
 public:
  /// @param cancel  is checked in each iteration of conjugate gradients, and lives as long as this
  SparseSolver(int size, Blocks blocks, PatternCache& cache, const Cancellation& cancel = Cancellation::never());
  ~SparseSolver();
  SparseSolver(const SparseSolver&) = delete;
  SparseSolver& operator=(const SparseSolver&) = delete;

  /// The unknowns x, y, z of up to four corners, -1 for a coordinate that is left out.
  using Corners = std::array<int, 12>;
  /// Replaces the contacts.
  void set_contacts(const std::vector<Corners>& contacts);

  int size() const noexcept;
  void clear();
  void add_diagonal(int row, double value);
  void add(std::size_t block, const double* column_major);  ///< a symmetric block, of the size given at first

  /// The block of corners a and b is omega_a omega_b `block`; `block` is symmetric and positive semidefinite. At most
  /// once for a contact between calls of clear().
  void add_contact(std::size_t contact, const std::array<double, 4>& omega, const Eigen::Matrix3d& block);

  /// False when the matrix is not positive definite.
  bool factorise();
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchstone::linear
