// SPDX-License-Identifier: MIT
#include "io/sealed_json.hpp"

#include <algorithm>

#include "io/sha256.hpp"

namespace touchstone::io {
namespace {

std::string first_line(std::string_view rest) {
  return std::string("{\"sha256\": \"").append(sha256(rest)).append("\",\n");
}

}  // namespace

std::string sealed_json(std::string_view object) {
  const std::string_view rest = object.substr(std::min(object.find('{') + 1, object.size()));
  return first_line(rest).append(rest);
}

bool seal_holds(std::string_view text) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) return false;
  return text.substr(0, end + 1) == first_line(text.substr(end + 1));
}

}  // namespace touchstone::io
