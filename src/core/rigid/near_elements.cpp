// SPDX-License-Identifier: MIT
#include "rigid/near_elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "filters/apart/same_side.hpp"
#include "geometry/kind_traits.hpp"
#include "mesh/pair_distance.hpp"
#include "solver/cascade.hpp"

namespace touchstone::rigid {
namespace {

using mesh::Representative;

constexpr double kRounded = 1 + 0x1p-48;  // for the roundings of some sums

/// An element of a body on its arc.
struct Element {
  MeshElement sort;
  Index number;
  std::array<Arc::Ends, 3> corners;  ///< as many as it has
  double radius;
  double deviation;  ///< of its points from the straight motion between its corners' ends
  BoundsByAxis box;
};

/// A representative of a body's mesh on the body's arc, with the elements that it stands for.
struct Seen {
  Representative representative;
  std::array<Element, 7> elements;
  std::size_t count = 0;
  BoundsByAxis box;  ///< around all of them
};

/// The radius by which each body's boxes are wider: half of the common separation, and its own.
struct Margins {
  double common = 0;
  bool radii = false;
  double of(double radius) const noexcept { return mesh::with_room(common + (radii ? radius : 0)); }
};

/// What is compared in motion.
struct InMotion {
  static bool compares(const Representative& a, MeshElement of_a, const Representative& b, MeshElement of_b) noexcept {
    if (of_a == of_b && of_a == MeshElement::edge) return true;
    if (of_a == MeshElement::vertex && of_b == MeshElement::face) return true;
    if (of_b == MeshElement::vertex && of_a == MeshElement::face) return true;
    return is_itself(a, of_a) && is_itself(b, of_b) && of_a != MeshElement::face && of_b != MeshElement::face;
  }
  static constexpr bool kRests = false, kNearestFirst = false;

 protected:
  static bool is_itself(const Representative& one, MeshElement sort) noexcept { return one.sort == sort; }
};

/// What is compared at rest.
struct AtRest : InMotion {
  static bool compares(const Representative& a, MeshElement of_a, const Representative& b, MeshElement of_b) noexcept {
    const bool edges = of_a == MeshElement::edge && of_b == MeshElement::edge;
    if (edges) return a.sort == MeshElement::edge || b.sort == MeshElement::edge;
    const auto meets_face = [](const Representative& one, MeshElement sort) {
      return sort == MeshElement::edge || (sort == MeshElement::vertex && one.sort == sort);
    };
    if (of_b == MeshElement::face) return meets_face(a, of_a);
    if (of_a == MeshElement::face) return meets_face(b, of_b);
    return is_itself(a, of_a) && is_itself(b, of_b);
  }
  static constexpr bool kRests = true;
};

/// The same pairs as in motion, by a distance that falls meanwhile.
struct Nearest : InMotion {
  static constexpr bool kNearestFirst = true;
};

/// The chords of two elements: of a moving pair, or of a place that goes along the first one, an edge, while the second
/// one rests.
Query chords_of(Kind kind, const Element& first, const Element& second, bool rests) noexcept {
  Query chords;
  chords.kind = kind;
  std::size_t at = 0;
  if (rests) {
    chords.start[0] = first.corners[0].start;
    chords.end[0] = first.corners[first.sort == MeshElement::edge ? 1 : 0].start;
    at = 1;
  } else {
    for (std::size_t c = 0; c <= static_cast<std::size_t>(first.sort); ++c, ++at) {
      chords.start[at] = first.corners[c].start;
      chords.end[at] = first.corners[c].end;
    }
  }
  for (std::size_t c = 0; c <= static_cast<std::size_t>(second.sort); ++c, ++at) {
    chords.start[at] = second.corners[c].start;
    chords.end[at] = rests ? second.corners[c].start : second.corners[c].end;
  }
  return chords;
}

template <class Rule>
class Search {
 public:
  /// @param most  null, or the separation, which may fall
  Search(const BodyOnArc& a, const BodyOnArc& b, const Margins& margins, const Separation& separation,
         const NearConsumer& take, const std::atomic<double>* most = nullptr)
      : a_(a), b_(b), margins_(margins), separation_(separation), take_(take), most_(most) {}

