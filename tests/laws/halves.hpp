// What is known of the answer to a part of a step from the answer to all of it, and the other way round.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include <touchstone/answer.hpp>

#include "seeded/rng.hpp"

namespace touchstone::tests {

/// Ends of the time range that are worth asking for: around the times of an answer, and others.
inline std::vector<double> ends_around(const Answer& whole, seeded::Rng& rng) {
  std::vector<double> ends{0, 1, rng.unit()};
  if (!whole.contact) return ends;
  for (const double bound : {whole.toi, whole.toi_upper}) {
    ends.push_back(bound);
    ends.push_back(std::nextafter(bound, 0.0));
    ends.push_back(std::min(1.0, std::nextafter(bound, 2.0)));
  }
  return ends;
}

/// The answer with a t_max, given the answer without one.
inline Answer cut_off(const Answer& whole, double t_max) {
  if (!whole.contact || whole.toi_upper > t_max) return {};
  Answer cut = whole;
  // A contact that would last longer is a single instant of the range, which ends with it.
  if (whole.toi == t_max && whole.nature == Nature::sustained) cut.nature = Nature::isolated;
  return cut;
}

/// The neighbouring doubles around (1 + time) / 2, from those around `time`. Doubles in [1/2, 1] are the multiples of
/// 2^-53, and twice one less 1 is a double, so that none lies between where these round to and the time.
inline std::pair<double, double> in_second_half(const Answer& answer) {
  const double lower = std::floor((0.5 * answer.toi) * 0x1p53) * 0x1p-53;
  const double upper = std::ceil((0.5 * answer.toi_upper) * 0x1p53) * 0x1p-53;
  return {0.5 + lower, 0.5 + upper};
}

/// The answer to a step, from that to its first half and, where nothing touches in it, that to the second.
/// @param whole  the answer to the step; only its nature is read, where a contact at the end of the first half has
/// another
/// @param second  gives the answer to the second half
template <typename Second>
Answer of_halves(const Answer& whole, Answer first, Second&& second) {
  if (first.contact) {
    // A contact that lasts through the second half may be a single instant of the first.
    const bool at_its_end = first.toi == 1;
    first.toi *= 0.5;
    first.toi_upper *= 0.5;
    if (at_its_end && first.nature == Nature::isolated) first.nature = whole.nature;
    return first;
  }
  Answer later = second();
  if (later.contact) std::tie(later.toi, later.toi_upper) = in_second_half(later);
  return later;
}

}  // namespace touchstone::tests
