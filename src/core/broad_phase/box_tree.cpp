// SPDX-License-Identifier: MIT
#include "broad_phase/box_tree.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "threads/for_each_range.hpp"

namespace touchstone::broad_phase {
namespace {

using Number = BoxTree::Number;
using Node = BoxTree::Node;

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

constexpr Number kLeaf = 8;  // boxes in a leaf, at most

/// A box's number, and its lower bounds at both ends.
struct Item {
  std::array<double, 6> at;
  Number number;
};

using Items = LargeVector<Item>;

struct Extent {
  std::size_t axis;
  double middle;
};

Extent widest_extent(const Items& items, Number first, Number last) noexcept {
  std::array<double, 6> least = items[first].at, greatest = least;
  for (Number i = first + 1; i < last; ++i) {
    for (std::size_t axis = 0; axis < 6; ++axis) {
      least[axis] = std::min(least[axis], items[i].at[axis]);
      greatest[axis] = std::max(greatest[axis], items[i].at[axis]);
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
Number split(Items& items, Number first, Number last) {
  const auto begin = items.begin() + first, end = items.begin() + last;
  const Extent extent = widest_extent(items, first, last);
  const auto beyond = std::partition(begin, end, [&](const Item& i) { return i.at[extent.axis] < extent.middle; });
  const Number middle = first + static_cast<Number>(beyond - begin);
  const Number fewest = 1 + (last - first) / 8;  // in each part; otherwise the depth might reach the number of boxes
  if (middle - first >= fewest && last - middle >= fewest) return middle;
  const Number half = first + (last - first) / 2;
  std::nth_element(begin, items.begin() + half, end, [&](const Item& i, const Item& j) {
    const double x = i.at[extent.axis], y = j.at[extent.axis];
    return x != y ? x < y : i.number < j.number;
  });
  return half;
}

/// What the subtrees of a tree are built from, by several threads at the same time: each has its own positions.
struct Material {
  Items& items;
  LargeVector<Number>& numbers;
  LargeVector<MovingBox>& boxes;
  const std::function<MovingBox(Number)>& box_of;
};

/// Appends the tree over the positions [first, last), whose children are numbered from the beginning of `nodes`.
void build(const Material& from, Number first, Number last, LargeVector<Node>& nodes) {
  const std::size_t at = nodes.size();
  nodes.push_back({empty_moving_box(), first, last, 0});
  if (last - first <= kLeaf) {
    std::sort(from.items.begin() + first, from.items.begin() + last,
              [](const Item& i, const Item& j) { return i.number < j.number; });
    for (Number i = first; i < last; ++i) {
      from.numbers[i] = from.items[i].number;
      from.boxes[i] = from.box_of(from.numbers[i]);
      join(nodes[at].box, from.boxes[i]);
    }
    return;
  }
  const Number middle = split(from.items, first, last);
  build(from, first, middle, nodes);
  nodes[at].second = static_cast<Number>(nodes.size());
  build(from, middle, last, nodes);
  join(nodes[at].box, nodes[at + 1].box);
  join(nodes[at].box, nodes[nodes[at].second].box);
}

/// A node near the root. Its children are both 0, or numbers of other subtrees; without children, it has a tree of its
/// own.
struct Subtree {
  Number begin, end;
  std::size_t children[2] = {0, 0};
  LargeVector<Node> tree;
};

constexpr Number kSubtreeBoxes = 2048;     // a subtree of so many boxes, or fewer, is not divided among threads
constexpr std::size_t kSubtreeLevels = 6;  // 64 subtrees: enough for most machines, and few enough to put together fast

/// The tree's upper levels, level by level, each level's nodes on several threads; then the trees below them.
std::vector<Subtree> build_subtrees(const Material& from, int threads) {
  std::vector<Subtree> subtrees(1);
  subtrees[0].begin = 0;
  subtrees[0].end = static_cast<Number>(from.items.size());
  std::size_t level_begin = 0;
  for (std::size_t level = 0; level < kSubtreeLevels; ++level) {
    const std::size_t level_end = subtrees.size();
    std::vector<Number> middles(level_end - level_begin, 0);
    threads::for_each_range(middles.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Subtree& subtree = subtrees[level_begin + i];
        if (subtree.end - subtree.begin > kSubtreeBoxes) middles[i] = split(from.items, subtree.begin, subtree.end);
      }
    });
    for (std::size_t i = 0; i < middles.size(); ++i) {
      if (middles[i] == 0) continue;
      const std::size_t at = level_begin + i;
      const Number bounds[3] = {subtrees[at].begin, middles[i], subtrees[at].end};
      for (std::size_t child = 0; child < 2; ++child) {
        subtrees[at].children[child] = subtrees.size();
        Subtree subtree;
        subtree.begin = bounds[child];
        subtree.end = bounds[child + 1];
        subtrees.push_back(std::move(subtree));
      }
    }
    level_begin = level_end;
  }
  threads::for_each_range(subtrees.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (subtrees[i].children[0] == 0) build(from, subtrees[i].begin, subtrees[i].end, subtrees[i].tree);
    }
  });
  return subtrees;
}

/// Appends the subtree and all that is below it.
void put_together(std::vector<Subtree>& subtrees, std::size_t subtree, LargeVector<Node>& nodes) {
  const auto at = static_cast<Number>(nodes.size());
  if (subtrees[subtree].children[0] == 0) {
    for (Node& node : subtrees[subtree].tree) {
      if (!node.is_leaf()) node.second += at;
    }
    nodes.insert(nodes.end(), subtrees[subtree].tree.begin(), subtrees[subtree].tree.end());
    LargeVector<Node>().swap(subtrees[subtree].tree);
    return;
  }
  nodes.push_back({empty_moving_box(), subtrees[subtree].begin, subtrees[subtree].end, 0});
  put_together(subtrees, subtrees[subtree].children[0], nodes);
  nodes[at].second = static_cast<Number>(nodes.size());
  put_together(subtrees, subtrees[subtree].children[1], nodes);
  join(nodes[at].box, nodes[at + 1].box);
  join(nodes[at].box, nodes[nodes[at].second].box);
}

/// Two nodes whose boxes are to be compared; `within`: one node, and both are it.
struct Task {
  Number a, b;
  bool within;
};

/// Whether the nodes x of a and y of b are compared by the children of x.
bool divides_first(const Node& x, const Node& y) noexcept {
  return y.is_leaf() || (!x.is_leaf() && x.size() >= y.size());
}

/// Compares the boxes of trees. `until()` is the time after which a meeting does not count. `found(position in a,
/// position in b)` is called for boxes that meet.
template <class Until, class Found>
class Comparison {
 public:
  Comparison(const BoxTree& a, const BoxTree& b, const Until& until, const Found& found)
      : a_(a), b_(b), until_(until), found_(found) {}

