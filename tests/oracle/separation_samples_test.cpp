// The oracle with a separation against distances at single times, by formulas of this test's own. Corners are small
// integers, so that elements are often parallel, flat or at exactly the separation, and everything here is exact except
// what is said to be in doubles.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>
#include <vector>

#include "oracle/algebra.hpp"
#include "oracle/elements_at.hpp"
#include "oracle/expected.hpp"
#include "support/query_families.hpp"
#include "support/report.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

using oracle::Rational;

constexpr std::uint64_t kSeed = 1212;
constexpr int kQueries = 800;  // of each kind in each metric

double distance_of(const Elements<double>& elements, Metric metric) {
  const double measured = measure(elements, metric);
  return metric == Metric::euclidean ? std::sqrt(measured) : measured;
}

Query small_query(seeded::Rng& rng, Kind kind) {
  Query query;
  query.kind = kind;
  const int size = rng.between(1, 5);
  const bool same_motion = rng.one_in(4);
  const bool flat = rng.one_in(4);
  for (std::size_t i = 0; i < corner_count(kind); ++i) {
    const auto corner = [&] {
      const auto coordinate = [&] { return static_cast<double>(rng.between(-size, size)); };
      return Vec3{coordinate(), coordinate(), flat ? 0.0 : coordinate()};
    };
    query.start[i] = corner();
    query.end[i] = corner();
    const std::size_t first = kind == Kind::edge_edge ? i / 2 * 2 : i == 0 ? 0 : 1;
    if (!same_motion || first == i) continue;
    const Vec3& x0 = query.start[first];
    const Vec3& x1 = query.end[first];
    const Vec3& start = query.start[i];
    query.end[i] = {start.x + x1.x - x0.x, start.y + x1.y - x0.y, start.z + x1.z - x0.z};
  }
  return query;
}

/// A point of an element by its weights, in doubles.
plain::Point<double> weighted(const plain::Element<double>& element, const Weights& weights) {
  plain::Point<double> point = {0, 0, 0};
  for (std::size_t i = 0; i < element.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) point[k] += weights[i] * element[i][k];
  }
  return point;
}

/// The weights that a feature's name allows to be positive, as bits; all of them for an overlap.
unsigned support_of(Feature feature) {
  switch (feature) {
    case Feature::a0:
    case Feature::b0:
    case Feature::v:
    case Feature::f0:
    case Feature::p:
    case Feature::e0:
    case Feature::q: return 1;
    case Feature::a1:
    case Feature::b1:
    case Feature::f1:
    case Feature::e1: return 2;
    case Feature::a:
    case Feature::b:
    case Feature::e:
    case Feature::f01: return 3;
    case Feature::f2: return 4;
    case Feature::f20: return 5;
    case Feature::f12: return 6;
    default: return 7;
  }
}

unsigned support_of(const Weights& weights) {
  unsigned support = 0;
  for (unsigned i = 0; i < 3; ++i) {
    if (weights[i] > 0) support |= 1U << i;
  }
  return support;
}

/// Whether one of the elements has less than its full dimension, so that weights are not unique.
bool is_degenerate(const Elements<double>& elements) {
  const auto size = [](const plain::Point<double>& x) { return std::sqrt(plain::dot(x, x)); };
  for (const auto* element : {&elements.a, &elements.b}) {
    if (element->size() == 2 && size(plain::minus((*element)[1], (*element)[0])) < 1e-6) return true;
    if (element->size() < 3) continue;
    const auto n = plain::cross(plain::minus((*element)[1], (*element)[0]), plain::minus((*element)[2], (*element)[0]));
    if (size(n) < 1e-6) return true;
  }
  return false;
}

constexpr double kClear = 1e-5;  // a step in a weight that changes the distance clearly

/// The parts of two elements whose weights come before those of the answer by a clear step. Each must be farther away.
std::vector<Elements<double>> smaller_weights(const Elements<double>& at, const Answer& answer) {
  std::vector<Elements<double>> parts;
  const auto point = [&](const plain::Element<double>& element, double w0, double w1, double w2) {
    return weighted(element, {w0, w1, w2});
  };
  plain::Element<double> a = at.a;
  if (a.size() == 2) {
    const double w = answer.weights_a[0] - kClear;
    if (w > 0) parts.push_back({{point(a, w, 1 - w, 0), a[1]}, at.b});
    a = {weighted(a, answer.weights_a)};
  }
  const Weights& weights = answer.weights_b;
  const double w = weights[0] - kClear;
  if (at.b.size() == 2 && w > 0) parts.push_back({a, {point(at.b, w, 1 - w, 0), at.b[1]}});
  if (at.b.size() != 3) return parts;
  if (w > 0) {  // the part is a quadrilateral: two triangles
    const auto on_f01 = point(at.b, w, 1 - w, 0);
    const auto on_f20 = point(at.b, w, 0, 1 - w);
    parts.push_back({a, {at.b[1], at.b[2], on_f01}});
    parts.push_back({a, {at.b[2], on_f20, on_f01}});
  }
  const double v = weights[1] - kClear;
  if (v > 0)
    parts.push_back({a, {point(at.b, weights[0], v, 1 - weights[0] - v), point(at.b, weights[0], 0, 1 - weights[0])}});
  return parts;
}

