// SPDX-License-Identifier: MIT
#include "solver/survivors.hpp"

#include "solver/cascade.hpp"

namespace touchstone::solver {

Survivors::Survivors(const QueryColumns& queries, const filters::Columns& columns, const BatchOptions& options,
                     Answer* answers) noexcept
    : queries_(queries),
      columns_(columns),
      options_(options),
      kernel_(filters::bracket_kernel(queries.kind, options.vectors)),
      refine_(filters::refine_kernel(queries.kind, options.vectors)),
      answers_(answers) {}

void Survivors::add(std::size_t i) {
  if (kernel_ == nullptr) {
    answer_one(i);
    return;
  }
  waiting_[count_++] = i;
  if (count_ == filters::kMostBracketed) answer_waiting();
}

void Survivors::answer_waiting() {
  if (count_ == 0) return;
  kernel_(columns_, waiting_, count_, options_.t_max, roots_);
  for (std::size_t k = 0; k < count_; ++k) {
    const std::size_t i = waiting_[k];
    const std::int64_t facts = roots_.facts[k];
    constexpr std::int64_t kCertain = filters::kOneRoot | filters::kInsideElements | filters::kInsideStep;
    if (facts == 0) {
      answer_one(i);
    } else if (facts == kCertain && options_.wanted == Wanted::contact) {
      answers_[i] = answer_at_refined_root(queries_.kind, {filters::Outcome::contact}, Wanted::contact);
    } else if ((facts & filters::kOneRoot) != 0) {
      hits_.which[hits_.count++] = k;
    } else {
      answers_[i] = Answer();
      answers_[i].level = facts == filters::kBoxesDisjoint ? Level::filter : Level::bracket;
    }
  }
  answer_hits();
  count_ = 0;
}

void Survivors::answer_hits() {
  const bool with_weights = options_.wanted == Wanted::all;
  refine_(columns_, hits_, options_.t_max, with_weights, refined_);
  for (std::size_t h = 0; h < hits_.count; ++h) {
    const std::size_t k = hits_.which[h];
    const std::size_t i = waiting_[k];
    const filters::RefinedRoot refined = refined_.root(h, with_weights);
    answers_[i] = refined.finding != filters::Outcome::uncertain
                      ? answer_at_refined_root(queries_.kind, refined, options_.wanted)
                      : answer_at_root(queries_[i], roots_.root(k), (roots_.facts[k] & filters::kInsideStep) != 0,
                                       options_.method, options_.t_max, options_.wanted);
  }
  hits_.count = 0;
}

void Survivors::answer_one(std::size_t i) {
  answers_[i] = answer_after_same_side(queries_[i], options_.method, options_.t_max, options_.wanted);
}

}  // namespace touchstone::solver
