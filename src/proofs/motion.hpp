// The motion of a mesh: which pairs of a step are to be proved, their proofs, and the text of a motion file.
// docs/proofs.md, "Motions of meshes", defines all of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

namespace touchstone::proofs {

/// The elements of a motion file. The numbers of vertices are below vertex_count.
struct MotionElements {
  std::size_t vertex_count = 0;
  std::vector<std::uint32_t> points;                ///< each vertex once
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< of different vertices
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< of different vertices
  std::vector<char> fixed;                          ///< by vertex: whether it never moves; empty when all may
};

/// The vertices that collide, in ascending order: the corners of edges and the loose points.
std::vector<std::uint32_t> colliding_vertices(const std::vector<std::array<std::uint32_t, 2>>& edges,
                                              const std::vector<std::uint32_t>& loose_points);

/// The position of each vertex. All coordinates are finite.
using MotionFrame = std::vector<Vec3>;

/// Two elements, by their numbers among those of their sort.
struct MotionPair {
  Kind kind = Kind::edge_edge;
  std::uint32_t first = 0, second = 0;

  bool operator==(const MotionPair& other) const = default;
};

/// Whether a <= b + distance, in exact arithmetic. All are finite, and distance >= 0.
bool at_most_apart(double a, double b, double distance) noexcept;

/// Finds the pairs of a step, and proves the answer to each.
class StepProver {
 public:
  /// @param separation  of all pairs
  StepProver(MotionElements elements, const Separation& separation);

  const MotionElements& elements() const noexcept { return elements_; }
  const Separation& separation() const noexcept { return separation_; }

  /// The pairs of the step between two frames, in the order of the proofs; the same for any number of threads.
  std::vector<MotionPair> pairs(const MotionFrame& start, const MotionFrame& end, int threads) const;

  Query query_of(const MotionPair& pair, const MotionFrame& start, const MotionFrame& end) const;

  /// Answers a pair and appends the lines of its proof. Several threads may call it at the same time.
  /// @throws Error  as prove does
  Answer append_proof(std::string& to, std::uint64_t number, const MotionPair& pair, const MotionFrame& start,
                      const MotionFrame& end) const;

 private:
  std::array<std::uint32_t, 4> corners_of(const MotionPair& pair) const noexcept;

  MotionElements elements_;
  Separation separation_;
  std::vector<std::uint32_t> loose_;  // the numbers of the points that are a corner of no edge
};

/// The lines of a motion file before the first frame.
std::string motion_head(const MotionElements& elements);

/// The lines of a frame.
void append_frame(std::string& to, const MotionFrame& frame);

}  // namespace touchstone::proofs
