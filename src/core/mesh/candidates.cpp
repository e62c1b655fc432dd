// SPDX-License-Identifier: MIT
#include "mesh/candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>

#include "mesh/contacts.hpp"
#include "mesh/folds.hpp"
#include "mesh/pair_distance.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "solver/cascade.hpp"
#include "threads/for_each_range.hpp"

namespace touchstone::mesh {
namespace {

using broad_phase::Box;
using broad_phase::BoxTree;
using broad_phase::MovingBox;
using broad_phase::Pair;

/// The corners of the n-th element of a list: one vertex, an edge or a face.
struct Vertices {
  const std::vector<Index>& numbers;
  std::size_t size() const noexcept { return numbers.size(); }
  Index number(Index n) const noexcept { return numbers[n]; }
  std::array<Index, 1> corners(Index n) const noexcept { return {numbers[n]}; }
};

template <std::size_t N>
struct All {
  const std::vector<std::array<Index, N>>& elements;
  std::size_t size() const noexcept { return elements.size(); }
  Index number(Index n) const noexcept { return n; }
  const std::array<Index, N>& corners(Index n) const noexcept { return elements[n]; }
};

struct Wires {
  const Mesh::Impl& mesh;
  std::size_t size() const noexcept { return mesh.wires.size(); }
  Index number(Index n) const noexcept { return mesh.wires[n]; }
  const std::array<Index, 2>& corners(Index n) const noexcept { return mesh.edges[mesh.wires[n]]; }
};

/// Boxes of elements in motion.
class Boxes {
 public:
  Boxes(const Motion& motion, const Reach& reach) : motion_(motion), reach_(reach) {}

  template <std::size_t N>
  MovingBox around(const std::array<Index, N>& corners) const noexcept {
    MovingBox box = broad_phase::empty_moving_box();
    double reach = reach_.same, more = 0;
    for (const Index corner : corners) {
      const MovingVertex& vertex = motion_[corner];
      broad_phase::extend(box.start, vertex.start);
      if (!reach_.at_rest) broad_phase::extend(box.end, vertex.end);
      if (!reach_.of_vertices.empty()) reach = std::max(reach, reach_.of_vertices[corner]);
      if (!reach_.of_ways.empty()) more = std::max(more, reach_.of_ways[corner]);
    }
    reach += more;
    if (reach_.at_rest) box.end = box.start;
    broad_phase::grow(box.start, reach);
    broad_phase::grow(box.end, reach);
    return box;
  }

  template <class List>
  BoxTree tree(const List& list, int threads) const {
    return BoxTree(
        list.size(), [&](Index n) { return around(list.corners(n)); }, threads);
  }

 private:
  const Motion& motion_;
  const Reach& reach_;
};

/// Compares all boxes of a list with all of another, or with each other where `b` is null, and hands out the numbers of
/// those elements that keep(i, j) takes, i and j being their places in the lists.
template <class ListA, class ListB, class Keep>
void compare(const Boxes& boxes, const ListA& a, const ListB* b, const broad_phase::PairSearch& search,
             const Keep& keep, const broad_phase::PairBlockConsumer& take) {
  const auto take_kept = [&](const Pair* pairs, std::size_t count) {
    std::array<Pair, broad_phase::kPairBlock> kept;
    std::size_t kept_count = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Index first = pairs[i][0], second = pairs[i][1];
      if (!keep(first, second)) continue;
      kept[kept_count++] = {a.number(first), b == nullptr ? a.number(second) : b->number(second)};
    }
    if (kept_count > 0) take(kept.data(), kept_count);
  };
  if (a.size() == 0 || (b != nullptr && b->size() == 0)) return;
  const BoxTree tree = boxes.tree(a, search.threads);
  if (b == nullptr) {
    broad_phase::for_each_pair_block(tree, search, take_kept);
  } else {
    broad_phase::for_each_pair_block(tree, boxes.tree(*b, search.threads), search, take_kept);
  }
}

/// The same for pairs of a kind that may collide.
template <class ListA, class ListB>
void find(const Mesh::Impl& mesh, const Boxes& boxes, Kind kind, const ListA& a, const ListB* b,
          const broad_phase::PairSearch& search, const CandidateConsumer& take) {
  const auto keep = [&](Index i, Index j) {
    if (b == nullptr) return rules_allow(mesh, {kind, a.number(i), a.number(j)}, a.corners(i), a.corners(j));
    return rules_allow(mesh, {kind, a.number(i), b->number(j)}, a.corners(i), b->corners(j));
  };
  compare(boxes, a, b, search, keep, [&](const Pair* pairs, std::size_t count) { take(kind, pairs, count); });
}

/// The same for ends of wires, and the wires beside them.
void find_beside(const Mesh::Impl& mesh, const Boxes& boxes, const Vertices& ends, const Wires& wires,
                 const broad_phase::PairSearch& search, const CandidateConsumer& take) {
  const auto keep = [&](Index i, Index j) {
    const Index end = ends.number(i);
    return is_beside(mesh, end, wires.corners(j)) && rules_allow(mesh, {Kind::point_edge, end, wires.number(j)});
  };
  compare(boxes, ends, &wires, search, keep,
          [&](const Pair* pairs, std::size_t count) { take(Kind::point_edge, pairs, count); });
}

constexpr double kRoomOfBounds = 0x1p-15;

/// The greatest distance of a vertex from its start, or a little more.
double displacement(const MovingVertex& vertex) noexcept {
  return std::hypot(vertex.end.x - vertex.start.x, vertex.end.y - vertex.start.y, vertex.end.z - vertex.start.z);
}

}  // namespace

