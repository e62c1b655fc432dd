// What a check of an animation finds, in the numbers and names of its files.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/mesh.hpp>
#include <touchstone/query.hpp>

#include "mesh/group_relations/group_relations.hpp"
#include "sequence/parts/part_rules.hpp"

namespace touchstone::sequence {

/// An element of a mesh as its file counts and names it.
struct NamedElement {
  MeshElement element = MeshElement::vertex;  ///< which sort
  std::array<std::uint64_t, 3> vertices{};    ///< its corners; those past the element's corners are 0
  std::uint64_t face = 0;                     ///< of a face: its number, which triangles of one polygon share
  std::string part;                           ///< its object or group; empty without one

  std::size_t corner_count() const noexcept { return static_cast<std::size_t>(element) + 1; }
};

/// Two elements in contact.
struct PairContact {
  Kind kind = Kind::edge_edge;
  NamedElement first, second;
  Nature nature = Nature::none;
  Feature feature_a = Feature::none, feature_b = Feature::none;
  Trend trend = Trend::none;  ///< with a separation only
};

/// Two elements that meet at rest.
struct RestContact {
  NamedElement first, second;
  IntersectionSort sort = IntersectionSort::touches;
};

/// How many intersections there are, and how many of them are of a sort that a reader may not expect.
struct IntersectionCounts {
  std::size_t all = 0;
  std::size_t folds = 0, inside = 0;  ///< of these

  void add(const std::vector<RestContact>& contacts) noexcept {
    all += contacts.size();
    for (const RestContact& contact : contacts) {
      folds += contact.sort == IntersectionSort::folds ? 1 : 0;
      inside += contact.sort == IntersectionSort::inside ? 1 : 0;
    }
  }
};

/// How many parts are wholly inside closed surfaces, which is no intersection, and the first of them.
struct EnclosedCounts {
  std::size_t surfaces = 0, wires = 0, points = 0;
  NamedElement vertex, face;  ///< of the first: one of its vertices, and a face of the surface around it

  std::size_t all() const noexcept { return surfaces + wires + points; }
  void add(const EnclosedCounts& other) {
    if (all() == 0) vertex = other.vertex, face = other.face;
    surfaces += other.surfaces;
    wires += other.wires;
    points += other.points;
  }
};

/// The least distance of two elements in a step or in a frame.
struct Clearance {
  double distance = std::numeric_limits<double>::infinity();  ///< rounded up; infinity without two that may collide
  double toi = 0;         ///< when two elements come within that distance first, in [0, 1]
  double toi_upper = 0;   ///< the double after that, or the same
  std::size_t pairs = 0;  ///< how many do then; 0 where the mesh intersects itself at the start
  PairContact pair = {};  ///< the first of them

  /// Whether the mesh intersects itself at the start; the distance is 0 then.
  bool starts_intersecting() const noexcept { return distance == 0 && pairs == 0; }
};

/// Two parts that are not clear of each other.
struct PartRelation {
  std::string first, second;                       ///< their names
  mesh::Relation sort = mesh::Relation::touching;  ///< never `around`: the first one is inside the second
};

/// What was found about a frame at rest, or about the step from a frame to the next.
struct Result {
  bool step = false;      ///< a step
  std::size_t frame = 0;  ///< the frame, or the first one of the step, by its place in the sequence

  double toi = std::numeric_limits<double>::infinity();  ///< of `first`; infinity without them
  double toi_upper = std::numeric_limits<double>::infinity();
  std::vector<PairContact> first;     ///< the pairs whose contact begins first
  std::vector<PairContact> at_start;  ///< the pairs in contact at the start of the step

  /// Where the frame intersects itself; for a step that is not free, where its last frame does.
  std::vector<RestContact> intersections;

  /// Of a frame that intersects itself, and of the first frame of a step that starts in contact: how many vertices are
  /// at exactly the position of another one.
  std::size_t coinciding = 0;

  /// Of `at_start`, with a separation: the pairs about it whose elements an edge of the mesh connects.
  std::size_t own_neighbours = 0;

  /// Of a frame at rest. A free frame may have some.
  EnclosedCounts enclosed;
  std::size_t flat = 0;     ///< flat_faces
  std::size_t in_open = 0;  ///< Insides::in_open

  std::size_t turning = 0;  ///< of a step: turning_faces

  std::optional<Clearance> clearance;  ///< where it was asked for

  std::optional<std::vector<PartRelation>> classes;  ///< of a frame at rest, where they were asked for
  std::size_t without_inside = 0;                    ///< GroupRelations::without_inside, of the same

