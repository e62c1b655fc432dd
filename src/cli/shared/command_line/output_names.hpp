// The names of the files that commands write: a name with the ending of another format is a mistake.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace touchstone::cli {

/// What is written into a file.
enum class Output : std::uint8_t { csv, json, json_lines, page, animation, picture, text, theorem };

/// Why a file of this name cannot be written, or an empty text: the name is empty, or has the ending of another format.
/// "-", standard output, and endings that no known format has are fine.
std::string fault_of_name(const std::string& name, Output output);

/// The same as a check of an option.
std::function<std::string(const std::string&)> named_as(Output output);

/// Why coqc could not read a theorem in a file of this name, or an empty text. @param usual  a name that is right
std::string fault_of_module_name(const std::string& name, const std::string& usual);

}  // namespace touchstone::cli
