// SPDX-License-Identifier: MIT
#include "numbers/integers/library_versions.hpp"

#include <gmp.h>

#ifdef TOUCHSTONE_WITH_CGAL
#include <CGAL/version.h>
#include <mpfr.h>

#include <boost/version.hpp>
#endif

namespace touchstone::numbers {
namespace {

#define TOUCHSTONE_TEXT_OF(x) #x
#define TOUCHSTONE_TEXT(x) TOUCHSTONE_TEXT_OF(x)

std::string dotted(int major, int minor, int patch) {
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

}  // namespace

std::vector<LibraryVersion> library_versions() {
  std::vector<LibraryVersion> versions;
  const std::string gmp = dotted(__GNU_MP_VERSION, __GNU_MP_VERSION_MINOR, __GNU_MP_VERSION_PATCHLEVEL);
#ifdef TOUCHSTONE_WITH_CGAL
  const std::string cgal = TOUCHSTONE_TEXT(CGAL_VERSION);
  const std::string boost = dotted(BOOST_VERSION / 100'000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100);
  versions = {{"CGAL", cgal, cgal}, {"Boost", boost, boost}};
#endif
  versions.push_back({"GMP", gmp, gmp_version});
#ifdef TOUCHSTONE_WITH_CGAL
  versions.push_back({"MPFR", MPFR_VERSION_STRING, mpfr_get_version()});
#endif
  return versions;
}

}  // namespace touchstone::numbers
