// SPDX-License-Identifier: MIT
#include "view/basis.hpp"

#include <cmath>

namespace touchstone::view {
namespace {

Double3 cross_product(const Double3& a, const Double3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double length(const Double3& a) { return std::sqrt(dot_product(a, a)); }

Double3 unit(const Double3& a, const Double3& otherwise) {
  const double size = length(a);
  return size > 1e-12 ? Double3{a[0] / size, a[1] / size, a[2] / size} : otherwise;
}

Double3 sum(const Double3& a, double x, const Double3& b, double y) {
  return {a[0] * x + b[0] * y, a[1] * x + b[1] * y, a[2] * x + b[2] * y};
}

/// A direction of one element, by its corners relative to one point.
Double3 between(const nlohmann::json& picture, std::size_t i, std::size_t j) {
  const Double3 a = vector_at(picture["corners"][i], 0), b = vector_at(picture["corners"][j], 0);
  return unit({b[0] - a[0], b[1] - a[1], b[2] - a[2]}, {0, 0, 0});
}

Double3 any_normal_to(const Double3& a) {
  const Double3 axis = std::abs(a[2]) < 0.9 ? Double3{0, 0, 1} : Double3{0, 1, 0};
  return unit(sum(axis, 1, a, -dot_product(axis, a)), {0, 0, 1});
}

}  // namespace

double polynomial_at(const nlohmann::json& p, double s) {
  double result = 0;
  for (std::size_t i = p.size(); i-- > 0;) result = result * s + p[i].get<double>();
  return result;
}

Double3 vector_at(const nlohmann::json& p, double s) {
  return {polynomial_at(p[0], s), polynomial_at(p[1], s), polynomial_at(p[2], s)};
}

double dot_product(const Double3& a, const Double3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

nlohmann::json first_view(const nlohmann::json& picture) {
  if (picture["planar"].get<bool>()) return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::size_t count = picture["corners"].size();
  const bool edges = picture["kind"] == "edge-edge";
  const Double3 u = edges ? between(picture, 0, 1) : count > 2 ? between(picture, 1, 2) : Double3{1, 0, 0};
  const Double3 w = edges ? between(picture, 2, 3) : count > 3 ? between(picture, 1, 3) : Double3{0, 0, 0};
  const Double3 normal = cross_product(u, w);
  // Only an ordinary angle gives a normal that is a direction to look along.
  const Double3 up = length(normal) > 1e-3 ? unit(normal, {0, 0, 1}) : any_normal_to(u);
  const Double3 side = unit(cross_product(up, u), any_normal_to(up));
  const Double3 towards = unit(sum(sum(u, 0.35, side, -0.8), 1, up, 0.45), {0, 0, 1});
  const Double3 screen_up = unit(sum(up, 1, towards, -dot_product(up, towards)), {0, 1, 0});
  const Double3 right = cross_product(screen_up, towards);
  return {right, screen_up, towards};
}

}  // namespace touchstone::view
