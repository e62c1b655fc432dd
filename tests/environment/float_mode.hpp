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

#if TOUCHSTONE_X86
inline constexpr bool kCanFlush = true;
inline constexpr unsigned long kFlushBits = 0x8040;  ///< MXCSR: flush-to-zero, denormals-are-zero
inline constexpr unsigned long kStatusBits = 0x3F;
inline unsigned long control_register() { return _mm_getcsr(); }
inline void set_control_register(unsigned long bits) { _mm_setcsr(static_cast<unsigned>(bits)); }
#elif defined(__aarch64__)
inline constexpr bool kCanFlush = true;
inline constexpr unsigned long kFlushBits = 1ul << 24;  ///< FPCR.FZ
inline constexpr unsigned long kStatusBits = 0;         ///< they are in FPSR
inline unsigned long control_register() {
  unsigned long bits = 0;
  __asm__ volatile("mrs %0, fpcr" : "=r"(bits));
  return bits;
}
inline void set_control_register(unsigned long bits) { __asm__ volatile("msr fpcr, %0" : : "r"(bits)); }
#else
inline constexpr bool kCanFlush = false;
inline constexpr unsigned long kFlushBits = 0;
inline constexpr unsigned long kStatusBits = 0;
inline unsigned long control_register() { return 0; }
inline void set_control_register(unsigned long) {}
#endif

struct FloatMode {
  int rounding = FE_TONEAREST;
  bool flush = false;      ///< subnormals are flushed to zero (where kCanFlush)
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
  if (flush) text += ", subnormals flushed";
  if (traps) text += ", exceptions unmasked";
  if (x87_bits != 64) text += ", x87 at " + std::to_string(x87_bits) + " bits";
  if (x87_traps) text += ", x87's exceptions unmasked";
  return text;
}

/// The part of the environment that a caller can see: control bits, without the status flags.
struct ControlBits {
  unsigned long control = 0;  ///< of the vector unit: MXCSR or FPCR
  unsigned short x87 = 0;
  int rounding = 0;
  friend bool operator==(const ControlBits& a, const ControlBits& b) {
    return a.control == b.control && a.x87 == b.x87 && a.rounding == b.rounding;
  }
};

inline ControlBits control_bits() {
  ControlBits bits;
  bits.control = control_register() & ~kStatusBits;
#if TOUCHSTONE_X86
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
#endif
    set_control_register((control_register() & ~kFlushBits) | (mode.flush ? kFlushBits : 0));
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
