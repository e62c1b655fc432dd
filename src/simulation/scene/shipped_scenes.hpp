// The scenes that come with the program, each made to a size.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace touchstone::sim {

struct ShippedScene {
  std::string_view name;
  std::string_view about;       ///< one line
  std::string_view size_means;  ///< "about how many edges"
  Index least, usual, most;     ///< sizes
  Scene (*make)(Index size);
};

const std::vector<ShippedScene>& shipped_scenes();
const ShippedScene* find_shipped_scene(std::string_view name);

/// @throws Error when there is no such scene or the size is out of its range
Scene make_shipped_scene(std::string_view name, std::optional<Index> size);

// One for each name. Each is the same, bit for bit, every time.
Scene make_two_edges(Index pairs);
Scene make_hoop(Index edges);
Scene make_hoop_rim(Index edges);
Scene make_cable_drop(Index segments);
Scene make_whip(Index segments);
Scene make_ring_twist(Index segments);
Scene make_chain(Index segments);
Scene make_flag(Index triangles);
Scene make_drape(Index triangles);
Scene make_twist(Index triangles);
Scene make_link_chain(Index links);
Scene make_stack(Index boxes);
Scene make_nut_and_bolt(Index around);

}  // namespace touchstone::sim
