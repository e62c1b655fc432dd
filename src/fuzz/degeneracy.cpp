// SPDX-License-Identifier: MIT
#include "fuzz/degeneracy.hpp"

#include <array>
#include <cstddef>
#include <vector>

#include "geometry/frame.hpp"
#include "geometry/vector.hpp"
#include "numbers/exact_number.hpp"
#include "numbers/polynomial.hpp"

namespace touchstone::fuzz {
namespace {

using numbers::Exact;
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

template <int D>
bool vanishes(const geometry::Vector<numbers::Polynomial<Exact, D>>& v) {
  return numbers::is_zero(v[0]) && numbers::is_zero(v[1]) && numbers::is_zero(v[2]);
}

using Names = std::vector<const char*>;

const Names& names_of(Kind kind) {
  static const std::array<Names, 4> names{{
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

std::uint8_t vanishing(const Query& q) {
  using geometry::cross;
  using geometry::dot;
  const auto corner_difference = [&q](std::size_t i, std::size_t j) { return difference(q, i, j); };
  switch (q.kind) {
    case Kind::edge_edge: {
      const auto frame = geometry::frame_of(true, corner_difference);
      const auto& [u, w, r] = frame;
      const auto n = geometry::normal(frame);
      return bits({numbers::is_zero(dot(n, r)), vanishes(n), vanishes(cross(r, u)), vanishes(cross(r, w)), vanishes(u),
                   vanishes(w)});
    }
    case Kind::vertex_face: {
      const auto frame = geometry::frame_of(false, corner_difference);
      const auto& [u, w, r] = frame;
      const auto n = geometry::normal(frame);
      return bits({numbers::is_zero(dot(n, r)), vanishes(n), vanishes(u), vanishes(w), vanishes(difference(q, 3, 2))});
    }
    case Kind::point_edge: {
      const Moving u = difference(q, 2, 1), r = difference(q, 0, 1);
      return bits({vanishes(cross(r, u)), vanishes(u), vanishes(r)});
    }
    case Kind::point_point: return bits({vanishes(difference(q, 1, 0))});
  }
  return 0;
}

}  // namespace

Degeneracy degeneracy_of(const Query& query, const Answer& truth) {
  return {query.kind, truth.nature, truth.feature_a, truth.feature_b, vanishing(query)};
}

std::string degeneracy_text(const Degeneracy& d) {
  std::string text;
  if (d.nature == Nature::none) {
    text = "no contact";
  } else if (d.feature_a == Feature::overlap) {
    text.append(nature_name(d.nature)).append(", overlap");
  } else {
    text.append(nature_name(d.nature)).append(", ").append(feature_name(d.feature_a)).append(" against ");
    text.append(feature_name(d.feature_b));
  }
  const Names& names = names_of(d.kind);
  std::string zeros;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if ((d.vanishing >> i & 1) != 0) zeros.append(names[i]).append(" = ");
  }
  return zeros.empty() ? text : text.append(", ").append(zeros).append("0 at all times");
}

}  // namespace touchstone::fuzz
