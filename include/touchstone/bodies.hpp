// Touchstone: whole bodies that turn and move. When do two meshes, with two poses each, first touch?
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/mesh.hpp>
#include <touchstone/screw.hpp>
#include <touchstone/separation.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// The number of a body, from 0.
using BodyIndex = std::uint32_t;

/// Where a body is.
struct Pose {
  std::array<double, 4> orientation = {1, 0, 0, 0};  ///< a quaternion {w, x, y, z}, finite, not all 0, of any length
  Vec3 position;                                     ///< where the body's origin is, in the unit of length
};

/// The order of a quaternion's components, which programs and files differ in: w first in Eigen's constructor, MuJoCo
/// and here; w last in ROS, Unity, SciPy and glTF.
enum class QuaternionOrder : std::uint8_t { wxyz, xyzw };

/// The pose with a quaternion of this order.
Pose pose_of(const Vec3& position, const std::array<double, 4>& quaternion, QuaternionOrder order);

/// Which of both turns a body takes between two orientations: q and -q are the same orientation.
enum class Turn : std::uint8_t {
  shorter,  ///< the turn by at most 180 degrees: the second quaternion has the other sign where q0 . q1 < 0
  as_given  ///< the one that the signs say: with q0 . q1 < 0 it is longer than 180 degrees
};

/// The rigid motion from one pose to the other. `takes_longer_turn` says which turn the poses as they are would take.
RigidMotion motion_between(const Pose& start, const Pose& end, Turn turn = Turn::shorter);

/// A rigid body: a mesh, with its vertices in the body's own frame. It is immutable, and several threads may use one
/// object. A copy is cheap. It is made once, with the tree of its elements' boxes, for any number of questions.
///
/// The elements of one body do not move against each other, so they are never asked about: neither the mesh's rules nor
/// its separation count. Its radii do.
class Body {
 public:
  /// The representation, known to the library only.
  struct Impl;

  /// A body without elements.
  Body();

  /// @param mesh    its faces, edges and loose points, and their radii
  /// @param points  the positions of its vertices in its own frame
  /// @throws InvalidMesh   for a mesh in the plane
  /// @throws InvalidQuery  for positions that do not fit the mesh, or a coordinate that is not finite (it names the
  ///                       vertex)
  Body(const Mesh& mesh, const Positions& points);

  const Mesh& mesh() const noexcept;                 ///< what it is made of
  const std::vector<Vec3>& points() const noexcept;  ///< the positions of its vertices in its own frame

  /// For the library: the representation.
  const Impl& impl() const noexcept { return *impl_; }

 private:
  std::shared_ptr<const Impl> impl_;
};

/// Which bodies never collide with each other.
struct BodyRules {
  std::vector<std::array<BodyIndex, 2>> body_pairs;  ///< pairs of bodies that never collide, in any order

  std::vector<std::uint32_t> groups;                      ///< the group of each body; empty without groups
  GroupRule group_rule = GroupRule::all_but_listed;       ///< the meaning of group_pairs
  std::vector<std::array<std::uint32_t, 2>> group_pairs;  ///< pairs of groups, in any order; {3, 3} is within group 3
};

/// What is asked about.
struct Bodies {
  std::vector<Body> bodies;  ///< fewer than 2^32 - 1
  BodyRules rules;           ///< which of them never collide

  /// Contact is to be within this of each other; with distance 0, to touch. The radii of both elements come on top: the
  /// radius of an element is the largest of its vertices' in its body's mesh. A sum that is no double is rounded up.
  Separation separation = {};
};

/// An element of a body.
struct BodyElement {
  BodyIndex body = 0;     ///< the body
  MeshIndex element = 0;  ///< the number of the vertex, edge or face in the body's mesh

  /// By body, then by element.
  friend bool operator<(const BodyElement& a, const BodyElement& b) noexcept {
    return a.body != b.body ? a.body < b.body : a.element < b.element;
  }
  /// Whether both are the same.
  friend bool operator==(const BodyElement& a, const BodyElement& b) noexcept {
    return a.body == b.body && a.element == b.element;
  }
};

/// Elements of two bodies: edge and edge, the one of the lesser body first; vertex and face; a loose point and an edge
/// that is in no face; or two loose points, that of the lesser body first.
struct BodyPair {
  Kind kind = Kind::edge_edge;  ///< which elements
  BodyElement first;            ///< the first element: an edge, or a vertex for the other three kinds
  BodyElement second;           ///< the second element: an edge, face, edge or vertex

  /// Whether both are the same pair.
  friend bool operator==(const BodyPair& a, const BodyPair& b) noexcept {
    return a.kind == b.kind && a.first == b.first && a.second == b.second;
  }
  /// Whether they are different pairs.
  friend bool operator!=(const BodyPair& a, const BodyPair& b) noexcept { return !(a == b); }
  /// By kind, then by first, then by second.
  friend bool operator<(const BodyPair& a, const BodyPair& b) noexcept {
    if (a.kind != b.kind) return a.kind < b.kind;
    return a.first == b.first ? a.second < b.second : a.first < b.first;
  }
};

