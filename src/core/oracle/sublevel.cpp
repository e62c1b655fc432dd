// Why the times are divided completely. In either metric the distance D is, at every time, one of finitely many
// quotients N_i / Q_i of polynomials with Q_i not zero at that time: the value at a stationary point of a face, or at a
// corner of a linear programme. (For the Euclidean metric, read D squared for D.) The dividing polynomials are
// P_i = N_i - level Q_i. Let D be the level at a time in an open cell, that is, between neighbouring roots. D is
// N_i / Q_i there for some i, so P_i vanishes there and hence everywhere. Suppose that D is not the level everywhere in
// the cell. Then some time of the cell at which D is the level is a limit of times at which it is not, infinitely many
// of them with the same j. P_j is not zero at these. By continuity N_j / Q_j tends to the level, so
// P_j = Q_j (N_j / Q_j - level) tends to zero, and the limit is a root of P_j inside the cell: a contradiction. So D is
// the level everywhere in the cell or nowhere, and if nowhere it stays on one side.
// SPDX-License-Identifier: MIT
#include "oracle/sublevel.hpp"

#include <algorithm>

#include <CGAL/determinant.h>

namespace touchstone::oracle {
namespace {

Polynomial constant(const Integer& value) { return Polynomial(value); }

/// The directions of a face, and its base, as moving vectors.
struct MovingFace {
  Corner base;
  Corner first;
  Corner second;
};

MovingFace moving_face(const DifferencePolygon& polygon, const DifferenceFace& face) {
  MovingFace moving;
  moving.base = polygon.corners[face.corners[0]].position;
  if (face.dimension() >= 1) moving.first = polygon.corners[face.corners[1]].position - moving.base;
  if (face.dimension() >= 2) moving.second = polygon.corners[face.corners[2]].position - moving.base;
  return moving;
}

/// A candidate with the conditions that keep it on its face. Its distance counts as below the level.
Candidate on_face(Kind kind, const DifferenceFace& face, const Polynomial& unit, const Polynomial& s,
                  const Polynomial& t) {
  return {&face, unit, s, t, margins(kind, face.dimension(), unit, s, t), {}, unit};
}

/// `unit` times the candidate's point.
Corner scaled_point(const Candidate& candidate, const MovingFace& face) {
  Corner point = candidate.unit * face.base;
  if (candidate.face->dimension() >= 1) point = point + candidate.s * face.first;
  if (candidate.face->dimension() >= 2) point = point + candidate.t * face.second;
  return point;
}

/// The stationary point of the squared length on a face's line or plane, by Cramer's rule, and `unit` times its squared
/// length. Both are Gram determinants: of the face's directions, and of these and the base.
struct Stationary {
  Candidate point;
  Polynomial scaled_square;
};

Stationary stationary_point(Kind kind, const DifferenceFace& face, const MovingFace& moving) {
  const auto& [x, e, f] = moving;
  const Polynomial zero = constant(0);
  const Polynomial xx = dot(x, x);
  if (face.dimension() == 0) return {on_face(kind, face, constant(1), zero, zero), xx};
  const Polynomial xe = dot(x, e);
  const Polynomial ee = dot(e, e);
  if (face.dimension() == 1) return {on_face(kind, face, ee, -xe, zero), Polynomial(ee * xx - xe * xe)};
  const Polynomial xf = dot(x, f);
  const Polynomial ef = dot(e, f);
  const Polynomial ff = dot(f, f);
  return {
      on_face(kind, face, Polynomial(ee * ff - ef * ef), Polynomial(xf * ef - xe * ff), Polynomial(xe * ef - xf * ee)),
      CGAL::determinant(ee, ef, xe,  //
                        ef, ff, xf,  //
                        xe, xf, xx)};
}

/// The conditions that the coordinates other than those in `tight` are at most the level in absolute value.
void add_bounds(Candidate& candidate, const MovingFace& face, const Polynomial& level,
                std::initializer_list<std::size_t> tight) {
  const Corner point = scaled_point(candidate, face);
  const Polynomial bound = candidate.unit * level;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::find(tight.begin(), tight.end(), k) != tight.end()) continue;
    candidate.nonnegative.push_back(bound - point[k]);
    candidate.nonnegative.push_back(bound + point[k]);
  }
}

