// SPDX-License-Identifier: MIT
#include "mesh/candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <type_traits>

#include "mesh/folds.hpp"
#include "mesh/pair_distance.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "solver/cascade.hpp"

namespace touchstone::mesh {
namespace {

using broad_phase::BoundsByAxis;
using broad_phase::Box;
using broad_phase::Pair;

Box bounds_of(const MovingVertex& vertex, const Box*) noexcept {
  const Vec3& x = vertex.start;
  return {{x.x, x.y, x.z}, {x.x, x.y, x.z}};
}
BoundsByAxis bounds_of(const MovingVertex& vertex, const BoundsByAxis*) noexcept {
  using At = BoundsByAxis::AtBothEnds;
  const Vec3 &a = vertex.start, &b = vertex.end;
  const At x{a.x, b.x}, y{a.y, b.y}, z{a.z, b.z};
  return {{x, y, z}, {x, y, z}};
}

/// The box at rest that holds a moving one, and that swells.
void swell(BoundsByAxis& box, double swelling) noexcept {
  using At = BoundsByAxis::AtBothEnds;
  BoundsByAxis grown = box;
  broad_phase::grow(grown, swelling);
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = At{std::min(box.low[k][0], box.low[k][1]), std::min(grown.low[k][0], grown.low[k][1])};
    box.high[k] = At{std::max(box.high[k][0], box.high[k][1]), std::max(grown.high[k][0], grown.high[k][1])};
  }
}

/// The boxes of elements: at rest, or moving ones.
template <class Bounds>
class Boxes {
 public:
  Boxes(const Motion& motion, const Reach& reach)
      : motion_(motion),
        reach_(reach),
        reaches_(reach.same > 0 || !reach.of_vertices.empty() || !reach.of_ways.empty()) {}

  template <std::size_t N>
  Bounds around(const std::array<Index, N>& corners) const noexcept {
    Bounds box = at(corners[0]);
    for (std::size_t i = 1; i < N; ++i) broad_phase::extend_by(box, at(corners[i]));
    if constexpr (std::is_same_v<Bounds, BoundsByAxis>) {
      if (reach_.swelling > 0) swell(box, reach_.swelling);
    }
    if (!reaches_) return box;
    double reach = reach_.same, more = 0;
    for (const Index corner : corners) {
      if (!reach_.of_vertices.empty()) reach = std::max(reach, reach_.of_vertices[corner]);
      if (!reach_.of_ways.empty()) more = std::max(more, reach_.of_ways[corner]);
    }
    broad_phase::grow(box, reach + more);
    return box;
  }

 private:
  Bounds at(Index vertex) const noexcept { return bounds_of(motion_[vertex], static_cast<const Bounds*>(nullptr)); }

  const Motion& motion_;
  const Reach& reach_;
  bool reaches_;
};

/// Which pairs of elements are compared in motion.
struct InMotion {
  using Bounds = BoundsByAxis;
  static constexpr bool kFolds = false;           // whether elements that share a vertex are compared,
  static constexpr bool kEdgesWithFaces = false;  // and edges with faces

  const Mesh::Impl& mesh;

  bool edges_with_edges(const Representative&, const Representative&) const noexcept { return mesh.dimension == 3; }

  /// Whether the vertices that `a` stands for are compared with `b`, a face or an edge; with an edge in no face only
  /// loose points and those beside it, which `allow` tells.
  bool vertices_with(const Representative& a, const Representative& b) const noexcept {
    return mesh.dimension == 2 || b.sort == MeshElement::face || a.sort == MeshElement::vertex || !mesh.joined.empty();
  }

  template <std::size_t N, std::size_t M>
  bool allow(const Pair& pair, const std::array<Index, N>& a, const std::array<Index, M>& b) const noexcept {
    constexpr Kind kKind = N == 2   ? Kind::edge_edge
                           : M == 3 ? Kind::vertex_face
                           : M == 2 ? Kind::point_edge
                                    : Kind::point_point;
    if constexpr (kKind == Kind::point_edge) {
      if (mesh.dimension == 3 && !is_in(mesh.points, a[0]) && !is_beside(mesh, a[0], b)) return false;
    }
    return rules_allow(mesh, {kKind, pair[0], pair[1]}, a, b);
  }
};

/// Which pairs of elements are compared at rest.
struct AtRest {
  using Bounds = Box;
  static constexpr bool kFolds = true;
  static constexpr bool kEdgesWithFaces = true;

  const Mesh::Impl& mesh;
  const Motion& motion;

  bool edges_with_edges(const Representative& a, const Representative& b) const noexcept {
    return a.sort == MeshElement::edge || b.sort == MeshElement::edge;
  }
  bool vertices_with(const Representative& a, const Representative&) const noexcept {
    return a.sort == MeshElement::vertex;
  }

