// SPDX-License-Identifier: MIT
#include "filters/curved/curved_walk.hpp"

#include <algorithm>
#include <cmath>

#include "filters/curved/curved_projection.hpp"
#include "filters/separation/facet.hpp"

namespace touchstone::filters {
namespace {

using numbers::kBoundSlack;
using numbers::kRounding;
using Index = std::size_t;

// Points within a distance d of each other differ by at most |n| d along n, and in the metric max by at most (|n_x| +
// |n_y| + |n_z|) d: 5 roundings of the length, and one each of its products with d and with the scale. The products
// with whole numbers and the sum of two have 2 more.
constexpr double kReach = 1 + 8 * kRounding;

/// Bernstein coefficients over [0, 1]: a quotient's rounding each.
template <Index Dim, Index Size>
double copy(const CurvedForm<Dim>& form, std::array<std::array<double, Size>, Dim>& to) noexcept {
  const auto& b = kBinomial[static_cast<Index>(form.degree)];
  for (Index axis = 0; axis < Dim; ++axis) {
    for (Index k = 0; k <= static_cast<Index>(form.degree); ++k) to[axis][k] = form.c[axis][k] / b[k];
  }
  return form.error + kRounding * form.size;
}

/// The difference of two points as r - s u - q w, from the pairs of corners.
StepAt step_at(Kind kind, const std::array<Vector, 4>& pairs) noexcept {
  StepAt step = {};
  step.r = pairs[0];
  if (kind == Kind::point_point) return step;
  const Vector w = pairs[0] - pairs[1];
  if (kind == Kind::point_edge) {
    step.u = w;
  } else {
    step.u = pairs[0] - pairs[2];
    step.w = w;
  }
  return step;
}

/// n divided by its largest coordinate; false for none.
bool unite(Vector& n) noexcept {
  const double largest = largest_of(n);
  if (!(largest > 0)) return false;
  n = {{n[0] / largest, n[1] / largest, n[2] / largest}};
  return true;
}

}  // namespace

CurvedWalk::CurvedWalk(const CurvedQuery& query, const CurvedFrame& frame, const Separation& separation) noexcept
    : kind_(query.kind), metric_(separation.metric), distance_(frame.factor * separation.distance) {
  if (!(distance_ / frame.factor == separation.distance)) return;
  std::array<VectorForm, 4> forms;
  forms[0] = frame.between;
  pairs_ = 1;
  if (query.kind != Kind::point_point) {
    const VectorForm w = frame.second_multiplier * frame.w;
    forms[pairs_++] = sum(frame.between, w, 1);
    if (query.kind == Kind::vertex_face) {
      forms[pairs_++] = sum(frame.between, frame.second_multiplier * frame.u, 1);
    } else if (query.kind == Kind::edge_edge) {
      const VectorForm u = frame.first_multiplier * frame.u;
      forms[pairs_++] = sum(frame.between, u, -1);
      forms[pairs_++] = sum(forms[1], u, -1);
    }
  }
  ScalarForm scale = frame.first_multiplier * frame.second_multiplier;
  degree_ = scale.degree;
  for (Index i = 0; i < pairs_; ++i) degree_ = std::max(degree_, forms[i].degree);
  if (degree_ > kMostDegree) return;
  scale = elevated(scale, degree_);
  std::array<std::array<double, kSize>, 1> scale_numbers;
  whole_.low = 0;
  whole_.high = 1;
  whole_.scale_error = copy(scale, scale_numbers);
  whole_.scale = scale_numbers[0];
  whole_.error = 0;
  scale_size_ = scale.size;
  for (Index i = 0; i < pairs_; ++i) {
    const VectorForm form = elevated(forms[i], degree_);
    whole_.error = std::max(whole_.error, copy(form, whole_.pairs[i]));
    size_ = std::max(size_, form.size);
  }
  known_ = true;
}

/// `right` is all of a piece at first.
void CurvedWalk::cut(PathPiece& left, PathPiece& right, double fraction) const noexcept {
  for (Index i = 0; i < pairs_; ++i) {
    for (Index axis = 0; axis < 3; ++axis) cut_at(left.pairs[i][axis], right.pairs[i][axis], degree_, fraction);
  }
  cut_at(left.scale, right.scale, degree_, fraction);
  left.error = right.error = right.error + cut_error(degree_, size_);
  left.scale_error = right.scale_error = right.scale_error + cut_error(degree_, scale_size_);
  left.low = right.low;
  left.high = right.low = right.low + fraction * (right.high - right.low);
}

CurvedWalk::Pairs CurvedWalk::pairs_at(const PathPiece& piece, Index k) const noexcept {
  Pairs pairs = {};
  for (Index i = 0; i < pairs_; ++i) {
    for (Index axis = 0; axis < 3; ++axis) pairs[i][axis] = piece.pairs[i][axis][k];
  }
  return pairs;
}

/// About the piece's middle.
CurvedWalk::Pairs CurvedWalk::mean(const PathPiece& piece) const noexcept {
  Pairs result = {};
  const double fraction = 1 / (degree_ + 1.0);
  for (Index i = 0; i < pairs_; ++i) {
    for (Index axis = 0; axis < 3; ++axis) {
      for (Index k = 0; k <= static_cast<Index>(degree_); ++k) result[i][axis] += fraction * piece.pairs[i][axis][k];
    }
  }
  return result;
}

/// About the direction that keeps the elements farthest apart where the pairs are these, and the distance along it.
CurvedWalk::Best CurvedWalk::best(const Pairs& pairs) const noexcept {
  const StepAt step = step_at(kind_, pairs);
  const Domain domain = domain_of(kind_);
  if (metric_ == Metric::max) {
    const auto [facet, distance] = FacetSearch(domain, step).best();
    if (!(distance > 0)) return {{{0, 0, 0}}, 0};
    return {normal_of(facet, step.u, step.w, 0.0, 1.0), distance};
  }
  const Parameters p = closest(domain, step.r, step.u, step.w);
  const Vector c = combined(step.r, step.u, step.w, p.s, p.q);
  return {c, std::sqrt(dot(c, c))};
}

/// Whether the direction shows that the elements are farther apart over the piece.
bool CurvedWalk::separates(const PathPiece& piece, Vector n) const noexcept {
  if (!unite(n)) return false;
  const double reach = kReach * (dual_norm(n, metric_) * distance_);
  const double error = projection_error(piece.error, size_);
  for (Index k = 0; k <= static_cast<Index>(degree_); ++k) {
    const double kept = kBoundSlack * (error + kReach * (reach * (std::max(piece.scale[k], 0.0) + piece.scale_error)));
    for (Index i = 0; i < pairs_; ++i) {
      if (!(projection(n, piece.pairs[i], k) > kept)) return false;
    }
  }
  return true;
}

/// The same for a direction that goes evenly from `m` to `n` over the piece. Its length is at most the number that goes
/// evenly from |m| to |n|. So the difference of a projection and what it must exceed is at least a polynomial of
/// degree 1 more than the pairs have. Its Bernstein coefficients, times that degree, are what is compared here.
bool CurvedWalk::separates_in_turning(const PathPiece& piece, Vector m, Vector n) const noexcept {
  if (!unite(m) || !unite(n)) return false;
  const double m_reach = kReach * (dual_norm(m, metric_) * distance_);
  const double n_reach = kReach * (dual_norm(n, metric_) * distance_);
  const double degree = degree_ + 1;
  const double error = turning_error(degree, piece.error, size_);
  const auto scale = [&](Index k) { return std::max(piece.scale[k], 0.0) + piece.scale_error; };
  for (Index k = 0; k <= static_cast<Index>(degree_) + 1; ++k) {
    const double later = static_cast<double>(k), earlier = degree - later;
    const bool has_m = k <= static_cast<Index>(degree_), has_n = k > 0;
    const double of_m = has_m ? earlier * (m_reach * scale(k)) : 0, of_n = has_n ? later * (n_reach * scale(k - 1)) : 0;
    const double kept = kBoundSlack * (error + kReach * (of_m + of_n));
    for (Index i = 0; i < pairs_; ++i) {
      const auto& x = piece.pairs[i];
      const double first = has_m ? earlier * projection(m, x, k) : 0;
      const double last = has_n ? later * projection(n, x, k - 1) : 0;
      if (!(first + last > kept)) return false;
    }
  }
  return true;
}

bool CurvedWalk::separates_somehow(const PathPiece& piece) const noexcept {
  const Pairs about = mean(piece);
  if (separates(piece, best(about).direction)) return true;
  if (metric_ != Metric::max) return false;
  for (Index axis = 0; axis < 3; ++axis) {
    Vector n = {};
    n[axis] = about[0][axis] < 0 ? -1 : 1;
    if (separates(piece, n)) return true;
  }
  return false;
}

/// Whether they are within the distance of each other at the piece's start or, for k the degree, at its end; a hint.
bool CurvedWalk::seem_near(const PathPiece& piece, Index k) const noexcept {
  return !(best(pairs_at(piece, k)).distance > distance_ * piece.scale[k]);
}

CurvedWalk::Result CurvedWalk::walk(double t_max) const noexcept {
  constexpr Index kMostCuts = 10;
  constexpr int kMostPieces = 48;
  std::array<PathPiece, kMostCuts + 1> pieces;  // still to come, the first one last
  pieces[0] = whole_;
  if (seem_near(whole_, 0)) return {WalkEnd::start, 0, 0};
  if (t_max < 1) {
    PathPiece whole = whole_;
    cut(pieces[0], whole, t_max);
  }
  const Index last = static_cast<Index>(degree_);
  Index count = 1;
  for (int looked_at = 0; count > 0; ++looked_at) {
    PathPiece& piece = pieces[count - 1];
    if (separates_somehow(piece)) {
      --count;
      continue;
    }
    if (count == pieces.size() || looked_at >= kMostPieces) {
      return {seem_near(piece, last) ? WalkEnd::near : WalkEnd::lost, piece.low, piece.high};
    }
    PathPiece& left = pieces[count];
    cut(left, piece, 0.5);
    if (seem_near(piece, 0)) return {WalkEnd::near, left.low, left.high};
    ++count;
  }
  return {WalkEnd::clear, t_max, t_max};
}

bool CurvedWalk::farther_between(double low, double high) const noexcept {
  // Products and quotients of times are off by a few e: the piece is a little longer.
  constexpr double kLonger = 0x1p-48;
  constexpr Index kMostCuts = 16;
  constexpr int kMostPieces = 32;
  std::array<PathPiece, kMostCuts + 1> pieces;
  PathPiece rest = whole_;
  high = std::min(high * (1 + kLonger), 1.0);
  if (!(high > 0)) return false;
  if (high < 1) {
    cut(pieces[0], rest, high);
  } else {
    pieces[0] = whole_;
  }
  const double start = low / high * (1 - kLonger);
  if (start > 0) cut(rest, pieces[0], start);
  const Index last = static_cast<Index>(degree_);
  Index count = 1;
  for (int looked_at = 0; count > 0; ++looked_at) {
    PathPiece& piece = pieces[count - 1];
    const Vector first = best(pairs_at(piece, 0)).direction, second = best(pairs_at(piece, last)).direction;
    if (separates_in_turning(piece, first, second) || separates(piece, second)) {
      --count;
      continue;
    }
    if (count == pieces.size() || looked_at >= kMostPieces) return false;
    cut(pieces[count], piece, 0.5);
    ++count;
  }
  return true;
}

}  // namespace touchstone::filters
