// SPDX-License-Identifier: MIT
#include "proofs/pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include <touchstone/error.hpp>

#include "filters/apart/separating_direction.hpp"
#include "proofs/directions.hpp"

namespace touchstone::proofs {
namespace {

using filters::RelativeCorners;

DenseVector constant(const DoubleVector& direction) {
  return {{Dense{Exact(direction[0])}, Dense{Exact(direction[1])}, Dense{Exact(direction[2])}}};
}

/// A moving direction n that may keep the elements farther apart than their separation D.
struct Candidate {
  bool normal = false;
  DenseVector direction;

  /// n . (x_j - x_i) times a positive polynomial for each pair of corners; one that has the sign of all, for u x w.
  std::vector<Dense> products;

  /// n . n in the Euclidean metric. In the other one s_0 n_0 + s_1 n_1 + s_2 n_2 for all choices of the signs s, or
  /// for some that decide about all. Empty without a separation.
  std::vector<Dense> norms;
  std::vector<Dense> bounds;  ///< for each product D or D^2 times what x_j - x_i is multiplied by, or its square

  bool separates(const Elements& elements, const Exact& from, const Exact& to, bool open) const {
    const Inner inner = open ? Inner::any_zero : Inner::not_zero;
    const int side = numbers::sign_of(value(products.front(), from));
    if (side == 0) return false;
    if (norms.empty()) {
      return std::all_of(products.begin(), products.end(),
                         [&](const Dense& p) { return sign_over(p, from, to, inner) == side; });
    }
    const bool euclidean = elements.metric == Metric::euclidean;
    for (std::size_t i = 0; i < products.size(); ++i) {
      const Dense& product = products[i];
      if (numbers::sign_of(value(product, from)) != side) return false;
      const Dense left = euclidean ? product * product : side > 0 ? product : -product;
      for (const Dense& norm : norms) {
        if (sign_over(left - bounds[i] * norm, from, to, inner) != 1) return false;
      }
    }
    return true;
  }
};

Candidate candidate_along(const Elements& elements, const DenseVector& direction) {
  Candidate candidate;
  candidate.direction = direction;
  elements.for_each_pair([&](std::size_t i, std::size_t j) {
    candidate.products.push_back(geometry::dot(direction, elements.difference(j, i)));
  });
  return candidate;
}

void add_bounds(const Elements& elements, Candidate& candidate) {
  const DenseVector& n = candidate.direction;
  if (!elements.has_separation()) return;
  const bool euclidean = elements.metric == Metric::euclidean;
  elements.for_each_pair([&](std::size_t i, std::size_t j) {
    const Dense bound = elements.bound(i, j);
    if (candidate.bounds.size() < candidate.products.size())
      candidate.bounds.push_back(euclidean ? bound * bound : bound);
  });
  if (euclidean) {
    candidate.norms = {geometry::dot(n, n)};
    return;
  }
  const bool is_constant = n[0].size() == 1 && n[1].size() == 1 && n[2].size() == 1;
  if (is_constant) {
    Exact sum;
    for (const Dense& p : n.c) sum = sum + (numbers::sign_of(p[0]) < 0 ? -p[0] : p[0]);
    candidate.norms = {Dense{sum}};
    // The others are between it and its negative. Where the bounds have positive Bernstein coefficients, as those of
    // straight motion do, it is enough.
    const auto varies = [](const Dense& weight) { return weight.size() > 1; };
    if (std::any_of(elements.weights.begin(), elements.weights.end(), varies)) candidate.norms.push_back({-sum});
    return;
  }
  for (const double s0 : {1.0, -1.0}) {
    for (const double s1 : {1.0, -1.0}) {
      for (const double s2 : {1.0, -1.0}) {
        candidate.norms.push_back(Exact(s0) * n[0] + Exact(s1) * n[1] + Exact(s2) * n[2]);
      }
    }
  }
}

/// Directions one of which separates over each piece that is short enough, and in the end over the last one before a
/// contact; docs/proofs.md says why. While two features are the closest ones, the difference of their closest points,
/// times a positive polynomial, separates: n for two edges, or a vertex and a face; (e x r) x e for a corner and an
/// edge; r for two corners. In the metric `max`: n, the axes, and the products of an edge and an axis.
std::vector<DenseVector> moving_directions(const Elements& elements) {
  std::vector<DenseVector> directions;
  for (const CornerAndEdge& pair : corners_and_edges(elements.kind)) {
    const DenseVector r = elements.difference(pair.corner, pair.start);
    const DenseVector e = elements.difference(pair.end, pair.start);
    directions.push_back(geometry::cross(geometry::cross(e, r), e));
  }
  elements.for_each_pair([&](std::size_t i, std::size_t j) { directions.push_back(elements.difference(j, i)); });
  if (elements.has_max_separation()) {
    const auto add = [&](const DenseVector& edge) {
      for (const DoubleVector& axis : kAxes) directions.push_back(geometry::cross(edge, constant(axis)));
    };
    const std::size_t second = elements.count - elements.first_count;  // the number of its corners
    if (elements.first_count == 2) add(elements.difference(1, 0));
    if (second >= 2) add(elements.difference(elements.first_count + 1, elements.first_count));
    if (second == 3) {
      add(elements.difference(elements.first_count + 2, elements.first_count));
      add(elements.difference(elements.first_count + 2, elements.first_count + 1));
    }
  }
  return directions;
}

/// The search on one query.
class PieceSearch {
 public:
  explicit PieceSearch(const Elements& elements) : elements_(elements) {
    if (!elements.has_normal()) return;
    const auto frame = elements.frame();
    Candidate normal;
    normal.normal = true;
    normal.direction = geometry::normal(frame);
    normal.products = {geometry::dot(normal.direction, frame.r)};
    add_bounds(elements, normal);
    normal_ = std::make_shared<Candidate>(std::move(normal));
  }

