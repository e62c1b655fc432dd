// SPDX-License-Identifier: MIT
#include "sequence/frame_name.hpp"

#include <system_error>

#include "io/fail.hpp"

namespace touchstone::sequence {

std::filesystem::path with_one_spelling(const std::string& file) {
  std::error_code ignored;
  const std::filesystem::path path(file), folder = path.parent_path();
  return std::filesystem::weakly_canonical(folder.empty() ? "." : folder, ignored) / path.filename();
}

std::string FrameName::label() const {
  if (!shown_as.empty()) return shown_as;
  std::filesystem::path path = folders == 0 ? std::filesystem::path(file) : with_one_spelling(file);
  std::filesystem::path shown = path.filename();
  for (std::size_t i = 0; i < folders && path.has_parent_path(); ++i) {
    path = path.parent_path();
    shown = path.filename() / shown;
  }
  std::string text = io::printable(shown.string());
  if (several) text.append("[").append(std::to_string(index)).append("]");
  return text;
}

bool same_file(const std::string& a, const std::string& b) { return with_one_spelling(a) == with_one_spelling(b); }

}  // namespace touchstone::sequence
