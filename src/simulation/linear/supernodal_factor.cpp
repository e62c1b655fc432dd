// SPDX-License-Identifier: MIT
#include "linear/supernodal_factor.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

// Davis, Rajamanickam and Sid-Lakhdar 2016, "A survey of direct methods for sparse linear systems", sections 4 and 11,
// names all of the following.
#include "linear/sparse_pattern.hpp"

namespace touchstone::linear {
namespace {

using Matrix = Eigen::MatrixXd;

/// The parent of each column in the elimination tree; -1 for a root.
std::vector<int> elimination_tree(int size, const int* first, const int* row) {
  std::vector<int> parent(at(size), -1), ancestor(at(size), -1);
  for (int j = 0; j < size; ++j) {
    for (int k = first[j]; k < first[j + 1]; ++k) {
      for (int i = row[k]; i != -1 && i < j;) {
        const int next = ancestor[at(i)];
        ancestor[at(i)] = j;
        if (next == -1) parent[at(i)] = j;
        i = next;
      }
    }
  }
  return parent;
}

/// The number of entries in each column of the factor, the diagonal included.
std::vector<int> column_counts(int size, const int* first, const int* row, const std::vector<int>& parent) {
  std::vector<int> count(at(size), 1), seen(at(size), -1);
  for (int j = 0; j < size; ++j) {
    seen[at(j)] = j;
    for (int k = first[j]; k < first[j + 1]; ++k) {
      for (int i = row[k]; seen[at(i)] != j; i = parent[at(i)]) {
        seen[at(i)] = j;
        ++count[at(i)];
      }
    }
  }
  return count;
}

/// The position of each column in a postorder: children before their parents, and each subtree in one range.
std::vector<int> postorder(const std::vector<int>& parent) {
  const int size = static_cast<int>(parent.size());
  std::vector<int> head(at(size), -1), next(at(size), -1), position(at(size)), open;
  for (int j = size; j-- > 0;) {
    if (parent[at(j)] == -1) continue;
    next[at(j)] = head[at(parent[at(j)])];
    head[at(parent[at(j)])] = j;
  }
  int count = 0;
  for (int root = 0; root < size; ++root) {
    if (parent[at(root)] != -1) continue;
    open.push_back(root);
    while (!open.empty()) {
      const int j = open.back(), child = head[at(j)];
      if (child == -1) {
        position[at(j)] = count++;
        open.pop_back();
      } else {
        head[at(j)] = next[at(child)];
        open.push_back(child);
      }
    }
  }
  return position;
}

// Columns of a supernode. Eigen cuts longer products at lengths that it takes from the processor's caches, and then
// each kind of processor would have rounding errors of its own.
constexpr int kMostColumns = 256;

/// Whether a supernode of so many columns may have this fraction of zeros in its panel. Wide panels with few zeros are
/// quicker than narrow ones without any.
bool may_have_zeros(int columns, double zeros) {
  if (columns > kMostColumns) return false;
  return columns <= 4 || zeros < 0.05 || (columns <= 16 && zeros < 0.8) || (columns <= 48 && zeros < 0.1);
}

}  // namespace

FactorSize factor_size(int size, const int* first, const int* row) {
  FactorSize sum;
  for (const int count : column_counts(size, first, row, elimination_tree(size, first, row))) {
    sum.entries += count;
    sum.work += static_cast<double>(count) * count;
  }
  return sum;
}

SupernodalFactor::SupernodalFactor(int size, const int* first, const int* row) : size_(size) {
  const std::vector<int> tree = elimination_tree(size, first, row);
  const std::vector<int> counts = column_counts(size, first, row, tree);
  numbers_ = postorder(tree);
  std::vector<int> parent(at(size), -1), count(at(size));
  for (int j = 0; j < size; ++j) {
    const auto own = at(numbers_[at(j)]);
    count[own] = counts[at(j)];
    if (tree[at(j)] != -1) parent[own] = numbers_[at(tree[at(j)])];
  }
  find_supernodes(parent, count);
  // In an entry of the upper triangle, the column is an ancestor of the row and comes after it in a postorder, too.
  std::vector<std::vector<int>> columns(at(size));
  for (int j = 0; j < size; ++j) {
    for (int k = first[j]; k < first[j + 1]; ++k) columns[at(numbers_[at(row[k])])].push_back(numbers_[at(j)]);
  }
  find_rows(columns);

  std::vector<std::size_t> supernode_of(at(size));
  for (std::size_t s = 0; s < supernodes_.size(); ++s) {
    for (int j = supernodes_[s].begin; j < supernodes_[s].end; ++j) supernode_of[at(j)] = s;
  }
  entry_positions_.resize(at(first[size]));
  for (int j = 0; j < size; ++j) {
    for (int k = first[j]; k < first[j + 1]; ++k) {
      const int low = numbers_[at(row[k])], high = numbers_[at(j)];
      const Supernode& own = supernodes_[supernode_of[at(low)]];
      std::size_t position = at(high - own.begin);
      if (high >= own.end) {
        const auto begin = rows_.begin() + static_cast<std::ptrdiff_t>(own.first_row);
        position = static_cast<std::size_t>(own.columns()) +
                   static_cast<std::size_t>(std::lower_bound(begin, begin + own.below(), high) - begin);
      }
      const auto height = static_cast<std::size_t>(own.columns() + own.below());
      entry_positions_[at(k)] = own.panel + at(low - own.begin) * height + position;
    }
  }
}

void SupernodalFactor::find_supernodes(const std::vector<int>& parent, const std::vector<int>& count) {
  // Columns with the same rows below the next column, one after the other.
  std::vector<int> begin;
  for (int j = 0; j < size_; ++j) {
    const bool same = j > 0 && parent[at(j - 1)] == j && count[at(j - 1)] == count[at(j)] + 1;
    if (!same || j - begin.back() == kMostColumns) begin.push_back(j);
  }
  // A supernode joins its parent where it ends just before it, and few of the panel's entries become zeros. The row
  // count of the union is that of the parent.
  struct Range {
    int begin, end;
    double zeros;  // in its panel
  };
  std::vector<Range> joined;
  const auto entries = [&](int first, int end) {  // of a panel with the rows of its last column
    const double width = end - first, height = width - 1 + count[at(end - 1)];
    return width * height - 0.5 * width * (width - 1);
  };
  begin.push_back(size_);
  for (std::size_t s = 0; s + 1 < begin.size(); ++s) {
    Range range{begin[s], begin[s + 1], 0};
    while (!joined.empty() && parent[at(joined.back().end - 1)] >= range.begin &&
           parent[at(joined.back().end - 1)] < range.end) {
      const Range& before = joined.back();
      const double whole = entries(before.begin, range.end);
      const double full =
          entries(before.begin, before.end) - before.zeros + entries(range.begin, range.end) - range.zeros;
      if (!may_have_zeros(range.end - before.begin, (whole - full) / whole)) break;
      range = {before.begin, range.end, whole - full};
      joined.pop_back();
    }
    joined.push_back(range);
  }
  std::vector<int> supernode_of(at(size_));
  for (const Range& range : joined) {
    for (int j = range.begin; j < range.end; ++j) supernode_of[at(j)] = static_cast<int>(supernodes_.size());
    Supernode own;
    own.begin = range.begin;
    own.end = range.end;
    supernodes_.push_back(own);
  }
  for (Supernode& own : supernodes_) {
    const int above = parent[at(own.end - 1)];
    if (above != -1) own.parent = supernode_of[at(above)];
  }
}

void SupernodalFactor::find_rows(const std::vector<std::vector<int>>& columns) {
  std::vector<std::vector<int>> rows(supernodes_.size());  // of children so far
  std::vector<int> seen(at(size_), -1);
  std::size_t panel = 0, top = 0, highest = 0;
  std::vector<std::size_t> update_size(supernodes_.size(), 0);
  std::vector<std::size_t> of_children(supernodes_.size(), 0);  // numbers of their updates
  for (std::size_t s = 0; s < supernodes_.size(); ++s) {
    Supernode& own = supernodes_[s];
    std::vector<int> all;
    const auto take = [&](int r) {
      if (r < own.end || seen[at(r)] == static_cast<int>(s)) return;
      seen[at(r)] = static_cast<int>(s);
      all.push_back(r);
    };
    for (int j = own.begin; j < own.end; ++j) {
      for (const int r : columns[at(j)]) take(r);
    }
    for (const int r : rows[s]) take(r);
    rows[s] = {};
    std::sort(all.begin(), all.end());
    own.first_row = rows_.size();
    own.row_count = all.size();
    rows_.insert(rows_.end(), all.begin(), all.end());
    own.panel = panel;
    panel += static_cast<std::size_t>(own.columns() * (own.columns() + own.below()));
    if (own.parent >= 0) {
      auto& above = rows[at(own.parent)];
      above.insert(above.end(), all.begin(), all.end());
    }
    // The update is made on top of those of the children, and then takes their place.
    const std::size_t update = all.size() * all.size();
    highest = std::max(highest, top + update);
    top += update - of_children[s];
    if (own.parent >= 0) of_children[at(own.parent)] += update;
  }
  panels_.resize(panel);
  stack_.resize(highest);
  positions_in_parent_.resize(rows_.size());
  for (const Supernode& own : supernodes_) {
    if (own.parent < 0) continue;
    const Supernode& above = supernodes_[at(own.parent)];
    const int* const begin = rows_.data() + above.first_row;
    for (std::size_t k = own.first_row; k < own.first_row + own.row_count; ++k) {
      const int r = rows_[k];
      positions_in_parent_[k] =
          r < above.end
              ? r - above.begin
              : static_cast<int>(above.columns() + (std::lower_bound(begin, begin + above.below(), r) - begin));
    }
  }
}

void SupernodalFactor::add_update(const Supernode& child, const double* update, const Supernode& parent,
                                  double* parent_update) {
  const auto count = child.row_count;
  const int* const positions = positions_in_parent_.data() + child.first_row;
  const auto columns = static_cast<int>(parent.columns());
  const auto height = static_cast<std::size_t>(parent.columns() + parent.below());
  for (std::size_t c = 0; c < count; ++c) {
    const int position = positions[c];
    double* const to = position < columns ? panels_.data() + parent.panel + at(position) * height
                                          : parent_update + at(position - columns) * parent.row_count - columns;
    const double* const from = update + c * count;
    for (std::size_t r = c; r < count; ++r) to[positions[r]] += from[r];
  }
}

bool SupernodalFactor::factorise(const double* values) {
  std::fill(panels_.begin(), panels_.end(), 0.0);
  for (std::size_t k = 0; k < entry_positions_.size(); ++k) panels_[entry_positions_[k]] += values[k];
  struct Waiting {
    std::size_t supernode, position;
  };
  std::vector<Waiting> waiting;
  std::size_t top = 0;
  for (std::size_t s = 0; s < supernodes_.size(); ++s) {
    const Supernode& own = supernodes_[s];
    const Eigen::Index width = own.columns(), below = own.below();
    double* const update = stack_.data() + top;
    std::fill(update, update + below * below, 0.0);
    std::size_t base = top;
    while (!waiting.empty() && supernodes_[waiting.back().supernode].parent == static_cast<int>(s)) {
      base = waiting.back().position;
      add_update(supernodes_[waiting.back().supernode], stack_.data() + base, own, update);
      waiting.pop_back();
    }
    Eigen::Map<Matrix> panel(panels_.data() + own.panel, width + below, width);
    Eigen::Ref<Matrix> diagonal(panel.topRows(width));
    const Eigen::LLT<Eigen::Ref<Matrix>> factor(diagonal);
    if (factor.info() != Eigen::Success || !diagonal.diagonal().allFinite()) return false;
    if (below == 0) {
      top = base;
      continue;
    }
    auto lower = panel.bottomRows(below);
    diagonal.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(lower);
    Eigen::Map<Matrix> rest(update, below, below);
    rest.selfadjointView<Eigen::Lower>().rankUpdate(lower, -1);
    std::copy(update, update + below * below, stack_.data() + base);
    waiting.push_back({s, base});
    top = base + static_cast<std::size_t>(below * below);
  }
  return true;
}

void SupernodalFactor::solve_in_place(Eigen::Ref<Eigen::VectorXd> x) const {
  Eigen::VectorXd y(size_), gathered(size_);
  for (int i = 0; i < size_; ++i) y[numbers_[at(i)]] = x[i];
  for (const Supernode& own : supernodes_) {
    const Eigen::Index width = own.columns(), below = own.below();
    const Eigen::Map<const Matrix> panel(panels_.data() + own.panel, width + below, width);
    auto top = y.segment(own.begin, width);
    panel.topRows(width).triangularView<Eigen::Lower>().solveInPlace(top);
    if (below == 0) continue;
    auto pull = gathered.head(below);
    pull.noalias() = panel.bottomRows(below) * top;
    const int* const rows = rows_.data() + own.first_row;
    for (Eigen::Index r = 0; r < below; ++r) y[rows[r]] -= pull[r];
  }
  for (auto own = supernodes_.rbegin(); own != supernodes_.rend(); ++own) {
    const Eigen::Index width = own->columns(), below = own->below();
    const Eigen::Map<const Matrix> panel(panels_.data() + own->panel, width + below, width);
    auto top = y.segment(own->begin, width);
    if (below > 0) {
      const int* const rows = rows_.data() + own->first_row;
      for (Eigen::Index r = 0; r < below; ++r) gathered[r] = y[rows[r]];
      top.noalias() -= panel.bottomRows(below).transpose() * gathered.head(below);
    }
    panel.topRows(width).triangularView<Eigen::Lower>().transpose().solveInPlace(top);
  }
  for (int i = 0; i < size_; ++i) x[i] = y[numbers_[at(i)]];
}

}  // namespace touchstone::linear
