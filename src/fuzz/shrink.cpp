// SPDX-License-Identifier: MIT
#include "fuzz/shrink.hpp"

#include <bit>
#include <cmath>

#include "fuzz/shrink_moves.hpp"
#include "fuzz/simplicity.hpp"

namespace touchstone::fuzz {
namespace {

constexpr std::uint64_t kSeed = 1;  // random moves are the same in every run

bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool is_finite(const Query& query) {
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    if (!is_finite(query.start[i]) || !is_finite(query.end[i])) return false;
  }
  return true;
}

/// Two queries almost never have the same fingerprint; when they do, one candidate is not tried.
std::uint64_t fingerprint(const Query& query) {
  std::uint64_t state = static_cast<std::uint64_t>(query.kind);
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    for (const Vec3& corner : {query.start[i], query.end[i]}) {
      for (const double x : {corner.x, corner.y, corner.z}) {
        state ^= std::bit_cast<std::uint64_t>(x);
        hash = seeded::splitmix64(state);
        state = hash;
      }
    }
  }
  return hash;
}

}  // namespace

Shrinking::Shrinking(const Query& query, const std::function<bool(const Query&)>& still_fails,
                     const ShrinkLimits& limits)
    : still_fails_(still_fails), limits_(limits), best_(query), difficulty_(difficulty(query)), rng_(kSeed) {}

bool Shrinking::offer(const Query& candidate) {
  if (over_ || !is_finite(candidate)) return false;
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

Query shrink(const Query& query, const std::function<bool(const Query&)>& still_fails, const ShrinkLimits& limits) {
  Shrinking shrinking(query, still_fails, limits);
  std::int64_t before = 0;
  do {
    before = difficulty(shrinking.best());
    for (const Move move : shrink_moves()) {
      move(shrinking);
      if (shrinking.over()) return shrinking.best();
    }
  } while (difficulty(shrinking.best()) < before);
  return shrinking.best();
}

}  // namespace touchstone::fuzz
