// SPDX-License-Identifier: MIT
#include "sequence/parts/scene_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>

#include <touchstone/error.hpp>

#include "io/counted.hpp"
#include "io/fail.hpp"
#include "sequence/element_names.hpp"

namespace touchstone::sequence {
namespace {

namespace fs = std::filesystem;

std::string stem_of(const std::string& file) { return fs::path(file).stem().string(); }

bool has_repeats(const std::vector<std::string>& names) {
  std::set<std::string> known;
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return !known.insert(shown_part(name)).second; });
}

/// The names, or the whole arguments where two names are one, or these with their places in the command where two of
/// them look alike in results, which cut long names.
std::vector<std::string> different_names(std::vector<std::string> names, const std::vector<std::string>& arguments) {
  if (has_repeats(names)) names = arguments;
  if (!has_repeats(names)) return names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = fmt::format("{}: {}", i + 1, names[i]);
  return names;
}

/// "lid" of lid-0001.obj and lid-0002.obj; empty if the names have no such text.
std::string common_name(const std::vector<std::string>& files) {
  std::string common = stem_of(files.front());
  for (const std::string& file : files) {
    const std::string other = stem_of(file);
    const auto [end, ignored] = std::mismatch(common.begin(), common.end(), other.begin(), other.end());
    common.erase(end, common.end());
  }
  for (const std::string_view ends : {"0123456789", "-_. "}) {
    common.erase(common.find_last_not_of(ends) + 1);
  }
  return common;
}

/// The name of a part of several files.
std::string name_of_frames(const std::string& argument, const std::vector<std::string>& files) {
  std::error_code ignored;
  const bool is_folder = fs::is_directory(argument, ignored);
  fs::path folder = is_folder ? fs::path(argument) : fs::path(argument).parent_path();
  if (!folder.has_filename()) folder = folder.parent_path();
  std::string of_folder = folder.filename().string();
  if (of_folder == "." || of_folder == "..") of_folder.clear();
  std::string of_files = common_name(files);
  if (is_folder) std::swap(of_files, of_folder);
  if (!of_files.empty()) return of_files;
  return of_folder.empty() ? argument : of_folder;
}

/// How many parts at rest have names that differ from another one's in numbers only.
std::size_t count_numbered(const std::vector<ScenePart>& parts) {
  std::multiset<std::string> texts;
  const auto text_of = [](const ScenePart& part) {
    std::string text = part.frames.front().file;
    std::erase_if(text, [](char c) { return c >= '0' && c <= '9'; });
    return text;
  };
  for (const ScenePart& part : parts) {
    if (part.is_at_rest()) texts.insert(text_of(part));
  }
  return static_cast<std::size_t>(std::count_if(parts.begin(), parts.end(), [&](const ScenePart& part) {
    return part.is_at_rest() && texts.count(text_of(part)) > 1;
  }));
}

void check_frame_counts(const std::vector<ScenePart>& parts) {
  const ScenePart* first = nullptr;
  for (const ScenePart& part : parts) {
    if (part.is_at_rest()) continue;
    if (first == nullptr) first = &part;
    if (part.frames.size() == first->frames.size()) continue;
    throw Error(fmt::format("the part {} has {} frames, and {} has {}; parts that move have the same number of frames",
                            io::shortened(io::printable(part.name)), io::grouped(part.frames.size()),
                            io::shortened(io::printable(first->name)), io::grouped(first->frames.size())));
  }
  if (first != nullptr) return;
  std::string text = "a step needs two frames, and no part has more than 1; --check --parts asks about parts at rest";
  if (const std::size_t numbered = count_numbered(parts); numbered > 0) {
    text += fmt::format(
        "; the names of {} differ in numbers only: a pattern in quotes, such as 'lid-*.obj', is one "
        "part with these frames, and without quotes the shell makes each file a part",
        io::counted(numbered, "part"));
  }
  throw Error(text);
}

}  // namespace

std::vector<ScenePart> parts_at_rest(const std::vector<std::string>& arguments, const frames::ReadOptions& reading) {
  const std::vector<std::string> files = expand_patterns(arguments);
  refuse_repeats(files);
  std::vector<std::string> stems;
  for (const std::string& file : files) stems.push_back(stem_of(file));
  const std::vector<std::string> names = different_names(std::move(stems), files);
  std::vector<ScenePart> parts;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (const std::size_t count = frames::frame_count(files[i], reading); count != 1) {
      io::fail(files[i], fmt::format("has {} frames; it must be one mesh at rest", io::grouped(count)));
    }
    parts.push_back({names[i], {{files[i]}}});
  }
  return parts;
}

std::vector<ScenePart> moving_parts(const std::vector<std::string>& arguments, const frames::ReadOptions& reading) {
  std::vector<ScenePart> parts;
  std::vector<std::string> names, all;
  for (const std::string& argument : arguments) {
    const std::vector<std::string> files = in_order(expand_patterns({argument}), Gaps::refused);
    all.insert(all.end(), files.begin(), files.end());
    names.push_back(files.size() > 1 ? name_of_frames(argument, files) : stem_of(files.front()));
    parts.push_back({{}, frames_of(files, reading)});
    if (parts.back().frames.empty()) io::fail(argument, "has no frame");
  }
  refuse_repeats(all);
  names = different_names(std::move(names), arguments);
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i].name = names[i];
  check_frame_counts(parts);
  return parts;
}

std::vector<FrameName> frames_of(const std::vector<ScenePart>& parts) {
  std::vector<const ScenePart*> moving;
  for (const ScenePart& part : parts) {
    if (!part.is_at_rest()) moving.push_back(&part);
  }
  if (moving.size() == 1) return moving.front()->frames;
  std::vector<FrameName> frames;
  if (moving.empty()) {
    std::vector<FrameName> files;
    for (const ScenePart& part : parts) files.push_back(part.frames.front());
    show_folders(files);
    frames.push_back(files.front());
    for (const FrameName& file : files) frames[0].shown_as += (&file == &files[0] ? "" : " + ") + file.label();
    return frames;
  }
  for (std::size_t i = 0; i < moving.front()->frames.size(); ++i) {
    frames.push_back(moving.front()->frames[i]);
    frames.back().shown_as = fmt::format("frame {}", i);
  }
  return frames;
}

SceneFacts facts_of(const std::vector<ScenePart>& parts) {
  const auto at_rest = std::count_if(parts.begin(), parts.end(), [](const auto& part) { return part.is_at_rest(); });
  return {parts.size(), static_cast<std::size_t>(at_rest), count_numbered(parts)};
}

}  // namespace touchstone::sequence
