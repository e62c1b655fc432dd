// V's Bernstein coefficients as sums of determinants of the vectors at both ends.
// SPDX-License-Identifier: MIT
#include "benchmarks/floor.hpp"

namespace touchstone::benchmarks {
namespace {

Vec3 minus(const Vec3& a, const Vec3& b) noexcept { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

Vec3 cross(const Vec3& a, const Vec3& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double dot(const Vec3& a, const Vec3& b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }

Vec3 plus(const Vec3& a, const Vec3& b) noexcept { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

}  // namespace

std::array<double, 4> bernstein_coefficients(const Query& query) noexcept {
  const auto& x = query.start;
  const auto& y = query.end;
  const bool edges = query.kind == Kind::edge_edge;
  const std::size_t origin = edges ? 0 : 1, u = edges ? 1 : 2, w_from = edges ? 2 : 1, r = edges ? 2 : 0;
  const Vec3 u0 = minus(x[u], x[origin]), u1 = minus(y[u], y[origin]);
  const Vec3 w0 = minus(x[3], x[w_from]), w1 = minus(y[3], y[w_from]);
  const Vec3 r0 = minus(x[r], x[origin]), r1 = minus(y[r], y[origin]);
  const Vec3 n0 = cross(u0, w0), n1 = cross(u1, w1);
  const Vec3 mixed = plus(cross(u0, w1), cross(u1, w0));
  return {dot(n0, r0), dot(mixed, r0) + dot(n0, r1), dot(mixed, r1) + dot(n1, r0), dot(n1, r1)};
}

}  // namespace touchstone::benchmarks
