// SPDX-License-Identifier: MIT
#include "numbers/library_versions.hpp"

#include <CGAL/version.h>
#include <gmp.h>
#include <mpfr.h>

#include <boost/version.hpp>

namespace touchstone::numbers {
namespace {

#define TOUCHSTONE_TEXT_OF(x) #x
#define TOUCHSTONE_TEXT(x) TOUCHSTONE_TEXT_OF(x)

std::string dotted(int major, int minor, int patch) {
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

}  // namespace

std::vector<LibraryVersion> library_versions() {
  const std::string cgal = TOUCHSTONE_TEXT(CGAL_VERSION);
  const std::string boost = dotted(BOOST_VERSION / 100'000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100);
  const std::string gmp = dotted(__GNU_MP_VERSION, __GNU_MP_VERSION_MINOR, __GNU_MP_VERSION_PATCHLEVEL);
  return {{"CGAL", cgal, cgal},
          {"Boost", boost, boost},
          {"GMP", gmp, gmp_version},
          {"MPFR", MPFR_VERSION_STRING, mpfr_get_version()}};
}

}  // namespace touchstone::numbers
