// The main of every test program, for Catch2 2.x and 3.x.
// SPDX-License-Identifier: MIT
#define CATCH_CONFIG_RUNNER
#include "support/catch.hpp"
#include "support/skip.hpp"

int main(int count, char** arguments) {
  const int status = Catch::Session().run(count, arguments);
  return status == 0 && touchstone::tests::has_skipped() ? touchstone::tests::kSkippedStatus : status;
}
