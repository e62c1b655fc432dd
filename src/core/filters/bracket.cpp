// SPDX-License-Identifier: MIT
#include "filters/bracket.hpp"

#include <optional>

#include "filters/bernstein_cubic.hpp"
#include "filters/root_sides.hpp"
#include "filters/step_frame.hpp"

namespace touchstone::filters {
namespace {

/// A question on its way through this level, with the values computed for it here.
struct BracketState {
  const Question& question;
  const StepFrame<double>& frame;
  const Magnitudes& magnitudes;
  const BernsteinCubic& cubic;
};

constexpr BracketFinding kNone = {Outcome::no_contact};

/// Decides at the one root between p and q. `no_contact` says that the elements do not touch there within [0, t_max].
/// Nothing where the root could not be told apart from others or from the ends of the range.
std::optional<BracketFinding> decide_at_root(const BracketState& s, double p, double q, Answer& answer) {
  const auto& [query, t_max, exact_value, wanted] = s.question;
  const BernsteinCubic::Root root = s.cubic.root_between(p, q);
  if (!root.certain) return std::nullopt;
  const RootTime<double> time = time_of<double>(root, t_max);
  if (time.outside) return kNone;
  const SideValues<double> values = side_values(query.kind, s.frame, s.magnitudes, root.t, root.radius);
  const Sides<double> sides = sides_of(query.kind, values);
  if (sides.outside) return kNone;
  if (sides.unknown) return BracketFinding{};
  if (wanted == Wanted::contact && sides.inside && time.inside) {
    answer.contact = true;
    return BracketFinding{Outcome::contact};
  }
  const Outcome finding = decide_refined(s.question,
                                         {root.t, root.radius, root.slope, s.cubic.slope_error(), s.cubic.curvature(),
                                          s.magnitudes, values.axis, sides.inside},
                                         answer);
  return BracketFinding{finding, finding == Outcome::uncertain};
}

/// Decides from the cubic's roots in [low, high], of which [0, 1] is a part. Nothing where roots could not be told
/// apart from each other or from the ends of the range.
std::optional<BracketFinding> decide_over(const BracketState& s, double low, double high, Answer& answer) {
  using Variations = BernsteinCubic::Variations;
  const Variations whole = s.cubic.variations(low, high);
  if (whole == Variations::none) return kNone;
  double split[4] = {low, high};
  const int segments = whole == Variations::one ? 1 : s.cubic.split_points(low, high, split);
  // A root that lies after t_max ends the loop, since its segment ends after it.
  for (int i = 0; i < segments && !(split[i] > s.question.t_max); ++i) {
    const Variations variations = segments == 1 ? whole : s.cubic.variations(split[i], split[i + 1]);
    if (variations == Variations::none) continue;
    if (variations == Variations::uncertain) return std::nullopt;
    const std::optional<BracketFinding> found = decide_at_root(s, split[i], split[i + 1], answer);
    if (!found || found->finding != Outcome::no_contact) return found;
  }
  return kNone;
}

}  // namespace

Outcome decide_refined(const Question& question, const SimpleRoot& root, Answer& answer) {
  const RefinedRoot refined = refine_root(question, root);
  if (refined.finding == Outcome::contact) write_contact(question.query.kind, refined, answer);
  return refined.finding;
}

void write_contact(Kind kind, const RefinedRoot& refined, Answer& answer) noexcept {
  answer.contact = true;
  answer.nature = Nature::crossing;
  answer.toi = refined.toi;
  answer.toi_upper = refined.toi_upper;
  if (kind == Kind::edge_edge) {
    answer.feature_a = Feature::a;
    answer.feature_b = Feature::b;
    answer.weights_a = {1 - refined.weights[0], refined.weights[0], 0};
    answer.weights_b = {1 - refined.weights[1], refined.weights[1], 0};
  } else {
    answer.feature_a = Feature::v;
    answer.feature_b = Feature::f;
    answer.weights_a = {1, 0, 0};
    answer.weights_b = refined.weights;
  }
}

BracketFinding decide_in_brackets(const Question& question, Answer& answer) {
  // The first test has computed these already. Keeping them would slow down the many queries that it settles.
  const StepFrame<double> frame = frame_of(question.query);
  const Magnitudes m = magnitudes_of(frame);
  if (!within_range(m)) return {};
  const BernsteinCubic cubic(coplanarity_coefficients(frame), m.u * m.w * m.r);
  if (cubic.is_zero()) return {};  // as in a plane that all corners share
  const BracketState search = {question, frame, m, cubic};
  std::optional<BracketFinding> found = decide_over(search, 0, 1, answer);
  if (!found) {
    // A root may lie at an end of the step, where no sign of V is certain. A little beyond the end it is.
    found = decide_over(search, -BernsteinCubic::kMargin, 1 + BernsteinCubic::kMargin, answer);
  }
  return found.value_or(BracketFinding{});
}

}  // namespace touchstone::filters
