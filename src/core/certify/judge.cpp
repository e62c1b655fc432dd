// SPDX-License-Identifier: MIT
#include <touchstone/certify.hpp>

#include <string>
#include <utility>
#include <vector>

#include <touchstone/contact_times.hpp>
#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include "numbers/doubles/float_environment.hpp"
#include "numbers/integers/common_denominator.hpp"
#include "numbers/written_number.hpp"

namespace touchstone {
inline namespace TOUCHSTONE_ABI {
namespace {

Fraction exact_value(const std::string& number) {
  auto value = numbers::exact_value(number);
  if (value) return {std::move(value->numerator), std::move(value->denominator)};
  constexpr std::size_t kShown = 40;
  const std::string shown = number.size() <= kShown ? number : number.substr(0, kShown) + "...";
  throw InvalidQuery("the claimed time is " + shown + "; it must be a finite number of at most " +
                     std::to_string(numbers::kMostWrittenDigits) + " digits");
}

/// The sign of (fraction - time).
class FractionAmongDoubles {
 public:
  explicit FractionAmongDoubles(const Fraction& fraction)
      : integers_(numbers::over_common_denominator({{fraction.numerator, fraction.denominator}, {"1", "1"}})) {}

  int compare(double time) const { return numbers::sign_of(integers_[0] - integers_[1] * numbers::Exact(time)); }

 private:
  std::vector<numbers::Exact> integers_;  // numerator and denominator, which is positive
};

/// Whether the claimed time is after the exact one, which times() has first. Both have the same nearest doubles, or
/// nearly.
template <class Times>
bool is_late_as_written(const Claim& claim, const Answer& truth, Times times) {
  const numbers::DefaultFloatEnvironment environment;
  const Fraction time = exact_value(claim.toi_as_written);
  const FractionAmongDoubles among(time);
  if (among.compare(truth.toi) <= 0) return false;
  if (truth.toi == truth.toi_upper || among.compare(truth.toi_upper) >= 0) return true;
  return times().front().first.compare(time) < 0;
}

/// @param times  gives the exact contact times; it is called only when they are needed
template <class Times>
Verdict judge_as_written(const Claim& claim, const Answer& truth, Times times) {
  const Verdict verdict = judge(claim, truth);
  const bool of_contact = claim.contact && truth.contact && claim.toi;
  if (!of_contact || claim.toi_as_written.empty()) return verdict;
  // If the nearest double of a time is before toi, the time lies before the midpoint of two doubles that are both at
  // most toi. The same holds after toi_upper. In both cases the nearest double decides.
  if (*claim.toi < truth.toi || *claim.toi > truth.toi_upper) return verdict;
  return is_late_as_written(claim, truth, times) ? Verdict::late : Verdict::holds;
}

}  // namespace

template <>
Names names_of<Verdict>() noexcept {
  static constexpr std::string_view kNames[] = {"holds", "missed", "phantom", "late"};
  return kNames;
}

Verdict judge(const Claim& claim, const Answer& truth) noexcept {
  if (!claim.contact) return truth.contact ? Verdict::missed : Verdict::holds;
  if (!truth.contact) return Verdict::phantom;
  // truth.toi is the largest double that is not after the exact time, so for a double c: c > truth.toi exactly when c
  // is after the exact time. Comparing with toi_upper would let a claim pass that lies between the two.
  return claim.toi && *claim.toi > truth.toi ? Verdict::late : Verdict::holds;
}

Verdict judge(const Claim& claim, const Query& query, const Answer& truth, const Separation& separation) {
  return judge_as_written(claim, truth, [&] { return contact_times(query, separation); });
}

Verdict judge(const Claim& claim, const RationalQuery& query, const Answer& truth, const Separation& separation) {
  return judge_as_written(claim, truth, [&] { return contact_times(query, separation); });
}

Verdict judge(const Claim& claim, const CurvedQuery& query, const Answer& truth, const Separation& separation) {
  return judge_as_written(claim, truth, [&] { return contact_times(query, separation); });
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
