// The report on the findings of a search for failures, as text for a person and as query files.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/shared/findings/search_options.hpp"
#include "fuzz/engine.hpp"
#include "view/pages/findings_page.hpp"

namespace touchstone::cli {

/// One line of a terminal, without its end.
std::string progress_for_person(const fuzz::Progress& progress);

/// The solver, the judge, the seed, and the number and rate of the queries.
std::string search_for_person(const FuzzCommandOptions& options, const fuzz::SearchOutcome& outcome, int threads);

/// The number of given queries that were asked; empty when all of them were.
std::string given_for_person(const fuzz::SearchOutcome& outcome);

/// "; 3 wrong answers did not count: late by at most 16ulps". Empty where all count.
std::string allowed_for_person(const FuzzCommandOptions& options, const fuzz::SearchOutcome& outcome);

/// Failures by family and class. Families without failures are left out. Empty without any failure.
std::string table_for_person(const fuzz::FailureTable& table);

/// The command that makes the finding's query again, or reads it again, asks the solver again and shrinks the query
/// again.
std::string case_command(const FuzzCommandOptions& options, const fuzz::Finding& finding);

/// The position of a finding's query among the written files.
struct WrittenQuery {
  std::string file;  ///< empty: the query was not written
  std::uint64_t query = 0;
};

/// The command that explains the query as it was written and asked.
std::string explain_command(const fuzz::Finding& finding, const WrittenQuery& written);

/// One finding: its corners, the claim, the true answer, and the commands that repeat and explain it.
std::string finding_for_person(std::size_t number, const fuzz::Finding& finding, const FuzzCommandOptions& options,
                               const WrittenQuery& written);

/// FOLDER/KIND/CLASS.csv, or FOLDER/KIND/curved_CLASS.csv for curved queries. With separations of their own, each
/// finding has a file to itself, FOLDER/KIND/CLASS-N.csv.
std::string findings_file(const std::string& out, Kind kind, fuzz::FailureClass failure, bool curved);

/// Writes the findings' queries, with their true answers for the whole step, to these files. The folders are made where
/// they are missing, and the files appear when all of them are complete.
/// @returns the position of each @throws FileError
std::vector<WrittenQuery> write_findings(const std::vector<fuzz::Finding>& findings, const FuzzCommandOptions& options);

/// The finding for a page.
view::FindingToShow finding_to_show(const fuzz::Finding& finding, const FuzzCommandOptions& options,
                                    const WrittenQuery& written);

/// Writes the page of the findings. @param summary  whole lines about the search @throws FileError
void write_findings_page(const std::string& file, const std::string& title, const std::string& summary,
                         const std::vector<view::FindingToShow>& findings);

/// Throws when nothing can be written to the folder or the page (empty: none): before minutes are spent on a search,
/// not after. @throws Error
void check_outputs(const std::string& out, const std::string& html);

}  // namespace touchstone::cli
