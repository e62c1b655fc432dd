// The elements of a motion, the rules that make pairs of them, and their boxes during a step.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "broad_phase/box_tree.hpp"
#include "proofs/mesh_motion.hpp"

namespace touchstone::proofs {

using broad_phase::Box;
using RestingTree = broad_phase::BoxTree<Box>;
using Index = std::uint32_t;

template <std::size_t N, std::size_t M>
bool share_vertex(const std::array<Index, N>& a, const std::array<Index, M>& b) noexcept {
  return std::any_of(a.begin(), a.end(), [&](Index v) { return std::find(b.begin(), b.end(), v) != b.end(); });
}

/// The elements of one sort. `corners(i)` has the vertices of element i, and `number(i)` is its number in the motion.
struct Points {
  const std::vector<Index>& vertices;
  std::size_t size() const noexcept { return vertices.size(); }
  Index number(Index i) const noexcept { return i; }
  std::array<Index, 1> corners(Index i) const noexcept { return {vertices[i]}; }
};

/// Some of the points: those that are a corner of no edge, or those that are corners of wires.
struct SomePoints {
  const std::vector<Index>& vertices;
  const std::vector<Index>& numbers;
  std::size_t size() const noexcept { return numbers.size(); }
  Index number(Index i) const noexcept { return numbers[i]; }
  std::array<Index, 1> corners(Index i) const noexcept { return {vertices[numbers[i]]}; }
};

template <std::size_t N>
struct Cells {
  const std::vector<std::array<Index, N>>& cells;
  std::size_t size() const noexcept { return cells.size(); }
  Index number(Index i) const noexcept { return i; }
  const std::array<Index, N>& corners(Index i) const noexcept { return cells[i]; }
};

struct SomeEdges {
  const std::vector<std::array<Index, 2>>& edges;
  const std::vector<Index>& numbers;
  std::size_t size() const noexcept { return numbers.size(); }
  Index number(Index i) const noexcept { return numbers[i]; }
  const std::array<Index, 2>& corners(Index i) const noexcept { return edges[numbers[i]]; }
};

inline std::array<Index, 2> side(Index v, Index w) noexcept { return {std::min(v, w), std::max(v, w)}; }

/// Any two elements, so far as the rules leave them.
struct Always {
  template <class A, class B>
  bool operator()(const A&, const B&) const noexcept {
    return true;
  }
};

/// The wires of a motion: which vertices they join.
struct Joined {
  const std::vector<std::array<Index, 2>>& joined;  ///< sorted
  /// Whether a wire joins the point to the edge.
  bool operator()(const std::array<Index, 1>& point, const std::array<Index, 2>& edge) const noexcept {
    return std::any_of(edge.begin(), edge.end(), [&](Index end) {
      return std::binary_search(joined.begin(), joined.end(), side(point[0], end));
    });
  }
};

/// What makes two elements a pair, wherever they are.
class Rules {
 public:
  explicit Rules(const MotionElements& elements) : elements_(elements) {}

  template <std::size_t N, std::size_t M>
  bool may_meet(const std::array<Index, N>& a, const std::array<Index, M>& b) const noexcept {
    if (share_vertex(a, b)) return false;
    if (!elements_.fixed.empty() && all_fixed(a) && all_fixed(b)) return false;
    if (!elements_.groups.are_asked(a, b)) return false;
    return elements_.on_bodies.empty() || !on_one_body(a, b);
  }

  /// Whether there is a pair of elements of two lists, of which the first one may be the second one too.
  template <class ListA, class ListB, class Keep = Always>
  bool has_pair(const ListA& a, const ListB& b, const Keep& keep = {}) const {
    if (a.size() == 0 || b.size() == 0) return false;
    const auto all = [&](const auto& holds) {
      for (Index i = 0; i < a.size(); ++i) {
        if (!holds(a.corners(i))) return false;
      }
      for (Index j = 0; j < b.size(); ++j) {
        if (!holds(b.corners(j))) return false;
      }
      return true;
    };
    // Without a look at each pair: nothing moves, or nothing but one body.
    if (!elements_.fixed.empty() && all([&](const auto& e) { return all_fixed(e); })) return false;
    const auto first = a.corners(0);
    if (!elements_.on_bodies.empty() && all([&](const auto& e) { return on_one_body(first, e); })) return false;
    auto has_partner = partners_in(b);
    for (Index i = 0; i < a.size(); ++i) {
      const auto& corners = a.corners(i);
      if (std::none_of(corners.begin(), corners.end(), std::ref(has_partner))) continue;
      for (Index j = 0; j < b.size(); ++j) {
        if (may_meet(a.corners(i), b.corners(j)) && keep(a.corners(i), b.corners(j))) return true;
      }
    }
    return false;
  }

 private:
  /// A function of a vertex: is its group asked about with one of the list?
  template <class List>
  auto partners_in(const List& list) const {
    std::set<Index> groups;
    const auto& group_of = elements_.groups.of_vertices;
    for (Index i = 0; i < list.size() && !group_of.empty(); ++i) {
      for (const Index v : list.corners(i)) groups.insert(group_of[v]);
    }
    return [&group_of, groups, this, known = std::map<Index, bool>()](Index v) mutable {
      if (group_of.empty()) return true;
      const auto [found, is_new] = known.emplace(group_of[v], false);
      if (is_new) {
        found->second = std::any_of(groups.begin(), groups.end(),
                                    [&](Index h) { return elements_.groups.are_asked(group_of[v], h); });
      }
      return found->second;
    };
  }

