// Faults of meshes that are mended on request, and counted: vertices at one position, and faces that are none.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frames/frame.hpp"
#include "sequence/frame_name.hpp"

namespace touchstone::sequence {

/// What is mended.
struct RepairOptions {
  bool weld = false;         ///< elements name the first of a part's vertices at one position in place of the others
  bool is_one_part = false;  ///< the mesh is one part, whatever objects it has
  bool drop_degenerate = false;  ///< what names a vertex twice, or the vertices of an element before it, is left out

  bool empty() const noexcept { return !weld && !drop_degenerate; }
};

/// Mends the frames of one mesh, one after the other. Vertices and faces keep their numbers. The first frame says which
/// vertices are welded.
class Repairs {
 public:
  /// @param each_by_itself  whether each frame is a mesh by itself
  Repairs(const RepairOptions& options, bool each_by_itself) : options_(options), each_by_itself_(each_by_itself) {}

  /// @param name  the frame's, for messages
  /// @throws FileError  for vertices that are welded, and apart in this frame
  void mend(frames::Frame& frame, const FrameName& name);

  /// Of a frame whose topology was mended: whether vertices that are welded are at one position. @throws FileError
  void check_welds(const frames::Frame& frame, const FrameName& name) const;

 private:
  void begin_with(const frames::Frame& frame, const FrameName& name);

  RepairOptions options_;
  bool each_by_itself_;
  std::shared_ptr<const frames::Topology> before_, after_;  ///< of the first frame
  std::string first_;                                       ///< its label
  std::vector<MeshIndex> standing_for_;  ///< for each vertex, the one that elements name; empty: itself
};

}  // namespace touchstone::sequence
