// report.csv: every number.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/report.hpp"

namespace touchstone::report {

/// A header, then a row for each set and contestant, and for each scale and contestant. Cells without meaning are
/// empty. Shares are from 0 to 1, times are microseconds, time errors are ulps (negative: early).
std::string csv_text(const Report& report);

}  // namespace touchstone::report
