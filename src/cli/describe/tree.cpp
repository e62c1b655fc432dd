// SPDX-License-Identifier: MIT
#include "cli/describe/tree.hpp"

#include <CLI/CLI.hpp>
#include <sstream>

namespace touchstone::cli {
namespace {

/// The words of "METRIC:{euclidean,max}".
std::vector<std::string> words_of(const std::string& type) {
  const std::size_t open = type.find('{'), close = type.find('}');
  std::vector<std::string> words;
  if (open == std::string::npos || close == std::string::npos) return words;
  std::istringstream list(type.substr(open + 1, close - open - 1));
  for (std::string word; std::getline(list, word, ',');) words.push_back(word);
  return words;
}

OptionFacts facts_of(const CLI::Option& option) {
  OptionFacts facts;
  if (option.get_positional()) {
    facts.names = {option.get_name(true)};
  } else {
    for (const auto& name : option.get_snames()) facts.names.push_back("-" + name);
    for (const auto& name : option.get_lnames()) facts.names.push_back("--" + name);
  }
  if (option.get_items_expected_max() > 0) {
    const std::string type = option.get_type_name();
    facts.value = type.substr(0, type.find(':'));
    facts.words = words_of(type);
  }
  facts.description = option.get_description();
  facts.required = option.get_required();
  facts.repeated = option.get_items_expected_max() > 1;
  return facts;
}

CommandFacts facts_of_command(const CLI::App& command) {
  CommandFacts facts;
  facts.name = command.get_name();
  facts.description = command.get_description();
  facts.footer = command.get_footer();
  for (const CLI::Option* const option : command.get_options()) {
    if (option->get_group().empty()) continue;
    (option->get_positional() ? facts.positionals : facts.options).push_back(facts_of(*option));
  }
  return facts;
}

}  // namespace

ProgramFacts facts_of(const CLI::App& program) {
  ProgramFacts facts;
  facts.name = program.get_name();
  facts.top = facts_of_command(program);
  facts.top.name.clear();
  for (const CLI::App* const command : program.get_subcommands({})) {
    if (!command->get_group().empty()) facts.commands.push_back(facts_of_command(*command));
  }
  return facts;
}

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

}  // namespace touchstone::cli
