// The pairs of elements whose boxes meet in a substep.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <utility>

#include "broad_phase/box_tree.hpp"
#include "contact/colliders.hpp"
#include "geometry/arc_bulge.hpp"
#include "numbers/doubles/rounded_sum.hpp"

namespace touchstone::sim {
namespace {

using broad_phase::MovingBox;

// A moving box follows the straight lines between the ends of its corners' paths. RigidMotion interpolates
// the quaternion straight, and q0 . q1 >= 0 in a step, as geometry::kArcBulge asks. 0.01 is for rounding.
constexpr double kBulge = geometry::kArcBulge + 0.01;

// The rounded matrix of a quaternion has entries of up to 1 and errors below 14 e, e = 2^-53; 3 products and 2 sums of
// them with a point X, below 51 e |X| together; the quaternion's length is off by 4 e, its square by 8 e, which is as
// much of |X|; the position adds e (|X| + |p|). All of it is below 2^-46 (|X| + |p|) = 128 e (|X| + |p|).
constexpr double kPositioning = 0x1p-46;

// So many vertices have a box of their own, and more of them have one around those of their clusters.
constexpr std::size_t kFewVertices = 32;

double largest(const Vector3& x) { return x.lpNorm<Eigen::Infinity>(); }

/// The margin of a box around an element with this radius. A separation exceeds the sum of two radii by the rounding of
/// that sum, less than two units in the last place of the larger one: 2^-51 of it is as much.
double with_radius_added(double margin, double radius) {
  constexpr double kRoundedSum = 0x1p-51;
  return radius > 0 ? numbers::sum_rounded_up(margin, radius + kRoundedSum * radius) : margin;
}

template <std::size_t N>
bool contains(const std::array<Index, N>& element, Index particle) {
  return std::find(element.begin(), element.end(), particle) != element.end();
}

}  // namespace

double bulge(const Quaternion& q0, const Quaternion& q1, double reach) noexcept {
  double apart = 0;
  for (std::size_t i = 0; i < 4; ++i) apart += (q1[i] - q0[i]) * (q1[i] - q0[i]);
  return kBulge * apart * reach;
}

/// Where the vertices of a group are at both ends, give or take a margin along each axis: by how much paths leave the
/// lines between is in it. The vertices of a body are placed when they are needed: most of them lie in clusters that
/// meet nothing.
class Colliders::Sweep {
 public:
  Sweep(const SceneMotion& motion, double margin) : motion_(motion), margin_(margin) {}
  /// @param margin  beside what rounding and the bulge of arcs, and the radius of the body, need
  Sweep(const Colliders& colliders, Index group, const SceneMotion& motion, double margin)
      : motion_(motion), group_(group), first_(colliders.before(group).vertices) {
    const RigidBody& body = colliders.bodies().bodies()[group - 1];
    const Pose &start = (*motion.start)[group - 1].pose, &end = (*motion.end)[group - 1].pose;
    points_ = body.points.data();
    turns_ = {matrix_of(start.q), matrix_of(end.q)};
    positions_ = {start.p, end.p};
    placed_.resize(body.points.size());
    is_placed_.resize(body.points.size(), 0);
    rounding_ = kPositioning * (body.reach + std::max(largest(start.p), largest(end.p)));
    margin_ = with_radius_added(margin, colliders.body_radii_[group - 1]);
    margin_ = numbers::sum_rounded_up(margin_, bulge(start.q, end.q, body.reach));
    margin_ = numbers::sum_rounded_up(margin_, rounding_);
  }

  Index group() const noexcept { return group_; }

  /// @param radius  of an element of particles
  MovingBox box_of(const Index* corners, std::size_t count, double radius = 0) {
    MovingBox box = broad_phase::empty_moving_box();
    for (std::size_t c = 0; c < count; ++c) {
      const auto [start, end] = ends_of(corners[c]);
      broad_phase::extend(box.start, start);
      broad_phase::extend(box.end, end);
    }
    return grown(box, with_radius_added(margin_, radius));
  }

  /// A box that the boxes of all elements of a body's cluster are in. Their corners are rounded, and so is its centre.
  MovingBox box_of(const Cluster& cluster) const {
    MovingBox box = broad_phase::empty_moving_box();
    const auto [start, end] = placed(cluster.centre);
    broad_phase::extend(box.start, start);
    broad_phase::extend(box.end, end);
    return grown(box, numbers::sum_rounded_up(cluster.radius + 2 * rounding_, margin_));
  }

 private:
  using Ends = std::array<Vec3, 2>;

  Ends ends_of(Index vertex) {
    if (points_ == nullptr) return {corner_of(*motion_.x0, vertex), corner_of(*motion_.x1, vertex)};
    const Index v = vertex - first_;
    if (!std::exchange(is_placed_[v], 1)) placed_[v] = placed(points_[v]);
    return placed_[v];
  }
  Ends placed(const Vector3& point) const {
    const Vector3 start = turns_[0] * point + positions_[0], end = turns_[1] * point + positions_[1];
    return {Vec3{start.x(), start.y(), start.z()}, Vec3{end.x(), end.y(), end.z()}};
  }
  static MovingBox grown(MovingBox box, double margin) {
    broad_phase::grow(box.start, margin);
    broad_phase::grow(box.end, margin);
    return box;
  }

