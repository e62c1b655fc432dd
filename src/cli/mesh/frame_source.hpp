// The frames that `touchstone mesh` asks about: which files they are, and how they are read.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/mesh/mesh.hpp"
#include "frames/frame.hpp"
#include "sequence/frame_list.hpp"
#include "sequence/parts/scene_frames.hpp"
#include "sequence/repairs.hpp"

namespace touchstone::cli {

/// Whether the frames may be different meshes.
bool may_differ(const MeshRunOptions& options);

class FrameSource {
 public:
  /// @throws Error  for files that are no frames of one sequence, and no parts of one scene
  explicit FrameSource(const MeshRunOptions& options);

  const std::vector<sequence::FrameName>& names() const noexcept { return names_; }

  /// Where each part has frames of its own.
  std::optional<sequence::SceneFacts> scene() const;

  /// All files that are read.
  std::vector<std::string> files() const;

  /// One call at a time. The frame that is read first says which vertices are welded. @throws FileError
  std::shared_ptr<const frames::Frame> read(std::size_t index);

  /// The file that the elements of a frame come from, for messages.
  const std::string& elements_file(std::size_t index) const;

 private:
  const MeshRunOptions& options_;
  frames::ReadOptions reading_;
  std::vector<sequence::ScenePart> parts_;  ///< empty: each file is a frame
  std::vector<sequence::FrameName> names_;
  sequence::Repairs repairs_;
  sequence::SceneFrames scene_;                 ///< of the parts
  std::shared_ptr<const frames::Frame> first_;  ///< the one that was read first, of files that are frames
};

}  // namespace touchstone::cli
