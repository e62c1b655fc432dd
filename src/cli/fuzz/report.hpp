// What `touchstone fuzz` says of what it has found, to a person and in query files.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/fuzz/fuzz.hpp"
#include "fuzz/engine.hpp"

namespace touchstone::cli {

/// One line of a terminal, without its end.
std::string progress_for_person(const fuzz::Progress& progress);

/// Who was asked what, how much and how fast.
std::string search_for_person(const FuzzOptions& options, const fuzz::Outcome& outcome, int threads);

/// How many of the given queries were asked; empty when all of them were.
std::string given_for_person(const fuzz::Outcome& outcome);

/// Failures by family and class; families without any are left out. Empty when there is none at all.
std::string table_for_person(const fuzz::FailureTable& table);

/// The command that makes this query again, asks the solver and shrinks it again.
std::string case_command(const FuzzOptions& options, const fuzz::CaseName& name);

/// Where a finding's query stands; no file: nowhere.
struct Place {
  std::string file;
  std::uint64_t query = 0;
};

/// One finding with its corners, what was claimed, what is true, and the commands that repeat and explain it.
std::string finding_for_person(std::size_t number, const fuzz::Finding& finding, const FuzzOptions& options,
                               const Place& place);

/// FOLDER/KIND/CLASS.csv.
std::string findings_file(const std::string& out, Kind kind, fuzz::FailureClass failure);

/// Writes the findings' queries, with their true answers, to FOLDER/KIND/CLASS.csv. The folders are made where they are
/// missing, and the files appear when all of them are complete.
/// @returns the place of each @throws FileError
std::vector<Place> write_findings(const std::vector<fuzz::Finding>& findings, const FuzzOptions& options);

}  // namespace touchstone::cli
