// SPDX-License-Identifier: MIT
#include "sequence/frame_list.hpp"

#include <algorithm>
#include <map>

#include "frames/content.hpp"
#include "io/sha256.hpp"

namespace touchstone::sequence {
namespace {

/// Whether frames of two files have one label.
bool has_repeated_label(const std::vector<FrameName>& names) {
  std::map<std::string, std::string> files;  // by label
  return std::any_of(names.begin(), names.end(), [&](const FrameName& name) {
    const auto [known, is_new] = files.emplace(name.label(), name.file);
    return !is_new && !same_file(known->second, name.file);
  });
}

}  // namespace

void show_folders(std::vector<FrameName>& names) {
  constexpr std::size_t kMostFolders = 8;
  for (std::size_t folders = 1; folders <= kMostFolders && has_repeated_label(names); ++folders) {
    for (FrameName& name : names) name.folders = folders;
  }
}

std::vector<FrameName> frames_of(const std::vector<std::string>& files, const frames::ReadOptions& options) {
  std::vector<FrameName> all;
  for (const auto& file : files) {
    const std::size_t count = frames::frame_count(file, options);
    for (std::size_t i = 0; i < count; ++i) all.push_back({file, i, count > 1});
  }
  show_folders(all);
  return all;
}

std::string digest_of(const std::vector<std::string>& labels) {
  std::string lines;
  for (const auto& label : labels) lines.append(label).append("\n");
  return io::sha256(lines);
}

}  // namespace touchstone::sequence
