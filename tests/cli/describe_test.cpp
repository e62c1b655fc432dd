// The man page and the completions are made from the parser's tree. What they must hold is read here from --help.
// SPDX-License-Identifier: MIT
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <touchstone/version.hpp>

#include "cli/run_program.hpp"
#include "io/temporary_folder.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace touchstone::tests;

namespace {

std::set<std::string> set_of_lines(const std::string& text) {
  const auto lines = lines_of(text);
  return {lines.begin(), lines.end()};
}

/// What a help text lists: names of subcommands, or names of options with the words that each takes.
struct Help {
  std::set<std::string> subcommands, options;
  std::map<std::string, std::set<std::string>> words;  ///< by option
};

Help help_of(const std::vector<std::string>& command) {
  auto arguments = command;
  arguments.push_back("--help");
  const Run run = run_program(arguments);
  CHECK(run.status == 0);
  Help help;
  bool subcommands = false, options = false;
  for (const std::string& line : lines_of(run.out)) {
    if (line.empty()) subcommands = options = false;
    if (line == "Subcommands:") subcommands = true;
    if (line == "Options:") options = true;
    if (line.rfind("  ", 0) != 0 || line[2] == ' ') continue;
    const std::string first = line.substr(2, line.find(' ', 2) - 2);
    if (subcommands) help.subcommands.insert(first);
    if (!options || first[0] != '-') continue;
    std::istringstream names(first);
    std::string last;
    for (std::string name; std::getline(names, name, ',');) help.options.insert(last = name);
    const std::size_t open = line.find(":{");
    if (open == std::string::npos || line.find("  ", 2) < open) continue;
    std::istringstream words(line.substr(open + 2, line.find('}') - open - 2));
    for (std::string word; std::getline(words, word, ',');) help.words[last].insert(word);
  }
  CHECK(!help.options.empty());
  return help;
}

std::string described(const std::string& as) {
  const Run run = run_program({"describe", "--as", as});
  CHECK(run.status == 0);
  CHECK(run.err == "");
  return run.out;
}

/// A folder with the script, and a file and a folder whose names begin with `a`.
std::string folder_with(const TemporaryFolder& folder, const std::string& name, const std::string& text) {
  folder.write("here/a.csv", "");
  folder.write("here/a folder/b.csv", "");
  return folder.write(name, text);
}

/// bash's proposals for the last of these words.
std::set<std::string> bash_completes(const std::string& script, const std::string& folder,
                                     const std::vector<std::string>& words) {
  RunOptions options;
  options.program = *find_tool("bash");
  options.folder = folder;
  std::vector<std::string> arguments = {
      "-c",
      "source \"$1\"; shift; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _touchstone; "
      "printf '%s\\n' \"${COMPREPLY[@]}\"",
      "bash", script};
  arguments.insert(arguments.end(), words.begin(), words.end());
  const Run run = run_program(arguments, options);
  CAPTURE(words, run.err);
  CHECK(run.status == 0);
  CHECK(run.err == "");
  auto found = set_of_lines(run.out);
  found.erase("");
  return found;
}

using WordSet = std::set<std::string>;

}  // namespace

TEST_CASE_WITH("bash", "bash completes every subcommand, option and value that --help shows") {
  const TemporaryFolder folder;
  const std::string script = folder_with(folder, "touchstone.bash", described("bash"));
  const std::string here = folder.path("here");
  const Help top = help_of({});
  CHECK(top.subcommands.size() >= 13);
  CHECK(bash_completes(script, here, {"touchstone", ""}) == top.subcommands);
  CHECK(bash_completes(script, here, {"touchstone", "-"}) == top.options);
  CHECK(bash_completes(script, here, {"touchstone", "ce"}) == WordSet{"certify"});
  std::size_t valued = 0;
  for (const std::string& command : top.subcommands) {
    CAPTURE(command);
    const Help help = help_of({command});
    CHECK(bash_completes(script, here, {"touchstone", command, "-"}) == help.options);
    for (const auto& [option, words] : help.words) {
      CAPTURE(option);
      ++valued;
      CHECK(bash_completes(script, here, {"touchstone", command, option, ""}) == words);
      CHECK(bash_completes(script, here, {"touchstone", command, option, "=", ""}) == words);
    }
  }
  CHECK(valued >= 10);
  CHECK(bash_completes(script, here, {"touchstone", "solve", "--kind", "e"}) == WordSet{"edge-edge"});
  CHECK(bash_completes(script, here, {"touchstone", "solve", "a"}) == WordSet{"a.csv", "a folder"});
  CHECK(bash_completes(script, here, {"touchstone", "solve", "--out", "a."}) == WordSet{"a.csv"});
  CHECK(bash_completes(script, here, {"touchstone", "stress", "--out", "a"}) == WordSet{"a folder"});
  CHECK(bash_completes(script, here, {"touchstone", "stress", "--seed", ""}) == WordSet{});
  CHECK(bash_completes(script, here, {"touchstone", "doctor", ""}) == WordSet{});
  CHECK(bash_completes(script, here, {"touchstone", "simulate", "hoop-"}) == WordSet{"hoop-rim"});
  CHECK(bash_completes(script, here, {"touchstone", "simulate", "a."}) == WordSet{"a.csv"});
  CHECK(bash_completes(script, here, {"touchstone", "juggle", ""}) == WordSet{});
}

