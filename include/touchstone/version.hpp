// Touchstone: which version this is.
// SPDX-License-Identifier: MIT
#pragma once

namespace touchstone {

/// "MAJOR.MINOR.PATCH" of the library that is linked; the one place that sets it is the CMake project.
const char* version() noexcept;

}  // namespace touchstone
