// SPDX-License-Identifier: MIT
#include "sim/sparse_solver.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include "sim/sparse_kernels.hpp"

namespace touchstone::sim {
namespace {

using Corners = SparseSolver::Corners;
using Vector3 = Eigen::Vector3d;

/// Larger systems keep their pattern when contacts come and go, and what does not fit it is left to conjugate
/// gradients: contacts tie a pile of cables together in such a way that a factor of all of it fills up.
constexpr int kLargestDirect = 300;
constexpr double kResidual = 1e-2;  // relative: on a corner as sharp as friction's, more takes away nothing
constexpr int kMostIterations = 400;

constexpr int kLanes = 4;
constexpr int kNone = -1;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Unknowns that blocks tie together, and nothing else: a matrix of its own.
struct Component {
  std::shared_ptr<const SparsePattern> pattern;
  int batch = 0, lane = 0;
};

/// Matrices of one pattern side by side.
struct Batch {
  std::shared_ptr<const SparsePattern> pattern;
  int lanes = 1;
  std::size_t matrix = 0, factor = 0, vector = 0;  // where its numbers begin
};

/// A contact as conjugate gradients need it: what of it lies beside the matrix's pattern.
struct Tie {
  Corners at{};                          // places in a vector; what is left out is one past the last
  std::array<std::uint8_t, 4> beside{};  // for each corner, the corners (as bits) whose blocks are not in the pattern
  std::array<double, 4> omega{};
  Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
};

Vector3 gathered(const Tie& tie, std::size_t corner, const double* x) {
  const int* const place = tie.at.data() + 3 * corner;
  return {x[place[0]], x[place[1]], x[place[2]]};
}

}  // namespace

struct SparseSolver::Parts {
  int size = 0;
  Blocks blocks;
  PatternCache* cache = nullptr;
  bool with_contacts = false;  // whether the pattern has entries that only contacts need

  std::vector<Component> components;
  std::vector<Batch> batches;
  std::vector<int> component_of, local;  // of each unknown
  std::vector<int> where, diagonal;      // in a vector, and in `matrix`
  struct BlockPlace {
    int component = 0, first = 0;
  };
  std::vector<BlockPlace> block_places;
  std::vector<double> matrix, factor, inverse, work;
  std::vector<int> end;

  std::vector<Tie> ties;
  std::vector<int> contact_places;  // of each contact's entries in `matrix`, pair of corners by pair
  std::vector<std::size_t> contact_first;
  bool beside = false;  // whether any contact has entries beside the pattern

