// Touchstone: whole meshes. Where does a mesh intersect itself, when do its elements first touch, how far may it move?
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/error.hpp>
#include <touchstone/names.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// The number of a vertex, edge, face or loose point, from 0.
using MeshIndex = std::uint32_t;

/// Two elements of a mesh: edge and edge, vertex and face, vertex and edge, or vertex and vertex.
struct MeshPair {
  Kind kind = Kind::edge_edge;  ///< which elements
  MeshIndex first = 0;          ///< the number of the first element: an edge, or a vertex for the other three kinds
  MeshIndex second = 0;         ///< the number of the second element: an edge, face, edge or vertex

  /// Whether both are the same pair.
  bool operator==(const MeshPair& other) const noexcept {
    return kind == other.kind && first == other.first && second == other.second;
  }
  /// Whether they are different pairs.
  bool operator!=(const MeshPair& other) const noexcept { return !(*this == other); }
  /// By kind, then by first, then by second.
  bool operator<(const MeshPair& other) const noexcept {
    if (kind != other.kind) return kind < other.kind;
    return first != other.first ? first < other.first : second < other.second;
  }
};

/// Which pairs of groups of vertices collide.
enum class GroupRule : std::uint8_t {
  all_but_listed,  ///< every two groups, and each group with itself, but those in the list
  only_listed      ///< the pairs of groups in the list, and no others
};

/// Which pairs of a mesh never collide, beside those that share a vertex. Two elements may collide when some vertex of
/// one may collide with some vertex of the other. Two vertices may not collide when they are listed, or when their
/// groups may not.
struct CollisionRules {
  std::vector<std::array<MeshIndex, 2>> vertex_pairs;  ///< vertices that never collide with each other, in any order
  std::vector<MeshPair> element_pairs;                 ///< elements that never collide with each other

  std::vector<MeshIndex> groups;                      ///< the group of each vertex; empty without groups
  GroupRule group_rule = GroupRule::all_but_listed;   ///< the meaning of group_pairs
  std::vector<std::array<MeshIndex, 2>> group_pairs;  ///< pairs of groups, in any order; {3, 3} is within group 3
};

/// The separation of one pair.
struct PairSeparation {
  MeshPair pair;        ///< the elements
  double distance = 0;  ///< in place of every other separation of this pair; finite and not negative
};

/// What a mesh is made of.
struct MeshElements {
  std::size_t vertex_count = 0;  ///< the number of vertices, below 2^32 - 1

  /// Triangles, by the numbers of their corners. Their orientation has no meaning.
  std::vector<std::array<MeshIndex, 3>> faces;

  /// Edges. The edges of the faces need not be given. A given edge keeps its number, and may be an edge of a face too.
  /// The other edges of the faces come after those given, in ascending order of their corners.
  std::vector<std::array<MeshIndex, 2>> edges;

  /// The loose points: vertices that are in no edge, and collide. Without a list, it is every vertex that is in no
  /// edge.
  std::optional<std::vector<MeshIndex>> points;

  int dimension = 3;  ///< 2 or 3; a mesh in the plane has edges and loose points, and no faces

  CollisionRules rules;  ///< which pairs never collide

  /// The separation of every pair. With distance 0, contact is touching.
  Separation separation = {};

  /// The radius of each vertex, in place of separation.distance, which must then be 0; empty without radii. An
  /// element's radius is the largest of its vertices' radii. The separation of a pair is the sum of its two elements'
  /// radii; a sum that is no double is rounded up. The metric is separation.metric.
  std::vector<double> radii;

  /// Separations of single pairs, each pair once. Their metric is separation.metric.
  std::vector<PairSeparation> pair_separations;
};

/// A mesh whose elements were checked. It is immutable, and several threads may use one object. A copy is cheap.
///
/// It holds 28 bytes for each face, 8 for each edge, 28 for each edge that is in no face, 4 for each vertex that
/// collides and 20 for each loose point, besides the rules and the radii. While it is made, it needs at most 40 bytes
/// more for each face, 28 for each edge that is given, and 8 for each vertex.
class Mesh {
 public:
  /// The representation, known to the library only.
  struct Impl;

