// The transforms of glTF's nodes.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "json/json_node.hpp"

namespace touchstone::frames {

/// x -> m x + p.
struct Affine {
  std::array<std::array<double, 3>, 3> m = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::array<double, 3> p = {0, 0, 0};
  bool is_identity = true;

  std::array<double, 3> operator()(const std::array<double, 3>& x) const noexcept {
    if (is_identity) return x;
    std::array<double, 3> y = p;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) y[i] += m[i][k] * x[k];
    }
    return y;
  }

  bool mirrors() const noexcept {
    const auto minor = [&](std::size_t a, std::size_t b) { return m[1][a] * m[2][b] - m[1][b] * m[2][a]; };
    return m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1) < 0;
  }
};

/// First b, then a.
Affine product(const Affine& a, const Affine& b) noexcept;

/// The transform of a node in its parent.
Affine transform_of(const json::JsonNode& node);

}  // namespace touchstone::frames