  void across(Number in_a, Number in_b) const {
    const Node &x = a_.node(in_a), &y = b_.node(in_b);
    if (!meet(x.box, y.box, until_())) return;
    if (x.is_leaf() && y.is_leaf()) {
      for (Number i = x.begin; i < x.end; ++i) {
        const MovingBox& box = a_.box(i);
        if (!meet(box, y.box, until_())) continue;
        for (Number j = y.begin; j < y.end; ++j) {
          if (meet(box, b_.box(j), until_())) found_(i, j);
        }
      }
    } else if (divides_first(x, y)) {
      across(in_a + 1, in_b);
      across(x.second, in_b);
    } else {
      across(in_a, in_b + 1);
      across(in_a, y.second);
    }
  }

  /// `a` and `b` are one tree.
  void within(Number at) const {
    const Node& x = a_.node(at);
    if (x.is_leaf()) {
      for (Number i = x.begin; i < x.end; ++i) {
        for (Number j = i + 1; j < x.end; ++j) {
          if (meet(a_.box(i), a_.box(j), until_())) found_(i, j);
        }
      }
      return;
    }
    within(at + 1);
    within(x.second);
    across(at + 1, x.second);
  }

  void run(const Task& task) const { task.within ? within(task.a) : across(task.a, task.b); }

