// Steps of two whole bodies that turn: what a motion planner or a simulator of rigid bodies asks about.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "report/sets/body_pairs.hpp"
#include "report/sets/query_set.hpp"

namespace touchstone::report {

/// `count` steps of each of four sorts, a set each: random shapes and boxes, gears, and rings like links of a chain,
/// which just touch or just miss each other; and boxes that touch at round times or miss by an ulp. They start apart.
std::vector<QuerySet> body_step_sets(std::uint64_t seed, std::size_t count, const BodyPulse& pulse);

}  // namespace touchstone::report
