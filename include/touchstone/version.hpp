// Touchstone: which version this is.
// SPDX-License-Identifier: MIT
#pragma once

namespace touchstone {

/// The version of the linked library, "MAJOR.MINOR.PATCH". The CMake project is the one place that sets it.
const char* version() noexcept;

}  // namespace touchstone
