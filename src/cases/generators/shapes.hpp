// The connectivity of sheets, spheres and chains: corners, edges and faces.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <touchstone/query.hpp>

namespace touchstone::generators {

using Index = std::uint32_t;

/// Edges and faces name their corners by number. A face's three edges are among the edges, each edge once.
struct Mesh {
  std::size_t corner_count = 0;
  std::vector<std::array<Index, 2>> edges;
  std::vector<std::array<Index, 3>> faces;

  /// An object of the scene. Its corners, edges and faces come before those of the next one.
  struct Object {
    std::string name;
    std::size_t first_face = 0;
  };
  std::vector<Object> objects;

  /// Adds another mesh as an object of this name. Its corners come after those that are there.
  void append(const Mesh& other, const std::string& name);
};

/// A square sheet of n x n squares, each cut along one diagonal, alternately. Corner (i, j), 0 <= i, j <= n, has
/// number i (n + 1) + j.
Mesh sheet_mesh(std::size_t n);

/// A chain of n edges; corner i, 0 <= i <= n, has number i.
Mesh chain_mesh(std::size_t n);

/// A box of 12 triangles. Corner i has its greater x, y and z where bit 0, 1 and 2 of i is set.
Mesh box_mesh();

/// An octahedron whose faces are cut into n^2 triangles each: 12 n^2 edges, 8 n^2 faces.
struct Sphere {
  Mesh mesh;
  std::vector<Vec3> directions;  ///< of the corners, of length 1 up to rounding
};
Sphere sphere_mesh(std::size_t n);

}  // namespace touchstone::generators
