// SPDX-License-Identifier: MIT
#include "fuzz/judging/degeneracy.hpp"

#include <array>
#include <cstddef>
#include <vector>

#include "exact/corners.hpp"
#include "geometry/frame.hpp"
#include "geometry/vector.hpp"
#include "numbers/integers/exact_number.hpp"
#include "numbers/roots/polynomial.hpp"

namespace touchstone::fuzz {
namespace {

using numbers::Exact;
using numbers::is_zero;
using Linear = numbers::Polynomial<Exact, 1>;
using Moving = geometry::Vector<Linear>;

Linear difference(double start_a, double end_a, double start_b, double end_b) {
  const Exact start = Exact(start_a) - Exact(start_b);
  return {{start, Exact(end_a) - Exact(end_b) - start}};
}

/// Corner a less corner b, as a polynomial in t.
Moving difference(const Query& q, std::size_t a, std::size_t b) {
  return {{difference(q.start[a].x, q.end[a].x, q.start[b].x, q.end[b].x),
           difference(q.start[a].y, q.end[a].y, q.start[b].y, q.end[b].y),
           difference(q.start[a].z, q.end[a].z, q.start[b].z, q.end[b].z)}};
}

/// Of polynomials of any sort.
template <class P>
bool vanishes(const geometry::Vector<P>& v) {
  return is_zero(v[0]) && is_zero(v[1]) && is_zero(v[2]);
}

using PolynomialNames = std::vector<const char*>;

const PolynomialNames& polynomial_names_of(Kind kind) {
  static const std::array<PolynomialNames, 4> names{{
      {"V", "n", "r x u", "r x w", "u", "w"},         // edge-edge
      {"V", "n", "f1 - f0", "f2 - f0", "f2 - f1"},    // vertex-face
      {"(p - e0) x (e1 - e0)", "e1 - e0", "p - e0"},  // point-edge
      {"q - p"},                                      // point-point
  }};
  return names[static_cast<std::size_t>(kind)];
}

std::uint8_t bits(std::initializer_list<bool> flags) {
  unsigned result = 0, bit = 1;
  for (const bool flag : flags) {
    if (flag) result |= bit;
    bit <<= 1;
  }
  return static_cast<std::uint8_t>(result);
}

/// @param corner_difference  of two corners, as polynomials in t times one positive number at each t
template <class Difference>
std::uint8_t vanishing(Kind kind, Difference&& corner_difference) {
  using geometry::cross;
  using geometry::dot;
  switch (kind) {
    case Kind::edge_edge: {
      const auto frame = geometry::frame_of(kind, corner_difference);
      const auto& [u, w, r] = frame;
      const auto n = geometry::normal(frame);
      return bits(
          {is_zero(dot(n, r)), vanishes(n), vanishes(cross(r, u)), vanishes(cross(r, w)), vanishes(u), vanishes(w)});
    }
    case Kind::vertex_face: {
      const auto frame = geometry::frame_of(kind, corner_difference);
      const auto& [u, w, r] = frame;
      const auto n = geometry::normal(frame);
      return bits({is_zero(dot(n, r)), vanishes(n), vanishes(u), vanishes(w), vanishes(corner_difference(3, 2))});
    }
    case Kind::point_edge: {
      const auto u = corner_difference(2, 1), r = corner_difference(0, 1);
      return bits({vanishes(cross(r, u)), vanishes(u), vanishes(r)});
    }
    case Kind::point_point: return bits({vanishes(corner_difference(1, 0))});
  }
  return 0;
}

std::uint8_t vanishing(const Query& query) {
  return vanishing(query.kind, [&](std::size_t i, std::size_t j) { return difference(query, i, j); });
}

std::uint8_t vanishing(const CurvedQuery& query) {
  const auto corners = exact::moving_corners<exact::AnyDegree>(query);
  return vanishing(query.kind, [&](std::size_t i, std::size_t j) { return corners[i] - corners[j]; });
}

}  // namespace

Degeneracy degeneracy_of(const AnyQuery& query, const Answer& truth) {
  const std::uint8_t zeros = std::visit([](const auto& q) { return vanishing(q); }, query);
  return {kind_of(query), truth.nature, truth.feature_a, truth.feature_b, zeros, is_curved(query)};
}

std::string degeneracy_text(const Degeneracy& d) {
  std::string text;
  if (d.nature == Nature::none) {
    text = "no contact";
  } else if (d.feature_a == Feature::overlap) {
    text.append(name_of(d.nature)).append(", overlap");
  } else {
    text.append(name_of(d.nature)).append(", ").append(name_of(d.feature_a)).append(" against ");
    text.append(name_of(d.feature_b));
  }
  const PolynomialNames& names = polynomial_names_of(d.kind);
  std::string zeros;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if ((d.vanishing >> i & 1) != 0) zeros.append(names[i]).append(" = ");
  }
  return zeros.empty() ? text : text.append(", ").append(zeros).append("0 at all times");
}

}  // namespace touchstone::fuzz
