// SPDX-License-Identifier: MIT
#include "linear/block_matrix.hpp"

#include <algorithm>
#include <map>

#include "geometry/union_find.hpp"

namespace touchstone::linear {
namespace {

constexpr int kNone = -1;

// Unknowns of a component whose factor fills up, from which on multigrid takes less time than the factor.
constexpr int kLeastSheet = 3000;

template <class Number>
constexpr int lanes = 1;
template <>
constexpr int lanes<FourDoubles> = FourDoubles::kCount;

double* first_lane(double* value) { return value; }
double* first_lane(FourDoubles* value) { return value->each.data(); }

/// The connected components of the unknowns that blocks tie together.
struct Components {
  std::vector<int> of, local;  // of each unknown: its component, and its number there
  std::vector<int> sizes;
};

Components components_of(int size, const Blocks& blocks) {
  geometry::UnionFind tied(at(size));
  for (const auto& block : blocks) {
    int before = kNone;
    for (const int i : block) {
      if (i < 0) continue;
      if (before >= 0)
        tied.join(static_cast<geometry::UnionFind::Index>(before), static_cast<geometry::UnionFind::Index>(i));
      before = i;
    }
  }
  Components all;
  all.of.resize(at(size));
  for (int i = 0; i < size; ++i) {
    const auto r = static_cast<int>(tied.root(static_cast<geometry::UnionFind::Index>(i)));
    if (r == i) {
      all.of[at(i)] = static_cast<int>(all.sizes.size());
      all.sizes.push_back(0);
    }
    all.of[at(i)] = all.of[at(r)];
    all.local.push_back(all.sizes[at(all.of[at(i)])]++);
  }
  return all;
}

}  // namespace

template <class Number>
void Diagonal<Number>::assemble(const Patterns& patterns) {
  int size = 0, entries = 0;
  for (const auto& pattern : patterns) {
    size += pattern->size;
    entries += static_cast<int>(pattern->row.size());
  }
  matrix.resize(size, size);
  matrix.resizeNonZeros(entries);
  int *end = matrix.outerIndexPtr(), *row = matrix.innerIndexPtr();
  size = entries = 0;
  for (const auto& pattern : patterns) {
    for (auto first = pattern->first.begin() + 1; first != pattern->first.end(); ++first) *++end = entries + *first;
    row = std::transform(pattern->row.begin(), pattern->row.end(), row, [&](int r) { return size + r; });
    size += pattern->size;
    entries += static_cast<int>(pattern->row.size());
  }
  analysed = false;
  dense = nullptr;
}

template <class Number>
void Diagonal<Number>::take_dense() {
  const auto size = static_cast<int>(matrix.rows());
  dense = std::make_unique<SupernodalFactor>(size, matrix.outerIndexPtr(), matrix.innerIndexPtr());
}

template <class Number>
double* Diagonal<Number>::entry(int row, int column) {
  const auto [low, high] = std::minmax(row, column);
  const int* const begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[high];
  const int* const end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[high + 1];
  const int* const found = std::lower_bound(begin, end, low);
  return found != end && *found == low ? first_lane(matrix.valuePtr() + (found - matrix.innerIndexPtr())) : nullptr;
}

template <class Number>
bool Diagonal<Number>::factorise() {
  if (matrix.rows() == 0) return true;
  if (dense) return dense->factorise(first_lane(matrix.valuePtr()));
  if (!analysed) factor.analyzePattern(matrix);
  analysed = true;
  factor.factorize(matrix);
  if (factor.info() != Eigen::Success) return false;
  Eigen::Matrix<Number, Eigen::Dynamic, 1> pivots = factor.vectorD();
  const Eigen::Map<const Eigen::ArrayXd> all(first_lane(pivots.data()), pivots.size() * lanes<Number>);
  return all.allFinite() && (all > 0).all();
}

template <class Number>
template <class Vector>
void Diagonal<Number>::apply_inverse(Vector&& x) const {
  if constexpr (lanes<Number> == 1) {
    if (dense) return dense->solve_in_place(x);
  }
  x = factor.solve(x);
}

void BlockMatrix::take_pattern(int size, const Blocks& all, const std::vector<int>& coordinates, PatternCache* cache) {
  const Components components = components_of(size, all);
  const std::size_t count = components.sizes.size();
  std::vector<Blocks> local_blocks(count);
  std::vector<int> component_of_block(all.size(), kNone), block_number(all.size(), 0);
  for (std::size_t b = 0; b < all.size(); ++b) {
    const auto first = std::find_if(all[b].begin(), all[b].end(), [](int i) { return i >= 0; });
    if (first == all[b].end()) continue;
    component_of_block[b] = components.of[at(*first)];
    Blocks& own = local_blocks[at(component_of_block[b])];
    block_number[b] = static_cast<int>(own.size());
    own.push_back(all[b]);
    for (int& i : own.back()) {
      if (i >= 0) i = components.local[at(i)];
    }
  }
  patterns_.resize(count);
  // In the order in which patterns appear: the order of addresses would not be the same in each run.
  std::map<const SparsePattern*, std::size_t> group_of;
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t c = 0; c < count; ++c) {
    patterns_[c] = cache != nullptr ? cache->get(components.sizes[c], local_blocks[c])
                                    : std::make_shared<const SparsePattern>(components.sizes[c], local_blocks[c]);
    const auto [found, fresh] = group_of.try_emplace(patterns_[c].get(), groups.size());
    if (fresh) groups.emplace_back();
    groups[found->second].push_back(c);
  }
  std::vector<bool> of_points(count, !coordinates.empty());  // each component: whether its unknowns are coordinates
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (coordinates[i] < 0) of_points[at(components.of[i])] = false;
  }
  struct Slot {
    int unknown = 0, entry = 0, lane = kNone;
    bool sheet = false;
  };
  std::vector<Slot> slots(count);
  std::vector<std::shared_ptr<const SparsePattern>> by_four, by_one, in_sheets;
  Slot four{0, 0, 0, false}, one, sheet{0, 0, kNone, true};
  const auto next = [](Slot& slot, const SparsePattern& pattern) {
    slot.unknown += pattern.size;
    slot.entry += static_cast<int>(pattern.row.size());
  };
  for (const auto& group : groups) {
    const auto& pattern = patterns_[group[0]];
    if (pattern->fills_up && pattern->size >= kLeastSheet && of_points[group[0]]) {
      for (const std::size_t c : group) {
        slots[c] = sheet;
        in_sheets.push_back(pattern);
        next(sheet, *pattern);
      }
      continue;
    }
    const std::size_t in_fours = pattern->fills_up ? 0 : group.size() - group.size() % FourDoubles::kCount;
    for (std::size_t i = 0; i < in_fours; ++i) {
      four.lane = static_cast<int>(i % FourDoubles::kCount);
      slots[group[i]] = four;
      if (four.lane != FourDoubles::kCount - 1) continue;
      by_four.push_back(pattern);
      next(four, *pattern);
    }
    for (std::size_t i = in_fours; i < group.size(); ++i) {
      slots[group[i]] = one;
      by_one.push_back(pattern);
      next(one, *pattern);
    }
  }
  fours_.assemble(by_four);
  alone_.assemble(by_one);
  if (std::any_of(by_one.begin(), by_one.end(), [](const auto& pattern) { return pattern->fills_up; }))
    alone_.take_dense();
  sheets_.assemble(in_sheets);
  const int first_alone = FourDoubles::kCount * four.unknown, first_of_sheets = first_alone + one.unknown;
  where_.resize(at(size));
  for (std::size_t i = 0; i < where_.size(); ++i) {
    const std::size_t c = at(components.of[i]);
    const int number = slots[c].unknown + patterns_[c]->numbers[at(components.local[i])];
    where_[i] = slots[c].sheet           ? first_of_sheets + number
                : slots[c].lane == kNone ? first_alone + number
                                         : FourDoubles::kCount * number + slots[c].lane;
  }
  blocks_.assign(all.size(), {});
  for (std::size_t b = 0; b < all.size(); ++b) {
    if (component_of_block[b] == kNone) continue;
    const std::size_t c = at(component_of_block[b]);
    const Slot& slot = slots[c];
    BlockEntries& own = blocks_[b];
    own.entries = patterns_[c]->block_entries.data() + patterns_[c]->first_block_entry[at(block_number[b])];
    own.stride = slot.lane == kNone ? 1 : FourDoubles::kCount;
    own.values = slot.sheet           ? sheets_.matrix.valuePtr() + slot.entry
                 : slot.lane == kNone ? alone_.matrix.valuePtr() + slot.entry
                                      : fours_.matrix.valuePtr()[slot.entry].each.data() + slot.lane;
  }
  grid_ = nullptr;
  if (in_sheets.empty()) return;
  std::vector<int> coordinates_there(at(sheet.unknown));
  for (std::size_t i = 0; i < where_.size(); ++i) {
    if (where_[i] >= first_of_sheets) coordinates_there[at(where_[i] - first_of_sheets)] = coordinates[i];
  }
  Blocks blocks_there;
  for (std::size_t b = 0; b < all.size(); ++b) {
    if (component_of_block[b] == kNone || !slots[at(component_of_block[b])].sheet) continue;
    blocks_there.push_back(all[b]);
    for (int& i : blocks_there.back()) {
      if (i >= 0) i = where_[at(i)] - first_of_sheets;
    }
  }
  grid_ = std::make_unique<Multigrid>(coordinates_there, blocks_there, sheets_.matrix.outerIndexPtr(),
                                      sheets_.matrix.innerIndexPtr());
}

