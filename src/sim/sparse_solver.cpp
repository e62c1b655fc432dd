// SPDX-License-Identifier: MIT
#include "sim/sparse_solver.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace touchstone::sim {

struct SparseSolver::Parts {
  Eigen::SparseMatrix<double> matrix;  // the lower triangle
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::AMDOrdering<int>> cholesky;
  std::vector<int> diagonal;          // where each row's is among the values
  std::vector<std::size_t> first;     // of each block in `places`, and one past the last
  std::vector<int> places;            // of each block's entries among the values, column by column; -1: left out
};

SparseSolver::SparseSolver(int size, const std::vector<std::vector<int>>& blocks) : parts_(std::make_unique<Parts>()) {
  std::vector<std::uint64_t> keys;  // column, row
  const auto key = [](int row, int column) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32 | static_cast<std::uint32_t>(row);
  };
  for (int i = 0; i < size; ++i) keys.push_back(key(i, i));
  for (const auto& block : blocks) {
    for (const int column : block) {
      for (const int row : block) {
        if (column >= 0 && row > column) keys.push_back(key(row, column));
      }
    }
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());

  auto& m = parts_->matrix;
  m.resize(size, size);
  m.resizeNonZeros(static_cast<Eigen::Index>(keys.size()));
  int column = -1;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    for (const auto c = static_cast<int>(keys[i] >> 32); column < c;) m.outerIndexPtr()[++column] = static_cast<int>(i);
    m.innerIndexPtr()[i] = static_cast<int>(keys[i] & 0xffffffffu);
  }
  while (column < size) m.outerIndexPtr()[++column] = static_cast<int>(keys.size());
  std::fill_n(m.valuePtr(), keys.size(), 1.0);

  const auto place = [&](int row, int col) {
    return static_cast<int>(std::lower_bound(keys.begin(), keys.end(), key(row, col)) - keys.begin());
  };
  for (int i = 0; i < size; ++i) parts_->diagonal.push_back(place(i, i));
  for (const auto& block : blocks) {
    parts_->first.push_back(parts_->places.size());
    for (const int c : block) {
      for (const int r : block) parts_->places.push_back(c >= 0 && r >= c ? place(r, c) : -1);
    }
  }
  parts_->first.push_back(parts_->places.size());
  if (size > 0) parts_->cholesky.analyzePattern(m);
}

SparseSolver::~SparseSolver() = default;

int SparseSolver::size() const noexcept { return static_cast<int>(parts_->diagonal.size()); }

void SparseSolver::clear() { std::fill_n(parts_->matrix.valuePtr(), parts_->matrix.nonZeros(), 0.0); }

void SparseSolver::add_diagonal(int row, double value) {
  parts_->matrix.valuePtr()[parts_->diagonal[static_cast<std::size_t>(row)]] += value;
}

void SparseSolver::add(std::size_t block, const double* column_major) {
  double* const values = parts_->matrix.valuePtr();
  const std::size_t last = parts_->first[block + 1];
  for (std::size_t i = parts_->first[block]; i < last; ++i, ++column_major) {
    if (const int place = parts_->places[i]; place >= 0) values[place] += *column_major;
  }
}

bool SparseSolver::factorise() {
  parts_->cholesky.factorize(parts_->matrix);
  return parts_->cholesky.info() == Eigen::Success;
}

Eigen::VectorXd SparseSolver::solve(const Eigen::VectorXd& right) const { return parts_->cholesky.solve(right); }

}  // namespace touchstone::sim
