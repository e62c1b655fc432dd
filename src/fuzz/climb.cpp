// SPDX-License-Identifier: MIT
#include "fuzz/climb.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

#include "families/curved_parts.hpp"
#include "families/linear_motion.hpp"
#include "fuzz/margin.hpp"

namespace touchstone::fuzz {
namespace {

using families::Rng;

// Below, one call of rng a statement: compilers evaluate the arguments of a call in different orders, and a case's name
// means the same query on every machine.

double& random_number(Query& query, Rng& rng) {
  auto& corners = rng.one_in(2) ? query.start : query.end;
  const auto axis = static_cast<std::size_t>(rng.below(3));
  return families::coordinate(corners[rng.below(corner_count(query.kind))], axis);
}

double& random_number(CurvedQuery& query, Rng& rng) {
  std::uint64_t count = 0;
  families::for_each_number(query, [&](double&) { ++count; });
  const std::uint64_t chosen = rng.below(count);
  double* found = nullptr;
  std::uint64_t next = 0;
  families::for_each_number(query, [&](double& x) {
    if (next++ == chosen) found = &x;
  });
  return *found;
}

double& random_number(AnyQuery& query, Rng& rng) {
  return std::visit([&](auto& q) -> double& { return random_number(q, rng); }, query);
}

double changed(double x, AnyQuery& query, Rng& rng) {
  const double away =
      rng.one_in(2) ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
  switch (rng.between(0, 6)) {
    case 0: return std::nextafter(x, away);
    case 1: {
      const int exponent = -rng.between(0, 50);
      return x + std::ldexp(rng.symmetric() * (std::fabs(x) + 0x1p-1022), exponent);
    }
    case 2: {
      const int exponent = -rng.between(0, 52);
      return x * (1 + std::ldexp(rng.symmetric(), exponent));
    }
    case 3: return random_number(query, rng);
    case 4: return std::nextafter(random_number(query, rng), away);
    case 5: return -x;
    default: return 0.5 * (x + random_number(query, rng));
  }
}

}  // namespace

double Climb::height_of(const AnyQuery& query) const {
  return std::fabs(std::log2(std::fabs(filter_margin(query, separation_))));
}

/// Moves one number to the value at which the margin would be zero if it were linear in the number. V's coefficients
/// are linear in a straight query's coordinates, so that there only rounding remains of them.
void Climb::step_to_zero(AnyQuery& query) {
  double& x = random_number(query, rng_);
  const double before = x;
  const double margin = filter_margin(query, separation_);
  const int exponent = -rng_.between(0, 30);
  x = before + std::ldexp(rng_.symmetric() * (std::fabs(before) + 0x1p-1000), exponent);
  const double moved = before - margin * (x - before) / (filter_margin(query, separation_) - margin);
  x = std::isfinite(moved) ? moved : before;
}

Climb::Climb(const families::CaseId& start)
    : rng_(families::rng_of(start)),
      current_(families::make(start.family, start.kind, rng_)),
      height_(height_of(current_)) {}

Climb::Climb(const AnyQuery& start, const families::Rng& random, const Separation& separation)
    : rng_(random), separation_(separation), current_(start), height_(height_of(current_)) {}

AnyQuery Climb::next() {
  AnyQuery query = current_;
  if (rng_.one_in(3)) step_to_zero(query);
  for (int changes = rng_.between(0, 2); changes > 0; --changes) {
    double& x = random_number(query, rng_);
    const double value = changed(x, query, rng_);
    if (std::isfinite(value)) x = value;
  }
  if (auto* const curved = std::get_if<CurvedQuery>(&query)) families::make_valid(*curved);
  const double height = height_of(query);
  if (height <= height_) {  // false for NaN, which a margin is not
    current_ = query;
    height_ = height;
  }
  return query;
}

}  // namespace touchstone::fuzz
