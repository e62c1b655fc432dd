// The Cholesky factor of a large sparse matrix whose factor fills up, by dense blocks: the multifrontal method.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace touchstone::linear {

/// L L^T of a symmetric matrix. A supernode is a range of columns of L with nearly the same rows. Its columns are one
/// dense panel, and dense kernels do its work: on a sheet of 20,000 triangles they are four times as fast as loops over
/// single entries. There are no threads in it and no pivots, so that the result is the same in each run.
class SupernodalFactor {
 public:
  /// The work on each entry of a factor, above which dense panels pay (Chen, Davis, Hager and Rajamanickam 2008).
  static constexpr double kWorkPerEntry = 40;

  /// @param first, row  the upper triangle, column by column, in an order that fills up little; rows ascend, and the
  /// diagonal comes last
  SupernodalFactor(int size, const int* first, const int* row);

  /// @param values  of the entries of the pattern  @returns false when the matrix is not positive definite
  bool factorise(const double* values);

  /// x becomes the solution for the right-hand side x.
  void solve_in_place(Eigen::Ref<Eigen::VectorXd> x) const;

  std::size_t entries() const noexcept { return panels_.size(); }

 private:
  struct Supernode {
    int begin = 0, end = 0;     // its columns
    std::size_t panel = 0;      // where its panel begins: rows() by columns() numbers, column by column
    std::size_t first_row = 0;  // in rows_: those below its columns
    std::size_t row_count = 0;
    int parent = -1;
    Eigen::Index columns() const noexcept { return end - begin; }
    Eigen::Index below() const noexcept { return static_cast<Eigen::Index>(row_count); }
  };
  void find_supernodes(const std::vector<int>& parent, const std::vector<int>& count);
  void find_rows(const std::vector<std::vector<int>>& columns);
  void add_update(const Supernode& child, const double* update, const Supernode& parent, double* parent_update);

  int size_;
  std::vector<int> numbers_;                  // of the unknowns, in a postorder of the elimination tree
  std::vector<Supernode> supernodes_;         // children before their parents
  std::vector<int> rows_;                     // below the columns of each supernode, ascending
  std::vector<int> positions_in_parent_;      // of these rows, among the parent's columns and rows
  std::vector<std::size_t> entry_positions_;  // of the matrix's entries, in the panels
  std::vector<double> panels_;
  std::vector<double> stack_;  // of the updates that wait for their parents
};

/// The number of entries of a factor and of multiplications that make it.
struct FactorSize {
  double entries = 0, work = 0;
};
FactorSize factor_size(int size, const int* first, const int* row);

}  // namespace touchstone::linear
