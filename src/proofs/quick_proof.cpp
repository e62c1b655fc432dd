// SPDX-License-Identifier: MIT
#include "proofs/quick_proof.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

#include "filters/apart/same_side.hpp"
#include "filters/apart/separating_direction.hpp"
#include "filters/bernstein_cubic.hpp"
#include "proofs/directions.hpp"
#include "proofs/quick_contact.hpp"

namespace touchstone::proofs {
namespace {

using filters::RelativeCorners;

/// The corners as they are from one time to another one. Each coordinate is an interpolation of two that are off by e
/// M, with e = 2^-53 and M the largest one: 1 - s is exact or has 1 rounding, both products have 1, and their sum has
/// 1. So it is off by at most 4 e M to first order, where gap_along counts with 1 e M: a projection, by 12 + 9 in place
/// of 12 e D M, and the difference of two by 6 e D M more. Twice its bound of 3 * 13 e D M is enough for these 48 e D
/// M. No product underflows by more than 2^-1075, which is nothing beside e M.
RelativeCorners corners_between(const RelativeCorners& whole, double from, double to) {
  RelativeCorners corners = whole;
  for (std::size_t i = 0; i < whole.count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = whole.start[i][k];
      const double b = whole.end[i][k];
      if (from > 0) corners.start[i][k] = (1 - from) * a + from * b;
      if (to < 1) corners.end[i][k] = (1 - to) * a + to * b;
    }
  }
  return corners;
}
constexpr double kErrorFactor = 2;
constexpr double kLeastCoordinate = 0x1p-900;

/// A search for pieces in doubles.
class QuickSearch {
 public:
  QuickSearch(const Query& query, const Separation& separation)
      : kind_(query.kind), separation_(separation), corners_(filters::relative_corners(query)) {
    if (separation.distance > 0 || !filters::has_cubic(kind_)) return;
    const auto frame = filters::frame_of(query);
    const double uw = filters::largest(frame.start.u, frame.end.u) * filters::largest(frame.start.w, frame.end.w);
    const double uwr = uw * filters::largest(frame.start.r, frame.end.r);
    if (filters::products_in_range(uw, uwr)) cubic_.emplace(filters::coplanarity_coefficients(frame), uwr);
  }

  /// Pieces that cover [0, 1]; none where a few do not.
  std::vector<Piece> pieces() {
    constexpr std::size_t kMostIntervals = 4;
    constexpr double kShortest = 0x1p-36;
    constexpr int kMostTries = 80;  // they cost little beside a search in exact numbers
    if (!(corners_.largest >= kLeastCoordinate)) return {};
    std::vector<Subinterval> intervals;
    double from = 0;
    double to = 1;
    std::vector<double> ends;  // of the intervals after `to`, the next one last
    for (int tries = 0;; ++tries) {
      if (tries == kMostTries) return {};
      if (const auto direction = direction_over(from, to)) {
        append(intervals, {*direction, from, to});
        if (intervals.size() > kMostIntervals) return {};
        if (ends.empty()) break;
        from = to;
        to = ends.back();
        ends.pop_back();
      } else {
        if (to - from <= kShortest) return {};
        ends.push_back(to);
        to = 0.5 * (from + to);
      }
    }
    std::vector<Piece> pieces;
    for (const Subinterval& interval : intervals) {
      Piece& piece = pieces.emplace_back();
      piece.normal = interval.direction.normal;
      for (std::size_t k = 0; k < 3 && !piece.normal; ++k) piece.direction[k] = {Exact(interval.direction.integers[k])};
      piece.until = Exact(interval.to);
    }
    return pieces;
  }

 private:
  struct Subinterval {
    QuickDirection direction;
    double from, to;
  };

  /// Where one direction serves for two intervals, they become one.
  void append(std::vector<Subinterval>& intervals, Subinterval interval) const {
    while (!intervals.empty()) {
      const Subinterval& before = intervals.back();
      if (separates(before.direction, before.from, interval.to)) {
        interval.direction = before.direction;
      } else if (!separates(interval.direction, before.from, interval.to)) {
        break;
      }
      interval.from = before.from;
      intervals.pop_back();
    }
    intervals.push_back(interval);
  }

  bool separates(const QuickDirection& direction, double from, double to) const {
    if (direction.normal) return normal_separates(from, to);
    return separates(corners_between(corners_, from, to), DoubleVector{direction.integers});
  }

  bool normal_separates(double from, double to) const {
    if (!cubic_) return false;
    const auto b = cubic_->restricted_to(from, to);
    const double error = cubic_->restriction_error();
    if (!(std::fabs(b[0]) > error)) return false;
    return filters::flipped(b[1], b[0]) > error && filters::flipped(b[2], b[0]) > error &&
           filters::flipped(b[3], b[0]) > error;
  }

