// The motion of a mesh: which pairs of a step are to be proved, their proofs, and the text of a motion file.
// docs/proofs.md, "Motions of meshes", defines all of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/mesh.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

namespace touchstone::proofs {

/// A vertex that is a point of a body.
struct BodyVertex {
  std::uint32_t body = 0;
  Vec3 point;  ///< in the body's own frame
};

/// The radii of the elements of a motion, none of them negative. All are empty where each radius is zero.
struct MotionRadii {
  std::vector<double> points, edges, faces;
  /// Pairs of different vertices, each once: elements one of which has one of the two, and the other one the other,
  /// only do not touch.
  std::vector<std::array<std::uint32_t, 2>> near;

  bool any() const noexcept { return !points.empty() || !edges.empty() || !faces.empty(); }
};

/// Two elements are no pair if all groups of one are ignored with all groups of the other.
struct MotionGroups {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};  ///< a group that is ignored with none
  std::vector<std::uint32_t> of_vertices;                    ///< by vertex; empty when nothing is ignored
  std::vector<std::array<std::uint32_t, 2>> ignored;         ///< the lesser group first, in ascending order

  /// Of two groups.
  bool are_asked(std::uint32_t g, std::uint32_t h) const noexcept {
    return !std::binary_search(ignored.begin(), ignored.end(), std::array{std::min(g, h), std::max(g, h)});
  }

  /// Of elements with these corners.
  template <std::size_t N, std::size_t M>
  bool are_asked(const std::array<std::uint32_t, N>& a, const std::array<std::uint32_t, M>& b) const noexcept {
    return ignored.empty() || std::any_of(a.begin(), a.end(), [&](std::uint32_t v) {
             return std::any_of(b.begin(), b.end(),
                                [&](std::uint32_t w) { return are_asked(of_vertices[v], of_vertices[w]); });
           });
  }
};

/// The groups by which the same elements are no pairs as by the rules of a mesh. Groups with the same list of groups
/// are one here: many objects of which nothing is asked, say.
inline MotionGroups motion_groups(const CollisionRules& rules) {
  const bool only_listed = rules.group_rule == GroupRule::only_listed;
  if (rules.groups.empty() || (!only_listed && rules.group_pairs.empty())) return {};
  std::map<std::uint32_t, std::vector<std::uint32_t>> listed;  // with each group, in ascending order
  for (const std::uint32_t group : rules.groups) listed[group];
  for (const auto& [g, h] : rules.group_pairs) {
    listed[g].push_back(h);
    listed[h].push_back(g);
  }
  std::map<std::vector<std::uint32_t>, std::uint32_t> numbers;  // of the new groups, by their lists
  std::map<std::uint32_t, std::uint32_t> number_of;             // and by the groups
  if (!only_listed) numbers.emplace(std::vector<std::uint32_t>{}, MotionGroups::kNone);
  const auto first = static_cast<std::uint32_t>(numbers.size());
  for (auto& [group, list] : listed) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    number_of[group] = numbers.emplace(list, static_cast<std::uint32_t>(numbers.size()) - first).first->second;
  }
  MotionGroups groups;
  for (const std::uint32_t group : rules.groups) groups.of_vertices.push_back(number_of.at(group));
  if (!only_listed) {
    for (const auto& [g, h] : rules.group_pairs) {
      groups.ignored.push_back(
          {std::min(number_of.at(g), number_of.at(h)), std::max(number_of.at(g), number_of.at(h))});
    }
  } else {
    for (const auto& [list, number] : numbers) {
      std::vector<char> asked(numbers.size(), 0);
      for (const std::uint32_t group : list) asked[number_of.at(group)] = 1;
      for (std::uint32_t other = number; other < asked.size(); ++other) {
        if (asked[other] == 0) groups.ignored.push_back({number, other});
      }
    }
  }
  std::sort(groups.ignored.begin(), groups.ignored.end());
  groups.ignored.erase(std::unique(groups.ignored.begin(), groups.ignored.end()), groups.ignored.end());
  return groups;
}

/// Two elements, by their numbers among those of their sort.
struct MotionPair {
  Kind kind = Kind::edge_edge;
  std::uint32_t first = 0, second = 0;

  auto operator<=>(const MotionPair& other) const = default;
};

