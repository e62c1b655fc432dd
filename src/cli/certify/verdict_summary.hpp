// Verdicts on claims, as text for a person.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "certify/tally.hpp"
#include "io/queries/curved_rows.hpp"
#include "io/queries/decimal_rows.hpp"

namespace touchstone::cli {

// Blocks of whole lines:
std::string verdicts_for_person(const certify::VerdictCounts& verdicts);
std::string early_for_person(const certify::TimeErrors& early);                ///< empty when no claim had a toi
std::string late_for_person(const certify::TimeErrors& late);                  ///< empty when none was late
std::string outside_for_person(std::uint64_t below_0, std::uint64_t above_1);  ///< empty when there is none

/// How many claims are how far from the exact time; empty for none. @param heading  "early" or "late"
std::string histogram_for_person(std::string_view heading, const certify::TimeErrors& errors);

/// One refuted claim and the command that explains its query. @param turns, decimals  with which it was judged
std::string refuted_for_person(const certify::RefutedClaim& refuted, io::Turns turns, io::Decimals decimals);

}  // namespace touchstone::cli
