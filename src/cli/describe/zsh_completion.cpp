// SPDX-License-Identifier: MIT
#include <string_view>

#include "cli/describe/tree.hpp"

namespace touchstone::cli {
namespace {

/// `text` in single quotes.
std::string in_quotes(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// The first sentence of a description, with a backslash before each of `special`.
std::string short_text(const std::string& text, std::string_view special) {
  std::string out;
  for (const char c : text.substr(0, text.find(". "))) {
    if (special.find(c) != std::string_view::npos) out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out;
}

std::string action_of(const OptionFacts& option) {
  if (!option.words.empty()) return std::string("(").append(joined(option.words)).append(")");
  if (is_file(option)) return "_files";
  if (is_folder(option)) return "_files -/";
  return " ";  // a value that cannot be listed
}

/// "'--kind[The kind of the files]:KIND:(edge-edge ...)'" for _arguments.
std::string argument(const OptionFacts& option) {
  std::string text;
  for (const auto& name : option.names) {
    std::string spec = option.repeated ? "*" : "";
    spec.append(name).append("[").append(short_text(option.description, "[]\\:")).append("]");
    if (!option.value.empty()) spec.append(":").append(option.value).append(":").append(action_of(option));
    text.append(" \\\n        ").append(in_quotes(spec));
  }
  return text;
}

std::string arguments(const CommandFacts& command) {
  std::string text;
  for (const auto& option : command.options) text += argument(option);
  return text;
}

}  // namespace

std::string zsh_completion(const ProgramFacts& program) {
  std::string text = "#compdef " + program.name + "\n# Written by `" + program.name +
                     " describe`. SPDX-License-Identifier: MIT\n_" + program.name +
                     "() {\n"
                     "  local context state state_descr line\n"
                     "  typeset -A opt_args\n"
                     "  _arguments -C" +
                     arguments(program.top) +
                     " \\\n        '1:subcommand:->subcommand' \\\n        '*::argument:->arguments'\n"
                     "  case $state in\n    subcommand)\n      local -a subcommands\n      subcommands=(\n";
  for (const auto& command : program.commands) {
    text += "        " + in_quotes(command.name + ":" + short_text(command.description, ":\\")) + "\n";
  }
  text += "      )\n      _describe subcommand subcommands\n      ;;\n    arguments)\n      case $words[1] in\n";
  for (const auto& command : program.commands) {
    text += "        " + command.name + ") _arguments" + arguments(command);
    for (const auto& positional : command.positionals) {
      std::string spec = positional.repeated ? "*:" : ":";
      spec.append(positional.names.front()).append(":");
      spec += positional.words.empty() ? "_files" : "{ compadd " + joined(positional.words) + "; _files }";
      text.append(" \\\n        ").append(in_quotes(spec));
    }
    text += " ;;\n";
  }
  return text + "      esac\n      ;;\n  esac\n}\n_" + program.name + " \"$@\"\n";
}

}  // namespace touchstone::cli
