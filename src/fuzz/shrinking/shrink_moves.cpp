// SPDX-License-Identifier: MIT
#include "fuzz/shrinking/shrink_moves.hpp"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstddef>
#include <utility>

#include "families/linear_motion.hpp"
#include "fuzz/shrinking/shrink_numbers.hpp"

namespace touchstone::fuzz {
namespace {

using families::coordinate;
using families::mapped_corners;
using families::operator+;
using families::operator-;

using StraightShrinking = Shrinking<Query>;

constexpr std::array<std::size_t, 3> kAxes{0, 1, 2};

/// The sets of axes that a move may change: all axes, and each axis alone.
constexpr std::array<std::array<bool, 3>, 4> kAxisSets{
    {{true, true, true}, {true, false, false}, {false, true, false}, {false, false, true}}};

std::size_t corners_of(const StraightShrinking& s) { return corner_count(s.best().kind); }

/// The exponents of the last binary digit and of the power of two above the largest coordinate, over some axes.
struct Digits {
  int last = INT_MAX;
  int above = INT_MIN;
};

Digits digits_of(const Query& query, const std::array<bool, 3>& axes) {
  Digits digits;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    for (const Vec3& corner : {query.start[i], query.end[i]}) {
      for (const std::size_t axis : kAxes) {
        const double x = coordinate(corner, axis);
        if (!axes[axis] || x == 0) continue;
        int exponent = 0;
        const double significand = std::frexp(x, &exponent);
        int last = exponent - 53;
        for (auto digit = static_cast<long long>(std::ldexp(significand, 53)); digit % 2 == 0; digit /= 2) ++last;
        digits.last = std::min(digits.last, last);
        digits.above = std::max(digits.above, exponent);
      }
    }
  }
  return digits;
}

template <class F>
Query mapped_axes(const Query& query, const std::array<bool, 3>& axes, F&& f) {
  return mapped_corners(query, [&](Vec3 corner) {
    for (const std::size_t axis : kAxes) {
      if (axes[axis]) coordinate(corner, axis) = f(coordinate(corner, axis));
    }
    return corner;
  });
}

/// Multiplies by powers of two: to integers, to halves, or to ordinary size.
void scale(StraightShrinking& s) {
  for (const auto& axes : kAxisSets) {
    const Digits digits = digits_of(s.best(), axes);
    if (digits.above == INT_MIN) continue;
    for (const int shift : {-digits.last, -digits.last - 1, -digits.above, 1 - digits.above, 2 - digits.above,
                            3 - digits.above, 4 - digits.above}) {
      s.offer(mapped_axes(s.best(), axes, [&](double x) { return std::ldexp(x, shift); }));
    }
  }
}

/// Moves a corner to the origin: at both ends together, or at each end with all corners there.
void translate(StraightShrinking& s) {
  for (std::size_t i = 0; i < corners_of(s); ++i) {
    for (const auto& axes : kAxisSets) {
      const auto masked = [&](Vec3 v) {
        for (const std::size_t axis : kAxes) {
          if (!axes[axis]) coordinate(v, axis) = 0;
        }
        return v;
      };
      const auto moved = [&](const Vec3& start, const Vec3& end) {
        Query query = s.best();
        for (std::size_t j = 0; j < corners_of(s); ++j) {
          query.start[j] = query.start[j] - masked(start);
          query.end[j] = query.end[j] - masked(end);
        }
        return query;
      };
      s.offer(moved(s.best().start[i], s.best().start[i]));
      s.offer(moved(s.best().end[i], s.best().end[i]));
      s.offer(moved(s.best().start[i], s.best().end[i]));
      s.offer(moved({}, s.best().end[i] - s.best().start[i]));
    }
  }
}

/// Rounds every coordinate to a multiple of one power of two, or to a few digits of its own: to the nearest, towards
/// zero, or at random up or down.
void round_all(StraightShrinking& s) {
  constexpr int kLots = 8;
  for (const int digits : {1, 2, 3, 4, 5, 6, 8, 10, 14, 20, 28, 40}) {
    for (const auto& axes : kAxisSets) {
      const int above = digits_of(s.best(), axes).above;
      if (above == INT_MIN) continue;
      const auto rounded = [&](double x, auto&& to_integer) {
        return std::ldexp(to_integer(std::ldexp(x, digits - above)), above - digits);
      };
      const auto offer = [&](auto&& to_integer) {
        return s.offer(mapped_axes(s.best(), axes, [&](double x) { return rounded(x, to_integer); }));
      };
      offer([](double x) { return std::nearbyint(x); });
      offer([](double x) { return std::trunc(x); });
      for (int lot = 0; lot < kLots; ++lot) {
        if (offer([&](double x) { return s.rng().one_in(2) ? std::floor(x) : std::ceil(x); })) break;
      }
    }
    s.offer(mapped_axes(s.best(), kAxisSets[0], [&](double x) {
      int exponent = 0;
      const double significand = std::frexp(x, &exponent);
      return std::ldexp(std::nearbyint(std::ldexp(significand, digits)), exponent - digits);
    }));
    if (s.over()) return;
  }
}

void stand_still(StraightShrinking& s) {
  Query query = s.best();
  query.end = query.start;
  s.offer(query);
  for (std::size_t i = 0; i < corners_of(s); ++i) {
    query = s.best();
    query.end[i] = query.start[i];
    s.offer(query);
    query = s.best();
    query.start[i] = query.end[i];
    s.offer(query);
  }
}

/// Moves corners onto others or the origin, or gives them the motion of others.
void merge(StraightShrinking& s) {
  const auto offer = [&](std::size_t i, const Vec3& start, const Vec3& end) {
    Query query = s.best();
    query.start[i] = start;
    query.end[i] = end;
    s.offer(query);
  };
  for (std::size_t i = 0; i < corners_of(s); ++i) {
    const auto start = [&](std::size_t j) { return s.best().start[j]; };
    const auto end = [&](std::size_t j) { return s.best().end[j]; };
    offer(i, {}, {});
    offer(i, {}, end(i));
    offer(i, start(i), {});
    for (std::size_t j = 0; j < corners_of(s); ++j) {
      if (j == i) continue;
      offer(i, start(j), end(j));
      offer(i, start(j), end(i));
      offer(i, start(i), end(j));
      offer(i, start(i), start(i) + (end(j) - start(j)));
    }
  }
}

/// Changes whole axes: to zero, without motion, mirrored. Reverses time.
void simplify_axes(StraightShrinking& s) {
  for (const std::size_t axis : kAxes) {
    std::array<bool, 3> only{};
    only[axis] = true;
    s.offer(mapped_axes(s.best(), only, [](double) { return 0.0; }));
    s.offer(mapped_axes(s.best(), only, [](double x) { return 0.0 - x; }));
    Query query = s.best();
    for (std::size_t i = 0; i < corners_of(s); ++i) coordinate(query.end[i], axis) = coordinate(query.start[i], axis);
    s.offer(query);
  }
  Query reversed = s.best();
  std::swap(reversed.start, reversed.end);
  s.offer(reversed);
}

/// Simplifies one coordinate after the other, at one end or at both.
void simplify_coordinates(StraightShrinking& s) {
  enum class End { start, end, both };
  for (std::size_t i = 0; i < corners_of(s); ++i) {
    for (const std::size_t axis : kAxes) {
      for (const End end : {End::both, End::start, End::end}) {
        const auto offer = [&](double value) {
          Query query = s.best();
          if (end != End::end) coordinate(query.start[i], axis) = value;
          if (end != End::start) coordinate(query.end[i], axis) = value;
          return s.offer(query);
        };
        const auto number = [&] { return coordinate((end == End::end ? s.best().end : s.best().start)[i], axis); };
        simplify_number(number, offer);
        for (std::size_t j = 0; j < corners_of(s); ++j) {
          offer(coordinate(s.best().start[j], axis));
          offer(coordinate(s.best().end[j], axis));
        }
        if (s.over()) return;
      }
    }
  }
}

/// Simplifies one value after the other, at all its occurrences with either sign.
void simplify_values(StraightShrinking& s) {
  for (std::size_t i = 0; i < corners_of(s); ++i) {
    for (const std::size_t axis : kAxes) {
      for (const bool at_start : {true, false}) {
        const auto number = [&] { return std::fabs(coordinate((at_start ? s.best().start : s.best().end)[i], axis)); };
        simplify_number(number, [&](double value) {
          const double old = number();
          if (old == 0) return false;
          return s.offer(mapped_axes(s.best(), kAxisSets[0], [&](double x) {
            return std::fabs(x) == old ? std::copysign(1.0, x) * value : x;
          }));
        });
        if (s.over()) return;
      }
    }
  }
}

/// Sets one coordinate of a corner at both ends to pairs of small integers.
void simplify_pairs(StraightShrinking& s) {
  constexpr int kReach = 2;
  for (std::size_t i = 0; i < corners_of(s); ++i) {
    for (const std::size_t axis : kAxes) {
      for (int start = -kReach; start <= kReach; ++start) {
        for (int end = -kReach; end <= kReach; ++end) {
          Query query = s.best();
          coordinate(query.start[i], axis) = start;
          coordinate(query.end[i], axis) = end;
          s.offer(query);
        }
      }
      if (s.over()) return;
    }
  }
}

/// Moves several random coordinates at once to integers or halves near their values or near zero.
void draw_lots(StraightShrinking& s) {
  constexpr int kTries = 600;
  for (int i = 0; i < kTries && !s.over(); ++i) {
    Query query = s.best();
    for (int changes = s.rng().between(2, 6); changes > 0; --changes) {
      auto& corners = s.rng().one_in(2) ? query.start : query.end;
      double& x = coordinate(corners[s.rng().below(corners_of(s))], static_cast<std::size_t>(s.rng().below(3)));
      const double near = s.rng().one_in(2) ? x : 0.0;
      const double grid = s.rng().one_in(4) ? 2 : 1;
      x = (std::nearbyint(grid * near) + s.rng().between(-2, 2)) / grid;
    }
    s.offer(query);
  }
}

}  // namespace

template <>
const std::vector<Move<Query>>& shrink_moves<Query>() {
  static const std::vector<Move<Query>> moves{translate,      scale,           round_all,
                                              scale,          stand_still,     merge,
                                              simplify_axes,  simplify_values, simplify_coordinates,
                                              simplify_pairs, draw_lots};
  return moves;
}

}  // namespace touchstone::fuzz
