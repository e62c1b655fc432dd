// SPDX-License-Identifier: MIT
#include "solver/cascade.hpp"

#include <limits>

#include "exact/exact.hpp"
#include "filters/bracket.hpp"
#include "filters/filters.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "oracle/oracle.hpp"
#include "solver/ladder.hpp"
#include "solver/validate.hpp"

namespace touchstone::solver {
namespace {

/// The arithmetic without error below the filters and the bracket level.
struct ExactArithmetic {
  filters::ExactValue coplanarity_at;
  Answer (*decide)(const Query& query, double t_max, Wanted wanted, exact::Rung* decided);
};

Answer decide_by_oracle(const Query& query, double t_max, Wanted, exact::Rung*) {
  return oracle::decide_by_oracle(query, t_max);
}

/// Contact at exactly t = 0 is a fact that no level below needs.
void complete(Answer& answer) noexcept { answer.starts_within = answer.contact && answer.toi_upper == 0; }

constexpr ExactArithmetic kOwn = {exact::coplanarity_at, exact::decide};
constexpr ExactArithmetic kCgal = {oracle::coplanarity_at, decide_by_oracle};

}  // namespace

void trim(Answer& answer, Wanted wanted) noexcept {
  if (!answer.contact || wanted == Wanted::all) return;
  answer.weights_a = answer.weights_b = {};
  if (wanted == Wanted::features) return;
  answer.nature = Nature::none;
  answer.trend = Trend::none;
  answer.feature_a = answer.feature_b = Feature::none;
  if (wanted == Wanted::time) return;
  answer.toi = answer.toi_upper = std::numeric_limits<double>::quiet_NaN();
  answer.starts_within = false;
}

namespace {

// The rungs of kLadder are the filters' tests, then those of the exact level.
constexpr std::size_t kFirstExactRung = 1 + static_cast<std::size_t>(filters::Test::rescaled);
static_assert(kFirstExactRung + exact::kRungs == kLadder.size());

/// What follows the first test, by a method with filters. `rung`, if not null, becomes the number of the one that
/// decides.
inline void answer_after_same_side(const Query& query, Method method, double t_max, Wanted wanted, Answer& result,
                                   std::size_t* rung = nullptr) {
  validate(query, t_max);
  const ExactArithmetic& below = method == Method::fast ? kOwn : kCgal;
  const filters::Decision decision = filters::decide_by_filters({query, t_max, below.coplanarity_at, wanted}, result);
  if (decision.finding == filters::Outcome::uncertain) {
    exact::Rung decided{};
    result = below.decide(query, t_max, wanted, rung != nullptr ? &decided : nullptr);
    if (rung != nullptr) *rung = kFirstExactRung + static_cast<std::size_t>(decided);
  } else if (rung != nullptr) {
    *rung = static_cast<std::size_t>(decision.test);
  }
  complete(result);
  trim(result, wanted);
}

}  // namespace

Answer answer(const Query& query, Method method, double t_max, Wanted wanted) {
  Answer result;  // the one object that is returned everywhere, so that none is copied
  if (method != Method::fast && method != Method::fast_cgal) {
    validate_method(method);
    validate(query, t_max);
    result = method == Method::oracle ? oracle::decide_by_oracle(query, t_max) : exact::decide_exactly(query, t_max);
    complete(result);
    trim(result, wanted);
    return result;
  }
  result.level = Level::filter;
  // The first test also proves that the query is valid. So most queries are read only once.
  if (is_time(t_max) && filters::same_side(query)) return result;
  answer_after_same_side(query, method, t_max, wanted, result);
  return result;
}

namespace {

TOUCHSTONE_BEHIND_GUARD RungAnswer rung_answer(const Query& query, double t_max) {
  RungAnswer result;
  result.answer.level = Level::filter;
  if (is_time(t_max) && filters::same_side(query)) return result;
  answer_after_same_side(query, Method::fast, t_max, Wanted::all, result.answer, &result.rung);
  return result;
}

}  // namespace

RungAnswer answer_and_rung(const Query& query, double t_max) {
  const numbers::DefaultFloatEnvironment environment;
  return rung_answer(query, t_max);
}

Answer answer_after_same_side(const Query& query, Method method, double t_max, Wanted wanted) {
  Answer result;
  result.level = Level::filter;
  answer_after_same_side(query, method, t_max, wanted, result);
  return result;
}

Answer answer_at_root(const Query& query, const filters::SimpleRoot& root, bool inside_step, Method method,
                      double t_max, Wanted wanted) {
  Answer result;
  result.level = Level::bracket;
  if (wanted == Wanted::contact && root.inside && inside_step) {
    result.contact = true;
  } else {
    const ExactArithmetic& below = method == Method::fast ? kOwn : kCgal;
    const filters::Outcome finding =
        filters::decide_refined({query, t_max, below.coplanarity_at, wanted}, root, result);
    if (finding == filters::Outcome::uncertain) return answer_after_same_side(query, method, t_max, wanted);
  }
  complete(result);
  trim(result, wanted);
  return result;
}

Answer answer_at_refined_root(Kind kind, const filters::RefinedRoot& root, Wanted wanted) {
  Answer result;
  result.level = Level::bracket;
  if (root.finding == filters::Outcome::no_contact) return result;
  filters::write_contact(kind, root, result);
  complete(result);
  trim(result, wanted);
  return result;
}

Answer answer(const Query& query, const Separation& separation, Method method, double t_max, Wanted wanted) {
  if (separation.distance == 0) return answer(query, method, t_max, wanted);
  Answer result;
  if (method == Method::fast || method == Method::fast_cgal) {
    result.level = Level::filter;
    if (is_time(t_max) && filters::clear_all_along(query, separation)) return result;
    validate(query, t_max);
    if (filters::decide_by_filters(query, separation, t_max, result) != filters::Outcome::uncertain) {
      trim(result, wanted);
      return result;
    }
    if (wanted == Wanted::contact) {  // elements that touch are within every separation
      const Answer touching = answer(query, method, t_max, wanted);
      if (touching.contact) return touching;
    }
  } else {
    validate_method(method);
    validate(query, t_max);
  }
  const bool by_cgal = method == Method::oracle || method == Method::fast_cgal;
  result =
      by_cgal ? oracle::decide_by_oracle(query, t_max, separation) : exact::decide_exactly(query, t_max, separation);
  trim(result, wanted);
  return result;
}

}  // namespace touchstone::solver
