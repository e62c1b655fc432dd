// A build without expat says so, and what to install.
// SPDX-License-Identifier: MIT
#include <touchstone/error.hpp>

#include "frames/frame.hpp"
#include "io/temporary_folder.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace touchstone;

TEST_CASE("cells of a VTK XML file are those that the legacy format has") {
  tests::skip("this build has no expat (Debian: libexpat1-dev)");
}

TEST_CASE("without expat the error says what to install") {
  const tests::TemporaryFolder folder;
  for (const char* const name : {"a.vtu", "a.vtp"}) {
    const std::string file = folder.write(name, "");
    CHECK_THROWS_WITH(frames::read_frame(file, 0, {}), Catch::Contains("libexpat1-dev"));
  }
}