/// Elements of two bodies in contact.
struct BodyContact {
  BodyPair pair;          ///< the elements
  Separation separation;  ///< the separation that the contact is about
  Answer answer;          ///< that of `solve` for query_of(bodies, pair, motions) and this separation
};

/// Elements of two bodies that share a point at rest, or of which one is inside the other's surface.
struct BodyIntersection {
  MeshElement first_element = MeshElement::edge;   ///< an edge, or a vertex: a loose point, or one that is inside
  BodyElement first;                               ///< it
  MeshElement second_element = MeshElement::face;  ///< a face, an edge or a vertex
  BodyElement second;                              ///< it

  /// How they meet; `folds` is none of them. `inside`: the vertex, with all that is connected to it, lies inside closed
  /// surfaces of the other body and meets none of its elements. The face is the least one of the least such surface.
  IntersectionSort sort = IntersectionSort::touches;
};

/// What a question about bodies left out, and what nobody can tell.
struct BodiesLeftOut {
  /// How many pieces of bodies (surfaces, wires, loose points) lie in the box around the open surfaces of another body,
  /// at rest or at the start of a step, if that was asked about. Such surfaces have no inside, even if they are closed
  /// but for vertices that lie on each other and are not one.
  std::size_t in_open = 0;

  /// And how many lie within closed surfaces of another body whose winding numbers add up to 0: as in a cavity, or in
  /// two solids that overlap, one of which is inside out. They count as outside.
  std::size_t cancelled = 0;

  /// How many pairs of bodies the rules left out.
  std::size_t excluded = 0;
};

/// The first contact of some bodies in a step.
struct FirstBodyContact : BodiesLeftOut {
  /// Whether elements of two bodies that are not in contact at the start come into contact in [0, t_max].
  bool contact = false;

  /// The largest double <= the exact first time of such a contact; infinity without one.
  double toi = std::numeric_limits<double>::infinity();
  /// The smallest double >= this time; infinity without contact.
  double toi_upper = std::numeric_limits<double>::infinity();

  /// The earliest contacts: every pair whose contact begins at exactly that time, in ascending order.
  std::vector<BodyContact> earliest;

  /// Every pair in contact at t = 0, in ascending order. Later contacts of these pairs are not reported.
  std::vector<BodyContact> at_start;

  /// Whether the start was asked about, by BodyStepOptions::check_start.
  bool start_checked = false;

  /// Where bodies intersect at the start; empty when that was not asked.
  std::vector<BodyIntersection> start_intersections;

  /// Whether there is no contact at all in the step, and no intersection at the start, if that was asked about.
  bool free() const noexcept { return !contact && at_start.empty() && start_intersections.empty(); }
};

/// The options of first_contact and free_step for bodies.
struct BodyStepOptions : StepOptions {
  /// Whether `intersections` is asked about the start, too. An answer about a step assumes a free start: bodies that
  /// pierce each other at t = 0, or of which one is inside the other, may move on without a contact.
  bool check_start = true;
};

/// The earliest contact of bodies in a step. Each moves by its RigidMotion, as a corner of a CurvedQuery does. All
/// elements of two bodies are asked about, but for those that the rules leave out, and each pair has the exact answer
/// of `solve` with curved motion: nothing is sampled, and there is no tolerance. The surfaces may have any shape.
///
/// The result is the same for every number of threads, byte for byte.
/// @param bodies   the bodies
/// @param motions  one for each body
/// @param options  how the question is answered
/// @throws InvalidQuery  for another number of motions than of bodies, a number that is not finite, a quaternion that
///                       is zero at an end or between them (it names the body), or rules or options without meaning
FirstBodyContact first_contact(const Bodies& bodies, const std::vector<RigidMotion>& motions,
                               const BodyStepOptions& options = {});

/// Every pair that comes into contact in [0, t_max], or is in contact at the start. They are sorted by toi, then by
/// toi_upper, then by pair.
/// @throws InvalidQuery  as first_contact
std::vector<BodyContact> all_contacts(const Bodies& bodies, const std::vector<RigidMotion>& motions,
                                      const StepOptions& options = {});

/// Pairs of which every pair in contact is one, in ascending order: boxes around arcs of their paths meet.
/// @throws InvalidQuery  as first_contact
std::vector<BodyPair> candidates(const Bodies& bodies, const std::vector<RigidMotion>& motions,
                                 const MeshOptions& options = {});

/// Where bodies intersect at rest, exactly. Separations and radii do not count. An edge and a face are compared, two
/// edges if one of them is in no face, a loose point and a face, a loose point and an edge that is in no face, and two
/// loose points. What lies inside closed surfaces of another body, as Intersection says, is found too.
/// @param bodies    the bodies
/// @param poses     one for each body
/// @param options   how the question is answered
/// @param left_out  null, or becomes what was not found out
/// @return the intersections, in ascending order of the first elements and then of the second ones
/// @throws InvalidQuery  as first_contact
std::vector<BodyIntersection> intersections(const Bodies& bodies, const std::vector<Pose>& poses,
                                            const MeshOptions& options = {}, BodiesLeftOut* left_out = nullptr);

