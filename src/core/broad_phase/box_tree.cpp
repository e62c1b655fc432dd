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

/// The lower bounds, at both ends of a step.
std::array<double, 3> lower_bounds(const Box& box) noexcept { return box.low; }
std::array<double, 6> lower_bounds(const BoundsByAxis& box) noexcept {
  return {box.low[0][0], box.low[1][0], box.low[2][0], box.low[0][1], box.low[1][1], box.low[2][1]};
}

constexpr Number kLeaf = 8;            // boxes in a leaf, at most
constexpr Number kFewest = kLeaf / 2;  // and, in each part of a larger node, at least

/// A box's number, and its lower bounds.
template <class Bounds>
struct Item {
  decltype(lower_bounds(std::declval<Bounds>())) at;
  Number number;
};

template <class Bounds>
using Items = LargeVector<Item<Bounds>>;

struct Extent {
  std::size_t axis;
  double middle;
};

template <class Bounds>
Extent widest_extent(const Items<Bounds>& items, Number first, Number last) noexcept {
  auto least = items[first].at, greatest = least;
  for (Number i = first + 1; i < last; ++i) {
    for (std::size_t axis = 0; axis < least.size(); ++axis) {
      least[axis] = std::min(least[axis], items[i].at[axis]);
      greatest[axis] = std::max(greatest[axis], items[i].at[axis]);
    }
  }
  std::size_t widest = 0;
  for (std::size_t axis = 1; axis < least.size(); ++axis) {
    if (greatest[axis] - least[axis] > greatest[widest] - least[widest]) widest = axis;
  }
  return {widest, 0.5 * least[widest] + 0.5 * greatest[widest]};
}

/// Divides the items [first, last) into two parts. @returns where the second part begins. Only the boxes decide which
/// box is in which part.
template <class Bounds>
Number split(Items<Bounds>& items, Number first, Number last) {
  const auto begin = items.begin() + first, end = items.begin() + last;
  const Extent extent = widest_extent(items, first, last);
  const auto beyond = std::partition(begin, end, [&](const auto& i) { return i.at[extent.axis] < extent.middle; });
  const Number middle = first + static_cast<Number>(beyond - begin);
  const Number fewest = std::max(kFewest, (last - first) / 8);  // so that the depth is logarithmic
  if (middle - first >= fewest && last - middle >= fewest) return middle;
  const Number half = first + (last - first) / 2;
  std::nth_element(begin, items.begin() + half, end, [&](const auto& i, const auto& j) {
    const double x = i.at[extent.axis], y = j.at[extent.axis];
    return x != y ? x < y : i.number < j.number;
  });
  return half;
}

// A node has a place of its own in the array, whatever is built before it: each leaf but the first begins where exactly
// one inner node has its middle, and no two begin less than kFewest positions apart. Between two leaves is the node
// that divides them.
Number number_of_leaf(Number first) noexcept { return first / kFewest * 2; }
Number number_of_inner(Number middle) noexcept { return middle / kFewest * 2 - 1; }

/// Two nodes whose boxes are to be compared; `within`: one node, and both are it.
struct Task {
  Number a, b;
  bool within;
};

/// Whether the nodes x of a and y of b are compared by the children of x.
template <class Node>
bool divides_first(const Node& x, const Node& y) noexcept {
  return y.is_leaf() || (!x.is_leaf() && x.size() >= y.size());
}

/// Compares the boxes of trees. `until()` is the time after which a meeting does not count. `found(position in a,
/// position in b)` is called for boxes that meet.
template <class Bounds, class Until, class Found>
class Comparison {
 public:
  Comparison(const BoxTree<Bounds>& a, const BoxTree<Bounds>& b, const Until& until, const Found& found)
      : a_(a), b_(b), until_(until), found_(found) {}

  void across(Number in_a, Number in_b) const {
    const auto &x = a_.node(in_a), &y = b_.node(in_b);
    if (!meet(x.box, y.box, until_())) return;
    if (x.is_leaf() && y.is_leaf()) {
      for (Number i = x.begin; i < x.end; ++i) {
        const Bounds& box = a_.box(i);
        if (!meet(box, y.box, until_())) continue;
        for (Number j = y.begin; j < y.end; ++j) {
          if (meet(box, b_.box(j), until_())) found_(i, j);
        }
      }
    } else if (divides_first(x, y)) {
      across(x.first, in_b);
      across(x.second, in_b);
    } else {
      across(in_a, y.first);
      across(in_a, y.second);
    }
  }