double* BlockMatrix::entry(int unknown, int other) {
  const int first_alone = FourDoubles::kCount * static_cast<int>(fours_.matrix.rows());
  const int first_of_sheets = first_alone + static_cast<int>(alone_.matrix.rows());
  const auto [low, high] = std::minmax({index_of(unknown), index_of(other)});
  if (low >= first_of_sheets) return sheets_.entry(low - first_of_sheets, high - first_of_sheets);
  if (low >= first_alone && high < first_of_sheets) return alone_.entry(low - first_alone, high - first_alone);
  if (high >= first_alone || low % FourDoubles::kCount != high % FourDoubles::kCount) return nullptr;
  double* const found = fours_.entry(low / FourDoubles::kCount, high / FourDoubles::kCount);
  return found == nullptr ? nullptr : found + low % FourDoubles::kCount;
}

void BlockMatrix::clear() {
  fours_.matrix.coeffs().setConstant(0);
  alone_.matrix.coeffs().setConstant(0);
  sheets_.matrix.coeffs().setConstant(0);
}

void BlockMatrix::add(std::size_t block, const std::vector<int>& unknowns, const double* column_major) {
  const auto [entries, values, stride] = blocks_[block];
  if (entries == nullptr) return;
  const int* index = entries;
  const std::size_t n = unknowns.size();
  for (std::size_t c = 0; c < n; ++c) {
    if (unknowns[c] < 0) continue;
    for (std::size_t r = c; r < n; ++r) {
      if (unknowns[r] >= 0) values[*index++ * stride] += column_major[c * n + r];
    }
  }
}

