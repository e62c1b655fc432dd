// Symmetric positive definite systems whose pattern is known once and for all: a sum of small dense blocks.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace touchstone::sim {

class SparseSolver {
 public:
  /// @param blocks  the unknowns of each block, -1 for rows and columns that are left out
  SparseSolver(int size, const std::vector<std::vector<int>>& blocks);
  ~SparseSolver();
  SparseSolver(const SparseSolver&) = delete;
  SparseSolver& operator=(const SparseSolver&) = delete;

  /// Further blocks, in place of those that were given last time.
  void set_extra(const std::vector<std::vector<int>>& blocks);

  int size() const noexcept;
  void clear();
  void add_diagonal(int row, double value);
  void add(std::size_t block, const double* column_major);  ///< a symmetric block, of the size given at first

  void add_extra(std::size_t block, const double* column_major);

  /// False when the matrix is not positive definite.
  bool factorise();
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace touchstone::sim
