// SPDX-License-Identifier: MIT
#include "cli/shared/findings/given.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <variant>

#include <touchstone/error.hpp>

#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/command_line/turns.hpp"
#include "cli/shared/findings/findings_report.hpp"
#include "cli/shared/inputs.hpp"
#include "cli/shared/words.hpp"
#include "families/families.hpp"
#include "io/fail.hpp"
#include "io/queries/kind_of_file.hpp"

namespace touchstone::cli {
namespace {

/// The queries of one file.
struct Count {
  std::uint64_t queries = 0;
  std::uint64_t no_doubles = 0;
  std::uint64_t first = 0;  ///< of those that are no doubles
  std::uint64_t first_row = 0;

  void add(const io::QueryRecord& record) {
    ++queries;
    if (!std::holds_alternative<RationalQuery>(record.query)) return;
    if (no_doubles++ > 0) return;
    first = record.number;
    first_row = record.first_row;
  }
  std::string text(const std::string& file) const {
    return fmt::format(
        "{} of {} of {} {} coordinates that are no doubles and {} not asked; the first is query {}, in row {}\n",
        grouped(no_doubles), counted(queries, "query"), io::printable(file), no_doubles == 1 ? "has" : "have",
        no_doubles == 1 ? "is" : "are", first, first_row);
  }
};

std::vector<Input> inputs_of(const FuzzCommandOptions& options) {
  std::optional<Kind> kind;
  if (options.settings.kinds.size() == 1) kind = options.settings.kinds.front();
  if (options.a_case) kind = options.a_case->start.kind;
  std::vector<Input> inputs;
  for (const std::string& file : options.from) {
    // --kind also selects among the queries of many files, so that it does not overrule a folder as it does in solve.
    const auto found = find_inputs({file}, io::kind_of_path(file) ? std::nullopt : kind);
    inputs.insert(inputs.end(), found.begin(), found.end());
  }
  return inputs;
}

}  // namespace

std::vector<fuzz::AnyQuery> given_queries(const FuzzCommandOptions& options) {
  const std::vector<Input> inputs = inputs_of(options);
  std::vector<Count> counts(inputs.size());
  std::vector<fuzz::AnyQuery> queries;
  TurnNotes turns(inputs, io::Turns::as_given, kConvertForShorterTurns);
  const auto take = [&](std::size_t input, const io::QueryRecord& record) {
    counts[input].add(record);
    turns.add(input, record.longer_turns);
    if (const auto* const query = std::get_if<Query>(&record.query)) queries.push_back(*query);
    if (const auto* const curved = std::get_if<CurvedQuery>(&record.query)) queries.push_back(*curved);
  };
  for_each_query(inputs, take, io::Motions::any);
  if (queries.empty()) {
    std::uint64_t all = 0;
    for (const Count& count : counts) all += count.queries;
    throw Error(all == 0
                    ? "--from: there is no query to ask"
                    : fmt::format("--from: nothing is left to ask, {} given with coordinates that are no doubles",
                                  all == 1 ? "the only query is" : fmt::format("all {} queries are", grouped(all))));
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (counts[i].no_doubles > 0) print_error(counts[i].text(inputs[i].name));
  }
  turns.tell();
  return queries;
}

void refuse_to_overwrite_given(const FuzzCommandOptions& options) {
  refuse_to_overwrite(options.html, options.from);
  if (options.out.empty()) return;
  for (const Kind kind : kKinds) {
    for (const fuzz::FailureClass failure : fuzz::kEveryFailure) {
      for (const bool curved : {false, true}) {
        refuse_to_overwrite(findings_file(options.out, kind, failure, curved), options.from,
                            "give --out another folder");
      }
    }
  }
}

}  // namespace touchstone::cli
