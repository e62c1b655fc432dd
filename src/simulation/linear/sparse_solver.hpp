// Symmetric positive definite systems: sums of small dense blocks, whose pattern never changes, and of contacts, which
// come and go. Eigen's sparse Cholesky factorises them; those of large sheets are solved by multigrid.
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
  /// @param coordinates  of each unknown: 3 * point + axis, or -1 for an unknown that is no coordinate of a point.
  ///   Empty means that all of them are -1: then no sheet is known as one
  /// @param cancel       is checked in each iteration of conjugate gradients, and lives as long as this
  SparseSolver(int size, Blocks blocks, std::vector<int> coordinates, PatternCache& cache,
               const Cancellation& cancel = Cancellation::never());
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

  /// False when the matrix is known not to be positive definite.
  bool factorise();
  /// By conjugate gradients where there are large sheets, or contacts that do not fit the pattern. Where these find
  /// that the matrix is not positive definite, the solution is a direction along which x^T A x / 2 - right^T x
  /// decreases. Where numbers overflow, the solution is not finite.
  Eigen::VectorXd solve(const Eigen::VectorXd& right);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace touchstone::linear
