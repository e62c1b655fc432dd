// Which entries a sparse symmetric matrix has, and in which order: found out once, for any number of matrices.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <vector>

namespace touchstone::linear {

/// Dense blocks that a matrix is the sum of: the unknowns of each, -1 for rows and columns that are left out.
using Blocks = std::vector<std::vector<int>>;

struct SparsePattern {
  SparsePattern(int unknowns, const Blocks& blocks);

  int size;
  /// Of each unknown: an order in which few entries fill up (approximate minimum degree).
  std::vector<int> numbers;

  /// The matrix's upper triangle, column by column, in these numbers; rows ascend, and the diagonal comes last.
  std::vector<int> first, row;

  /// Where the entries of each block are: those of its lower triangle, column by column, without what is left out.
  std::vector<int> places, place_first;

 private:
  void order(const std::vector<std::vector<int>>& blocks);
  void take_matrix(const Blocks& blocks);
};

/// Patterns that were met before: the cables of a pile are mostly alike.
class PatternCache {
 public:
  std::shared_ptr<const SparsePattern> get(int unknowns, const Blocks& blocks);

 private:
  std::map<std::pair<int, Blocks>, std::shared_ptr<const SparsePattern>> known_;
};

}  // namespace touchstone::linear
