// How the program says numbers and names to a person.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>
#include <touchstone/solve.hpp>

namespace touchstone::cli {

std::string grouped(std::uint64_t number);                          ///< "1,000,000"
std::string counted(std::uint64_t number, std::string_view thing);  ///< "1 file", "1,024 files"

/// "12.5 %" of a whole that may be zero; what is there but rounds to nothing is "< 0.1 %".
std::string share(std::uint64_t part, std::uint64_t whole);

/// "0x1.8p-1 (0.75)".
std::string time_for_person(double time);

/// What touches what and how: "crossing, a against b1"; "no contact".
std::string contact_for_person(const Answer& answer);

std::string_view method_name(Method method) noexcept;  ///< "fast", "exact", "oracle": the values of --level

/// Writes to standard error as it is; when nobody can hear it, nobody does.
void print_error(const std::string& text) noexcept;

/// Why an option's value is no double, for a message after the value: " is no finite number".
std::string fault_of_number(std::string_view text);

/// `word` as one word of a POSIX shell command.
std::string shell_word(const std::string& word);

/// The command that tells one query's story.
std::string explain_command(const std::string& file, Kind kind, std::uint64_t query);

}  // namespace touchstone::cli