  template <std::size_t N, std::size_t M>
  bool allow(const Pair&, const std::array<Index, N>& a, const std::array<Index, M>& b) const noexcept {
    return may_intersect(mesh, motion, a, b);
  }
};

/// Takes pairs of representatives, and hands out the pairs of elements that these stand for: those that the rule has,
/// and whose boxes meet.
template <class Rule>
class ElementPairs {
 public:
  using Bounds = typename Rule::Bounds;

  ElementPairs(const Mesh::Impl& mesh, const Rule& rule, const Boxes<Bounds>& boxes, const ElementConsumer& take)
      : mesh_(mesh), rule_(rule), boxes_(boxes), take_(take) {
    others_of_.fill(StandsFor::kNone);
  }

  /// Of pairs that meet by the time `until`.
  void add(const Pair& pair, double until) {
    if (until < 0) return;
    until_ = until;
    if (pair[0] != first_of_) look_at(first_of_ = pair[0], first_);
    const Seen &a = first_, &b = other(pair[1]);
    if (rule_.edges_with_edges(a.representative, b.representative)) {
      for (std::size_t i = 0; i < a.edge_count; ++i) {
        for (std::size_t j = 0; j < b.edge_count; ++j) compare(a.edges[i], b.edges[j]);
      }
    }
    compare_elements_of(a, b);
    compare_elements_of(b, a);
    if (a.representative.sort == MeshElement::vertex && b.representative.sort == MeshElement::vertex) {
      compare(a.vertices[0], b.vertices[0]);
    }
  }

  void hand_out_rest() {
    hand_out<1, 1>();
    hand_out<1, 2>();
    hand_out<1, 3>();
    hand_out<2, 2>();
    hand_out<2, 3>();
  }

 private:
  template <std::size_t N>
  struct Element {
    Index number;
    std::array<Index, N> corners;
    Bounds box;
  };

  /// A representative, and what it stands for.
  struct Seen {
    Representative representative;
    std::size_t vertex_count, edge_count;
    std::array<Element<1>, 3> vertices;
    std::array<Element<2>, 3> edges;  // an edge that is a representative is the first one
    Element<3> face;
  };

  /// The boxes of a leaf come again and again, with one box after another.
  const Seen& other(Index n) noexcept {
    const auto found = std::find(others_of_.begin(), others_of_.end(), n);
    if (found != others_of_.end()) return others_[static_cast<std::size_t>(found - others_of_.begin())];
    const std::size_t at = next_other_++ % others_.size();
    look_at(others_of_[at] = n, others_[at]);
    return others_[at];
  }

  void look_at(Index n, Seen& seen) const noexcept {
    const Representative one = seen.representative = representative(mesh_, n);
    const StandsFor& stands_for = mesh_.stands_for[n];
    const auto element = [&](Index number, const auto& corners) {
      return Element<std::tuple_size_v<std::decay_t<decltype(corners)>>>{number, corners, boxes_.around(corners)};
    };
    seen.vertex_count = seen.edge_count = 0;
    for (std::size_t i = 0; i < one.count(); ++i) {
      const Index corner = one.corners[i], next = one.corners[(i + 1) % 3], edge = stands_for.edges[i];
      if ((stands_for.vertices >> i & 1) != 0) seen.vertices[seen.vertex_count++] = element(corner, std::array{corner});
      if (edge != StandsFor::kNone) seen.edges[seen.edge_count++] = element(edge, std::array{corner, next});
    }
    if (one.sort == MeshElement::face) seen.face = element(one.number, one.corners);
  }

  /// The pairs of an element that `a` stands for with `b` itself.
  void compare_elements_of(const Seen& a, const Seen& b) {
    if (b.representative.sort == MeshElement::vertex) return;
    const bool is_face = b.representative.sort == MeshElement::face;
    const std::size_t vertices = rule_.vertices_with(a.representative, b.representative) ? a.vertex_count : 0;
    for (std::size_t i = 0; i < vertices; ++i) {
      is_face ? compare(a.vertices[i], b.face) : compare(a.vertices[i], b.edges[0]);
    }
    if constexpr (Rule::kEdgesWithFaces) {
      for (std::size_t i = 0; is_face && i < a.edge_count; ++i) compare(a.edges[i], b.face);
    }
  }

  template <std::size_t N, std::size_t M>
  void compare(const Element<N>& a, const Element<M>& b) {
    const bool are_neighbours = share_vertex(a.corners, b.corners);
    if (are_neighbours ? !Rule::kFolds : !meet(a.box, b.box, until_)) return;
    const Pair pair = N == M && b.number < a.number ? Pair{b.number, a.number} : Pair{a.number, b.number};
    if (!rule_.allow(pair, a.corners, b.corners)) return;
    auto& [pairs, count] = lists_[list_of<N, M>()];
    pairs[count++] = pair;
    if (count == pairs.size()) hand_out<N, M>();
  }

