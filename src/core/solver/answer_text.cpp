// SPDX-License-Identifier: MIT
#include <cmath>

#include <touchstone/answer.hpp>

#include "numbers/doubles/decimal_text.hpp"

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

std::string to_string(const Answer& answer) {
  if (!answer.contact) return "no contact";
  std::string text = "contact";
  const std::string toi = numbers::decimal_text(answer.toi);
  if (answer.toi == answer.toi_upper) {
    text += " at t = " + toi;
  } else if (!std::isnan(answer.toi)) {
    text += " at t in [" + toi + ", " + numbers::decimal_text(answer.toi_upper) + "]";
  }
  if (answer.nature == Nature::none) return text;
  text.append(", ").append(name_of(answer.nature)).append(", ").append(name_of(answer.feature_a));
  if (answer.feature_a == Feature::overlap) return text;
  return text.append(" against ").append(name_of(answer.feature_b));
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
