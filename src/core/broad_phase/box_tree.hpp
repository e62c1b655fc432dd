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

/// False proves that the boxes are disjoint at all times in [0, until], until <= 1. It is false where until <= -1.
bool meet(const MovingBox& a, const MovingBox& b, double until = 1) noexcept;

/// The same with the bounds of both ends side by side.
struct BoundsByAxis {
  typedef double AtBothEnds __attribute__((vector_size(16)));
  AtBothEnds low[3], high[3];
};

/// A binary tree over boxes. The boxes of a node are near each other at both ends of the step.
class BoxTree {
 public:
  using Number = std::uint32_t;

  /// @param count    the number of boxes, below 2^32
  /// @param box_of   box i; it is asked twice for each box, from several threads
  /// @param threads  the number of threads, as in threads::for_each_range; the tree does not depend on it
  BoxTree(std::size_t count, const std::function<MovingBox(Number)>& box_of, int threads = 1);

  struct Node {
    BoundsByAxis box;
    Number begin, end;     ///< the positions of its boxes: begin, ..., end - 1
    Number first, second;  ///< the children; the second is 0 in a leaf
    bool is_leaf() const noexcept { return second == 0; }
    Number size() const noexcept { return end - begin; }
  };

  bool empty() const noexcept { return nodes_.empty(); }
  Number root() const noexcept { return root_; }
  const Node& node(Number n) const noexcept { return nodes_[n]; }
  Number number(Number position) const noexcept { return numbers_[position]; }
  const BoundsByAxis& box(Number position) const noexcept { return boxes_[position]; }

 private:
  LargeVector<Number> numbers_;      // by position
  LargeVector<BoundsByAxis> boxes_;  // by position
  LargeVector<Node> nodes_;          // not all of its places hold one
  Number root_ = 0;
};

/// The numbers of two boxes.
using Pair = std::array<std::uint32_t, 2>;

/// Takes some of the pairs, at most kPairBlock at a time. Several threads may call it at the same time.
using PairBlockConsumer = std::function<void(const Pair* pairs, std::size_t count)>;
inline constexpr std::size_t kPairBlock = 1024;

struct PairSearch {
  int threads = 1;

  /// Boxes that meet only after this time need not be found. It is read again and again, and may fall meanwhile. Null:
  /// 1.
  const std::atomic<double>* until = nullptr;
};

/// Hands out each pair i < j of boxes that meet, once, and no other pair. With one thread, the order depends on the
/// boxes only.
void for_each_pair_block(const BoxTree& tree, const PairSearch& search, const PairBlockConsumer& take);

/// The same for box i of `a` and box j of `b`.
void for_each_pair_block(const BoxTree& a, const BoxTree& b, const PairSearch& search, const PairBlockConsumer& take);

/// Calls found(i, j) once for each i < j whose boxes meet, and for no other pair. The order of the calls depends on the
/// boxes only.
void for_each_pair(const std::vector<MovingBox>& boxes, const PairConsumer& found);

/// The same for box i of `a` and box j of `b`.
void for_each_pair(const std::vector<MovingBox>& a, const std::vector<MovingBox>& b, const PairConsumer& found);

}  // namespace touchstone::broad_phase