  template <std::size_t N, std::size_t M>
  static constexpr std::size_t list_of() noexcept {
    return N == 1 ? M - 1 : M + 1;
  }

  template <std::size_t N, std::size_t M>
  void hand_out() {
    auto& [pairs, count] = lists_[list_of<N, M>()];
    if (count > 0) take_(static_cast<MeshElement>(N - 1), static_cast<MeshElement>(M - 1), pairs.data(), count);
    count = 0;
  }

  struct List {
    std::array<Pair, 128> pairs;  // small: all of this is on the stack, beneath the solver
    std::size_t count = 0;
  };

  const Mesh::Impl& mesh_;
  const Rule& rule_;
  const Boxes<Bounds>& boxes_;
  const ElementConsumer& take_;
  double until_ = 1;
  Index first_of_ = StandsFor::kNone;
  Seen first_;
  std::array<Index, 8> others_of_;
  std::array<Seen, 8> others_;
  std::size_t next_other_ = 0;
  std::array<List, 5> lists_;
};

/// Hands out the pairs of elements of one mesh that the rule has and whose boxes meet.
template <class Rule>
void for_each_element_pair(const Mesh::Impl& mesh, const Motion& motion, const Reach& reach, const Rule& rule,
                           const broad_phase::PairSearch& search, const ElementConsumer& take) {
  using Bounds = typename Rule::Bounds;
  const Boxes<Bounds> boxes(motion, reach);
  const broad_phase::BoxOf<Bounds> box_of = [&](Index n) { return boxes.around(representative(mesh, n).corners); };
  broad_phase::for_each_pair_block(mesh.stands_for.size(), box_of, search, [&](const Pair* pairs, std::size_t count) {
    ElementPairs<Rule> elements(mesh, rule, boxes, take);
    for (std::size_t i = 0; i < count; ++i) elements.add(pairs[i], broad_phase::until(search));
    elements.hand_out_rest();
  });
}

Kind kind_of(MeshElement first, MeshElement second) noexcept {
  if (first == MeshElement::edge) return Kind::edge_edge;
  return second == MeshElement::face   ? Kind::vertex_face
         : second == MeshElement::edge ? Kind::point_edge
                                       : Kind::point_point;
}

constexpr double kRoomOfBounds = 0x1p-15;

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

// Seen by someone who moves the usual way, which changes no distance, a pair's distance falls by at most the sum of the
// greatest displacements of its elements' corners, since a point of an element is a convex combination of them, and by
// at most a part t of that sum until the time t. If it falls from D0 to d + fraction (D0 - d), it falls by
// (1 - fraction) (D0 - d). So D0 - d is at most that over 1 - fraction, and the elements are then within d plus the
// fraction of that, also along each axis.
// The distance to keep is computed with a bound of D0 that is greater by up to a part b of it: b = 2^-20 where the
// fraction is at most kMostBounded, and some 2^-53 elsewhere. With f (1 + b) in place of f, d + f (D0 - d) grows by
// less than kRoomOfBounds of itself for b = 2^-20 and f <= 0.9, and for b = 2^-50 and f <= 1 - 2^-30. Beyond that, no
// pair is lost for what it is to keep exactly, but one may be for what that is rounded to.
Reach reach_of_fraction(const Mesh::Impl& mesh, const Motion& motion, double fraction, double until) {
  Reach reach = reach_of_separations(mesh);
  // At least the least normal number: what is rounded up by some doubles among the subnormal ones is below that.
  const auto with_more_room = [](double length) {
    return std::max(with_room(length * (1 + kRoomOfBounds)), std::numeric_limits<double>::min());
  };
  reach.same = with_more_room(reach.same);
  for (double& one : reach.of_vertices) one = with_more_room(one);
  const double ratio = fraction / (1 - fraction);
  reach.of_ways = lengths_beside_usual_way(motion);
  for (double& one : reach.of_ways) one = with_more_room(ratio * one * until);
  return reach;
}

Reach reach_of(const Mesh::Impl& mesh, const Motion& motion, double kept_fraction, double until) {
  return kept_fraction == 0 ? reach_of_separations(mesh) : reach_of_fraction(mesh, motion, kept_fraction, until);
}

void for_each_candidate_block(const Mesh::Impl& mesh, const Motion& motion, const Reach& reach,
                              const broad_phase::PairSearch& search, const CandidateConsumer& take) {
  for_each_element_pair(mesh, motion, reach, InMotion{mesh}, search,
                        [&](MeshElement first, MeshElement second, const Pair* pairs, std::size_t count) {
                          take(kind_of(first, second), pairs, count);
                        });
}

void for_each_resting_block(const Mesh::Impl& mesh, const Motion& motion, const broad_phase::PairSearch& search,
                            const ElementConsumer& take) {
  for_each_element_pair(mesh, motion, {}, AtRest{mesh, motion}, search, take);
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
