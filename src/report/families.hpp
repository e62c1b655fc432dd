// The query sets that the report makes itself. The same seed makes the same queries on every machine.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <touchstone/query.hpp>

#include "report/query_set.hpp"

namespace touchstone::report {

/// Candidate pairs of the three moving scenes of the generators, one set a kind; at most `count` a kind and scene.
/// @param edges, steps  how large a scene is and for how long it moves
/// @param separation  candidates come that near
std::vector<QuerySet> simulation_sets(std::uint64_t seed, std::size_t count, std::size_t edges, std::size_t steps,
                                      double separation = 0);

/// Corners anywhere in a cube of side 2 at both ends. Edge-edge and vertex-face only: a random point never meets a
/// random edge.
std::vector<QuerySet> random_sets(std::uint64_t seed, std::size_t count);

/// The elements' lines and planes meet at a time and place that lies just inside or just outside of the elements or of
/// the step, by a fraction that is log-uniform from 2^-50 to 2^-6. Edge-edge and vertex-face.
std::vector<QuerySet> near_sets(std::uint64_t seed, std::size_t count);

/// The same queries with every coordinate times 2^exponent, which is exact for those of the two families above from
/// 2^-900 to 2^900.
std::vector<Query> scaled(const std::vector<Query>& queries, int exponent);

/// Puts the queries into an order that depends on the seed only, so that the first n are a fair sample.
void shuffle(std::vector<Query>& queries, std::uint64_t seed);

}  // namespace touchstone::report
