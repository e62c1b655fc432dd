// The program's commands and options, as its parser of arguments knows them: what the man page and the completions are
// made from.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/shared/command_line/command.hpp"

namespace touchstone::cli {

/// An option, or a positional argument.
struct OptionFacts {
  std::vector<std::string> names;  ///< "-h", "--help"; of a positional argument its name
  std::string value;               ///< "FILE"; empty: it takes none
  std::vector<std::string>
      words;  ///< the only values that it takes, or beside files for a positional one; empty: others
  std::string description;
  bool required = false;
  bool repeated = false;  ///< it takes several values
};

struct CommandFacts {
  std::string name;  ///< empty: the program
  std::string description;
  std::string footer;
  std::vector<OptionFacts> options, positionals;
};

struct ProgramFacts {
  std::string name;
  CommandFacts top;
  std::vector<CommandFacts> commands;  ///< those that --help shows
};

ProgramFacts facts_of(const CLI::App& program);

std::string man_page(const ProgramFacts& program);
std::string bash_completion(const ProgramFacts& program);
std::string zsh_completion(const ProgramFacts& program);

/// Whether a value is the name of a file or of a folder.
inline bool is_file(const OptionFacts& option) { return option.value == "FILE"; }
inline bool is_folder(const OptionFacts& option) { return option.value == "FOLDER"; }

/// `words` with a separator between them.
std::string joined(const std::vector<std::string>& words, const std::string& separator = " ");

}  // namespace touchstone::cli
