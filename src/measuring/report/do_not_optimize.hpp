// Results that are computed for their run time only.
// SPDX-License-Identifier: MIT
#pragma once

namespace touchstone::report {

/// Tells the compiler that `value` is read here, so that it may not leave out the computation of it.
template <class Value>
void do_not_optimize(const Value& value) {
#if defined(__GNUC__)
  asm volatile("" : : "m"(value) : "memory");
#else
  static volatile const Value* read_later;
  read_later = &value;
#endif
}

}  // namespace touchstone::report
