// Contacts in a corner, at the very end of the step, at scales from 2^-1000 to 2^1000: none is missed. Tight-Inclusion
// misses many of them away from scale 1, because its bound on rounding errors is too small there. The drop-in's own
// version of this bound holds.
// SPDX-License-Identifier: MIT
#include <tight_inclusion/ccd.hpp>
#include <tight_inclusion/interval_root_finder.hpp>

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include <touchstone/error.hpp>

#include "dropin/tight_inclusion_query.hpp"
#include "separation/distances.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"
#include "support/slow_build.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

double& coordinate(Vec3& position, int k) { return k == 0 ? position.x : k == 1 ? position.y : position.z; }

/// Elements on two sides of a plane across an axis, for all t in [0, 1). At t = 1 one corner of each reaches one point
/// of the plane. So the first contact is at t = 1, by construction.
Query corner_hit(Kind kind, double scale, Rng& rng) {
  Query query;
  query.kind = kind;
  const int axis = rng.between(0, 2);
  const double side = rng.one_in(2) ? 1 : -1;
  Vec3 point;
  for (int k = 0; k < 3; ++k) coordinate(point, k) = scale * rng.symmetric();
  const double plane = coordinate(point, axis);
  const std::size_t corners_of_first = kind == Kind::edge_edge ? 2 : 1;
  for (auto* corners : {&query.start, &query.end}) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (int k = 0; k < 3; ++k) coordinate((*corners)[i], k) = scale * rng.symmetric();
      const double away = scale * (rng.unit() + 0x1p-20);
      coordinate((*corners)[i], axis) = plane + (i < corners_of_first ? side : -side) * away;
    }
  }
  query.end[rng.below(corners_of_first)] = point;
  query.end[corners_of_first + rng.below(4 - corners_of_first)] = point;
  return query;
}

/// x0 + t (x1 - x0) without rounding.
mpq_class on_path(double t, double x0, double x1) {
  return mpq_class(x0) + mpq_class(t) * (mpq_class(x1) - mpq_class(x0));
}

/// The value of function_f_ee or function_f_vf on an axis without rounding.
mpq_class exact_difference(Kind kind, double t, double u, double v, const EigenCorners& x, int k) {
  std::array<mpq_class, 4> c;
  for (std::size_t i = 0; i < 4; ++i) c[i] = on_path(t, x[i][k], x[i + 4][k]);
  if (kind == Kind::edge_edge) {
    return mpq_class(c[0] + mpq_class(u) * (c[1] - c[0])) - mpq_class(c[2] + mpq_class(v) * (c[3] - c[2]));
  }
  return c[0] - mpq_class(c[1] + mpq_class(u) * (c[2] - c[1]) + mpq_class(v) * (c[3] - c[1]));
}

double rounded_difference(Kind kind, double t, double u, double v, const EigenCorners& x, int k) {
  const auto f = kind == Kind::edge_edge ? ticcd::function_f_ee<double> : ticcd::function_f_vf<double>;
  return f(t, u, v, k, x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]);
}

}  // namespace

TEST_CASE("no contact in a corner at t = 1 is missed, at any scale") {
  const auto cases = static_cast<int>(effort(2000));
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
    for (const double scale : {0x1p-1000, 1e-100, 1e-4, 0.01, 0.1, 1.0, 64.0, 100.0, 1000.0, 1e100, 0x1p1000}) {
      Rng rng(kind == Kind::edge_edge ? 41 : 42);
      int wrong = 0;
      for (int i = 0; i < cases; ++i) {
        const Query query = corner_hit(kind, scale, rng);
        Call call;
        call.no_zero_toi = rng.one_in(2);
        const Impact impact = ask(query, call);
        if (impact.exists && impact.toi == 1) continue;
        if (++wrong <= 3) FAIL_CHECK("toi " << hexfloat(impact.toi) << ", not 1: " << cpp_initializer(query));
      }
      CAPTURE(scale, cases);
      CHECK(wrong == 0);
    }
  }
}

