// SPDX-License-Identifier: MIT
#include "proofs/meeting.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>

#include "numbers/roots/common_divisor.hpp"
#include "numbers/roots/real_root.hpp"
#include "proofs/constructions.hpp"

namespace touchstone::proofs {
namespace {

using numbers::RealRoot;

/// Makes the weights positive or absent, given their signs; false when some of an element are of one sign and some of
/// the other, or an element has none.
bool keep_positive(const Elements& elements, const std::array<int, 4>& signs, std::array<Dense, 4>& weights) {
  // The sign is that of the sum over an element, and may differ between the elements.
  for (const auto& [begin, end] :
       {std::pair{std::size_t{0}, elements.first_count}, std::pair{elements.first_count, elements.count}}) {
    int side = 0;
    for (std::size_t i = begin; i < end; ++i) {
      if (signs[i] == 0) {
        weights[i].clear();
      } else if (side == -signs[i]) {
        return false;
      } else {
        side = signs[i];
      }
    }
    if (side == 0) return false;
    for (std::size_t i = begin; i < end && side < 0; ++i) weights[i] = -weights[i];
  }
  return true;
}

/// The signs of the weights by `sign_of`, which takes a polynomial that is not identically zero.
template <class SignOf>
std::array<int, 4> signs_of(const std::array<Dense, 4>& weights, SignOf&& sign_of) {
  std::array<int, 4> signs{};
  for (std::size_t i = 0; i < signs.size(); ++i) signs[i] = is_zero(weights[i]) ? 0 : sign_of(weights[i]);
  return signs;
}

/// The meeting at a time that is a double. `still` are the elements at that time, so all polynomials are constant.
std::optional<Meeting> meeting_at(const Elements& still, const Exact& time, const Construction& construction) {
  const auto sign = [](const Dense& p) { return numbers::sign_of(value(p, Exact(0))); };
  if (!still.has_max_separation()) {
    for (const Dense& p : construction.events.front()) {
      const int s = sign(p);
      if (s > 0 || (s < 0 && !still.has_separation())) return std::nullopt;
    }
  }
  Meeting result;
  result.weights = construction.weights;
  result.low = result.high = time;
  if (!keep_positive(still, signs_of(result.weights, sign), result.weights)) return std::nullopt;
  for (const Dense& p : conditions(still, result.weights)) {
    if (sign(p) < 0) return std::nullopt;
  }
  return result;
}

bool changes_sign(const Meeting& meeting) {
  return numbers::sign_of(value(meeting.root, meeting.low)) * numbers::sign_of(value(meeting.root, meeting.high)) < 0;
}

/// Whether the meeting passes the check of docs/proofs.md. That the points are in contact at a root is known except in
/// the metric `max`, where the conditions say it.
bool proves(const Elements& elements, const Meeting& meeting) {
  if (!changes_sign(meeting)) return false;
  const auto is_positive = [&](const Dense& p) {
    return sign_over(p, meeting.low, meeting.high, Inner::not_zero) == 1;
  };
  for (const Dense& weight : meeting.weights) {
    if (!weight.empty() && !is_positive(weight)) return false;
  }
  // A body's own weight is positive, but its Bernstein coefficients may not be where its quaternion shrinks to 2^-900
  // of its length between two doubles.
  const auto sums = sums_of(elements, meeting.weights);
  if (!std::all_of(sums.begin(), sums.end(), is_positive)) return false;
  const auto all = conditions(elements, meeting.weights);
  return std::all_of(all.begin(), all.end(), [&](const Dense& p) {
    return nowhere_negative(p, meeting.low, meeting.high) || divides(meeting.root, p);
  });
}

/// The usual case without isolation of roots: the event's polynomial changes its sign between the two times, and all
/// weights are positive there.
std::optional<Meeting> direct_meeting(const Elements& elements, const Answer& answer,
                                      const Construction& construction) {
  Meeting result;
  result.low = Exact(answer.toi);
  result.high = Exact(answer.toi_upper);
  result.weights = construction.weights;
  const auto sign_at_low = [&](const Dense& p) { return numbers::sign_of(value(p, result.low)); };
  for (const Dense& p : construction.weights) {
    if (!is_zero(p) && sign_at_low(p) == 0) return std::nullopt;
  }
  if (!keep_positive(elements, signs_of(result.weights, sign_at_low), result.weights)) return std::nullopt;
  for (const std::vector<Dense>& event : construction.events) {
    if (event.size() != 1) continue;
    result.root = event.front();
    while (!result.root.empty() && numbers::is_zero(result.root.back())) result.root.pop_back();
    if (proves(elements, result)) return result;
  }
  return std::nullopt;
}

/// Narrows the bracket around the root until the root is alone in it, in the sense that a proof needs.
bool narrow(const Elements& elements, const RealRoot& root, Meeting& meeting) {
  constexpr int kMostHalvings = 100'000;
  for (int i = 0; i < kMostHalvings; ++i) {
    if (proves(elements, meeting)) return true;
    const Exact middle = (meeting.low + meeting.high) * Exact(0.5);
    const int side = root.compare(middle);
    if (side >= 0) meeting.low = side > 0 ? middle : (meeting.low + middle) * Exact(0.5);
    if (side <= 0) meeting.high = side < 0 ? middle : (meeting.high + middle) * Exact(0.5);
  }
  return false;
}

/// The meeting at one root of an event.
std::optional<Meeting> meeting_at_root(const Elements& elements, const Answer& answer, const Construction& construction,
                                       const Dense& event, const RealRoot& root) {
  Meeting result;
  result.weights = construction.weights;
  result.root = event;
  // A polynomial that vanishes at the root, but not everywhere, becomes a multiple of `root`.
  const auto sign_at_root = [&](const Dense& p) {
    const int sign = root.sign_at(coefficients(p));
    if (sign == 0) result.root = numbers::simple_common_divisor(coefficients(result.root), coefficients(p));
    return sign;
  };
  if (!keep_positive(elements, signs_of(result.weights, sign_at_root), result.weights)) return std::nullopt;
  for (const Dense& p : conditions(elements, result.weights)) {
    if (!is_zero(p) && sign_at_root(p) < 0) return std::nullopt;
  }
  result.low = Exact(answer.toi);
  result.high = Exact(answer.toi_upper);
  if (!narrow(elements, root, result)) return std::nullopt;
  return result;
}

/// The meeting at a root between two neighbouring doubles.
std::optional<Meeting> meeting_between(const Elements& elements, const Answer& answer,
                                       const Construction& construction) {
  for (const std::vector<Dense>& event : construction.events) {
    Dense common;
    for (const Dense& p : event) {
      if (!is_zero(p)) common = numbers::simple_common_divisor(coefficients(common), coefficients(p));
    }
    if (common.size() < 2) continue;
    const numbers::RootList roots = numbers::isolate_roots(coefficients(common), Exact(1));
    for (int i = 0; i < roots.size(); ++i) {
      const RealRoot& root = roots[i];
      if (root.lower() != answer.toi || root.upper() != answer.toi_upper) continue;
      if (auto found = meeting_at_root(elements, answer, construction, common, root)) return found;
    }
  }
  return std::nullopt;
}

}  // namespace

Meeting meeting(const Elements& elements, const Answer& answer) {
  std::optional<Meeting> found;
  const Exact upper(answer.toi_upper);
  const auto first_of = [&](const Elements& of, Events events, auto&& try_one) {
    try_constructions(of, upper, events, [&](const Construction& c) { return (found = try_one(c)).has_value(); });
  };
  if (answer.toi == answer.toi_upper) {
    const Elements still = elements.at(upper);
    first_of(still, Events::unneeded, [&](const Construction& c) { return meeting_at(still, upper, c); });
  } else {
    first_of(elements, Events::needed, [&](const Construction& c) { return direct_meeting(elements, answer, c); });
    if (!found) {
      first_of(elements, Events::needed, [&](const Construction& c) { return meeting_between(elements, answer, c); });
    }
  }
  if (!found) throw Error("the elements are not in contact: there is no proof that they are");
  return std::move(*found);
}

}  // namespace touchstone::proofs