Reach reach_of_separations(const Mesh::Impl& mesh) {
  Reach reach;
  reach.same = with_room(mesh.separation.distance / 2);
  if (mesh.separation.distance > 0) reach.same = std::max(reach.same, std::numeric_limits<double>::min());
  reach.of_vertices.reserve(mesh.radii.size());
  for (const double radius : mesh.radii) reach.of_vertices.push_back(with_room(radius));
  if (mesh.pair_separations.empty()) return reach;
  if (reach.of_vertices.empty()) reach.of_vertices.assign(mesh.vertex_count, reach.same);
  for (const PairSeparation& separation : mesh.pair_separations) {
    const double half = std::max(with_room(separation.distance / 2), std::numeric_limits<double>::min());
    const auto corners = corners_of(mesh, separation.pair);
    for (std::size_t c = 0; c < corner_count(separation.pair.kind); ++c) {
      reach.of_vertices[corners[c]] = std::max(reach.of_vertices[corners[c]], half);
    }
  }
  return reach;
}

// A pair's distance falls by at most the sum of the greatest displacements of its elements' corners, since a point of
// an element is a convex combination of them. If it falls from D0 to d + fraction (D0 - d), it falls by
// (1 - fraction) (D0 - d). So D0 - d is at most the displacements over 1 - fraction, and the elements are then within d
// plus the fraction of that, also along each axis.
// The distance to keep is computed with a bound of D0 that is greater by up to a part b of it: b = 2^-20 where the
// fraction is at most kMostBounded, and some 2^-53 elsewhere. With f (1 + b) in place of f, d + f (D0 - d) grows by
// less than kRoomOfBounds of itself for b = 2^-20 and f <= 0.9, and for b = 2^-50 and f <= 1 - 2^-30. Beyond that, no
// pair is lost for what it is to keep exactly, but one may be for what that is rounded to.
Reach reach_of_fraction(const Mesh::Impl& mesh, const Motion& motion, double fraction) {
  Reach reach = reach_of_separations(mesh);
  // At least the least normal number: what is rounded up by some doubles among the subnormal ones is below that.
  const auto with_more_room = [](double length) {
    return std::max(with_room(length * (1 + kRoomOfBounds)), std::numeric_limits<double>::min());
  };
  reach.same = with_more_room(reach.same);
  for (double& one : reach.of_vertices) one = with_more_room(one);
  const double ratio = fraction / (1 - fraction);
  reach.of_ways.reserve(motion.size());
  for (const MovingVertex& vertex : motion) reach.of_ways.push_back(with_more_room(ratio * displacement(vertex)));
  return reach;
}

Reach reach_of(const Mesh::Impl& mesh, const Motion& motion, double kept_fraction) {
  return kept_fraction == 0 ? reach_of_separations(mesh) : reach_of_fraction(mesh, motion, kept_fraction);
}

