// SPDX-License-Identifier: MIT
#include "baselines/scaled_frame.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::baselines {
namespace {

double largest(const Vector& v) { return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])}); }
double largest(const Motion& m) { return std::max(largest(m.start), largest(m.end)); }

Vector scaled(const Vector& v, int by) {
  return {{std::scalbn(v[0], by), std::scalbn(v[1], by), std::scalbn(v[2], by)}};
}

/// Times 2^by: one multiplication where that factor is a normal double.
Motion scaled(const Motion& m, int by) {
  if (by < -1000 || by > 1000) return {scaled(m.start, by), scaled(m.end, by)};
  const double factor = std::scalbn(1.0, by);
  return {factor * m.start, factor * m.end};
}

}  // namespace

Frame frame_of(const Query& query) {
  std::array<Motion, 4> corner{};
  double greatest = 0;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const Vec3& a = query.start[i];
    const Vec3& b = query.end[i];
    corner[i] = {{{a.x, a.y, a.z}}, {{b.x, b.y, b.z}}};
    greatest = std::max(greatest, largest(corner[i]));
  }
  // A difference of coordinates near the greatest double would overflow.
  const int lowered = greatest > 0x1p1020 ? 4 : 0;
  if (lowered != 0) {
    for (Motion& motion : corner) motion = scaled(motion, -lowered);
  }

  Frame frame;
  frame.kind = query.kind;
  switch (query.kind) {
    case Kind::edge_edge:
      frame.u = corner[1] - corner[0];
      frame.w = corner[3] - corner[2];
      frame.r = corner[2] - corner[0];
      break;
    case Kind::vertex_face:
      frame.u = corner[2] - corner[1];
      frame.w = corner[3] - corner[1];
      frame.r = corner[0] - corner[1];
      break;
    case Kind::point_edge:
      frame.u = corner[2] - corner[1];
      frame.r = corner[0] - corner[1];
      break;
    case Kind::point_point: frame.r = corner[1] - corner[0]; break;
  }
  const double u = largest(frame.u);
  const double w = largest(frame.w);
  const double r = largest(frame.r);
  const double size = std::max({u, w, r});
  int exponent = 0;
  if (size > 0 && std::isfinite(size)) std::frexp(size, &exponent);
  if (exponent != 0) {
    for (Motion* motion : {&frame.u, &frame.w, &frame.r}) *motion = scaled(*motion, -exponent);
  }
  frame.exponent = exponent + lowered;
  frame.box = std::scalbn(u, -exponent) * std::scalbn(w, -exponent) * std::scalbn(r, -exponent);
  return frame;
}

}  // namespace touchstone::baselines
