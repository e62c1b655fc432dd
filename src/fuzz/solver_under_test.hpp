// A solver to be attacked: ours, a baseline, a callable, somebody's plugin or program.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <touchstone/query.hpp>

namespace touchstone::fuzz {

/// What a solver did with one query.
struct Reply {
  enum class State : std::uint8_t {
    answered,  ///< it returned; what it says is still to be judged
    crashed,   ///< it ended by a signal or an exception, or its program exited
    hung,      ///< it did not return within the limit on wall-clock time
    malformed  ///< it returned something that is no answer: a line that cannot be read, a status that is undefined
  };
  State state = State::answered;
  bool contact = false;
  std::optional<double> toi;   ///< as claimed: may be NaN, infinite or outside [0, 1]
  std::string toi_as_written;  ///< as in Claim: the time when `toi` is only the nearest double to it
  std::string detail;          ///< for a person: the signal, the exit status, the line; empty when answered
};

class SolverUnderTest {
 public:
  virtual ~SolverUnderTest() = default;

  /// As reports name it: "paper", "./theirs.so", "python3 theirs.py".
  virtual const std::string& name() const = 0;

  /// Whether it takes queries of this kind; the others are not asked.
  virtual bool supports(Kind kind) const = 0;

  /// Asks it for the first contact in [0, 1]. Never throws because of what the solver does. One call at a time.
  virtual Reply ask(const Query& query) = 0;
};

}  // namespace touchstone::fuzz
