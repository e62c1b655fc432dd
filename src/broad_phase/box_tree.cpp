// SPDX-License-Identifier: MIT
#include "broad_phase/box_tree.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace touchstone::broad_phase {
namespace {

using Number = std::uint32_t;

/// The times at which two boxes may overlap; none if `from` exceeds `to`.
struct TimeInterval {
  double from = 0, to = 1;
};

// f is linear in t, from f0 to f1. Both are differences of two bounds, and rounding does not change a difference's
// sign. If both are negative, f is negative at all times. If one of them is negative, f is zero at
// t = -f0 / (f1 - f0) = 1 - f1 / (f1 - f0).
// Let e = 2^-53. The computed f0 and f1 have a relative error of e. Their signs differ, so f1 - f0 has a relative
// error of e, and e more for its own rounding. The quotient is at most 1 and is off by 4 e; 1 minus the quotient is off
// by 5 e. So two times and their comparison are off by 10 e. The rest of the constant covers terms of second order and
// underflow.
constexpr double kTimesError = 12 * 0x1p-53;

/// Removes the times at which f is certainly negative. @returns false if f is negative at all times
bool keep_where_not_negative(double f0, double f1, TimeInterval& times) noexcept {
  // A difference that overflows makes a quotient 0 or NaN. Neither changes the times: std::max and std::min return
  // their first argument then.
  if (f0 < 0) {
    if (f1 < 0) return false;
    times.from = std::max(times.from, -f0 / (f1 - f0));
  } else if (f1 < 0) {
    times.to = std::min(times.to, 1 - f1 / (f1 - f0));
  }
  return true;
}

/// A binary tree over boxes. The boxes of a node are near each other at both ends of the step.
class Tree {
 public:
  struct Node {
    MovingBox box;
    Number first, last;  ///< positions of its boxes in items_
    Number second;       ///< the second child; the first one comes next. 0: a leaf
    bool is_leaf() const noexcept { return second == 0; }
  };

  explicit Tree(const std::vector<MovingBox>& boxes) : boxes_(&boxes), items_(boxes.size()) {
    if (boxes.empty()) return;
    for (Number i = 0; i < items_.size(); ++i) {
      items_[i].number = i;
      std::copy_n(boxes[i].start.low.begin(), 3, items_[i].at.begin());
      std::copy_n(boxes[i].end.low.begin(), 3, items_[i].at.begin() + 3);
    }
    nodes_.reserve(boxes.size() / 2);
    build(0, static_cast<Number>(items_.size()));
  }

  bool empty() const noexcept { return nodes_.empty(); }
  const Node& node(Number n) const noexcept { return nodes_[n]; }
  Number number(Number place) const noexcept { return items_[place].number; }
  const MovingBox& box(Number place) const noexcept { return (*boxes_)[number(place)]; }

 private:
  static constexpr Number kLeaf = 8;  // boxes in a leaf, at most

  /// A box's number, and its lower bounds at both ends.
  struct Item {
    std::array<double, 6> at;
    Number number;
  };

  struct Extent {
    std::size_t axis;
    double middle;
  };

  Extent widest_extent(Number first, Number last) const noexcept {
    std::array<double, 6> least = items_[first].at, greatest = least;
    for (Number i = first + 1; i < last; ++i) {
      for (std::size_t axis = 0; axis < 6; ++axis) {
        least[axis] = std::min(least[axis], items_[i].at[axis]);
        greatest[axis] = std::max(greatest[axis], items_[i].at[axis]);
      }
    }
    std::size_t widest = 0;
    for (std::size_t axis = 1; axis < 6; ++axis) {
      if (greatest[axis] - least[axis] > greatest[widest] - least[widest]) widest = axis;
    }
    return {widest, 0.5 * least[widest] + 0.5 * greatest[widest]};
  }

  /// Divides the items [first, last) into two parts. @returns where the second part begins. Only the boxes decide which
  /// box is in which part.
  Number split(Number first, Number last) {
    const auto begin = items_.begin() + first, end = items_.begin() + last;
    const Extent extent = widest_extent(first, last);
    const auto beyond = std::partition(begin, end, [&](const Item& i) { return i.at[extent.axis] < extent.middle; });
    const Number middle = first + static_cast<Number>(beyond - begin);
    const Number fewest = 1 + (last - first) / 8;  // in each part; otherwise the depth might reach the number of boxes
    if (middle - first >= fewest && last - middle >= fewest) return middle;
    const Number half = first + (last - first) / 2;
    std::nth_element(begin, items_.begin() + half, end, [&](const Item& i, const Item& j) {
      const double x = i.at[extent.axis], y = j.at[extent.axis];
      return x != y ? x < y : i.number < j.number;
    });
    return half;
  }