  bool free() const noexcept { return first.empty() && at_start.empty() && intersections.empty(); }
};

/// Which question is asked.
enum class Question : std::uint8_t {
  steps,  ///< is each step between neighbouring frames free, and the first frame free of intersections?
  rest    ///< is each frame free of intersections?
};

/// A part of a sequence.
struct Shard {
  std::size_t number = 1;  ///< from 1
  std::size_t count = 1;
};

/// Frames [first, last) of a shard's report, and the results that belong to it.
struct Range {
  std::size_t first = 0, last = 0;
};

/// The number of items that shards divide: steps, or frames at rest.
inline std::size_t item_count(Question question, std::size_t frames) noexcept {
  return question == Question::steps ? frames - 1 : frames;
}

/// The frames that a shard reads. A step reads two frames, so neighbouring shards share one.
inline Range frames_of_shard(Question question, std::size_t frames, const Shard& shard) noexcept {
  const std::size_t items = item_count(question, frames);
  const std::size_t quotient = items / shard.count, rest = items % shard.count;
  const auto first_item = [&](std::size_t number) { return quotient * number + (number < rest ? number : rest); };
  const std::size_t shared = question == Question::steps ? 1 : 0;
  return {first_item(shard.number - 1), first_item(shard.number) + shared};
}

/// The number of results about these frames: a step for two neighbours, and each frame at rest, or the first one of the
/// sequence.
inline std::size_t result_count(Question question, const Range& frames) noexcept {
  const std::size_t count = frames.last - frames.first;
  return question == Question::rest ? count : count - 1 + (frames.first == 0 ? 1 : 0);
}

/// The frame or step that result number `i` of these frames is about.
inline Result result_at(Question question, const Range& frames, std::size_t i) noexcept {
  Result result;
  if (question == Question::rest) {
    result.frame = frames.first + i;
    return result;
  }
  const bool starts = frames.first == 0;
  result.step = !starts || i > 0;
  result.frame = frames.first + i - (starts && i > 0 ? 1 : 0);
  return result;
}

/// What a mesh has.
struct MeshFacts {
  std::string digest;  ///< of its elements: 64 hexadecimal digits
  int dimension = 3;
  std::size_t vertices = 0, faces = 0, edges = 0, points = 0;
  std::size_t idle = 0;        ///< the vertices that are in no edge and no loose points: they collide with nothing
  std::size_t neighbours = 0;  ///< the pairs of elements that share a vertex, of the kinds that a step is asked about
  std::size_t polygons = 0;    ///< closed polygons in the plane, beside anything else: no one asks what is inside them
  std::size_t branching = 0;   ///< surfaces with an edge of three faces or more: what is inside what is not known there
  std::size_t joined = 0;      ///< vertices at which the reader joined solids: no one asks whether they touch there
  std::size_t welded = 0;      ///< vertices for which others at the same positions stand, on request
  std::size_t animations = 0;  ///< of the file, which are not read
  std::size_t unshown = 0;     ///< meshes of the file that are not in its scene, and not read
  std::size_t moved = 0;       ///< vertices that the file moves and that are rounded
  std::size_t dropped = 0;     ///< faces and edges of the file that are none, and were left out on request

  /// Whether there are edges or faces.
  bool has_elements() const noexcept { return edges > 0; }

  /// Whether two elements could collide at all: there are more than one point, one edge or one face.
  bool has_pairs() const noexcept { return points + edges > (faces > 0 ? 3u : 1u); }

  /// Adds the numbers of another mesh.
  void add_counts(const MeshFacts& other) noexcept {
    for (const auto member :
         {&MeshFacts::vertices, &MeshFacts::edges, &MeshFacts::faces, &MeshFacts::points, &MeshFacts::idle,
          &MeshFacts::neighbours, &MeshFacts::polygons, &MeshFacts::branching, &MeshFacts::joined, &MeshFacts::welded,
          &MeshFacts::dropped, &MeshFacts::animations, &MeshFacts::unshown, &MeshFacts::moved}) {
      this->*member += other.*member;
    }
  }

  bool operator==(const MeshFacts& other) const = default;
};

/// One frame of a report.
struct FrameEntry {
  std::string label;                    ///< FrameName::label
  std::string digest;                   ///< frames::Frame::digest
  std::optional<MeshFacts> facts = {};  ///< where the frames may be different meshes
};

/// What a scene of parts that move is made of.
struct SceneFacts {
  std::size_t parts = 0;     ///< all
  std::size_t at_rest = 0;   ///< of these: at rest in all frames
  std::size_t numbered = 0;  ///< of those: the name differs from another one's in numbers only, as those of frames do

