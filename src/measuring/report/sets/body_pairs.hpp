// Pairs of elements such as a simulation of rigid bodies asks about: those of the scenes link-chain and nut-and-bolt.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>

#include "report/sets/query_set.hpp"

namespace touchstone::report {

struct BodyPairOptions {
  std::size_t count = 4000;  ///< the most pairs of each kind, about
  double separation = 0;     ///< candidates come that near
};

/// Called often during the work; may throw to end it.
using BodyPulse = std::function<void()>;

inline constexpr std::array<std::string_view, 2> kBodyScenes{"link-chain", "nut-and-bolt"};

/// One set for each kind that the scene has, named "link-chain/edge-edge". Most pairs are those of the steps as the
/// simulation takes them: their boxes overlap and they do not touch. About one in a hundred is a pair that touches when
/// both bodies move on freely, for the shortest time of 1, 2, 4, ... steps in which any pair touches.
std::vector<QuerySet> body_pair_sets(std::string_view scene, const BodyPairOptions& options, const BodyPulse& pulse);

/// The straight motion between the same corners at both ends of the step, rounded to doubles.
Query straight_twin(const CurvedQuery& query);

}  // namespace touchstone::report