  /// A mesh without elements.
  Mesh();

  /// @param elements  what it is made of
  /// @throws InvalidMesh  for an index out of range, an element with a repeated corner, an element that is given twice,
  ///                      a loose point in an edge, faces in the plane, rules about elements that do not exist, radii
  ///                      that are negative or not finite; the message names the element and what would be right
  /// @throws InvalidQuery  for a separation without meaning
  explicit Mesh(MeshElements elements);

  std::size_t vertex_count() const noexcept;                            ///< the number of vertices
  int dimension() const noexcept;                                       ///< 2 or 3
  const std::vector<std::array<MeshIndex, 3>>& faces() const noexcept;  ///< as they were given
  const std::vector<std::array<MeshIndex, 2>>& edges() const noexcept;  ///< those given, then those of the faces
  const std::vector<MeshIndex>& points() const noexcept;                ///< the loose points, in ascending order
  Metric metric() const noexcept;                                       ///< how distances are measured

  /// What the mesh is made of, from which the constructor makes the same mesh: with all edges, the loose points, and
  /// the pairs of rules and separations in ascending order.
  MeshElements elements() const;

  /// Whether the pair is one that first_contact and the other functions ask about. In three dimensions these are two
  /// edges, a vertex and a face, a loose point and an edge that is in no face, the end of an edge that is in no face
  /// and another such edge at its other end, and two loose points. In two dimensions they are a vertex and an edge, and
  /// two loose points. Two elements that share a vertex, or that the rules exclude, never collide. Vertices that are
  /// neither in an edge nor a loose point never collide. Two elements that share a vertex may fold onto each other.
  /// Then a corner of one comes to lie in the other, or an edge of one meets the opposite edge of the other: such a
  /// pair may collide.
  /// @throws InvalidMesh  for an element that does not exist
  bool may_collide(const MeshPair& pair) const;

  /// Whether there are two elements that could meet, and two groups of vertices that may collide, if there are groups.
  /// Where it is false, no pair is asked about, and a verdict about the mesh says nothing.
  bool has_pairs() const;

  /// The separation of a pair. In three dimensions it is 0 for a pair of a vertex and an edge, if the vertex is in
  /// another edge: neighbours along a wire only fold onto each other. @throws InvalidMesh  for an element that does not
  /// exist
  Separation separation(const MeshPair& pair) const;

  /// The vertices of a pair in the order of a query's corners; those past corner_count(kind) are 0.
  /// @throws InvalidMesh  for an element that does not exist
  std::array<MeshIndex, 4> corners(const MeshPair& pair) const;

  /// The pair for a person: "edge 7 (3-4) and edge 9 (10-11)", "vertex 5 and face 2 (0-1-9)".
  /// @throws InvalidMesh  for an element that does not exist
  std::string describe(const MeshPair& pair) const;

  /// For the library: the representation.
  const Impl& impl() const noexcept { return *impl_; }

 private:
  std::shared_ptr<const Impl> impl_;
};

/// The positions of a mesh's vertices: a view of doubles or floats in the caller's memory. Coordinate k of vertex v is
/// data[v * vertex_stride + k * coordinate_stride], or the same of `floats` where `data` is null.
struct Positions {
  const double* data = nullptr;          ///< the first coordinate of the first vertex
  const float* floats = nullptr;         ///< the same in single precision, in place of `data`
  std::size_t count = 0;                 ///< the number of vertices
  int dimension = 3;                     ///< 2 or 3 coordinates a vertex
  std::ptrdiff_t vertex_stride = 3;      ///< numbers from a vertex to the next
  std::ptrdiff_t coordinate_stride = 1;  ///< numbers from a coordinate to the next

  /// No positions.
  Positions() = default;

  /// Contiguous positions: x y z x y z ..., or x y x y ... `first` points to the first coordinate of all.
  Positions(const double* first, std::size_t vertices, int coordinates = 3)
      : data(first), count(vertices), dimension(coordinates), vertex_stride(coordinates) {}
  /// The same of floats. A null pointer is one to doubles.
  template <class Float, class = std::enable_if_t<std::is_same_v<Float, float>>>
  Positions(const Float* first, std::size_t vertices, int coordinates = 3)
      : floats(first), count(vertices), dimension(coordinates), vertex_stride(coordinates) {}