  bool operator==(const SceneFacts& other) const = default;
};

/// Within a surface: which pairs are asked about touching alone (own_neighbours).
struct SelfRule {
  double length = 0;         ///< positive
  std::size_t pairs = 0;     ///< how many they are
  std::string frame_digest;  ///< of the first frame of all, which says which pairs

  bool operator==(const SelfRule& other) const = default;
};

/// What a report is about. Two runs with the same heading differ in the content of their frames only.
struct Heading {
  std::string program;  ///< the version
  Question question = Question::steps;
  Separation separation;
  PartRules parts;                  ///< which parts were asked about
  bool clearance = false;           ///< whether the least distance was asked for, too
  bool classes = false;             ///< whether it was asked for how parts lie to each other
  std::optional<SelfRule> self;     ///< where neighbours along a surface do not count
  std::optional<SceneFacts> scene;  ///< where each part has frames of its own
  std::optional<double> dt;         ///< the second frame is the first one and so many times a file of velocities

  std::size_t frame_count = 0;     ///< of the whole sequence
  std::string list_digest;         ///< digest_of the labels of all frames
  std::optional<Shard> shard;      ///< nothing for a whole run
  std::optional<MeshFacts> facts;  ///< the mesh that all frames have; nothing where they may have different ones
};

/// A report.
struct Report {
  Heading heading;
  std::vector<FrameEntry> frames;  ///< those that were read
  std::vector<Result> results;     ///< in the order of frames
};

/// The least distance of all results, and the first frame or step that has it.
struct LeastDistance {
  double distance = std::numeric_limits<double>::infinity();
  bool step = false;      ///< as Result::step
  std::size_t frame = 0;  ///< as Result::frame
};

/// The counts at the end of a report.
struct ResultCounts {
  std::size_t results = 0;            ///< steps, or frames at rest
  std::size_t free = 0;               ///< of those, the free ones
  IntersectionCounts intersections;   ///< of the first frame, when steps are asked about, else of all frames
  std::size_t from_intersecting = 0;  ///< the free steps from a frame that intersects itself, as far as is known
  EnclosedCounts enclosed;            ///< of the same frames as `intersections`
  std::size_t frames_enclosing = 0;   ///< those with such parts
  std::size_t flat = 0;               ///< the greatest of Result::flat
  std::size_t in_open = 0;            ///< the greatest of Result::in_open
  std::size_t turning = 0;            ///< the greatest of Result::turning
  std::size_t without_inside = 0;     ///< the greatest of Result::without_inside
  std::size_t coinciding = 0;         ///< the greatest of Result::coinciding
  std::size_t own_neighbours = 0;     ///< the greatest of Result::own_neighbours
  std::optional<LeastDistance> least_distance;  ///< of Result::clearance; nothing where it was not asked for
  bool ends_intersecting = false;  ///< whether the frame at the end of the last result is known to intersect itself

  std::array<std::size_t, mesh::kRelations> classes{};  ///< pairs of parts of each class in all frames, but clear

  bool all_free() const noexcept { return free == results && intersections.all == 0; }
  void add(Question question, const Result& result) {
    flat = result.flat > flat ? result.flat : flat;
    in_open = result.in_open > in_open ? result.in_open : in_open;
    turning = result.turning > turning ? result.turning : turning;
    without_inside = result.without_inside > without_inside ? result.without_inside : without_inside;
    coinciding = result.coinciding > coinciding ? result.coinciding : coinciding;
    own_neighbours = result.own_neighbours > own_neighbours ? result.own_neighbours : own_neighbours;
    if (result.classes) {
      for (const PartRelation& one : *result.classes) ++classes[static_cast<std::size_t>(one.sort)];
    }
    if (result.clearance) {
      const double distance = result.clearance->distance;
      if (!least_distance || distance < least_distance->distance) {
        least_distance = {distance, result.step, result.frame};
      }
      if (result.step && result.clearance->starts_intersecting()) ends_intersecting = true;
    }
    // A step without contact leaves a frame that intersects itself as it is.
    if (question == Question::rest || !result.free()) ends_intersecting = !result.intersections.empty();
    if (!result.step) {
      intersections.add(result.intersections);
      enclosed.add(result.enclosed);
      frames_enclosing += result.enclosed.all() > 0 ? 1 : 0;
    }
    if (question == Question::steps && !result.step) return;
    ++results;
    free += result.free() ? 1 : 0;
    from_intersecting += result.step && result.free() && ends_intersecting ? 1 : 0;
  }
};

}  // namespace touchstone::sequence
