// The entries of a sparse symmetric matrix and their order, found once for any number of matrices.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

namespace touchstone::linear {

/// An int of these lists as an index.
inline std::size_t at(int i) noexcept { return static_cast<std::size_t>(i); }

/// The dense blocks whose sum is a matrix: the unknowns of each, -1 for rows and columns that are left out.
using Blocks = std::vector<std::vector<int>>;

struct SparsePattern {
  SparsePattern(int unknowns, const Blocks& blocks);

  int size;
  /// The number of each unknown in an order with little fill-in (approximate minimum degree).
  std::vector<int> numbers;

  /// The matrix's upper triangle, column by column, in these numbers; rows ascend, and the diagonal comes last.
  std::vector<int> first, row;

  /// Whether the factor of the matrix is better made of dense blocks than of single entries.
  bool fills_up = false;

  /// Where the entries of each block are: its lower triangle, column by column, without rows and columns left out.
  std::vector<int> block_entries, first_block_entry;

 private:
  void order(const std::vector<std::vector<int>>& blocks);
  void take_matrix(const Blocks& blocks);
};

/// Patterns by their blocks. The cables of a pile are mostly alike, so most patterns come again.
class PatternCache {
 public:
  std::shared_ptr<const SparsePattern> get(int unknowns, const Blocks& blocks);

 private:
  std::map<std::pair<int, Blocks>, std::shared_ptr<const SparsePattern>> known_;
};

}  // namespace touchstone::linear
