// report.md: tables for a person.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/report.hpp"

namespace touchstone::report {

/// @param plots  whether the plots were drawn, so that the text shows them
std::string markdown_text(const Report& report, bool plots);

}  // namespace touchstone::report
