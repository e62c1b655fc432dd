// SPDX-License-Identifier: MIT
#include "cli/shared/whole_file.hpp"

#include "cli/shared/progress/interrupt.hpp"
#include "io/whole_file.hpp"

namespace touchstone::cli {

std::string whole_file(const std::string& path) {
  return std::string(io::WholeFile::read(path, io::kJsonLimits, throw_if_interrupted).bytes());
}

}  // namespace touchstone::cli
