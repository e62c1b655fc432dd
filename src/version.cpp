// SPDX-License-Identifier: MIT
#include <touchstone/version.hpp>

namespace touchstone {

const char* version() noexcept { return TOUCHSTONE_VERSION; }

}  // namespace touchstone
