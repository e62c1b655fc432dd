// SPDX-License-Identifier: MIT
#include "broad_phase/grid.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace touchstone::broad_phase {
namespace {

using Cell = std::array<std::uint64_t, 3>;
using BoxList = std::vector<const std::vector<Box>*>;

/// Which cell a coordinate lies in. Each axis maps x to floor((x - low) * cells per unit length), computed in doubles:
/// rounding is monotone, so low <= x <= high gives cell(low) <= cell(x) <= cell(high), and that is all that is needed.
class Grid {
 public:
  explicit Grid(const BoxList& lists) : bounds_(empty_box()) {
    double longest_sides = 0;
    std::size_t count = 0;
    for (const auto* boxes : lists) {
      for (const Box& box : *boxes) {
        double longest = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          bounds_.low[k] = std::min(bounds_.low[k], box.low[k]);
          bounds_.high[k] = std::max(bounds_.high[k], box.high[k]);
          longest = std::max(longest, box.high[k] - box.low[k]);
        }
        longest_sides += longest;
        ++count;
      }
    }
    if (count == 0) return;
    double extent = 0;
    for (std::size_t k = 0; k < 3; ++k) extent = std::max(extent, bounds_.high[k] - bounds_.low[k]);
    double side = std::max(longest_sides / static_cast<double>(count), extent * (1 / kMostCells));
    if (!(side > 0)) side = 1;
    cells_per_length_ = 1 / side;
    // A few boxes that are much larger than the mean must not fill the memory.
    while (entry_count(lists) > kEntriesPerBox * static_cast<double>(count)) cells_per_length_ /= 2;
  }

  std::uint64_t cell(double x, std::size_t axis) const noexcept {
    return static_cast<std::uint64_t>(std::min((x - bounds_.low[axis]) * cells_per_length_, kMostCells));
  }

  /// 20 bits and a carry an axis.
  static std::uint64_t key(const Cell& cell) noexcept { return cell[0] | cell[1] << 21 | cell[2] << 42; }

  /// The one cell in which an overlapping pair is reported: the cell of the low corner of the two boxes' intersection.
  std::uint64_t key_of_overlap(const Box& a, const Box& b) const noexcept {
    Cell at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = cell(std::max(a.low[k], b.low[k]), k);
    return key(at);
  }

  struct Entry {
    std::uint64_t key;
    std::uint32_t box;
    bool operator<(const Entry& other) const { return key != other.key ? key < other.key : box < other.box; }
  };

  /// Each box in every cell that it reaches, sorted by cell.
  std::vector<Entry> entries(const std::vector<Box>& boxes) const {
    std::vector<Entry> all;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      Cell first, last, at;
      for (std::size_t k = 0; k < 3; ++k) {
        first[k] = cell(boxes[i].low[k], k);
        last[k] = cell(boxes[i].high[k], k);
      }
      for (at[0] = first[0]; at[0] <= last[0]; ++at[0]) {
        for (at[1] = first[1]; at[1] <= last[1]; ++at[1]) {
          for (at[2] = first[2]; at[2] <= last[2]; ++at[2]) all.push_back({key(at), static_cast<std::uint32_t>(i)});
        }
      }
    }
    return sorted(std::move(all));
  }

 private:
  static constexpr double kMostCells = 0x1p20;
  static constexpr double kEntriesPerBox = 24;  // 8 would do for boxes of one size; with one cell for all it is 1

  /// By cell, and in each cell by box, as they come: counted into place where there are not many more cells than
  /// entries.
  std::vector<Entry> sorted(std::vector<Entry> all) const {
    if (all.empty()) return all;
    constexpr double kCellsPerEntry = 8;
    Cell sides;
    double cells = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      sides[k] = cell(bounds_.high[k], k) + 1;
      cells *= static_cast<double>(sides[k]);
    }
    if (cells > kCellsPerEntry * static_cast<double>(all.size())) {
      std::sort(all.begin(), all.end());
      return all;
    }
    constexpr std::uint64_t kAxis = (std::uint64_t{1} << 21) - 1;
    const auto number = [&](const Entry& entry) {
      return ((entry.key >> 42) * sides[1] + (entry.key >> 21 & kAxis)) * sides[0] + (entry.key & kAxis);
    };
    std::vector<std::uint32_t> next(static_cast<std::size_t>(cells) + 1, 0);
    for (const Entry& entry : all) ++next[number(entry) + 1];
    for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
    std::vector<Entry> placed(all.size());
    for (const Entry& entry : all) placed[next[number(entry)]++] = entry;
    return placed;
  }

  double entry_count(const BoxList& lists) const noexcept {
    double sum = 0;
    for (const auto* boxes : lists) {
      for (const Box& box : *boxes) {
        double cells = 1;
        for (std::size_t k = 0; k < 3; ++k) {
          cells *= static_cast<double>(cell(box.high[k], k) - cell(box.low[k], k) + 1);
        }
        sum += cells;
      }
    }
    return sum;
  }

  Box bounds_;
  double cells_per_length_ = 1;
};

using Entries = std::vector<Grid::Entry>;

Entries::const_iterator end_of_cell(Entries::const_iterator at, Entries::const_iterator end) {
  return std::find_if(at, end, [key = at->key](const Grid::Entry& entry) { return entry.key != key; });
}

}  // namespace

void for_each_overlap(const std::vector<Box>& boxes, const PairConsumer& found) {
  const Grid grid({&boxes});
  const Entries entries = grid.entries(boxes);
  for (auto cell = entries.begin(); cell != entries.end();) {
    const auto end = end_of_cell(cell, entries.end());
    for (auto i = cell; i != end; ++i) {
      const Box& box = boxes[i->box];
      for (auto j = i + 1; j != end; ++j) {
        const Box& other = boxes[j->box];
        if (overlap(box, other) && grid.key_of_overlap(box, other) == i->key) found(i->box, j->box);
      }
    }
    cell = end;
  }
}

void for_each_overlap(const std::vector<Box>& a, const std::vector<Box>& b, const PairConsumer& found) {
  const Grid grid({&a, &b});
  const Entries in_a = grid.entries(a), in_b = grid.entries(b);
  auto cell_b = in_b.begin();
  for (auto cell_a = in_a.begin(); cell_a != in_a.end();) {
    const auto end_a = end_of_cell(cell_a, in_a.end());
    while (cell_b != in_b.end() && cell_b->key < cell_a->key) ++cell_b;
    for (auto i = cell_a; i != end_a; ++i) {
      for (auto j = cell_b; j != in_b.end() && j->key == i->key; ++j) {
        const Box &box = a[i->box], &other = b[j->box];
        if (overlap(box, other) && grid.key_of_overlap(box, other) == i->key) found(i->box, j->box);
      }
    }
    cell_a = end_a;
  }
}

}  // namespace touchstone::broad_phase
