// An answer without contact. Out of line: a caller's -ffast-math may assume that infinity does not exist.
// SPDX-License-Identifier: MIT
#include <touchstone/answer.hpp>

#include <limits>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

Answer::Answer() noexcept
    : toi(std::numeric_limits<double>::infinity()), toi_upper(std::numeric_limits<double>::infinity()) {}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
