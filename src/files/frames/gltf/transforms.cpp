// SPDX-License-Identifier: MIT
#include "frames/gltf/transforms.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace touchstone::frames {

using json::JsonNode;

namespace {

std::vector<double> numbers(const JsonNode& node, std::size_t count) {
  std::vector<double> values;
  for (const JsonNode& item : node.items()) values.push_back(item.number());
  if (values.size() != count) node.fail("must have " + std::to_string(count) + " numbers");
  return values;
}

}  // namespace

Affine product(const Affine& a, const Affine& b) noexcept {
  if (a.is_identity) return b;
  if (b.is_identity) return a;
  Affine c;
  c.is_identity = false;
  c.p = a(b.p);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      c.m[i][k] = a.m[i][0] * b.m[0][k] + a.m[i][1] * b.m[1][k] + a.m[i][2] * b.m[2][k];
    }
  }
  return c;
}

Affine transform_of(const JsonNode& node) {
  Affine local;
  if (const auto matrix = node.find("matrix")) {
    const std::vector<double> x = numbers(*matrix, 16);  // column by column
    if (x[3] != 0 || x[7] != 0 || x[11] != 0 || x[15] != 1) matrix->fail("must have the last row 0 0 0 1");
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) local.m[i][k] = x[4 * k + i];
      local.p[i] = x[12 + i];
    }
    local.is_identity = false;
    return local;
  }
  if (const auto rotation = node.find("rotation")) {
    const std::vector<double> q = numbers(*rotation, 4);
    const double x = q[0], y = q[1], z = q[2], w = q[3], s = x * x + y * y + z * z + w * w;
    if (!(s > 0) || !std::isfinite(s)) rotation->fail("is no quaternion of a rotation");
    local.m = {{{1 - 2 * (y * y + z * z) / s, 2 * (x * y - z * w) / s, 2 * (x * z + y * w) / s},
                {2 * (x * y + z * w) / s, 1 - 2 * (x * x + z * z) / s, 2 * (y * z - x * w) / s},
                {2 * (x * z - y * w) / s, 2 * (y * z + x * w) / s, 1 - 2 * (x * x + y * y) / s}}};
    local.is_identity = false;
  }
  if (const auto scale = node.find("scale")) {
    const auto factors = scale->three_numbers();
    for (auto& row : local.m) {
      for (std::size_t k = 0; k < 3; ++k) row[k] *= factors[k];
    }
    local.is_identity = false;
  }
  if (const auto translation = node.find("translation")) {
    local.p = translation->three_numbers();
    local.is_identity = false;
  }
  return local;
}

}  // namespace touchstone::frames
