// An engine as a program that `touchstone audit` asks over pipes: its questions, and the loop that answers them.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace engine {

using Point = std::array<double, 3>;

/// "edge-edge" a0 a1 b0 b1, "vertex-face" v f0 f1 f2, "point-edge" p e0 e1, "point-point" p q.
struct Query {
  std::string kind;
  std::vector<Point> start, end;  ///< the corners at t = 0 and at t = 1

  /// How many corners the first element has; the second has the others.
  std::size_t first() const { return kind == "edge-edge" ? 2 : 1; }

  /// The motion of a corner from t = 0 to t = 1.
  Point motion(std::size_t corner) const {
    Point d{};
    for (std::size_t k = 0; k < 3; ++k) d[k] = end[corner][k] - start[corner][k];
    return d;
  }
};

/// What an engine says about a query.
struct Answer {
  bool known = true;  ///< false: the engine says that it failed
  bool contact = false;
  std::optional<double> time;  ///< of a contact; nothing: the engine gives none
};

inline Answer no_contact() { return {}; }
inline Answer contact_at(double time) { return {true, true, time}; }
inline Answer failed() { return {false, false, {}}; }

struct Question {
  std::string name;
  std::string description;  ///< lines as docs/audit.md explains them, without `question`
  std::function<Answer(const Query&)> ask;
};

/// `--describe` prints the questions; the name of one answers queries until the input ends.
int serve(int argc, char** argv, const std::vector<Question>& questions);

}  // namespace engine