  /// The same of a vector. A remainder that is no whole vertex counts as one more vertex, and no function
  /// takes it.
  Positions(const std::vector<double>& all, int coordinates)
      : Positions(all.data(), whole_vertices(all.size(), coordinates), coordinates) {}
  /// The same of floats.
  template <class Float, class = std::enable_if_t<std::is_same_v<Float, float>>>
  Positions(const std::vector<Float>& all, int coordinates)
      : Positions(all.data(), whole_vertices(all.size(), coordinates), coordinates) {}

  /// Three coordinates a vertex.
  Positions(const std::vector<Vec3>& all) : Positions(all.empty() ? nullptr : &all[0].x, all.size()) {}

 private:
  static std::size_t whole_vertices(std::size_t numbers, int coordinates) noexcept {
    const auto each = static_cast<std::size_t>(coordinates);
    return coordinates > 0 ? (numbers + each - 1) / each : 0;
  }
};

/// A long call was asked to stop, by MeshOptions::stop.
class Stopped : public Error {
 public:
  using Error::Error;
};

/// How a mesh's questions are answered. They change no result.
struct MeshOptions {
  int threads = 1;  ///< the number of threads, 1 to 1024; 0 takes as many as the machine has

  /// Null, or a flag that another thread may set to end the call early, within about a tenth of a second. The call then
  /// throws Stopped.
  const std::atomic<bool>* stop = nullptr;
};

/// The options of all_contacts.
struct StepOptions : MeshOptions {
  double t_max = 1.0;  ///< the end of the time range, 0 <= t_max <= 1
};

/// The options of first_contact.
struct FirstContactOptions : StepOptions {
  /// Whether `intersections` is asked about the start, too. An answer about a step assumes a free start: elements that
  /// pierce each other at t = 0, without a pair that touches, may move on without a contact.
  bool check_start = false;
};

/// Two elements in contact.
struct MeshContact {
  MeshPair pair;          ///< the elements
  Separation separation;  ///< the separation that the contact is about
  Answer answer;          ///< that of `solve` for this pair and this separation
};

/// How two elements of a mesh meet at rest.
enum class IntersectionSort : std::uint8_t {
  /// They share a point, and no vertex: in a corner or border, or lying in each other.
  touches,
  /// The edge passes through: its interior and the other element's interior share a single point, with the ends of the
  /// edge strictly on both sides.
  pierces,
  /// They share a vertex, and also a point that is no shared vertex: an edge lies in a face that it grows from, or
  /// along another edge. Two faces that lie folded onto each other have such an edge.
  folds,
  /// The vertex's closed surface lies wholly inside the face's, has the same orientation, and shares at most vertices
  /// with it. The face is the least one of its surface. The vertex is the least one of its surface that is in no other
  /// surface or wire; if there is none, it is the least one of its surface.
  inside
};

/// "touches", "pierces", "folds", "inside".
template <>
Names names_of<IntersectionSort>() noexcept;

/// The verb between both elements in a message: "touches", "pierces", "folds onto" or "is inside the closed surface
/// of".
std::string_view intersection_verb(IntersectionSort sort) noexcept;

/// Two elements of a mesh that share a point at rest, or of which one is inside the other's surface.
struct Intersection {
  MeshElement first_element = MeshElement::edge;   ///< an edge, or a vertex: a loose point, or one that is inside
  MeshIndex first = 0;                             ///< its number
  MeshElement second_element = MeshElement::face;  ///< a face, an edge or a vertex
  MeshIndex second = 0;                            ///< its number

  IntersectionSort sort = IntersectionSort::touches;  ///< how they meet

  /// A common point: barycentric coordinates on the first element, (e0, e1, 0) for an edge and (1, 0, 0) for a vertex,
  /// and on the second one. Each is within 2^-50 of its true value. Of several common points, the answer is one that is
  /// nearest to the edge's first corner. If the elements fold, it is one that is nearest to the edge's corner that is
  /// not shared. Elements that are inside have no common point, and zeros.
  std::array<double, 3> weights_first{};
  std::array<double, 3> weights_second{};  ///< the same on the second element
};

