// SPDX-License-Identifier: MIT
#include "sim/sparse_pattern.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

// Indices are int, as they are half of the memory; `at` makes them what vectors want.
namespace touchstone::sim {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

SparsePattern::SparsePattern(int unknowns, const Blocks& blocks) : size(unknowns), numbers(at(unknowns)) {
  order(blocks);
  take_matrix(blocks);
  take_factor();
  for (const auto& block : blocks) {
    place_first.push_back(static_cast<int>(places.size()));
    for (std::size_t c = 0; c < block.size(); ++c) {
      for (std::size_t r = c; r < block.size(); ++r) {
        if (block[c] >= 0 && block[r] >= 0) places.push_back(place(block[r], block[c]));
      }
    }
  }
  place_first.push_back(static_cast<int>(places.size()));
}

void SparsePattern::order(const Blocks& blocks) {
  std::iota(numbers.begin(), numbers.end(), 0);
  if (size == 0) return;
  take_matrix(blocks);
  {
    using Matrix = Eigen::SparseMatrix<double>;
    const std::vector<double> values(row.size(), 1);
    const Eigen::Map<const Matrix> upper(size, size, static_cast<Eigen::Index>(row.size()), first.data(), row.data(),
                                         values.data());
    const Matrix full = upper.selfadjointView<Eigen::Upper>();
    Eigen::AMDOrdering<int>::PermutationType permutation;
    Eigen::AMDOrdering<int>()(full, permutation);
    for (int i = 0; i < size; ++i) numbers[at(permutation.indices()[i])] = i;
  }
  take_matrix(blocks);
  // By height above the leaves of the elimination tree: a parent still comes after its children, which is all that the
  // fill depends on.
  const std::vector<int> parent = elimination_tree();
  std::vector<int> height(at(size), 0), by_height(at(size)), renumbered(at(size));
  for (int k = 0; k < size; ++k) {
    if (parent[at(k)] >= 0) height[at(parent[at(k)])] = std::max(height[at(parent[at(k)])], height[at(k)] + 1);
  }
  std::iota(by_height.begin(), by_height.end(), 0);
  std::stable_sort(by_height.begin(), by_height.end(), [&](int a, int b) { return height[at(a)] < height[at(b)]; });
  for (int i = 0; i < size; ++i) renumbered[at(by_height[at(i)])] = i;
  for (int& number : numbers) number = renumbered[at(number)];
}

void SparsePattern::take_matrix(const Blocks& blocks) {
  std::vector<std::uint64_t> entries;  // 2^32 * column + row
  for (int i = 0; i < size; ++i) entries.push_back(static_cast<std::uint64_t>(i) << 32 | static_cast<std::uint64_t>(i));
  for (const auto& block : blocks) {
    for (const int a : block) {
      for (const int b : block) {
        if (a < 0 || b < 0 || numbers[at(a)] >= numbers[at(b)]) continue;
        entries.push_back(static_cast<std::uint64_t>(numbers[at(b)]) << 32 |
                          static_cast<std::uint64_t>(numbers[at(a)]));
      }
    }
  }
  std::sort(entries.begin(), entries.end());
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  first.assign(at(size) + 1, 0);
  row.clear();
  for (const auto entry : entries) {
    row.push_back(static_cast<int>(entry & 0xffffffffu));
    ++first[(entry >> 32) + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
}

/// The parent of each column (Liu 1986); -1 for a root.
std::vector<int> SparsePattern::elimination_tree() const {
  std::vector<int> parent(at(size), -1), ancestor(at(size), -1);
  for (int k = 0; k < size; ++k) {
    for (int p = first[at(k)]; p + 1 < first[at(k) + 1]; ++p) {
      for (int i = row[at(p)]; i != -1 && i < k;) {
        const int next = ancestor[at(i)];
        ancestor[at(i)] = k;
        if (next == -1) parent[at(i)] = k;
        i = next;
      }
    }
  }
  return parent;
}

void SparsePattern::take_factor() {
  const std::vector<int> parent = elimination_tree();
  left_first.assign(1, 0);
  factor_first.assign(at(size) + 1, 0);
  std::vector<int> seen(at(size), -1);
  for (int k = 0; k < size; ++k) {
    // Row k of L reaches from each entry of the matrix up the tree, towards k.
    const auto begin = static_cast<std::ptrdiff_t>(left.size());
    seen[at(k)] = k;
    for (int p = first[at(k)]; p + 1 < first[at(k) + 1]; ++p) {
      for (int i = row[at(p)]; seen[at(i)] != k; i = parent[at(i)]) {
        seen[at(i)] = k;
        left.push_back(i);
        ++factor_first[at(i) + 1];
      }
    }
    std::sort(left.begin() + begin, left.end());
    left_first.push_back(static_cast<int>(left.size()));
  }
  std::partial_sum(factor_first.begin(), factor_first.end(), factor_first.begin());
  factor_row.resize(left.size());
  std::vector<int> end(factor_first.begin(), factor_first.end() - 1);
  for (int k = 0; k < size; ++k) {
    for (int p = left_first[at(k)]; p < left_first[at(k) + 1]; ++p) factor_row[at(end[at(left[at(p)])]++)] = k;
  }
}

int SparsePattern::place(int unknown, int other) const noexcept {
  const int a = numbers[at(unknown)], b = numbers[at(other)];
  const auto begin = row.begin() + first[at(std::max(a, b))], end = row.begin() + first[at(std::max(a, b)) + 1];
  const auto found = std::lower_bound(begin, end, std::min(a, b));
  return found != end && *found == std::min(a, b) ? static_cast<int>(found - row.begin()) : -1;
}

std::shared_ptr<const SparsePattern> PatternCache::get(int unknowns, const Blocks& blocks) {
  auto& known = known_[{unknowns, blocks}];
  if (known == nullptr) known = std::make_shared<const SparsePattern>(unknowns, blocks);
  return known;
}

}  // namespace touchstone::sim
