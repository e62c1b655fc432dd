// Exact coordinates for pages: hexfloats, one corner a line.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <touchstone/query.hpp>

namespace touchstone::cli {

/// "particle 3: 0x1p+0 0x1.8p-2 0x0p+0" and a line end.
std::string exact_corner(std::string_view name, const Vec3& x);

/// A line for each corner of a query at the start and at the end, by its name in the query.
std::string exact_corners(const Query& query);

}  // namespace touchstone::cli
