// SPDX-License-Identifier: MIT
#include "report/pictures/front.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::report {
namespace {

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? ", " : " and ";
    text += names[i];
  }
  return text;
}

/// The median of the magnitudes; 0 without a time to compare.
double ulps_off(const Result& result) {
  return result.time_error ? static_cast<double>(result.time_error->median_size) : 0;
}

std::string described(const Result& result) {
  const std::string wrong =
      result.wrong() == 0 ? "never wrong" : fmt::format("{:.3g} % wrong", 100 * result.wrong_fraction());
  return fmt::format("`{}` ({}, times {:.3g} ulps off in the median, {:.3g} us)", result.contestant.label(), wrong,
                     ulps_off(result), result.mean);
}

/// How many queries those were asked that were asked the most.
std::size_t whole_set(const std::vector<Result>& results) {
  std::size_t most = 1;
  for (const Result& result : results) most = std::max(most, result.asked);
  return most;
}

}  // namespace

bool dominates(const Result& a, const Result& b) noexcept {
  if (a.asked == 0 || a.asked != b.asked) return false;
  const bool no_worse = a.wrong_fraction() <= b.wrong_fraction() && ulps_off(a) <= ulps_off(b) && a.mean <= b.mean;
  return no_worse && (a.wrong_fraction() < b.wrong_fraction() || ulps_off(a) < ulps_off(b) || a.mean < b.mean);
}

std::vector<const Result*> front(const std::vector<Result>& results) {
  std::vector<const Result*> best;
  const std::size_t whole = whole_set(results);
  for (const Result& result : results) {
    const auto beats = [&](const Result& other) { return other.contestant.competes() && dominates(other, result); };
    const bool competes = result.asked == whole && result.contestant.competes();
    if (competes && std::none_of(results.begin(), results.end(), beats)) best.push_back(&result);
  }
  std::sort(best.begin(), best.end(), [](const Result* a, const Result* b) { return a->mean < b->mean; });
  return best;
}

std::string front_sentence(const std::vector<Result>& results) {
  std::vector<std::string> names;
  for (const Result* result : front(results)) names.push_back(described(*result));
  std::vector<std::string> aside, subset;
  for (const Result& result : results) {
    if (result.asked == 0) continue;
    if (!result.contestant.competes()) aside.push_back(fmt::format("`{}`", result.contestant.label()));
    if (result.asked < whole_set(results)) subset.push_back(fmt::format("`{}`", result.contestant.label()));
  }
  std::string text =
      fmt::format("On the front (no other{} is as seldom wrong, as close in time and as fast): {}. ",
                  aside.empty() ? "" : " but " + listed(aside) + ", which shares our filters,", listed(names));
  if (!subset.empty()) text += fmt::format("Asked a part, and so not placed: {}. ", listed(subset));

  const auto own = std::find_if(results.begin(), results.end(),
                                [](const Result& result) { return result.contestant.is_touchstone(); });
  if (own == results.end() || own->asked == 0) return text;
  std::vector<std::string> faster, beaten_by;
  for (const Result& result : results) {
    if (result.contestant.competes() && dominates(result, *own)) beaten_by.push_back(described(result));
    if (result.asked > 0 && result.has_errors() && result.mean < own->mean) {
      faster.push_back(fmt::format("`{}`", result.contestant.label()));
    }
  }
  if (!beaten_by.empty()) return text + fmt::format("`touchstone` is dominated by {}.", listed(beaten_by));
  if (faster.empty()) return text + "`touchstone` is faster than every method that has errors.";
  return text + fmt::format("Faster than `touchstone`, with errors: {}.", listed(faster));
}

}  // namespace touchstone::report
