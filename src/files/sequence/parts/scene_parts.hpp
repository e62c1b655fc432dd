// The parts of a scene of several files, from the arguments that a user gives: which files, how many frames.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sequence/frame_list.hpp"
#include "sequence/results.hpp"

namespace touchstone::sequence {

/// One part of a scene.
struct ScenePart {
  std::string name;               ///< no other part has it, also as results show it
  std::vector<FrameName> frames;  ///< one: the part is at rest in all frames of the scene

  bool is_at_rest() const noexcept { return frames.size() == 1; }
  const FrameName& at(std::size_t frame) const noexcept { return frames[is_at_rest() ? 0 : frame]; }
};

/// Each file is a part with the name of its file, also those of a folder or a pattern.
/// @throws FileError  as expand_patterns, and for a file that is given twice or holds several frames
std::vector<ScenePart> parts_at_rest(const std::vector<std::string>& arguments, const frames::ReadOptions& reading);

/// Each argument is a part. A folder or a pattern of several files gives its frames, in the order of in_order, and so
/// does a file that holds several. A part of several files has the text that starts their names as its name, without a
/// number at its end, or the name of its folder.
/// @throws FileError  for parts that move and have different numbers of frames, where no part moves, and as
///                    expand_patterns and in_order
std::vector<ScenePart> moving_parts(const std::vector<std::string>& arguments, const frames::ReadOptions& reading);

/// The frames of the scene. The label is that of the one part that moves; with several it is "frame 3", and without one
/// it has the names of all files.
std::vector<FrameName> frames_of(const std::vector<ScenePart>& parts);

/// Of parts of which some move.
SceneFacts facts_of(const std::vector<ScenePart>& parts);

}  // namespace touchstone::sequence