/// The elements of a motion file. The numbers of vertices are below vertex_count.
struct MotionElements {
  std::size_t vertex_count = 0;
  std::vector<std::uint32_t> points;                ///< each vertex once
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< of different vertices
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< of different vertices
  std::vector<char> fixed;                          ///< by vertex: whether it never moves; empty when all may
  std::vector<BodyVertex> on_bodies = {};           ///< the last vertices
  MotionRadii radii = {};
  MotionGroups groups = {};
  std::vector<MotionPair> touching = {};  ///< pairs whose separation is zero, in ascending order

  std::size_t free_count() const noexcept { return vertex_count - on_bodies.size(); }  ///< vertices on no body
};

/// The vertices that collide, in ascending order: the corners of edges and the loose points.
std::vector<std::uint32_t> colliding_vertices(const std::vector<std::array<std::uint32_t, 2>>& edges,
                                              const std::vector<std::uint32_t>& loose_points);

/// Adds the vertices of a body, and its elements by the numbers of these. The radii stay as they are.
/// @param points   of all its vertices
/// @param collide  the numbers of those that collide
void add_body(MotionElements& to, std::uint32_t body, const std::vector<Vec3>& points,
              const std::vector<std::uint32_t>& collide, const std::vector<std::array<std::uint32_t, 2>>& edges,
              const std::vector<std::array<std::uint32_t, 3>>& faces);

struct MotionPose {
  std::array<double, 4> q{1, 0, 0, 0};
  Vec3 p;
};

/// The position of each vertex that is on no body, and the pose of each body. All numbers are finite.
struct MotionFrame : std::vector<Vec3> {
  using std::vector<Vec3>::vector;
  std::vector<MotionPose> poses;
};

/// Whether a <= b + distance, in exact arithmetic. All are finite, and distance >= 0.
bool at_most_apart(double a, double b, double distance) noexcept;

/// Finds the pairs of a step, and proves the answer to each.
class StepProver {
 public:
  /// @param separation  of all pairs but folds, for which it is zero; zero with radii
  StepProver(MotionElements elements, const Separation& separation);

  const MotionElements& elements() const noexcept { return elements_; }
  const Separation& separation() const noexcept { return separation_; }

  /// Whether two elements could meet in a step at all, however far apart they are. Without a pair, proofs show nothing,
  /// and the checker refuses them.
  bool has_pair() const;

  /// The pairs of the step between two frames, in the order of the proofs; the same for any number of threads.
  std::vector<MotionPair> pairs(const MotionFrame& start, const MotionFrame& end, int threads) const;

  /// The separation that a pair's proof is about: zero for those that only touch, and for a fold, a point and a wire
  /// that another wire joins. Wires are edges that are no sides of faces. With radii, their sum, rounded up, but zero
  /// where vertices are near.
  Separation separation_of(const MotionPair& pair) const noexcept;

  /// Of a pair without a vertex on a body.
  Query query_of(const MotionPair& pair, const MotionFrame& start, const MotionFrame& end) const;
  CurvedQuery curved_query_of(const MotionPair& pair, const MotionFrame& start, const MotionFrame& end) const;

  /// Answers a pair and appends the lines of its proof. Several threads may call it at the same time.
  /// @throws Error  as prove does
  Answer append_proof(std::string& to, std::uint64_t number, const MotionPair& pair, const MotionFrame& start,
                      const MotionFrame& end) const;

 private:
  std::array<std::uint32_t, 4> corners_of(const MotionPair& pair) const noexcept;
  bool are_near(const MotionPair& pair) const noexcept;
  double largest_separation() const noexcept;
  bool is_curved(const MotionPair& pair) const noexcept;

  MotionElements elements_;
  Separation separation_;
  // Numbers of points that are a corner of no edge, of those that are corners of wires, and of the wires; and the pairs
  // of vertices that wires join, sorted.
  std::vector<std::uint32_t> loose_, wire_ends_, wires_;
  std::vector<std::array<std::uint32_t, 2>> joined_;
};

/// The lines of a motion file before the first frame.
std::string motion_head(const MotionElements& elements);

/// The lines of a frame: the poses, and then the positions.
void append_frame(std::string& to, const MotionFrame& frame);

}  // namespace touchstone::proofs
