// The versions of the number libraries, for a person who asks how a program was built.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace touchstone::numbers {

struct LibraryVersion {
  std::string name;
  std::string compiled;  ///< of the headers that this build saw
  std::string running;   ///< of the library that this process has loaded or linked; of headers alone: the same
};

/// CGAL, Boost, GMP and MPFR.
std::vector<LibraryVersion> library_versions();

}  // namespace touchstone::numbers
