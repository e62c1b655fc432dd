// The text of proofs, as docs/proofs.md defines it. SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include <touchstone/answer.hpp>

#include "proofs/proof.hpp"

namespace touchstone::proofs {

inline constexpr char kFirstLine[] = "touchstone-proofs 1\n";

/// An exact number that is a multiple of a power of two: a decimal integer, or a hexfloat of any length.
void append_number(std::string& to, const Exact& x);

/// The lines of one query's proof.
void append_proof(std::string& to, std::uint64_t query, const Answer& answer, const Proof& proof);

}  // namespace touchstone::proofs