bool BlockMatrix::factorise() {
  approximate_ = grid_ != nullptr;
  return fours_.factorise() && alone_.factorise() && (grid_ == nullptr || grid_->set(sheets_.matrix.valuePtr()));
}

bool BlockMatrix::factorise_sheets() {
  if (!sheets_.dense) sheets_.take_dense();
  approximate_ = false;
  return sheets_.factorise();
}

void BlockMatrix::apply_inverse(Vector& x) const {
  const Eigen::Index fours = fours_.matrix.rows(), singles = alone_.matrix.rows(), in_sheets = sheets_.matrix.rows();
  auto others = numbers(x).segment(FourDoubles::kCount * fours, singles + in_sheets);
  if (fours > 0) fours_.apply_inverse(x.head(fours));
  if (singles > 0) alone_.apply_inverse(others.head(singles));
  if (in_sheets == 0) return;
  if (approximate_) {
    grid_->apply_inverse(others.tail(in_sheets));
  } else {
    sheets_.apply_inverse(others.tail(in_sheets));
  }
}

void BlockMatrix::multiply_sheets(const Vector& x, Vector& out) const {
  const Eigen::Index begin = FourDoubles::kCount * fours_.matrix.rows() + alone_.matrix.rows();
  grid_->multiply(numbers(x).segment(begin, sheets_.matrix.rows()), numbers(out).segment(begin, sheets_.matrix.rows()));
}

}  // namespace touchstone::linear
