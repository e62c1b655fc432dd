// SPDX-License-Identifier: MIT
#include "sim/sparse_solver.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "sim/sparse_cholesky.hpp"

namespace touchstone::sim {
namespace {

using Blocks = std::vector<std::vector<int>>;
using Corners = SparseSolver::Corners;

/// Larger systems keep their pattern when contacts come and go, and what does not fit it is left to conjugate gradients:
/// contacts tie a pile of cables together in such a way that a factor of all of it fills up.
constexpr int kLargestDirect = 300;
constexpr double kResidual = 1e-2;  // relative: on a corner as sharp as friction's, more takes away nothing
constexpr int kMostIterations = 400;

constexpr int kLeftOut = -1;

/// Appends the lower triangle's entries of a block without its diagonal.
template <class Block>
void append_keys(const Block& block, Keys& keys) {
  for (const int column : block) {
    for (const int row : block) {
      if (column >= 0 && row > column) keys.push_back(key(row, column));
    }
  }
}

void make_unique(Keys& keys) {
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
}

/// A contact as conjugate gradients need it: what of it lies beside the matrix's pattern.
struct Tie {
  Corners unknowns;                        // in the matrix's numbering; what is left out is one past the last
  std::array<std::uint8_t, 4> beside{};    // for each corner, the corners (as bits) whose blocks are not in the pattern
  std::array<double, 4> omega{};
  Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
};

using Vector3 = Eigen::Vector3d;

Vector3 gathered(const Tie& tie, std::size_t corner, const double* x) {
  const int* const at = tie.unknowns.data() + 3 * corner;
  return {x[at[0]], x[at[1]], x[at[2]]};
}

}  // namespace

struct SparseSolver::Parts {
  int size = 0;
  std::vector<std::vector<int>> blocks;
  Keys keys;  // of the blocks
  std::vector<int> numbers;
  UpperMatrix matrix;
  SparseCholesky cholesky;
  bool with_contacts = false;  // whether the pattern has entries that only contacts need

  std::vector<int> places;          // of each block's entries: of its lower triangle, without what is left out
  std::vector<std::size_t> first;   // of each block, and one past the last
  std::vector<int> contact_places;  // the same of contacts, pair of corners by pair
  std::vector<std::size_t> contact_first;
  std::vector<Tie> ties;
  bool beside = false;  // whether any contact has entries beside the pattern

  void take_pattern(const Keys& entries) {
    numbers = elimination_numbers(size, entries);
    matrix = matrix_of(size, entries, numbers);
    cholesky.analyse(matrix);
    places.clear();
    first.clear();
    for (const auto& block : blocks) {
      first.push_back(places.size());
      for (std::size_t c = 0; c < block.size(); ++c) {
        for (std::size_t r = c; r < block.size(); ++r) {
          if (block[c] >= 0 && block[r] >= 0) places.push_back(matrix.place(number(block[r]), number(block[c])));
        }
      }
    }
    first.push_back(places.size());
  }

  int number(int unknown) const { return unknown < 0 ? size : numbers[static_cast<std::size_t>(unknown)]; }

  void take_contacts(const std::vector<Corners>& contacts) {
    ties.assign(contacts.size(), {});
    contact_places.clear();
    contact_first.clear();
    beside = false;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      Tie& tie = ties[i];
      for (std::size_t k = 0; k < 12; ++k) tie.unknowns[k] = number(contacts[i][k]);
      contact_first.push_back(contact_places.size());
      for_each_entry(tie, [&](std::size_t a, std::size_t b, int r, int c) {
        const int place = r == size || c == size ? kLeftOut : matrix.place(r, c);
        contact_places.push_back(place);
        if (place != kLeftOut || r == size || c == size) return;
        tie.beside[a] = static_cast<std::uint8_t>(tie.beside[a] | 1u << b);
        tie.beside[b] = static_cast<std::uint8_t>(tie.beside[b] | 1u << a);
        beside = true;
      });
    }
    contact_first.push_back(contact_places.size());
  }

  /// Every entry of the blocks of corners a <= b that can be there, but those of whole blocks that are left out.
  template <class Entry>
  void for_each_entry(const Tie& tie, Entry entry) const {
    for (std::size_t a = 0; a < 4; ++a) {
      if (absent(tie, a)) continue;
      for (std::size_t b = a; b < 4; ++b) {
        if (absent(tie, b)) continue;
        for (std::size_t i = 0; i < 3; ++i) {
          for (std::size_t j = a == b ? i : 0; j < 3; ++j)
            entry(a, b, tie.unknowns[3 * a + i], tie.unknowns[3 * b + j]);
        }
      }
    }
  }
  bool absent(const Tie& tie, std::size_t corner) const {
    const int* const at = tie.unknowns.data() + 3 * corner;
    return at[0] == size && at[1] == size && at[2] == size;
  }

