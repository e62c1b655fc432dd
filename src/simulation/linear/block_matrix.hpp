// A symmetric matrix that is a sum of dense blocks. Its connected components are factorised apart, by Eigen.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <memory>
#include <vector>

#include "linear/four_doubles.hpp"
#include "linear/multigrid.hpp"
#include "linear/sparse_pattern.hpp"
#include "linear/supernodal_factor.hpp"

namespace touchstone::linear {

/// Several components as one block-diagonal matrix. With FourDoubles for numbers, each block stands for four components
/// of one pattern.
template <class Number>
struct Diagonal {
  using Patterns = std::vector<std::shared_ptr<const SparsePattern>>;
  void assemble(const Patterns& patterns);
  void take_dense();
  double* entry(int row, int column);  ///< null when there is none
  bool factorise();                    ///< false when it is not positive definite
  template <class Vector>
  void apply_inverse(Vector&& x) const;

  Eigen::SparseMatrix<Number> matrix;  ///< the upper triangle, in an order that fills up little
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<Number>, Eigen::Upper, Eigen::NaturalOrdering<int>> factor;
  bool analysed = false;
  std::unique_ptr<SupernodalFactor> dense;  ///< in place of `factor` when that would fill up
};

class BlockMatrix {
 public:
  /// @param coordinates  of each unknown: 3 * point + axis, or -1 for an unknown that is no coordinate of a point; may
  ///   be empty
  /// @param cache        null when this pattern will not come again
  void take_pattern(int size, const Blocks& blocks, const std::vector<int>& coordinates, PatternCache* cache);

  /// The entry of these two unknowns; null when there is none.
  double* entry(int unknown, int other);
  void clear();
  /// @param unknowns  of this block, as they were given
  void add(std::size_t block, const std::vector<int>& unknowns, const double* column_major);
  bool factorise();  ///< false when it is known not to be positive definite

  /// The numbers of all unknowns: first those of components that are solved four by four, then the others, and last
  /// those of large sheets. Numbers past `size` are 0 and mean nothing.
  using Vector = Eigen::Matrix<FourDoubles, Eigen::Dynamic, 1>;
  Vector zero() const {
    const Eigen::Index singles = alone_.matrix.rows() + sheets_.matrix.rows();
    return Vector::Constant(fours_.matrix.rows() + singles / FourDoubles::kCount + 1, 0);
  }
  static Eigen::Map<Eigen::VectorXd> numbers(Vector& v) {
    return {v.data()->each.data(), FourDoubles::kCount * v.size()};
  }
  static Eigen::Map<const Eigen::VectorXd> numbers(const Vector& v) {
    return {v.data()->each.data(), FourDoubles::kCount * v.size()};
  }
  int index_of(int unknown) const { return where_[static_cast<std::size_t>(unknown)]; }  ///< among a vector's numbers

  /// x becomes the solution for the right-hand side x; of large sheets an approximate one, while is_approximate().
  void apply_inverse(Vector& x) const;
  bool is_approximate() const noexcept { return approximate_; }

  /// Sets the numbers of large sheets to those of the matrix times x.
  void multiply_sheets(const Vector& x, Vector& out) const;

  /// Factorises large sheets, too, until the next factorise(). False when the matrix is not positive definite.
  bool factorise_sheets();

 private:
  struct BlockEntries {
    const int* entries = nullptr;  // in the pattern of its component; null when the whole block is left out
    double* values = nullptr;      // of its component
    int stride = 1;                // between them
  };
  Diagonal<FourDoubles> fours_;
  Diagonal<double> alone_, sheets_;
  std::unique_ptr<Multigrid> grid_;  // of sheets_; null when there are none
  bool approximate_ = false;         // whether grid_ stands for the factor of sheets_
  std::vector<int> where_;
  std::vector<BlockEntries> blocks_;
  std::vector<std::shared_ptr<const SparsePattern>> patterns_;  // of each component
};

}  // namespace touchstone::linear
