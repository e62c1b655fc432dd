// Numbers as base64, for typed arrays of a page's script.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace touchstone::view {

/// The bytes of `count` numbers, little-endian whatever the machine is.
template <class Number>
std::string base64_of(const Number* numbers, std::size_t count);

}  // namespace touchstone::view
