// Double-double values of V and the side conditions against exact arithmetic: their bounds hold under search, and every
// processor's code takes the same steps.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstring>

#include "filters/bernstein_cubic.hpp"
#include "filters/bound_search.hpp"
#include "filters/contact_values_steps.hpp"
#include "filters/coplanarity_form.hpp"
#include "numbers/integers/exact_number.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using filters::ContactValues;
using numbers::Exact;

namespace {

using ExactVector = std::array<Exact, 3>;

struct Input {
  std::array<Vec3, 4> start, end;
  double t;
  std::size_t axis;

  explicit Input(const std::vector<double>& x) {
    for (std::size_t i = 0; i < 4; ++i) {
      start[i] = {x[3 * i], x[3 * i + 1], x[3 * i + 2]};
      end[i] = {x[12 + 3 * i], x[12 + 3 * i + 1], x[12 + 3 * i + 2]};
    }
    int exponent;
    const double significand = std::fabs(std::frexp(x[24], &exponent));  // in [1/2, 1)
    t = filters::exact_to_one(x[24] > 0 ? significand : 1 - significand);
    axis = static_cast<std::size_t>(std::fabs(std::frexp(x[25], &exponent)) * 6 - 3) % 3;
  }

  Query query(bool edges) const { return edges ? Query(EdgeEdge{start, end}) : Query(VertexFace{start, end}); }
  ContactValues values(bool edges) const { return filters::contact_values(query(edges), t, axis); }

  ExactVector difference(std::size_t i, std::size_t j) const {
    const auto along = [&](double Vec3::*k) {
      const Exact from = Exact(start[i].*k) - Exact(start[j].*k);
      const Exact to = Exact(end[i].*k) - Exact(end[j].*k);
      return (Exact(1) - Exact(t)) * from + Exact(t) * to;
    };
    return {along(&Vec3::x), along(&Vec3::y), along(&Vec3::z)};
  }

