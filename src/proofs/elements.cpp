// SPDX-License-Identifier: MIT
#include "proofs/elements.hpp"

#include <algorithm>

#include "exact/corners.hpp"
#include "geometry/kind_traits.hpp"

namespace touchstone::proofs {
namespace {

Elements empty_elements(Kind kind, const Separation& separation, const Exact& factor) {
  Elements elements;
  elements.kind = kind;
  elements.count = corner_count(kind);
  elements.first_count = geometry::corners_of_first(kind);
  elements.separation = Exact(separation.distance) * factor;
  elements.metric = separation.metric;
  return elements;
}

template <class Q>
Elements straight_elements(const Q& query, const Separation& separation) {
  const exact::ScaledCorners scaled = exact::scaled_corners(query);
  Elements elements = empty_elements(query.kind, separation, scaled.factor);
  for (std::size_t i = 0; i < elements.count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      elements.corners[i][k] = {scaled.corners[i][k][0], scaled.corners[i][k][1]};
    }
    elements.weights[i] = {Exact(1)};
  }
  return elements;
}

/// The polynomial with as many coefficients as docs/proofs.md counts.
Dense of_size(std::size_t size, const exact::Form& p) {
  Dense result(size);
  for (std::size_t i = 0; i < std::min(size, static_cast<std::size_t>(p.size())); ++i) {
    result[i] = p[static_cast<int>(i)];
  }
  return result;
}

}  // namespace

Elements Elements::at(const Exact& time) const {
  Elements still = *this;
  for (std::size_t i = 0; i < count; ++i) {
    for (Dense& coordinate : still.corners[i].c) coordinate = {value(coordinate, time)};
    still.weights[i] = {value(weights[i], time)};
  }
  return still;
}

DenseVector Elements::difference(std::size_t i, std::size_t j) const {
  if (have_one_weight(i, j)) return corners[i] - corners[j];
  DenseVector result;
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = scaled_by(weights[j], corners[i][k]) - scaled_by(weights[i], corners[j][k]);
  }
  return result;
}

Elements elements_of(const Query& query, const Separation& separation) { return straight_elements(query, separation); }
Elements elements_of(const RationalQuery& query, const Separation& separation) {
  return straight_elements(query, separation);
}

Elements elements_of(const CurvedQuery& query, const Separation& separation) {
  constexpr std::size_t kBodySize = 4, kWeightSize = 3;  // of |q|^2 x, and of |q|^2
  const exact::HomogeneousCorners all = exact::homogeneous_corners(query);
  Elements elements = empty_elements(query.kind, separation, all.factor);
  for (std::size_t i = 0; i < elements.count; ++i) {
    const CurvedCorner& corner = query.corners[i];
    const bool on_curve = corner.motion == CurvedCorner::kOnCurve;
    const std::size_t size = on_curve ? static_cast<std::size_t>(corner.control_points) : kBodySize;
    for (std::size_t k = 0; k < 3; ++k) elements.corners[i][k] = of_size(size, all.numerators[i][k]);
    elements.weights[i] = of_size(on_curve ? 1 : kWeightSize, all.weights[i]);
    elements.motions[i] = corner.motion;
  }
  return elements;
}

CornersAndEdges corners_and_edges(Kind kind) {
  CornersAndEdges all{};
  const auto add = [&](const geometry::Element& of_corners, std::size_t c, const geometry::Element& of_edges,
                       std::size_t e) {
    for (std::size_t i = 0; i < of_corners.corners(); ++i) {
      for (std::size_t j = 0; j < of_edges.edges(); ++j) {
        all.pairs[all.count++] = {c + i, e + j, e + of_edges.end_of_edge(j)};
      }
    }
  };
  const auto& [first, second] = geometry::traits_of(kind);
  add(first, 0, second, first.corners());
  add(second, first.corners(), first, 0);
  return all;
}

}  // namespace touchstone::proofs
