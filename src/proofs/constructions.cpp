// SPDX-License-Identifier: MIT
#include "proofs/constructions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchstone::proofs {
namespace {

/// Two edges meet, or a vertex and a face do, with the weights of geometry/frame.hpp: n = u x w and, along an axis, the
/// numerators of two fractions.
///
/// The frame's vectors are multiplied by scales, and corner i's weight is its share of the point over W_i. Let s be the
/// scale of r, and a that of u. The fraction of u is first / n times a / s, and the share of corner 1 of two edges is
/// this fraction. So with the common factor n s, the weight is first a / W_1; and that of corner 0 is n s / W_0 - first
/// a / W_0. A scale over a weight is what `completed` multiplies by.
std::array<Dense, 4> weights_of_lines(const Elements& elements, const Dense& n, const Dense& first,
                                      const Dense& second) {
  const auto of = [&](const Dense& p, std::size_t i, std::size_t j) { return elements.completed(p, i, j); };
  if (elements.is_edge_edge()) {
    return {of(n, 0, 2) - of(first, 0, 1), of(first, 1, 0), of(n, 2, 0) - of(second, 2, 3), of(second, 3, 2)};
  }
  return {n, of(n, 1, 0) - of(first, 1, 2) - of(second, 1, 3), of(first, 2, 1), of(second, 3, 1)};
}

/// Where V vanishes, the fractions along axis k; none of them is better than another one.
Construction along_axis(const Elements& elements, const geometry::Frame<DenseVector>& frame, std::size_t k) {
  Construction c;
  c.events = {{geometry::coplanarity(frame)}};
  c.weights =
      weights_of_lines(elements, geometry::cross_component(frame.u, frame.w, k), geometry::first_numerator(frame, k),
                       geometry::second_numerator(elements.kind, frame, k));
  return c;
}

/// The closest points of two lines, or of a vertex and a plane: the fractions are projections of the vectors along n,
/// because V n / (n . n) is what is left of r. Its square is V^2 / (n . n).
Construction closest_of_lines(const Elements& elements, const geometry::Frame<DenseVector>& frame) {
  const DenseVector n = geometry::normal(frame);
  const Dense square = geometry::dot(n, n);
  const Dense v = geometry::dot(n, frame.r);
  const DenseVector second =
      elements.is_edge_edge() ? geometry::cross(frame.r, frame.u) : geometry::cross(frame.u, frame.r);
  Construction c;
  const Dense bound = elements.is_edge_edge() ? elements.bound(2, 0) : elements.bound(0, 1);  // of r
  c.events = {{v * v - bound * bound * square}};
  c.weights =
      weights_of_lines(elements, square, geometry::dot(geometry::cross(frame.r, frame.w), n), geometry::dot(second, n));
  return c;
}

/// A corner and the point of an edge that is closest to it. Their squared distance is |r x e|^2 / (e . e).
Construction on_edge(const Elements& elements, const CornerAndEdge& pair) {
  const DenseVector r = elements.difference(pair.corner, pair.start);
  const DenseVector e = elements.difference(pair.end, pair.start);
  const DenseVector c = geometry::cross(r, e);
  const Dense square = geometry::dot(e, e);
  Construction result;
  if (elements.has_separation()) {
    const Dense bound = elements.bound(pair.corner, pair.start);
    result.events = {{geometry::dot(c, c) - bound * bound * square}};
  } else {
    result.events = {{c[0], c[1], c[2]}};
  }
  result.weights[pair.corner] = {Exact(1)};
  const Dense along = geometry::dot(r, e);
  result.weights[pair.end] = elements.completed(along, pair.end, pair.start);
  result.weights[pair.start] =
      elements.completed(square, pair.start, pair.corner) - elements.completed(along, pair.start, pair.end);
  return result;
}

Construction at_corners(const Elements& elements, std::size_t i, std::size_t j) {
  const DenseVector r = elements.difference(j, i);
  Construction result;
  if (elements.has_separation()) {
    const Dense bound = elements.bound(j, i);
    result.events = {{geometry::dot(r, r) - bound * bound}};
  } else {
    result.events = {{r[0], r[1], r[2]}};
  }
  result.weights[i] = result.weights[j] = {Exact(1)};
  return result;
}

/// In the metric `max`, with the fractions s and q along the elements' edges, times the scale of r over that of the
/// edge: the polygon of the points (s, q) of the elements whose difference is at most D along each axis. A border is
/// the line where a s + b q + c = 0; the polygon is on its side where that is not negative. For a point and an edge q =
/// 0, for two points s = 0 too; these are the last borders.
class Polygon {
 public:
  explicit Polygon(const Elements& elements) : elements_(elements) {
    const Dense zero = {Exact(0)};
    const Dense one = {Exact(1)};
    const Dense minus_one = {Exact(-1)};
    DenseVector r, along_s, along_q;  // the difference is r + s along_s + q along_q, times the scale of r
    const auto of = [&](const Dense& p, std::size_t i, std::size_t j) { return elements.completed(p, i, j); };
    const bool edges = elements.kind == Kind::edge_edge;
    const Dense d = edges ? elements.bound(2, 0) : elements.bound(1, 0);
    switch (elements.kind) {
      case Kind::edge_edge:
        dimensions_ = 2;
        r = elements.difference(2, 0);
        along_s = elements.difference(0, 1);
        along_q = elements.difference(3, 2);
        borders_ = {{one, zero, zero},
                    {of(minus_one, 0, 1), zero, of(one, 0, 2)},
                    {zero, one, zero},
                    {zero, of(minus_one, 2, 3), of(one, 2, 0)}};
        break;
      case Kind::vertex_face:
        dimensions_ = 2;
        r = elements.difference(1, 0);
        along_s = elements.difference(2, 1);
        along_q = elements.difference(3, 1);
        borders_ = {{one, zero, zero}, {zero, one, zero}, {of(minus_one, 1, 2), of(minus_one, 1, 3), of(one, 1, 0)}};
        break;
      case Kind::point_edge:
        dimensions_ = 1;
        r = elements.difference(1, 0);
        along_s = elements.difference(2, 1);
        borders_ = {{one, zero, zero}, {of(minus_one, 1, 2), zero, of(one, 1, 0)}};
        break;
      case Kind::point_point: r = elements.difference(1, 0); break;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      borders_.push_back({-along_s[k], -along_q[k], d - r[k]});
      borders_.push_back({along_s[k], along_q[k], d + r[k]});
    }
    if (dimensions_ == 0) borders_.push_back({one, zero, zero});
    if (dimensions_ <= 1) borders_.push_back({zero, one, zero});
  }

