// The frames of an animation, from the names that a user gives: patterns, order, gaps.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "frames/frame.hpp"

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

/// The files of the arguments. A folder is replaced by its files of one format, and an argument that is no file, and
/// has one of the characters * ? [, by the files that it matches.
/// @throws FileError  for a pattern that matches nothing, and a folder without mesh files or with those of several
///                    formats
std::vector<std::string> expand_patterns(const std::vector<std::string>& arguments);

/// Whether both name one file, by whatever spellings of its path. A link with a name of its own is another file: some
/// programs write a frame that holds still as a link to the one before it.
bool same_file(const std::string& a, const std::string& b);

/// @throws FileError  for a file that is given twice
void refuse_repeats(const std::vector<std::string>& files);

/// What a missing number means.
enum class Gaps : std::uint8_t { refused, allowed };

/// The files in the order of their numbers: cloth-2.obj comes before cloth-10.obj. Of several numbers, one counts that
/// no two files have, and one with a constant stride before others: f-2-t0.2.obj comes before f-10-t0.10.obj.
/// @throws FileError  for a file that is given twice, names that differ in more than numbers, or of which two such
///                    numbers give different orders; with Gaps::refused also for two files with the same number, and
///                    for a number that is missing from a sequence with a constant stride
std::vector<std::string> in_order(std::vector<std::string> files, Gaps gaps);

/// The files of the arguments in the order of the arguments. A pattern has no order of its own: its files are in the
/// order of their numbers where in_order would take them, else in that of their names.
/// @throws FileError  for a pattern that matches nothing
std::vector<std::string> as_given(const std::vector<std::string>& arguments);

/// Gives each label as many folders as tell the frames of different files apart.
void show_folders(std::vector<FrameName>& names);

/// Every frame of the files, one file after the other. @throws FileError
std::vector<FrameName> frames_of(const std::vector<std::string>& files, const frames::ReadOptions& options);

/// The digest of the labels of all frames, in their order.
std::string digest_of(const std::vector<std::string>& labels);

}  // namespace touchstone::sequence
