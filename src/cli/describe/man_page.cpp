// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include <touchstone/version.hpp>

#include "cli/describe/tree.hpp"

namespace touchstone::cli {
namespace {

/// Text that troff takes as it is.
std::string plain(const std::string& text) {
  std::string out;
  bool line_start = true;
  for (const char c : text) {
    if (line_start && (c == '.' || c == '\'')) out += "\\&";
    line_start = c == '\n';
    switch (c) {
      case '\\': out += "\\e"; break;
      case '-': out += "\\-"; break;
      case '\'': out += "\\(aq"; break;
      case '`': out += "\\(ga"; break;
      case '^': out += "\\(ha"; break;
      case '~': out += "\\(ti"; break;
      default: out += c;
    }
  }
  return out;
}

std::string bold(const std::string& text) { return "\\fB" + plain(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + plain(text) + "\\fR"; }

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

/// Whether a paragraph of the help is prose, which the page may fill: it has no column and no indented line.
bool is_prose(const std::string& paragraph) {
  return paragraph.find("  ") == std::string::npos && paragraph.find("\n ") == std::string::npos;
}

/// The paragraphs below a help's options: prose, or lines that stay as they are.
std::string paragraphs(const std::string& text) {
  std::string out;
  std::istringstream lines(text);
  std::string paragraph;
  const auto finish = [&] {
    if (paragraph.empty()) return;
    paragraph.pop_back();
    out += is_prose(paragraph) ? ".PP\n" + plain(paragraph) + "\n" : ".PP\n.nf\n" + plain(paragraph) + "\n.fi\n";
    paragraph.clear();
  };
  for (std::string line; std::getline(lines, line);) {
    if (line.empty())
      finish();
    else
      paragraph += line + "\n";
  }
  finish();
  return out;
}

std::string option_text(const OptionFacts& option, bool positional) {
  std::string heading;
  for (const auto& name : option.names) {
    if (!heading.empty()) heading += ", ";
    heading += positional ? italic(name) : bold(name);
  }
  if (!positional && !option.value.empty()) heading.append(" ").append(italic(option.value));
  if (option.repeated) heading += " ...";
  if (option.required) heading += " (required)";
  std::string text = ".TP\n" + heading + "\n" + plain(option.description) + "\n";
  if (!option.words.empty() && !positional) text += ".br\nOne of: " + plain(joined(option.words, ", ")) + "\n";
  return text;
}

std::string options_text(const CommandFacts& command) {
  std::string text;
  for (const auto& option : command.positionals) text += option_text(option, true);
  for (const auto& option : command.options) text += option_text(option, false);
  return text;
}

}  // namespace

std::string man_page(const ProgramFacts& program) {
  const std::string about = program.top.description;
  std::string text = fmt::format(
      ".\\\" Written by `{0} describe`. SPDX-License-Identifier: MIT\n"
      ".TH {1} 1 \"\" \"{0} {2}\" \"User Commands\"\n"
      ".SH NAME\n{0} \\- exact continuous collision detection\n"
      ".SH SYNOPSIS\n{3} {4} [{5}]\n.br\n{3} {4} \\-\\-help\n.br\n{3} \\-\\-version [\\-\\-verbose]\n"
      ".SH DESCRIPTION\n",
      program.name, upper(program.name), version(), bold(program.name), italic("SUBCOMMAND"), italic("OPTIONS"));
  text += plain(about) + "\n.SH OPTIONS\n" + options_text(program.top) + ".SH SUBCOMMANDS\n";
  for (const auto& command : program.commands) {
    text += ".SS " + plain(command.name) + "\n" + plain(command.description) + "\n" + options_text(command) +
            paragraphs(command.footer);
  }
  return text + ".SH NOTES\n" + paragraphs(program.top.footer);
}

}  // namespace touchstone::cli