  void run() {
    if (a_.body.tree.empty() || b_.body.tree.empty()) return;
    std::vector<std::array<Index, 2>> waiting{{a_.body.tree.root(), b_.body.tree.root()}};
    std::vector<Seen> of_a, of_b;
    while (!waiting.empty()) {
      const auto [i, j] = waiting.back();
      waiting.pop_back();
      look_again();
      if (!broad_phase::meet(box_of(a_, i), box_of(b_, j))) continue;
      const auto &first = a_.body.tree.node(i), &second = b_.body.tree.node(j);
      if (first.is_leaf() && second.is_leaf()) {
        compare_leaves(first, second, of_a, of_b);
      } else if (second.is_leaf() || (!first.is_leaf() && first.size() >= second.size())) {
        push(waiting, {first.first, j}, {first.second, j});
      } else {
        push(waiting, {i, second.first}, {i, second.second});
      }
    }
  }

 private:
  using Node = broad_phase::BoxTree<Box>::Node;

  void look_again() noexcept {
    if (most_ != nullptr) margins_.common = (separation_.distance = *most_) / 2;
  }

  void push(std::vector<std::array<Index, 2>>& waiting, const std::array<Index, 2>& one,
            const std::array<Index, 2>& other) const {
    const bool swap = Rule::kNearestFirst && gap_at_start(one) < gap_at_start(other);
    waiting.push_back(swap ? other : one);
    waiting.push_back(swap ? one : other);
  }

  /// The greatest gap along an axis; less than none where boxes overlap along all of them.
  double gap_at_start(const std::array<Index, 2>& nodes) const noexcept {
    const BoundsByAxis a = box_of(a_, nodes[0]), b = box_of(b_, nodes[1]);
    double gap = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) gap = std::max({gap, b.low[k][0] - a.high[k][0], a.low[k][0] - b.high[k][0]});
    return gap;
  }

  BoundsByAxis box_of(const BodyOnArc& moving, Index node) const noexcept {
    return moving.arc.around(moving.body.tree.node(node).box, moving.body.reaches[node],
                             margins_.of(moving.body.radius));
  }

  void compare_leaves(const Node& first, const Node& second, std::vector<Seen>& of_a, std::vector<Seen>& of_b) {
    look_at(a_, first, of_a);
    look_at(b_, second, of_b);
    for (Seen& one : of_a) {
      for (Seen& other : of_b) {
        if (broad_phase::meet(one.box, other.box)) compare(one, other);
      }
    }
  }

  void look_at(const BodyOnArc& moving, const Node& leaf, std::vector<Seen>& all) const {
    all.resize(leaf.size());
    for (Index at = leaf.begin; at < leaf.end; ++at) look_at(moving, moving.body.tree.number(at), all[at - leaf.begin]);
  }

  void look_at(const BodyOnArc& moving, Index n, Seen& seen) const {
    const Mesh::Impl& mesh = moving.body.mesh.impl();
    const Representative one = seen.representative = mesh::representative(mesh, n);
    const StandsFor& stands_for = mesh.stands_for[n];
    seen.count = 0;
    std::array<Arc::Ends, 3> ends;
    double reach = 0, radius = 0;
    for (std::size_t i = 0; i < one.count(); ++i) {
      const Vec3& point = moving.body.points[one.corners[i]];
      ends[i] = moving.arc.ends_of(point);
      reach = std::max(reach, moving.arc.reach_of(point));
      if (margins_.radii) radius = std::max(radius, radius_of(mesh, &one.corners[i], 1));
    }
    const double deviation = moving.arc.deviation(reach);
    const auto add = [&](MeshElement sort, Index number, std::array<std::size_t, 3> corners) {
      Element& element = seen.elements[seen.count++];
      element.sort = sort;
      element.number = number;
      element.radius = 0;
      element.deviation = deviation;
      for (std::size_t c = 0; c <= static_cast<std::size_t>(sort); ++c) {
        element.corners[c] = ends[corners[c]];
        if (margins_.radii) element.radius = std::max(element.radius, radius_of(mesh, &one.corners[corners[c]], 1));
        const BoundsByAxis at = bounds_of(ends[corners[c]]);
        c == 0 ? element.box = at : (broad_phase::extend_by(element.box, at), at);
      }
      broad_phase::grow(element.box, kRounded * (deviation + margins_.of(element.radius)));
    };
    for (std::size_t i = 0; i < one.count(); ++i) {
      if ((stands_for.vertices >> i & 1) != 0) add(MeshElement::vertex, one.corners[i], {i, 0, 0});
      if (stands_for.edges[i] != StandsFor::kNone) add(MeshElement::edge, stands_for.edges[i], {i, (i + 1) % 3, 0});
    }
    if (one.sort == MeshElement::face) add(MeshElement::face, one.number, {0, 1, 2});
    seen.box = seen.elements[0].box;
    for (std::size_t i = 1; i < seen.count; ++i) broad_phase::extend_by(seen.box, seen.elements[i].box);
  }

