// Contact of elements at rest over the rationals, by linear systems.
// SPDX-License-Identifier: MIT
#include "support/static_contact.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace touchstone::tests {
namespace {

using Weights = std::array<mpq_class, 3>;

RationalPoint rational(const Vec3& v) { return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)}; }

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) {
  return {mpq_class(a[0] - b[0]), mpq_class(a[1] - b[1]), mpq_class(a[2] - b[2])};
}

// The solutions of  s u + q w = r : none, one (rank 2), the line  alpha s + beta q = gamma  (rank 1), all (rank 0).
struct Solutions {
  bool any = true;
  int rank = 0;
  mpq_class s, q;
  mpq_class alpha, beta, gamma;
};

Solutions solve_for_two(const RationalPoint& u, const RationalPoint& w, const RationalPoint& r) {
  Solutions result;
  std::array<std::array<mpq_class, 3>, 3> rows;
  for (std::size_t i = 0; i < 3; ++i) rows[i] = {u[i], w[i], r[i]};
  std::size_t done = 0;
  std::array<std::optional<std::size_t>, 2> pivot_row;
  for (std::size_t column = 0; column < 2; ++column) {
    std::size_t pivot = done;
    while (pivot < 3 && sgn(rows[pivot][column]) == 0) ++pivot;
    if (pivot == 3) continue;
    std::swap(rows[pivot], rows[done]);
    const mpq_class lead = rows[done][column];
    for (auto& entry : rows[done]) entry /= lead;
    for (std::size_t i = 0; i < 3; ++i) {
      if (i == done || sgn(rows[i][column]) == 0) continue;
      const mpq_class factor = rows[i][column];
      for (std::size_t j = 0; j < 3; ++j) rows[i][j] -= factor * rows[done][j];
    }
    pivot_row[column] = done++;
  }
  result.rank = static_cast<int>(done);
  for (std::size_t i = done; i < 3; ++i) result.any = result.any && sgn(rows[i][2]) == 0;
  if (done == 2) {
    result.s = rows[0][2];
    result.q = rows[1][2];
  } else if (done == 1) {
    result.alpha = rows[0][0];
    result.beta = rows[0][1];
    result.gamma = rows[0][2];
  }
  return result;
}

bool in_unit_interval(const mpq_class& x) { return sgn(x) >= 0 && cmp(x, 1) <= 0; }

// Which of {first corner, second corner, interior} a place on an edge is.
Feature on_edge(const mpq_class& place, Feature first, Feature second, Feature interior) {
  return sgn(place) == 0 ? first : cmp(place, 1) == 0 ? second : interior;
}

Weights edge_weights(const mpq_class& place) { return {mpq_class(1 - place), place, mpq_class(0)}; }

struct SegmentContact {
  bool touching = false;
  bool overlap = false;
  mpq_class s, q;  // places on either segment; where they overlap, the greatest s
};

// Segment from a along u (of length zero, perhaps) and segment from c along w:  s u - q w = c - a.
SegmentContact segments(const RationalPoint& a, const RationalPoint& u, const RationalPoint& c,
                        const RationalPoint& w) {
  const RationalPoint zero{};
  const Solutions solutions = solve_for_two(u, minus(zero, w), minus(c, a));
  SegmentContact contact;
  if (!solutions.any) return contact;
  if (solutions.rank == 0) {
    contact.touching = true;
    return contact;
  }
  if (solutions.rank == 2) {
    contact.s = solutions.s;
    contact.q = solutions.q;
    contact.touching = in_unit_interval(contact.s) && in_unit_interval(contact.q);
    return contact;
  }
  const mpq_class& alpha = solutions.alpha;
  const mpq_class& beta = solutions.beta;
  const mpq_class& gamma = solutions.gamma;
  if (sgn(alpha) == 0) {  // u = 0
    contact.q = gamma / beta;
    contact.touching = in_unit_interval(contact.q);
  } else if (sgn(beta) == 0) {  // w = 0
    contact.s = gamma / alpha;
    contact.touching = in_unit_interval(contact.s);
  } else {  // parallel segments of one line: s runs from where q = 0 to where q = 1
    const mpq_class at_0 = gamma / alpha;
    const mpq_class at_1 = (gamma - beta) / alpha;
    const mpq_class low = std::max(std::min(at_0, at_1), mpq_class(0));
    const mpq_class high = std::min(std::max(at_0, at_1), mpq_class(1));
    contact.touching = low <= high;
    contact.overlap = low < high;
    contact.s = high;
    contact.q = (gamma - alpha * high) / beta;
  }
  return contact;
}

StaticContact edge_edge(const RationalCorners& x) {
  const SegmentContact found = segments(x[0], minus(x[1], x[0]), x[2], minus(x[3], x[2]));
  StaticContact contact;
  if (!found.touching) return contact;
  contact.touching = true;
  contact.weights_a = edge_weights(found.s);
  contact.weights_b = edge_weights(found.q);
  contact.feature_a = found.overlap ? Feature::overlap : on_edge(found.s, Feature::a0, Feature::a1, Feature::a);
  contact.feature_b = found.overlap ? Feature::overlap : on_edge(found.q, Feature::b0, Feature::b1, Feature::b);
  return contact;
}

StaticContact point_edge(const RationalCorners& x) {
  const SegmentContact found = segments(x[0], RationalPoint{}, x[1], minus(x[2], x[1]));
  StaticContact contact;
  if (!found.touching) return contact;
  contact.touching = true;
  contact.weights_a = {1, 0, 0};
  contact.weights_b = edge_weights(found.q);
  contact.feature_a = Feature::p;
  contact.feature_b = on_edge(found.q, Feature::e0, Feature::e1, Feature::e);
  return contact;
}

