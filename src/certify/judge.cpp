// SPDX-License-Identifier: MIT
#include <touchstone/certify.hpp>

namespace touchstone {

std::string_view verdict_name(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::holds: return "holds";
    case Verdict::missed: return "missed";
    case Verdict::phantom: return "phantom";
    case Verdict::late: return "late";
  }
  return "";
}

Verdict judge(const Claim& claim, const Answer& truth) noexcept {
  if (!claim.contact) return truth.contact ? Verdict::missed : Verdict::holds;
  if (!truth.contact) return Verdict::phantom;
  // truth.toi is the largest double that is not after the exact time, so for a double c: c > truth.toi exactly when c
  // is after the exact time. Comparing with toi_upper would let a claim pass that lies between the two.
  return claim.toi && *claim.toi > truth.toi ? Verdict::late : Verdict::holds;
}

}  // namespace touchstone
