// The frames of an animation.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "frames/frame.hpp"
#include "sequence/frame_name.hpp"
#include "sequence/frame_order.hpp"

namespace touchstone::sequence {

/// Gives each label as many folders as tell the frames of different files apart.
void show_folders(std::vector<FrameName>& names);

/// Every frame of the files, one file after the other. @throws FileError
std::vector<FrameName> frames_of(const std::vector<std::string>& files, const frames::ReadOptions& options);

/// The digest of the labels of all frames, in their order.
std::string digest_of(const std::vector<std::string>& labels);

}  // namespace touchstone::sequence
