// report.md: tables for a person.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/report.hpp"

namespace touchstone::report {

/// One paragraph: how often touchstone is wrong, and on how many fronts it is.
std::string summary(const Report& report);

/// What the tables' words mean, and what each method is, in Markdown but for the heading.
std::string how_to_read(const Report& report);

/// The whole text. It shows the pictures in the folder plots.
std::string markdown_text(const Report& report);

}  // namespace touchstone::report
