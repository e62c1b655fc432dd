// Fast tests in doubles, each sound by itself for any finite input in the default floating-point environment: they
// prove, or say that they are uncertain; never a guess.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>

#include "filters/same_side.hpp"

namespace touchstone::filters {

/// What a level says.
enum class Decision : std::uint8_t { uncertain, no_contact, contact };

/// Which test proved that there is no contact in [0, 1]; `none` when all are uncertain.
enum class Proof : std::uint8_t { none, same_side, boxes, closest_points, normal, centres };

/// Runs the tests that can only prove separation, in order, until one does.
Proof separation_proof(const Query& query) noexcept;

/// V(t) for a double t within a relative error of 2^-50, with its exact sign: what doubles cannot tell, from the level
/// below. A value that underflows is the least double of its sign.
using ExactValue = double (*)(const Query& query, double t);

/// How much of the answer is wanted.
enum class Want : std::uint8_t { everything, contact_only };

/// The first test, for any coordinates, NaN and infinity included. True proves that the coordinates are finite and that
/// there is no contact.
bool same_side(const Query& query) noexcept;

/// The tests after the first, for a valid query: separation and shared corners (Level::filter), then the bracket level
/// (Level::bracket). `answer` comes in as one without contact, Answer(); it is complete when it goes out, unless the
/// decision is uncertain or only contact is wanted.
Decision decide(const Query& query, double t_max, Want want, ExactValue exact_value, Answer& answer);

}  // namespace touchstone::filters
