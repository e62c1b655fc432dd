// SPDX-License-Identifier: MIT
#include "io/queries/kind_of_file.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
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

/// The public benchmark calls its files 227ee.csv and 227vf.csv.
std::optional<Kind> kind_of_name(const std::string& path) {
  const std::string stem = std::filesystem::path(path).stem().string();
  const std::size_t digits = std::min(stem.find_first_not_of("0123456789"), stem.size());
  const std::string_view ending = std::string_view(stem).substr(digits);
  if (digits > 0 && ending == "ee") return Kind::edge_edge;
  if (digits > 0 && ending == "vf") return Kind::vertex_face;
  return std::nullopt;
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

std::optional<Kind> kind_of_path(const std::string& path) {
  const auto kind = from_name<Kind>(folder_name(path));
  return kind ? kind : kind_of_name(path);
}

Kind kind_of_file(const std::string& path, std::optional<Kind> given) {
  if (given) return *given;
  if (const auto kind = kind_of_path(path)) return *kind;
  fail(path, "of which kind are its queries? Its folder " + in_quotes(folder_name(path)) + " is not called " +
                 kind_names() + ", its name is not like 227ee.csv or 227vf.csv, and no kind was given (--kind)");
}

}  // namespace touchstone::io
