// SPDX-License-Identifier: MIT
#include "proofs/meeting.hpp"

#include <utility>
#include <vector>

#include <touchstone/error.hpp>

#include "numbers/common_divisor.hpp"
#include "numbers/real_root.hpp"

namespace touchstone::proofs {
namespace {

using numbers::RealRoot;

/// Weighted points that are equal where all of `zero` vanish, and belong to the elements where no weight is negative, or
/// none is positive.
struct Construction {
  std::array<Dense, 4> weights;
  std::vector<Dense> zero;
};

/// The lines of two edges meet, or a vertex is in the plane of a face, where V vanishes; the weights along axis k are
/// those of geometry/frame.hpp.
Construction along_axis(const Elements& elements, std::size_t k) {
  const std::size_t i = (k + 1) % 3;
  const std::size_t j = (k + 2) % 3;
  const DenseVector u = elements.u();
  const DenseVector w = elements.w();
  const DenseVector r = elements.r();
  const Dense n = u[i] * w[j] - u[j] * w[i];
  const Dense first = r[i] * w[j] - r[j] * w[i];
  const Dense second = elements.is_edge_edge() ? r[i] * u[j] - r[j] * u[i] : u[i] * r[j] - u[j] * r[i];
  Construction c;
  c.zero = {dot(cross(u, w), r)};
  if (elements.is_edge_edge()) {
    c.weights = {n - first, first, n - second, second};
  } else {
    c.weights = {n, n - first - second, first, second};
  }
  return c;
}

Construction on_edge(const Elements& elements, const CornerAndEdge& pair) {
  const DenseVector r = elements.corners[pair.corner] - elements.corners[pair.start];
  const DenseVector e = elements.corners[pair.end] - elements.corners[pair.start];
  const DenseVector c = cross(r, e);
  Construction result;
  result.zero = {c[0], c[1], c[2]};
  result.weights[pair.corner] = {Exact(1)};
  result.weights[pair.end] = dot(r, e);
  result.weights[pair.start] = dot(e, e) - result.weights[pair.end];
  return result;
}

Construction at_corners(const Elements& elements, std::size_t i, std::size_t j) {
  const DenseVector r = elements.corners[j] - elements.corners[i];
  Construction result;
  result.zero = {r[0], r[1], r[2]};
  result.weights[i] = result.weights[j] = {Exact(1)};
  return result;
}

std::vector<Construction> constructions(const Elements& elements) {
  std::vector<Construction> all;
  for (std::size_t k = 0; k < 3 && elements.has_normal(); ++k) all.push_back(along_axis(elements, k));
  for (const CornerAndEdge& pair : corners_and_edges(elements.kind)) all.push_back(on_edge(elements, pair));
  for (std::size_t i = 0; i < elements.first; ++i) {
    for (std::size_t j = elements.first; j < elements.count; ++j) all.push_back(at_corners(elements, i, j));
  }
  return all;
}

/// Makes the weights positive or absent, given their signs; false when some are of one sign and some of the other, or
/// an element has none.
bool keep_positive(const Elements& elements, const std::array<int, 4>& signs, std::array<Dense, 4>& weights) {
  // The sign is that of the sum over an element, and may differ between the elements.
  for (const auto& [begin, end] :
       {std::pair{std::size_t{0}, elements.first}, std::pair{elements.first, elements.count}}) {
    int side = 0;
    for (std::size_t i = begin; i < end; ++i) {
      if (signs[i] == 0) {
        weights[i].clear();
      } else if (side == -signs[i]) {
        return false;
      } else {
        side = signs[i];
      }
    }
    if (side == 0) return false;
    for (std::size_t i = begin; i < end && side < 0; ++i) weights[i] = Dense() - weights[i];
  }
  return true;
}

/// The meeting at a time that is a double.
std::optional<Meeting> meeting_at(const Elements& elements, const Exact& time, const Construction& construction) {
  for (const Dense& p : construction.zero) {
    if (!numbers::is_zero(value(p, time))) return std::nullopt;
  }
  Meeting result;
  result.weights = construction.weights;
  std::array<int, 4> signs{};
  for (std::size_t i = 0; i < elements.count; ++i) signs[i] = numbers::sign_of(value(result.weights[i], time));
  result.low = result.high = time;
  if (!keep_positive(elements, signs, result.weights)) return std::nullopt;
  return result;
}

/// Narrows the bracket around the root until the root is alone in it, in the sense that a proof needs.
bool narrow(const RealRoot& root, Meeting& meeting) {
  const auto proves = [&] {
    if (numbers::sign_of(value(meeting.root, meeting.low)) * numbers::sign_of(value(meeting.root, meeting.high)) >= 0) {
      return false;
    }
    for (const Dense& weight : meeting.weights) {
      if (!weight.empty() && sign_over(weight, meeting.low, meeting.high, false) != 1) return false;
    }
    return true;
  };
  constexpr int kMostHalvings = 100'000;
  for (int i = 0; i < kMostHalvings; ++i) {
    if (proves()) return true;
    const Exact middle = (meeting.low + meeting.high) * Exact(0.5);
    const int side = root.compare(middle);
    if (side >= 0) meeting.low = side > 0 ? middle : (meeting.low + middle) * Exact(0.5);
    if (side <= 0) meeting.high = side < 0 ? middle : (meeting.high + middle) * Exact(0.5);
  }
  return false;
}

/// The meeting at a root between two neighbouring doubles.
std::optional<Meeting> meeting_between(const Elements& elements, const Answer& answer,
                                       const Construction& construction) {
  Dense common;
  for (const Dense& p : construction.zero) {
    if (!is_zero(p)) common = numbers::simple_common_divisor(coefficients(common), coefficients(p));
  }
  if (common.size() < 2) return std::nullopt;
  const numbers::RootList roots = numbers::isolate_roots(coefficients(common), Exact(1));
  for (int i = 0; i < roots.size(); ++i) {
    const RealRoot& root = roots[i];
    if (root.lower() != answer.toi || root.upper() != answer.toi_upper) continue;
    Meeting result;
    result.weights = construction.weights;
    result.root = common;
    std::array<int, 4> signs{};
    for (std::size_t c = 0; c < elements.count; ++c) {
      const Dense& weight = result.weights[c];
      signs[c] = weight.empty() ? 0 : root.sign_at(coefficients(weight));
      if (signs[c] == 0 && !is_zero(weight)) {
        result.root = numbers::simple_common_divisor(coefficients(result.root), coefficients(weight));
      }
    }
    result.low = Exact(answer.toi);
    result.high = Exact(answer.toi_upper);
    if (keep_positive(elements, signs, result.weights) && narrow(root, result)) return result;
  }
  return std::nullopt;
}

}  // namespace

Meeting meeting(const Elements& elements, const Answer& answer) {
  for (const Construction& construction : constructions(elements)) {
    auto found = answer.toi == answer.toi_upper ? meeting_at(elements, Exact(answer.toi), construction)
                                                : meeting_between(elements, answer, construction);
    if (found) return std::move(*found);
  }
  throw Error("the elements do not touch: there is no proof that they do");
}

}  // namespace touchstone::proofs
