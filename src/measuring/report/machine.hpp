// The origin of the numbers: processor, compiler, version.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace touchstone::report {

/// The processor's name as Linux gives it, or else the system's name and architecture.
std::string machine_name();

/// The compiler that built this layer: "g++ 12.2.0".
std::string compiler_name();

}  // namespace touchstone::report
