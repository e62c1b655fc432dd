// SPDX-License-Identifier: MIT
#include "cli/shared/animation_file.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "cli/shared/command_line/typed_command.hpp"
#include "cli/shared/words.hpp"
#include "io/answers/claim_columns.hpp"
#include "io/fail.hpp"
#include "view/frame_svg.hpp"

namespace touchstone::cli {

std::uint64_t write_animation(const view::Animation& animation, view::AnimationWords words, io::OutputFile& file) {
  if (io::in_lower_case(std::filesystem::path(file.name()).extension().string()) == ".svg") {
    const std::string text = view::moving_svg(animation, words.title, words.subtitle, words.time_unit);
    file.write(text);
    return text.size();
  }
  words.command = typed_command();
  return view::write_animation_page(animation, words, [&](std::string_view bytes) { file.write(bytes); });
}

std::string animation_summary(const std::string& file, std::uint64_t bytes) {
  return fmt::format("animation in {}, {} bytes: open it in a browser\n", io::printable(file), grouped(bytes));
}

}  // namespace touchstone::cli
