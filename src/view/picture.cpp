// SPDX-License-Identifier: MIT
#include "view/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "io/times.hpp"
#include "numbers/roots/real_root.hpp"
#include "proofs/elements.hpp"
#include "proofs/proof.hpp"
#include "view/basis.hpp"
#include "view/closest_points.hpp"

namespace touchstone::view {
namespace {

using nlohmann::json;

/// The proof of an answer over [0, 1].
std::optional<proofs::Proof> proof_of(const io::FileQuery& query, const Answer& answer, double t_max,
                                      const Separation& separation) {
  if (t_max != 1) return std::nullopt;
  return std::visit([&](const auto& of_sort) { return std::optional(proofs::prove(of_sort, answer, separation)); },
                    query);
}

/// The contact's time within its two doubles.
Exact contact_time(const MovingCorners& corners, const Answer& answer, const std::optional<proofs::Proof>& proof) {
  const Exact low(answer.toi), high(answer.toi_upper);
  if (low == high) return low;
  if (proof && proof->meeting && !proof->meeting->root.empty()) {
    return narrowed_root(proof->meeting->root, proof->meeting->low, proof->meeting->high);
  }
  const Dense v = corners.coplanarity();
  if (!v.empty() && numbers::sign_of(value(v, low)) * numbers::sign_of(value(v, high)) < 0) {
    return narrowed_root(v, low, high);
  }
  return high;
}

Origin origin_with_proof(const MovingCorners& corners, const Answer& answer, double t_max,
                         const std::optional<proofs::Proof>& proof) {
  Exact t = answer.contact ? contact_time(corners, answer, proof) : closest_approach(corners, t_max);
  auto weights = closest_points(corners, t).weights;
  return {std::move(t), std::move(weights)};
}

/// Turns exact coefficients into doubles: divided by one number, and lengths also by 2^exponent.
class Rounded {
 public:
  Rounded(Exact divisor, long exponent) : divisor_(std::move(divisor)), scale_(numbers::power_of_two(-exponent)) {}

  json operator()(const Dense& p) const {
    json result = json::array();
    for (const Exact& c : trimmed(p)) result.push_back(finite(numbers::approximate_quotient(c * scale_, divisor_)));
    return result;
  }
  json operator()(const DenseVector& p) const { return {(*this)(p[0]), (*this)(p[1]), (*this)(p[2])}; }

 private:
  /// JSON has no infinity.
  static double finite(double x) { return std::clamp(x, -1e300, 1e300); }

  Exact divisor_;
  Exact scale_;
};

DenseVector weighted(const std::array<DenseVector, 4>& corners, const std::array<Exact, 4>& weights, std::size_t begin,
                     std::size_t end) {
  DenseVector sum;
  for (std::size_t i = begin; i < end; ++i) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] = sum[k] + weights[i] * corners[i][k];
  }
  return sum;
}

/// The exponent of the largest of the numbers in [2^(e-1), 2^e]; 0 without one.
class LargestExponent {
 public:
  void add(const Exact& numerator, const Exact& denominator) {
    if (numbers::is_zero(numerator)) return;
    const auto n = numbers::approximate(numerator), d = numbers::approximate(denominator);
    const long exponent = n.exponent - d.exponent + 1;
    largest_ = largest_ ? std::max(*largest_, exponent) : exponent;
  }
  long value() const { return largest_.value_or(0); }

 private:
  std::optional<long> largest_;
};

/// The picture's motions: polynomials in the time since the origin.
struct Motions {
  std::array<DenseVector, 4> corners;  // relative to nothing
  std::array<DenseVector, 2> feet;     // the closest points, carried along by their elements
  Dense denominator;
  long exponent = 0;  // of the largest distance from the origin's place, at the origin's time and both ends

  Exact unit() const { return denominator.front(); }
};

