// SPDX-License-Identifier: MIT
#include "proofs/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <touchstone/error.hpp>

#include "filters/same_side.hpp"
#include "filters/separating_direction.hpp"

namespace touchstone::proofs {
namespace {

using filters::RelativeCorners;
using DoubleVector = filters::Vector;

/// Bits of the coordinates of a direction: few first, because they make short proofs.
constexpr int kDirectionBits[] = {7, 20, 52};

/// The direction with integer coordinates below 2^bits in place of its own; nothing for one that is zero or not finite.
std::optional<DoubleVector> rounded(const DoubleVector& direction, int bits) {
  const double largest = std::max({std::fabs(direction[0]), std::fabs(direction[1]), std::fabs(direction[2])});
  if (!(largest > 0) || !(largest < HUGE_VAL)) return std::nullopt;
  int exponent;
  std::frexp(largest, &exponent);
  DoubleVector result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = std::nearbyint(std::ldexp(direction[k], bits - exponent));
  return result;
}

DenseVector constant(const DoubleVector& direction) {
  return {Dense{Exact(direction[0])}, Dense{Exact(direction[1])}, Dense{Exact(direction[2])}};
}

/// A moving direction that may separate the elements, with its product with each difference of two corners.
struct Candidate {
  bool normal = false;
  DenseVector direction;
  std::vector<Dense> products;

  bool separates(const Exact& from, const Exact& to, bool open) const {
    int side = 0;
    for (const Dense& product : products) {
      const int sign = sign_over(product, from, to, open);
      if (sign == 0 || sign == -side) return false;
      side = sign;
    }
    return true;
  }
};

std::vector<Dense> products_with(const Elements& elements, const DenseVector& direction) {
  std::vector<Dense> products;
  for (std::size_t i = 0; i < elements.first; ++i) {
    for (std::size_t j = elements.first; j < elements.count; ++j) {
      products.push_back(dot(direction, elements.corners[j] - elements.corners[i]));
    }
  }
  return products;
}

/// While two features are the closest ones, the difference of their closest points, times a positive polynomial,
/// separates the elements: n for two edges, or a vertex and a face; (e x r) x e for a corner and an edge; r for two
/// corners. So, as the pieces get shorter, one of these separates over each of them, and in the end over the last one
/// before a contact (see docs/proofs.md).
std::vector<Candidate> moving_candidates(const Elements& elements) {
  std::vector<Candidate> candidates;
  const auto add = [&](const DenseVector& direction) {
    Candidate candidate;
    candidate.direction = direction;
    candidate.products = products_with(elements, direction);
    candidates.push_back(std::move(candidate));
  };
  for (const CornerAndEdge& pair : corners_and_edges(elements.kind)) {
    const DenseVector r = elements.corners[pair.corner] - elements.corners[pair.start];
    const DenseVector e = elements.corners[pair.end] - elements.corners[pair.start];
    add(cross(cross(e, r), e));
  }
  for (std::size_t i = 0; i < elements.first; ++i) {
    for (std::size_t j = elements.first; j < elements.count; ++j) add(elements.corners[j] - elements.corners[i]);
  }
  return candidates;
}

/// The search on one query.
class Search {
 public:
  explicit Search(const Elements& elements) : elements_(elements) {
    if (!elements.has_normal()) return;
    normal_.normal = true;
    normal_.products = {dot(cross(elements.u(), elements.w()), elements.r())};
  }

  /// A piece that ends at `to`, if one is found.
  std::optional<Piece> piece(const Exact& from, const Exact& to, bool open) {
    if (elements_.has_normal() && normal_.separates(from, to, open)) {
      Piece piece;
      piece.normal = true;
      piece.until = to;
      return piece;
    }
    if (auto piece = constant_piece(from, to, open)) return piece;
    if (moving_.empty()) moving_ = moving_candidates(elements_);
    for (const Candidate& candidate : moving_) {
      if (candidate.separates(from, to, open)) return Piece{false, candidate.direction, to};
    }
    return std::nullopt;
  }

 private:
  std::optional<Piece> constant_piece(const Exact& from, const Exact& to, bool open) const {
    const RelativeCorners corners = relative_corners(from, to);
    for (const DoubleVector& direction :
         {filters::between_closest_points(corners, elements_.kind), filters::between_centres(corners)}) {
      const filters::Gap gap = filters::gap_along(corners, direction);
      if (!(gap.value > -gap.error)) continue;  // the rounded corners are too far off
      for (const int bits : kDirectionBits) {
        const auto integers = rounded(direction, bits);
        if (!integers) break;
        Candidate candidate;
        candidate.direction = constant(*integers);
        candidate.products = products_with(elements_, candidate.direction);
        if (candidate.separates(from, to, open)) return Piece{false, candidate.direction, to};
      }
    }
    return std::nullopt;
  }

  /// The corners at the ends of the piece, in doubles, which are a hint only.
  RelativeCorners relative_corners(const Exact& from, const Exact& to) const {
    RelativeCorners corners;
    corners.count = elements_.count;
    corners.first_count = elements_.first;
    corners.largest = 0;
    const DenseVector& origin = elements_.corners[0];
    for (std::size_t i = 0; i < elements_.count; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Exact zero = value(origin[k], from);
        corners.start[i][k] = numbers::to_double(value(elements_.corners[i][k], from) - zero);
        corners.end[i][k] = numbers::to_double(value(elements_.corners[i][k], to) - zero);
        corners.largest = std::max({corners.largest, std::fabs(corners.start[i][k]), std::fabs(corners.end[i][k])});
      }
    }
    return corners;
  }

  const Elements& elements_;
  Candidate normal_;
  std::vector<Candidate> moving_;
};

}  // namespace

std::vector<Piece> separating_pieces(const Elements& elements, const Exact& end, bool open) {
  // A gap of 2^-k of the coordinates needs about k bisections; no query of doubles has gaps near this bound.
  constexpr int kMostBisections = 100'000;
  Search search(elements);
  std::vector<Piece> pieces;
  Exact from(0);
  std::vector<Exact> ends = {end};  // of the pieces to come, the next one last
  int bisections = 0;
  while (!ends.empty()) {
    const Exact to = ends.back();
    const bool last = ends.size() == 1;
    if (auto piece = search.piece(from, to, open && last)) {
      pieces.push_back(std::move(*piece));
      from = to;
      ends.pop_back();
    } else {
      if (from == to || ++bisections > kMostBisections)
        throw Error("the elements touch: there is no proof that they do not");
      ends.push_back((from + to) * Exact(0.5));
    }
  }
  return pieces;
}

std::vector<Piece> quick_piece(const Query& query) {
  Piece piece;
  piece.until = Exact(1);
  if (filters::same_side(query)) {
    piece.normal = true;
    return {piece};
  }
  const RelativeCorners corners = filters::relative_corners(query);
  const DoubleVector direction = filters::between_closest_points(corners, query.kind);
  if (!filters::separates(corners, direction)) return {};
  for (const int bits : kDirectionBits) {
    const auto integers = rounded(direction, bits);
    if (!integers || !filters::separates(corners, *integers)) continue;
    piece.direction = constant(*integers);
    return {piece};
  }
  return {};
}

}  // namespace touchstone::proofs
