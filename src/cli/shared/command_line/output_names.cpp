// SPDX-License-Identifier: MIT
#include "cli/shared/command_line/output_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

#include "cli/shared/command_line/common_options.hpp"
#include "frames/content.hpp"
#include "io/answers/claim_columns.hpp"
#include "io/fail.hpp"
#include "io/queries/query_file_writer.hpp"

namespace touchstone::cli {
namespace {

struct OutputFormat {
  Output output;
  std::string_view name;                    ///< "what is written is ..."
  std::vector<std::string_view> endings{};  ///< the usual one first
};

const std::vector<OutputFormat>& formats() {
  static const std::vector<OutputFormat> all = {
      {Output::csv, "CSV", {".csv"}},
      {Output::json, "JSON", {".json"}},
      {Output::json_lines, "lines of JSON", {".jsonl", ".ndjson", ".json"}},
      {Output::page, "a page, HTML with pictures (SVG) in it", {".html", ".htm"}},
      {Output::animation, "a page, HTML with pictures (SVG) in it, or a moving picture", {".html", ".htm", ".svg"}},
      {Output::picture, "a moving picture (SVG)", {".svg"}},
      {Output::text, "text", {".txt"}},
      {Output::theorem, "a theorem of Coq", {".v"}},
  };
  return all;
}

bool has(const std::vector<std::string_view>& endings, std::string_view ending) {
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

/// Whether the name says that the file has a format beyond plain text: one of the program's, or a well-known one.
bool has_known_ending(const std::string& name, std::string_view ending) {
  static const std::vector<std::string_view> others = {
      ".abc", ".avi", ".blend", ".bmp", ".doc", ".docx", ".eps",  ".fbx", ".gif",  ".gz",  ".jpg",     ".jpeg",
      ".mat", ".mov", ".mp4",   ".npz", ".odt", ".ods",  ".pdf",  ".pkl", ".png",  ".ps",  ".parquet", ".pvd",
      ".svg", ".tif", ".tiff",  ".tsv", ".usd", ".webm", ".webp", ".xls", ".xlsx", ".xml", ".zip"};
  const auto is_of = [&](const OutputFormat& format) {
    return format.output != Output::text && has(format.endings, ending);
  };
  return has(others, ending) || std::any_of(formats().begin(), formats().end(), is_of) ||
         io::format_of_name(name).has_value() || frames::known_format_of(name).has_value();
}

}  // namespace

std::string fault_of_name(const std::string& name, Output output) {
  const auto& format =
      *std::find_if(formats().begin(), formats().end(), [&](const OutputFormat& one) { return one.output == output; });
  const std::filesystem::path path(name);
  const std::string ending = io::in_lower_case(path.extension().string());
  if (has(format.endings, ending) || !has_known_ending(name, ending)) return not_empty(name);
  std::filesystem::path right = path;
  right.replace_extension();
  if (right.extension() != format.endings.front()) right += format.endings.front();
  return fmt::format("{} has the ending of another format; what is written is {}: name it {}", io::printable(name),
                     format.name, io::printable(right.string()));
}

std::function<std::string(const std::string&)> named_as(Output output) {
  return [output](const std::string& name) { return fault_of_name(name, output); };
}

std::string fault_of_module_name(const std::string& name, const std::string& usual) {
  if (name == "-") return {};
  const std::filesystem::path path(name);
  const std::string stem = path.stem().string();
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto fits = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  const bool is_module = !stem.empty() && is_letter(stem[0]) && std::all_of(stem.begin(), stem.end(), fits);
  if (is_module && path.extension() == ".v") return {};
  return fmt::format(
      "{} is no name of a theory, which Coq takes: a letter, then letters, digits and _, and then .v; name it {}",
      io::printable(name), io::printable((path.parent_path() / usual).string()));
}

}  // namespace touchstone::cli
