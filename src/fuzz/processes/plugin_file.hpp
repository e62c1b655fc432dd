// The file of a shared library under test.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace touchstone::fuzz {

/// Its absolute path: dlopen looks elsewhere for a name without a slash. @throws FileError  where no file can be
std::string plugin_file(const std::string& path);

/// Loads a library, in a child process, and looks up a function. @param library  receives its handle
/// @return null with a reason in `fault` where there is none
void* load_plugin_function(const std::string& path, const char* name, void*& library, std::string& fault);

}  // namespace touchstone::fuzz