Motions motions_of(const MovingCorners& corners, const Origin& origin, double t_max) {
  Motions motions;
  for (std::size_t i = 0; i < corners.count; ++i) motions.corners[i] = shifted(corners.numerators[i], origin.t);
  motions.denominator = trimmed(shifted(corners.denominator, origin.t));
  motions.feet = {weighted(motions.corners, origin.weights, 0, corners.first_count),
                  weighted(motions.corners, origin.weights, corners.first_count, corners.count)};
  LargestExponent largest;
  const Exact zero(0);
  for (const Exact& s : {zero, -origin.t, Exact(t_max) - origin.t}) {
    const Exact unit = motions.unit(), at_s = value(motions.denominator, s);
    for (std::size_t i = 0; i < corners.count; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Exact position = value(motions.feet[0][k], zero) * at_s;
        largest.add(value(motions.corners[i][k], s) * unit - position, at_s * unit);
      }
    }
  }
  motions.exponent = largest.value();
  return motions;
}

DenseVector carrier_of(const Motions& motions) {
  DenseVector result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Dense& foot = motions.feet[0][k];
    const Exact position = foot.empty() ? Exact(0) : foot.front();
    result[k] = motions.unit() * foot - position * motions.denominator;
  }
  return result;
}

json mark(double t, double s, const char* sort, std::string text) {
  return {{"t", t}, {"s", s}, {"sort", sort}, {"text", std::move(text)}};
}

double difference_as_double(const Exact& t, const Exact& origin) { return numbers::to_double(t - origin); }

std::string enclosed(double lower, double upper) {
  return lower == upper ? "= " + io::hexfloat(lower) : "in [" + io::hexfloat(lower) + ", " + io::hexfloat(upper) + "]";
}

void add_roots(json& marks, const MovingCorners& corners, const Origin& origin, const Answer& answer, double t_max) {
  const Dense v = corners.coplanarity();
  if (v.size() < 2) return;
  const numbers::RootList roots = numbers::isolate_roots(proofs::coefficients(v), Exact(t_max));
  for (int i = 0; i < roots.size(); ++i) {
    const numbers::RealRoot& root = roots[i];
    const Exact low(root.lower()), high(root.upper());
    const bool changes = numbers::sign_of(value(v, low)) * numbers::sign_of(value(v, high)) < 0;
    const bool at_origin = root.compare(origin.t) == 0 ||
                           (answer.contact && root.lower() == answer.toi && root.upper() == answer.toi_upper);
    const double s = at_origin ? 0 : difference_as_double(changes ? narrowed_root(v, low, high) : low, origin.t);
    const std::string fold = root.multiplicity() > 1 ? fmt::format(", {}-fold", root.multiplicity()) : std::string();
    marks.push_back(mark(root.lower(), s, "root",
                         fmt::format("root {} of V{}: t {}", i + 1, fold, enclosed(root.lower(), root.upper()))));
  }
}

json marks_of(const MovingCorners& corners, const Origin& origin, const Answer& answer, double t_max) {
  json marks = json::array();
  marks.push_back(mark(0, difference_as_double(Exact(0), origin.t), "start", "start: t = 0"));
  add_roots(marks, corners, origin, answer, t_max);
  if (answer.contact) {
    marks.push_back(mark(answer.toi, 0, "contact", "first contact: t " + enclosed(answer.toi, answer.toi_upper)));
    if (answer.toi != answer.toi_upper) {
      marks.push_back(mark(answer.toi, difference_as_double(Exact(answer.toi), origin.t), "toi",
                           "toi, a safe step: t = " + io::hexfloat(answer.toi)));
    }
  } else {
    const double t = numbers::to_double(origin.t);
    marks.push_back(mark(t, 0, "closest", fmt::format("closest approach: t about {}", t)));
  }
  marks.push_back(
      mark(t_max, difference_as_double(Exact(t_max), origin.t), "end", fmt::format("t_max: t = {}", t_max)));
  return marks;
}

