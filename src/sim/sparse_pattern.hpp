// Which entries a sparse symmetric matrix and its factor L D L^T have: found out once, for any number of matrices.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <vector>

namespace touchstone::sim {

/// Dense blocks that a matrix is the sum of: the unknowns of each, -1 for rows and columns that are left out.
using Blocks = std::vector<std::vector<int>>;

struct SparsePattern {
  SparsePattern(int unknowns, const Blocks& blocks);

  int size;
  /// Of each unknown. Few entries fill up (approximate minimum degree), and of the orders that fill up alike it is the
  /// one in which neighbours depend on each other least: what the processor can overlap stands side by side.
  std::vector<int> numbers;

  /// The matrix's upper triangle, column by column, in these numbers; rows ascend, and the diagonal comes last.
  std::vector<int> first, row;

  /// L's columns below the diagonal, and the columns in which each row of L has an entry, ascending.
  std::vector<int> factor_first, factor_row, left_first, left;

  /// Where the entries of each block are: those of its lower triangle, column by column, without what is left out.
  std::vector<int> places, place_first;

  /// Where the entry of these two unknowns is; -1 when there is none.
  int place(int unknown, int other) const noexcept;

 private:
  void order(const std::vector<std::vector<int>>& blocks);
  void take_matrix(const Blocks& blocks);
  std::vector<int> elimination_tree() const;
  void take_factor();
};

/// Patterns that were met before: the cables of a pile are mostly alike.
class PatternCache {
 public:
  std::shared_ptr<const SparsePattern> get(int unknowns, const Blocks& blocks);

 private:
  std::map<std::pair<int, Blocks>, std::shared_ptr<const SparsePattern>> known_;
};

}  // namespace touchstone::sim
