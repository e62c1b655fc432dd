// SPDX-License-Identifier: MIT
#include "linear/sparse_solver.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "linear/block_matrix.hpp"

namespace touchstone::linear {
namespace {

using Corners = SparseSolver::Corners;
using Vector3 = Eigen::Vector3d;

// Unknowns. Larger systems keep their pattern when contacts come and go, and conjugate gradients add the entries that
// do not fit it: contacts tie a pile of cables together so that a factor of the whole fills up.
constexpr int kLargestDirect = 300;
// Relative, of conjugate gradients: the corner of friction is so sharp that a smaller residual saves no iteration of
// Newton's method.
constexpr double kResidual = 1e-2;

// Of conjugate gradients.
constexpr int kMostIterations = 400;
// Of those with multigrid. They take about as long as the factor of a sheet does, which comes then.
constexpr int kMostOfMultigrid = 50;
// The same with contacts beside the pattern. These are in neither the factor nor multigrid, so that the factor would
// save few iterations, and each costs several times as much with it.
constexpr int kMostWithContacts = 200;

using Vector = BlockMatrix::Vector;

/// A contact for conjugate gradients: its blocks that are outside the matrix's pattern.
struct Tie {
  Corners at{};                          // indices in a vector; one past the last for an unknown that is left out
  std::array<std::uint8_t, 4> beside{};  // for each corner, the corners (as bits) whose blocks are not in the pattern
  std::array<double, 4> omega{};
  Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
};

Vector3 gathered(const Tie& tie, std::size_t corner, const double* x) {
  const int* const index = tie.at.data() + 3 * corner;
  return {x[index[0]], x[index[1]], x[index[2]]};
}

}  // namespace

struct SparseSolver::Impl {
  int size = 0;
  Blocks blocks;
  std::vector<int> coordinates;
  PatternCache* cache = nullptr;
  const Cancellation* cancel = nullptr;
  bool with_contacts = false;  // whether the pattern has entries that only contacts need

  BlockMatrix matrix;

  std::vector<Tie> ties;
  std::vector<double*> contact_entries;  // each contact's entries, pair of corners by pair; null where there is none
  std::vector<std::size_t> contact_first;
  bool beside = false;  // whether any contact has entries beside the pattern

  bool fits(const Corners& unknowns, std::size_t a, std::size_t b);
  void take_contacts(const std::vector<Corners>& contacts);
  void add_ties_times(const Vector& in, Vector& out) const;
  void iterate(Vector& right);