  /// `a` and `b` are one tree.
  void within(Number at) const {
    const auto& x = a_.node(at);
    if (x.is_leaf()) {
      for (Number i = x.begin; i < x.end; ++i) {
        for (Number j = i + 1; j < x.end; ++j) {
          if (meet(a_.box(i), a_.box(j), until_())) found_(i, j);
        }
      }
      return;
    }
    within(x.first);
    within(x.second);
    across(x.first, x.second);
  }

  void run(const Task& task) const { task.within ? within(task.a) : across(task.a, task.b); }

 private:
  const BoxTree<Bounds>&a_, &b_;
  const Until& until_;
  const Found& found_;
};

constexpr Number kTaskBoxes = 512;  // a task with so many boxes, or fewer, is not divided

/// The comparison of two nodes as tasks, in the order in which Comparison makes them.
template <class Bounds>
void divide(const BoxTree<Bounds>& a, const BoxTree<Bounds>& b, const Task& task, double until,
            std::vector<Task>& tasks) {
  const auto &x = a.node(task.a), &y = b.node(task.b);
  if (task.within) {
    if (x.is_leaf() || x.size() <= kTaskBoxes) {
      tasks.push_back(task);
      return;
    }
    divide(a, b, {x.first, x.first, true}, until, tasks);
    divide(a, b, {x.second, x.second, true}, until, tasks);
    divide(a, b, {x.first, x.second, false}, until, tasks);
    return;
  }
  if (!meet(x.box, y.box, until)) return;
  if ((x.is_leaf() && y.is_leaf()) || x.size() + y.size() <= kTaskBoxes) {
    tasks.push_back(task);
  } else if (divides_first(x, y)) {
    divide(a, b, {x.first, task.b, false}, until, tasks);
    divide(a, b, {x.second, task.b, false}, until, tasks);
  } else {
    divide(a, b, {task.a, y.first, false}, until, tasks);
    divide(a, b, {task.a, y.second, false}, until, tasks);
  }
}

/// Runs tasks one after another, and hands out the pairs in blocks.
template <class Bounds>
void run_tasks(const BoxTree<Bounds>& a, const BoxTree<Bounds>& b, const Task* first, const Task* last,
               const PairSearch& search, const PairBlockConsumer& take) {
  std::array<Pair, kPairBlock> block;
  std::size_t count = 0;
  const auto found = [&](Number i, Number j) {
    block[count++] = {a.number(i), b.number(j)};
    if (count == kPairBlock) {
      take(block.data(), count);
      count = 0;
    }
  };
  const auto time = [&] { return until(search); };
  const Comparison comparison(a, b, time, found);
  for (const Task* task = first; task != last; ++task) comparison.run(*task);
  if (count > 0) take(block.data(), count);
}

template <class Bounds>
void run_all(const BoxTree<Bounds>& a, const BoxTree<Bounds>& b, const std::vector<Task>& wholes,
             const PairSearch& search, const PairBlockConsumer& take) {
  std::vector<Task> tasks;
  for (const Task& whole : wholes) divide(a, b, whole, 1, tasks);
  constexpr std::size_t kTasksAtATime = 16;
  threads::for_each_range(tasks.size(), kTasksAtATime, search.threads, [&](std::size_t first, std::size_t last) {
    run_tasks(a, b, tasks.data() + first, tasks.data() + last, search, take);
  });
}

double whole_step() noexcept { return 1; }

/// A node near the root. Its children are both 0, or numbers of other subtrees.
struct Subtree {
  Number begin, end;
  std::size_t children[2] = {0, 0};
  Number root = 0;  ///< of the tree over its boxes
  bool is_divided() const noexcept { return children[0] != 0; }
};

constexpr Number kSubtreeBoxes = 2048;     // a subtree of so many boxes, or fewer, is not divided among threads
constexpr std::size_t kSubtreeLevels = 6;  // 64 subtrees: enough for most machines

/// Whether a subtree is small enough among `count` boxes that one thread compares all of its boxes.
bool is_small(const Subtree& subtree, std::size_t count) noexcept {
  return (subtree.end - subtree.begin) <= count / 16;
}

}  // namespace

