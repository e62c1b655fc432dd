// How much of its thread's stack a call needs: it runs in a thread whose stack is painted before, and looked at after.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace touchstone::tests {

/// In bytes.
struct StackUse {
  std::size_t own = 0;  ///< by the call, without what GMP takes for numbers of many limbs
  std::size_t gmp = 0;  ///< the most that GMP takes below a call of the library's
};

/// A stack that threads run on, one after another.
class PaintedStack {
 public:
  PaintedStack();
  ~PaintedStack();
  PaintedStack(const PaintedStack&) = delete;
  PaintedStack& operator=(const PaintedStack&) = delete;

  /// The bytes of the stack that a call needs, beyond those of a thread that does nothing. An exception ends the test.
  StackUse use_of(const std::function<void()>& call);

 private:
  unsigned char* bottom_;
  std::size_t idle_ = 0;
};

/// Whether the program is linked so that calls of GMP go through tests/support/painted_stack.cpp: with the library in
/// it, and not beside it. GMP has its temporary numbers on the stack, up to 64 KB in each of its functions.
bool sees_calls_of_gmp();

}  // namespace touchstone::tests