  /// @param known  null when this pattern will not come again
  void take_pattern(const Blocks& all, PatternCache* known);
  void find_components(const Blocks& all, std::vector<Blocks>& local_blocks, std::vector<int>& sizes);
  void make_batches();
  int place(int unknown, int other) const;
  void take_contacts(const std::vector<Corners>& contacts);
  bool factorise();
  void apply_inverse(double* x) const;
  void times(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;
  void iterate(Eigen::VectorXd& right) const;

  bool absent(const Tie& tie, std::size_t corner) const {
    const int* const place = tie.at.data() + 3 * corner;
    return place[0] == size && place[1] == size && place[2] == size;
  }
};

void SparseSolver::Parts::find_components(const Blocks& all, std::vector<Blocks>& local_blocks,
                                          std::vector<int>& sizes) {
  std::vector<int> root(at(size));
  std::iota(root.begin(), root.end(), 0);
  const auto root_of = [&](int i) {
    while (root[at(i)] != i) i = root[at(i)] = root[at(root[at(i)])];
    return i;
  };
  for (const auto& block : all) {
    int before = kNone;
    for (const int i : block) {
      if (i < 0) continue;
      if (before >= 0) {
        const int a = root_of(before), b = root_of(i);
        root[at(std::max(a, b))] = std::min(a, b);
      }
      before = i;
    }
  }
  component_of.assign(at(size), kNone);
  local.assign(at(size), 0);
  sizes.clear();
  for (int i = 0; i < size; ++i) {
    const int r = root_of(i);
    if (r == i) {
      component_of[at(i)] = static_cast<int>(sizes.size());
      sizes.push_back(0);
    }
    component_of[at(i)] = component_of[at(r)];
    local[at(i)] = sizes[at(component_of[at(i)])]++;
  }
  local_blocks.assign(sizes.size(), {});
  block_places.assign(all.size(), {});
  for (std::size_t b = 0; b < all.size(); ++b) {
    const auto first = std::find_if(all[b].begin(), all[b].end(), [](int i) { return i >= 0; });
    if (first == all[b].end()) {
      block_places[b].component = kNone;
      continue;
    }
    Blocks& own = local_blocks[at(component_of[at(*first)])];
    block_places[b] = {component_of[at(*first)], static_cast<int>(own.size())};
    own.push_back(all[b]);
    for (int& i : own.back()) {
      if (i >= 0) i = local[at(i)];
    }
  }
}

void SparseSolver::Parts::take_pattern(const Blocks& all, PatternCache* known) {
  std::vector<Blocks> local_blocks;
  std::vector<int> sizes;
  find_components(all, local_blocks, sizes);
  components.assign(sizes.size(), {});
  for (std::size_t c = 0; c < sizes.size(); ++c) {
    components[c].pattern = known != nullptr ? known->get(sizes[c], local_blocks[c])
                                             : std::make_shared<const SparsePattern>(sizes[c], local_blocks[c]);
  }
  for (BlockPlace& block : block_places) {
    if (block.component != kNone) block.first = components[at(block.component)].pattern->place_first[at(block.first)];
  }
  make_batches();
  where.resize(at(size));
  diagonal.resize(at(size));
  for (std::size_t i = 0; i < where.size(); ++i) {
    const Component& component = components[at(component_of[i])];
    const Batch& batch = batches[at(component.batch)];
    where[i] = static_cast<int>(batch.vector) + component.pattern->numbers[at(local[i])] * batch.lanes + component.lane;
    diagonal[i] = place(static_cast<int>(i), static_cast<int>(i));
  }
}

void SparseSolver::Parts::make_batches() {
  // In the order in which patterns appear: the order of addresses would not be the same in each run.
  std::map<const SparsePattern*, std::size_t> group_of;
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t c = 0; c < components.size(); ++c) {
    const auto [found, fresh] = group_of.try_emplace(components[c].pattern.get(), groups.size());
    if (fresh) groups.emplace_back();
    groups[found->second].push_back(c);
  }
  batches.clear();
  std::size_t entries = 0, factor_entries = 0, unknowns = 0;
  for (const auto& group : groups) {
    for (std::size_t i = 0; i < group.size();) {
      Batch batch;
      batch.pattern = components[group[i]].pattern;
      batch.lanes = group.size() - i >= kLanes ? kLanes : 1;
      batch.matrix = entries;
      batch.factor = factor_entries;
      batch.vector = unknowns;
      for (int lane = 0; lane < batch.lanes; ++lane, ++i) {
        components[group[i]].batch = static_cast<int>(batches.size());
        components[group[i]].lane = lane;
      }
      const auto lanes = at(batch.lanes);
      entries += lanes * batch.pattern->row.size();
      factor_entries += lanes * batch.pattern->factor_row.size();
      unknowns += lanes * at(batch.pattern->size);
      batches.push_back(std::move(batch));
    }
  }
  matrix.assign(entries, 0);
  factor.resize(factor_entries);
  inverse.resize(unknowns);
}

int SparseSolver::Parts::place(int unknown, int other) const {
  if (component_of[at(unknown)] != component_of[at(other)]) return kNone;
  const Component& component = components[at(component_of[at(unknown)])];
  const Batch& batch = batches[at(component.batch)];
  const int found = component.pattern->place(local[at(unknown)], local[at(other)]);
  return found == kNone ? kNone : static_cast<int>(batch.matrix) + found * batch.lanes + component.lane;
}

void SparseSolver::Parts::take_contacts(const std::vector<Corners>& contacts) {
  ties.assign(contacts.size(), {});
  contact_places.clear();
  contact_first.clear();
  beside = false;
  for (std::size_t n = 0; n < contacts.size(); ++n) {
    Tie& tie = ties[n];
    const Corners& unknowns = contacts[n];
    for (std::size_t k = 0; k < 12; ++k) tie.at[k] = unknowns[k] < 0 ? size : where[at(unknowns[k])];
    contact_first.push_back(contact_places.size());
    for (std::size_t a = 0; a < 4; ++a) {
      if (absent(tie, a)) continue;
      for (std::size_t b = a; b < 4; ++b) {
        if (absent(tie, b)) continue;
        for (std::size_t i = 3 * a; i < 3 * a + 3; ++i) {
          for (std::size_t j = a == b ? i : 3 * b; j < 3 * b + 3; ++j) {
            const bool is_there = unknowns[i] >= 0 && unknowns[j] >= 0;
            contact_places.push_back(is_there ? place(unknowns[i], unknowns[j]) : kNone);
            if (!is_there || contact_places.back() != kNone) continue;
            tie.beside[a] = static_cast<std::uint8_t>(tie.beside[a] | 1u << b);
            tie.beside[b] = static_cast<std::uint8_t>(tie.beside[b] | 1u << a);
            beside = true;
          }
        }
      }
    }
  }
  contact_first.push_back(contact_places.size());
}

bool SparseSolver::Parts::factorise() {
  for (const Batch& batch : batches) {
    work.assign(at(batch.lanes) * at(batch.pattern->size), 0);
    const auto run = [&](auto kernels) {
      return kernels.factorise(*batch.pattern, matrix.data() + batch.matrix, factor.data() + batch.factor,
                               inverse.data() + batch.vector, work.data(), end);
    };
    if (!(batch.lanes == kLanes ? run(SparseKernels<kLanes>()) : run(SparseKernels<1>()))) return false;
  }
  return true;
}

void SparseSolver::Parts::apply_inverse(double* x) const {
  for (const Batch& batch : batches) {
    const auto run = [&](auto kernels) {
      kernels.solve(*batch.pattern, factor.data() + batch.factor, inverse.data() + batch.vector, x + batch.vector);
    };
    batch.lanes == kLanes ? run(SparseKernels<kLanes>()) : run(SparseKernels<1>());
  }
}

/// y = the whole matrix times x; both have size + 1 numbers, of which the last one means nothing and is 0 in x.
void SparseSolver::Parts::times(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  for (const Batch& batch : batches) {
    const auto run = [&](auto kernels) {
      kernels.times(*batch.pattern, matrix.data() + batch.matrix, x.data() + batch.vector, y.data() + batch.vector);
    };
    batch.lanes == kLanes ? run(SparseKernels<kLanes>()) : run(SparseKernels<1>());
  }
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
      for (std::size_t i = 0; i < 3; ++i) y[tie.at[3 * a + i]] += tie.omega[a] * pull[static_cast<Eigen::Index>(i)];
    }
  }
  y[size] = 0;
}