/// Builds a tree. Several threads build its subtrees at the same time: each has its own positions.
template <class Bounds>
class TreeBuilder {
 public:
  TreeBuilder(BoxTree<Bounds>& tree, std::size_t count, const BoxOf<Bounds>& box_of, int threads)
      : tree_(tree), box_of_(box_of), threads_(threads), items_(count) {
    tree.numbers_.resize(count);
    tree.boxes_.resize(count);
    tree.nodes_.resize(number_of_leaf(static_cast<Number>(count)) + 1);
    constexpr std::size_t kItemsAtATime = 4096;
    threads::for_each_range(count, kItemsAtATime, threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const auto number = static_cast<Number>(i);
        items_[i] = {lower_bounds(box_of(number)), number};
      }
    });
  }

  /// The tree's upper levels, level by level, each level's nodes on several threads; then the trees below them.
  /// `built(root)` is called for each of these that is small, by any thread; false ends all, with a tree that is of no
  /// use.
  /// @returns the root, and its subtrees after it
  template <class Built>
  std::vector<Subtree> build_all(const Built& built) {
    std::vector<Subtree> subtrees = divide();
    std::atomic<bool> ends{false};
    threads::for_each_range(subtrees.size(), 1, threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !ends; ++i) {
        if (subtrees[i].is_divided()) continue;
        subtrees[i].root = build(subtrees[i].begin, subtrees[i].end);
        if (is_small(subtrees[i], items_.size()) && !built(subtrees[i].root)) ends = true;
      }
    });
    for (std::size_t i = subtrees.size(); i-- > 0 && !ends;) {  // children come after their parents
      const auto& children = subtrees[i].children;
      if (!subtrees[i].is_divided()) continue;
      subtrees[i].root = join_children(subtrees[children[0]].root, subtrees[children[1]].root);
    }
    tree_.root_ = subtrees[0].root;
    return subtrees;
  }

 private:
  std::vector<Subtree> divide() {
    std::vector<Subtree> subtrees(1);
    subtrees[0].begin = 0;
    subtrees[0].end = static_cast<Number>(items_.size());
    std::size_t level_begin = 0;
    for (std::size_t level = 0; level < kSubtreeLevels; ++level) {
      const std::size_t level_end = subtrees.size();
      std::vector<Number> middles(level_end - level_begin, 0);
      threads::for_each_range(middles.size(), 1, threads_, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const Subtree& subtree = subtrees[level_begin + i];
          if (subtree.end - subtree.begin > kSubtreeBoxes) middles[i] = split(items_, subtree.begin, subtree.end);
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
          subtrees.push_back(subtree);
        }
      }
      level_begin = level_end;
    }
    return subtrees;
  }

  /// Builds the tree over the positions [first, last). @returns the number of its root
  Number build(Number first, Number last) {
    if (last - first > kLeaf) {
      const Number middle = split(items_, first, last);
      const Number begin = build(first, middle);
      return join_children(begin, build(middle, last));
    }
    std::sort(items_.begin() + first, items_.begin() + last,
              [](const auto& i, const auto& j) { return i.number < j.number; });
    for (Number i = first; i < last; ++i) {
      tree_.numbers_[i] = items_[i].number;
      tree_.boxes_[i] = box_of_(items_[i].number);
    }
    auto& node = tree_.nodes_[number_of_leaf(first)];
    node = {tree_.boxes_[first], first, last, 0, 0};
    for (Number i = first + 1; i < last; ++i) extend_by(node.box, tree_.boxes_[i]);
    return number_of_leaf(first);
  }

  /// Makes an inner node of two others. @returns its number
  Number join_children(Number first, Number second) {
    auto& nodes = tree_.nodes_;
    const Number at = number_of_inner(nodes[second].begin);
    nodes[at] = {nodes[first].box, nodes[first].begin, nodes[second].end, first, second};
    extend_by(nodes[at].box, nodes[second].box);
    return at;
  }

  BoxTree<Bounds>& tree_;
  const BoxOf<Bounds>& box_of_;
  int threads_;
  Items<Bounds> items_;
};

BoundsByAxis by_axis(const MovingBox& box) noexcept {
  BoundsByAxis bounds;
  for (std::size_t k = 0; k < 3; ++k) {
    bounds.low[k] = BoundsByAxis::AtBothEnds{box.start.low[k], box.end.low[k]};
    bounds.high[k] = BoundsByAxis::AtBothEnds{box.start.high[k], box.end.high[k]};
  }
  return bounds;
}

