// SPDX-License-Identifier: MIT
#include "certify/tally.hpp"

#include <algorithm>
#include <cstddef>

namespace touchstone::certify {

void VerdictCounts::add(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::holds: ++holds; break;
    case Verdict::missed: ++missed; break;
    case Verdict::phantom: ++phantom; break;
    case Verdict::late: ++late; break;
  }
}

void VerdictCounts::merge(const VerdictCounts& other) noexcept {
  holds += other.holds;
  missed += other.missed;
  phantom += other.phantom;
  late += other.late;
}

void Tally::add(const Claim& claim, const Answer& answer, Verdict verdict) noexcept {
  verdicts.add(verdict);
  ++levels[static_cast<std::size_t>(answer.level)];
  ++natures[static_cast<std::size_t>(answer.nature)];
  if (!claim.contact || !claim.toi || !answer.contact) return;
  if (*claim.toi < 0 || *claim.toi > 1) {
    ++(*claim.toi < 0 ? below_0 : above_1);
    return;
  }
  if (verdict == Verdict::late) late.add(answer.toi, late_until(*claim.toi, answer.toi));
  if (verdict != Verdict::holds) return;
  // A time as written may hold and yet round to the double after the exact time. Then it is early by 0 doubles.
  early.add(std::min(*claim.toi, answer.toi), answer.toi);
}

void Tally::merge(const Tally& other) noexcept {
  verdicts.merge(other.verdicts);
  for (std::size_t i = 0; i < levels.size(); ++i) levels[i] += other.levels[i];
  for (std::size_t i = 0; i < natures.size(); ++i) natures[i] += other.natures[i];
  early.merge(other.early);
  late.merge(other.late);
  below_0 += other.below_0;
  above_1 += other.above_1;
}

bool counts(const Counting<Verdict>& counting, const Claim& claim, const Answer& answer, Verdict verdict,
            NotCounted& not_counted) noexcept {
  const bool is_other = !counting.has(verdict);
  if (!is_other && !(verdict == Verdict::late && counting.allows(*claim.toi, answer.toi))) return true;
  ++(is_other ? not_counted.other : not_counted.late);
  return false;
}

}  // namespace touchstone::certify
