// Bodies of curved queries that take the longer of two turns: told to the user, and the option for the shorter one.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cli/shared/command_line/command.hpp"
#include "cli/shared/inputs.hpp"
#include "io/queries/curved_rows.hpp"

namespace touchstone::cli {

void add_shorter_turn_option(CLI::App& subcommand, io::Turns& turns);

/// " --shorter-turn", or nothing: the argument that asks for these turns.
std::string turns_argument(io::Turns turns);

/// What to do for shorter turns, where the command has not the option.
inline constexpr const char* kConvertForShorterTurns =
    "convert --shorter-turn --claims solve writes a file with the shorter ones";

/// The same, where it has the option.
inline constexpr const char* kTakeShorterTurns = "--shorter-turn takes the shorter ones";

/// The longer turns of several files.
class TurnNotes {
 public:
  /// @param advice  what to do for shorter turns
  explicit TurnNotes(const std::vector<Input>& inputs, io::Turns turns = io::Turns::as_given,
                     std::string advice = kTakeShorterTurns);

  void add(std::size_t input, const io::LongerTurns& turns) { turns_[input].merge(turns); }

  /// Writes a line to the standard error for each file that has some: a warning, or that they were changed. Bundled
  /// files mean what they say.
  void tell() const;

 private:
  const std::vector<Input>& inputs_;
  io::Turns taken_;
  std::string advice_;
  std::vector<io::LongerTurns> turns_;
};

}  // namespace touchstone::cli