/// Counts that show that the test is about something.
struct Tally {
  int contacts = 0;
  int starts_within = 0;
  int natures[6] = {};
  int overlaps = 0;
  int not_doubles = 0;
  int smaller = 0;
};

class Checker {
 public:
  Checker(const Query& query, const Separation& separation)
      : query_(query),
        metric_(separation.metric),
        distance_(separation.distance),
        level_(metric_ == Metric::euclidean ? Rational(Rational(distance_) * Rational(distance_))
                                            : Rational(distance_)) {}

  /// For any query: the first time is the first one, as far as single times tell.
  void check_first(const Answer& answer, double t_max) const {
    CHECK(answer.level == Level::oracle);
    const Rational start = at(Rational(0));
    CHECK(answer.starts_within == (start <= level_));
    check_samples(answer, t_max);
    if (!answer.contact) {
      CHECK(answer.trend == Trend::none);
      return;
    }
    if (answer.starts_within) {
      CHECK(answer.toi_upper == 0);
      if (start < level_) CHECK(answer.nature == Nature::sustained);
      return;
    }
    if (answer.toi == answer.toi_upper) {
      CHECK(at(Rational(answer.toi)) == level_);
    } else {
      CHECK(answer.toi_upper == std::nextafter(answer.toi, 2));
      CHECK(at(Rational(answer.toi)) > level_);
    }
  }

  /// For corners that are small integers: everything.
  void check(const Answer& answer, double t_max, Tally& tally) const {
    check_first(answer, t_max);
    if (!answer.contact) return;
    ++tally.contacts;
    ++tally.natures[static_cast<int>(answer.nature)];
    if (answer.starts_within) ++tally.starts_within;
    if (answer.toi < answer.toi_upper) ++tally.not_doubles;
    if (answer.feature_a == Feature::overlap) ++tally.overlaps;
    check_change(answer);
    check_place(answer, tally);
  }

 private:
  Rational at(const Rational& t) const { return measure(elements_at(query_, t), metric_); }

  void check_samples(const Answer& answer, double t_max) const {
    constexpr int samples = 24;  // thirds and eighths among them
    for (int i = 0; i <= samples; ++i) {
      const Rational t = Rational(t_max) * Rational(i, samples);
      const bool is_before =
          !answer.contact || t < Rational(answer.toi) || (t == Rational(answer.toi) && answer.toi < answer.toi_upper);
      if (is_before) CHECK(at(t) > level_);
    }
  }

  /// Nature and trend.
  void check_change(const Answer& answer) const {
    const Rational after = Rational(answer.toi_upper) + Rational(1, 1 << 24);
    const Rational before = Rational(answer.toi) - Rational(1, 1 << 24);
    const Rational level = std::min(at(Rational(answer.toi)), level_);
    // Small integers leave no other change of the distance's sign within 2^-24 of this one.
    const auto change = CGAL::compare(at(after), level);
    CHECK(answer.trend == (change < 0 ? Trend::approaching : change > 0 ? Trend::leaving : Trend::constant));
    if (level < level_) return;
    const auto earlier = CGAL::compare(at(before), level);
    CHECK(answer.nature == (change < 0    ? Nature::entering
                            : change == 0 ? Nature::sustained
                            : earlier > 0 ? Nature::grazing
                                          : Nature::isolated));
  }

