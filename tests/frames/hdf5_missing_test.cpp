// A build without libhdf5 says so, and what to install.
// SPDX-License-Identifier: MIT
#include <touchstone/error.hpp>

#include "frames/frame.hpp"
#include "io/temporary_folder.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace touchstone;

TEST_CASE("positions of an HDF5 file are exact") { tests::skip("this build has no libhdf5 (Debian: libhdf5-dev)"); }

TEST_CASE("without libhdf5 the error says what to install") {
  const tests::TemporaryFolder folder;
  for (const char* const name : {"a.h5", "a.hdf5"}) {
    const std::string file = folder.write(name, "");
    CHECK_THROWS_WITH(frames::read_frame(file, 0, {}), Catch::Contains("libhdf5-dev"));
    CHECK_THROWS_WITH(frames::frame_count(file, {}), Catch::Contains("libhdf5-dev"));
  }
}
