// Directions that keep two elements on curves apart, each for a piece of the step.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <touchstone/curved_query.hpp>
#include <touchstone/separation.hpp>

#include "filters/curved/curved_frame.hpp"
#include "filters/separation/entry_walk.hpp"

namespace touchstone::filters {

/// The way of two elements through the step, as far as directions show that they are farther from each other than a
/// separation >= 0.
class CurvedWalk {
 public:
  /// @param frame  of the query, known
  CurvedWalk(const CurvedQuery& query, const CurvedFrame& frame, const Separation& separation) noexcept;

  /// False where degrees or sizes are out of range: then nothing else may be asked.
  bool known() const noexcept { return known_; }
  /// The separation's distance times the frame's factor.
  double distance() const noexcept { return distance_; }

  /// How a walk through [0, t_max] ends. `near`: the elements are farther from each other up to about `low`, which is
  /// off by a few roundings, and they seem to be within the separation at `high`.
  struct Result {
    WalkEnd end;
    double low, high;
  };
  Result walk(double t_max) const noexcept;

  /// Whether the elements are farther from each other at all times between, and a few roundings around. They must seem
  /// to be so.
  bool farther_between(double low, double high) const noexcept;

 private:
  static constexpr int kMostDegree = 6;
  static constexpr std::size_t kSize = kMostDegree + 1;

  /// The corners of the second element minus those of the first, and the scale that they are multiplied by, over a
  /// piece of the step, in the Bernstein basis.
  struct PathPiece {
    double low, high;
    std::array<std::array<std::array<double, kSize>, 3>, 4> pairs;  // B - A first
    std::array<double, kSize> scale;
    double error;  // of the pairs
    double scale_error;
  };
  using Pairs = std::array<Vector, 4>;
  struct Best {
    Vector direction;
    double distance;
  };

  Pairs pairs_at(const PathPiece& piece, std::size_t k) const noexcept;
  Pairs mean(const PathPiece& piece) const noexcept;
  void cut(PathPiece& left, PathPiece& right, double fraction) const noexcept;
  Best best(const Pairs& pairs) const noexcept;
  bool separates(const PathPiece& piece, Vector n) const noexcept;
  bool separates_in_turning(const PathPiece& piece, Vector m, Vector n) const noexcept;
  bool separates_somehow(const PathPiece& piece) const noexcept;
  bool seem_near(const PathPiece& piece, std::size_t k) const noexcept;

  Kind kind_;
  Metric metric_;
  bool known_ = false;
  int degree_ = 0;
  std::size_t pairs_ = 0;
  double size_ = 0;        // of the pairs' coefficients
  double scale_size_ = 0;  // of the scale's
  double distance_ = 0;
  PathPiece whole_;
};

/// Whether directions, each for a piece of the step, show that the elements are farther from each other than a
/// separation >= 0 at all times in [0, t_max].
/// @param frame  of the query, known
inline bool certainly_farther_in_pieces(const CurvedQuery& query, const CurvedFrame& frame,
                                        const Separation& separation, double t_max) noexcept {
  const CurvedWalk walk(query, frame, separation);
  return walk.known() && walk.walk(t_max).end == WalkEnd::clear;
}

}  // namespace touchstone::filters
