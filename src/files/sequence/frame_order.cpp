// SPDX-License-Identifier: MIT
#include "sequence/frame_order.hpp"

#include <glob.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <new>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>

#include "frames/content.hpp"
#include "io/answers/claim_columns.hpp"
#include "io/fail.hpp"
#include "sequence/frame_name.hpp"

namespace touchstone::sequence {
namespace {

constexpr std::size_t kMostDigits = 18;  // of a number; more digits are text

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A name cut into texts and the numbers between them: text[0] number[0] text[1] ...
struct SplitName {
  std::vector<std::string> texts{1};
  std::vector<std::uint64_t> numbers;
};

SplitName split(std::string_view name) {
  SplitName split_name;
  while (!name.empty()) {
    const auto digits = static_cast<std::size_t>(std::find_if_not(name.begin(), name.end(), is_digit) - name.begin());
    if (digits == 0 || digits > kMostDigits) {
      const std::size_t length = std::max<std::size_t>(digits, 1);
      split_name.texts.back() += name.substr(0, length);
      name.remove_prefix(length);
      continue;
    }
    split_name.numbers.push_back(std::stoull(std::string(name.substr(0, digits))));
    split_name.texts.emplace_back();
    name.remove_prefix(digits);
  }
  return split_name;
}

struct Numbered {
  std::uint64_t number;
  std::string file;
};

/// The indices of the numbers in which names differ; nothing when they differ in anything else.
std::optional<std::vector<std::size_t>> differing_numbers(const std::vector<SplitName>& all) {
  const SplitName& first = all.front();
  std::set<std::size_t> indices;
  for (const SplitName& split_name : all) {
    if (split_name.texts != first.texts) return std::nullopt;
    for (std::size_t i = 0; i < split_name.numbers.size(); ++i) {
      if (split_name.numbers[i] != first.numbers[i]) indices.insert(i);
    }
  }
  return std::vector(indices.begin(), indices.end());
}

/// The names in the order of the numbers at an index.
std::vector<std::size_t> order_by(const std::vector<SplitName>& all, std::size_t index) {
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return all[a].numbers[index] < all[b].numbers[index]; });
  return order;
}

/// Of several numbers in which names differ, as in f-2-t0.2 and f-10-t0.10, one that is a frame's own: no two names
/// have it. Those with a constant stride count first. Nothing when there is none, or when two of them give different
/// orders.
std::optional<std::size_t> frame_number_of(const std::vector<SplitName>& all, const std::vector<std::size_t>& indices) {
  struct Found {
    std::vector<std::size_t> order;
    std::size_t index = 0;
    bool agreed = true;
  };
  std::array<std::optional<Found>, 2> found;  // without and with a constant stride
  for (const std::size_t index : indices) {
    auto order = order_by(all, index);
    const auto number = [&](std::size_t i) { return all[order[i]].numbers[index]; };
    bool is_own = true, is_constant = true;
    for (std::size_t i = 1; i < order.size(); ++i) {
      is_own = is_own && number(i) != number(i - 1);
      is_constant = is_constant && number(i) - number(i - 1) == number(1) - number(0);
    }
    if (!is_own) continue;
    auto& same_sort = found[is_constant ? 1 : 0];
    if (!same_sort) {
      same_sort = Found{std::move(order), index};
    } else if (same_sort->order != order) {
      same_sort->agreed = false;
    }
  }
  const auto& best = found[1] ? found[1] : found[0];
  if (!best || !best->agreed) return std::nullopt;
  return best->index;
}

/// The files with the number that orders them; nothing when there is no such number.
std::optional<std::vector<Numbered>> numbered(const std::vector<std::string>& files) {
  std::vector<SplitName> all;
  all.reserve(files.size());
  for (const auto& file : files) all.push_back(split(file));
  const auto indices = differing_numbers(all);
  if (!indices || all.front().numbers.empty()) return std::nullopt;
  // Names without a difference are those of one number: its digits differ, as in 1 and 01, or nothing does.
  std::optional<std::size_t> at = indices->empty() ? all.front().numbers.size() - 1 : indices->front();
  if (indices->size() > 1) at = frame_number_of(all, *indices);
  if (!at) return std::nullopt;
  std::vector<Numbered> result;
  for (std::size_t i = 0; i < files.size(); ++i) result.push_back({all[i].numbers[*at], files[i]});
  return result;
}

std::string base_name(const std::string& file) {
  return io::printable(std::filesystem::path(file).filename().string());
}

/// Names that are no numbered sequence may be frames, or the parts of one scene, about which nothing would be asked.
[[noreturn]] void refuse_names(const std::vector<std::string>& files, const std::string& advice) {
  const SplitName first = split(files.front());
  std::string fault = "several numbers, which do not say the order of the frames";
  std::size_t at = 1;
  for (std::size_t i = 1; i < files.size(); ++i) {
    if (split(files[i]).texts == first.texts) continue;
    at = i;
    fault = "more than numbers";
    break;
  }
  io::fail(files[at], "the name differs from " + base_name(files.front()) + " in " + fault + advice);
}

void check_numbers(const std::vector<Numbered>& files, const std::string& advice) {
  for (std::size_t i = 1; i < files.size(); ++i) {
    if (files[i].number != files[i - 1].number) continue;
    io::fail(files[i].file, "has the same number as " + base_name(files[i - 1].file) +
                                ", and a sequence has each number once" + advice);
  }
}

