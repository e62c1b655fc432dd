// SPDX-License-Identifier: MIT
#include <touchstone/version.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

const char* version() noexcept { return TOUCHSTONE_VERSION; }

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
