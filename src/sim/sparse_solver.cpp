// SPDX-License-Identifier: MIT
#include "sim/sparse_solver.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace touchstone::sim {
namespace {

using Blocks = std::vector<std::vector<int>>;
using Keys = std::vector<std::uint64_t>;  // column and row of entries of the lower triangle, ascending

std::uint64_t key(int row, int column) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32 | static_cast<std::uint32_t>(row);
}

Keys keys_of(const Blocks& blocks) {
  Keys keys;
  for (const auto& block : blocks) {
    for (const int column : block) {
      for (const int row : block) {
        if (column >= 0 && row > column) keys.push_back(key(row, column));
      }
    }
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

/// Larger systems keep their pattern when blocks come and go, and what does not fit it is left to conjugate gradients:
/// contacts tie a pile of cables together in such a way that a factor of all of it fills up.
constexpr int kLargestDirect = 1500;
constexpr double kResidual = 1e-4;  // relative: a Newton step needs no more
constexpr int kMostIterations = 400;

constexpr int kLeftOut = -1;  // the upper triangle, and unknowns that are not there
constexpr int kOutside = -2;  // kOutside - n: entry n of those that are not in the pattern

/// Entries of the lower triangle beside the pattern.
struct Outside {
  std::vector<int> row, column;
  std::vector<double> value;
};

/// Where each entry of the blocks is among the keys, column by column.
struct Places {
  std::vector<int> all;
  std::vector<std::size_t> first;  // of each block, and one past the last

  /// @param outside  takes entries that are not among the keys; null when there are none
  void find(const Blocks& blocks, const Keys& keys, Outside* outside = nullptr) {
    all.clear();
    first.clear();
    if (outside != nullptr) *outside = {};
    for (const auto& block : blocks) {
      first.push_back(all.size());
      for (const int c : block) {
        for (const int r : block) {
          if (c < 0 || r < c) {
            all.push_back(kLeftOut);
            continue;
          }
          const auto found = std::lower_bound(keys.begin(), keys.end(), key(r, c));
          if (outside == nullptr || (found != keys.end() && *found == key(r, c))) {
            all.push_back(static_cast<int>(found - keys.begin()));
          } else {
            all.push_back(kOutside - static_cast<int>(outside->row.size()));
            outside->row.push_back(r);
            outside->column.push_back(c);
          }
        }
      }
    }
    first.push_back(all.size());
    if (outside != nullptr) outside->value.assign(outside->row.size(), 0);
  }
};

}  // namespace

struct SparseSolver::Parts {
  using Matrix = Eigen::SparseMatrix<double>;
  Matrix matrix;  // the lower triangle
  Eigen::SimplicialLLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<int>> cholesky;
  Keys keys;
  Places places;
  std::vector<int> diagonal;  // where each row's is among the keys
  Places extra;
  Outside outside;
  std::vector<int> shift;  // from places among the keys to places among the values; empty while they are the same

  void take_pattern(const Keys& entries, int size) {
    matrix.resize(size, size);
    matrix.resizeNonZeros(static_cast<Eigen::Index>(entries.size()));
    int column = -1;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      for (const auto c = static_cast<int>(entries[i] >> 32); column < c;)
        matrix.outerIndexPtr()[++column] = static_cast<int>(i);
      matrix.innerIndexPtr()[i] = static_cast<int>(entries[i] & 0xffffffffu);
    }
    while (column < size) matrix.outerIndexPtr()[++column] = static_cast<int>(entries.size());
    std::fill_n(matrix.valuePtr(), entries.size(), 1.0);
    if (size > 0) cholesky.analyzePattern(matrix);
  }

  Eigen::VectorXd times(const Eigen::VectorXd& x) const {
    Eigen::VectorXd y = matrix.selfadjointView<Eigen::Lower>() * x;
    for (std::size_t i = 0; i < outside.row.size(); ++i) {
      y[outside.row[i]] += outside.value[i] * x[outside.column[i]];
      if (outside.row[i] != outside.column[i]) y[outside.column[i]] += outside.value[i] * x[outside.row[i]];
    }
    return y;
  }

  /// Conjugate gradients, with the factor of what is in the pattern as preconditioner.
  Eigen::VectorXd iterate(const Eigen::VectorXd& right) const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(right.size()), r = right, z = cholesky.solve(r), p = z;
    double rz = r.dot(z);
    const double enough = kResidual * kResidual * rz;
    for (int i = 0; i < kMostIterations && rz > enough; ++i) {
      const Eigen::VectorXd hp = times(p);
      const double curvature = p.dot(hp);
      if (!(curvature > 0)) break;
      const double step = rz / curvature;
      x += step * p;
      r -= step * hp;
      z = cholesky.solve(r);
      const double before = rz;
      rz = r.dot(z);
      p = z + rz / before * p;
    }
    return x;
  }

  int value(int place) const { return shift.empty() ? place : shift[static_cast<std::size_t>(place)]; }
};

