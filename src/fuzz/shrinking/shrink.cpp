// SPDX-License-Identifier: MIT
#include "fuzz/shrinking/shrink.hpp"

#include <bit>
#include <cmath>

#include <touchstone/error.hpp>

#include "families/curved_parts.hpp"
#include "fuzz/shrinking/shrink_moves.hpp"
#include "fuzz/shrinking/simplicity.hpp"
#include "solver/validate.hpp"

namespace touchstone::fuzz {
namespace {

constexpr std::uint64_t kSeed = 1;  // random moves are the same in every run

bool is_valid(const Query& query) {
  bool finite = true;
  Query read = query;
  families::for_each_coordinate(read, [&](double& x) { finite = finite && std::isfinite(x); });
  return finite;
}

bool is_valid(const CurvedQuery& query) {
  try {
    solver::validate(query, 1);
    return true;
  } catch (const InvalidQuery&) {
    return false;
  }
}

/// Mixes numbers to one.
class Fingerprint {
 public:
  void add(double x) {
    state_ ^= std::bit_cast<std::uint64_t>(x);
    hash_ = seeded::splitmix64(state_);
    state_ = hash_;
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t state_ = 0, hash_ = 0;
};

// Two queries almost never have the same fingerprint; when they do, one candidate is not tried.

std::uint64_t fingerprint(const Query& query) {
  Fingerprint print;
  print.add(static_cast<double>(query.kind));
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    for (const Vec3& corner : {query.start[i], query.end[i]}) {
      for (const double x : {corner.x, corner.y, corner.z}) print.add(x);
    }
  }
  return print.value();
}

std::uint64_t fingerprint(const CurvedQuery& query) {
  Fingerprint print;
  print.add(static_cast<double>(query.kind));
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    print.add(query.corners[i].motion);
    print.add(query.corners[i].control_points);
  }
  CurvedQuery read = query;
  families::for_each_number(read, [&](double& x) { print.add(x); });
  return print.value();
}

template <class Q>
Q shrunk(const Q& query, const std::function<bool(const Q&)>& still_fails, const ShrinkLimits& limits) {
  Shrinking<Q> shrinking(query, still_fails, limits);
  std::int64_t before = 0;
  do {
    before = difficulty(shrinking.best());
    for (const Move<Q> move : shrink_moves<Q>()) {
      move(shrinking);
      if (shrinking.over()) return shrinking.best();
    }
  } while (difficulty(shrinking.best()) < before);
  return shrinking.best();
}

}  // namespace

template <class Q>
Shrinking<Q>::Shrinking(const Q& query, const std::function<bool(const Q&)>& still_fails, const ShrinkLimits& limits)
    : still_fails_(still_fails), limits_(limits), best_(query), difficulty_(difficulty(query)), rng_(kSeed) {}

template <class Q>
bool Shrinking<Q>::offer(const Q& candidate) {
  if (over_ || !is_valid(candidate)) return false;
  const std::int64_t its_difficulty = difficulty(candidate);
  if (its_difficulty >= difficulty_) return false;
  const std::uint64_t its_fingerprint = fingerprint(candidate);
  if (refused_.contains(its_fingerprint)) return false;
  over_ = ++tries_ >= limits_.tries || (limits_.stop && limits_.stop());
  if (!still_fails_(candidate)) {
    refused_.insert(its_fingerprint);
    return false;
  }
  best_ = candidate;
  difficulty_ = its_difficulty;
  return true;
}

template class Shrinking<Query>;
template class Shrinking<CurvedQuery>;

Query shrink(const Query& query, const std::function<bool(const Query&)>& still_fails, const ShrinkLimits& limits) {
  return shrunk(query, still_fails, limits);
}

CurvedQuery shrink(const CurvedQuery& query, const std::function<bool(const CurvedQuery&)>& still_fails,
                   const ShrinkLimits& limits) {
  return shrunk(query, still_fails, limits);
}

}  // namespace touchstone::fuzz
