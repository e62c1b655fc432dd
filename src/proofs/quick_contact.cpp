// SPDX-License-Identifier: MIT
#include "proofs/quick_contact.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "exact/common_scale.hpp"
#include "exact/elements.hpp"
#include "filters/step_frame.hpp"
#include "geometry/frame.hpp"
#include "numbers/integers/fixed_int.hpp"

namespace touchstone::proofs {
namespace {

using exact::Forms;

// Coefficients are doubles off by a relative 2^-51 each. So a value at T in [0, 1], or a Bernstein coefficient over
// [0, T], of a degree of at most 6, is off by at most 2^-47 times the sum of the coefficients' absolute values, or of
// those of c_i T^i. A Bernstein coefficient over [T, U], with U - T <= 2^-52, differs from the value at T by at most
// 2^-52 times the derivative's bound, 6 times the sum.
constexpr double kValueError = 0x1p-46;

/// The sign of a polynomial's Bernstein coefficients over [T, U], or 0 where it is uncertain.
template <class N, int D>
int certain_sign(const numbers::Polynomial<N, D>& p, double t) {
  double value = 0;
  double sum = 0;
  for (int i = D; i >= 0; --i) {
    const double c = numbers::to_double(p[i]);
    value = value * t + c;
    sum += std::fabs(c);
  }
  const double error = kValueError * sum;
  return value > error ? 1 : value < -error ? -1 : 0;
}

/// Whether a polynomial's Bernstein coefficients over [0, T] certainly have the sign that it has at T.
template <class N, int D>
bool keeps_sign_until(const numbers::Polynomial<N, D>& p, double t, int sign_at_t) {
  if (p[0].sign() != sign_at_t) return false;
  double c[D + 1];  // of s^i, with s = t / T
  double sum = 0;
  double power = sign_at_t;
  for (int i = 0; i <= D; ++i, power *= t) {
    c[i] = numbers::to_double(p[i]) * power;
    sum += std::fabs(c[i]);
  }
  for (int k = 1; k < D; ++k) {
    double b = 0;
    double ratio = 1;  // C(k, i) / C(D, i)
    for (int i = 0; i <= k; ++i) {
      b += ratio * c[i];
      ratio *= static_cast<double>(k - i) / (D - i);
    }
    if (!(b > kValueError * sum)) return false;
  }
  return true;
}

template <class N, int D>
Dense dense(const numbers::Polynomial<N, D>& p, bool negative = false) {
  Dense result;
  result.reserve(D + 1);
  for (const N& c : p.c) result.push_back(numbers::to_exact(negative ? -c : c));
  return result;
}

/// One piece with the direction u x w, and `event` as the polynomial of the meeting, where it keeps its sign until T
/// and changes it between T and U.
template <class N, int D>
std::optional<Proof> proof_until(const numbers::Polynomial<N, D>& event, const Answer& answer) {
  std::optional<Proof> proof(std::in_place);
  Meeting& meeting = proof->meeting.emplace();
  meeting.root = dense(event);
  meeting.low = Exact(answer.toi);
  meeting.high = Exact(answer.toi_upper);
  const int before = numbers::sign_of(value(meeting.root, meeting.low));
  const int after = numbers::sign_of(value(meeting.root, meeting.high));
  if (before * after >= 0 || !keeps_sign_until(event, answer.toi, before)) return std::nullopt;
  while (numbers::is_zero(meeting.root.back())) meeting.root.pop_back();
  Piece& piece = proof->pieces.emplace_back();
  piece.normal = true;
  piece.until = meeting.low;
  return proof;
}

enum class Weighed { positive, not_positive, uncertain };

/// Sets the weights of geometry/frame.hpp, from the fractions' numerators and their denominator, times the sign that
/// makes those of an element positive.
template <class P>
Weighed weigh(Kind kind, const P& n, const P& first, const P& second, double t, Meeting& meeting) {
  const bool edges = kind == Kind::edge_edge;
  const std::array<P, 4> weights = edges ? std::array<P, 4>{n - first, first, n - second, second}
                                         : std::array<P, 4>{n, n - first - second, first, second};
  int signs[4];
  for (std::size_t i = 0; i < 4; ++i) {
    signs[i] = certain_sign(weights[i], t);
    if (signs[i] == 0) return Weighed::uncertain;
  }
  if (signs[2] != signs[3] || signs[1] != signs[edges ? 0 : 2]) return Weighed::not_positive;
  for (std::size_t i = 0; i < 4; ++i) meeting.weights[i] = dense(weights[i], signs[i] < 0);
  return Weighed::positive;
}

template <class N>
auto frame_in_integers(const Query& query, int low) {
  const auto corner = [&](std::size_t i) {
    const auto moving = [low](double start, double end) {
      const N from = N::scaled(start, low);
      return typename Forms<N>::Linear{{from, N::scaled(end, low) - from}};
    };
    const Vec3& a = query.start[i];
    const Vec3& b = query.end[i];
    return typename Forms<N>::Point{{moving(a.x, b.x), moving(a.y, b.y), moving(a.z, b.z)}};
  };
  return geometry::frame_of(query.kind, [&corner](std::size_t i, std::size_t j) { return corner(i) - corner(j); });
}

/// V changes its sign, and the weights are those along the first axis for which all of them are certainly positive.
template <class N>
std::optional<Proof> crossing(const Query& query, const Answer& answer, int low) {
  const auto frame = frame_in_integers<N>(query, low);
  const auto n = geometry::normal(frame);
  auto proof = proof_until(geometry::dot(n, frame.r), answer);
  for (std::size_t k = 0; k < 3 && proof; ++k) {
    const auto weighed = weigh(query.kind, n[k], geometry::first_numerator(frame, k),
                               geometry::second_numerator(query.kind, frame, k), answer.toi, *proof->meeting);
    if (weighed == Weighed::positive) return proof;
    if (weighed == Weighed::uncertain) break;
  }
  return std::nullopt;
}

/// V^2 - D^2 n . n becomes zero, which is |n|^2 times the difference of the squares of the distance and of D. The
/// weights are those of the closest points of two lines, or of a vertex and a plane. With coordinates and D of B bits,
/// n . n and the weights have at most 4 B + 16 bits, and the event 6 B + 23, by the bounds of exact::kMostBits.
template <class N>
std::optional<Proof> approach(const Query& query, const Answer& answer, double distance, int low) {
  const auto frame = frame_in_integers<N>(query, low);
  const auto n = geometry::normal(frame);
  const auto v = geometry::dot(n, frame.r);
  if (v[0].is_zero()) return std::nullopt;
  const auto square = geometry::dot(n, n);
  const N d = N::scaled(distance, low);
  auto event = v * v;
  for (int i = 0; i <= 4; ++i) event[i] = event[i] - square[i] * (d * d);
  auto proof = proof_until(event, answer);
  if (!proof || event[0].sign() < 0) return std::nullopt;
  const bool edges = query.kind == Kind::edge_edge;
  const auto second = edges ? geometry::cross(frame.r, frame.u) : geometry::cross(frame.u, frame.r);
  const auto weighed = weigh(query.kind, square, geometry::dot(geometry::cross(frame.r, frame.w), n),
                             geometry::dot(second, n), answer.toi, *proof->meeting);
  return weighed == Weighed::positive ? std::move(proof) : std::nullopt;
}

/// Keeps the weights of an element that are not zero, times the sign that makes them positive; false if there is none.
template <class N>
bool keep_signs(const std::array<N, 4>& weights, std::size_t begin, std::size_t end, Meeting& meeting) {
  int side = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const int sign = weights[i].sign();
    if (sign * side < 0) return false;
    if (sign != 0) side = sign;
  }
  for (std::size_t i = begin; i < end; ++i) {
    meeting.weights[i].clear();
    if (!weights[i].is_zero()) meeting.weights[i] = {numbers::to_exact(side < 0 ? -weights[i] : weights[i])};
  }
  return side != 0;
}

/// A contact at t = 0, which needs no piece: the weights of `crossing` or `approach` at this time.
template <class N>
std::optional<Proof> start(const Query& query, double distance, int low) {
  const bool edges = query.kind == Kind::edge_edge;
  const auto corner = [&](std::size_t i) {
    const Vec3& x = query.start[i];
    return geometry::Vector<N>{{N::scaled(x.x, low), N::scaled(x.y, low), N::scaled(x.z, low)}};
  };
  const auto frame =
      geometry::frame_of(query.kind, [&corner](std::size_t i, std::size_t j) { return corner(i) - corner(j); });
  const auto n = geometry::normal(frame);
  const auto v = geometry::dot(n, frame.r);
  std::optional<Proof> proof(std::in_place);
  Meeting& meeting = proof->meeting.emplace();
  meeting.low = meeting.high = Exact(0);
  const auto keep = [&](const auto& whole, const auto& first, const auto& second) {
    using Weights = std::array<std::decay_t<decltype(first)>, 4>;
    const Weights weights = edges ? Weights{whole - first, first, whole - second, second}
                                  : Weights{whole, whole - first - second, first, second};
    const std::size_t size = edges ? 2 : 1;  // of the first element
    return keep_signs(weights, 0, size, meeting) && keep_signs(weights, size, 4, meeting);
  };
  if (distance == 0) {
    for (std::size_t k = 0; k < 3 && v.is_zero(); ++k) {
      const auto second = geometry::second_numerator(query.kind, frame, k);
      if (keep(n[k], geometry::first_numerator(frame, k), second)) return proof;
    }
    return std::nullopt;
  }
  const N d = N::scaled(distance, low);
  const auto square = geometry::dot(n, n);
  if ((v * v - square * (d * d)).sign() > 0) return std::nullopt;
  const auto second = edges ? geometry::cross(frame.r, frame.u) : geometry::cross(frame.u, frame.r);
  const auto first = geometry::dot(geometry::cross(frame.r, frame.w), n);
  return keep(square, first, geometry::dot(second, n)) ? std::move(proof) : std::nullopt;
}

}  // namespace