StaticContact point_point(const RationalCorners& x) {
  StaticContact contact;
  if (x[0] != x[1]) return contact;
  contact.touching = true;
  contact.weights_a = {1, 0, 0};
  contact.weights_b = {1, 0, 0};
  contact.feature_a = Feature::p;
  contact.feature_b = Feature::q;
  return contact;
}

// The first name, in the order f0 f1 f2 f01 f12 f20, of a place on a flat triangle.
StaticContact on_flat_triangle(const RationalCorners& x) {
  StaticContact contact;
  static constexpr std::array<Feature, 3> corners{Feature::f0, Feature::f1, Feature::f2};
  static constexpr std::array<Feature, 3> edges{Feature::f01, Feature::f12, Feature::f20};
  contact.weights_a = {1, 0, 0};
  contact.feature_a = Feature::v;
  for (std::size_t i = 0; i < 3; ++i) {
    if (x[0] != x[1 + i]) continue;
    contact.touching = true;
    contact.feature_b = corners[i];
    contact.weights_b[i] = 1;
    return contact;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const SegmentContact found = segments(x[0], RationalPoint{}, x[1 + i], minus(x[1 + j], x[1 + i]));
    if (!found.touching) continue;
    contact.touching = true;
    contact.feature_b = edges[i];
    contact.weights_b[i] = 1 - found.q;
    contact.weights_b[j] = found.q;
    return contact;
  }
  return {};
}

Feature on_face(const Weights& weights) {
  static constexpr std::array<Feature, 8> by_support{Feature::none, Feature::f0,  Feature::f1,  Feature::f01,
                                                     Feature::f2,   Feature::f20, Feature::f12, Feature::f};
  std::size_t support = 0;
  for (std::size_t i = 0; i < 3; ++i) support |= static_cast<std::size_t>(sgn(weights[i]) != 0) << i;
  return by_support[support];
}

StaticContact vertex_face(const RationalCorners& x) {
  const Solutions solutions = solve_for_two(minus(x[2], x[1]), minus(x[3], x[1]), minus(x[0], x[1]));
  if (!solutions.any) return {};
  if (solutions.rank < 2) return on_flat_triangle(x);
  StaticContact contact;
  contact.weights_a = {1, 0, 0};
  contact.weights_b = {mpq_class(1 - solutions.s - solutions.q), solutions.s, solutions.q};
  for (const mpq_class& weight : contact.weights_b) {
    if (sgn(weight) < 0) return {};
  }
  contact.touching = true;
  contact.feature_a = Feature::v;
  contact.feature_b = on_face(contact.weights_b);
  return contact;
}

using Polynomial = std::vector<mpq_class>;  // constant first

Polynomial product(const Polynomial& p, const Polynomial& q) {
  Polynomial result(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) result[i + j] += p[i] * q[j];
  }
  return result;
}

void add(Polynomial& sum, const Polynomial& p, int sign) {
  for (std::size_t i = 0; i < p.size(); ++i) sum[i] += sign * p[i];
}

// The coordinates of x_i - x_j as polynomials in t.
std::array<Polynomial, 3> difference(const Query& query, std::size_t i, std::size_t j) {
  const RationalPoint start = minus(rational(query.start[i]), rational(query.start[j]));
  const RationalPoint end = minus(rational(query.end[i]), rational(query.end[j]));
  std::array<Polynomial, 3> result;
  for (std::size_t axis = 0; axis < 3; ++axis) result[axis] = {start[axis], mpq_class(end[axis] - start[axis])};
  return result;
}

}  // namespace

RationalCorners corners_at(const Query& query, const mpq_class& time) {
  RationalCorners corners;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const RationalPoint start = rational(query.start[i]);
    const RationalPoint end = rational(query.end[i]);
    for (std::size_t axis = 0; axis < 3; ++axis) corners[i][axis] = start[axis] + time * (end[axis] - start[axis]);
  }
  return corners;
}

StaticContact contact_at(Kind kind, const RationalCorners& corners) {
  switch (kind) {
    case Kind::edge_edge: return edge_edge(corners);
    case Kind::vertex_face: return vertex_face(corners);
    case Kind::point_edge: return point_edge(corners);
    case Kind::point_point: return point_point(corners);
  }
  return {};
}

bool touching_at(const Query& query, const mpq_class& time) {
  return contact_at(query.kind, corners_at(query, time)).touching;
}

std::vector<mpq_class> coplanarity_cubic(const Query& query) {
  if (query.kind != Kind::edge_edge && query.kind != Kind::vertex_face) return {};
  const bool edges = query.kind == Kind::edge_edge;
  const auto u = edges ? difference(query, 1, 0) : difference(query, 2, 1);
  const auto w = edges ? difference(query, 3, 2) : difference(query, 3, 1);
  const auto r = edges ? difference(query, 2, 0) : difference(query, 0, 1);
  Polynomial cubic(4);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    add(cubic, product(product(u[i], w[j]), r[k]), 1);
    add(cubic, product(product(u[j], w[i]), r[k]), -1);
  }
  while (!cubic.empty() && sgn(cubic.back()) == 0) cubic.pop_back();
  return cubic;
}

int root_multiplicity(std::vector<mpq_class> polynomial, const mpq_class& time) {
  int multiplicity = 0;
  while (polynomial.size() > 1) {  // divide by (t - time)
    Polynomial quotient(polynomial.size() - 1);
    mpq_class carry = 0;
    for (std::size_t i = polynomial.size(); i-- > 1;) {
      carry = polynomial[i] + time * carry;
      quotient[i - 1] = carry;
    }
    if (sgn(mpq_class(polynomial[0] + time * carry)) != 0) break;
    ++multiplicity;
    polynomial = quotient;
  }
  return multiplicity;
}

}  // namespace touchstone::tests