SparseSolver::SparseSolver(int size, const Blocks& blocks) : parts_(std::make_unique<Parts>()) {
  Keys& keys = parts_->keys;
  keys = keys_of(blocks);
  Keys diagonal;
  for (int i = 0; i < size; ++i) diagonal.push_back(key(i, i));
  Keys all;
  std::set_union(keys.begin(), keys.end(), diagonal.begin(), diagonal.end(), std::back_inserter(all));
  keys = std::move(all);
  for (const auto entry : diagonal) {
    parts_->diagonal.push_back(static_cast<int>(std::lower_bound(keys.begin(), keys.end(), entry) - keys.begin()));
  }
  parts_->places.find(blocks, keys);
  parts_->take_pattern(keys, size);
}

SparseSolver::~SparseSolver() = default;

void SparseSolver::set_extra(const Blocks& blocks) {
  const Keys& keys = parts_->keys;
  const Keys wanted = keys_of(blocks);
  Keys more;
  std::set_difference(wanted.begin(), wanted.end(), keys.begin(), keys.end(), std::back_inserter(more));
  parts_->outside = {};
  const bool iterative = !more.empty() && size() > kLargestDirect;
  if (more.empty() || iterative) {
    // Contacts with what is pinned couple nothing new: the pattern can stay, or go back to what it was.
    if (!parts_->shift.empty()) {
      parts_->shift.clear();
      parts_->take_pattern(keys, size());
    }
    parts_->extra.find(blocks, keys, iterative ? &parts_->outside : nullptr);
    return;
  }
  Keys all;
  std::merge(keys.begin(), keys.end(), more.begin(), more.end(), std::back_inserter(all));
  parts_->shift.resize(keys.size());
  for (std::size_t i = 0, j = 0; i < keys.size(); ++i) {
    while (j < more.size() && more[j] < keys[i]) ++j;
    parts_->shift[i] = static_cast<int>(i + j);
  }
  parts_->extra.find(blocks, all);
  parts_->take_pattern(all, size());
}

int SparseSolver::size() const noexcept { return static_cast<int>(parts_->diagonal.size()); }

void SparseSolver::clear() {
  std::fill_n(parts_->matrix.valuePtr(), parts_->matrix.nonZeros(), 0.0);
  std::fill(parts_->outside.value.begin(), parts_->outside.value.end(), 0.0);
}

void SparseSolver::add_diagonal(int row, double value) {
  parts_->matrix.valuePtr()[parts_->value(parts_->diagonal[static_cast<std::size_t>(row)])] += value;
}

void SparseSolver::add(std::size_t block, const double* column_major) {
  double* const values = parts_->matrix.valuePtr();
  const std::size_t last = parts_->places.first[block + 1];
  for (std::size_t i = parts_->places.first[block]; i < last; ++i, ++column_major) {
    if (const int place = parts_->places.all[i]; place >= 0) values[parts_->value(place)] += *column_major;
  }
}

void SparseSolver::add_extra(std::size_t block, const double* column_major) {
  double* const values = parts_->matrix.valuePtr();
  const std::size_t last = parts_->extra.first[block + 1];
  for (std::size_t i = parts_->extra.first[block]; i < last; ++i, ++column_major) {
    const int place = parts_->extra.all[i];
    if (place >= 0) {
      values[place] += *column_major;
    } else if (place <= kOutside) {
      parts_->outside.value[static_cast<std::size_t>(kOutside - place)] += *column_major;
    }
  }
}

bool SparseSolver::factorise() {
  parts_->cholesky.factorize(parts_->matrix);
  return parts_->cholesky.info() == Eigen::Success;
}

Eigen::VectorXd SparseSolver::solve(const Eigen::VectorXd& right) const {
  return parts_->outside.row.empty() ? Eigen::VectorXd(parts_->cholesky.solve(right)) : parts_->iterate(right);
}

}  // namespace touchstone::sim