  template <std::size_t N>
  bool all_fixed(const std::array<Index, N>& corners) const noexcept {
    return std::all_of(corners.begin(), corners.end(), [&](Index v) { return elements_.fixed[v] != 0; });
  }

  template <std::size_t N, std::size_t M>
  bool on_one_body(const std::array<Index, N>& a, const std::array<Index, M>& b) const noexcept {
    const std::size_t free = elements_.free_count();
    const auto is_elsewhere = [&](Index v) {
      return v < free || a[0] < free || elements_.on_bodies[v - free].body != elements_.on_bodies[a[0] - free].body;
    };
    return std::none_of(a.begin(), a.end(), is_elsewhere) && std::none_of(b.begin(), b.end(), is_elsewhere);
  }

  const MotionElements& elements_;
};

/// How far apart the boxes of a pair may be, and the most that it can be.
struct BoxReach {
  double largest;
  std::function<double(const MotionPair&)> of;
};

/// The boxes of a step, and its pairs. The box of a vertex reaches from `start` to `end` along each axis.
class StepBoxes {
 public:
  StepBoxes(const MotionElements& elements, const MotionFrame& start, const MotionFrame& end, BoxReach reach,
            int threads)
      : rules_(elements), start_(start), end_(end), reach_(std::move(reach)), threads_(threads) {}

  template <class List>
  RestingTree tree(const List& list) const {
    // The tree finds boxes that meet. So each is wider by half of the largest reach or more; what it finds beyond the
    // pairs is left out by an exact comparison. Half of a subnormal reach may be no double.
    const double reach = reach_.largest > 0 ? std::max(reach_.largest / 2, std::numeric_limits<double>::min()) : 0;
    return RestingTree(
        list.size(),
        [&](Index i) {
          Box box = around(list.corners(i));
          broad_phase::grow(box, reach);
          // A bound beyond all doubles would be infinite, and no coordinate is beyond the largest one either.
          constexpr double kLargest = std::numeric_limits<double>::max();
          for (std::size_t k = 0; k < 3; ++k) {
            box.low[k] = std::max(box.low[k], -kLargest);
            box.high[k] = std::min(box.high[k], kLargest);
          }
          return box;
        },
        threads_);
  }

  /// Adds the pairs of elements of two lists, or, where `tree_b` is null, of the first one, in order.
  template <class ListA, class ListB, class Keep = Always>
  void add_pairs(Kind kind, const ListA& a, const RestingTree& tree_a, const ListB& b, const RestingTree* tree_b,
                 std::vector<MotionPair>& pairs, const Keep& keep = {}) const {
    const auto before = static_cast<std::ptrdiff_t>(pairs.size());
    std::mutex lock;
    const auto take = [&](const broad_phase::Pair* found, std::size_t count) {
      std::array<MotionPair, broad_phase::kPairBlock> kept;
      std::size_t kept_count = 0;
      for (std::size_t n = 0; n < count; ++n) {
        auto [i, j] = found[n];
        if (tree_b == nullptr && j < i) std::swap(i, j);
        const MotionPair pair{kind, a.number(i), b.number(j)};
        if (!rules_.may_meet(a.corners(i), b.corners(j)) || !keep(a.corners(i), b.corners(j))) continue;
        if (are_near(a.corners(i), b.corners(j), reach_.of(pair))) kept[kept_count++] = pair;
      }
      const std::lock_guard<std::mutex> guard(lock);
      pairs.insert(pairs.end(), kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(kept_count));
    };
    broad_phase::PairSearch search;
    search.threads = threads_;
    if (tree_b == nullptr) {
      broad_phase::for_each_pair_block(tree_a, search, take);
    } else {
      broad_phase::for_each_pair_block(tree_a, *tree_b, search, take);
    }
    std::sort(pairs.begin() + before, pairs.end(), [](const MotionPair& one, const MotionPair& other) {
      return std::tie(one.first, one.second) < std::tie(other.first, other.second);
    });
  }

 private:
  template <std::size_t N>
  Box around(const std::array<Index, N>& corners) const noexcept {
    Box box = broad_phase::empty_box();
    for (const Index corner : corners) {
      broad_phase::extend(box, start_[corner]);
      broad_phase::extend(box, end_[corner]);
    }
    return box;
  }

  template <std::size_t N, std::size_t M>
  bool are_near(const std::array<Index, N>& a, const std::array<Index, M>& b, double reach) const noexcept {
    const Box box_a = around(a), box_b = around(b);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!at_most_apart(box_a.low[k], box_b.high[k], reach)) return false;
      if (!at_most_apart(box_b.low[k], box_a.high[k], reach)) return false;
    }
    return true;
  }

  Rules rules_;
  const MotionFrame& start_;
  const MotionFrame& end_;
  BoxReach reach_;
  int threads_;
};

}  // namespace touchstone::proofs
