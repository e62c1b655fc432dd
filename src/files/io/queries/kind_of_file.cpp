// SPDX-License-Identifier: MIT
#include "io/queries/kind_of_file.hpp"

#include <filesystem>
#include <system_error>

#include "io/fail.hpp"

namespace touchstone::io {
namespace {

std::string folder_name(const std::string& path) {
  std::error_code ignored;  // without a working folder the path is taken as it is
  std::filesystem::path whole = std::filesystem::absolute(path, ignored);
  if (ignored) whole = path;
  return whole.lexically_normal().parent_path().filename().string();
}

}  // namespace

std::string kind_names() {
  std::string names;
  for (const Kind kind : kKinds) {
    if (!names.empty()) names += kind == kKinds.back() ? " or " : ", ";
    names += name_of(kind);
  }
  return names;
}

std::optional<Kind> kind_of_folder(const std::string& path) { return from_name<Kind>(folder_name(path)); }

Kind kind_of_file(const std::string& path, std::optional<Kind> given) {
  if (given) return *given;
  if (const auto kind = kind_of_folder(path)) return *kind;
  fail(path, "of which kind are its queries? Its folder " + in_quotes(folder_name(path)) + " is not called " +
                 kind_names() + ", and no kind was given (--kind)");
}

}  // namespace touchstone::io
