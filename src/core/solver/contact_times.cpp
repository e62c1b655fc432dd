// SPDX-License-Identifier: MIT
#include <touchstone/contact_times.hpp>

#include <utility>

#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>

#include "exact/exact_times.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "numbers/integers/common_denominator.hpp"
#include "solver/validate.hpp"

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

struct ExactTime::Impl {
  numbers::RealRoot root;
};

namespace {

std::vector<ContactInterval> with_exact_times(std::vector<exact::RootInterval> intervals) {
  const auto time = [](numbers::RealRoot& root) {
    return ExactTime(std::make_shared<const ExactTime::Impl>(ExactTime::Impl{std::move(root)}));
  };
  std::vector<ContactInterval> times;
  times.reserve(intervals.size());
  for (exact::RootInterval& interval : intervals) times.push_back({time(interval.first), time(interval.last)});
  return times;
}

template <class AnyQuery>
std::vector<ContactInterval> times_of_any(const AnyQuery& query, const Separation& separation, double t_max) {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate(separation);
  solver::validate(query, t_max);
  return with_exact_times(separation.distance == 0 ? exact::touching_times(query, t_max)
                                                   : exact::touching_times(query, t_max, separation));
}

}  // namespace

ExactTime::ExactTime(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

double ExactTime::lower() const noexcept { return impl_->root.lower(); }
double ExactTime::upper() const noexcept { return impl_->root.upper(); }

int ExactTime::compare(const ExactTime& other) const {
  const numbers::DefaultFloatEnvironment environment;
  // Copies, because comparing changes a root's cached bracket, and other threads may hold these times too.
  const numbers::RealRoot mine = impl_->root;
  const numbers::RealRoot theirs = other.impl_->root;
  return mine.compare(theirs);
}

int ExactTime::compare(double time) const {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate_finite_time(time);
  return impl_->root.compare(numbers::Exact(time));
}

int ExactTime::compare(const Fraction& time) const {
  const numbers::DefaultFloatEnvironment environment;
  solver::validate_fraction(time);
  const auto integers = numbers::over_common_denominator({{time.numerator, time.denominator}, {"1", "1"}});
  const numbers::Exact& numerator = integers[0];
  const numbers::Exact& denominator = integers[1];  // positive
  if (numbers::sign_of(numerator) < 0) return 1;
  if (numbers::sign_of(numerator - denominator) > 0) return -1;
  const numbers::RealRoot mine = impl_->root;  // a copy: roots keep their narrowed brackets
  return mine.compare(numbers::RealRoot::rational(numerator, denominator, 1));
}

ExactTime ExactTime::reversed() const {
  const numbers::DefaultFloatEnvironment environment;
  return ExactTime(std::make_shared<const Impl>(Impl{impl_->root.reversed()}));
}

std::string ExactTime::to_string() const {
  const numbers::DefaultFloatEnvironment environment;
  return impl_->root.to_string();
}

std::vector<ContactInterval> contact_times(const Query& query, const Separation& separation, double t_max) {
  return times_of_any(query, separation, t_max);
}

std::vector<ContactInterval> contact_times(const RationalQuery& query, const Separation& separation, double t_max) {
  return times_of_any(query, separation, t_max);
}

std::vector<ContactInterval> contact_times(const CurvedQuery& query, const Separation& separation, double t_max) {
  return times_of_any(query, separation, t_max);
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