  using Found = std::shared_ptr<const Candidate>;

  bool separates(const Found& candidate, const Exact& from, const Exact& to, bool open) const {
    return candidate->separates(elements_, from, to, open);
  }

  /// A direction that separates over the piece; null when none is found.
  Found direction(const Exact& from, const Exact& to, bool open) {
    if (normal_ && separates(normal_, from, to, open)) return normal_;
    if (Found found = constant_direction(from, to, open)) return found;
    if (moving_.empty()) {
      for (const DenseVector& direction : moving_directions(elements_)) {
        Candidate candidate = candidate_along(elements_, direction);
        add_bounds(elements_, candidate);
        moving_.push_back(std::make_shared<Candidate>(std::move(candidate)));
      }
    }
    for (const Found& candidate : moving_) {
      if (separates(candidate, from, to, open)) return candidate;
    }
    return nullptr;
  }

 private:
  Found constant_direction(const Exact& from, const Exact& to, bool open) const {
    const auto tried = [&](const DoubleVector& direction) -> Found {
      Candidate candidate = candidate_along(elements_, constant(direction));
      add_bounds(elements_, candidate);
      if (!candidate.separates(elements_, from, to, open)) return nullptr;
      return std::make_shared<Candidate>(std::move(candidate));
    };
    const RelativeCorners corners = relative_corners(from, to);
    for (const DoubleVector& direction :
         {filters::between_closest_points(corners, elements_.kind), filters::between_centres(corners)}) {
      const filters::Gap gap = filters::gap_along(corners, direction);
      if (!(gap.value > -gap.error)) continue;  // the rounded corners are too far off
      Found found;
      const auto try_one = [&](const DoubleVector& integers) {
        const filters::Gap of_integers = filters::gap_along(corners, integers);
        return of_integers.value > -of_integers.error && (found = tried(integers)) != nullptr;
      };
      if (try_rounded(direction, try_one)) return found;
    }
    if (elements_.has_max_separation()) {
      for (const DoubleVector& axis : kAxes) {
        if (Found found = tried(axis)) return found;
      }
    }
    return nullptr;
  }

