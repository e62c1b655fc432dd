// The page of a report.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/report.hpp"

namespace touchstone::cli {

/// The whole HTML file.
std::string report_page(const report::Report& report);

}  // namespace touchstone::cli
