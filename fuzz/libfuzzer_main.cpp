// libFuzzer's entry: one target, TOUCHSTONE_FUZZ_TARGET, per program.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static constexpr const auto* kTarget = touchstone::fuzzing::find_target(TOUCHSTONE_FUZZ_TARGET);
  static_assert(kTarget != nullptr);
  try {
    kTarget->run({data, size});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "FINDING: %s\n", error.what());
    std::abort();
  }
  return 0;
}
