// SPDX-License-Identifier: MIT
#include "linear/sparse_pattern.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "linear/supernodal_factor.hpp"

// Indices are int, as they are half of the memory; `at` makes std::size_t of them.
namespace touchstone::linear {
namespace {

// Unknowns: the factor of a smaller matrix is quick whatever it is made of.
constexpr int kLeastDense = 400;

}  // namespace

SparsePattern::SparsePattern(int unknowns, const Blocks& blocks) : size(unknowns), numbers(at(unknowns)) {
  order(blocks);
  take_matrix(blocks);
  if (size >= kLeastDense) {
    const FactorSize factor = factor_size(size, first.data(), row.data());
    fills_up = factor.work > SupernodalFactor::kWorkPerEntry * factor.entries;
  }
  const auto entry = [&](int unknown, int other) {
    const auto [low, high] = std::minmax(numbers[at(unknown)], numbers[at(other)]);
    return std::lower_bound(row.begin() + first[at(high)], row.begin() + first[at(high) + 1], low) - row.begin();
  };
  for (const auto& block : blocks) {
    first_block_entry.push_back(static_cast<int>(block_entries.size()));
    for (std::size_t c = 0; c < block.size(); ++c) {
      for (std::size_t r = c; r < block.size(); ++r) {
        if (block[c] >= 0 && block[r] >= 0) block_entries.push_back(static_cast<int>(entry(block[r], block[c])));
      }
    }
  }
  first_block_entry.push_back(static_cast<int>(block_entries.size()));
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

std::shared_ptr<const SparsePattern> PatternCache::get(int unknowns, const Blocks& blocks) {
  auto& known = known_[{unknowns, blocks}];
  if (known == nullptr) known = std::make_shared<const SparsePattern>(unknowns, blocks);
  return known;
}

}  // namespace touchstone::linear
