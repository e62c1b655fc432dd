// What an engine's program says about itself when it is called with --describe.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <touchstone/query.hpp>

#include "fuzz/auditing/claims.hpp"

namespace touchstone::fuzz {

/// How wrong an answer may be by the engine's own word: it is right for a query whose first element is moved by at most
/// `length` plus `relative` of the greatest coordinate, or late by at most `time` of the step.
struct EngineTolerance {
  double length = 0;
  double relative = 0;
  double time = 0;
};

/// One question that the engine answers.
struct EngineQuestion {
  std::string name;    ///< of letters, digits and -
  std::string engine;  ///< its name and version
  std::string asks;    ///< the functions that are called
  std::vector<std::string> notes;
  std::vector<Kind> kinds;
  Claims claims;
  EngineTolerance tolerance;
  double separation = 0;  ///< contact is a distance of at most this
};

/// The questions of a description. The tolerance is at least a few units in the last place of a time, of the numbers'
/// type. Where none is given, it is also a few dozen of the greatest coordinate.
/// @throws Error  naming the line that is wrong
std::vector<EngineQuestion> parse_description(std::string_view text);

/// Runs `command --describe` and reads what it writes. @throws Error  with the reason when it cannot, or says it wrong
std::vector<EngineQuestion> describe_engine(const std::string& command);

}  // namespace touchstone::fuzz