  void check_place(const Answer& answer, Tally& tally) const {
    const Elements<double> now = elements_at(query_, answer.toi);
    const double distance = std::min(distance_, distance_of(now, metric_));
    const Elements<double> pair = {{weighted(now.a, answer.weights_a)}, {weighted(now.b, answer.weights_b)}};
    CHECK(std::abs(distance_of(pair, metric_) - distance) < 1e-12);
    if (answer.feature_a == Feature::overlap) {
      CHECK(answer.feature_b == Feature::overlap);
      CHECK(metric_ == Metric::euclidean);
      CHECK(plain::dot(plain::cross(plain::minus(now.a[1], now.a[0]), plain::minus(now.b[1], now.b[0])),
                       plain::cross(plain::minus(now.a[1], now.a[0]), plain::minus(now.b[1], now.b[0]))) < 1e-20);
    } else {
      CHECK(support_of(answer.weights_a) == support_of(answer.feature_a));
      CHECK(support_of(answer.weights_b) == support_of(answer.feature_b));
    }
    if (is_degenerate(now)) return;
    for (const auto& part : smaller_weights(now, answer)) {
      ++tally.smaller;
      CHECK(distance_of(part, metric_) - distance > 1e-13);
    }
  }

  const Query& query_;
  Metric metric_;
  double distance_;
  Rational level_;
};

/// A separation that the elements have at some time of the step, or nearly, as far as doubles can tell.
double separation_between(const Query& query, Metric metric, seeded::Rng& rng) {
  double distance = distance_of(elements_at(query, rng.between(0, 8) / 8.0), metric);
  if (rng.one_in(3)) distance *= rng.unit();
  if (rng.one_in(4)) distance = std::nextafter(distance, rng.one_in(2) ? 0 : HUGE_VAL);
  return distance > 0 && distance < HUGE_VAL ? distance : std::ldexp(1.0, rng.between(-1074, 1023));
}

void check_kind(Kind kind, Metric metric) {
  static constexpr std::array<double, 8> distances = {0.25, 0.5, 1, 1, 1.5, 2, 3, 0.625};
  seeded::Rng rng(
      seeded::seed_of_stream(kSeed, static_cast<std::uint64_t>(kind) * 2 + static_cast<std::uint64_t>(metric)));
  Tally tally;
  for (int i = 0; i < kQueries; ++i) {
    const Query query = small_query(rng, kind);
    const Separation separation = {distances[rng.below(distances.size())], metric};
    const double t_max = rng.one_in(4) ? rng.between(0, 8) / 8.0 : 1;
    INFO("number " << i << ", separation " << separation.distance << " " << name_of(metric) << ", t_max " << t_max);
    INFO(cpp_initializer(query));
    const Answer answer = oracle::decide_by_oracle(query, t_max, separation);
    INFO(describe(answer) << " " << name_of(answer.trend));
    Checker(query, separation).check(answer, t_max, tally);
  }
  const auto seen = [&](Nature nature) { return tally.natures[static_cast<int>(nature)]; };
  INFO(name_of(kind) << " " << name_of(metric));
  CHECK(tally.contacts > kQueries / 5);
  CHECK(tally.contacts < kQueries);
  CHECK(tally.starts_within > kQueries / 20);
  CHECK(seen(Nature::entering) > kQueries / 20);
  CHECK(seen(Nature::sustained) > kQueries / 20);
  CHECK(seen(Nature::grazing) > 0);
  CHECK(seen(Nature::isolated) > 0);
  CHECK(tally.not_doubles > kQueries / 20);
  CHECK((tally.overlaps > 0) == (kind == Kind::edge_edge && metric == Metric::euclidean));
  CHECK((tally.smaller > 0) == (kind != Kind::point_point));
}

}  // namespace

TEST_CASE("the Euclidean distance at single times agrees with the first time within a separation", "[slow]") {
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face, Kind::point_edge, Kind::point_point}) {
    check_kind(kind, Metric::euclidean);
  }
}

TEST_CASE("the largest-axis distance at single times agrees with the first time within a separation", "[slow]") {
  for (const Kind kind : {Kind::edge_edge, Kind::vertex_face, Kind::point_edge, Kind::point_point}) {
    check_kind(kind, Metric::max);
  }
}

TEST_CASE("no time of hard queries of every magnitude is within a separation before the first one", "[slow]") {
  for_each_case(
      kSeed, 1, [](const FamilyInfo&, Kind) { return true; },
      [&](const CaseId& id) {
        const Query query = make(id);
        seeded::Rng rng(seeded::seed_of_stream(kSeed, id.index + 64 * static_cast<std::uint64_t>(id.family)));
        for (const Metric metric : {Metric::euclidean, Metric::max}) {
          const Separation separation = {separation_between(query, metric, rng), metric};
          INFO(case_name(id) << ", separation " << hexfloat(separation.distance) << " " << name_of(metric));
          INFO(cpp_initializer(query));
          const Answer answer = oracle::decide_by_oracle(query, 1, separation);
          INFO(describe(answer) << " " << name_of(answer.trend));
          Checker(query, separation).check_first(answer, 1);
        }
      });
}