/// The corners of the part of a face on which no coordinate exceeds the level, other than those on lower faces. At
/// each, as many coordinates are the level or its opposite as the face has dimensions. `moving` is in the unit of the
/// level.
std::vector<Candidate> corners_within(Kind kind, const DifferenceFace& face, const MovingFace& moving,
                                      const Polynomial& level) {
  const Polynomial zero = constant(0);
  const auto& [x, e, f] = moving;
  std::vector<Candidate> corners;
  if (face.dimension() == 0) {
    corners.push_back(on_face(kind, face, constant(1), zero, zero));
    add_bounds(corners.back(), moving, level, {});
    return corners;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    for (const Polynomial& at_k : {level, Polynomial(-level)}) {
      const Polynomial to_k = at_k - x[k];
      if (face.dimension() == 1) {
        corners.push_back(on_face(kind, face, e[k], to_k, zero));
        add_bounds(corners.back(), moving, level, {k});
        continue;
      }
      const std::size_t l = (k + 1) % 3;
      for (const Polynomial& at_l : {level, Polynomial(-level)}) {
        const Polynomial to_l = at_l - x[l];
        corners.push_back(on_face(kind, face, Polynomial(e[k] * f[l] - e[l] * f[k]),
                                  Polynomial(to_k * f[l] - to_l * f[k]), Polynomial(e[k] * to_l - e[l] * to_k)));
        add_bounds(corners.back(), moving, level, {k, l});
      }
    }
  }
  return corners;
}

}  // namespace

Sublevel euclidean_sublevel(const DifferencePolygon& polygon, const Rational& level, const Polynomial& scale) {
  // The squared length is convex on the polygon, so a point is the closest one exactly when no direction into the
  // polygon shortens it: the Karush-Kuhn-Tucker conditions.
  const Polynomial numerator = constant(level.numerator()) * scale * scale;
  const Polynomial denominator = constant(level.denominator());
  Sublevel sublevel;
  for (const auto& face : polygon.faces) {
    const MovingFace moving = moving_face(polygon, face);
    auto [candidate, scaled_square] = stationary_point(polygon.kind, face, moving);
    const Corner point = scaled_point(candidate, moving);
    for (const std::size_t corner : face.inward) {
      candidate.nonnegative.push_back(dot(point, polygon.corners[corner].position - moving.base));
    }
    candidate.below = numerator * candidate.unit - denominator * scaled_square;
    sublevel.dividing.push_back(candidate.below);
    sublevel.candidates.push_back(std::move(candidate));
  }
  return sublevel;
}

Sublevel max_sublevel(const DifferencePolygon& polygon, const Rational& level, const Polynomial& scale) {
  // The distance is the least h of a linear programme: coordinates between -h and h, parameters on the polygon. It is
  // attained at a corner, where three independent conditions hold with equality. Two that are opposite make h = 0, and
  // a positive level needs no division there; for level 0 their polynomial vanishes identically. The others are the
  // bounds of a point in which, on a face of dimension n, n coordinates are the level or its opposite.
  const Polynomial unit = constant(level.denominator());
  const Polynomial bound = constant(level.numerator()) * scale;
  Sublevel sublevel;
  for (const auto& face : polygon.faces) {
    MovingFace moving = moving_face(polygon, face);
    moving = {unit * moving.base, unit * moving.first, unit * moving.second};
    for (auto& candidate : corners_within(polygon.kind, face, moving, bound)) {
      sublevel.dividing.insert(sublevel.dividing.end(), candidate.nonnegative.begin(), candidate.nonnegative.end());
      sublevel.candidates.push_back(std::move(candidate));
    }
  }
  return sublevel;
}

bool counts(const Candidate& candidate, const Moment& at) {
  const CGAL::Sign unit = at.sign(candidate.unit);
  if (unit == CGAL::ZERO) return false;
  const auto is_positive = [&](const Polynomial& p) { return at.sign(p) == unit; };
  const auto is_nonnegative = [&](const Polynomial& p) { return at.sign(p) != -unit; };
  return std::all_of(candidate.positive.begin(), candidate.positive.end(), is_positive) &&
         std::all_of(candidate.nonnegative.begin(), candidate.nonnegative.end(), is_nonnegative);
}

bool is_within(const Sublevel& sublevel, const Moment& at) {
  const auto closest = std::find_if(sublevel.candidates.begin(), sublevel.candidates.end(),
                                    [&](const Candidate& candidate) { return counts(candidate, at); });
  return closest != sublevel.candidates.end() && at.sign(closest->below) != -at.sign(closest->unit);
}

}  // namespace touchstone::oracle