[[gnu::noinline]] bool meet_between(const BoundsByAxis& a, const BoundsByAxis& b, double until) noexcept {
  if (until < 0) return false;
  TimeInterval times{0, until};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto f = b.high[k] - a.low[k], g = a.high[k] - b.low[k];
    if (!keep_where_not_negative(f[0], f[1], times) || !keep_where_not_negative(g[0], g[1], times)) return false;
  }
  return times.from <= times.to + kTimesError;
}

template <class Bounds>
BoxTree<Bounds>::BoxTree(std::size_t count, const BoxOf<Bounds>& box_of, int threads) {
  if (count > 0) TreeBuilder<Bounds>(*this, count, box_of, threads).build_all([](Number) { return true; });
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

bool meet(const MovingBox& a, const MovingBox& b, double until) noexcept { return meet(by_axis(a), by_axis(b), until); }

template <class Bounds>
void for_each_pair_block(const BoxTree<Bounds>& tree, const PairSearch& search, const PairBlockConsumer& take) {
  if (!tree.empty()) run_all(tree, tree, {{tree.root(), tree.root(), true}}, search, take);
}

template <class Bounds>
void for_each_pair_block(const BoxTree<Bounds>& a, const BoxTree<Bounds>& b, const PairSearch& search,
                         const PairBlockConsumer& take) {
  if (!a.empty() && !b.empty()) run_all(a, b, {{a.root(), b.root(), false}}, search, take);
}

template <class Bounds>
void for_each_pair_block(std::size_t count, const BoxOf<Bounds>& box_of, const PairSearch& search,
                         const PairBlockConsumer& take) {
  if (count == 0) return;
  BoxTree<Bounds> tree;
  const std::vector<Subtree> subtrees =
      TreeBuilder<Bounds>(tree, count, box_of, search.threads).build_all([&](Number root) {
        const Task within{root, root, true};
        run_tasks(tree, tree, &within, &within + 1, search, take);
        return until(search) >= 0;
      });
  if (until(search) < 0) return;
  std::vector<Task> tasks;
  for (const Subtree& subtree : subtrees) {
    if (subtree.is_divided()) {
      tasks.push_back({subtrees[subtree.children[0]].root, subtrees[subtree.children[1]].root, false});
    } else if (!is_small(subtree, count)) {
      tasks.push_back({subtree.root, subtree.root, true});
    }
  }
  run_all(tree, tree, tasks, search, take);
}

#define TOUCHSTONE_TREES_OF(Bounds)                                                                       \
  template class BoxTree<Bounds>;                                                                         \
  template void for_each_pair_block(const BoxTree<Bounds>&, const PairSearch&, const PairBlockConsumer&); \
  template void for_each_pair_block(const BoxTree<Bounds>&, const BoxTree<Bounds>&, const PairSearch&,    \
                                    const PairBlockConsumer&);                                            \
  template void for_each_pair_block<Bounds>(std::size_t, const BoxOf<Bounds>&, const PairSearch&,         \
                                            const PairBlockConsumer&)
TOUCHSTONE_TREES_OF(Box);
TOUCHSTONE_TREES_OF(BoundsByAxis);
#undef TOUCHSTONE_TREES_OF

namespace {

BoxTree<BoundsByAxis> tree_of(const std::vector<MovingBox>& boxes) {
  return {boxes.size(), [&](Number i) { return by_axis(boxes[i]); }};
}

}  // namespace

void for_each_pair(const std::vector<MovingBox>& boxes, const PairConsumer& found) {
  const BoxTree tree = tree_of(boxes);
  if (tree.empty()) return;
  const auto found_positions = [&](Number i, Number j) {
    const Number a = tree.number(i), b = tree.number(j);
    found(std::min(a, b), std::max(a, b));
  };
  Comparison(tree, tree, whole_step, found_positions).within(tree.root());
}

void for_each_pair(const std::vector<MovingBox>& a, const std::vector<MovingBox>& b, const PairConsumer& found) {
  const BoxTree in_a = tree_of(a), in_b = tree_of(b);
  if (in_a.empty() || in_b.empty()) return;
  const auto found_positions = [&](Number i, Number j) { found(in_a.number(i), in_b.number(j)); };
  Comparison(in_a, in_b, whole_step, found_positions).across(in_a.root(), in_b.root());
}

}  // namespace touchstone::broad_phase
