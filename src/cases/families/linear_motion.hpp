// Vectors and linear motions in doubles, for building queries. Exact on the lattices that the generators use.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <touchstone/query.hpp>

#include "geometry/kind_traits.hpp"

namespace touchstone::families {

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }

/// Coordinate 0, 1 or 2.
inline double& coordinate(Vec3& v, std::size_t axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
inline double coordinate(const Vec3& v, std::size_t axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

/// A scalar that is linear in t.
struct Linear {
  double start;
  double end;
};

/// A point or vector that is linear in t.
struct Moving {
  Vec3 start;
  Vec3 end;
};

inline Moving fixed(const Vec3& v) { return {v, v}; }
inline Moving operator+(const Moving& a, const Moving& b) { return {a.start + b.start, a.end + b.end}; }
inline Moving operator-(const Moving& a, const Moving& b) { return {a.start - b.start, a.end - b.end}; }
inline Moving operator*(double s, const Moving& a) { return {s * a.start, s * a.end}; }
inline Moving operator*(const Linear& s, const Vec3& a) { return {s.start * a, s.end * a}; }

/// How many corners each of the two elements has; the first element's corners come first in a query.
struct ElementSizes {
  std::size_t a;
  std::size_t b;
};
constexpr ElementSizes element_sizes(Kind kind) noexcept {
  const auto& [first, second] = geometry::traits_of(kind);
  return {first.corners(), second.corners()};
}

inline Query query_of(Kind kind, const std::array<Moving, 4>& corners) {
  Query query;
  query.kind = kind;
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    query.start[i] = corners[i].start;
    query.end[i] = corners[i].end;
  }
  return query;
}

/// Calls f(double&) for every coordinate of every corner at both ends.
template <typename F>
void for_each_coordinate(Query& query, F&& f) {
  for (auto* corners : {&query.start, &query.end}) {
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) f(coordinate((*corners)[i], axis));
    }
  }
}

/// The query with f(Vec3) in place of every corner at both ends.
template <typename F>
Query mapped_corners(Query query, F&& f) {
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    query.start[i] = f(query.start[i]);
    query.end[i] = f(query.end[i]);
  }
  return query;
}

}  // namespace touchstone::families
