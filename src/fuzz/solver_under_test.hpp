// A solver under test: ours, a baseline, a callable, a plugin or a program.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

namespace touchstone::fuzz {

/// The reply of a solver to one query.
struct Reply {
  enum class State : std::uint8_t {
    answered,  ///< it returned; its claim is still to be judged
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

/// The reply of a solver that gave no answer: it crashed, hung, or sent something malformed.
inline Reply no_answer(Reply::State state, std::string detail) {
  Reply reply;
  reply.state = state;
  reply.detail = std::move(detail);
  return reply;
}

class SolverUnderTest {
 public:
  virtual ~SolverUnderTest() = default;

  /// The name in reports: "paper", "./theirs.so", "python3 theirs.py".
  virtual const std::string& name() const = 0;

  /// Whether it takes queries of this kind. Other kinds are not asked.
  virtual bool supports(Kind kind) const = 0;

  /// From the next query on contact means this separation. Only called for distances above 0, and on a solver that was
  /// made for a separation with the same metric. A solver that does not take it says so in its replies.
  virtual void change_separation(const Separation&) {}

  /// Asks for the first contact in [0, 1]. No behaviour of the solver makes it throw. One call at a time.
  virtual Reply ask(const Query& query) = 0;

  /// Whether it takes straight queries.
  virtual bool takes_straight() const { return true; }

  /// Whether it takes curved queries.
  virtual bool takes_curves() const { return false; }

  /// The same for the first contact of a curved query in [0, t_max]. Only called where takes_curves(). A solver that
  /// was made for a separation, or told of one, answers about it.
  virtual Reply ask_curved(const CurvedQuery&, double /*t_max*/) {
    return no_answer(Reply::State::malformed, "it takes no curved queries");
  }
};

}  // namespace touchstone::fuzz
