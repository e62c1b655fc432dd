// A decimal gives the nearest double. The C library's strtod decides, which rounds correctly and shares no code.
// SPDX-License-Identifier: MIT
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>

#include "frames/frame.hpp"
#include "frames/samples.hpp"
#include "io/temporary_folder.hpp"
#include "seeded/rng.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

/// A decimal of a random double with too few digits, too many, or beside the middle between two doubles.
std::string random_decimal(seeded::Rng& rng) {
  double x = 0;
  do {
    x = std::bit_cast<double>(rng.bits());
  } while (!std::isfinite(x) || std::abs(x) > 1e308 || (x != 0 && std::abs(x) < 1e-300));
  if (rng.one_in(2)) x = std::ldexp(rng.symmetric(), rng.between(-40, 40));
  char text[1200];
  const int digits = rng.between(0, 40);
  const char* const format = std::abs(x) < 1e20 && rng.one_in(3) ? "%.*f" : "%.*e";
  std::snprintf(text, sizeof text, format, digits, x);
  if (!rng.one_in(3)) return text;
  // The middle between x and the next double, exactly, and then a digit 1 or not.
  const long double middle = (static_cast<long double>(x) + std::nextafter(x, 1e308)) / 2;
  std::snprintf(text, sizeof text, "%.*Le", 800, middle);
  std::string exact = text;
  if (rng.one_in(2)) exact.insert(exact.find('e'), 1, '1');
  return exact;
}

}  // namespace

TEST_CASE("a decimal is read as the nearest double") {
  const TemporaryFolder folder;
  seeded::Rng rng(7);
  constexpr int kVertexCount = 20'000;
  std::string text;
  std::vector<double> expected;
  for (int i = 0; i < kVertexCount; ++i) {
    text += 'v';
    for (int k = 0; k < 3; ++k) {
      const std::string number = random_decimal(rng);
      expected.push_back(std::strtod(number.c_str(), nullptr));
      text += ' ';
      text += number;
    }
    text += '\n';
  }
  const frames::Frame frame = frames::read_frame(folder.write("a.obj", text), 0, {});
  REQUIRE(frame.positions.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (std::memcmp(&frame.positions[i], &expected[i], sizeof(double)) == 0) continue;
    CAPTURE(i, frame.positions[i], expected[i]);
    FAIL_CHECK("another double");
  }
}

TEST_CASE("numbers in other spellings are the same numbers") {
  const TemporaryFolder folder;
  const frames::Frame frame = frames::read_frame(
      folder.write("a.obj", "v +1.5 -.5 5.\nv 0x1.8p-2 -0x1p-1074 1E+2\nv 1e-0 0e99999 00012\n"), 0, {});
  CHECK(frame.positions == std::vector<double>{1.5, -0.5, 5, 0.375, -0x1p-1074, 100, 1, 0, 12});
}
