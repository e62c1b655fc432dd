// SPDX-License-Identifier: MIT
#include "sim/sparse_cholesky.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

// Indices are int, as they are half of the memory; `at` makes them what vectors want.
namespace touchstone::sim {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The parent of each column in the elimination tree (Liu 1986); -1 for a root.
std::vector<int> elimination_tree(const UpperMatrix& matrix) {
  std::vector<int> parent(at(matrix.size()), -1), ancestor(at(matrix.size()), -1);
  for (int k = 0; k < matrix.size(); ++k) {
    for (int p = matrix.first[at(k)]; p + 1 < matrix.first[at(k) + 1]; ++p) {
      for (int i = matrix.row[at(p)]; i != -1 && i < k;) {
        const int next = ancestor[at(i)];
        ancestor[at(i)] = k;
        if (next == -1) parent[at(i)] = k;
        i = next;
      }
    }
  }
  return parent;
}

}  // namespace

int UpperMatrix::place(int r, int c) const noexcept {
  const auto begin = row.begin() + first[at(std::max(r, c))], end = row.begin() + first[at(std::max(r, c)) + 1];
  const auto found = std::lower_bound(begin, end, std::min(r, c));
  return found != end && *found == std::min(r, c) ? static_cast<int>(found - row.begin()) : -1;
}

void UpperMatrix::times(const double* x, double* y) const noexcept {
  const int n = size();
  for (int c = 0, p = 0; c < n; ++c) {
    const double own = x[c];
    double sum = 0;
    for (const int last = first[at(c) + 1] - 1; p < last; ++p) {
      const int r = row[at(p)];
      y[r] += value[at(p)] * own;
      sum += value[at(p)] * x[r];
    }
    y[c] = value[at(p++)] * own + sum;
  }
}

UpperMatrix matrix_of(int size, const Keys& entries, const std::vector<int>& numbers) {
  Keys sorted;
  sorted.reserve(entries.size() + at(size));
  for (const auto entry : entries) {
    const int r = numbers[at(static_cast<int>(entry & 0xffffffffu))], c = numbers[at(static_cast<int>(entry >> 32))];
    sorted.push_back(key(std::min(r, c), std::max(r, c)));
  }
  for (int i = 0; i < size; ++i) sorted.push_back(key(i, i));
  std::sort(sorted.begin(), sorted.end());
  UpperMatrix matrix;
  matrix.first.assign(at(size) + 1, 0);
  matrix.row.reserve(sorted.size());
  for (const auto entry : sorted) {
    matrix.row.push_back(static_cast<int>(entry & 0xffffffffu));
    ++matrix.first[(entry >> 32) + 1];
  }
  std::partial_sum(matrix.first.begin(), matrix.first.end(), matrix.first.begin());
  matrix.value.assign(matrix.row.size(), 0);
  return matrix;
}

std::vector<int> elimination_numbers(int size, const Keys& entries) {
  std::vector<int> numbers(at(size));
  if (size == 0) return numbers;
  std::iota(numbers.begin(), numbers.end(), 0);
  {
    const UpperMatrix plain = matrix_of(size, entries, numbers);
    using Pattern = Eigen::SparseMatrix<double>;
    const Eigen::Map<const Pattern> upper(size, size, static_cast<Eigen::Index>(plain.row.size()), plain.first.data(),
                                          plain.row.data(), plain.value.data());
    Pattern full = upper.selfadjointView<Eigen::Upper>();
    Eigen::AMDOrdering<int>::PermutationType order;
    Eigen::AMDOrdering<int>()(full, order);
    for (int i = 0; i < size; ++i) numbers[at(order.indices()[i])] = i;
  }
  // By height above the leaves of the elimination tree: a parent still comes after its children, which is all that the
  // fill depends on.
  const std::vector<int> parent = elimination_tree(matrix_of(size, entries, numbers));
  std::vector<int> height(at(size), 0), order(at(size));
  for (int k = 0; k < size; ++k) {
    if (parent[at(k)] >= 0) height[at(parent[at(k)])] = std::max(height[at(parent[at(k)])], height[at(k)] + 1);
  }
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return height[at(a)] < height[at(b)]; });
  std::vector<int> renumbered(at(size));
  for (int i = 0; i < size; ++i) renumbered[at(order[at(i)])] = i;
  for (int& number : numbers) number = renumbered[at(number)];
  return numbers;
}

void SparseCholesky::analyse(const UpperMatrix& matrix) {
  const int n = matrix.size();
  const std::vector<int> parent = elimination_tree(matrix);
  row_first_.assign(1, 0);
  left_.clear();
  first_.assign(at(n) + 1, 0);
  std::vector<int> seen(at(n), -1);
  for (int k = 0; k < n; ++k) {
    // Row k of L reaches from each entry of the matrix up the tree, towards k.
    const std::size_t begin = left_.size();
    seen[at(k)] = k;
    for (int p = matrix.first[at(k)]; p + 1 < matrix.first[at(k) + 1]; ++p) {
      for (int i = matrix.row[at(p)]; seen[at(i)] != k; i = parent[at(i)]) {
        seen[at(i)] = k;
        left_.push_back(i);
        ++first_[at(i) + 1];
      }
    }
    std::sort(left_.begin() + static_cast<std::ptrdiff_t>(begin), left_.end());
    row_first_.push_back(static_cast<int>(left_.size()));
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  row_.resize(left_.size());
  value_.resize(left_.size());
  inverse_.assign(at(n), 0);
  work_.assign(at(n), 0);
  end_.assign(first_.begin(), first_.end() - 1);
  for (int k = 0; k < n; ++k) {
    for (int p = row_first_[at(k)]; p < row_first_[at(k) + 1]; ++p) row_[at(end_[at(left_[at(p)])]++)] = k;
  }
}

bool SparseCholesky::factorise(const UpperMatrix& matrix) {
  const int n = matrix.size();
  std::copy(first_.begin(), first_.end() - 1, end_.begin());
  for (int k = 0; k < n; ++k) {
    int p = matrix.first[at(k)];
    for (; p + 1 < matrix.first[at(k) + 1]; ++p) work_[at(matrix.row[at(p)])] = matrix.value[at(p)];
    double pivot = matrix.value[at(p)];
    for (int l = row_first_[at(k)]; l < row_first_[at(k) + 1]; ++l) {
      const int j = left_[at(l)];
      const double y = work_[at(j)];
      work_[at(j)] = 0;
      const int end = end_[at(j)]++;
      for (int i = first_[at(j)]; i < end; ++i) work_[at(row_[at(i)])] -= value_[at(i)] * y;
      const double own = y * inverse_[at(j)];
      pivot -= own * y;
      value_[at(end)] = own;
    }
    if (!(pivot > 0) || !std::isfinite(pivot)) return false;
    inverse_[at(k)] = 1 / pivot;
  }
  return true;
}

void SparseCholesky::solve(double* x) const noexcept {
  const int n = static_cast<int>(inverse_.size());
  for (int j = 0; j < n; ++j) {
    const double own = x[j];
    for (int p = first_[at(j)]; p < first_[at(j) + 1]; ++p) x[row_[at(p)]] -= value_[at(p)] * own;
  }
  for (int j = n - 1; j >= 0; --j) {
    double sum = x[j] * inverse_[at(j)];
    for (int p = first_[at(j)]; p < first_[at(j) + 1]; ++p) sum -= value_[at(p)] * x[row_[at(p)]];
    x[j] = sum;
  }
}

}  // namespace touchstone::sim
