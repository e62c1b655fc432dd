// SPDX-License-Identifier: MIT
#include "filters/refined_root.hpp"

#include <cmath>
#include <optional>

#include "filters/contact_values.hpp"
#include "filters/refined_root_steps.hpp"
#include "numbers/doubles/double_double.hpp"

namespace touchstone::filters {
namespace {

/// A bound on the error of an ExactValue: 2^-50 of it, and less than 2^-1074 where it underflows. The terms of
/// offset_of may underflow too.
double exact_value_error(double value) noexcept { return 8 * kUnit * std::fabs(value) + 0x1p-1072; }

/// Finds the two neighbouring doubles around a root, equal when it is a double. It uses the root's offset and, where
/// this leaves a doubt, V's exact value at a double: its sign tells on which side of the double the root lies, because
/// V is monotone within the root's radius.
///
/// Its results are RefinedRoots without weights: `contact` means that the times are found, `no_contact` that the root
/// lies outside [0, 1].
template <class ValueAt>
class NeighbouringDoubles {
 public:
  /// value_at(t): an ExactValue of the query at t.
  NeighbouringDoubles(const SimpleRoot& root, const Offset& offset, const ValueAt& value_at)
      : root_(root), value_at_(value_at), base_(root.t), offset_(offset) {}

  RefinedRoot find() {
    const bool inner = root_.t - root_.radius > 0 && root_.t + root_.radius < 1;
    if (const std::optional<RefinedRoot> found = inner ? settled() : settled_near_end()) return *found;
    // The root is several doubles away from the nearest, since it is small. A step from there is as good as its value
    // is exact.
    const double nearest = base_ + offset_.value;
    if (!(nearest > 0 && nearest < 1 && within_radius(nearest))) return {};
    if (look_from(nearest) == 0) return {Outcome::contact, nearest, nearest};
    return settled().value_or(RefinedRoot{});
  }

 private:
  /// `settled`, for a root that may lie outside [0, 1].
  std::optional<RefinedRoot> settled_near_end() {
    for (const double end : {0.0, 1.0}) {
      const numbers::DoubleDouble sum = numbers::two_sum(base_, offset_.value);
      const double beyond = (sum.high - end) + sum.low;  // sum.high - end is exact where it matters
      if (end == 0 ? beyond < -offset_.error : beyond > offset_.error) return RefinedRoot{Outcome::no_contact};
      if (std::fabs(beyond) > offset_.error) continue;
      if (!within_radius(end)) return RefinedRoot{};
      const int side = look_from(end);
      if (side == 0) return RefinedRoot{Outcome::contact, end, end};
      if (side == (end == 0 ? -1 : 1)) return RefinedRoot{Outcome::no_contact};
      break;  // the root lies inside, and far from the other end
    }
    return settled();
  }

  bool within_radius(double time) const { return std::fabs(time - root_.t) <= root_.radius; }

  /// On which side of `time` the root lies, exactly (1: after it). From now on the offset is counted from there.
  int look_from(double time) {
    const double value = value_at_(time);
    base_ = time;
    offset_ = offset_of(root_, time, value, exact_value_error(value));
    return value == 0 ? 0 : (value > 0) == (root_.slope > 0) ? -1 : 1;
  }

  /// The times of a root in (0, 1); nothing where the offset is not good enough to tell.
  std::optional<RefinedRoot> settled() {
    const auto [nearest, near, earlier, later] = nearest_double(base_, offset_);
    if (!near) return std::nullopt;
    int side = later ? 1 : earlier ? -1 : 0;
    if (side == 0) {
      if (!within_radius(nearest)) return std::nullopt;
      side = look_from(nearest);
    }
    const double toi = side < 0 ? before(nearest) : nearest;
    return RefinedRoot{Outcome::contact, toi, side == 0 ? nearest : after(toi)};  // nearest < 1 where side > 0
  }

  const SimpleRoot& root_;
  const ValueAt& value_at_;
  double base_;
  Offset offset_;
};

}  // namespace

RefinedRoot refine_root(const Question& question, const SimpleRoot& root) {
  const auto& [query, t_max, exact_value, wanted] = question;
  const auto& [u, w, r] = root.magnitudes;
  const bool no_components = root.inside && wanted != Wanted::all;
  const ContactValues at =
      no_components ? ContactValues{{}, coplanarity_value(query, root.t)} : contact_values(query, root.t, root.axis);
  const Offset offset = offset_of(root, root.t, at.coplanarity, kCoplanarityError * (u * w * r));
  const double spread = component_spread(offset);
  if (!root.inside) {
    const SidesAtRoot<double> sides = sides_at_root(query.kind, at, root.magnitudes, offset, spread);
    if (sides.outside) return {Outcome::no_contact};
    if (!sides.inside) return {Outcome::uncertain};
  }

  const auto value_at = [&question](double time) { return question.exact_value(question.query, time); };
  RefinedRoot refined = NeighbouringDoubles(root, offset, value_at).find();
  if (refined.finding != Outcome::contact) return refined;
  if (is_late(refined.toi, refined.toi_upper, t_max)) return {Outcome::no_contact};
  if (wanted != Wanted::all) return refined;
  const WeightsAtRoot<double> found = weights_at_root(query.kind, at, root.magnitudes, offset, spread);
  if (!found.certain) return {Outcome::uncertain};
  refined.weights = found.weights;
  return refined;
}

}  // namespace touchstone::filters