  const SceneMotion& motion_;
  Index group_ = kParticles, first_ = 0;
  const Vector3* points_ = nullptr;
  std::array<Matrix3, 2> turns_;
  std::array<Vector3, 2> positions_;
  std::vector<Ends> placed_;
  std::vector<char> is_placed_;
  double rounding_ = 0, margin_ = 0;
};

/// Boxes of some elements, with their numbers.
struct Colliders::Boxes {
  std::vector<Index> numbers;
  std::vector<MovingBox> boxes;
};

std::vector<Cluster> Colliders::clusters_of(Index group, MeshElement sort) const {
  constexpr Index kMost = 8;  // elements: a box for each of them costs about as much as four boxes of clusters
  constexpr double kRounded = 1 + 0x1p-40;
  const Vector3* const points = bodies_.bodies()[group - 1].points.data();
  std::vector<Cluster> clusters;
  const Index last = before_[group + 1].of(sort);
  for (Index first = before_[group].of(sort); first < last; first += kMost) {
    Cluster& cluster = clusters.emplace_back();
    cluster.begin = first;
    cluster.end = std::min(first + kMost, last);
    const auto for_each_corner = [&](const auto& visit) {
      for (Index i = cluster.begin; i < cluster.end; ++i) {
        const Index* const corners = corners_of(sort, i);
        for (std::size_t c = 0; c <= static_cast<std::size_t>(sort); ++c) {
          visit(points[corners[c] - before_[group].vertices]);
        }
      }
    };
    Vector3 low = points[*corners_of(sort, first) - before_[group].vertices], high = low;
    for_each_corner([&](const Vector3& x) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    });
    cluster.centre = 0.5 * low + 0.5 * high;
    for_each_corner([&](const Vector3& x) { cluster.radius = std::max(cluster.radius, (x - cluster.centre).norm()); });
    cluster.radius *= kRounded;
  }
  return clusters;
}

bool Colliders::can_move(const Pair& pair) const noexcept {
  const auto all = corners(pair);
  return std::any_of(all.begin(), all.begin() + corner_count(pair.kind), [&](Index v) { return can_move(v); });
}

std::vector<Pair> Colliders::candidates(const VectorX& x0, const VectorX& x1, double margin) const {
  std::vector<Pair> pairs;
  const SceneMotion motion{&x0, &x1};
  Sweep sweep(motion, margin);
  const bool thick = radii_.any();
  const auto boxes_of = [&](MeshElement sort, std::size_t count, const auto& number_of) {
    std::vector<MovingBox> boxes;
    boxes.reserve(count);
    for (Index i = 0; i < count; ++i) {
      const Index number = number_of(i);
      const double radius = thick ? radius_of(sort, number) : 0;
      boxes.push_back(sweep.box_of(corners_of(sort, number), static_cast<std::size_t>(sort) + 1, radius));
    }
    return boxes;
  };
  const auto itself = [](Index i) { return i; };
  const auto boxes_of_particles = [&](const std::vector<Index>& particles) {
    return boxes_of(MeshElement::vertex, particles.size(), [&](Index i) -> Index { return particles[i]; });
  };
  const auto add = [&](const Pair& pair) {
    if (can_move(pair)) pairs.push_back(pair);
  };
  std::vector<MovingBox> edge_boxes;
  if (passes_.edge_edge || passes_.joints || passes_.points) {
    edge_boxes = boxes_of(MeshElement::edge, before_[1].edges, itself);
  }
  if (passes_.edge_edge) {
    broad_phase::for_each_pair(edge_boxes, [&](Index i, Index j) {
      if (!contains(edges_[j], edges_[i][0]) && !contains(edges_[j], edges_[i][1])) add({Kind::edge_edge, i, j});
    });
  }
  if (kFaces && passes_.vertex_face) {
    const auto vertex_boxes = boxes_of_particles(vertices_);
    const auto face_boxes = boxes_of(MeshElement::face, before_[1].faces, itself);
    broad_phase::for_each_pair(vertex_boxes, face_boxes, [&](Index i, Index j) {
      if (!contains(faces_[j], vertices_[i])) add({Kind::vertex_face, vertices_[i], j});
    });
  }
  if (kFolds && passes_.joints) {
    for (const Fold& fold : folds_) {
      if (broad_phase::meet(sweep.box_of(&fold.particle, 1), edge_boxes[fold.edge]))
        pairs.push_back({Kind::point_edge, fold.particle, fold.edge});
    }
  }
  if (passes_.points) {
    const auto point_boxes = boxes_of_particles(points_);
    broad_phase::for_each_pair(point_boxes, edge_boxes, [&](Index i, Index j) {
      add({Kind::point_edge, points_[i], j});
    });
    broad_phase::for_each_pair(point_boxes, [&](Index i, Index j) {
      add({Kind::point_point, points_[i], points_[j]});
    });
  }
  return pairs;
}

