// What a body holds.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include <touchstone/bodies.hpp>

#include "broad_phase/box_tree.hpp"
#include "mesh/inside_surfaces/pieces.hpp"
#include "mesh/mesh_elements.hpp"
#include "solver/validate.hpp"

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

struct Body::Impl {
  Mesh mesh;
  std::vector<Vec3> points;
  broad_phase::BoxTree<broad_phase::Box> tree;  // of the mesh's representatives, in the body's frame
  std::vector<double> reaches;                  // by node of the tree: reach_of its box
  broad_phase::Box box;                         // around all representatives
  double reach = 0;                             // reach_of(box)
  double radius = 0;                            // the largest radius

  /// The pieces of the mesh, found when they are first needed.
  const mesh::Pieces& pieces() const;

 private:
  mutable std::once_flag once_;
  mutable mesh::Motion at_rest_;
  mutable std::unique_ptr<const mesh::Pieces> pieces_;
};

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone

namespace touchstone::rigid {

using Index = MeshIndex;
using broad_phase::BoundsByAxis;
using broad_phase::Box;

/// The largest radius of an element's vertices.
double radius_of(const Mesh::Impl& mesh, const Index* corners, std::size_t count) noexcept;

/// The least double that is not below the sum of the bodies' separation and of both elements' radii.
double separation_between(const Bodies& bodies, const BodyPair& pair) noexcept;

/// The query of a pair whose elements exist.
CurvedQuery query_between(const Bodies& bodies, const BodyPair& pair, const std::vector<RigidMotion>& motions) noexcept;

/// The pairs of bodies that the rules let collide, and how many they leave out.
/// @throws InvalidQuery  for rules about bodies that do not exist, a separation without meaning, or too many bodies
class CollidingBodies {
 public:
  explicit CollidingBodies(const Bodies& bodies);
  bool may_collide(BodyIndex a, BodyIndex b) const noexcept;
  std::size_t excluded() const;

 private:
  const BodyRules& rules_;
  std::size_t count_;
  std::vector<std::uint64_t> body_pairs_, group_pairs_;  // ascending
};

/// @throws InvalidQuery  for another number of motions than of bodies, naming the body whose motion has no meaning, or
///                       for a number of threads without meaning
void validate(const Bodies& bodies, const std::vector<RigidMotion>& motions, int threads = 1,
              solver::OriginPath path = solver::OriginPath::straight);

}  // namespace touchstone::rigid