/// How near bodies come to each other at rest.
struct BodyDistance : BodiesLeftOut {
  /// The least distance, rounded up to a double: some pair comes within it, and none within the next lesser double. It
  /// is 0 where bodies intersect, and where one is inside the other. Infinity where no two elements may collide, or
  /// where all that may are farther apart than the greatest double.
  double distance = std::numeric_limits<double>::infinity();

  /// Every pair within this distance, in ascending order, as first_contact has it in at_start for this separation. Of
  /// bodies that intersect these are the pairs that touch.
  std::vector<BodyContact> pairs;

  std::vector<BodyIntersection> intersections;  ///< where bodies intersect
};

/// The least distance of two elements of two bodies at rest, of the pairs that first_contact asks about, in the metric
/// of the bodies' separation: separations and radii do not count.
/// @param bodies   the bodies
/// @param poses    one for each body
/// @param options  how the question is answered
/// @throws InvalidQuery  as first_contact
BodyDistance distance(const Bodies& bodies, const std::vector<Pose>& poses, const MeshOptions& options = {});

/// A step of bodies that is free of contact.
struct FreeBodyStep {
  StepOutcome outcome = StepOutcome::whole;  ///< what became of the step

  /// The fraction of the step, in [0, 1]. It is 1 only for a whole step.
  double length = 1;

  /// The poses at the end: the orientation (1 - length) q0 + length q1 and the position (1 - length) p0 + length p1,
  /// both rounded; for a whole step q1 and p1.
  std::vector<Pose> poses;

  /// The first contact of the whole step.
  FirstBodyContact first_contact;

  int proofs = 0;  ///< the number of times that all pairs were asked about
};

/// A long step whose stored, rounded end poses are reached free of contact: all pairs were asked about the motion from
/// the poses at t = 0 to these very poses. It ends below the first contact by little more than rounding needs.
/// @param bodies   the bodies
/// @param motions  one for each body
/// @param options  how the question is answered; t_max must be 1
/// @throws InvalidQuery  as first_contact
FreeBodyStep free_step(const Bodies& bodies, const std::vector<RigidMotion>& motions,
                       const BodyStepOptions& options = {});

/// The options of solve_screw for bodies.
struct BodyScrewOptions : BodyStepOptions {
  int arcs = 8;         ///< as in ScrewOptions
  int most_arcs = 256;  ///< as in ScrewOptions
};

/// Two elements that meet on screws, or may meet.
struct BodyScrewContact {
  BodyPair pair;       ///< the elements
  ScrewAnswer answer;  ///< that of `solve_screw` for query_of(bodies, pair, motions), with its separation
};

/// Whether bodies that turn at constant rates come into contact. Whatever the verdict is, they certainly have no
/// contact before `free_until`, but for the start, if that was not asked about.
struct BodyScrewAnswer : BodiesLeftOut {
  ScrewVerdict verdict = ScrewVerdict::free;  ///< `contact` where a pair certainly meets
  double free_until = 0;                      ///< no contact is at a time less than this; t_max for `free`
  double contact_by = 0;  ///< for `contact`: there is a contact at this time or before it; t_max otherwise

  /// Every pair without the verdict `free` that may meet by `contact_by`, in the order of its `free_until`.
  std::vector<BodyScrewContact> pairs;

  bool start_checked = false;                         ///< as in FirstBodyContact
  std::vector<BodyIntersection> start_intersections;  ///< as in FirstBodyContact

  /// Whether there is certainly no contact, and no intersection at the start, if that was asked about.
  bool free() const noexcept { return verdict == ScrewVerdict::free && start_intersections.empty(); }
};

/// The same for bodies that turn at constant rates, as slerp and screw motions do: the motions are read as
/// touchstone/screw.hpp says. The verdict of each pair is that of `solve_screw`.
/// @param bodies   the bodies
/// @param motions  one for each body
/// @param options  how the question is answered
/// @throws InvalidQuery  as first_contact, and for a number of arcs that is not a power of two in range
BodyScrewAnswer solve_screw(const Bodies& bodies, const std::vector<RigidMotion>& motions,
                            const BodyScrewOptions& options = {});

/// The query of a pair: its first element has the query's motion 0, the second one motion 1.
/// @throws InvalidQuery  for another number of motions than of bodies
/// @throws InvalidMesh   for a body or an element that does not exist
CurvedQuery query_of(const Bodies& bodies, const BodyPair& pair, const std::vector<RigidMotion>& motions);

/// The separation of a pair. @throws InvalidMesh  for a body or an element that does not exist
Separation separation_of(const Bodies& bodies, const BodyPair& pair);

/// The pair for a person: "edge 7 (3-4) of body 0 and edge 9 (10-11) of body 2".
/// @throws InvalidMesh  for a body or an element that does not exist
std::string describe(const Bodies& bodies, const BodyPair& pair);

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
