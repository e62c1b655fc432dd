// The moves that make a curved query readable.
// SPDX-License-Identifier: MIT
#include <array>
#include <climits>
#include <cmath>
#include <cstddef>
#include <utility>

#include "families/curved_parts.hpp"
#include "fuzz/shrinking/shrink_moves.hpp"
#include "fuzz/shrinking/shrink_numbers.hpp"

namespace touchstone::fuzz {
namespace {

using families::Quaternion;
using families::operator+;
using families::operator-;
using families::operator*;

using ShrinkingCurve = Shrinking<CurvedQuery>;

std::size_t corners_of(const ShrinkingCurve& s) { return corner_count(s.best().kind); }

/// Offers the query that `change` makes of the best one.
template <class Change>
bool offer(ShrinkingCurve& s, Change&& change) {
  CurvedQuery query = s.best();
  change(query);
  return s.offer(query);
}

/// Multiplies all lengths, or all quaternions, by powers of two: to integers, or to ordinary size.
template <class ForEach>
void scale(ShrinkingCurve& s, ForEach&& for_each) {
  int last = INT_MAX, above = INT_MIN;
  CurvedQuery read = s.best();
  for_each(read, [&](double& x) {
    if (x == 0) return;
    int exponent = 0;
    const double significand = std::frexp(x, &exponent);
    int zeros = 0;
    for (auto digit = static_cast<long long>(std::ldexp(significand, 53)); digit % 2 == 0; digit /= 2) ++zeros;
    last = std::min(last, exponent - 53 + zeros);
    above = std::max(above, exponent);
  });
  if (above == INT_MIN) return;
  for (const int shift : {-last, -last - 1, -above, 1 - above, 2 - above, 3 - above}) {
    offer(s, [&](CurvedQuery& query) { for_each(query, [&](double& x) { x = std::ldexp(x, shift); }); });
  }
}

template <class F>
void for_each_component(CurvedQuery& query, F&& f) {
  families::for_each_motion(query, [&](RigidMotion& motion) {
    for (double& c : motion.q0) f(c);
    for (double& c : motion.q1) f(c);
  });
}

void scale_all(ShrinkingCurve& s) {
  scale(s, [](CurvedQuery& query, auto&& f) { families::for_each_length(query, f); });
  scale(s, [](CurvedQuery& query, auto&& f) { for_each_component(query, f); });
}

/// Moves all of space so that a body's origin, or a corner, is at the origin.
void translate(ShrinkingCurve& s) {
  const auto moved = [&](const Vec3& by) {
    offer(s, [&](CurvedQuery& query) {
      for (CurvedCorner& corner : query.corners) {
        if (corner.motion != CurvedCorner::kOnCurve) continue;
        for (Vec3& point : corner.points) point = point - by;
      }
      for (RigidMotion& motion : query.motions) {
        motion.p0 = motion.p0 - by;
        motion.p1 = motion.p1 - by;
      }
    });
  };
  for (std::size_t i = 0; i < 4; ++i) {
    moved(s.best().motions[i].p0);
    moved(s.best().corners[i].points[0]);
  }
}

/// Bodies that do not turn, do not move, or move like the first one; turns from no turn at all.
void simplify_motions(ShrinkingCurve& s) {
  for (std::size_t m = 0; m < 4; ++m) {
    const auto change = [&](auto&& f) { offer(s, [&](CurvedQuery& query) { f(query.motions[m]); }); };
    change([](RigidMotion& motion) { motion = RigidMotion(); });
    change([](RigidMotion& motion) { motion.q0 = motion.q1 = families::kNoTurn; });
    change([](RigidMotion& motion) { motion.q1 = motion.q0; });
    change([](RigidMotion& motion) { motion.q0 = motion.q1; });
    change([](RigidMotion& motion) { motion.q0 = families::kNoTurn; });
    change([](RigidMotion& motion) { motion.q1 = families::kNoTurn; });
    change([](RigidMotion& motion) { motion.p0 = motion.p1 = {}; });
    change([](RigidMotion& motion) { motion.p1 = motion.p0; });
    change([](RigidMotion& motion) { motion.p0 = motion.p1; });
    change([](RigidMotion& motion) { std::swap(motion.q0, motion.q1); });
    for (Quaternion RigidMotion::*const q : {&RigidMotion::q0, &RigidMotion::q1}) {
      change([q](RigidMotion& motion) { motion.*q = -1.0 * (motion.*q); });
    }
    if (m > 0) offer(s, [m](CurvedQuery& query) { query.motions[m] = query.motions[0]; });
  }
}

/// Corners at rest, on straight lines, on the first body, or where another one is.
void simplify_corners(ShrinkingCurve& s) {
  for (std::size_t i = 0; i < corners_of(s); ++i) {
    const auto change = [&](auto&& f) { offer(s, [&](CurvedQuery& query) { f(query, query.corners[i]); }); };
    for (const double t : {0.0, 0.5, 1.0}) {
      change([&](CurvedQuery& query, CurvedCorner& corner) {
        corner = CurvedCorner::on_curve({families::position(query, i, t)});
      });
    }
    change([&](CurvedQuery& query, CurvedCorner& corner) {
      corner = CurvedCorner::on_curve({families::position(query, i, 0), families::position(query, i, 1)});
    });
    change([](CurvedQuery&, CurvedCorner& corner) {
      if (corner.motion > 0) corner.motion = 0;
    });
    for (int points = 3; points > 0; --points) {
      change([points](CurvedQuery&, CurvedCorner& corner) {
        if (corner.control_points > points) corner.control_points = points;
      });
    }
    change([](CurvedQuery&, CurvedCorner& corner) { corner.points = {}; });
    for (std::size_t j = 0; j < i; ++j) {
      change([j](CurvedQuery& query, CurvedCorner& corner) { corner = query.corners[j]; });
      change([j](CurvedQuery& query, CurvedCorner& corner) { corner.points = query.corners[j].points; });
    }
  }
}

/// Rounds all lengths, or all components, to multiples of one power of two.
void round_all(ShrinkingCurve& s) {
  for (const int digits : {1, 2, 3, 4, 5, 6, 8, 10, 14, 20, 28, 40}) {
    const auto rounded = [digits](double& x) {
      int exponent = 0;
      const double significand = std::frexp(x, &exponent);
      x = std::ldexp(std::nearbyint(std::ldexp(significand, digits)), exponent - digits);
    };
    const auto to_grid = [digits](double& x) { x = std::ldexp(std::nearbyint(std::ldexp(x, digits)), -digits); };
    offer(s, [&](CurvedQuery& query) { families::for_each_number(query, rounded); });
    offer(s, [&](CurvedQuery& query) { families::for_each_length(query, rounded); });
    offer(s, [&](CurvedQuery& query) { families::for_each_length(query, to_grid); });
    offer(s, [&](CurvedQuery& query) { for_each_component(query, rounded); });
    offer(s, [&](CurvedQuery& query) { for_each_component(query, to_grid); });
    if (s.over()) return;
  }
}

/// Number `index` of the query.
double& number(CurvedQuery& query, std::size_t index) {
  double* found = &query.motions[0].q0[0];
  std::size_t next = 0;
  families::for_each_number(query, [&](double& x) {
    if (next++ == index) found = &x;
  });
  return *found;
}

std::size_t number_count(const CurvedQuery& query) {
  CurvedQuery read = query;
  std::size_t count = 0;
  families::for_each_number(read, [&](double&) { ++count; });
  return count;
}

void simplify_numbers(ShrinkingCurve& s) {
  for (std::size_t i = 0; i < number_count(s.best()) && !s.over(); ++i) {
    const auto read = [&] {
      CurvedQuery query = s.best();
      return number(query, i);
    };
    simplify_number(read,
                    [&](double value) { return offer(s, [&](CurvedQuery& query) { number(query, i) = value; }); });
  }
}

/// Simplifies one value after the other, at all its occurrences with either sign.
void simplify_values(ShrinkingCurve& s) {
  for (std::size_t i = 0; i < number_count(s.best()) && !s.over(); ++i) {
    const auto read = [&] {
      CurvedQuery query = s.best();
      return std::fabs(number(query, i));
    };
    simplify_number(read, [&](double value) {
      const double old = read();
      if (old == 0) return false;
      return offer(s, [&](CurvedQuery& query) {
        families::for_each_number(query, [&](double& x) {
          if (std::fabs(x) == old) x = std::copysign(1.0, x) * value;
        });
      });
    });
  }
}

/// Moves several random numbers at once to integers or halves near their values or near zero.
void draw_lots(ShrinkingCurve& s) {
  constexpr int kTries = 600;
  for (int i = 0; i < kTries && !s.over(); ++i) {
    CurvedQuery query = s.best();
    const std::size_t count = number_count(query);
    for (int changes = s.rng().between(2, 6); changes > 0; --changes) {
      double& x = number(query, static_cast<std::size_t>(s.rng().below(count)));
      const double near = s.rng().one_in(2) ? x : 0.0;
      const double grid = s.rng().one_in(4) ? 2 : 1;
      x = (std::nearbyint(grid * near) + s.rng().between(-2, 2)) / grid;
    }
    s.offer(query);
  }
}

}  // namespace

template <>
const std::vector<Move<CurvedQuery>>& shrink_moves<CurvedQuery>() {
  static const std::vector<Move<CurvedQuery>> moves{translate,        scale_all, round_all, simplify_motions,
                                                    simplify_corners, scale_all, translate, simplify_values,
                                                    simplify_numbers, draw_lots};
  return moves;
}

}  // namespace touchstone::fuzz
