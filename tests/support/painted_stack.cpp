// SPDX-License-Identifier: MIT
#include "support/painted_stack.hpp"

#include <gmp.h>
#include <pthread.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <stdexcept>

namespace touchstone::tests {
namespace {

constexpr std::size_t kSize = std::size_t{1} << 20;
constexpr unsigned char kPaint = 0xA5;
constexpr std::uint64_t kPaintedWord = 0xA5A5A5A5A5A5A5A5u;

thread_local std::size_t gmp_use = 0;
thread_local bool on_painted_stack = false;
bool called = false;  // the program's threads run one after another

/// What was written to the stack below the caller since it was painted. It is painted again.
[[gnu::noinline]] std::size_t use_below() {
  constexpr std::uintptr_t kOwn = 1024;                 // more than this function's frame
  constexpr std::size_t kLongestGap = (160 << 10) / 8;  // words: GMP's numbers have less than 64 KB each
  const auto here = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0)) / 4096 * 4096 - kOwn;
  auto* const end = reinterpret_cast<volatile std::uint64_t*>(here);
  auto* deepest = end;
  for (auto* word = end - 1; deepest - word < static_cast<std::ptrdiff_t>(kLongestGap); --word) {
    if (*word == kPaintedWord) continue;
    *word = kPaintedWord;
    deepest = word;
  }
  return static_cast<std::size_t>(end - deepest) * sizeof *deepest;
}

/// A call of GMP with operands of so many limbs.
class GmpCall {
 public:
  explicit GmpCall(std::size_t limbs) : long_(limbs > kShort) { called = true; }
  ~GmpCall() {
    if (long_ && on_painted_stack) gmp_use = std::max(gmp_use, use_below());
  }
  GmpCall(const GmpCall&) = delete;
  GmpCall& operator=(const GmpCall&) = delete;

 private:
  static constexpr std::size_t kShort = 1024;  // for these, what GMP takes is counted as the call's own
  bool long_;
};

struct Run {
  const std::function<void()>& call;
  std::exception_ptr error;
  std::size_t gmp = 0;
};

void* run(void* argument) {
  Run& run = *static_cast<Run*>(argument);
  on_painted_stack = true;
  try {
    run.call();
  } catch (...) {
    run.error = std::current_exception();
  }
  run.gmp = gmp_use;
  return nullptr;
}

}  // namespace

PaintedStack::PaintedStack() {
  void* const memory = mmap(nullptr, kSize, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::runtime_error("no memory for a stack");
  bottom_ = static_cast<unsigned char*>(memory);
  std::fill_n(bottom_, kSize, kPaint);
  use_of([] {});  // the first thread may look for the functions that it calls
  idle_ = use_of([] {}).own;
}

PaintedStack::~PaintedStack() { munmap(bottom_, kSize); }

StackUse PaintedStack::use_of(const std::function<void()>& call) {
  Run what = {call, nullptr, 0};
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_t thread;
  const bool started =
      pthread_attr_setstack(&attributes, bottom_, kSize) == 0 && pthread_create(&thread, &attributes, run, &what) == 0;
  pthread_attr_destroy(&attributes);
  if (!started) throw std::runtime_error("no thread on a stack of its own");
  pthread_join(thread, nullptr);
  if (what.error) std::rethrow_exception(what.error);
  auto* const end = reinterpret_cast<std::uint64_t*>(bottom_ + kSize);
  auto* const deepest = std::find_if(reinterpret_cast<std::uint64_t*>(bottom_), end,
                                     [](std::uint64_t word) { return word != kPaintedWord; });
  std::fill(deepest, end, kPaintedWord);
  const std::size_t all = static_cast<std::size_t>(end - deepest) * sizeof *end;
  return {all - std::min(all, idle_), what.gmp};  // the end of a thread may need more than the call
}

bool sees_calls_of_gmp() { return called; }

}  // namespace touchstone::tests

// The linker's option --wrap sends calls of GMP's functions here (tests/solver/CMakeLists.txt).
extern "C" {
using touchstone::tests::GmpCall;

#define TOUCHSTONE_WRAPPED_MPZ(function)                                      \
  void __real___gmpz_##function(mpz_ptr result, mpz_srcptr a, mpz_srcptr b);  \
  void __wrap___gmpz_##function(mpz_ptr result, mpz_srcptr a, mpz_srcptr b) { \
    const GmpCall call(mpz_size(a) + mpz_size(b));                            \
    __real___gmpz_##function(result, a, b);                                   \
  }
TOUCHSTONE_WRAPPED_MPZ(gcd)
TOUCHSTONE_WRAPPED_MPZ(mul)
TOUCHSTONE_WRAPPED_MPZ(divexact)
TOUCHSTONE_WRAPPED_MPZ(tdiv_q)
TOUCHSTONE_WRAPPED_MPZ(tdiv_r)
TOUCHSTONE_WRAPPED_MPZ(lcm)

mp_limb_t __real___gmpn_mul(mp_ptr result, mp_srcptr a, mp_size_t size_a, mp_srcptr b, mp_size_t size_b);
mp_limb_t __wrap___gmpn_mul(mp_ptr result, mp_srcptr a, mp_size_t size_a, mp_srcptr b, mp_size_t size_b) {
  const GmpCall call(static_cast<std::size_t>(size_a + size_b));
  return __real___gmpn_mul(result, a, size_a, b, size_b);
}
}