  /// The corners at the ends of the piece, in doubles, which are a hint only.
  RelativeCorners relative_corners(const Exact& from, const Exact& to) const {
    RelativeCorners corners;
    corners.count = elements_.count;
    corners.first_count = elements_.first_count;
    corners.largest = 0;
    for (std::size_t i = 0; i < elements_.count; ++i) {
      const DenseVector relative = elements_.difference(i, 0);
      const Dense scale = elements_.scale(i, 0);
      const auto at = [&](std::size_t k, const Exact& time) {
        return numbers::to_double(value(relative[k], time)) / numbers::to_double(value(scale, time));
      };
      for (std::size_t k = 0; k < 3; ++k) {
        corners.start[i][k] = at(k, from);
        corners.end[i][k] = at(k, to);
        corners.largest = std::max({corners.largest, std::fabs(corners.start[i][k]), std::fabs(corners.end[i][k])});
      }
    }
    return corners;
  }

  const Elements& elements_;
  Found normal_;
  std::vector<Found> moving_;
};

/// A piece of the search: its direction separates over [from, to].
struct DirectedInterval {
  PieceSearch::Found direction;
  Exact from, to;
};

/// Adds an interval after the last one. Where one direction serves for both, they become one interval. So the cuts
/// towards an event leave few intervals.
void append(const PieceSearch& search, std::vector<DirectedInterval>& intervals, DirectedInterval interval, bool open) {
  while (!intervals.empty()) {
    DirectedInterval& before = intervals.back();
    if (search.separates(before.direction, before.from, interval.to, open)) {
      interval.direction = before.direction;
    } else if (!search.separates(interval.direction, before.from, interval.to, open)) {
      break;
    }
    interval.from = before.from;
    intervals.pop_back();
  }
  intervals.push_back(std::move(interval));
}

/// Where a piece is cut: in the middle; between times of very different size, in the middle of their exponents. So an
/// event at 2^-1000 is reached in few steps.
Exact cut(const Exact& from, const Exact& to) {
  const long high = numbers::approximate(to).exponent;
  const long low = from.is_zero() ? 2 * high : numbers::approximate(from).exponent;
  constexpr long kOrdinary = 8;
  return high - low > kOrdinary ? numbers::power_of_two(low + (high - low) / 2) : (from + to) * Exact(0.5);
}

}  // namespace

std::vector<Piece> separating_pieces(const Elements& elements, const Exact& end, bool open,
                                     const std::function<bool()>& is_true) {
  // Two events that are 2^-k apart need about k bisections. Without a contact the search ends; with one it would not.
  constexpr int kLongSearch = 500;
  PieceSearch search(elements);
  std::vector<DirectedInterval> intervals;
  Exact from(0);
  std::vector<Exact> ends = {end};  // of the intervals to come, the next one last
  int bisections = 0;
  while (!ends.empty()) {
    const Exact to = ends.back();
    const bool last = ends.size() == 1;
    if (PieceSearch::Found direction = search.direction(from, to, open && last)) {
      append(search, intervals, {std::move(direction), from, to}, open && last);
      from = to;
      ends.pop_back();
    } else {
      if (from == to || (++bisections == kLongSearch && !is_true())) {
        throw Error("the elements are in contact: there is no proof that they are not");
      }
      ends.push_back(cut(from, to));
    }
  }
  std::vector<Piece> pieces;
  for (const DirectedInterval& interval : intervals) {
    Piece& piece = pieces.emplace_back();
    piece.normal = interval.direction->normal;
    if (!piece.normal) piece.direction = interval.direction->direction;
    piece.until = interval.to;
  }
  return pieces;
}

}  // namespace touchstone::proofs
