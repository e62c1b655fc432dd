// Queries such as a simulation asks: the candidate pairs of elements of a moving scene.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <touchstone/query.hpp>

#include "generators/moving_mesh.hpp"

namespace touchstone::generators {

struct CandidateOptions {
  SceneName scene = SceneName::cloth;
  std::uint64_t seed = 1;
  std::size_t edges = 4000;  ///< about how many the scene has; in [kFewestEdges, kMostEdges]
  std::size_t steps = 20;    ///< the number of steps that the scene makes
  double separation = 0;     ///< the distance of a contact: a candidate's boxes are that near; finite, >= 0
  double speed = 1;          ///< 1: most corners move by a tenth of an edge's length a step; finite, >= 0
  Placement placement = Placement::as_built;  ///< of the whole scene
  bool edge_edge = true;
  bool vertex_face = true;
  bool shared_corners = false;  ///< also the pairs that share a corner; they touch there at all times
  std::uint64_t count = 0;      ///< at most so many of each kind, drawn evenly from all the steps; 0: every one
};

inline constexpr double kGreatestSpeed = 1000;

/// Queries of one kind from one step. The step's ends are the same doubles in all of its queries, and the end of one
/// step is the start of the next.
struct Batch {
  std::size_t step = 0;
  Kind kind = Kind::edge_edge;
  std::vector<Query> queries;
};
inline constexpr std::size_t kBatchQueries = 4096;

struct CandidateCounts {
  std::uint64_t edge_edge = 0;
  std::uint64_t vertex_face = 0;
};

/// Calls take(batch) with batches of at most kBatchQueries, step by step; memory does not grow with their number.
/// A pair is a candidate when the boxes around the two elements' paths, each grown by half the separation, overlap:
/// every contact is among them. The same options give the same queries, bit for bit, on every machine.
/// @returns how many queries were handed out
/// @throws InvalidQuery  for options outside their ranges
CandidateCounts for_each_batch(const CandidateOptions& options, const std::function<void(const Batch&)>& take);

/// All of them, or the `count` that the options ask for, at once.
std::vector<Query> candidates(const CandidateOptions& options);

}  // namespace touchstone::generators
