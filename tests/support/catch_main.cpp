// The main of every test program, for Catch2 2.x and 3.x.
// SPDX-License-Identifier: MIT
#define CATCH_CONFIG_RUNNER
#include "support/catch.hpp"
#include "support/skip.hpp"

int main(int count, char** arguments) {
  Catch::Session session;
#ifndef CATCH_VERSION_MAJOR
#error "the version of Catch2 is not known"
#elif CATCH_VERSION_MAJOR == 2
  // A name that matches no test fails, as in 3.x: CTest's list may have another name than the test case.
  session.configData().warnings = Catch::WarnAbout::NoTests;
#endif
  const int status = session.run(count, arguments);
  return status == 0 && touchstone::tests::has_skipped() ? touchstone::tests::kSkippedStatus : status;
}