/// Those elements of a group that meet the other box.
Colliders::Boxes Colliders::boxes_near(Sweep& sweep, MeshElement sort, const MovingBox& other) const {
  Boxes near;
  const Index group = sweep.group();
  const bool thick = group == kParticles && radii_.any();
  const auto look_at = [&](Index number) {
    const double radius = thick ? radius_of(sort, number) : 0;
    const MovingBox box = sweep.box_of(corners_of(sort, number), static_cast<std::size_t>(sort) + 1, radius);
    if (!broad_phase::meet(box, other)) return;
    near.numbers.push_back(number);
    near.boxes.push_back(box);
  };
  if (group != kParticles) {
    for (const Cluster& cluster : clusters_[group - 1][static_cast<std::size_t>(sort)]) {
      if (!broad_phase::meet(sweep.box_of(cluster), other)) continue;
      for (Index i = cluster.begin; i < cluster.end; ++i) look_at(i);
    }
  } else if (sort == MeshElement::vertex) {
    for (const Index particle : vertices_) look_at(particle);
  } else {
    for (Index i = 0; i < before_[1].of(sort); ++i) look_at(i);
  }
  return near;
}

std::vector<Pair> Colliders::body_candidates(const SceneMotion& motion, double margin) const {
  std::vector<Sweep> sweeps;  // by group, as `whole`
  sweeps.reserve(group_count());
  sweeps.emplace_back(motion, 0);
  std::vector<MovingBox> whole{
      sweeps[0].box_of(vertices_.data(), vertices_.size(), radii_.any() ? largest_radius() : 0)};
  for (Index group = 1; group < group_count(); ++group) {
    Sweep& sweep = sweeps.emplace_back(*this, group, motion, margin);
    MovingBox& box = whole.emplace_back(broad_phase::empty_moving_box());
    const Index count = before_[group + 1].vertices - before_[group].vertices;
    const auto& clusters = clusters_[group - 1][static_cast<std::size_t>(MeshElement::vertex)];
    for (const Cluster& cluster : clusters) {
      if (count > kFewVertices) broad_phase::join(box, sweep.box_of(cluster));
      for (Index v = cluster.begin; count <= kFewVertices && v < cluster.end; ++v) {
        broad_phase::join(box, sweep.box_of(&v, 1));
      }
    }
  }

  std::vector<Pair> pairs;
  const auto meet_all = [&](Kind kind, const Boxes& a, const Boxes& b) {
    if (a.boxes.empty() || b.boxes.empty()) return;
    broad_phase::for_each_pair(a.boxes, b.boxes, [&](Index i, Index j) {
      if (const Pair pair{kind, a.numbers[i], b.numbers[j]}; can_move(pair)) pairs.push_back(pair);
    });
  };
  const auto between_groups = [&](Index a, Index b) {
    const auto near = [&](Index of, MeshElement sort) { return boxes_near(sweeps[of], sort, whole[of == a ? b : a]); };
    const auto only = [](const Boxes& boxes, const auto& chosen) {
      Boxes some;
      for (std::size_t i = 0; i < boxes.numbers.size(); ++i) {
        if (!chosen(boxes.numbers[i])) continue;
        some.numbers.push_back(boxes.numbers[i]);
        some.boxes.push_back(boxes.boxes[i]);
      }
      return some;
    };
    const Boxes edges = near(b, MeshElement::edge);
    meet_all(Kind::edge_edge, near(a, MeshElement::edge), edges);
    for (const auto& [of, other] : {std::array{a, b}, std::array{b, a}}) {
      if (faces_of(other).empty()) continue;
      meet_all(Kind::vertex_face, near(of, MeshElement::vertex), near(other, MeshElement::face));
    }
    // A particle in no edge meets the edges of wire frames. Those of faces are parts of the faces.
    if (a != kParticles || points_.empty()) return;
    meet_all(Kind::point_edge, only(near(a, MeshElement::vertex), [&](Index p) { return in_edge_[p] == 0; }),
             only(edges, [&](Index e) { return is_bare(e); }));
  };
  const std::vector<MovingBox> of_bodies(whole.begin() + 1, whole.end());
  broad_phase::for_each_pair(of_bodies, [&](Index a, Index b) {
    if (can_move(before_[a + 1].vertices) || can_move(before_[b + 1].vertices)) between_groups(a + 1, b + 1);
  });
  for (Index group = 1; !vertices_.empty() && group < group_count(); ++group) {
    if (broad_phase::meet(whole[kParticles], whole[group])) between_groups(kParticles, group);
  }
  return pairs;
}

}  // namespace touchstone::sim
