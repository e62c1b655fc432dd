// A run that its user ends: the check that long loops make, from the conjugate gradients here to the steps of sim.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <utility>

namespace touchstone::linear {

/// Long loops call `check` in each round. It may throw, and so ends all of them.
class Cancellation {
 public:
  Cancellation() = default;
  Cancellation(std::function<void()> check) : check_(std::move(check)) {}  // implicit: a function is one

  void check() const {
    if (check_) check_();
  }

  /// Never throws.
  static const Cancellation& never() {
    static const Cancellation none;
    return none;
  }

 private:
  std::function<void()> check_;
};

}  // namespace touchstone::linear
