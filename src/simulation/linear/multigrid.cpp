// SPDX-License-Identifier: MIT
#include "linear/multigrid.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace touchstone::linear {
namespace {

using Vector3 = Eigen::Vector3d;

// Points of the last level, which dense Cholesky factorises: that takes less time than a sweep over a large sheet.
constexpr int kFewest = 40;
// A level with more than this fraction of the points of the one before is not worth its sweeps.
constexpr double kLeastCoarsening = 0.6;
// Points of a last level that is not factorised but swept over, as it could not be coarsened.
constexpr int kMostDense = 400;
// Of the step towards the neighbours' mean that smooths the interpolation. 0.5 to 0.7 need equally many iterations on
// sheets of 2,000 to 20,000 triangles; on one of 80,000 triangles, 0.7 needs seven and 0.5 ten.
constexpr double kSmoothing = 0.7;

auto segment(Eigen::VectorXd& x, int point) { return x.segment<3>(3 * static_cast<Eigen::Index>(point)); }
auto segment(const Eigen::VectorXd& x, int point) { return x.segment<3>(3 * static_cast<Eigen::Index>(point)); }

}  // namespace

Multigrid::Multigrid(const std::vector<int>& coordinates, const Blocks& blocks, const int* first, const int* row) {
  // Points in the order of their numbers, which follows a sheet's rows better than an order with little fill-in.
  const int size = static_cast<int>(coordinates.size());
  std::vector<int> numbers;
  for (const int c : coordinates) numbers.push_back(c / 3);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  const int points = static_cast<int>(numbers.size());
  std::vector<int> point_of;
  for (const int c : coordinates) {
    const auto point = std::lower_bound(numbers.begin(), numbers.end(), c / 3) - numbers.begin();
    point_of.push_back(static_cast<int>(point));
    index_.push_back(3 * point_of.back() + c % 3);
  }

  std::vector<std::uint64_t> pairs;  // 2^32 * point + other
  const auto pair = [](int a, int b) { return static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint64_t>(b); };
  for (int j = 0; j < size; ++j) {
    for (int k = first[j]; k < first[j + 1]; ++k) {
      const int a = point_of[at(row[k])], b = point_of[at(j)];
      pairs.push_back(pair(a, b));
      pairs.push_back(pair(b, a));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  Level level;
  level.entries.first.assign(at(points) + 1, 0);
  for (const auto entry : pairs) {
    ++level.entries.first[(entry >> 32) + 1];
    level.entries.to.push_back(static_cast<int>(entry & 0xffffffffu));
  }
  for (std::size_t i = 0; i < at(points); ++i) level.entries.first[i + 1] += level.entries.first[i];
  const auto number = [&](int a, int axis_a, int b, int axis_b) {
    const auto found = std::lower_bound(pairs.begin(), pairs.end(), pair(a, b)) - pairs.begin();
    return static_cast<std::size_t>(9 * found + 3 * axis_b + axis_a);
  };
  for (int j = 0; j < size; ++j) {
    for (int k = first[j]; k < first[j + 1]; ++k) {
      const int a = index_[at(row[k])], b = index_[at(j)];
      entries_.push_back(number(a / 3, a % 3, b / 3, b % 3));
      mirrors_.push_back(number(b / 3, b % 3, a / 3, a % 3));
    }
  }
  std::vector<bool> there(3 * at(points), false);
  for (const int p : index_) there[at(p)] = true;
  for (int i = 0; i < 3 * points; ++i) {
    if (!there[at(i)]) missing_.push_back(number(i / 3, i % 3, i / 3, i % 3));
  }

  Graph mesh = mesh_of(points, point_of, blocks);
  for (;;) {
    find_mirrors(level);
    const int own = level.entries.size();
    level.values.resize(level.entries.to.size());
    level.inverse_diagonal.resize(at(own));
    level.x.resize(3 * own);
    level.r.resize(3 * own);
    Graph coarse_mesh;
    if (own > kFewest) coarsen(level, mesh, coarse_mesh);
    const bool last = own <= kFewest || coarse_mesh.size() > kLeastCoarsening * own;
    Level next;
    if (last) {
      level.up = level.down = {};
    } else {
      next.entries = product_entries(level);
    }
    levels_.push_back(std::move(level));
    if (last) break;
    level = std::move(next);
    mesh = std::move(coarse_mesh);
  }
}

/// Points are neighbours when they share at least a third as many blocks as they share with their nearest ones. In a
/// mesh of triangles those are the ends of an edge, but not the two corners that only the bending of an edge ties.
Multigrid::Graph Multigrid::mesh_of(int points, const std::vector<int>& point_of, const Blocks& blocks) {
  std::vector<std::uint64_t> pairs;
  for (const auto& block : blocks) {
    std::vector<int> all;
    for (const int i : block) {
      if (i >= 0) all.push_back(point_of[at(i)]);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (const int a : all) {
      for (const int b : all) {
        if (a != b) pairs.push_back(static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint64_t>(b));
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  struct Shared {
    int a, b, count;
  };
  std::vector<Shared> shared;
  std::vector<int> most(at(points), 0);
  for (std::size_t i = 0, end = 0; i < pairs.size(); i = end) {
    while (end < pairs.size() && pairs[end] == pairs[i]) ++end;
    shared.push_back(
        {static_cast<int>(pairs[i] >> 32), static_cast<int>(pairs[i] & 0xffffffffu), static_cast<int>(end - i)});
    most[at(shared.back().a)] = std::max(most[at(shared.back().a)], shared.back().count);
  }
  Graph mesh;
  std::size_t next = 0;
  for (int a = 0; a < points; ++a) {
    mesh.to.push_back(a);
    for (; next < shared.size() && shared[next].a == a; ++next) {
      const auto [own, other, count] = shared[next];
      if (3 * count >= std::min(most[at(own)], most[at(other)])) mesh.to.push_back(other);
    }
    mesh.first.push_back(static_cast<int>(mesh.to.size()));
  }
  return mesh;
}

/// Gathers the points into aggregates, and takes the interpolation from these, and their mesh.
void Multigrid::coarsen(Level& level, const Graph& mesh, Graph& coarse_mesh) {
  const int size = mesh.size();
  std::vector<int> aggregate(at(size), -1), count;
  const auto neighbours = [&](int i) {
    return std::pair(mesh.to.begin() + mesh.first[at(i)], mesh.to.begin() + mesh.first[at(i) + 1]);
  };
  for (int i = 0; i < size; ++i) {
    const auto [begin, end] = neighbours(i);
    if (std::any_of(begin, end, [&](int j) { return aggregate[at(j)] >= 0; })) continue;
    for (auto j = begin; j != end; ++j) aggregate[at(*j)] = static_cast<int>(count.size());
    count.push_back(static_cast<int>(end - begin));
  }
  // The others join the smallest aggregate beside them.
  const std::vector<int> at_first = aggregate;
  for (int i = 0; i < size; ++i) {
    if (aggregate[at(i)] >= 0) continue;
    const auto [begin, end] = neighbours(i);
    int best = -1;
    for (auto j = begin; j != end; ++j) {
      const int there = at_first[at(*j)];
      if (there >= 0 && (best < 0 || std::pair(count[at(there)], there) < std::pair(count[at(best)], best)))
        best = there;
    }
    // There is one: a point beside no aggregate has become one with its neighbours.
    aggregate[at(i)] = best;
    ++count[at(best)];
  }

  std::vector<std::pair<int, double>> own;
  const auto add = [&](int to, double weight) {
    const auto found = std::find_if(own.begin(), own.end(), [&](const auto& one) { return one.first == to; });
    if (found == own.end()) {
      own.emplace_back(to, weight);
    } else {
      found->second += weight;
    }
  };
  const auto coarse = static_cast<int>(count.size());
  std::vector<std::vector<std::pair<int, double>>> down(at(coarse));
  std::vector<std::vector<int>> beside(at(coarse));
  for (int i = 0; i < size; ++i) {
    const auto [begin, end] = neighbours(i);
    const auto others = end - begin - 1;
    own.clear();
    add(aggregate[at(i)], others > 0 ? 1 - kSmoothing : 1);
    for (auto j = begin; j != end; ++j) {
      if (*j != i) add(aggregate[at(*j)], kSmoothing / static_cast<double>(others));
      beside[at(aggregate[at(i)])].push_back(aggregate[at(*j)]);
    }
    for (const auto& [to, weight] : own) {
      level.up.to.push_back(to);
      level.weights.push_back(weight);
      down[at(to)].emplace_back(i, weight);
    }
    level.up.first.push_back(static_cast<int>(level.up.to.size()));
  }
  for (int a = 0; a < coarse; ++a) {
    for (const auto& [from, weight] : down[at(a)]) {
      level.down.to.push_back(from);
      level.down_weights.push_back(weight);
    }
    level.down.first.push_back(static_cast<int>(level.down.to.size()));
    auto& all = beside[at(a)];
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    coarse_mesh.to.insert(coarse_mesh.to.end(), all.begin(), all.end());
    coarse_mesh.first.push_back(static_cast<int>(coarse_mesh.to.size()));
  }
}

void Multigrid::find_mirrors(Level& level) {
  const Graph& entries = level.entries;
  level.mirror.resize(entries.to.size());
  for (int i = 0; i < entries.size(); ++i) {
    for (int k = entries.first[at(i)]; k < entries.first[at(i) + 1]; ++k) {
      const int j = entries.to[at(k)];
      const auto begin = entries.to.begin() + entries.first[at(j)], end = entries.to.begin() + entries.first[at(j) + 1];
      level.mirror[at(k)] = static_cast<int>(std::lower_bound(begin, end, i) - entries.to.begin());
      if (j == i) level.diagonal.push_back(k);
    }
  }
}

/// The blocks of P^T A P.
Multigrid::Graph Multigrid::product_entries(const Level& level) {
  Graph product;
  std::vector<int> seen(at(level.down.size()), -1);
  for (int a = 0; a < level.down.size(); ++a) {
    const auto begin = static_cast<std::ptrdiff_t>(product.to.size());
    for (int d = level.down.first[at(a)]; d < level.down.first[at(a) + 1]; ++d) {
      const int i = level.down.to[at(d)];
      for (int k = level.entries.first[at(i)]; k < level.entries.first[at(i) + 1]; ++k) {
        const int j = level.entries.to[at(k)];
        for (int u = level.up.first[at(j)]; u < level.up.first[at(j) + 1]; ++u) {
          const int b = level.up.to[at(u)];
          if (seen[at(b)] == a) continue;
          seen[at(b)] = a;
          product.to.push_back(b);
        }
      }
    }
    std::sort(product.to.begin() + begin, product.to.end());
    product.first.push_back(static_cast<int>(product.to.size()));
  }
  return product;
}

void Multigrid::take_product(const Level& fine, Level& coarse) {
  std::fill(coarse.values.begin(), coarse.values.end(), Block::Zero());
  std::vector<int> entry_of(at(coarse.entries.size()));
  for (int a = 0; a < coarse.entries.size(); ++a) {
    const int begin = coarse.entries.first[at(a)], end = coarse.entries.first[at(a) + 1];
    for (int k = begin; k < end; ++k) entry_of[at(coarse.entries.to[at(k)])] = k;
    for (int d = fine.down.first[at(a)]; d < fine.down.first[at(a) + 1]; ++d) {
      const int i = fine.down.to[at(d)];
      const double weight = fine.down_weights[at(d)];
      for (int k = fine.entries.first[at(i)]; k < fine.entries.first[at(i) + 1]; ++k) {
        const int j = fine.entries.to[at(k)];
        for (int u = fine.up.first[at(j)]; u < fine.up.first[at(j) + 1]; ++u) {
          const int b = fine.up.to[at(u)];
          if (b >= a) coarse.values[at(entry_of[at(b)])] += weight * fine.weights[at(u)] * fine.values[at(k)];
        }
      }
    }
    for (int k = begin; k < end; ++k) {
      if (coarse.entries.to[at(k)] > a) coarse.values[at(coarse.mirror[at(k)])] = coarse.values[at(k)].transpose();
    }
  }
}

bool Multigrid::invert_diagonal(Level& level) {
  for (std::size_t i = 0; i < level.diagonal.size(); ++i) {
    const Block& own = level.values[at(level.diagonal[i])];
    if (!own.allFinite()) return false;  // the inverse of infinity would be 0
    const Eigen::LLT<Block> factor(own);
    level.inverse_diagonal[i] = factor.solve(Block::Identity());
    if (factor.info() != Eigen::Success || !level.inverse_diagonal[i].allFinite()) return false;
  }
  return true;
}

bool Multigrid::set(const double* values) {
  std::vector<Block>& blocks = levels_.front().values;
  std::fill(blocks.begin(), blocks.end(), Block::Zero());
  double* const numbers = blocks.front().data();
  for (std::size_t k = 0; k < entries_.size(); ++k) numbers[entries_[k]] = numbers[mirrors_[k]] = values[k];
  for (const std::size_t diagonal : missing_) numbers[diagonal] = 1;
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    if (l > 0) take_product(levels_[l - 1], levels_[l]);
    if (!invert_diagonal(levels_[l])) return false;
  }
  const Level& last = levels_.back();
  const int points = last.entries.size();
  if (points > kMostDense) return true;
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * points, 3 * points);
  for (int i = 0; i < points; ++i) {
    for (int k = last.entries.first[at(i)]; k < last.entries.first[at(i) + 1]; ++k) {
      dense.block<3, 3>(3 * i, 3 * last.entries.to[at(k)]) = last.values[at(k)];
    }
  }
  last_.compute(dense);
  return last_.info() == Eigen::Success;
}

void Multigrid::multiply(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> out) {
  Level& level = levels_.front();
  level.x.setZero();
  for (std::size_t i = 0; i < index_.size(); ++i) level.x[index_[i]] = x[static_cast<Eigen::Index>(i)];
  for (int i = 0; i < level.entries.size(); ++i) {
    Vector3 sum = Vector3::Zero();
    for (int k = level.entries.first[at(i)]; k < level.entries.first[at(i) + 1]; ++k) {
      sum += level.values[at(k)] * segment(std::as_const(level.x), level.entries.to[at(k)]);
    }
    segment(level.r, i) = sum;
  }
  for (std::size_t i = 0; i < index_.size(); ++i) out[static_cast<Eigen::Index>(i)] = level.r[index_[i]];
}

void Multigrid::apply_inverse(Eigen::Ref<Eigen::VectorXd> x) {
  Level& level = levels_.front();
  level.r.setZero();
  for (std::size_t i = 0; i < index_.size(); ++i) level.r[index_[i]] = x[static_cast<Eigen::Index>(i)];
  cycle(0);
  for (std::size_t i = 0; i < index_.size(); ++i) x[static_cast<Eigen::Index>(i)] = level.x[index_[i]];
}

/// Solves A x = r on this level, approximately.
void Multigrid::cycle(std::size_t number) {
  Level& level = levels_[number];
  const Graph& entries = level.entries;
  const int size = entries.size();
  const bool last = number + 1 == levels_.size();
  if (last && size <= kMostDense) {
    level.x = last_.solve(level.r);
    return;
  }
  const auto times_x = [&](int begin, int end) {  // these blocks of a row
    Vector3 sum = Vector3::Zero();
    for (int k = begin; k < end; ++k) sum += level.values[at(k)] * segment(std::as_const(level.x), entries.to[at(k)]);
    return sum;
  };
  for (int i = 0; i < size; ++i) {
    const Vector3 rest = segment(level.r, i) - times_x(entries.first[at(i)], level.diagonal[at(i)]);
    segment(level.x, i) = level.inverse_diagonal[at(i)] * rest;
  }
  if (!last) {
    // (L + D) x = r, so that r - A x = -U x.
    Level& next = levels_[number + 1];
    next.r.setZero();
    for (int i = 0; i < size; ++i) {
      const Vector3 rest = times_x(level.diagonal[at(i)] + 1, entries.first[at(i) + 1]);
      for (int u = level.up.first[at(i)]; u < level.up.first[at(i) + 1]; ++u) {
        segment(next.r, level.up.to[at(u)]) -= level.weights[at(u)] * rest;
      }
    }
    cycle(number + 1);
    for (int i = 0; i < size; ++i) {
      Vector3 sum = Vector3::Zero();
      for (int u = level.up.first[at(i)]; u < level.up.first[at(i) + 1]; ++u) {
        sum += level.weights[at(u)] * segment(next.x, level.up.to[at(u)]);
      }
      segment(level.x, i) += sum;
    }
  }
  for (int i = size; i-- > 0;) {
    const Vector3 rest = segment(level.r, i) - times_x(entries.first[at(i)], level.diagonal[at(i)]) -
                         times_x(level.diagonal[at(i)] + 1, entries.first[at(i) + 1]);
    segment(level.x, i) = level.inverse_diagonal[at(i)] * rest;
  }
}

}  // namespace touchstone::linear