void check_stride(const std::vector<Numbered>& files, const std::string& advice) {
  if (files.size() < 3) return;
  std::uint64_t stride = files[1].number - files[0].number;
  for (std::size_t i = 2; i < files.size(); ++i) stride = std::min(stride, files[i].number - files[i - 1].number);
  for (std::size_t i = 1; i < files.size(); ++i) {
    const auto &before = files[i - 1], &after = files[i];
    if (after.number - before.number == stride) continue;
    io::fail(after.file, "frame " + std::to_string(before.number + stride) + " is missing between " +
                             base_name(before.file) + " and " + base_name(after.file) +
                             "; other frames of the sequence are " + std::to_string(stride) + " apart" + advice);
  }
}

/// The files that a pattern matches.
std::vector<std::string> matches_of(const std::string& pattern) {
  glob_t found{};
  const int status = ::glob(pattern.c_str(), 0, nullptr, &found);
  std::vector<std::string> files;
  if (status == 0) files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  ::globfree(&found);
  if (status == GLOB_NOSPACE) throw std::bad_alloc();
  return files;
}

/// The name as a pattern that matches nothing else.
std::string escaped(const std::string& name) {
  std::string pattern;
  for (const char c : name) {
    if (std::string_view("*?[\\").find(c) != std::string_view::npos) pattern += '\\';
    pattern += c;
  }
  return pattern;
}

/// The frames of a folder: its files of one format, in the order of their names. Other files in it are no frames.
std::vector<std::string> frames_in(std::string folder) {
  while (folder.size() > 1 && folder.ends_with('/')) folder.pop_back();
  std::map<std::string, std::vector<std::string>> by_ending;  // in lower case
  std::set<std::string> patterns;
  std::string unread;
  const auto shown = [&](const std::string& ending) { return "'" + io::printable(folder + "/*" + ending) + "'"; };
  for (const std::string& file : matches_of(escaped(folder) + "/*")) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) continue;
    const std::string ending = std::filesystem::path(file).extension().string();
    if (frames::known_format_of(file)) {
      by_ending[io::in_lower_case(ending)].push_back(file);
      patterns.insert(shown(ending));
    } else if (!frames::fault_of_unread_format(file).empty()) {
      unread = file;
    }
  }
  if (by_ending.empty() && !unread.empty()) io::fail(unread, frames::fault_of_unread_format(unread));
  if (by_ending.empty()) io::fail(folder, "is a folder without mesh files");
  if (!unread.empty()) {  // perhaps frames that would be missed
    io::fail(folder, "is a folder with " + base_name(unread) + ", a format that is not read; name the files, such as " +
                         *patterns.begin());
  }
  if (by_ending.size() == 1) return by_ending.begin()->second;
  std::string endings, all;
  for (const auto& [ending, files] : by_ending) {
    endings += (endings.empty() ? "" : ", ") + std::to_string(files.size()) + " " + io::printable(ending);
  }
  for (const std::string& pattern : patterns) all += " " + pattern;
  io::fail(folder, "is a folder with files of several formats (" + endings + "); name those of one, such as " +
                       *patterns.begin() + ", or, where each file is a body or a part of its own, all:" + all);
}

}  // namespace

std::vector<std::string> expand_patterns(const std::vector<std::string>& arguments) {
  std::vector<std::string> files;
  for (const auto& argument : arguments) {
    std::error_code ignored;
    if (std::filesystem::is_directory(argument, ignored)) {
      const auto found = frames_in(argument);
      files.insert(files.end(), found.begin(), found.end());
      continue;
    }
    const bool pattern = argument.find_first_of("*?[") != std::string::npos;
    if (!pattern && argument != "-" && !frames::known_format_of(argument) &&
        !std::filesystem::exists(argument, ignored)) {
      io::fail(argument, "is no file, no folder, and no pattern such as 'x-*.obj'");
    }
    if (!pattern || std::filesystem::exists(argument, ignored)) {
      files.push_back(argument);
      continue;
    }
    const auto found = matches_of(argument);
    if (found.empty()) io::fail(argument, "is no file, and no file matches this pattern");
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

void refuse_repeats(const std::vector<std::string>& files) {
  std::map<std::filesystem::path, std::string> known;
  for (const auto& file : files) {
    const auto [earlier, is_new] = known.emplace(with_one_spelling(file), file);
    if (is_new) continue;
    const std::string& other = earlier->second;
    io::fail(file, (other == file ? "is given twice" : "is the same file as " + io::printable(other)) +
                       "; its frames would count twice: name it once");
  }
}

std::vector<std::string> in_order(std::vector<std::string> files, Gaps gaps, std::string advice) {
  if (files.size() < 2) return files;
  refuse_repeats(files);
  if (!advice.empty()) advice.insert(0, ". ");
  auto with_numbers = numbered(files);
  if (!with_numbers) refuse_names(files, advice);
  std::stable_sort(with_numbers->begin(), with_numbers->end(),
                   [](const Numbered& a, const Numbered& b) { return a.number < b.number; });
  if (gaps == Gaps::refused) {
    check_numbers(*with_numbers, advice);
    check_stride(*with_numbers, advice);
  }
  for (std::size_t i = 0; i < files.size(); ++i) files[i] = std::move((*with_numbers)[i].file);
  return files;
}

std::vector<std::string> as_given(const std::vector<std::string>& arguments) {
  std::vector<std::string> files;
  for (const auto& argument : arguments) {
    std::vector<std::string> found = expand_patterns({argument});
    if (numbered(found)) found = in_order(std::move(found), Gaps::allowed);
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

}  // namespace touchstone::sequence
