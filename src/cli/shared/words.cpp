// SPDX-License-Identifier: MIT
#include "cli/shared/words.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include <cstdio>

#include "cli/shared/command_line/separation_options.hpp"
#include "io/fail.hpp"
#include "io/queries/kind_of_file.hpp"
#include "io/times.hpp"

namespace touchstone::cli {

void print_error(const std::string& text) noexcept {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

std::string percentage(std::uint64_t count, std::uint64_t whole) {
  const double percent = whole == 0 ? 0.0 : 100 * static_cast<double>(count) / static_cast<double>(whole);
  if (count > 0 && percent < 0.1) return "< 0.1 %";
  if (count < whole && percent > 99.9) return "> 99.9 %";
  return fmt::format("{:.1f} %", percent);
}

std::string rows_text(std::uint64_t first, std::uint64_t last) {
  return first == last ? fmt::format("row {}", first) : fmt::format("rows {} to {}", first, last);
}

std::string time_for_person(double time) { return fmt::format("{} ({})", io::hexfloat(time), time); }

std::string contact_for_person(const Answer& answer) {
  if (!answer.contact) return "no contact";
  if (answer.feature_a == Feature::overlap) return fmt::format("{}, overlap", name_of(answer.nature));
  return fmt::format("{}, {} against {}", name_of(answer.nature), name_of(answer.feature_a), name_of(answer.feature_b));
}

std::string with_colour(std::string text, VerdictLine line, bool good) {
  if (text.empty()) return text;
  const std::size_t before = line == VerdictLine::first ? std::string::npos : text.rfind('\n', text.size() - 2);
  const std::size_t start = before == std::string::npos ? 0 : before + 1;
  std::size_t end = text.find('\n', start);
  for (const char* mark : {" (", ";"}) end = std::min(end, text.find(mark, start));
  text.insert(std::min(end, text.size()), "\033[0m");
  return text.insert(start, good ? "\033[32m" : "\033[31m");
}

std::string in_colour(const std::string& text, VerdictLine line, bool good) {
  const char *const no_colour = std::getenv("NO_COLOR"), *const terminal = std::getenv("TERM");
  const bool colours = ::isatty(STDOUT_FILENO) == 1 && (no_colour == nullptr || *no_colour == '\0') &&
                       terminal != nullptr && std::string_view(terminal) != "dumb";
  return colours ? with_colour(text, line, good) : text;
}

std::string fault_of_number(std::string_view text) { return std::string(" ").append(io::fault_of_double(text)); }

std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  if (io::printable(word) != word) {
    std::string escaped;
    for (const char c : word) escaped += c == '\\' || c == '\'' ? std::string{'\\', c} : std::string{c};
    return "$'" + io::printable(escaped) + "'";
  }
  std::string out = "'";
  for (const char c : word) {
    if (c == '\'') {
      out += "'\\''";
    } else {
      out += c;
    }
  }
  return out + "'";
}

std::string explain_command(const std::string& file, Kind kind, std::uint64_t query, const Separation& separation,
                            double t_max) {
  std::string options;
  if (io::kind_of_path(file) != kind) options = fmt::format(" --kind {}", name_of(kind));
  options += separation_arguments(separation);
  if (t_max != 1) options += " --t-max " + io::hexfloat(t_max);
  const std::string end_of_options = file.starts_with('-') ? " --" : "";
  return fmt::format("touchstone explain{} --query {}{} {}", options, query, end_of_options, shell_word(file));
}

std::string without_dash(const std::string& name) { return name == "-" ? "/dev/stdin" : name; }

}  // namespace touchstone::cli
