// Doubles say which features have the closest points, and prove it; double-doubles measure between them. Both carry
// their bounds along.
// SPDX-License-Identifier: MIT
#include "filters/separation/precise_distance.hpp"

#include <cmath>

#include "filters/separation/closest_feet.hpp"
#include "filters/separation/entry_walk.hpp"
#include "filters/separation/straight_differences.hpp"

namespace touchstone::filters {
namespace {

class Measurement {
 public:
  Measurement(const Query& query, double t, Metric metric) noexcept
      : is_euclidean_(metric == Metric::euclidean), closest_(query.kind, metric, 0) {
    const Step step(query);
    hint_ = closest_.hint_at(bare_iterate(step, t));
    is_certain_ = certainly_closest(closest_.feet(hint_, differences_near(step, t, 0), true));
    if (is_certain_) feet_ = closest_.feet(hint_, differences_at(PreciseStep(query), numbers::exact_pair(t)), true);
  }

  /// The sign of the distance minus the level; 0 when uncertain.
  int side_of(const BoundedPair& level) const noexcept {
    return is_certain_ ? closest_.excess_over(feet_, level).sign() : 0;
  }

  /// The double nearest to the distance, or 0.
  double nearest() const noexcept {
    // Beyond these sizes the halves of an ulp, or squares, are no doubles.
    constexpr double kLeast = 0x1p-400, kGreatest = 0x1p400;
    if (!is_certain_) return 0;
    const double power = feet_.gap.value.high / feet_.measure.value.high;
    double nearest = is_euclidean_ ? std::sqrt(power) : power;
    const double slope = (is_euclidean_ ? 2 * nearest : 1) * feet_.measure.value.high;
    nearest += closest_.excess_over(feet_, numbers::exact_pair(nearest)).value.high / slope;
    if (!(nearest >= kLeast && nearest <= kGreatest)) return 0;
    const double below = std::nextafter(nearest, 0.0), above = std::nextafter(nearest, 2 * kGreatest);
    const BoundedPair lower = {{nearest, -0.5 * (nearest - below)}, 0}, upper = {{nearest, 0.5 * (above - nearest)}, 0};
    return side_of(lower) > 0 && side_of(upper) < 0 ? nearest : 0;
  }

  bool name(Answer& answer) const noexcept { return closest_.name(hint_, feet_, answer); }

 private:
  bool is_euclidean_;
  ClosestFeet closest_;
  Hint hint_;
  bool is_certain_ = false;
  Feet<BoundedPair> feet_;
};

}  // namespace

std::optional<Distance> precise_distance(const Query& query, double t, Metric metric) noexcept {
  const Measurement measurement(query, t, metric);
  const double nearest = measurement.nearest();
  Answer where;
  if (nearest == 0 || !measurement.name(where)) return std::nullopt;
  return Distance{nearest, where.feature_a, where.feature_b, where.weights_a, where.weights_b};
}

int precise_side_of_distance(const Query& query, double t, const Separation& separation) noexcept {
  return Measurement(query, t, separation.metric).side_of(numbers::exact_pair(separation.distance));
}

}  // namespace touchstone::filters
