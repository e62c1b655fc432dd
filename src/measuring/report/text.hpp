// Numbers as reports write them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "report/measure.hpp"

namespace touchstone::report {

std::string percent(double fraction);  ///< "0", "12.5 %"
std::string ulps(std::int64_t error);  ///< "-12", "4.5e+15"

/// The number of queries of the set that were asked: "4000", or "130 of 4000".
std::string asked_text(const Result& result, const QuerySet& set);

/// " --separation 0x1p-3 --metric max": the arguments of the program that ask for it. Empty for touching.
std::string separation_arguments(const Separation& separation);

}  // namespace touchstone::report
