// SPDX-License-Identifier: MIT
#include "proofs/motion.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <mutex>
#include <tuple>
#include <utility>

#include <touchstone/curved.hpp>
#include <touchstone/solve.hpp>

#include "broad_phase/box_tree.hpp"
#include "io/times.hpp"
#include "numbers/float_environment.hpp"
#include "proofs/body_box.hpp"
#include "proofs/proof_text.hpp"

namespace touchstone::proofs {
namespace {

using broad_phase::Box;
using broad_phase::BoxTree;
using broad_phase::MovingBox;
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

/// The points that are a corner of no edge.
struct LoosePoints {
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

RigidMotion motion_of(std::uint32_t body, const MotionFrame& start, const MotionFrame& end) {
  const MotionPose &from = start.poses[body], &to = end.poses[body];
  return {from.q, to.q, from.p, to.p};
}

/// What makes two elements a pair, wherever they are.
class Rules {
 public:
  explicit Rules(const MotionElements& elements) : elements_(elements) {}

  template <std::size_t N, std::size_t M>
  bool may_meet(const std::array<Index, N>& a, const std::array<Index, M>& b) const noexcept {
    if (share_vertex(a, b)) return false;
    if (!elements_.fixed.empty() && all_fixed(a) && all_fixed(b)) return false;
    return elements_.on_bodies.empty() || !on_one_body(a, b);
  }

  /// Whether there is a pair of elements of two lists, of which the first one may be the second one too.
  template <class ListA, class ListB>
  bool has_pair(const ListA& a, const ListB& b) const {
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
    for (Index i = 0; i < a.size(); ++i) {
      for (Index j = 0; j < b.size(); ++j) {
        if (may_meet(a.corners(i), b.corners(j))) return true;
      }
    }
    return false;
  }

 private:
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

/// The boxes of a step, and its pairs. The box of a vertex reaches from `start` to `end` along each
/// axis.
class StepBoxes {
 public:
  StepBoxes(const MotionElements& elements, const MotionFrame& start, const MotionFrame& end, double distance,
            int threads)
      : rules_(elements), start_(start), end_(end), distance_(distance), threads_(threads) {}

  template <class List>
  BoxTree tree(const List& list) const {
    // The tree finds boxes that meet. So each is wider by half of the distance or more; what it finds beyond the pairs
    // is left out by an exact comparison. Half of a subnormal distance may be no double.
    const double reach = distance_ > 0 ? std::max(distance_ / 2, std::numeric_limits<double>::min()) : 0;
    return BoxTree(
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
          return MovingBox{box, box};
        },
        threads_);
  }

