// Proofs of the usual contacts, in integers of fixed size.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "proofs/proof.hpp"

namespace touchstone::proofs {

/// A proof of a contact of two edges, or of a vertex and a face, between their ends, where the plane along u x w keeps
/// them apart before, or the contact begins at t = 0. None where it is not found; with a separation in the metric `max`
/// it never is.
std::optional<Proof> quick_contact(const Query& query, const Answer& answer, const Separation& separation);

}  // namespace touchstone::proofs