std::optional<Proof> quick_contact(const Query& query, const Answer& answer, const Separation& separation) {
  static_assert(4 * exact::kMostBits<exact::Short> + 16 < 256 && 6 * exact::kMostBits<exact::Short> + 23 < 384);
  static_assert(4 * exact::kMostBits<exact::Medium> + 16 < 512 && 6 * exact::kMostBits<exact::Medium> + 23 < 768);
  const double distance = separation.distance;
  if (!filters::has_cubic(query.kind) || (answer.toi == answer.toi_upper && answer.toi > 0)) return std::nullopt;
  if (distance > 0 && separation.metric == Metric::max) return std::nullopt;
  exact::BitSpan span = exact::coordinate_span(query);
  span.add(distance);
  const int bits = span.bits();
  if (bits > exact::kMostBits<exact::Medium>) return std::nullopt;
  const bool is_short = bits <= exact::kMostBits<exact::Short>;
  if (answer.toi_upper == 0) {
    return is_short ? start<exact::Short>(query, distance, span.low) : start<exact::Medium>(query, distance, span.low);
  }
  if (distance == 0) {
    return is_short ? crossing<exact::Short>(query, answer, span.low)
                    : crossing<exact::Medium>(query, answer, span.low);
  }
  return is_short ? approach<exact::Short>(query, answer, distance, span.low)
                  : approach<exact::Medium>(query, answer, distance, span.low);
}

}  // namespace touchstone::proofs
