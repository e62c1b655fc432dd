// How this program was built, for a person.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace touchstone::cli {

/// A component that a build has or has not, depending on what CMake found.
struct BuildComponent {
  std::string name;     ///< "HDF5 files"
  bool there;           ///< in this build
  std::string details;  ///< the library and its version, or what is left out without it
  std::string package;  ///< Debian's name of the package that a build with this component needs
};

/// The optional components of a build. The commands print them as "Optional parts".
std::vector<BuildComponent> build_components();

/// "AVX2 (256 bits)", the SIMD width that batches use on this processor; "none" on others.
std::string vectors_in_use();

/// A line for each: its name, whether it is there, the details, and what to install.
std::string text_of(const std::vector<BuildComponent>& components);

/// Version, compiler, flags, libraries with their versions, and SIMD width, a line each.
std::string build_facts();

}  // namespace touchstone::cli
