// A preconditioner for the matrix of a large sheet, at a cost that grows as the sheet does: multigrid by aggregation.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <vector>

#include "linear/sparse_pattern.hpp"

namespace touchstone::linear {

/// An approximate inverse of a symmetric matrix whose unknowns are coordinates of points: a V-cycle with one sweep of
/// Gauss and Seidel over the points forward before it and one backward after it, so that the inverse is symmetric, too.
///
/// A level's points are gathered into aggregates, each a point with all its neighbours, and these are the points of the
/// next level (Vanek, Mandel and Brezina 1996). The interpolation from there is smoothed by the mean over a point's
/// neighbours, which depends on the mesh alone, not on the matrix. The matrix of the next level is P^T A P.
///
/// There are no threads in it, and nothing is kept from one matrix to the next, so that the result is the same in each
/// run and after a checkpoint.
class Multigrid {
 public:
  /// @param coordinates  of each unknown: 3 * point + axis; points may lack axes
  /// @param blocks       the dense blocks whose sum is the matrix: points that share most of them are neighbours
  /// @param first, row   the matrix's upper triangle, column by column; rows ascend
  Multigrid(const std::vector<int>& coordinates, const Blocks& blocks, const int* first, const int* row);

  /// @param values  of the upper triangle  @returns false when this shows that the matrix is not positive definite
  bool set(const double* values);

  /// out = A x
  void multiply(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> out);

  /// x becomes an approximate solution for the right-hand side x. The map is linear, symmetric and positive definite.
  void apply_inverse(Eigen::Ref<Eigen::VectorXd> x);

 private:
  using Block = Eigen::Matrix3d;
  /// Neighbours of points, each point among its own.
  struct Graph {
    std::vector<int> first{0}, to;
    int size() const noexcept { return static_cast<int>(first.size()) - 1; }
  };
  struct Level {
    Graph entries;              // the blocks of the matrix, row by row, columns ascending
    std::vector<int> diagonal;  // of each row, its index in `entries`
    std::vector<int> mirror;    // of each block, the index of the transposed one
    std::vector<Block> values, inverse_diagonal;
    // Of the next level; empty on the last one.
    Graph up;  // the coarse points that each point is interpolated from
    std::vector<double> weights;
    Graph down;  // the points that each coarse point gives to
    std::vector<double> down_weights;

    Eigen::VectorXd x, r;
  };

  static Graph mesh_of(int points, const std::vector<int>& point_of, const Blocks& blocks);
  static void coarsen(Level& level, const Graph& mesh, Graph& coarse_mesh);
  static void find_mirrors(Level& level);
  static Graph product_entries(const Level& level);
  static bool invert_diagonal(Level& level);
  static void take_product(const Level& fine, Level& coarse);
  void cycle(std::size_t number);

  std::vector<int> index_;            // of each unknown, in vectors of the first level
  std::vector<std::size_t> entries_;  // for each entry of the matrix, its number in the first level's blocks
  std::vector<std::size_t> mirrors_;  // and that of the entry across the diagonal
  std::vector<std::size_t> missing_;  // diagonal numbers of axes that points lack
  std::vector<Level> levels_;
  Eigen::LLT<Eigen::MatrixXd> last_;
};

}  // namespace touchstone::linear
