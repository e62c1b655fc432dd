// A partition of the numbers 0, 1, ... into sets, which are joined two by two.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace touchstone::geometry {

class UnionFind {
 public:
  using Index = std::uint32_t;

  explicit UnionFind(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), Index{0}); }

  std::size_t size() const noexcept { return parent_.size(); }

  /// The smallest of those that i has been joined with, itself included.
  Index root(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  /// @returns false when they were joined already
  bool join(Index a, Index b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace touchstone::geometry
