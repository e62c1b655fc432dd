// The common part of `closed_form` and `newton`: candidate times are roots of polynomials, and each is tested
// at its time.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "baselines/baseline.hpp"
#include "baselines/polynomial.hpp"

namespace touchstone::baselines {

/// Candidate times, in no order.
class Times {
 public:
  void add(double t) {
    if (count_ < times_.size()) times_[count_++] = t;
  }
  double* begin() { return times_.data(); }
  double* end() { return times_.data() + count_; }

 private:
  // Four pairs of corner and edge, three polynomials each (or six linear ones), nine times each at most, and t = 0.
  std::array<double, 4 * 3 * 9 + 1> times_;
  std::size_t count_ = 0;
};

/// Adds the roots of p in [0, t_max], double roots included, each within `tolerance`; nothing when p is rounding noise.
using RootFinder = void (*)(const Cubic& p, double t_max, double tolerance, Times& times);

/// The first candidate time at which the elements touch within `slack`: a fraction of the element for weights, and of
/// the frame's largest component for distances.
Result first_touch(const Query& query, double t_max, RootFinder roots, double tolerance, double slack);

}  // namespace touchstone::baselines
