// SPDX-License-Identifier: MIT
#include "cli/shared/found_query.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>
#include <vector>

#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "io/queries/separation_text.hpp"

namespace touchstone::cli {

std::string check_query_number(const std::string& text) {
  return check_whole_number(text).empty() ? std::string() : text + " must be a number counted from 0";
}

std::unique_ptr<FoundQuery> find_query(const Input& input, std::uint64_t number, io::Turns turns,
                                       const std::string& advice) {
  io::QueryChunkReader reader(input.open(), input.kind, io::kChunkBytes, io::Motions::any, input.decimals);
  std::uint64_t count = 0;
  auto found = std::make_unique<FoundQuery>();
  while (auto chunk = reader.next()) {
    throw_if_interrupted();
    if (chunk->first_query == 0) found->truth_separation = io::stated_separation(*chunk);
    count += chunk->query_count;
    if (number >= count && !chunk->truncated) continue;
    found->chunk = std::move(*chunk);
    io::QueryParser parser(found->chunk, turns);
    while (parser.next(found->record)) {
      if (found->record.number != number) continue;
      const std::vector<Input> inputs = {input};
      TurnNotes notes(inputs, turns, advice);
      notes.add(0, found->record.longer_turns);
      notes.tell();
      return found;
    }
  }
  io::fail(input.name, fmt::format("has no query {}; it has {}, counted from 0", number, counted(count, "query")));
}

std::string heading(const Input& input, const io::QueryRecord& record) {
  const char* const motion = std::holds_alternative<CurvedQuery>(record.query) ? ", curved motion" : "";
  return fmt::format("query {} of {} ({}), {}{}", record.number, io::printable(input.name),
                     rows_text(record.first_row, record.last_row), name_of(input.kind), motion);
}

}  // namespace touchstone::cli