  bool absent(const Tie& tie, std::size_t corner) const {
    const int* const index = tie.at.data() + 3 * corner;
    return index[0] == size && index[1] == size && index[2] == size;
  }
};

/// Whether the pattern has every entry of the block of two corners.
bool SparseSolver::Impl::fits(const Corners& unknowns, std::size_t a, std::size_t b) {
  for (std::size_t i = 3 * a; i < 3 * a + 3; ++i) {
    for (std::size_t j = 3 * b; j < 3 * b + 3; ++j) {
      if (unknowns[i] >= 0 && unknowns[j] >= 0 && matrix.entry(unknowns[i], unknowns[j]) == nullptr) return false;
    }
  }
  return true;
}

void SparseSolver::Impl::take_contacts(const std::vector<Corners>& contacts) {
  ties.assign(contacts.size(), {});
  contact_entries.clear();
  contact_first.clear();
  beside = false;
  for (std::size_t n = 0; n < contacts.size(); ++n) {
    Tie& tie = ties[n];
    const Corners& unknowns = contacts[n];
    for (std::size_t k = 0; k < 12; ++k) tie.at[k] = unknowns[k] < 0 ? size : matrix.index_of(unknowns[k]);
    contact_first.push_back(contact_entries.size());
    // The matrix takes groups of corners whose blocks all fit its pattern, so that its part of a contact is positive
    // semidefinite. With a single block of three corners left out it might not be, and the matrix would have no factor.
    std::array<std::uint8_t, 4> together{};  // for each corner, those that go into the matrix with it
    for (std::size_t a = 0; a < 4; ++a) {
      if (absent(tie, a)) continue;
      std::size_t first = 0;
      while (first < a) {
        bool all = together[first] != 0;
        for (std::size_t b = 0; b < a; ++b) {
          if ((together[first] >> b & 1u) != 0) all = all && fits(unknowns, a, b);
        }
        if (all) break;
        ++first;
      }
      const auto group = static_cast<std::uint8_t>((first < a ? together[first] : 0u) | 1u << a);
      for (std::size_t b = 0; b <= a; ++b) {
        if ((group >> b & 1u) != 0) together[b] = group;
      }
    }
    for (std::size_t a = 0; a < 4; ++a) {
      if (absent(tie, a)) continue;
      for (std::size_t b = a; b < 4; ++b) {
        if (absent(tie, b)) continue;
        const bool in = (together[a] >> b & 1u) != 0;
        if (!in) {
          tie.beside[a] = static_cast<std::uint8_t>(tie.beside[a] | 1u << b);
          tie.beside[b] = static_cast<std::uint8_t>(tie.beside[b] | 1u << a);
          beside = true;
        }
        for (std::size_t i = 3 * a; i < 3 * a + 3; ++i) {
          for (std::size_t j = a == b ? i : 3 * b; j < 3 * b + 3; ++j) {
            const bool is_there = in && unknowns[i] >= 0 && unknowns[j] >= 0;
            contact_entries.push_back(is_there ? matrix.entry(unknowns[i], unknowns[j]) : nullptr);
          }
        }
      }
    }
  }
  contact_first.push_back(contact_entries.size());
}

/// y += the contacts' blocks that are beside the pattern, times x.
void SparseSolver::Impl::add_ties_times(const Vector& in, Vector& out) const {
  const double* const x = in.data()->each.data();
  double* const y = out.data()->each.data();
  for (const Tie& tie : ties) {
    Vector3 pull = Vector3::Zero();
    std::uint8_t summed = 0;
    for (std::size_t a = 0; a < 4; ++a) {
      if (tie.beside[a] == 0) continue;
      if (tie.beside[a] != summed) {
        summed = tie.beside[a];
        Vector3 sum = Vector3::Zero();
        for (std::size_t b = 0; b < 4; ++b) {
          if ((summed >> b & 1u) != 0) sum += tie.omega[b] * gathered(tie, b, x);
        }
        pull = tie.block * sum;
      }
      for (std::size_t i = 0; i < 3; ++i) y[tie.at[3 * a + i]] += tie.omega[a] * pull[static_cast<Eigen::Index>(i)];
    }
  }
  y[size] = 0;
}

/// Conjugate gradients, with the factor of the matrix of the pattern as preconditioner. That matrix times z is r, so
/// that its product with a direction follows from that with the direction before, as the direction does. Such a product
/// is as far off as the factor's solution z is, which is the error that a direct solve would have. For a sheet that is
/// not factorised, z is an approximation, and products are taken.
void SparseSolver::Impl::iterate(Vector& right) {
  const auto numbers = [](auto& v) { return BlockMatrix::numbers(v); };
  Vector x = matrix.zero(), z = right;
  auto& r = right;
  matrix.apply_inverse(z);
  Vector p = z, mp = r, hp = x;  // mp: the matrix of the pattern times p; hp: the whole matrix times p
  double rz = numbers(r).dot(numbers(z));
  if (!std::isfinite(rz)) {
    // No iteration would be taken, and a step of length zero would look like convergence.
    numbers(right).setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  const int most_of_multigrid = beside ? kMostWithContacts : kMostOfMultigrid;
  const double enough = kResidual * kResidual * rz;
  for (int i = 0; i < kMostIterations && rz > enough; ++i) {
    cancel->check();
    if (matrix.is_approximate() && i == most_of_multigrid) {
      if (!matrix.factorise_sheets()) break;
      z = r;
      matrix.apply_inverse(z);
      p = z;
      mp = r;
      rz = numbers(r).dot(numbers(z));
    }
    if (matrix.is_approximate()) matrix.multiply_sheets(p, mp);
    hp = mp;
    add_ties_times(p, hp);
    const double curvature = numbers(p).dot(numbers(hp));
    if (!(curvature > 0)) {
      // The whole matrix need not be positive definite where that of the pattern is. The iterate so far leads down. In
      // the first iteration the direction itself does; a step of length zero would look like convergence.
      if (i == 0) x = p;
      break;
    }
    const double step = rz / curvature;
    numbers(x) += step * numbers(p);
    numbers(r) -= step * numbers(hp);
    z = r;
    matrix.apply_inverse(z);
    const double before = rz;
    rz = numbers(r).dot(numbers(z));
    numbers(p) = numbers(z) + rz / before * numbers(p);
    numbers(mp) = numbers(r) + rz / before * numbers(mp);
  }
  right = std::move(x);
}

SparseSolver::SparseSolver(int size, Blocks blocks, std::vector<int> coordinates, PatternCache& cache,
                           const Cancellation& cancel)
    : impl_(std::make_unique<Impl>()) {
  impl_->size = size;
  impl_->blocks = std::move(blocks);
  impl_->coordinates = std::move(coordinates);
  impl_->cache = &cache;
  impl_->cancel = &cancel;
  impl_->matrix.take_pattern(size, impl_->blocks, impl_->coordinates, &cache);
}

SparseSolver::~SparseSolver() = default;

void SparseSolver::set_contacts(const std::vector<Corners>& contacts) {
  Impl& own = *impl_;
  // The pattern may still have entries of earlier contacts.
  if (own.with_contacts) own.matrix.take_pattern(own.size, own.blocks, own.coordinates, own.cache);
  own.take_contacts(contacts);
  own.with_contacts = own.beside && own.size <= kLargestDirect;
  if (!own.with_contacts) return;
  Blocks all = own.blocks;
  for (const Corners& corners : contacts) all.emplace_back(corners.begin(), corners.end());
  own.matrix.take_pattern(own.size, all, own.coordinates, nullptr);
  own.take_contacts(contacts);
}

int SparseSolver::size() const noexcept { return impl_->size; }

void SparseSolver::clear() { impl_->matrix.clear(); }

void SparseSolver::add_diagonal(int row, double value) { *impl_->matrix.entry(row, row) += value; }

void SparseSolver::add(std::size_t block, const double* column_major) {
  impl_->matrix.add(block, impl_->blocks[block], column_major);
}

void SparseSolver::add_contact(std::size_t contact, const std::array<double, 4>& omega, const Eigen::Matrix3d& block) {
  Impl& own = *impl_;
  Tie& tie = own.ties[contact];
  tie.omega = omega;
  tie.block = block;
  double* const* to = own.contact_entries.data() + own.contact_first[contact];
  for (std::size_t a = 0; a < 4; ++a) {
    if (own.absent(tie, a)) continue;
    for (std::size_t b = a; b < 4; ++b) {
      if (own.absent(tie, b)) continue;
      const double weight = omega[a] * omega[b];
      for (Eigen::Index i = 0; i < 3; ++i) {
        for (Eigen::Index j = a == b ? i : 0; j < 3; ++j) {
          if (*to != nullptr) **to += weight * block(i, j);
          ++to;
        }
      }
    }
  }
}

bool SparseSolver::factorise() { return impl_->matrix.factorise(); }

Eigen::VectorXd SparseSolver::solve(const Eigen::VectorXd& right) {
  Impl& own = *impl_;
  Vector vector = own.matrix.zero();
  auto x = BlockMatrix::numbers(vector);
  for (int i = 0; i < own.size; ++i) x[own.matrix.index_of(i)] = right[i];
  if (own.beside || own.matrix.is_approximate()) {
    own.iterate(vector);
  } else {
    own.matrix.apply_inverse(vector);
  }
  Eigen::VectorXd solution(right.size());
  const auto found = BlockMatrix::numbers(vector);
  for (int i = 0; i < own.size; ++i) solution[i] = found[own.matrix.index_of(i)];
  return solution;
}

}  // namespace touchstone::linear
