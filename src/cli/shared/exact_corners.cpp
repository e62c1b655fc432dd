// SPDX-License-Identifier: MIT
#include "cli/shared/exact_corners.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <utility>

#include "io/times.hpp"

namespace touchstone::cli {

std::string exact_corner(std::string_view name, const Vec3& x) {
  return fmt::format("{}: {} {} {}\n", name, io::hexfloat(x.x), io::hexfloat(x.y), io::hexfloat(x.z));
}

std::string exact_corners(const Query& query) {
  std::string text;
  for (const auto& [when, corners] : {std::pair{"start", &query.start}, std::pair{"end", &query.end}}) {
    for (std::size_t c = 0; c < corner_count(query.kind); ++c) {
      text += exact_corner(fmt::format("{} {}", when, corner_name(query.kind, c)), (*corners)[c]);
    }
  }
  return text;
}

}  // namespace touchstone::cli