  static BoundsByAxis bounds_of(const Arc::Ends& at) noexcept {
    using At = BoundsByAxis::AtBothEnds;
    const At x{at.start.x, at.end.x}, y{at.start.y, at.end.y}, z{at.start.z, at.end.z};
    return {{x, y, z}, {x, y, z}};
  }

  void compare(const Seen& of_a, const Seen& of_b) {
    for (std::size_t i = 0; i < of_a.count; ++i) {
      for (std::size_t j = 0; j < of_b.count; ++j) {
        const Element &one = of_a.elements[i], &other = of_b.elements[j];
        if (!Rule::compares(of_a.representative, one.sort, of_b.representative, other.sort)) continue;
        if (!broad_phase::meet(one.box, other.box)) continue;
        const bool swap = one.sort == other.sort ? b_.number < a_.number : other.sort < one.sort;
        swap ? compare(b_, other, a_, one) : compare(a_, one, b_, other);
      }
    }
  }

  void compare(const BodyOnArc& of_first, const Element& first, const BodyOnArc& of_second, const Element& second) {
    look_again();
    const MeshElement asked = Rule::kRests ? MeshElement::vertex : first.sort;  // a place on the first one
    const Kind kind = asked == MeshElement::edge           ? Kind::edge_edge
                      : second.sort == MeshElement::face   ? Kind::vertex_face
                      : second.sort == MeshElement::vertex ? Kind::point_point
                                                           : Kind::point_edge;
    if (are_apart(kind, first, second)) return;
    take_({first.sort, second.sort, {of_first.number, first.number}, {of_second.number, second.number}});
  }

  /// True proves that two elements are farther than their separation from each other: their chords are farther than
  /// that by more than both deviations.
  bool are_apart(Kind kind, const Element& first, const Element& second) const {
    double distance = separation_.distance + (first.deviation + second.deviation);
    if (margins_.radii) distance += first.radius + second.radius;
    const Separation farther{kRounded * distance, separation_.metric};
    if (!std::isfinite(farther.distance)) return false;
    const Query chords = chords_of(kind, first, second, Rule::kRests);
    if (filters::has_cubic(kind) && filters::clear_all_along(chords, farther)) return true;
    return !solver::answer(chords, farther, Method::fast, 1, Wanted::contact).contact;
  }

  const BodyOnArc &a_, &b_;
  Margins margins_;
  Separation separation_;
  const NearConsumer& take_;
  const std::atomic<double>* most_;
};

}  // namespace

void for_each_near_in_motion(const Bodies& bodies, const BodyOnArc& a, const BodyOnArc& b, const NearConsumer& take) {
  const bool radii = a.body.radius > 0 || b.body.radius > 0;
  Search<InMotion>(a, b, {bodies.separation.distance / 2, radii}, bodies.separation, take).run();
}

void for_each_near_at_rest(const BodyOnArc& a, const BodyOnArc& b, const NearConsumer& take) {
  Search<AtRest>(a, b, {}, {}, take).run();
}

void for_each_nearer_at_rest(const BodyOnArc& a, const BodyOnArc& b, Metric metric, const std::atomic<double>& most,
                             const NearConsumer& take) {
  Search<Nearest>(a, b, {}, {0, metric}, take, &most).run();
}

}  // namespace touchstone::rigid
