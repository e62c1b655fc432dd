// The floating-point environment that every proof of the library assumes: round to nearest, subnormals kept,
// exceptions masked. A caller's program may have another: -ffast-math start-up code sets flush-to-zero, interval
// arithmetic leaves a rounding mode behind, feenableexcept unmasks traps.
// SPDX-License-Identifier: MIT
#pragma once

#include <cfenv>

#if defined(__x86_64__) || defined(__i386__)
#include <xmmintrin.h>
#endif

namespace touchstone::numbers {

/// Sets the default environment, whatever it is now.
inline void set_default_float_environment() noexcept {
  std::fesetenv(FE_DFL_ENV);
#if defined(__x86_64__) || (defined(__i386__) && defined(__SSE2_MATH__))
  constexpr unsigned kDefaultControl = 0x1F80;  // see below
  _mm_setcsr(kDefaultControl);
#endif
}

/// Sets the default environment for its lifetime and restores the caller's, status flags included where it changed
/// anything. Code that relies on it must sit behind a call that the compiler does not inline and read its operands
/// from memory, so that no operation moves across the change (see `solver`).
class DefaultFloatEnvironment {
 public:
#if defined(__x86_64__) || (defined(__i386__) && defined(__SSE2_MATH__))
  DefaultFloatEnvironment() noexcept : saved_(_mm_getcsr()), changed_((saved_ & kControlBits) != kDefaultControl) {
    if (changed_) _mm_setcsr(kDefaultControl);
  }
  ~DefaultFloatEnvironment() {
    if (changed_) _mm_setcsr(saved_);
  }

 private:
  // MXCSR: bits 15 flush-to-zero, 14-13 rounding, 12-7 exception masks, 6 denormals-are-zero, 5-0 status flags.
  static constexpr unsigned kControlBits = 0xFFC0;
  static constexpr unsigned kDefaultControl = 0x1F80;
  unsigned saved_;
  bool changed_;
#else
  DefaultFloatEnvironment() noexcept {
    std::fegetenv(&saved_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultFloatEnvironment() { std::fesetenv(&saved_); }

 private:
  std::fenv_t saved_;
#endif

 public:
  DefaultFloatEnvironment(const DefaultFloatEnvironment&) = delete;
  DefaultFloatEnvironment& operator=(const DefaultFloatEnvironment&) = delete;
};

}  // namespace touchstone::numbers