  /// Adds the pairs of elements of two lists, or, where `tree_b` is null, of the first one, in order.
  template <class ListA, class ListB>
  void add_pairs(Kind kind, const ListA& a, const BoxTree& tree_a, const ListB& b, const BoxTree* tree_b,
                 std::vector<MotionPair>& pairs) const {
    const auto before = static_cast<std::ptrdiff_t>(pairs.size());
    std::mutex lock;
    const auto take = [&](const broad_phase::Pair* found, std::size_t count) {
      std::array<MotionPair, broad_phase::kPairBlock> kept;
      std::size_t kept_count = 0;
      for (std::size_t n = 0; n < count; ++n) {
        const auto [i, j] = found[n];
        if (is_pair(a.corners(i), b.corners(j))) kept[kept_count++] = {kind, a.number(i), b.number(j)};
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
  bool is_pair(const std::array<Index, N>& a, const std::array<Index, M>& b) const noexcept {
    if (!rules_.may_meet(a, b)) return false;
    const Box box_a = around(a), box_b = around(b);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!at_most_apart(box_a.low[k], box_b.high[k], distance_)) return false;
      if (!at_most_apart(box_b.low[k], box_a.high[k], distance_)) return false;
    }
    return true;
  }

  Rules rules_;
  const MotionFrame& start_;
  const MotionFrame& end_;
  double distance_;
  int threads_;
};

void append_coordinate(std::string& to, double x) { to += x == 0 ? "0" : io::hexfloat(x); }

/// With the end of the line.
void append_point(std::string& to, const Vec3& point) {
  append_coordinate(to, point.x);
  to += ' ';
  append_coordinate(to, point.y);
  to += ' ';
  append_coordinate(to, point.z);
  to += '\n';
}

}  // namespace

std::vector<std::uint32_t> colliding_vertices(const std::vector<std::array<std::uint32_t, 2>>& edges,
                                              const std::vector<std::uint32_t>& loose_points) {
  std::vector<Index> vertices = loose_points;
  vertices.reserve(loose_points.size() + 2 * edges.size());
  for (const auto& edge : edges) vertices.insert(vertices.end(), edge.begin(), edge.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

// Rounding to the nearest double keeps the order, and a and the sum's rounding s are doubles. So a < s implies a <= b +
// distance, and a > s the opposite. For a = s the error of the sum decides. Of the two terms let x be the one that is
// at least as large as y in absolute value; then s - x and y - (s - x) are exact (Dekker). A sum beyond the largest
// double is s = infinity, and more than a.
bool at_most_apart(double a, double b, double distance) noexcept {
  const double s = b + distance;
  if (a != s) return a < s;
  const auto [x, y] = std::fabs(b) < distance ? std::pair(distance, b) : std::pair(b, distance);
  return y - (s - x) >= 0;
}

StepProver::StepProver(MotionElements elements, const Separation& separation)
    : elements_(std::move(elements)), separation_(separation) {
  std::vector<char> in_edge(elements_.vertex_count, 0);
  for (const auto& edge : elements_.edges) in_edge[edge[0]] = in_edge[edge[1]] = 1;
  for (Index i = 0; i < elements_.points.size(); ++i) {
    if (in_edge[elements_.points[i]] == 0) loose_.push_back(i);
  }
}

bool StepProver::has_pair() const {
  const Rules rules(elements_);
  const LoosePoints loose{elements_.points, loose_};
  const Cells<2> edges{elements_.edges};
  return rules.has_pair(edges, edges) || rules.has_pair(Points{elements_.points}, Cells<3>{elements_.faces}) ||
         rules.has_pair(loose, edges) || rules.has_pair(loose, loose);
}

std::vector<MotionPair> StepProver::pairs(const MotionFrame& start, const MotionFrame& end, int threads) const {
  const numbers::DefaultFloatEnvironment environment;
  MotionFrame low, high;
  if (!elements_.on_bodies.empty()) {
    low = start;
    high = end;
    for (const BodyVertex& vertex : elements_.on_bodies) {
      const PointBox box = box_on_body(motion_of(vertex.body, start, end), vertex.point);
      low.push_back(box.low);
      high.push_back(box.high);
    }
  }
  const bool straight = elements_.on_bodies.empty();
  const StepBoxes boxes(elements_, straight ? start : low, straight ? end : high, separation_.distance, threads);
  const Points points{elements_.points};
  const LoosePoints loose{elements_.points, loose_};
  const Cells<2> edges{elements_.edges};
  const Cells<3> faces{elements_.faces};
  const BoxTree edge_tree = boxes.tree(edges), loose_tree = boxes.tree(loose);
  std::vector<MotionPair> pairs;
  boxes.add_pairs(Kind::edge_edge, edges, edge_tree, edges, nullptr, pairs);
  if (faces.size() > 0) {
    const BoxTree point_tree = boxes.tree(points), face_tree = boxes.tree(faces);
    boxes.add_pairs(Kind::vertex_face, points, point_tree, faces, &face_tree, pairs);
  }
  boxes.add_pairs(Kind::point_edge, loose, loose_tree, edges, &edge_tree, pairs);
  boxes.add_pairs(Kind::point_point, loose, loose_tree, loose, nullptr, pairs);
  return pairs;
}

std::array<std::uint32_t, 4> StepProver::corners_of(const MotionPair& pair) const noexcept {
  switch (pair.kind) {
    case Kind::edge_edge: {
      const auto &a = elements_.edges[pair.first], &b = elements_.edges[pair.second];
      return {a[0], a[1], b[0], b[1]};
    }
    case Kind::vertex_face: {
      const auto& face = elements_.faces[pair.second];
      return {elements_.points[pair.first], face[0], face[1], face[2]};
    }
    case Kind::point_edge: {
      const auto& edge = elements_.edges[pair.second];
      return {elements_.points[pair.first], edge[0], edge[1], 0};
    }
    case Kind::point_point: return {elements_.points[pair.first], elements_.points[pair.second], 0, 0};
  }
  return {};
}

Query StepProver::query_of(const MotionPair& pair, const MotionFrame& start, const MotionFrame& end) const {
  Query query;
  query.kind = pair.kind;
  const auto corners = corners_of(pair);
  for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
    query.start[c] = start[corners[c]];
    query.end[c] = end[corners[c]];
  }
  return query;
}

CurvedQuery StepProver::curved_query_of(const MotionPair& pair, const MotionFrame& start,
                                        const MotionFrame& end) const {
  CurvedQuery query;
  query.kind = pair.kind;
  const auto corners = corners_of(pair);
  const std::size_t free = elements_.free_count();
  std::array<std::uint32_t, 4> bodies{};
  for (std::size_t c = 0; c < corner_count(pair.kind); ++c) {
    if (corners[c] < free) {
      query.corners[c] = CurvedCorner::on_curve({start[corners[c]], end[corners[c]]});
      bodies[c] = ~std::uint32_t{0};
      continue;
    }
    // Corners of one body have one motion.
    const BodyVertex& vertex = elements_.on_bodies[corners[c] - free];
    bodies[c] = vertex.body;
    const auto first = std::find(bodies.begin(), bodies.end(), vertex.body) - bodies.begin();
    query.motions[static_cast<std::size_t>(first)] = motion_of(vertex.body, start, end);
    query.corners[c] = CurvedCorner::on_body(static_cast<int>(first), vertex.point);
  }
  return query;
}

bool StepProver::is_curved(const MotionPair& pair) const noexcept {
  const auto corners = corners_of(pair);
  return std::any_of(corners.begin(), corners.begin() + corner_count(pair.kind),
                     [&](Index v) { return v >= elements_.free_count(); });
}

Answer StepProver::append_proof(std::string& to, std::uint64_t number, const MotionPair& pair, const MotionFrame& start,
                                const MotionFrame& end) const {
  const auto append = [&](const auto& query) {
    const Answer answer = solve(query, separation_);
    append_proof_of(to, number, query, answer, separation_);
    return answer;
  };
  return is_curved(pair) ? append(curved_query_of(pair, start, end)) : append(query_of(pair, start, end));
}

std::string motion_head(const MotionElements& elements) {
  std::string text = "touchstone-motion 1\nvertices " + std::to_string(elements.vertex_count) + '\n';
  const auto add = [&](const char* sort, const auto& vertices) {
    text += sort;
    for (const Index vertex : vertices) text += ' ' + std::to_string(vertex);
    text += '\n';
  };
  for (const Index vertex : elements.points) add("point", std::array{vertex});
  for (const auto& edge : elements.edges) add("edge", edge);
  for (const auto& face : elements.faces) add("face", face);
  for (Index vertex = 0; vertex < elements.fixed.size(); ++vertex) {
    if (elements.fixed[vertex] != 0) add("fixed", std::array{vertex});
  }
  for (std::size_t i = 0; i < elements.on_bodies.size(); ++i) {
    const BodyVertex& vertex = elements.on_bodies[i];
    text += "body " + std::to_string(elements.free_count() + i) + ' ' + std::to_string(vertex.body) + ' ';
    append_point(text, vertex.point);
  }
  return text;
}

void append_frame(std::string& to, const MotionFrame& frame) {
  to += "frame\n";
  for (const MotionPose& pose : frame.poses) {
    for (const double c : pose.q) {
      append_coordinate(to, c);
      to += ' ';
    }
    append_point(to, pose.p);
  }
  for (const Vec3& position : frame) append_point(to, position);
}

}  // namespace touchstone::proofs