  /// Calls `try_one` with the corners of the polygon, each with the times at which the polygon may begin there, until
  /// it returns true. Those that seem to exist at the time come first.
  void try_corners(const Exact& time, Events events, const std::function<bool(const Construction&)>& try_one) const {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    const std::size_t count = borders_.size();
    for (std::size_t i = dimensions_ > 0 ? 0 : count - 2; i < count; ++i) {
      for (std::size_t j = dimensions_ > 1 ? i + 1 : count - 1; j < count; ++j) {
        if (i != j) pairs.emplace_back(i, j);
      }
    }
    std::vector<DoubleBorder> at_time;
    for (const Border& border : borders_) {
      const auto near = [&](const Dense& p) { return numbers::to_double(value(p, time)); };
      at_time.push_back({near(border.a), near(border.b), near(border.c)});
    }
    std::stable_partition(pairs.begin(), pairs.end(),
                          [&](const auto& pair) { return seems_to_exist(at_time, pair.first, pair.second); });
    for (const auto& [i, j] : pairs) {
      const Border& f = borders_[i];
      const Border& g = borders_[j];
      const Dense det = f.a * g.b - f.b * g.a;
      if (is_zero(det)) continue;
      const Dense s = f.b * g.c - f.c * g.b;
      const Dense q = f.c * g.a - f.a * g.c;
      Construction corner;
      corner.weights = weights(det, s, q);
      for (const Border& border : borders_) {
        if (events == Events::unneeded || &border == &f || &border == &g) continue;
        Dense slack = border.a * s + border.b * q + border.c * det;
        if (!is_zero(slack)) corner.events.push_back({std::move(slack)});
      }
      if (try_one(corner)) return;
    }
  }

