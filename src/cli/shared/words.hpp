// Numbers and names as text for a person.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>
#include <touchstone/solve.hpp>

#include "io/counted.hpp"

namespace touchstone::cli {

using io::counted;
using io::grouped;

/// "12.5 %" of a whole that may be zero. A count that is not zero but rounds to zero is "< 0.1 %".
std::string percentage(std::uint64_t count, std::uint64_t whole);

/// "row 3", "rows 3 to 8".
std::string rows_text(std::uint64_t first, std::uint64_t last);

/// "0x1.8p-1 (0.75)".
std::string time_for_person(double time);

/// The nature and the features of a contact: "crossing, a against b1"; "no contact".
std::string contact_for_person(const Answer& answer);

/// Where the verdict of a text is.
enum class VerdictLine { first, last };

/// The text for standard output: where that is a terminal with colours, and NO_COLOR is not set, the verdict is green
/// or red, as far as its first bracket or semicolon.
std::string in_colour(const std::string& text, VerdictLine line, bool good);

/// The same for a terminal with colours.
std::string with_colour(std::string text, VerdictLine line, bool good);

/// Writes `text` unchanged to standard error. A write that fails is ignored.
void print_error(const std::string& text) noexcept;

/// Why an option's value is no double, for a message after the value: " is no finite number".
std::string fault_of_number(std::string_view text);

/// `word` as one word of a POSIX shell command; with control characters as $'\x1b', so that a terminal shows them.
std::string shell_word(const std::string& word);

/// The command that explains one query, for a separation and t in [0, t_max].
std::string explain_command(const std::string& file, Kind kind, std::uint64_t query, const Separation& separation = {},
                            double t_max = 1);

/// The name of a file to read, as the command line has it, where - stands for standard input.
std::string without_dash(const std::string& name);

}  // namespace touchstone::cli
