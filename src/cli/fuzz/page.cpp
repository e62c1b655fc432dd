// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cstddef>
#include <utility>
#include <variant>

#include "cli/fuzz/findings_report.hpp"
#include "cli/shared/words.hpp"
#include "fuzz/judging/finding_text.hpp"
#include "io/output_file.hpp"
#include "view/pages/findings_page.hpp"

namespace touchstone::cli {
namespace {

view::FindingToShow finding_to_show(const fuzz::Finding& finding, const FuzzCommandOptions& options,
                                    const WrittenQuery& written) {
  const fuzz::Example& example = finding.example;
  view::FindingToShow shown;
  shown.heading = fmt::format("{}{}, {}", name_of(finding.failure),
                              finding.count > 1 ? fmt::format(" {} times", grouped(finding.count)) : "",
                              name_of(finding.degeneracy.kind));
  shown.degeneracy = fuzz::degeneracy_text(finding.degeneracy);
  shown.claim = fuzz::claim_text(example.reply);
  shown.truth = fuzz::truth_text(example.truth);
  shown.detail = example.detail;
  shown.corners = fuzz::corners_text(example.query, "");
  if (example.t_max != 1) shown.corners += fmt::format("asked for t in [0, {}]\n", fuzz::decimal_text(example.t_max));
  if (example.separation.distance > 0) shown.corners += separation_for_person(example.separation) + "\n";
  shown.commands.push_back(case_command(options, example.name));
  if (!written.file.empty()) {
    shown.commands.push_back(explain_command(finding, written));
  }
  shown.query = std::visit([](const auto& query) { return io::FileQuery(query); }, example.query);
  shown.answer = example.truth;
  shown.t_max = example.t_max;
  shown.separation = example.separation;
  return shown;
}

}  // namespace

void write_findings_page(const std::string& summary, const std::vector<fuzz::Finding>& findings,
                         const FuzzCommandOptions& options, const std::vector<WrittenQuery>& written) {
  std::vector<view::FindingToShow> shown;
  for (std::size_t i = 0; i < findings.size(); ++i) shown.push_back(finding_to_show(findings[i], options, written[i]));
  const std::string solver = options.solver.command.empty() ? options.solver.solver : options.solver.command;
  io::OutputFile file(options.html);
  view::write_page(view::findings_page("findings about the solver " + solver, summary, shown),
                   [&file](std::string_view bytes) { file.write(bytes); });
  file.commit();
}

}  // namespace touchstone::cli
