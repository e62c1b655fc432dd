// Floating-point environments that callers leave behind, to set and to read back.
// SPDX-License-Identifier: MIT
#pragma once

#include <cfenv>
#include <string>
#include <vector>

#if defined(__x86_64__)
#include <xmmintrin.h>
#define TOUCHSTONE_X86 1
#else
#define TOUCHSTONE_X86 0
#endif

namespace touchstone::tests {

struct FloatMode {
  int rounding = FE_TONEAREST;
  bool flush = false;      ///< flush-to-zero and denormals-are-zero (x86 only)
  bool traps = false;      ///< every floating-point exception unmasked (glibc only)
  int x87_bits = 64;       ///< of x87's significands: 24, 53 or 64 (x86 only)
  bool x87_traps = false;  ///< every exception of x87 unmasked, whatever those of SSE are (x86 only)
  std::string name() const;
};

inline std::string FloatMode::name() const {
  std::string text = rounding == FE_UPWARD       ? "upward"
                     : rounding == FE_DOWNWARD   ? "downward"
                     : rounding == FE_TOWARDZERO ? "toward zero"
                                                 : "to nearest";
  if (flush) text += ", flush-to-zero and denormals-are-zero";
  if (traps) text += ", exceptions unmasked";
  if (x87_bits != 64) text += ", x87 at " + std::to_string(x87_bits) + " bits";
  if (x87_traps) text += ", x87's exceptions unmasked";
  return text;
}

/// What a caller can see of the environment: control bits, without the status flags.
struct ControlBits {
  unsigned mxcsr = 0;
  unsigned short x87 = 0;
  int rounding = 0;
  friend bool operator==(const ControlBits& a, const ControlBits& b) {
    return a.mxcsr == b.mxcsr && a.x87 == b.x87 && a.rounding == b.rounding;
  }
};

inline ControlBits control_bits() {
  ControlBits bits;
#if TOUCHSTONE_X86
  bits.mxcsr = _mm_getcsr() & ~0x3Fu;
  __asm__ volatile("fnstcw %0" : "=m"(bits.x87));
#endif
  bits.rounding = std::fegetround();
  return bits;
}

/// Sets a mode for its lifetime. Nothing but calls of the library should happen meanwhile.
class WithFloatMode {
 public:
  explicit WithFloatMode(const FloatMode& mode) {
    std::fegetenv(&saved_);
    std::feclearexcept(FE_ALL_EXCEPT);
    std::fesetround(mode.rounding);
#if TOUCHSTONE_X86
    unsigned short control = 0;
    __asm__ volatile("fnstcw %0" : "=m"(control));
    const unsigned precision = mode.x87_bits == 24 ? 0u : mode.x87_bits == 53 ? 0x200u : 0x300u;
    control = static_cast<unsigned short>((control & ~0x300u) | precision);
    if (mode.x87_traps) control = static_cast<unsigned short>(control & ~0x3Fu);
    __asm__ volatile("fldcw %0" : : "m"(control));
    _mm_setcsr((_mm_getcsr() & ~0x8040u) | (mode.flush ? 0x8040u : 0u));
#endif
#if defined(__GLIBC__)
    if (mode.traps) feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW | FE_UNDERFLOW | FE_INEXACT);
#endif
  }
  ~WithFloatMode() { std::fesetenv(&saved_); }
  WithFloatMode(const WithFloatMode&) = delete;
  WithFloatMode& operator=(const WithFloatMode&) = delete;

 private:
  std::fenv_t saved_;
};

/// Every rounding mode, with and without flushing, with and without traps; and x87 with fewer bits, or with traps where
/// SSE has none.
inline std::vector<FloatMode> float_modes() {
  std::vector<FloatMode> modes;
  for (const int rounding : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    for (const bool flush : {false, true}) {
      for (const bool traps : {false, true}) modes.push_back({rounding, flush, traps});
    }
  }
  modes.push_back({FE_TONEAREST, false, false, 24});
  modes.push_back({FE_TONEAREST, false, false, 53});
  modes.push_back({FE_UPWARD, true, true, 24});
  modes.push_back({FE_TONEAREST, false, false, 64, true});
  modes.push_back({FE_DOWNWARD, true, false, 53, true});
  return modes;
}

}  // namespace touchstone::tests
