// Where one frame of an animation is, and what it is called.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace touchstone::sequence {

/// Where one frame is.
struct FrameName {
  std::string file;           ///< as it was given
  std::size_t index = 0;      ///< which frame of the file
  bool several = false;       ///< whether the file holds several frames
  std::size_t folders = 0;    ///< how many of its folders the label has
  std::string shown_as = {};  ///< the label; empty: that of the file

  /// The frame in a report and in messages: the file's name, with folders where several files have one name, and "[7]"
  /// when the file holds several frames. It is one line of valid UTF-8, whatever the file is called.
  std::string label() const;
};

/// A path whose folder has one spelling.
std::filesystem::path with_one_spelling(const std::string& file);

/// Whether both name one file, by whatever spellings of its path. A link with a name of its own is another file: some
/// programs write a frame that holds still as a link to the one before it.
bool same_file(const std::string& a, const std::string& b);

}  // namespace touchstone::sequence