  /// y = the whole matrix times x; both have size + 1 numbers, of which the last one means nothing and is 0 in x.
  void times(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
    matrix.times(x.data(), y.data());
    for (const Tie& tie : ties) {
      Vector3 pull = Vector3::Zero();
      std::uint8_t summed = 0;
      for (std::size_t a = 0; a < 4; ++a) {
        if (tie.beside[a] == 0) continue;
        if (tie.beside[a] != summed) {
          summed = tie.beside[a];
          Vector3 sum = Vector3::Zero();
          for (std::size_t b = 0; b < 4; ++b) {
            if ((summed >> b & 1u) != 0) sum += tie.omega[b] * gathered(tie, b, x.data());
          }
          pull = tie.block * sum;
        }
        for (std::size_t i = 0; i < 3; ++i)
          y[tie.unknowns[3 * a + i]] += tie.omega[a] * pull[static_cast<Eigen::Index>(i)];
      }
    }
    y[size] = 0;
  }

  /// Conjugate gradients, with the factor of what is in the pattern as preconditioner.
  void iterate(Eigen::VectorXd& right) const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(right.size()), &r = right, z = r;
    cholesky.solve(z.data());
    Eigen::VectorXd p = z, hp(right.size());
    double rz = r.dot(z);
    const double enough = kResidual * kResidual * rz;
    for (int i = 0; i < kMostIterations && rz > enough; ++i) {
      times(p, hp);
      const double curvature = p.dot(hp);
      if (!(curvature > 0)) break;
      const double step = rz / curvature;
      x += step * p;
      r -= step * hp;
      z = r;
      cholesky.solve(z.data());
      const double before = rz;
      rz = r.dot(z);
      p = z + rz / before * p;
    }
    right = std::move(x);
  }
};

SparseSolver::SparseSolver(int size, const Blocks& blocks) : parts_(std::make_unique<Parts>()) {
  parts_->size = size;
  parts_->blocks = blocks;
  for (const auto& block : blocks) append_keys(block, parts_->keys);
  make_unique(parts_->keys);
  parts_->take_pattern(parts_->keys);
}

SparseSolver::~SparseSolver() = default;

void SparseSolver::set_contacts(const std::vector<Corners>& contacts) {
  if (size() <= kLargestDirect) {
    Keys wanted, all;
    for (const Corners& corners : contacts) append_keys(corners, wanted);
    make_unique(wanted);
    std::set_union(parts_->keys.begin(), parts_->keys.end(), wanted.begin(), wanted.end(), std::back_inserter(all));
    // Contacts with what is pinned couple nothing new: the pattern can stay, or go back to what it was.
    const bool more = all.size() > parts_->keys.size();
    if (more || parts_->with_contacts) parts_->take_pattern(all);
    parts_->with_contacts = more;
  }
  parts_->take_contacts(contacts);
}

int SparseSolver::size() const noexcept { return parts_->size; }

void SparseSolver::clear() { std::fill(parts_->matrix.value.begin(), parts_->matrix.value.end(), 0.0); }

void SparseSolver::add_diagonal(int row, double value) {
  // Last in its column.
  const auto column = static_cast<std::size_t>(parts_->number(row));
  parts_->matrix.value[static_cast<std::size_t>(parts_->matrix.first[column + 1] - 1)] += value;
}

void SparseSolver::add(std::size_t block, const double* column_major) {
  double* const values = parts_->matrix.value.data();
  const std::vector<int>& unknowns = parts_->blocks[block];
  const int* place = parts_->places.data() + parts_->first[block];
  const std::size_t n = unknowns.size();
  for (std::size_t c = 0; c < n; ++c) {
    if (unknowns[c] < 0) continue;
    for (std::size_t r = c; r < n; ++r) {
      if (unknowns[r] >= 0) values[*place++] += column_major[c * n + r];
    }
  }
}

void SparseSolver::add_contact(std::size_t contact, const std::array<double, 4>& omega, const Eigen::Matrix3d& block) {
  Parts& parts = *parts_;
  Tie& tie = parts.ties[contact];
  tie.omega = omega;
  tie.block = block;
  double* const values = parts.matrix.value.data();
  const int* place = parts.contact_places.data() + parts.contact_first[contact];
  for (std::size_t a = 0; a < 4; ++a) {
    if (parts.absent(tie, a)) continue;
    for (std::size_t b = a; b < 4; ++b) {
      if (parts.absent(tie, b)) continue;
      const double weight = omega[a] * omega[b];
      for (Eigen::Index i = 0; i < 3; ++i) {
        for (Eigen::Index j = a == b ? i : 0; j < 3; ++j) {
          if (*place != kLeftOut) values[*place] += weight * block(i, j);
          ++place;
        }
      }
    }
  }
}

bool SparseSolver::factorise() { return parts_->cholesky.factorise(parts_->matrix); }

Eigen::VectorXd SparseSolver::solve(const Eigen::VectorXd& right) const {
  const Parts& parts = *parts_;
  Eigen::VectorXd x(right.size() + 1);
  for (int i = 0; i < parts.size; ++i) x[parts.number(i)] = right[i];
  x[parts.size] = 0;
  if (parts.beside) {
    parts.iterate(x);
  } else {
    parts.cholesky.solve(x.data());
  }
  Eigen::VectorXd solution(right.size());
  for (int i = 0; i < parts.size; ++i) solution[i] = x[parts.number(i)];
  return solution;
}

}  // namespace touchstone::sim