/// Conjugate gradients, with the factor of what is in the pattern as preconditioner.
void SparseSolver::Parts::iterate(Eigen::VectorXd& right) const {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(right.size()), &r = right, z = r;
  apply_inverse(z.data());
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
    apply_inverse(z.data());
    const double before = rz;
    rz = r.dot(z);
    p = z + rz / before * p;
  }
  right = std::move(x);
}

SparseSolver::SparseSolver(int size, Blocks blocks, PatternCache& cache) : parts_(std::make_unique<Parts>()) {
  parts_->size = size;
  parts_->blocks = std::move(blocks);
  parts_->cache = &cache;
  parts_->take_pattern(parts_->blocks, &cache);
}

SparseSolver::~SparseSolver() = default;

void SparseSolver::set_contacts(const std::vector<Corners>& contacts) {
  Parts& parts = *parts_;
  parts.take_contacts(contacts);
  const bool more = parts.beside && parts.size <= kLargestDirect;
  if (!more && !parts.with_contacts) return;
  Blocks all = parts.blocks;
  if (more) {
    for (const Corners& corners : contacts) all.emplace_back(corners.begin(), corners.end());
  }
  parts.take_pattern(all, more ? nullptr : parts.cache);
  parts.with_contacts = more;
  parts.take_contacts(contacts);
}

int SparseSolver::size() const noexcept { return parts_->size; }

void SparseSolver::clear() { std::fill(parts_->matrix.begin(), parts_->matrix.end(), 0.0); }

void SparseSolver::add_diagonal(int row, double value) { parts_->matrix[at(parts_->place(row, row))] += value; }

void SparseSolver::add(std::size_t block, const double* column_major) {
  const auto [number, first] = parts_->block_places[block];
  if (number == kNone) return;
  const Component& component = parts_->components[at(number)];
  const Batch& batch = parts_->batches[at(component.batch)];
  double* const values = parts_->matrix.data() + batch.matrix + component.lane;
  const std::vector<int>& unknowns = parts_->blocks[block];
  const int* place = batch.pattern->places.data() + first;
  const std::size_t n = unknowns.size();
  for (std::size_t c = 0; c < n; ++c) {
    if (unknowns[c] < 0) continue;
    for (std::size_t r = c; r < n; ++r) {
      if (unknowns[r] >= 0) values[*place++ * batch.lanes] += column_major[c * n + r];
    }
  }
}

void SparseSolver::add_contact(std::size_t contact, const std::array<double, 4>& omega, const Eigen::Matrix3d& block) {
  Parts& parts = *parts_;
  Tie& tie = parts.ties[contact];
  tie.omega = omega;
  tie.block = block;
  double* const values = parts.matrix.data();
  const int* place = parts.contact_places.data() + parts.contact_first[contact];
  for (std::size_t a = 0; a < 4; ++a) {
    if (parts.absent(tie, a)) continue;
    for (std::size_t b = a; b < 4; ++b) {
      if (parts.absent(tie, b)) continue;
      const double weight = omega[a] * omega[b];
      for (Eigen::Index i = 0; i < 3; ++i) {
        for (Eigen::Index j = a == b ? i : 0; j < 3; ++j) {
          if (*place != kNone) values[*place] += weight * block(i, j);
          ++place;
        }
      }
    }
  }
}

bool SparseSolver::factorise() { return parts_->factorise(); }

Eigen::VectorXd SparseSolver::solve(const Eigen::VectorXd& right) const {
  const Parts& parts = *parts_;
  Eigen::VectorXd x(right.size() + 1);
  for (int i = 0; i < parts.size; ++i) x[parts.where[at(i)]] = right[i];
  x[parts.size] = 0;
  if (parts.beside) {
    parts.iterate(x);
  } else {
    parts.apply_inverse(x.data());
  }
  Eigen::VectorXd solution(right.size());
  for (int i = 0; i < parts.size; ++i) solution[i] = x[parts.where[at(i)]];
  return solution;
}

}  // namespace touchstone::sim
