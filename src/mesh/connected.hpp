// Sets of numbers that grow together.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include <touchstone/mesh.hpp>

namespace touchstone::mesh {

/// The numbers below a count, each in a set of its own at first. The least number of a set stands for it.
class ConnectedSets {
 public:
  explicit ConnectedSets(std::size_t count) : of_(count) { std::iota(of_.begin(), of_.end(), MeshIndex{0}); }

  MeshIndex find(MeshIndex n) noexcept {
    while (of_[n] != n) n = of_[n] = of_[of_[n]];
    return n;
  }

  void connect(MeshIndex a, MeshIndex b) noexcept {
    a = find(a), b = find(b);
    of_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<MeshIndex> of_;
};

}  // namespace touchstone::mesh
