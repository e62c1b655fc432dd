// A symmetric matrix that is a sum of dense blocks. Its connected components are factorised apart, by Eigen.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <memory>
#include <vector>

#include "linear/four_doubles.hpp"
#include "linear/sparse_pattern.hpp"
#include "linear/supernodal_factor.hpp"

namespace touchstone::linear {

/// Several components as one block-diagonal matrix. With FourDoubles for numbers, each block stands for four components
/// of one pattern.
template <class Number>
struct Diagonal {
  using Patterns = std::vector<std::shared_ptr<const SparsePattern>>;
  void assemble(const Patterns& patterns);
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
  /// @param cache  null when this pattern will not come again
  void take_pattern(int size, const Blocks& blocks, PatternCache* cache);

  /// The entry of these two unknowns; null when there is none.
  double* entry(int unknown, int other);
  void clear();
  /// @param unknowns  of this block, as they were given
  void add(std::size_t block, const std::vector<int>& unknowns, const double* column_major);
  bool factorise();  ///< false when it is not positive definite

  /// The numbers of all unknowns: first those of components that are solved four by four, then the others. Numbers past
  /// `size` are 0 and mean nothing.
  using Vector = Eigen::Matrix<FourDoubles, Eigen::Dynamic, 1>;
  Vector zero() const {
    return Vector::Constant(fours_.matrix.rows() + alone_.matrix.rows() / FourDoubles::kCount + 1, 0);
  }
  static Eigen::Map<Eigen::VectorXd> numbers(Vector& v) {
    return {v.data()->each.data(), FourDoubles::kCount * v.size()};
  }
  static Eigen::Map<const Eigen::VectorXd> numbers(const Vector& v) {
    return {v.data()->each.data(), FourDoubles::kCount * v.size()};
  }
  int place(int unknown) const { return where_[static_cast<std::size_t>(unknown)]; }  ///< among a vector's numbers

  void apply_inverse(Vector& x) const;

 private:
  struct BlockPlace {
    const int* places = nullptr;  // in the pattern of its component; null when the whole block is left out
    double* values = nullptr;     // of its component
    int stride = 1;               // between them
  };
  Diagonal<FourDoubles> fours_;
  Diagonal<double> alone_;
  std::vector<int> where_;
  std::vector<BlockPlace> blocks_;
  std::vector<std::shared_ptr<const SparsePattern>> patterns_;  // of each component
};

}  // namespace touchstone::linear