void for_each_candidate_block(const Mesh::Impl& mesh, const Motion& motion, const Reach& reach,
                              const broad_phase::PairSearch& search, const CandidateConsumer& take) {
  const Boxes boxes(motion, reach);
  const Vertices vertices{mesh.vertices}, points{mesh.points};
  const All<2> edges{mesh.edges};
  const All<3> faces{mesh.faces};
  constexpr const Vertices* kThemselves = nullptr;
  if (mesh.dimension == 3) {
    find<All<2>, All<2>>(mesh, boxes, Kind::edge_edge, edges, nullptr, search, take);
    find(mesh, boxes, Kind::vertex_face, vertices, &faces, search, take);
    const Wires wires{mesh};
    find(mesh, boxes, Kind::point_edge, points, &wires, search, take);
    find_beside(mesh, boxes, Vertices{mesh.wire_ends}, wires, search, take);
  } else {
    find(mesh, boxes, Kind::point_edge, vertices, &edges, search, take);
  }
  find(mesh, boxes, Kind::point_point, points, kThemselves, search, take);
}

void for_each_resting_block(const Mesh::Impl& mesh, const Motion& motion, const RestingPass& pass, int threads,
                            const broad_phase::PairBlockConsumer& take) {
  Reach reach;
  reach.at_rest = true;
  const Boxes boxes(motion, reach);
  broad_phase::PairSearch search;
  search.threads = threads;
  const Vertices points{mesh.points};
  const All<2> edges{mesh.edges};
  const All<3> faces{mesh.faces};
  const Wires wires{mesh};
  const auto run = [&](const auto& a, const auto& b) {
    const auto keep = [&](Index i, Index j) { return may_intersect(mesh, motion, a.corners(i), b.corners(j)); };
    compare(boxes, a, &b, search, keep, take);
  };
  const auto run_alone = [&](const auto& a) {
    const auto keep = [&](Index i, Index j) { return may_intersect(mesh, motion, a.corners(i), a.corners(j)); };
    compare<std::decay_t<decltype(a)>, std::decay_t<decltype(a)>>(boxes, a, nullptr, search, keep, take);
  };
  const auto run_first = [&](const auto& a) {
    switch (pass.second) {
      case MeshElement::vertex: return run(a, points);
      case MeshElement::edge: return pass.only_wires_second ? run(a, wires) : run(a, edges);
      case MeshElement::face: return run(a, faces);
    }
  };
  const bool one_list = pass.first == pass.second && pass.only_wires_first == pass.only_wires_second;
  if (pass.first == MeshElement::vertex) {
    one_list ? run_alone(points) : run_first(points);
  } else if (pass.only_wires_first) {
    one_list ? run_alone(wires) : run_first(wires);
  } else {
    one_list ? run_alone(edges) : run_first(edges);
  }
}

}  // namespace touchstone::mesh

namespace touchstone {
inline namespace TOUCHSTONE_ABI {
namespace {

TOUCHSTONE_BEHIND_GUARD std::vector<MeshPair> find_candidates(const Mesh& mesh, const Positions& x0,
                                                              const Positions& x1, const MeshOptions& options) {
  const mesh::Motion motion = mesh::motion_of(mesh.impl(), x0, x1, options.threads);
  std::vector<MeshPair> pairs;
  std::mutex lock;
  broad_phase::PairSearch search;
  search.threads = options.threads;
  mesh::for_each_candidate_block(mesh.impl(), motion, mesh::reach_of_separations(mesh.impl()), search,
                                 [&](Kind kind, const broad_phase::Pair* found, std::size_t count) {
                                   mesh::check_stop(options.stop);
                                   const std::lock_guard<std::mutex> guard(lock);
                                   for (std::size_t i = 0; i < count; ++i) {
                                     pairs.push_back({kind, found[i][0], found[i][1]});
                                   }
                                 });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace

std::vector<MeshPair> candidates(const Mesh& mesh, const Positions& x0, const Positions& x1,
                                 const MeshOptions& options) {
  const numbers::DefaultFloatEnvironment environment;
  return find_candidates(mesh, x0, x1, options);
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
