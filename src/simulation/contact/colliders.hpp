// The elements of a scene that can collide, and the pairs of them that come close during a substep.
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>

#include "broad_phase/box_tree.hpp"
#include "contact/body_system.hpp"
#include "contact/separations.hpp"
#include "rods/system.hpp"
#include "scene/features.hpp"

namespace touchstone::sim {

/// Elements are in groups: those of the particles, and then those of each body, which do not move against each other.
/// Vertices, edges and faces have one row of numbers each, over all groups. Body b is group b + 1.
constexpr Index kParticles = 0;

/// Two elements that may touch. i and j are: edge and edge, vertex and face, particle and edge, particle and particle.
struct Pair {
  Kind kind = Kind::edge_edge;
  Index i = 0, j = 0;

  auto operator<=>(const Pair&) const = default;
};

/// The stored motion of a substep: particles move straight, bodies by touchstone::RigidMotion between their poses.
struct SceneMotion {
  const VectorX* x0 = nullptr;
  const VectorX* x1 = nullptr;
  const BodyStates* start = nullptr;  ///< pairs of particles do without
  const BodyStates* end = nullptr;
};

/// The passes that a scene's particles need, with the reasons. A pass that is not needed costs nothing after that.
struct Passes {
  bool edge_edge = false, vertex_face = false, joints = false, points = false;
  bool anything_moves = false;
  std::size_t free_points = 0;    ///< particles that collide and are in no edge
  std::size_t not_colliding = 0;  ///< particles
};

/// A particle, and an edge that it can only reach by folding: an edge of the particle and this one share another
/// particle.
struct Fold {
  Index particle = 0, edge = 0;
};

/// Elements of a body that follow each other, and so mostly lie near each other: all within `radius` of a centre, in
/// the body's frame. Most of them need no box of their own.
struct Cluster {
  Vector3 centre = Vector3::Zero();
  double radius = 0;  ///< m, rounded up
  Index begin = 0, end = 0;
};

/// By how much, m, a point of a body may at most leave the straight line between the ends of its path, along an axis,
/// at any time of the motion from one orientation to the other. @param q0, q1  of length 1, with q0 . q1 >= 0
/// @param reach  m: no point is farther from the origin
double bulge(const Quaternion& q0, const Quaternion& q1, double reach) noexcept;

/// Whether elements keep the distances that their radii ask for, or only from touching.
enum class Keep : std::uint8_t { separations, contact };

class Colliders {
 public:
  Colliders(const Scene& scene, const System& system, Keep keep = Keep::separations);

  const BodySystem& bodies() const noexcept { return bodies_; }
  const std::vector<Edge>& edges() const noexcept { return edges_; }  ///< sorted
  const std::vector<Face>& faces() const noexcept { return faces_; }
  const std::vector<Index>& points() const noexcept { return points_; }       ///< particles that collide, in no edge
  bool can_move(Index vertex) const noexcept { return moves_[vertex] != 0; }  ///< it is not held
  const Passes& passes() const noexcept { return passes_; }

  /// How many elements a group has, or all groups before it.
  struct Counts {
    Index vertices = 0, edges = 0, faces = 0;

    Index of(MeshElement sort) const noexcept {
      return sort == MeshElement::edge ? edges : sort == MeshElement::face ? faces : vertices;
    }
  };
  Index group_count() const noexcept { return static_cast<Index>(before_.size() - 1); }
  const Counts& before(Index group) const noexcept { return before_[group]; }  ///< also of group_count(): of all
  std::span<const Edge> edges_of(Index group) const noexcept {
    return {edges_.data() + before_[group].edges, edges_.data() + before_[group + 1].edges};
  }
  std::span<const Face> faces_of(Index group) const noexcept {
    return {faces_.data() + before_[group].faces, faces_.data() + before_[group + 1].faces};
  }
  Index group_of(Index vertex) const noexcept {
    return vertex < before_[1].vertices ? kParticles : group_of_[vertex - before_[1].vertices];
  }
  Index group_of(MeshElement sort, Index number) const noexcept;
  bool is_of_particles(const Pair& pair) const noexcept;

  /// In a scene with bodies: the third corners of an edge's first two faces, or kNoCorner.
  const std::array<Index, 2>& opposite(Index edge) const noexcept { return opposite_[edge]; }
  bool is_bare(Index edge) const noexcept { return opposite_[edge][0] == kNoCorner; }  ///< it is in no face
  /// In a scene with bodies: the other ends of a vertex's edges.
  const std::vector<Index>& around(Index vertex) const noexcept { return around_[vertex]; }
  static constexpr Index kNoCorner = ~Index{0};
  Index edge_between(Index a, Index b) const noexcept;

