// "Continuous Collision Detection in 3-D", sections 3.2 to 3.4, as printed.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <touchstone/error.hpp>

#include "baselines/baseline.hpp"
#include "baselines/scaled_frame.hpp"

// The paper's method is changed only where it could not run: the coefficients of (3), which the paper does not give; b,
// c and d divided by a where it says "divide through by a"; real cube roots for G >= 0; for G < 0, T the conjugate of
// S, as any other pair of cube roots gives wrong roots. Its weaknesses are kept: the degree is whether a computed
// coefficient is exactly zero, T is a difference that may cancel, no root is polished, and of section 3.6 (planar
// motion) there is nothing. Vertex-face, which the paper does not have, takes the same cubic, and then F0 + f1 F0F1 +
// f2 F0F2 = V in place of (27).
namespace touchstone::baselines {
namespace {

using geometry::cross;
using geometry::cross_component;
using geometry::dot;

double determinant(const Vector& x, const Vector& y, const Vector& z) { return dot(x, cross(y, z)); }

struct Particle {
  Vector position;
  Vector velocity;

  Vector at(double t) const { return position + t * velocity; }  // equation (1)
};

using Particles = std::array<Particle, 4>;

Particles particles_of(const Query& query) {
  Particles particles{};
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3& a = query.start[i];
    const Vec3& b = query.end[i];
    particles[i].position = {{a.x, a.y, a.z}};
    particles[i].velocity = {{b.x - a.x, b.y - a.y, b.z - a.z}};
  }
  return particles;
}

constexpr double kNever = std::numeric_limits<double>::infinity();

struct CubicRoots {
  std::array<double, 3> t{kNever, kNever, kNever};
  std::size_t count = 0;

  void add(double root) { t[count++] = std::isnan(root) ? kNever : root; }

  void sort() {
    if (t[0] > t[1]) std::swap(t[0], t[1]);
    if (t[1] > t[2]) std::swap(t[1], t[2]);
    if (t[0] > t[1]) std::swap(t[0], t[1]);
  }
};

CubicRoots quadratic_roots(double a, double b, double c) {
  CubicRoots roots;
  if (a == 0) {
    if (b != 0) roots.add(-c / b);
    return roots;
  }
  const double discriminant = b * b - 4 * a * c;
  if (discriminant >= 0) {
    roots.add((-b + std::sqrt(discriminant)) / (2 * a));
    roots.add((-b - std::sqrt(discriminant)) / (2 * a));
  }
  return roots;
}

CubicRoots cubic_roots(double a, double b, double c, double d) {
  if (a == 0) return quadratic_roots(b, c, d);
  b /= a;
  c /= a;
  d /= a;
  const double p = (3 * c - b * b) / 3;
  const double q = (9 * c * b - 27 * d - 2 * b * b * b) / 27;
  const double Q = p / 3;
  const double R = q / 2;
  const double G = Q * Q * Q + R * R;
  CubicRoots roots;
  if (G >= 0) {
    const double S = std::cbrt(R + std::sqrt(G));
    const double T = std::cbrt(R - std::sqrt(G));
    roots.add(-b / 3 + S + T);                    // (20)
    if (G == 0) roots.add(-b / 3 - (S + T) / 2);  // (21) and (22), whose imaginary parts are zero
    return roots;
  }
  const double radius = std::sqrt(R * R - G);  // (23)
  const double theta = std::acos(R / radius);  // (24); the sine (25) is positive
  const double third = std::cbrt(radius);
  const double real = third * std::cos(theta / 3);  // S = real + i imaginary, T = real - i imaginary
  const double imaginary = third * std::sin(theta / 3);
  roots.add(-b / 3 + 2 * real);
  roots.add(-b / 3 - real - std::sqrt(3.0) * imaginary);
  roots.add(-b / 3 - real + std::sqrt(3.0) * imaginary);
  return roots;
}

/// When the four particles are coplanar: (2) and (3), with p and r the positions and velocities relative to the first
/// one.
CubicRoots coplanar_times(const Particles& x) {
  std::array<Vector, 3> p;
  std::array<Vector, 3> r;
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = x[i + 1].position - x[0].position;
    r[i] = x[i + 1].velocity - x[0].velocity;
  }
  const double a = determinant(r[0], r[1], r[2]);
  const double b = determinant(p[0], r[1], r[2]) + determinant(r[0], p[1], r[2]) + determinant(r[0], r[1], p[2]);
  const double c = determinant(p[0], p[1], r[2]) + determinant(p[0], r[1], p[2]) + determinant(r[0], p[1], p[2]);
  const double d = determinant(p[0], p[1], p[2]);
  CubicRoots roots = cubic_roots(a, b, c, d);
  roots.sort();
  return roots;
}

/// (27), or its like for a face: s along u and f along w solve two of the three equations s u + f w = r, the first two
/// whose determinant, the denominator, is not zero.
bool intersects(const Particles& particles, Kind kind, double t) {
  std::array<Vector, 4> x;
  for (std::size_t i = 0; i < 4; ++i) x[i] = particles[i].at(t);
  const bool edges = kind == Kind::edge_edge;
  const Vector u = edges ? x[1] - x[0] : x[2] - x[1];
  const Vector w = edges ? x[2] - x[3] : x[3] - x[1];  // A + f1 AB - f2 CD = C
  const Vector r = edges ? x[2] - x[0] : x[0] - x[1];
  for (std::size_t k = 0; k < 3; ++k) {
    const double denominator = cross_component(u, w, k);
    if (denominator == 0) continue;
    const double f1 = cross_component(r, w, k) / denominator;
    const double f2 = cross_component(u, r, k) / denominator;
    return edges ? f1 >= 0 && f1 <= 1 && f2 >= 0 && f2 <= 1 : f1 >= 0 && f2 >= 0 && f1 + f2 <= 1;
  }
  return false;
}

}  // namespace

Result solve_paper(const Query& query, double t_max, double) {
  if (query.kind != Kind::edge_edge && query.kind != Kind::vertex_face) {
    throw InvalidQuery("the baseline `paper` takes edge-edge and vertex-face queries, not " +
                       std::string(name_of(query.kind)));
  }
  const Particles particles = particles_of(query);
  const CubicRoots times = coplanar_times(particles);
  for (const double t : times.t) {
    if (t >= 0 && t <= t_max && intersects(particles, query.kind, t)) return {true, t};
  }
  return {};
}

}  // namespace touchstone::baselines
