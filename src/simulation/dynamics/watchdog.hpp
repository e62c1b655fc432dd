// Where a line search creeps: a few whole steps of Newton's method although the potential rises.
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "rods/system.hpp"

namespace touchstone::sim {

/// Stiff elements resist a straight step as much as it turns them on the way, so that a line search takes tiny steps
/// only (Maratos 1978). The watchdog of Chamberlain et al. (1982) lets the potential rise for a few whole steps, and
/// comes back to where it left when the potential has not come down below its target by then.
///
/// While it is out, the stretch elements are out of shape. The second derivatives then take the tension that each is
/// meant to have by the last step, not the tension that it has: Newton's method with the tensions as variables.
template <class Iterate>
class Watchdog {
 public:
  bool is_out() const noexcept { return steps_left_ > 0; }

  /// Whether it may go out in this iteration, counted from 1, in which a whole step does not decrease the potential.
  bool may_go_out(int iteration) const noexcept { return iteration > kPatience && wait_ == 0; }

  /// @param target  J: the potential that it must come down to
  void go_out(const Iterate& from, double target) {
    steps_left_ = kMostSteps;
    target_ = target;
    from_ = from;
  }

  double target() const noexcept { return target_; }

  /// N, of each stretch element; null when it is not out.
  const VectorX* tensions() const noexcept { return is_out() ? &tensions_ : nullptr; }
  void set_tensions(VectorX tensions) { tensions_ = std::move(tensions); }

  /// Whether another step may follow one that missed the target. @param finite  whether the potential is, after it
  bool may_go_on(bool finite) noexcept { return --steps_left_ > 0 && finite; }

  /// It has come down to its target.
  void succeed() noexcept {
    steps_left_ = 0;
    pause_ = 1;
  }

  /// It has not. Each failure in a row doubles the pause before the next time. @returns where it went out
  Iterate come_back() {
    steps_left_ = 0;
    wait_ = pause_;
    pause_ *= 2;
    return std::move(from_);
  }

  /// An iteration by the line search goes by.
  void rest() noexcept {
    if (wait_ > 0) --wait_;
  }

 private:
  static constexpr int kPatience = 15;  // iterations before the first time: most searches have converged by then
  static constexpr int kMostSteps = 4;  // each time

  int steps_left_ = 0;
  int wait_ = 0, pause_ = 1;  // iterations: before the next time, and after the next failure
  double target_ = 0;         // J
  VectorX tensions_;
  Iterate from_;
};

}  // namespace touchstone::sim