  void build(Number first, Number last) {
    const std::size_t at = nodes_.size();
    nodes_.push_back({empty_moving_box(), first, last, 0});
    if (last - first <= kLeaf) {
      std::sort(items_.begin() + first, items_.begin() + last,
                [](const Item& i, const Item& j) { return i.number < j.number; });
      for (Number i = first; i < last; ++i) join(nodes_[at].box, box(i));
      return;
    }
    const Number middle = split(first, last);
    build(first, middle);
    nodes_[at].second = static_cast<Number>(nodes_.size());
    build(middle, last);
    join(nodes_[at].box, nodes_[at + 1].box);
    join(nodes_[at].box, nodes_[nodes_[at].second].box);
  }

  const std::vector<MovingBox>* boxes_;
  std::vector<Item> items_;
  std::vector<Node> nodes_;
};

/// Calls found(position in a, position in b) for boxes that meet.
template <class Found>
void across(const Tree& a, Number in_a, const Tree& b, Number in_b, const Found& found) {
  const Tree::Node &x = a.node(in_a), &y = b.node(in_b);
  if (!meet(x.box, y.box)) return;
  if (x.is_leaf() && y.is_leaf()) {
    for (Number i = x.first; i < x.last; ++i) {
      for (Number j = y.first; j < y.last; ++j) {
        if (meet(a.box(i), b.box(j))) found(i, j);
      }
    }
  } else if (y.is_leaf() || (!x.is_leaf() && x.last - x.first >= y.last - y.first)) {
    across(a, in_a + 1, b, in_b, found);
    across(a, x.second, b, in_b, found);
  } else {
    across(a, in_a, b, in_b + 1, found);
    across(a, in_a, b, y.second, found);
  }
}

template <class Found>
void within(const Tree& tree, Number at, const Found& found) {
  const Tree::Node& x = tree.node(at);
  if (x.is_leaf()) {
    for (Number i = x.first; i < x.last; ++i) {
      for (Number j = i + 1; j < x.last; ++j) {
        if (meet(tree.box(i), tree.box(j))) found(i, j);
      }
    }
    return;
  }
  within(tree, at + 1, found);
  within(tree, x.second, found);
  across(tree, at + 1, tree, x.second, found);
}

}  // namespace

MovingBox empty_moving_box() noexcept { return {empty_box(), empty_box()}; }

void join(MovingBox& box, const MovingBox& other) noexcept {
  const auto join_at = [](Box& b, const Box& o) {
    for (std::size_t k = 0; k < 3; ++k) {
      b.low[k] = std::min(b.low[k], o.low[k]);
      b.high[k] = std::max(b.high[k], o.high[k]);
    }
  };
  join_at(box.start, other.start);
  join_at(box.end, other.end);
}

bool meet(const MovingBox& a, const MovingBox& b) noexcept {
  TimeInterval times;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!keep_where_not_negative(b.start.high[k] - a.start.low[k], b.end.high[k] - a.end.low[k], times)) return false;
    if (!keep_where_not_negative(a.start.high[k] - b.start.low[k], a.end.high[k] - b.end.low[k], times)) return false;
  }
  return times.from <= times.to + kTimesError;
}

void for_each_pair(const std::vector<MovingBox>& boxes, const PairConsumer& found) {
  const Tree tree(boxes);
  if (tree.empty()) return;
  within(tree, 0, [&](Number i, Number j) {
    const Number a = tree.number(i), b = tree.number(j);
    found(std::min(a, b), std::max(a, b));
  });
}

void for_each_pair(const std::vector<MovingBox>& a, const std::vector<MovingBox>& b, const PairConsumer& found) {
  const Tree in_a(a), in_b(b);
  if (in_a.empty() || in_b.empty()) return;
  across(in_a, 0, in_b, 0, [&](Number i, Number j) { found(in_a.number(i), in_b.number(j)); });
}

}  // namespace touchstone::broad_phase
