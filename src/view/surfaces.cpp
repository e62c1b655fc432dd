// SPDX-License-Identifier: MIT
#include "view/surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>

namespace touchstone::view {
namespace {

/// Vertices that edges and faces connect, as trees towards one of them.
class Connected {
 public:
  explicit Connected(std::size_t count) : above_(count) { std::iota(above_.begin(), above_.end(), 0U); }

  std::uint32_t root(std::uint32_t v) {
    while (above_[v] != v) v = above_[v] = above_[above_[v]];
    return v;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    above_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> above_;
};

/// The root of the set of vertices that is much larger than all others in the first frame, as a floor is, if there is
/// one.
std::optional<std::uint32_t> floor_of(const Animation& animation, Connected& connected,
                                      const std::vector<char>& drawn) {
  constexpr double kLarger = 2;
  struct Extent {
    Triple low, high;
  };
  std::map<std::uint32_t, Extent> boxes;
  for (std::uint32_t v = 0; v < drawn.size(); ++v) {
    if (drawn[v] == 0) continue;
    const Triple x = animation.frames().front().drawn.position(v);
    Extent& box = boxes.try_emplace(connected.root(v), Extent{x, x}).first->second;
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], x[k]);
      box.high[k] = std::max(box.high[k], x[k]);
    }
  }
  double largest = 0, next = 0;
  std::optional<std::uint32_t> floor;
  for (const auto& [root, box] : boxes) {
    const double size = std::hypot(box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]);
    next = std::max(next, std::min(size, largest));
    if (size > largest) {
      largest = size;
      floor = root;
    }
  }
  return boxes.size() > 1 && largest > kLarger * next ? floor : std::nullopt;
}

}  // namespace

std::vector<char> moving_vertices(const Animation& animation) {
  std::vector<char> moves(animation.shape().vertex_count(), 0);
  const AnimationFrame& first = animation.frames().front();
  for (const AnimationFrame& frame : animation.frames()) {
    const double rounding = std::ldexp(1.0, frame.drawn.exponent);  // no frame before has a larger one
    for (std::size_t i = 0; i < frame.drawn.steps.size(); ++i) {
      const double way = frame.drawn.coordinate(i / 3, i % 3) - first.drawn.coordinate(i / 3, i % 3);
      if (std::abs(way) > rounding) moves[i / 3] = 1;
    }
  }
  return moves;
}

std::vector<std::uint8_t> hues_of(const Animation& animation) {
  const AnimationShape& shape = animation.shape();
  Connected connected(shape.vertex_count());
  std::vector<char> drawn(shape.vertex_count(), 0);
  const auto add = [&](const auto& corners) {
    for (const std::uint32_t v : corners) {
      connected.join(corners[0], v);
      drawn[v] = 1;
    }
  };
  for (const auto& edge : shape.edges) add(edge);
  for (const auto& face : shape.faces) add(face);
  for (const std::uint32_t v : shape.points) add(std::array{v});
  std::uint32_t first = 0;
  for (const AnimationGroup& group : shape.groups) {
    for (std::uint32_t v = 1; v < group.vertices && !group.name.empty(); ++v) connected.join(first, first + v);
    first += group.vertices;
  }
  const std::vector<char> moves = moving_vertices(animation);
  std::vector<char> any_moves(moves.size(), 0);  // by root
  bool something_moves = false;
  for (std::uint32_t v = 0; v < moves.size(); ++v) {
    if (moves[v] == 0 || drawn[v] == 0) continue;
    any_moves[connected.root(v)] = 1;
    something_moves = true;
  }
  const auto floor = something_moves ? std::nullopt : floor_of(animation, connected, drawn);
  std::vector<std::uint8_t> hues(moves.size(), 0);
  std::size_t sets = 0;
  for (std::uint32_t v = 0; v < hues.size(); ++v) {
    const std::uint32_t root = connected.root(v);
    if (root != v) {
      hues[v] = hues[root];  // a root comes before its vertices
    } else if (drawn[v] != 0 && (any_moves[v] != 0 || (!something_moves && v != floor))) {
      hues[v] = static_cast<std::uint8_t>(1 + sets++ % (kHues.size() - 1));
    }
  }
  return hues;
}

}  // namespace touchstone::view