TEST_CASE_WITH("zsh", "zsh's completion names every subcommand, option and value that --help shows") {
  const TemporaryFolder folder;
  const std::string script = folder_with(folder, "_touchstone", described("zsh"));
  RunOptions options;
  options.program = *find_tool("zsh");
  // The two functions of zsh that take the lists print them here; $state says which part of the line is completed.
  const auto specs = [&](const std::string& state, const std::string& command) {
    const Run run = run_program({"-f", "-c",
                                 "setopt errexit nounset\n"
                                 "_arguments() { state=$wanted; for x; do print -r -- $x; done }\n"
                                 "_describe() { for x in ${(P)2}; do print -r -- $x; done }\n"
                                 "wanted=$2 words=($3)\nsource $1",
                                 "zsh", script, state, command},
                                options);
    CAPTURE(run.err);
    CHECK(run.status == 0);
    CHECK(run.err == "");
    return run.out;
  };
  const Help top = help_of({});
  const std::string commands = specs("subcommand", "");
  for (const std::string& command : top.subcommands) {
    CAPTURE(command);
    CHECK(occurrences("\n" + commands, "\n" + command + ":") == 1);
    const Help help = help_of({command});
    const std::string lines = std::string("\n").append(specs("arguments", command));
    for (const std::string& option : help.options) {
      CAPTURE(option);
      CHECK(occurrences(lines, "\n" + option + "[") + occurrences(lines, "\n*" + option + "[") > 0);
    }
  }
  CHECK(occurrences(specs("arguments", "simulate"), ":SCENE:{ compadd two-edges ") == 1);
  CHECK(occurrences(specs("arguments", "solve"), ":KIND:(edge-edge vertex-face point-edge point-point)") == 1);
}

TEST_CASE("the man page has every subcommand and option, and the text of their help") {
  const std::string page = described("man");
  CHECK(occurrences(page, std::string("\"touchstone ") + touchstone::version() + "\"") == 1);
  const Help top = help_of({});
  const auto with_dashes = [](const std::string& text) {
    std::string shown;
    for (const char c : text) shown.append(c == '-' ? "\\-" : std::string(1, c));
    return shown;
  };
  for (const std::string& command : top.subcommands) {
    CAPTURE(command);
    const std::string title = "\n.SS " + with_dashes(command) + "\n";
    REQUIRE(occurrences(page, title) == 1);
    const std::string section = page.substr(page.find(title));
    for (const std::string& option : help_of({command}).options) {
      CAPTURE(option);
      CHECK(section.find("\\fB" + with_dashes(option) + "\\fR") < section.find("\n.SS ", 1));
    }
  }
  CHECK(page.find(".SS describe") == std::string::npos);
}

TEST_CASE_WITH("groff", "groff formats the man page without a warning") {
  const TemporaryFolder folder;
  const std::string page = folder.write("touchstone.1", described("man"));
  RunOptions options;
  options.program = *find_tool("groff");
  const Run run = run_program({"-man", "-Tascii", "-ww", "-P-c", page}, options);
  CHECK(run.status == 0);
  CHECK(run.err == "");
  for (const char* text : {"NAME", "touchstone - exact continuous collision detection", "simulate", "--separation D",
                           "  touchstone certify --claims mine.csv edge-edge/a.csv --report report.json"}) {
    CAPTURE(text);
    std::string shown;
    for (std::size_t i = 0; i < run.out.size(); ++i) {  // bold and underlined letters are written over one another
      if (run.out[i] == '\b' && !shown.empty())
        shown.pop_back();
      else
        shown += run.out[i];
    }
    CHECK(occurrences(shown, text) > 0);
  }
}

TEST_CASE("describe refuses other forms, and --help does not show it") {
  const Run run = run_program({"describe", "--as", "html"});
  CHECK(run.status == 2);
  CHECK(run.out == "");
  CHECK(run_program({"describe"}).status == 2);
  CHECK(help_of({}).subcommands.count("describe") == 0);
}