 private:
  struct Border {
    Dense a, b, c;
  };
  struct DoubleBorder {
    double a, b, c;
  };

  /// Whether the corner of two borders is about on the right sides of all of them. It is a hint only.
  static bool seems_to_exist(const std::vector<DoubleBorder>& borders, std::size_t i, std::size_t j) {
    constexpr double kAbout = 1e-9;
    const DoubleBorder& f = borders[i];
    const DoubleBorder& g = borders[j];
    const double det = f.a * g.b - f.b * g.a;
    const double s = (f.b * g.c - f.c * g.b) / det;
    const double q = (f.c * g.a - f.a * g.c) / det;
    return det != 0 && std::all_of(borders.begin(), borders.end(), [&](const DoubleBorder& border) {
             const double size = std::fabs(border.a * s) + std::fabs(border.b * q) + std::fabs(border.c);
             return border.a * s + border.b * q + border.c >= -kAbout * size;
           });
  }

  /// The weights of the corners for the fractions s / det and q / det.
  std::array<Dense, 4> weights(const Dense& det, const Dense& s, const Dense& q) const {
    const Dense one = {Exact(1)};
    if (elements_.kind == Kind::point_point) return {one, one, {}, {}};
    if (elements_.kind == Kind::point_edge) {
      return {one, elements_.completed(det, 1, 0) - elements_.completed(s, 1, 2), elements_.completed(s, 2, 1), {}};
    }
    std::array<Dense, 4> result = weights_of_lines(elements_, det, s, q);
    if (elements_.kind == Kind::vertex_face) result[0] = one;
    return result;
  }

  const Elements& elements_;
  int dimensions_ = 0;  // of the polygon
  std::vector<Border> borders_;
};

}  // namespace

void try_constructions(const Elements& elements, const Exact& time, Events events,
                       const std::function<bool(const Construction&)>& try_one) {
  if (elements.has_max_separation()) return Polygon(elements).try_corners(time, events, try_one);
  if (elements.has_normal()) {
    const auto frame = elements.frame();
    if (elements.has_separation()) {
      if (try_one(closest_of_lines(elements, frame))) return;
    } else {
      for (std::size_t k = 0; k < 3; ++k) {
        if (try_one(along_axis(elements, frame, k))) return;
      }
    }
  }
  for (const CornerAndEdge& pair : corners_and_edges(elements.kind)) {
    if (try_one(on_edge(elements, pair))) return;
  }
  for (std::size_t i = 0; i < elements.first_count; ++i) {
    for (std::size_t j = elements.first_count; j < elements.count; ++j) {
      if (try_one(at_corners(elements, i, j))) return;
    }
  }
}

std::array<Dense, 2> sums_of(const Elements& elements, const std::array<Dense, 4>& weights) {
  std::array<Dense, 2> sums;
  for (std::size_t i = 0; i < elements.count; ++i) {
    Dense& sum = sums[i < elements.first_count ? 0 : 1];
    sum = sum + scaled_by(elements.weights[i], weights[i]);
  }
  return sums;
}

std::vector<Dense> conditions(const Elements& elements, const std::array<Dense, 4>& weights) {
  if (!elements.has_max_separation()) return {};
  const std::array<Dense, 2> sums = sums_of(elements, weights);
  std::array<DenseVector, 2> points;
  for (std::size_t i = 0; i < elements.count; ++i) {
    const std::size_t element = i < elements.first_count ? 0 : 1;
    for (std::size_t k = 0; k < 3; ++k) {
      points[element][k] = points[element][k] + weights[i] * elements.corners[i][k];
    }
  }
  const Dense bound = elements.separation * (sums[0] * sums[1]);
  std::vector<Dense> all;
  for (std::size_t k = 0; k < 3; ++k) {
    const Dense difference = sums[1] * points[0][k] - sums[0] * points[1][k];
    all.push_back(bound - difference);
    all.push_back(bound + difference);
  }
  return all;
}

}  // namespace touchstone::proofs
