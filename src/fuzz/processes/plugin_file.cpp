// SPDX-License-Identifier: MIT
#include "fuzz/processes/plugin_file.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

#include "io/fail.hpp"

namespace touchstone::fuzz {

std::string plugin_file(const std::string& path) {
  std::error_code error;
  const std::string absolute = std::filesystem::absolute(path, error).string();
  const std::string file = error ? path : absolute;
  if (!std::filesystem::exists(file, error)) io::fail(path, "there is no such plugin");
  if (std::filesystem::is_directory(file, error)) io::fail(path, "is a folder, not a plugin");
  return file;
}

void* load_plugin_function(const std::string& path, const char* name, void*& library, std::string& fault) {
  library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* const reason = ::dlerror();
    fault = reason == nullptr ? "it cannot be loaded" : reason;
    return nullptr;
  }
  void* const function = ::dlsym(library, name);
  if (function == nullptr) fault = std::string("it has no function ") + name + " (see touchstone/plugin.h)";
  return function;
}

}  // namespace touchstone::fuzz
