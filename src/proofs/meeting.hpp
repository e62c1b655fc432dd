// Why two elements are in contact.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>

#include "proofs/elements.hpp"
#include "proofs/proof.hpp"

namespace touchstone::proofs {

/// Points of both elements that are in contact between the answer's times. @throws Error  when none are
Meeting meeting(const Elements& elements, const Answer& answer);

}  // namespace touchstone::proofs
