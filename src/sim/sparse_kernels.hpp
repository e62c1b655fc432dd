// Arithmetic on matrices of one pattern, `lanes` of them at a time: entry i of matrix l is number lanes * i + l. A
// single chain of a cable's unknowns leaves the processor waiting for each of them; four beside each other do not.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "sim/sparse_pattern.hpp"

namespace touchstone::sim {

template <int lanes>
struct SparseKernels {
  using Lanes = std::conditional_t<lanes == 1, double, Eigen::Array<double, lanes, 1>>;
  static Lanes load(const double* values, int i) {
    if constexpr (lanes == 1) {
      return values[i];
    } else {
      return Eigen::Map<const Lanes>(values + static_cast<std::ptrdiff_t>(i) * lanes);
    }
  }
  static void store(double* values, int i, const Lanes& v) {
    if constexpr (lanes == 1) {
      values[i] = v;
    } else {
      Eigen::Map<Lanes>(values + static_cast<std::ptrdiff_t>(i) * lanes) = v;
    }
  }
  static Lanes zero() {
    if constexpr (lanes == 1) {
      return 0;
    } else {
      return Lanes::Zero();
    }
  }
  static bool is_pivot(const Lanes& v) {
    if constexpr (lanes == 1) {
      return v > 0 && std::isfinite(v);
    } else {
      return (v > 0).all() && v.allFinite();
    }
  }

  /// y = matrix * x.
  static void times(const SparsePattern& pattern, const double* matrix, const double* x, double* y) {
    const int* const row = pattern.row.data();
    for (int c = 0, p = 0; c < pattern.size; ++c) {
      const Lanes own = load(x, c);
      Lanes sum = zero();
      for (const int last = pattern.first[static_cast<std::size_t>(c) + 1] - 1; p < last; ++p) {
        const Lanes entry = load(matrix, p);
        store(y, row[p], load(y, row[p]) + entry * own);
        sum += entry * load(x, row[p]);
      }
      store(y, c, load(matrix, p++) * own + sum);
    }
  }

  /// Makes L in `factor` and 1 / D in `inverse`; `work` has size * lanes zeros, and has them again afterwards unless a
  /// matrix is not positive definite, which is what false says.
  static bool factorise(const SparsePattern& pattern, const double* matrix, double* factor, double* inverse,
                        double* work, std::vector<int>& end) {
    end.assign(pattern.factor_first.begin(), pattern.factor_first.end() - 1);
    const int* const row = pattern.factor_row.data();
    for (int k = 0, p = 0, l = 0; k < pattern.size; ++k) {
      const auto next = static_cast<std::size_t>(k) + 1;
      for (const int last = pattern.first[next] - 1; p < last; ++p) {
        store(work, pattern.row[static_cast<std::size_t>(p)], load(matrix, p));
      }
      Lanes pivot = load(matrix, p++);
      for (; l < pattern.left_first[next]; ++l) {
        const int j = pattern.left[static_cast<std::size_t>(l)];
        const Lanes y = load(work, j);
        store(work, j, zero());
        const int last = end[static_cast<std::size_t>(j)]++;
        for (int i = pattern.factor_first[static_cast<std::size_t>(j)]; i < last; ++i) {
          store(work, row[i], load(work, row[i]) - load(factor, i) * y);
        }
        const Lanes own = y * load(inverse, j);
        pivot -= own * y;
        store(factor, last, own);
      }
      if (!is_pivot(pivot)) return false;
      store(inverse, k, 1 / pivot);
    }
    return true;
  }

  /// x becomes the factorised matrix's inverse times x.
  static void solve(const SparsePattern& pattern, const double* factor, const double* inverse, double* x) {
    const int* const first = pattern.factor_first.data();
    const int* const row = pattern.factor_row.data();
    for (int j = 0; j < pattern.size; ++j) {
      const Lanes own = load(x, j);
      for (int p = first[j]; p < first[j + 1]; ++p) store(x, row[p], load(x, row[p]) - load(factor, p) * own);
    }
    for (int j = pattern.size - 1; j >= 0; --j) {
      Lanes sum = load(x, j) * load(inverse, j);
      for (int p = first[j]; p < first[j + 1]; ++p) sum -= load(factor, p) * load(x, row[p]);
      store(x, j, sum);
    }
  }
};

}  // namespace touchstone::sim
