// The floating-point environment that every proof of the library assumes: round to nearest, subnormals kept, exceptions
// masked. A caller's program may have another: -ffast-math start-up code sets flush-to-zero, interval arithmetic leaves
// a rounding mode behind, feenableexcept unmasks traps.
//
// An x86 processor has two floating-point units, with an environment each: SSE, which computes the doubles, with MXCSR;
// and x87, which compilers use for long double and for some constants, and which traps by its own masks.
// SPDX-License-Identifier: MIT
#pragma once

#include <cfenv>
#include <cfloat>
#include <limits>

#if defined(__GNUC__) && (defined(__x86_64__) || (defined(__i386__) && defined(__SSE2_MATH__)))
#define TOUCHSTONE_X86_ENVIRONMENT 1
#include <xmmintrin.h>
#endif

namespace touchstone::numbers {

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53,
              "doubles must be IEEE 754's binary64");
static_assert(FLT_EVAL_METHOD == 0,
              "an operation must round to double, not to the x87's longer type: use -mfpmath=sse");

/// Sets the default environment, whatever it is now.
inline void set_default_float_environment() noexcept {
  std::fesetenv(FE_DFL_ENV);
#ifdef TOUCHSTONE_X86_ENVIRONMENT
  constexpr unsigned kDefaultMxcsr = 0x1F80;  // see below
  _mm_setcsr(kDefaultMxcsr);
#elif defined(__aarch64__)
  __asm__ volatile("msr fpcr, %0" : : "r"(0ul));  // glibc keeps bits that it does not name
#endif
}

/// Sets the default environment for its lifetime. It restores the caller's at the end, with its status flags, where
/// that was another one. Code that relies on it must sit behind a call that the compiler does not inline, and read its
/// operands from memory, so that no operation moves across the change (see `solver`).
class DefaultFloatEnvironment {
 public:
#ifdef TOUCHSTONE_X86_ENVIRONMENT
  // Both units' controls are read on every call, and written only where one differs: the default environment costs a
  // few cycles.
  DefaultFloatEnvironment() noexcept : mxcsr_(_mm_getcsr()) {
    unsigned short control;
    __asm__ volatile("fnstcw %0" : "=m"(control));
    changed_ = (((mxcsr_ ^ kDefaultMxcsr) & kMxcsrControls) | ((control ^ kDefaultX87) & kX87Controls)) != 0;
    if (!changed_) return;
    // x87's status flags are cleared too: a raised flag whose exception is unmasked traps at the next x87 instruction.
    __asm__ volatile("fnstenv %0\n\tfnclex\n\tfldcw %1" : "=m"(x87_) : "m"(kDefaultX87));
    _mm_setcsr(kDefaultMxcsr);
  }
  ~DefaultFloatEnvironment() {
    if (!changed_) return;
    __asm__ volatile("fldenv %0" : : "m"(x87_));
    _mm_setcsr(mxcsr_);
  }

 private:
  // MXCSR: bits 15 flush-to-zero, 14-13 rounding, 12-7 exception masks, 6 denormals-are-zero, 5-0 status flags.
  static constexpr unsigned kMxcsrControls = 0xFFC0;
  static constexpr unsigned kDefaultMxcsr = 0x1F80;
  // x87's control word: bits 11-10 rounding, 9-8 precision, 5-0 exception masks. Bit 6 is always set.
  static constexpr unsigned kX87Controls = 0x0F3F;
  static constexpr unsigned short kDefaultX87 = 0x037F;
  struct X87Environment {
    unsigned words[7];
  };
  unsigned mxcsr_;
  bool changed_;
  X87Environment x87_;
#elif defined(__aarch64__)
  DefaultFloatEnvironment() noexcept : control_(0), status_(0) {
    __asm__ volatile("mrs %0, fpcr" : "=r"(control_));
    if (control_ == kDefaultControl) return;
    __asm__ volatile("mrs %0, fpsr" : "=r"(status_));
    __asm__ volatile("msr fpcr, %0" : : "r"(kDefaultControl));
  }
  ~DefaultFloatEnvironment() {
    if (control_ == kDefaultControl) return;
    __asm__ volatile("msr fpcr, %0" : : "r"(control_));
    __asm__ volatile("msr fpsr, %0" : : "r"(status_));
  }

 private:
  // FPCR: bits 24 flush-to-zero, 23-22 rounding, 15 and 12-8 traps, 0 flush inputs; all of them are 0 by default. FPSR
  // has the status flags.
  static constexpr unsigned long kDefaultControl = 0;
  unsigned long control_;
  unsigned long status_;
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