/// The planes keep the elements apart from 0, each until its time.
json planes_of(const proofs::Proof& proof, const MovingCorners& corners, const Motions& motions, const Origin& origin) {
  json planes = json::array();
  const Rounded lengths(motions.unit(), motions.exponent);
  for (const proofs::Piece& piece : proof.pieces) {
    DenseVector normal = piece.direction;
    if (piece.normal) {
      const auto frame = geometry::frame_of(
          corners.kind, [&](std::size_t i, std::size_t j) { return corners.numerators[i] - corners.numerators[j]; });
      normal = cross(frame.u, frame.w);
    }
    normal = shifted(normal, origin.t);
    LargestExponent size;
    for (const Dense& coordinate : normal.c) {
      for (const Exact& c : coordinate) size.add(c, Exact(1));
    }
    const Exact scale = numbers::power_of_two(-size.value());
    for (Dense& coordinate : normal.c) coordinate = scale * coordinate;
    json offsets = json::array();
    for (std::size_t i = 0; i < corners.count; ++i) {
      offsets.push_back(lengths(dot(normal, motions.corners[i] - motions.feet[0])));
    }
    planes.push_back({{"until", numbers::to_double(piece.until)},
                      {"untilS", difference_as_double(piece.until, origin.t)},
                      {"normal", Rounded(Exact(1), 0)(normal)},
                      {"offsets", std::move(offsets)}});
  }
  return planes;
}

/// log2 of the distance at the origin in units of the picture, or nothing for one of about zero.
std::optional<double> logarithm_of_gap(const DenseVector& gap, const Motions& motions) {
  LargestExponent size;
  bool any = false;
  for (const Dense& coordinate : gap.c) {
    if (coordinate.empty() || numbers::is_zero(coordinate.front())) continue;
    size.add(coordinate.front(), motions.unit());
    any = true;
  }
  if (!any) return std::nullopt;
  return static_cast<double>(size.value() - motions.exponent);
}

}  // namespace

Origin origin_of(const io::FileQuery& query, const MovingCorners& corners, const Answer& answer, double t_max,
                 const Separation& separation) {
  return origin_with_proof(corners, answer, t_max, proof_of(query, answer, t_max, separation));
}

json picture_of(const io::FileQuery& query, const Answer& answer, double t_max, const Separation& separation) {
  const MovingCorners corners = moving_corners_of(query);
  const auto proof = proof_of(query, answer, t_max, separation);
  const Origin origin = origin_with_proof(corners, answer, t_max, proof);
  const Motions motions = motions_of(corners, origin, t_max);
  const Rounded lengths(motions.unit(), motions.exponent);

  json names = json::array(), weights = json::array(), offsets = json::array();
  for (std::size_t i = 0; i < corners.count; ++i) {
    names.push_back(std::string(corner_name(corners.kind, i)));
    weights.push_back(numbers::to_double(origin.weights[i]));
    offsets.push_back(lengths(motions.corners[i] - motions.feet[i < corners.first_count ? 0 : 1]));
  }
  const DenseVector gap = motions.feet[1] - motions.feet[0];
  constexpr double kDeepest = 200, kNearlyZero = -190;  // the origin of a contact is within about 2^-240
  const auto logarithm = logarithm_of_gap(gap, motions);
  const bool apart = logarithm && *logarithm > kNearlyZero;
  json result = {{"kind", std::string(name_of(corners.kind))},
                 {"names", std::move(names)},
                 {"first", corners.first_count},
                 {"planar", corners.is_planar()},
                 {"contact", answer.contact},
                 {"separation", separation.distance > 0},
                 {"t", numbers::to_double(origin.t)},
                 {"tMax", t_max},
                 {"exponent", motions.exponent},
                 {"deepest", apart ? std::clamp(std::ceil(-*logarithm) + 2, 6.0, kDeepest) : 100.0},
                 {"apart", apart},
                 {"denominator", Rounded(motions.unit(), 0)(motions.denominator)},
                 {"carrier", Rounded(motions.unit() * motions.unit(), motions.exponent)(carrier_of(motions))},
                 {"gap", lengths(gap)},
                 {"corners", std::move(offsets)},
                 {"weights", std::move(weights)},
                 {"marks", marks_of(corners, origin, answer, t_max)},
                 {"planes", proof ? planes_of(*proof, corners, motions, origin) : json::array()}};
  result["basis"] = first_view(result);
  return result;
}

}  // namespace touchstone::view
