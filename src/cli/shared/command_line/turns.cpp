// SPDX-License-Identifier: MIT
#include "cli/shared/command_line/turns.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <utility>

#include "cli/shared/words.hpp"
#include "io/fail.hpp"

namespace touchstone::cli {

void add_shorter_turn_option(CLI::App& subcommand, io::Turns& turns) {
  subcommand.add_flag_callback(
      "--shorter-turn", [&turns] { turns = io::Turns::shorter; },
      "Bodies of curved queries take the shorter of the two turns between their orientations: where q0 . q1 < 0, q1 "
      "gets the other sign, which is the same pose");
}

std::string turns_argument(io::Turns turns) { return turns == io::Turns::shorter ? " --shorter-turn" : ""; }

TurnNotes::TurnNotes(const std::vector<Input>& inputs, io::Turns turns, std::string advice)
    : inputs_(inputs), taken_(turns), advice_(std::move(advice)), turns_(inputs.size()) {}

void TurnNotes::tell() const {
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    const io::LongerTurns& turns = turns_[i];
    if (turns.count == 0 || inputs_[i].bundled) continue;
    const bool shorter = taken_ == io::Turns::shorter;
    const std::string where =
        turns.count == 1 ? fmt::format("the motion in row {}", turns.first_row)
                         : fmt::format("{}, the first in row {},", counted(turns.count, "motion"), turns.first_row);
    const char* const verb = turns.count == 1 ? "takes" : "take";
    const std::string text =
        shorter
            ? fmt::format("q1 of {} has got the other sign, for the shorter turn", where)
            : fmt::format("{} {} the longer of two turns (q0 . q1 < 0), as recorded poses with the other sign do; {}",
                          where, verb, advice_);
    print_error(
        fmt::format("touchstone: {}: {}{}\n", io::printable(inputs_[i].name), shorter ? "" : "warning: ", text));
  }
}

}  // namespace touchstone::cli
