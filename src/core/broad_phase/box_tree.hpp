// The pairs of moving boxes that overlap at some time: a tree of boxes. The time is nearly linear in the number of
// boxes, even if every box moves so fast that it passes over the places of many others.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "broad_phase/box.hpp"
#include "broad_phase/large_vector.hpp"

namespace touchstone::broad_phase {

/// A box whose bounds move evenly from those at t = 0 to those at t = 1. A corner that is in the box at both ends, and
/// moves on a straight line, is in the box at all times.
struct MovingBox {
  Box start, end;
};

/// A box with nothing in it, for `join`.
MovingBox empty_moving_box() noexcept;

/// Extends `box` so that it contains the other box at all times.
void join(MovingBox& box, const MovingBox& other) noexcept;

/// The same with the bounds of both ends side by side.
struct BoundsByAxis {
  typedef double AtBothEnds __attribute__((vector_size(16)));
  AtBothEnds low[3], high[3];
};

BoundsByAxis by_axis(const MovingBox& box) noexcept;

/// As meet, for boxes that are apart along some axis at one end of the step.
bool meet_between(const BoundsByAxis& a, const BoundsByAxis& b, double until) noexcept;

/// False proves that the boxes are disjoint at all times in [0, until], until <= 1. It is false where until < 0.
/// Most boxes are apart along an axis at both ends, or along none: comparisons without branches tell these from others.
inline bool meet(const BoundsByAxis& a, const BoundsByAxis& b, double until = 1) noexcept {
  using Mask = decltype(a.low[0] < b.low[0]);
  Mask apart{}, at_an_end{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Mask below = a.high[k] < b.low[k], above = b.high[k] < a.low[k];
    apart |= Mask{below[0], above[0]} & Mask{below[1], above[1]};
    at_an_end |= below | above;
  }
  if ((apart[0] | apart[1]) != 0) return false;
  return (at_an_end[0] | at_an_end[1]) == 0 ? until >= 0 : meet_between(a, b, until);
}
bool meet(const MovingBox& a, const MovingBox& b, double until = 1) noexcept;

/// The same for boxes at rest.
inline bool meet(const Box& a, const Box& b, double until = 1) noexcept {
  int apart = int{until < 0};
  for (std::size_t k = 0; k < 3; ++k) apart |= int{a.high[k] < b.low[k]} | int{b.high[k] < a.low[k]};
  return apart == 0;
}

/// Extends a box so that it contains the other one, at all times.
template <class Bounds>
void extend_by(Bounds& box, const Bounds& other) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = other.low[k] < box.low[k] ? other.low[k] : box.low[k];
    box.high[k] = box.high[k] < other.high[k] ? other.high[k] : box.high[k];
  }
}

/// The box with a number. It is asked at most twice for each box, from several threads.
template <class Bounds>
using BoxOf = std::function<Bounds(std::uint32_t)>;

/// A binary tree over boxes: at rest, `Bounds` is Box, or in motion, BoundsByAxis. The boxes of a node are near each
/// other, at both ends of the step.
template <class Bounds>
class BoxTree {
 public:
  using Number = std::uint32_t;

  /// A tree over no box.
  BoxTree() = default;

  /// @param count    the number of boxes, below 2^32
  /// @param threads  the number of threads, as in threads::for_each_range; the tree does not depend on it
  BoxTree(std::size_t count, const BoxOf<Bounds>& box_of, int threads = 1);

  struct Node {
    Bounds box;
    Number begin, end;     ///< the positions of its boxes: begin, ..., end - 1
    Number first, second;  ///< the children; the second is 0 in a leaf
    bool is_leaf() const noexcept { return second == 0; }
    Number size() const noexcept { return end - begin; }
  };

  bool empty() const noexcept { return nodes_.empty(); }
  Number root() const noexcept { return root_; }
  const Node& node(Number n) const noexcept { return nodes_[n]; }
  Number number(Number position) const noexcept { return numbers_[position]; }
  const Bounds& box(Number position) const noexcept { return boxes_[position]; }

 private:
  template <class>
  friend class TreeBuilder;

  LargeVector<Number> numbers_;  // by position
  LargeVector<Bounds> boxes_;    // by position
  LargeVector<Node> nodes_;      // not all of its places hold one
  Number root_ = 0;
};

/// The numbers of two boxes.
using Pair = std::array<std::uint32_t, 2>;

/// Takes some of the pairs, at most kPairBlock at a time. Several threads may call it at the same time.
using PairBlockConsumer = std::function<void(const Pair* pairs, std::size_t count)>;
inline constexpr std::size_t kPairBlock = 512;

struct PairSearch {
  int threads = 1;

  /// Boxes that meet only after this time need not be found. It is read again and again, and may fall meanwhile. Null:
  /// 1.
  const std::atomic<double>* until = nullptr;
};

inline double until(const PairSearch& search) noexcept {
  return search.until == nullptr ? 1.0 : search.until->load(std::memory_order_relaxed);
}

/// Hands out each pair of boxes that meet, once, in either order, and no other pair. With one thread, the order depends
/// on the boxes only.
template <class Bounds>
void for_each_pair_block(const BoxTree<Bounds>& tree, const PairSearch& search, const PairBlockConsumer& take);

/// The same of boxes that have no tree yet. Pairs are handed out while it is built: so a search that ends early, by a
/// time below 0, waits for a part of it only.
template <class Bounds>
void for_each_pair_block(std::size_t count, const BoxOf<Bounds>& box_of, const PairSearch& search,
                         const PairBlockConsumer& take);

/// The same for box i of `a` and box j of `b`.
template <class Bounds>
void for_each_pair_block(const BoxTree<Bounds>& a, const BoxTree<Bounds>& b, const PairSearch& search,
                         const PairBlockConsumer& take);

/// Calls found(i, j) once for each i < j whose boxes meet, and for no other pair. The order of the calls depends on the
/// boxes only.
void for_each_pair(const std::vector<MovingBox>& boxes, const PairConsumer& found);

/// The same for box i of `a` and box j of `b`.
void for_each_pair(const std::vector<MovingBox>& a, const std::vector<MovingBox>& b, const PairConsumer& found);

}  // namespace touchstone::broad_phase
