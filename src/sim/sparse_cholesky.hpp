// L D L^T of a sparse symmetric matrix whose pattern stays while its values change.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace touchstone::sim {

/// The upper triangle, column by column; rows ascend, so that the diagonal, which is always there, comes last.
struct UpperMatrix {
  std::vector<int> first;  ///< of each column, and one past the last
  std::vector<int> row;
  std::vector<double> value;

  int size() const noexcept { return static_cast<int>(first.size()) - 1; }

  /// Where the entry of this row and column (or the other way round) is; -1 when the pattern lacks it.
  int place(int row, int column) const noexcept;

  /// y = the symmetric matrix times x, of size() numbers each.
  void times(const double* x, double* y) const noexcept;
};

/// Entries beside the diagonal, as 2^32 * column + row.
using Keys = std::vector<std::uint64_t>;
inline std::uint64_t key(int row, int column) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32 | static_cast<std::uint32_t>(row);
}

/// The pattern of the lower triangle's `entries` when unknown i is renumbered to numbers[i].
UpperMatrix matrix_of(int size, const Keys& entries, const std::vector<int>& numbers);

/// New numbers for the unknowns. Few entries fill up (approximate minimum degree), and of the orders that fill up alike
/// it is the one in which neighbours depend on each other least: what the processor can overlap stands side by side.
std::vector<int> elimination_numbers(int size, const Keys& entries);

class SparseCholesky {
 public:
  /// Takes the pattern.
  void analyse(const UpperMatrix& matrix);

  /// @returns false when the matrix, of that pattern, is not positive definite
  bool factorise(const UpperMatrix& matrix);

  /// x becomes the matrix's inverse times x.
  void solve(double* x) const noexcept;

 private:
  std::vector<int> first_, row_;       // L's columns below the diagonal
  std::vector<int> row_first_, left_;  // the columns in which each row of L has an entry, ascending
  std::vector<double> value_, inverse_;
  std::vector<int> end_;      // of what is known of each column
  std::vector<double> work_;  // zero between calls
};

}  // namespace touchstone::sim
