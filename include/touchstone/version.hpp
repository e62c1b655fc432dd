// Touchstone: which version this is.
// SPDX-License-Identifier: MIT
#pragma once

/// The inline namespace of every public name of C++. Each minor version has its own, so a program that was compiled
/// with the headers of another one fails to link. Two versions in one program do not meet.
#define TOUCHSTONE_ABI v0_2

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// The version of the linked library, "MAJOR.MINOR.PATCH". The CMake project is the one place that sets it.
const char* version() noexcept;

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone

#if __cplusplus < 201703L  // there is no std::optional then, and the compiler's own messages would name that
#error "Touchstone's headers need C++17 or later: compile with -std=c++17"
#endif