/// The first contact of a mesh in a step.
struct FirstContact {
  /// Whether two elements that are not in contact at the start come into contact in [0, t_max].
  bool contact = false;

  /// The largest double <= the exact first time of such a contact; infinity without one.
  double toi = std::numeric_limits<double>::infinity();
  /// The smallest double >= this time; infinity without contact.
  double toi_upper = std::numeric_limits<double>::infinity();

  /// The earliest contacts: every pair whose contact begins at exactly that time, in ascending order. Where the time is
  /// no double, the times of the pairs are compared as algebraic numbers.
  std::vector<MeshContact> earliest;

  /// Every pair in contact at t = 0, in ascending order. Later contacts of these pairs are not reported.
  std::vector<MeshContact> at_start;

  /// Whether the start was asked about, by FirstContactOptions::check_start.
  bool start_checked = false;

  /// Where the mesh intersects itself at the start; empty when that was not asked.
  std::vector<Intersection> start_intersections;

  /// Whether there is no contact at all in the step, and no intersection at the start, if that was asked about.
  bool free() const noexcept { return !contact && at_start.empty() && start_intersections.empty(); }
};

/// The earliest contact of a mesh in a step. Each vertex moves on a straight line from its position in x0 to that in
/// x1. All pairs for which Mesh::may_collide is true are asked about, and each has the answer of `solve`. Elements that
/// pierce each other at the start are not in contact if no pair of them touches there. `intersections` finds such
/// elements, and FirstContactOptions::check_start asks it.
///
/// The result is the same for every number of threads, byte for byte. The call needs 48 bytes for each vertex, and less
/// than 240 bytes for each face, each edge that is in no face and each loose point: for a closed surface of 10^7 faces
/// less than 3 GB.
/// @param mesh     the mesh
/// @param x0       the positions at t = 0
/// @param x1       the positions at t = 1
/// @param options  how the question is answered
/// @return the first contact
/// @throws InvalidQuery  for positions that do not fit the mesh, a coordinate that is not finite (it names the vertex)
///                       or options without meaning
FirstContact first_contact(const Mesh& mesh, const Positions& x0, const Positions& x1,
                           const FirstContactOptions& options = {});

/// Every pair that comes into contact in [0, t_max], or is in contact at the start. They are sorted by toi, then by
/// toi_upper, then by pair.
/// @throws InvalidQuery  as first_contact
std::vector<MeshContact> all_contacts(const Mesh& mesh, const Positions& x0, const Positions& x1,
                                      const StepOptions& options = {});

/// The pairs that may collide and whose boxes meet during the step: every pair in contact is among them. In ascending
/// order. The boxes move with their elements, and are wider by the pair's separation.
/// @throws InvalidQuery  as first_contact
std::vector<MeshPair> candidates(const Mesh& mesh, const Positions& x0, const Positions& x1,
                                 const MeshOptions& options = {});

/// The query of a pair. @throws InvalidQuery  for positions that do not fit the mesh
/// @throws InvalidMesh  for an element that does not exist
Query query_of(const Mesh& mesh, const MeshPair& pair, const Positions& x0, const Positions& x1);

/// Where the mesh intersects itself at the positions x, exactly. Separations do not count.
///
/// In three dimensions it compares an edge and a face, two edges if one of them is in no face, a loose point and a
/// face, a loose point and an edge that is in no face, and two loose points. In two dimensions it compares two edges, a
/// loose point and an edge, and two loose points. Two elements that share a vertex intersect when they fold onto each
/// other. The edges of one face are not compared. A closed surface inside another one is found too. A surface is a set
/// of faces that are connected by edges; it is closed when its faces pass each of their edges as often in one direction
/// as in the other.
///
/// The rules leave out two elements if no vertex of one may collide with a vertex of the other; vertices that both
/// share do not count for that. Of two surfaces, the rules see the two elements that would be reported. The rules' list
/// of element pairs leaves out only elements that a MeshPair can name.
/// @param mesh     the mesh
/// @param x        the positions
/// @param options  how the question is answered
/// @return the intersections, in ascending order of elements and numbers
/// @throws InvalidQuery  as first_contact
std::vector<Intersection> intersections(const Mesh& mesh, const Positions& x, const MeshOptions& options = {});

