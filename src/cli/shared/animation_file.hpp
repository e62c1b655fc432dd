// The file of an animation: a page, or a moving picture alone.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "io/output_file.hpp"
#include "view/pages/animation_page.hpp"

namespace touchstone::cli {

/// Writes a moving picture where the file's name ends in .svg, else the page. The command is that of
/// this run. @returns its bytes
std::uint64_t write_animation(const view::Animation& animation, view::AnimationWords words, io::OutputFile& file);

/// A line for a person, after the file is written.
std::string animation_summary(const std::string& file, std::uint64_t bytes);

}  // namespace touchstone::cli
