// The frames of a scene of several files.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "frames/frame.hpp"
#include "sequence/parts/scene_parts.hpp"
#include "sequence/repairs.hpp"

namespace touchstone::sequence {

/// Reads frames of a scene, one at a time: the meshes of its parts side by side. Vertices and faces keep the numbers of
/// their files. A part at rest is read once.
class SceneFrames {
 public:
  SceneFrames(std::vector<ScenePart> parts, const frames::ReadOptions& reading, const RepairOptions& repairs);

  /// @throws FileError  as read_frame, for faults of a part's mesh, one in the plane, a part whose elements differ from
  ///                    those of its frame that was read first, and more than 2^32 vertices or faces in all
  frames::Frame read(std::size_t index);

 private:
  struct Source {
    ScenePart part;
    Repairs repairs;
    frames::Frame frame;  ///< the one that was read last; without a topology before
    FrameName first;      ///< the name of the one that was read first
  };

  void read_part(Source& source, const FrameName& name);
  std::shared_ptr<const frames::Topology> topology() const;

  frames::ReadOptions reading_;
  std::vector<Source> sources_;
  std::shared_ptr<const frames::Topology> topology_;  ///< of the whole scene
};

}  // namespace touchstone::sequence