/// Whether `intersections` finds any. It ends at the first one that it meets. Surfaces inside others are looked for
/// last.
/// @throws InvalidQuery  as first_contact
bool intersects(const Mesh& mesh, const Positions& x, const MeshOptions& options = {});

/// How a step was shortened.
enum class StepOutcome : std::uint8_t {
  whole,      ///< the whole step is free: the length is 1, and the positions are x1, bit for bit, or rounded to float32
  shortened,  ///< the step was shortened, and some vertex moves

  /// No pair is in contact at the start, but every step that moves a vertex to another double, or float32, ends in
  /// a contact.
  no_room,

  contact_at_start,  ///< some pair is in contact at the start; the length is 0, and the positions are x0

  /// The mesh intersects itself at the start, which was asked about, and no pair is in contact there; the length is 0,
  /// and the positions are x0.
  intersects_at_start
};

/// "whole", "shortened", "no-room", "contact-at-start", "intersects-at-start".
template <>
Names names_of<StepOutcome>() noexcept;

/// The options of free_step, which is over [0, 1].
struct FreeStepOptions : MeshOptions {
  /// In [0, 1). Each pair keeps more than this fraction of its distance at the start: for a pair with the separation d
  /// and the distance D0 at the start, the distance stays greater than d + fraction * (D0 - d). In computing that,
  /// D0 - d is rounded up by at most 2^-10 of itself, or by a few units in the last place of D0, and the result by a
  /// few units in its last place. With 0, each pair keeps a distance greater than d.
  double kept_fraction = 0;

  bool check_start = false;  ///< as in FirstContactOptions

  /// Whether the step ends at positions that are float32 numbers, for a simulator that stores its state so. Positions
  /// rounded after the step may touch, or pass through each other. Those at the start must be float32 numbers, and
  /// those at t = 1 are rounded to the nearest ones first.
  bool float32 = false;
};

/// A step that is free of contact.
struct FreeStep {
  StepOutcome outcome = StepOutcome::whole;  ///< what became of the step

  /// The fraction of the step, in [0, 1]. It is 1 only for a whole step. It is 0 only in three cases: some pair is in
  /// contact at the start; the first contact is before every positive double; a kept distance is rounded up to the
  /// distance at the start. The length of a step without room may be positive: its rounded positions are still x0.
  double length = 1;

  /// The positions at the end. Each coordinate is a double between x0 and x1, within one unit in its last place of
  /// e = x0 + length (x1 - x0). If e is next to nothing beside x0 and x1, the coordinate is within 2^-100 (|x0| + |x1|)
  /// of it. With FreeStepOptions::float32 each is a float32 number, within one unit in its last place of e as such. A
  /// vertex has as many coordinates as the mesh has dimensions: x y z x y z ...
  std::vector<double> positions;

  /// The first contact of the whole step, about the distances that the step is to keep. It says whether the start was
  /// asked about.
  FirstContact first_contact;

  /// The number of times that all pairs were asked about.
  int proofs = 0;
};

/// The longest step that is proved free. It ends at rounded positions. The straight path from x0 to these has no
/// contact: all pairs were asked about this very path. A length that is not 1 is below the exact first time. The step
/// gives away no more than rounding needs: with the next longer length that was tried, the pairs in the way are not
/// free.
/// @param mesh     the mesh
/// @param x0       the positions at t = 0
/// @param x1       the positions at t = 1
/// @param options  how the question is answered
/// @return the step
/// @throws InvalidQuery  as first_contact, for a fraction outside [0, 1), and with float32 for a start that is not of
///                       float32 numbers, or an end beyond them
FreeStep free_step(const Mesh& mesh, const Positions& x0, const Positions& x1, const FreeStepOptions& options = {});

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
