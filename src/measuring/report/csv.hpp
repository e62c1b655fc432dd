// report.csv: every number.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/report.hpp"

namespace touchstone::report {

/// The header. `exponent_column` names the quantity whose exponent SetResults::exponent is. With a separation > 0 it
/// has two more columns, and so do the rows of such sets.
std::string csv_header(const std::string& exponent_column, const Separation& separation = {});

/// A row for each set and contestant.
std::string csv_rows(const Size& size, const std::vector<SetResults>& sets);

/// A header, then a row for each set and contestant, and for each scale and contestant. Cells without meaning are
/// empty. Fractions are from 0 to 1, times are microseconds, time errors are ulps (negative: early).
std::string csv_text(const Report& report);

}  // namespace touchstone::report