TEST_CASE("the bound on rounding errors is theirs at scale 1, in proportion to the cube above, and no less below") {
  const auto bound = [](double x, bool is_vertex_face, bool using_minimum_separation) {
    return ticcd::get_numerical_error({ticcd::Vector3(x, -x, 0)}, is_vertex_face, using_minimum_separation);
  };
  // The published constants.
  CHECK(bound(1, false, false)[0] == 6.217248937900877e-15);
  CHECK(bound(1, true, false)[0] == 6.661338147750939e-15);
  CHECK(bound(1, false, true)[0] == 7.105427357601002e-15);
  CHECK(bound(1, true, true)[0] == 7.549516567451064e-15);
  for (const bool is_vertex_face : {false, true}) {
    const ticcd::Array3 unit = bound(1, is_vertex_face, false);
    CHECK((bound(8, is_vertex_face, false) == ticcd::Array3(512 * unit[0], 512 * unit[0], unit[0])).all());
    CHECK((bound(0.125, is_vertex_face, false) == unit).all());
    CHECK(bound(1e200, is_vertex_face, false)[1] == std::numeric_limits<double>::infinity());
  }
  const std::vector<ticcd::Vector3> several = {{0, 2, 0}, {-4, 0, 0}, {1, -1, 1}};
  CHECK(
      (ticcd::get_numerical_error(several, false, false) == bound(1, false, false)[0] * ticcd::Array3(64, 8, 1)).all());
}

TEST_CASE("the bound on rounding errors holds at all scales, and one with the minimum would not") {
  double nearest = 0;
  std::size_t above_the_minimum = 0;
  const auto cases = static_cast<int>(effort(400));
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face}) {
    for (const double scale : {0x1p-1000, 1e-4, 0.01, 1.0, 64.0, 1000.0, 1e100}) {
      Rng rng(kind == Kind::edge_edge ? 43 : 44);
      for (int i = 0; i < cases; ++i) {
        const Query query = corner_hit(kind, scale, rng);
        const EigenCorners x = eigen_corners(query);
        const bool is_vertex_face = kind == Kind::vertex_face;
        const ticcd::Array3 bound = ticcd::get_numerical_error({x.begin(), x.end()}, is_vertex_face, false);
        const ticcd::Array3 of_unit = ticcd::get_numerical_error({ticcd::Vector3::Ones()}, is_vertex_face, false);
        for (int j = 0; j < 8; ++j) {
          // Multiples of 2^-53, which a NumCCD stores without rounding.
          const double t = rng.one_in(2) ? 1 : rng.unit();
          const double u = rng.one_in(2) ? 1 : rng.unit();
          const double v = std::floor((is_vertex_face ? 1 - u : 1) * rng.unit() * 0x1p53) * 0x1p-53;
          for (int k = 0; k < 3; ++k) {
            const mpq_class error =
                abs(exact_difference(kind, t, u, v, x, k) - mpq_class(rounded_difference(kind, t, u, v, x, k)));
            nearest = std::max(nearest, error.get_d() / bound[k]);
            if (error > mpq_class(bound[k])) {
              FAIL_CHECK("error " << error.get_d() << " > " << bound[k] << ": " << cpp_initializer(query));
            }
            // Tight-Inclusion's bound, with the greatest coordinate of all axes.
            const double smaller = of_unit[0] * std::pow(std::min(1.0, extent(query)), 3);
            above_the_minimum += error > mpq_class(smaller) ? 1 : 0;
          }
        }
      }
    }
  }
  std::printf("the greatest rounding error is %.3f of its bound\n", nearest);
  if (whole_effort("that the rounding errors come near the bound")) {
    CHECK(nearest > 0.02);
    CHECK(above_the_minimum > 1000);
  }
}

TEST_CASE("the bound on rounding errors needs finite vertices") {
  CHECK_THROWS_AS(ticcd::get_numerical_error({}, false, false), InvalidQuery);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    std::string message;
    try {
      ticcd::get_numerical_error({{0, 0, 0}, {0, bad, 0}}, true, false);
    } catch (const InvalidQuery& error) {
      message = error.what();
    }
    CHECK(message.find("vertex 1 ") == 0);
  }
}
