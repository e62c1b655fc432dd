// The elements of a scene that can collide, and the pairs of them that come close during a substep.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

#include "contact/separations.hpp"
#include "rods/system.hpp"
#include "scene/features.hpp"

namespace touchstone::sim {

/// Two elements that may touch. i and j are: edge and edge, particle and face, particle and edge, particle and
/// particle.
struct Pair {
  Kind kind = Kind::edge_edge;
  Index i = 0, j = 0;
};

/// The passes that a scene needs, with the reasons. A pass that is not needed costs nothing after that.
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

/// Whether elements keep the distances that their radii ask for, or only from touching.
enum class Keep : std::uint8_t { separations, contact };

class Colliders {
 public:
  Colliders(const Scene& scene, const System& system, Keep keep = Keep::separations);

  const std::vector<Edge>& edges() const noexcept { return edges_; }
  const std::vector<Face>& faces() const noexcept { return faces_; }
  const std::vector<Index>& points() const noexcept { return points_; }  ///< particles that collide, in no edge
  bool can_move(Index particle) const noexcept { return moves_[particle] != 0; }  ///< it is not held
  const Passes& passes() const noexcept { return passes_; }

  /// The particles of a pair in the order of the query's corners; entries past corner_count(kind) mean nothing.
  std::array<Index, 4> corners(const Pair& pair) const noexcept;

  Query query(const Pair& pair, const VectorX& x0, const VectorX& x1) const noexcept;

  /// Whether any element has a radius.
  bool has_separations() const noexcept { return kSeparations && radii_.any(); }

  /// The distance that the pair is to stay farther apart than, m: the sum of the radii of its elements, rounded up; 0
  /// for neighbours and folds, which only do not touch.
  double separation(const Pair& pair) const noexcept { return has_separations() ? separation_of(pair) : 0; }

  /// The distance of the pair's elements at these positions, correctly rounded, m.
  double distance(const Pair& pair, const VectorX& x) const;

  /// Of an element in contacts, m; of a particle the largest one of its elements, or its own.
  double radius_of(MeshElement sort, Index number) const noexcept {
    if (!has_separations()) return 0;
    const auto& radii = sort == MeshElement::edge   ? radii_.edge
                        : sort == MeshElement::face ? radii_.face
                                                    : radii_.particle;
    return radii[number];
  }

  /// How many elements have a radius: edges, faces, and particles that are in no edge.
  std::size_t with_radius() const noexcept;
  double largest_radius() const noexcept;  ///< m

  const Neighbours& neighbours() const noexcept { return neighbours_; }

  /// Every pair whose boxes overlap at some time, when the boxes move from x0 to x1 with their elements and are wider
  /// by their radii and by `margin` on all sides. So every pair that may come within its separation while each particle
  /// ends within `margin` of x1 along each axis. Pairs in which nothing can move are left out and, but for folds, pairs
  /// that share a particle. The order depends on the arguments only.
  std::vector<Pair> candidates(const VectorX& x0, const VectorX& x1, double margin) const;

  /// Where the pair's elements touch in the motion from x0 to x1, by the exact solver's answer. m
  Vector3 contact_point(const Pair& pair, const VectorX& x0, const VectorX& x1, const Answer& answer) const noexcept;

  /// "edge 3-4 and edge 10-11": by their particles.
  std::string describe(const Pair& pair) const;

  /// Of the initial positions, of those edges that can move, or of all when none can; 1 when there is no edge. m
  double shortest_edge() const noexcept { return shortest_; }

 private:
  bool can_move(const Pair& pair) const noexcept;
  double separation_of(const Pair& pair) const noexcept;

  std::vector<Edge> edges_;
  std::vector<Face> faces_;
  std::vector<Index> vertices_;  // every particle that collides
  std::vector<Index> points_;    // those that are in no edge
  std::vector<Fold> folds_;
  std::vector<char> moves_;  // by particle
  Passes passes_;
  double shortest_ = 1;
  Radii radii_;
  Neighbours neighbours_;
  std::vector<char> in_edge_;  // by particle
};

inline Vec3 corner_of(const VectorX& q, Index particle) noexcept {
  const auto at = 3 * static_cast<Eigen::Index>(particle);
  return {q[at], q[at + 1], q[at + 2]};
}

}  // namespace touchstone::sim