  /// The corners of a pair in the order of the query's; entries past corner_count(kind) mean nothing.
  std::array<Index, 4> corners(const Pair& pair) const noexcept;

  Query query(const Pair& pair, const VectorX& x0, const VectorX& x1) const noexcept;  ///< of particles
  CurvedQuery query(const Pair& pair, const SceneMotion& motion) const noexcept;
  Vector3 at(Index vertex, const VectorX& x, const BodyStates& bodies) const noexcept;

  /// Whether any element has a radius.
  bool has_separations() const noexcept { return kSeparations && has_separations_; }

  /// The distance that the pair is to stay farther apart than, m: the sum of the radii of its elements, rounded up; 0
  /// for neighbours and folds, which only do not touch.
  double separation(const Pair& pair) const noexcept { return has_separations() ? separation_of(pair) : 0; }

  /// The distance of the elements of a pair of particles at these positions, correctly rounded, m.
  double distance(const Pair& pair, const VectorX& x) const;

  /// Of an element in contacts, m; of a particle the largest one of its elements, or its own.
  double radius_of(MeshElement sort, Index number) const noexcept;

  /// How many elements of particles have a radius: edges, faces, and particles that are in no edge.
  std::size_t with_radius() const noexcept;
  double largest_radius() const noexcept;  ///< of these, m

  const Neighbours& neighbours() const noexcept { return neighbours_; }

  /// Every pair of particles whose boxes overlap at some time, when the boxes move from x0 to x1 with their elements
  /// and are wider by their radii and by `margin` on all sides. So every pair that may come within its separation while
  /// each particle ends within `margin` of x1 along each axis. Pairs in which nothing can move are left out and, but
  /// for folds, pairs that share a particle. The order depends on the arguments only.
  std::vector<Pair> candidates(const VectorX& x0, const VectorX& x1, double margin) const;

  /// Every other pair, one of a body at least, whose elements may come within its separation and `margin` of each
  /// other, and in which something can move. The order depends on the arguments only.
  std::vector<Pair> body_candidates(const SceneMotion& motion, double margin) const;

  /// Where the pair's elements touch in the motion from x0 to x1, by the exact solver's answer. m
  Vector3 contact_point(const Pair& pair, const VectorX& x0, const VectorX& x1, const Answer& answer) const noexcept;

  /// "edge 3-4 and edge 10-11 of body 2", "particle 3": by their vertices.
  std::string describe(const Pair& pair) const;
  std::string describe(MeshElement sort, const Index* corners) const;

  /// Of the initial positions, of those edges that can move, or of all when none can; 1 when there is no edge. m
  double shortest_edge() const noexcept { return shortest_; }
  /// Of bodies that can move; infinity when there is none. m
  double shortest_edge_of_bodies() const noexcept { return shortest_of_bodies_; }

 private:
  class Sweep;
  struct Boxes;

  void add_elements(const Scene& scene);
  void add_neighbourhoods();
  std::vector<Cluster> clusters_of(Index group, MeshElement sort) const;
  const Index* corners_of(MeshElement sort, const Index& number) const noexcept;
  bool can_move(const Pair& pair) const noexcept;
  double separation_of(const Pair& pair) const noexcept;
  Boxes boxes_near(Sweep& sweep, MeshElement sort, const broad_phase::MovingBox& other) const;

  BodySystem bodies_;
  std::vector<Edge> edges_;
  std::vector<Face> faces_;
  std::vector<Index> vertices_;  // every particle that collides
  std::vector<Index> points_;    // those that are in no edge
  std::vector<Fold> folds_;
  std::vector<char> moves_;  // by vertex
  Passes passes_;
  double shortest_ = 1, shortest_of_bodies_ = 0;
  Radii radii_;  // of particles
  bool has_separations_ = false;
  Neighbours neighbours_;
  std::vector<char> in_edge_;  // by particle
  std::vector<Counts> before_{{}};
  std::vector<Index> group_of_;                                // by vertex of bodies
  std::vector<double> body_radii_;                             // by body
  std::vector<std::array<std::vector<Cluster>, 3>> clusters_;  // by body and sort
  std::vector<std::array<Index, 2>> opposite_;                 // by edge; empty without bodies, as `around_`
  std::vector<std::vector<Index>> around_;
};

inline Vec3 corner_of(const VectorX& q, Index particle) noexcept {
  const auto at = 3 * static_cast<Eigen::Index>(particle);
  return {q[at], q[at + 1], q[at + 2]};
}

}  // namespace touchstone::sim
