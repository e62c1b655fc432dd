// The query sets that the report makes itself. The same seed makes the same queries on every machine.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <touchstone/query.hpp>

#include "report/sets/query_set.hpp"

namespace touchstone::report {

/// How many candidates are taken of a scene.
struct SceneSize {
  std::size_t count;  ///< at most so many of each kind
  std::size_t edges;  ///< about how many the scene has
  std::size_t steps;  ///< how long it moves
};

/// Candidate pairs of the three moving scenes of the generators, one set a kind.
/// @param separation  candidates come that near
std::vector<QuerySet> simulation_sets(std::uint64_t seed, const SceneSize& size, double separation = 0);

/// Candidate pairs of the scenes along the axes, one set a kind, and of the same scenes turned.
/// @param separation  candidates come that near
std::vector<QuerySet> aligned_sets(std::uint64_t seed, const SceneSize& size, double separation = 0);

/// Corners anywhere in a cube of side 2 at both ends. Edge-edge and vertex-face only: a random point never meets a
/// random edge.
std::vector<QuerySet> random_sets(std::uint64_t seed, std::size_t count);

/// The elements' lines and planes meet at a time and place that lies just inside or just outside of the elements or of
/// the step, by a fraction that is log-uniform from 2^-50 to 2^-6. Edge-edge and vertex-face.
std::vector<QuerySet> near_sets(std::uint64_t seed, std::size_t count);

/// The same queries with every coordinate times 2^exponent, which is exact for those of the two families above from
/// 2^-900 to 2^900.
std::vector<Query> scaled(const std::vector<Query>& queries, int exponent);

/// `count` queries of each family of curved queries, one set a kind.
std::vector<QuerySet> curved_sets(std::uint64_t seed, std::size_t count);

}  // namespace touchstone::report
