// SPDX-License-Identifier: MIT
#include "cli/audit/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include <touchstone/error.hpp>

#include "cli/audit/table.hpp"
#include "cli/shared/findings/findings_report.hpp"
#include "cli/shared/findings/given.hpp"
#include "cli/shared/new_folders.hpp"
#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/progress/pipeline.hpp"
#include "cli/shared/progress/progress_line.hpp"
#include "cli/shared/words.hpp"
#include "io/output_file.hpp"

namespace touchstone::cli {
namespace {

/// The search of one question about one kind.
FuzzCommandOptions search_of(const AuditedEngine& engine, const fuzz::EngineQuestion& question, Kind kind,
                             const AuditOptions& options) {
  FuzzCommandOptions search;
  search.solver.command = engine.command + ' ' + question.name;
  search.solver.any_memory = true;
  search.separation.separation.distance = question.separation;
  search.settings = options.settings;
  search.settings.kinds = {kind};
  search.settings.cases = options.cases;
  search.settings.separation = search.separation.separation;
  search.settings.claims = question.claims;
  search.settings.allowance.moved = question.tolerance.length;
  search.settings.allowance.moved_relative = question.tolerance.relative;
  if (question.tolerance.time > 0) search.settings.allowance.late = {.ulps = {}, .fraction = question.tolerance.time};
  search.out = (std::filesystem::path(options.out) / (engine.name + '-' + question.name)).string();
  const bool listed = std::find_if(options.commands.begin(), options.commands.end(), [&](const std::string& text) {
                        return text.rfind(engine.name + '=', 0) == 0;
                      }) == options.commands.end();
  search.repeat = fmt::format("touchstone audit {}/{} --out again", engine.name, question.name);
  if (!listed) search.repeat += " --engine " + shell_word(engine.name + '=' + engine.command);
  return search;
}

/// What an audit has found so far.
struct Audit {
  std::vector<AuditRow> rows;
  std::string findings;                      ///< for a person
  std::vector<view::FindingToShow> to_show;  ///< on the page
  std::size_t shown = 0;
  std::string troubles;  ///< lines about questions that could not be asked
};

void add_findings(Audit& audit, const std::string& name, const FuzzCommandOptions& search,
                  const std::vector<fuzz::Finding>& findings) {
  const std::vector<WrittenQuery> written = write_findings(findings, search);
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const std::string text = finding_for_person(++audit.shown, findings[i], search, written[i]);
    const std::size_t title = text.find(". ") + 2;
    audit.findings += text.substr(0, title) + name + " " + text.substr(title);
    audit.to_show.push_back(finding_to_show(findings[i], search, written[i]));
    audit.to_show.back().heading = name + ": " + audit.to_show.back().heading;
  }
}

/// Asks one question about one kind. @returns false when the user has interrupted it
bool ask(Audit& audit, const std::string& name, const FuzzCommandOptions& search, Kind kind, ProgressLine& line) {
  fuzz::SearchOutcome outcome =
      fuzz::run(solver_factory(search.solver, search.separation), search.settings, [&](const fuzz::Progress& progress) {
        line.draw([&] { return fmt::format("{}, {}: {}", name, name_of(kind), progress_for_person(progress)); });
        return !interrupted();
      });
  add_findings(audit, name, search, outcome.findings);
  if (const std::size_t rest = outcome.kinds_of_failure - outcome.findings.size(); rest > 0) {
    audit.findings += fmt::format("{}, {}: {} of failure not shown; --findings 0 shows all\n", name, name_of(kind),
                                  rest == 1 ? "1 more kind" : fmt::format("{} more kinds", rest));
  }
  outcome.findings.clear();
  audit.rows.push_back({name, kind, std::move(outcome)});
  return !interrupted();
}

bool has_kind(const std::vector<Kind>& kinds, Kind kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

/// Whether the question is asked about queries of this kind.
bool is_asked(const AuditOptions& options, Kind kind) {
  const std::vector<fuzz::AnyQuery>& given = options.settings.given;
  if (!options.settings.kinds.empty() && !has_kind(options.settings.kinds, kind)) return false;
  return given.empty() ||
         std::any_of(given.begin(), given.end(), [&](const auto& query) { return fuzz::kind_of(query) == kind; });
}

/// The queries of the files. @throws Error  where one is curved
std::vector<fuzz::AnyQuery> straight_queries(const AuditOptions& options) {
  FuzzCommandOptions files;
  files.from = options.from;
  files.html = options.html;
  files.settings.kinds = options.settings.kinds;
  refuse_to_overwrite_given(files);
  std::vector<fuzz::AnyQuery> queries = given_queries(files);
  if (std::any_of(queries.begin(), queries.end(), [](const auto& query) { return fuzz::is_curved(query); })) {
    throw Error("--from: an audit asks straight queries, and these files have curved ones");
  }
  return queries;
}

std::string asked_text(const AuditOptions& options) {
  if (!options.from.empty()) return counted(options.settings.given.size(), "given query");
  return fmt::format("seed {}, {} of each question and kind", options.settings.seed, counted(options.cases, "case"));
}

}  // namespace

int run_audit(const AuditOptions& given) {
  AuditOptions options = given;
  check_outputs(options.out, options.html);
  if (!options.from.empty()) options.settings.given = straight_queries(options);
  options.settings.threads = thread_count(options.settings.threads);
  const std::vector<AuditedEngine> engines = audited_engines(options.engines, options.commands);
  if (std::none_of(engines.begin(), engines.end(), [](const auto& engine) { return engine.missing.empty(); })) {
    throw Error(engines.empty() ? "no engine is installed beside this program; --engine NAME=COMMAND brings one"
                                : "no engine can be asked: " + engines[0].name + ": " + engines[0].missing);
  }
  NewFolders folders;
  folders.make(options.out);
  Audit audit;
  bool going = true;
  {
    ProgressLine line;
    for (const AuditedEngine& engine : engines) {
      for (const fuzz::EngineQuestion& question : engine.questions) {
        for (const Kind kind : question.kinds) {
          if (!going || !is_asked(options, kind)) continue;
          const std::string name = engine.name + '/' + question.name;
          try {
            going = ask(audit, name, search_of(engine, question, kind, options), kind, line);
          } catch (const FileError&) {
            throw;
          } catch (const Error& error) {  // the other engines are asked all the same
            audit.troubles += fmt::format("{}, {}: not asked: {}\n", name, name_of(kind), error.what());
          }
        }
      }
    }
  }
  if (audit.rows.empty() && going) {
    throw Error(audit.troubles.empty() ? "no engine that can be asked takes queries of these kinds"
                                       : "no engine answered: " + audit.troubles.substr(0, audit.troubles.find('\n')));
  }
  const auto is_silent = [](const AuditedEngine& engine) { return engine.is_given && !engine.missing.empty(); };
  const bool good = audit.troubles.empty() && std::none_of(audit.rows.begin(), audit.rows.end(), failed) &&
                    std::none_of(engines.begin(), engines.end(), is_silent);
  const std::string summary =
      fmt::format("{}, judged by exact arithmetic{}\n\n", asked_text(options), going ? "" : "; interrupted") +
      engines_text(engines) + audit.troubles + '\n' + audit_table(audit.rows);
  io::OutputFile table((std::filesystem::path(options.out) / "audit.txt").string());
  table.write(summary + audit.findings);
  table.commit();
  folders.keep();
  if (!options.html.empty()) write_findings_page(options.html, "an audit of engines", summary, audit.to_show);
  auto console = io::OutputFile::standard_output();
  console.write(summary + audit.findings);
  console.commit();
  return good ? kAllHold : kRefuted;
}

}  // namespace touchstone::cli
