// Positions in doubles, and rotations by operations that IEEE 754 fixes to the last bit.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <touchstone/query.hpp>

#include "seeded/rng.hpp"

namespace touchstone::generators {

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vec3& a) { return std::sqrt(dot(a, a)); }

/// A vector whose direction is uniform on the sphere, of length 1 up to rounding.
inline Vec3 random_direction(seeded::Rng& random) {
  for (;;) {
    const Vec3 v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const double square = dot(v, v);
    if (square > 0.01 && square <= 1) return (1 / std::sqrt(square)) * v;
  }
}

/// Three directions that are orthogonal up to rounding.
struct Rotation {
  Vec3 x{1, 0, 0};
  Vec3 y{0, 1, 0};
  Vec3 z{0, 0, 1};

  Vec3 operator()(const Vec3& v) const { return v.x * x + (v.y * y + v.z * z); }
};

/// So that nothing in a scene is aligned with the axes.
inline Rotation random_rotation(seeded::Rng& random) {
  Rotation rotation;
  rotation.x = random_direction(random);
  Vec3 y;
  do {
    const Vec3 other = random_direction(random);
    y = other - dot(other, rotation.x) * rotation.x;
  } while (length(y) < 0.1);
  rotation.y = (1 / length(y)) * y;
  rotation.z = cross(rotation.x, rotation.y);
  return rotation;
}

}  // namespace touchstone::generators
