// SPDX-License-Identifier: MIT
#include "sequence/element_faults.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "io/fail.hpp"

namespace touchstone::sequence {
namespace {

using frames::Topology;

/// The name of element i in messages.
std::string element_name(const Topology& topology, const std::array<MeshIndex, 3>&, std::size_t i) {
  return std::string("face ") + std::to_string(topology.number_of_face(i));
}
std::string element_name(const Topology& topology, const std::array<MeshIndex, 2>& corners, std::size_t) {
  return std::string("edge ") + corners_text(topology, corners);
}

template <std::size_t N>
void refuse_faults(const Topology& topology, const std::vector<std::array<MeshIndex, N>>& elements,
                   const std::string& file) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto& corners = elements[i];
    for (std::size_t k = 0; k < N; ++k) {
      const auto names = [&] {
        return element_name(topology, corners, i) + " names vertex " +
               std::to_string(topology.number_of_vertex(corners[k]));
      };
      if (corners[k] >= topology.vertex_count) {
        io::fail(file, names() + ", and there are only " + std::to_string(topology.vertex_count));
      }
      const auto before = corners.begin() + static_cast<std::ptrdiff_t>(k);
      if (std::find(corners.begin(), before, corners[k]) == before) continue;
      io::fail(file, names() + " twice; its corners must be " + std::to_string(N) +
                         " different vertices (mesh --drop-degenerate leaves such elements out)");
    }
  }
  std::vector<std::pair<std::array<MeshIndex, N>, std::size_t>> sorted;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    sorted.emplace_back(elements[i], i);
    std::sort(sorted.back().first.begin(), sorted.back().first.end());
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first != sorted[i - 1].first) continue;
    const std::size_t one = sorted[i - 1].second, two = sorted[i].second;
    io::fail(file, element_name(topology, elements[two], two) + " has the same corners as " +
                       element_name(topology, elements[one], one) + ", vertices " +
                       corners_text(topology, sorted[i].first) + "; each " + (N == 3 ? "face" : "edge") +
                       " may be given once (mesh --drop-degenerate leaves the others out)");
  }
}

}  // namespace

void check_elements(const Topology& topology, const std::string& file) {
  refuse_faults(topology, topology.faces, file);
  refuse_faults(topology, topology.edges, file);
}

}  // namespace touchstone::sequence
