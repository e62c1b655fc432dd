// A file that is read as a whole, and messages about its content.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <touchstone/error.hpp>

#include "io/fail.hpp"

namespace touchstone::cli {

/// All bytes of a file within io::kJsonLimits. @throws FileError; and Interrupted
std::string whole_file(const std::string& path);

/// The result of `make`. Errors of `make` name the file `path`, which its result is made from. @throws FileError
template <class Make>
auto naming_file(const std::string& path, Make make) {
  try {
    return make();
  } catch (const Error& error) {
    io::fail(path, error.what());
  }
}

}  // namespace touchstone::cli
