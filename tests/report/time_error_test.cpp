// Time errors in ulps: their sign, and medians.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "report/time_error.hpp"
#include "support/catch.hpp"

using namespace touchstone::report;

TEST_CASE("signed ulps count the doubles in between") {
  CHECK(signed_ulps(0.5, 0.5) == 0);
  CHECK(signed_ulps(std::nextafter(0.5, 1.0), 0.5) == 1);
  CHECK(signed_ulps(std::nextafter(0.5, 0.0), 0.5) == -1);
  CHECK(signed_ulps(-0.0, 0.0) == 0);
  CHECK(signed_ulps(0x1p-1074, 0.0) == 1);
  CHECK(signed_ulps(-0x1p-1074, 0x1p-1074) == -2);
  CHECK(signed_ulps(1.0, 0.5) == std::int64_t{1} << 52);
  CHECK(signed_ulps(0.0, 1.0) == -0x3FF0000000000000);
}

TEST_CASE("time errors are summed up by their extremes and lower medians") {
  CHECK_FALSE(time_error({}));
  const auto error = time_error({3, -10, 0, -2});
  REQUIRE(error);
  CHECK(error->claims == 4);
  CHECK(error->earliest == -10);
  CHECK(error->median == -2);
  CHECK(error->latest == 3);
  CHECK(error->median_size == 2);
  CHECK(error->greatest_size == 10);
}
