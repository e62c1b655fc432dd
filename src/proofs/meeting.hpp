// Why two elements touch. SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>

#include "proofs/elements.hpp"
#include "proofs/proof.hpp"

namespace touchstone::proofs {

/// Points of both elements that meet between the answer's times. @throws Error  when none do
Meeting meeting(const Elements& elements, const Answer& answer);

}  // namespace touchstone::proofs
