// The bracket level. It isolates the sign changes of V with certified signs, decides the side conditions over each
// bracket, and drives the time of a contact to its two neighbouring doubles, all in error-bounded doubles.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>

#include "filters/question.hpp"
#include "filters/refined_root.hpp"

namespace touchstone::filters {

/// What this level finds. `close`: it is uncertain at a root where the elements touch, or where doubles cannot tell
/// that they are apart. Then no direction separates them in doubles.
struct BracketFinding {
  Outcome finding = Outcome::uncertain;
  bool close = false;
};

/// Decides an edge-edge or vertex-face query whose contact, if any, is an ordinary crossing inside both elements, at
/// the step's ends too. It asks for an exact value only where the time is so close to a double, or so small, that
/// doubles cannot tell. On `contact` the answer is complete (nature, features, times, weights) except for its level, or
/// untouched where only contact is asked for. Otherwise the answer is untouched.
BracketFinding decide_in_brackets(const Question& question, Answer& answer);

/// The last step of this level: decides at the one root of V in the step. The answer is as that of decide_in_brackets.
Outcome decide_refined(const Question& question, const SimpleRoot& root, Answer& answer);

/// Writes a contact of that kind at a root into an untouched answer.
void write_contact(Kind kind, const RefinedRoot& refined, Answer& answer) noexcept;

}  // namespace touchstone::filters
