// Numbers of things as text for a person.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace touchstone::io {

std::string grouped(std::uint64_t number);  ///< "1,000,000"

/// "1 file", "1,024 files", "2 queries", "8 vertices".
std::string counted(std::uint64_t number, std::string_view thing);

}  // namespace touchstone::io
