// SPDX-License-Identifier: MIT
#include "cli/describe/tree.hpp"

namespace touchstone::cli {
namespace {

std::string names_of(const CommandFacts& command) {
  std::vector<std::string> names;
  for (const auto& option : command.options) names.insert(names.end(), option.names.begin(), option.names.end());
  return joined(names);
}

/// "    solve:--kind|solve:-k) words='...' ;;"
std::string value_case(const CommandFacts& command, const OptionFacts& option) {
  if (option.value.empty() && option.words.empty()) return {};  // no value, or one without a name
  std::vector<std::string> patterns;
  for (const auto& name : option.names) patterns.push_back(command.name + ":" + name);
  std::string action = "wanted=nothing";
  if (!option.words.empty())
    action = "words='" + joined(option.words) + "' wanted=words";
  else if (is_file(option))
    action = "wanted=files";
  else if (is_folder(option))
    action = "wanted=folders";
  return "    " + joined(patterns, "|") + ") " + action + " ;;\n";
}

}  // namespace

std::string bash_completion(const ProgramFacts& program) {
  std::vector<std::string> commands;
  for (const auto& command : program.commands) commands.push_back(command.name);
  std::string text = "# bash completion for " + program.name + ", written by `" + program.name +
                     " describe`. SPDX-License-Identifier: MIT\n"
                     "# shellcheck shell=bash\n"
                     "_" +
                     program.name + R"sh(() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command='' options='' words='' wanted=files
  local i
  COMPREPLY=()
  # --option=value comes as three words.
  if [[ $current == '=' ]]; then
    current=''
  elif [[ $previous == '=' ]]; then
    previous=${COMP_WORDS[COMP_CWORD-2]}
  fi
  for ((i = 1; i < COMP_CWORD; i++)); do
    [[ ${COMP_WORDS[i]} == -* ]] || { command=${COMP_WORDS[i]}; break; }
  done
  case $command in
    '') options=')sh" +
                     names_of(program.top) + "' words='" + joined(commands) + "' wanted=words ;;\n";
  for (const auto& command : program.commands) {
    text += "    " + command.name + ") options='" + names_of(command) + "'";
    if (command.positionals.empty()) text += " wanted=nothing";
    if (!command.positionals.empty() && !command.positionals.front().words.empty()) {
      text += " words='" + joined(command.positionals.front().words) + "' wanted=either";
    }
    text += " ;;\n";
  }
  text += "    *) return ;;\n  esac\n  case $command:$previous in\n";
  for (const auto& option : program.top.options) text += value_case(program.top, option);
  for (const auto& command : program.commands) {
    for (const auto& option : command.options) text += value_case(command, option);
  }
  return text + R"sh(  esac
  if [[ $current == -* ]]; then
    words=$options wanted=words
  fi
  case $wanted in
    words) mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current") ;;
    either) mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current"; compgen -f -- "$current") ;;
    files | folders)
      compopt -o filenames 2>/dev/null  # it needs a completion that is under way
      if [[ $wanted == files ]]; then
        mapfile -t COMPREPLY < <(compgen -f -- "$current")
      else
        mapfile -t COMPREPLY < <(compgen -d -- "$current")
      fi
      ;;
  esac
}
complete -F _)sh" +
         program.name + " " + program.name + "\n";
}

}  // namespace touchstone::cli
