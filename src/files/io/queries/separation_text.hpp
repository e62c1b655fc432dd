// The separation that a file is about, as text.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <touchstone/separation.hpp>

namespace touchstone::io {

/// Whether two separations ask the same question. With distance 0 the metric does not matter.
bool same_question(const Separation& a, const Separation& b) noexcept;

/// The line, with its end, by which a query file says the separation of its truth column:
/// "# separation 0x1p-3 euclidean\n".
std::string separation_comment(const Separation& separation);

/// The separation of the first such line before the first row of a query file. Nothing when there is none; the truth
/// column then does not say what it is about.
/// @param text  the beginning of the file, at least to its first row
std::optional<Separation> separation_of_comments(std::string_view text);

}  // namespace touchstone::io