 private:
  const BoxTree &a_, &b_;
  const Until& until_;
  const Found& found_;
};

constexpr Number kTaskBoxes = 512;  // a task with so many boxes, or fewer, is not divided

/// The comparison of two nodes as tasks, in the order in which Comparison makes them.
void divide(const BoxTree& a, const BoxTree& b, const Task& task, double until, std::vector<Task>& tasks) {
  const Node &x = a.node(task.a), &y = b.node(task.b);
  if (task.within) {
    if (x.is_leaf() || x.size() <= kTaskBoxes) {
      tasks.push_back(task);
      return;
    }
    divide(a, b, {task.a + 1, task.a + 1, true}, until, tasks);
    divide(a, b, {x.second, x.second, true}, until, tasks);
    divide(a, b, {task.a + 1, x.second, false}, until, tasks);
    return;
  }
  if (!meet(x.box, y.box, until)) return;
  if ((x.is_leaf() && y.is_leaf()) || x.size() + y.size() <= kTaskBoxes) {
    tasks.push_back(task);
  } else if (divides_first(x, y)) {
    divide(a, b, {task.a + 1, task.b, false}, until, tasks);
    divide(a, b, {x.second, task.b, false}, until, tasks);
  } else {
    divide(a, b, {task.a, task.b + 1, false}, until, tasks);
    divide(a, b, {task.a, y.second, false}, until, tasks);
  }
}

/// Runs tasks one after another, and hands out the pairs in blocks.
void run_tasks(const BoxTree& a, const BoxTree& b, const Task* first, const Task* last, const PairSearch& search,
               const PairBlockConsumer& take) {
  std::array<Pair, kPairBlock> block;
  std::size_t count = 0;
  const bool one_tree = &a == &b;
  const auto found = [&](Number i, Number j) {
    const Number x = a.number(i), y = b.number(j);
    block[count++] = one_tree && y < x ? Pair{y, x} : Pair{x, y};
    if (count == kPairBlock) {
      take(block.data(), count);
      count = 0;
    }
  };
  const auto until = [&] { return search.until == nullptr ? 1.0 : search.until->load(std::memory_order_relaxed); };
  const Comparison comparison(a, b, until, found);
  for (const Task* task = first; task != last; ++task) comparison.run(*task);
  if (count > 0) take(block.data(), count);
}

void run_all(const BoxTree& a, const BoxTree& b, const Task& whole, const PairSearch& search,
             const PairBlockConsumer& take) {
  std::vector<Task> tasks;
  divide(a, b, whole, 1, tasks);
  constexpr std::size_t kTasksAtATime = 16;
  threads::for_each_range(tasks.size(), kTasksAtATime, search.threads, [&](std::size_t first, std::size_t last) {
    run_tasks(a, b, tasks.data() + first, tasks.data() + last, search, take);
  });
}

double whole_step() noexcept { return 1; }

}  // namespace

BoxTree::BoxTree(std::size_t count, const std::function<MovingBox(Number)>& box_of, int threads)
    : numbers_(count), boxes_(count) {
  if (count == 0) return;
  Items items(count);
  constexpr std::size_t kItemsAtATime = 4096;
  threads::for_each_range(count, kItemsAtATime, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      items[i].number = static_cast<Number>(i);
      const MovingBox box = box_of(items[i].number);
      std::copy_n(box.start.low.begin(), 3, items[i].at.begin());
      std::copy_n(box.end.low.begin(), 3, items[i].at.begin() + 3);
    }
  });
  std::vector<Subtree> subtrees = build_subtrees({items, numbers_, boxes_, box_of}, threads);
  Items().swap(items);
  std::size_t node_count = subtrees.size();
  for (const Subtree& subtree : subtrees) node_count += subtree.tree.size();
  nodes_.reserve(node_count);
  put_together(subtrees, 0, nodes_);
}

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

bool meet(const MovingBox& a, const MovingBox& b, double until) noexcept {
  TimeInterval times{0, until};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!keep_where_not_negative(b.start.high[k] - a.start.low[k], b.end.high[k] - a.end.low[k], times)) return false;
    if (!keep_where_not_negative(a.start.high[k] - b.start.low[k], a.end.high[k] - b.end.low[k], times)) return false;
  }
  return times.from <= times.to + kTimesError;
}

void for_each_pair_block(const BoxTree& tree, const PairSearch& search, const PairBlockConsumer& take) {
  if (!tree.empty()) run_all(tree, tree, {0, 0, true}, search, take);
}

void for_each_pair_block(const BoxTree& a, const BoxTree& b, const PairSearch& search, const PairBlockConsumer& take) {
  if (!a.empty() && !b.empty()) run_all(a, b, {0, 0, false}, search, take);
}

void for_each_pair(const std::vector<MovingBox>& boxes, const PairConsumer& found) {
  const BoxTree tree(boxes.size(), [&](Number i) { return boxes[i]; });
  if (tree.empty()) return;
  const auto found_positions = [&](Number i, Number j) {
    const Number a = tree.number(i), b = tree.number(j);
    found(std::min(a, b), std::max(a, b));
  };
  Comparison(tree, tree, whole_step, found_positions).within(0);
}

void for_each_pair(const std::vector<MovingBox>& a, const std::vector<MovingBox>& b, const PairConsumer& found) {
  const BoxTree in_a(a.size(), [&](Number i) { return a[i]; }), in_b(b.size(), [&](Number i) { return b[i]; });
  if (in_a.empty() || in_b.empty()) return;
  const auto found_positions = [&](Number i, Number j) { found(in_a.number(i), in_b.number(j)); };
  Comparison(in_a, in_b, whole_step, found_positions).across(0, 0);
}

}  // namespace touchstone::broad_phase
