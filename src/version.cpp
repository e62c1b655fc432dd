// SPDX-License-Identifier: MIT
#include <touchstone/version.hpp>

namespace touchstone::inline TOUCHSTONE_ABI {

const char* version() noexcept { return TOUCHSTONE_VERSION; }

}  // namespace touchstone::inline TOUCHSTONE_ABI
