// The text of proofs, as docs/proofs.md defines it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include <touchstone/answer.hpp>

#include "proofs/proof.hpp"

namespace touchstone::proofs {

inline constexpr char kFirstLine[] = "touchstone-proofs 1\n";

/// An exact number that is a multiple of a power of two: a decimal integer, or a hexfloat of any length.
void append_number(std::string& to, const Exact& x);

/// The line of a file's separation; none without one.
void append_separation(std::string& to, const Separation& separation);

/// The lines of one query's proof.
void append_proof(std::string& to, std::uint64_t number, const Answer& answer, const Proof& proof);

/// The same for the proof that `prove` finds, without a Proof in between where a direction is found in doubles.
void append_proof_of(std::string& to, std::uint64_t number, const Query& query, const Answer& answer,
                     const Separation& separation = {});
void append_proof_of(std::string& to, std::uint64_t number, const RationalQuery& query, const Answer& answer,
                     const Separation& separation = {});
void append_proof_of(std::string& to, std::uint64_t number, const CurvedQuery& query, const Answer& answer,
                     const Separation& separation = {});

}  // namespace touchstone::proofs
