// The files of an animation in their order, from what a user names: patterns, folders, gaps.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace touchstone::sequence {

/// The files of the arguments. A folder is replaced by its files of one format, and an argument that is no file, and
/// has one of the characters * ? [, by the files that it matches.
/// @throws FileError  for a pattern that matches nothing, and a folder without mesh files or with those of several
///                    formats
std::vector<std::string> expand_patterns(const std::vector<std::string>& arguments);

/// @throws FileError  for a file that is given twice
void refuse_repeats(const std::vector<std::string>& files);

/// What a missing number means.
enum class Gaps : std::uint8_t { refused, allowed };

/// The files in the order of their numbers: cloth-2.obj comes before cloth-10.obj. Of several numbers, one counts that
/// no two files have, and one with a constant stride before others: f-2-t0.2.obj comes before f-10-t0.10.obj.
/// @param advice  ends the message about names and numbers
/// @throws FileError  for a file that is given twice, names that differ in more than numbers, or of which two such
///                    numbers give different orders; with Gaps::refused also for two files with the same number, and
///                    for a number that is missing from a sequence with a constant stride
std::vector<std::string> in_order(std::vector<std::string> files, Gaps gaps, std::string advice = {});

/// The files of the arguments in the order of the arguments. A pattern has no order of its own: its files are in the
/// order of their numbers where in_order would take them, else in that of their names.
/// @throws FileError  for a pattern that matches nothing
std::vector<std::string> as_given(const std::vector<std::string>& arguments);

}  // namespace touchstone::sequence