  /// A direction n of integers. Along it the elements must be more than D |n| apart, in the norm that belongs to the
  /// metric.
  bool separates(const RelativeCorners& corners, const DoubleVector& integers) const {
    constexpr double kRoundings = 1 + 0x1p-40;  // of the norm, the product and the sums
    const filters::Gap gap = filters::gap_along(corners, integers);
    if (separation_.distance == 0) return gap.value > kErrorFactor * gap.error;
    const double norm = separation_.metric == Metric::euclidean
                            ? std::sqrt(geometry::dot(integers, integers))
                            : std::fabs(integers[0]) + std::fabs(integers[1]) + std::fabs(integers[2]);
    const double least = (kErrorFactor * gap.error + separation_.distance * norm) * kRoundings;
    return gap.value > least + std::numeric_limits<double>::min();
  }

  std::optional<QuickDirection> direction_over(double from, double to) const {
    if (normal_separates(from, to)) return QuickDirection{true, {}};
    const RelativeCorners corners = corners_between(corners_, from, to);
    std::optional<QuickDirection> found;
    const auto try_one = [&](const DoubleVector& integers) {
      if (!separates(corners, integers)) return false;
      found = QuickDirection{false, integers.c};
      return true;
    };
    if (try_rounded(filters::between_closest_points(corners, kind_), try_one)) return found;
    if (separation_.distance == 0) return std::nullopt;
    if (separation_.metric == Metric::max) {
      for (const DoubleVector& axis : kAxes) {
        if (try_one(axis)) return found;
      }
    }
    if (filters::has_cubic(kind_)) try_rounded(filters::normal_at_mid_step(corners, kind_), try_one);
    return found;
  }

  Kind kind_;
  Separation separation_;
  RelativeCorners corners_;
  std::optional<filters::BernsteinCubic> cubic_;  ///< V; none with a separation
};

}  // namespace

std::optional<QuickDirection> quick_direction(const Query& query, const Separation& separation) {
  const bool touching = separation.distance == 0;
  // The Bernstein coefficients of V^2 are means of products of V's, and those of n . n, also when it counts as one of
  // the same degree, are means of products of n's. So where each of V's exceeds D times the norm of each of n's, the
  // polynomials of the check have positive coefficients.
  if (touching ? filters::same_side(query) : filters::clear_all_along(query, separation)) {
    return QuickDirection{true, {}};
  }
  const RelativeCorners corners = filters::relative_corners(query);
  std::optional<QuickDirection> found;
  const auto try_one = [&](const DoubleVector& direction) {
    const bool separates =
        touching ? filters::separates(corners, direction) : filters::separates_by(corners, direction, separation);
    if (separates) found = QuickDirection{false, direction.c};
    return separates;
  };
  if (try_rounded(filters::between_closest_points(corners, query.kind), try_one)) return found;
  if (touching) return std::nullopt;
  if (separation.metric == Metric::max) {
    for (const DoubleVector& axis : kAxes) {
      if (try_one(axis)) return found;
    }
  }
  if (filters::has_cubic(query.kind)) try_rounded(filters::normal_at_mid_step(corners, query.kind), try_one);
  return found;
}

std::optional<Proof> quick_proof(const Query& query, const Answer& answer, const Separation& separation) {
  std::optional<Proof> proof;
  if (!answer.contact) {
    auto pieces = QuickSearch(query, separation).pieces();
    if (pieces.empty()) return std::nullopt;
    proof.emplace().pieces = std::move(pieces);
  } else {
    proof = quick_contact(query, answer, separation);
  }
  if (proof) shorten(query.kind, Factors::powers_of_two, *proof);
  return proof;
}

void shorten(Kind kind, Factors factors, Proof& proof) {
  const auto remove = [factors](std::initializer_list<Dense*> polynomials) {
    factors == Factors::all ? remove_common_factor(polynomials) : make_short_integers(polynomials);
  };
  for (Piece& piece : proof.pieces) {
    auto& n = piece.direction;
    remove({&n[0], &n[1], &n[2]});
  }
  if (!proof.meeting) return;
  remove({&proof.meeting->root});
  auto& w = proof.meeting->weights;
  if (kind == Kind::edge_edge) {
    remove({&w[0], &w[1]});
    remove({&w[2], &w[3]});
  } else {
    remove({&w[0]});
    remove({&w[1], &w[2], &w[3]});
  }
}

}  // namespace touchstone::proofs
