// Whether two results of a mesh are the same, to the last bit.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include <touchstone/mesh.hpp>

namespace touchstone::tests {

inline std::uint64_t bits(double x) {
  std::uint64_t result;
  std::memcpy(&result, &x, sizeof x);
  return result;
}

inline bool same_bytes(const Answer& a, const Answer& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (bits(a.weights_a[k]) != bits(b.weights_a[k]) || bits(a.weights_b[k]) != bits(b.weights_b[k])) return false;
  }
  return a.contact == b.contact && a.level == b.level && a.nature == b.nature && a.feature_a == b.feature_a &&
         a.feature_b == b.feature_b && a.starts_within == b.starts_within && a.trend == b.trend &&
         bits(a.toi) == bits(b.toi) && bits(a.toi_upper) == bits(b.toi_upper);
}

inline bool same_bytes(const std::vector<MeshContact>& a, const std::vector<MeshContact>& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](const MeshContact& x, const MeshContact& y) {
           return x.pair == y.pair && x.separation.distance == y.separation.distance &&
                  x.separation.metric == y.separation.metric && same_bytes(x.answer, y.answer);
         });
}

inline bool same_bytes(const std::vector<Intersection>& a, const std::vector<Intersection>& b) {
  const auto same = [](const std::array<double, 3>& x, const std::array<double, 3>& y) {
    return bits(x[0]) == bits(y[0]) && bits(x[1]) == bits(y[1]) && bits(x[2]) == bits(y[2]);
  };
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [&](const auto& x, const auto& y) {
           return x.first_element == y.first_element && x.first == y.first && x.second_element == y.second_element &&
                  x.second == y.second && x.sort == y.sort && same(x.weights_first, y.weights_first) &&
                  same(x.weights_second, y.weights_second);
         });
}

inline bool same_bytes(const FirstContact& a, const FirstContact& b) {
  return a.contact == b.contact && a.toi == b.toi && a.toi_upper == b.toi_upper && same_bytes(a.earliest, b.earliest) &&
         same_bytes(a.at_start, b.at_start);
}

inline bool same_bytes(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return bits(x) == bits(y); });
}

inline bool same_bytes(const FreeStep& a, const FreeStep& b) {
  return a.outcome == b.outcome && bits(a.length) == bits(b.length) && a.proofs == b.proofs &&
         same_bytes(a.positions, b.positions) && same_bytes(a.first_contact, b.first_contact);
}

}  // namespace touchstone::tests