  /// The largest coordinate, at either end, of the computed difference of two corners.
  double bound(std::size_t i, std::size_t j) const {
    double m = 0;
    for (const auto* side : {&start, &end}) {
      const Vec3 &a = (*side)[i], &b = (*side)[j];
      m = std::max({m, std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(a.z - b.z)});
    }
    return m;
  }
};

Input random_input(Rng& rng) {
  std::vector<double> x(26);
  const int exponent = rng.between(-200, 200);
  const int spread = rng.between(0, 30);
  for (double& v : x) v = std::ldexp(rng.unit() - 0.5, exponent - rng.between(0, spread));
  return Input(x);
}

Exact cross_at(const ExactVector& a, const ExactVector& b, std::size_t k) {
  return a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

/// |error| / bound of a value before its rounding to a double.
double ratio(const numbers::DoubleDouble& computed, const Exact& truth, double bound) {
  return std::fabs(numbers::approximate_quotient(Exact(computed.high) + Exact(computed.low) - truth, Exact(bound)));
}

/// |error| / bound of V (which = 0) or the worst of the components (1).
double worst_ratio(const std::vector<double>& x, bool edges, int which) {
  const Input in(x);
  const auto pick = [edges](std::size_t e, std::size_t f) { return edges ? e : f; };
  const std::size_t u_to = pick(1, 2), u_from = pick(0, 1), w_to = 3, w_from = pick(2, 1), r_to = pick(2, 0),
                    r_from = pick(0, 1);
  const ExactVector u = in.difference(u_to, u_from);
  const ExactVector w = in.difference(w_to, w_from);
  const ExactVector r = in.difference(r_to, r_from);
  const double U = in.bound(u_to, u_from);
  const double W = in.bound(w_to, w_from);
  const double R = in.bound(r_to, r_from);
  if (!(std::min({U, W, R}) >= 0x1p-250 && std::max({U, W, R}) <= 0x1p250)) return std::nan("");
  const auto at = filters::precise_values(in.query(edges), in.t, in.axis);
  const ExactVector n = {cross_at(u, w, 0), cross_at(u, w, 1), cross_at(u, w, 2)};
  if (which == 0)
    return ratio(at.coplanarity, n[0] * r[0] + n[1] * r[1] + n[2] * r[2], filters::kCoplanarityError * (U * W * R));
  const Exact f1 = cross_at(r, w, in.axis);
  const Exact f2 = edges ? cross_at(r, u, in.axis) : cross_at(u, r, in.axis);
  const Exact& nk = n[in.axis];
  const double k = filters::kComponentError;
  double worst = std::max({ratio(at.normal.value, nk, k * U * W), ratio(at.first.value, f1, k * R * W),
                           ratio(at.second.value, f2, k * R * U)});
  if (edges) {
    worst = std::max({worst, ratio(at.third.value, nk - f1, k * (U * W + R * W)),
                      ratio(at.fourth.value, nk - f2, k * (U * W + R * U))});
  } else {
    worst = std::max(worst, ratio(at.third.value, nk - f1 - f2, k * (U * W + R * W + R * U)));
  }
  return worst;
}

/// Moves one corner near to the origin relative to the others. The differences of corners are then as large as their
/// bounds, and their low parts are as long as possible. b1 continues from b0.
std::vector<double> spread_out(std::vector<double> x, bool edges) {
  for (std::size_t side : {0u, 12u}) {
    for (std::size_t k = 0; k < 3; ++k) {
      x[side + (edges ? 0 : 3) + k] *= 0x1p-40;
      if (edges) x[side + 9 + k] += x[side + 6 + k];
    }
  }
  return x;
}

}  // namespace

TEST_CASE("double-double values are within their bounds at all magnitudes", "[slow]") {
  static const char* const names[] = {"V in double-doubles", "components in double-doubles"};
  for (const int which : {0, 1}) {
    BoundSearch search;
    Rng rng(71 + static_cast<unsigned>(which));
    for (const bool edges : {true, false}) {
      const auto measured = [&](const std::vector<double>& x) {
        return worst_ratio(spread_out(x, edges), edges, which);
      };
      constexpr int kSteps = kLongSearches ? 100000 : 300;
      search_bound(search, rng, 26, 0, 0, 2, kSteps, measured);
      for (const int exponent : {40, -40, 240, -200}) {
        search_bound(search, rng, 26, exponent, 0, 1, kSteps / 50, measured);
        search_bound(search, rng, 26, exponent, 40, 1, kSteps / 100, measured);
      }
    }
    report(names[which], search);
  }
}

TEST_CASE("the slopes are the derivatives") {
  Rng rng(75);
  for (int round = 0; round < 200; ++round) {
    std::vector<double> x(26);
    for (double& v : x) v = rng.unit() - 0.5;
    Input in(x);
    in.t = filters::exact_to_one(0.25 + 0.5 * rng.unit());
    for (const bool edges : {true, false}) {
      constexpr double h = 0x1p-20;
      const ContactValues at = in.values(edges);
      in.t += h;
      const ContactValues later = in.values(edges);
      in.t -= h;
      const auto close = [](const filters::ValueAndSlope& a, const filters::ValueAndSlope& b) {
        return std::fabs((b.value - a.value) / h - a.slope) < 0x1p-14;  // second derivatives are at most 16
      };
      CHECK((close(at.normal, later.normal) && close(at.first, later.first) && close(at.second, later.second)));
      CHECK((close(at.third, later.third) && close(at.fourth, later.fourth)));
    }
  }
}

TEST_CASE("fused and plain steps give the same bits") {
  const filters::ContactValuesFunctions& plain_steps = *filters::contact_values_functions(false);
  const filters::ContactValuesFunctions* const fused_steps = filters::contact_values_functions(true);
  if (fused_steps == nullptr) {
    skip("this processor, or compiler, has no fused multiply-add to compare with");
    return;
  }
  Rng rng(76);
  for (int round = 0; round < 20000; ++round) {
    const Input in = random_input(rng);
    const Query query = in.query(rng.one_in(2));
    const ContactValues plain = plain_steps.all(query, in.t, in.axis);
    const ContactValues fused = fused_steps->all(query, in.t, in.axis);
    REQUIRE(std::memcmp(&plain, &fused, sizeof plain) == 0);
  }
}

TEST_CASE("V alone has the bits of V with the components") {
  for (const bool fused : {false, true}) {
    const filters::ContactValuesFunctions* const steps = filters::contact_values_functions(fused);
    if (steps == nullptr) continue;  // the test above says so
    Rng rng(77);
    for (int round = 0; round < 20000; ++round) {
      const Input in = random_input(rng);
      const Query query = in.query(rng.one_in(2));
      const double with_components = steps->all(query, in.t, in.axis).coplanarity;
      const double alone = steps->coplanarity(query, in.t);
      REQUIRE(std::memcmp(&with_components, &alone, sizeof alone) == 0);
    }
  }
}
