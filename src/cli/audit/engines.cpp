// SPDX-License-Identifier: MIT
#include "cli/audit/engines.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <touchstone/error.hpp>

#include "cli/shared/words.hpp"
#include "io/fail.hpp"

namespace touchstone::cli {
namespace {

namespace files = std::filesystem;

/// Where the engines are installed, or else built. Empty: nowhere.
files::path engines_folder() {
  std::error_code error;
  const files::path self = files::read_symlink("/proc/self/exe", error);
  if (error) return {};
  const files::path here = self.parent_path();
  for (const files::path& folder :
       {here.parent_path() / "libexec" / "touchstone" / "engines", here / "fuzz" / "engines" / "programs"}) {
    if (files::is_regular_file(folder / "engines.txt", error)) return folder;
  }
  return {};
}

/// A line of engines.txt: "fcl fcl", "rapier rapier.mjs", "dart - REASON".
AuditedEngine listed_engine(const std::string& line, const files::path& folder) {
  const std::size_t name_end = std::min(line.find(' '), line.size());
  const std::string rest = line.substr(std::min(name_end + 1, line.size()));
  AuditedEngine engine;
  engine.name = line.substr(0, name_end);
  if (rest.rfind("- ", 0) == 0) {
    engine.missing = rest.substr(2);
  } else {
    engine.command = (rest.ends_with(".mjs") ? "node " : "") + shell_word((folder / rest).string());
  }
  return engine;
}

std::vector<AuditedEngine> listed_engines() {
  std::vector<AuditedEngine> engines;
  const files::path folder = engines_folder();
  if (folder.empty()) return engines;
  std::ifstream list(folder / "engines.txt");
  for (std::string line; std::getline(list, line);) {
    if (!line.empty()) engines.push_back(listed_engine(line, folder));
  }
  return engines;
}

AuditedEngine given_engine(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string name = text.substr(0, equals);
  const bool named = !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == name.npos;
  if (equals == text.npos || !named || text.find_first_not_of(' ', equals + 1) == text.npos) {
    throw Error("--engine " + io::in_quotes(text) + " must be NAME=COMMAND, the name of small letters, digits and -");
  }
  return {name, text.substr(equals + 1), {}, {}, true};
}

bool is_named(const AuditedEngine& engine, const std::string& name) {
  return name == engine.name || name.rfind(engine.name + '/', 0) == 0;
}

/// Leaves the questions that are named; all where the engine itself is.
void keep_named(AuditedEngine& engine, const std::vector<std::string>& names) {
  if (names.empty() || std::find(names.begin(), names.end(), engine.name) != names.end()) return;
  std::vector<fuzz::EngineQuestion> kept;
  for (const std::string& name : names) {
    if (!is_named(engine, name)) continue;
    const auto found = std::find_if(engine.questions.begin(), engine.questions.end(),
                                    [&](const auto& q) { return engine.name + '/' + q.name == name; });
    if (found == engine.questions.end()) {
      std::string questions;
      for (const auto& q : engine.questions) questions.append(questions.empty() ? "" : ", ").append(q.name);
      throw Error(io::in_quotes(name) + " is no question; those of " + engine.name + " are " + questions);
    }
    kept.push_back(*found);
  }
  engine.questions = kept;
}

}  // namespace

std::vector<AuditedEngine> audited_engines(const std::vector<std::string>& names,
                                           const std::vector<std::string>& commands) {
  std::vector<AuditedEngine> all = names.empty() && !commands.empty() ? std::vector<AuditedEngine>() : listed_engines();
  for (const std::string& command : commands) {
    AuditedEngine engine = given_engine(command);
    if (std::any_of(all.begin(), all.end(), [&](const auto& other) { return other.name == engine.name; })) {
      throw Error("--engine " + io::in_quotes(command) + ": there is an engine " + engine.name + "; name it otherwise");
    }
    all.push_back(std::move(engine));
  }
  std::string known;
  for (const AuditedEngine& engine : all) known.append(known.empty() ? "" : ", ").append(engine.name);
  for (const std::string& name : names) {
    if (std::any_of(all.begin(), all.end(), [&](const auto& engine) { return is_named(engine, name); })) continue;
    throw Error(io::in_quotes(name) + " is no engine; " +
                (known.empty() ? "none is installed beside this program" : "they are " + known));
  }
  std::vector<AuditedEngine> engines;
  for (AuditedEngine& engine : all) {
    if (!names.empty() &&
        std::none_of(names.begin(), names.end(), [&](const auto& name) { return is_named(engine, name); })) {
      continue;
    }
    if (engine.missing.empty()) {
      try {
        engine.questions = fuzz::describe_engine(engine.command);
      } catch (const Error& error) {
        engine.missing = error.what();
      }
    }
    if (engine.missing.empty()) keep_named(engine, names);
    engines.push_back(std::move(engine));
  }
  return engines;
}

}  // namespace touchstone::cli
