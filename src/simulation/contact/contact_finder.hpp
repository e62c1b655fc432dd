// The contacts of a substep whose end is still being changed: candidates are collected once, with room to move in.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "contact/contact.hpp"
#include "contact/narrow_phase.hpp"

namespace touchstone::sim {

struct ResponseCounts {
  std::uint64_t close = 0;                 ///< pairs whose gap was less than the thickness at the start
  std::uint64_t contacts = 0;              ///< found by the narrow phase, over all passes
  std::array<std::uint64_t, 6> natures{};  ///< of these, by Nature
  LevelCounts levels;                      ///< how many queries of the response each level decided
  std::uint64_t queries = 0;
  int passes = 0;             ///< of impulses that had contacts to answer
  int solves = 0;             ///< implicit steps with the contacts in their potential
  int newton_iterations = 0;  ///< of these
  int zones = 0;              ///< rigid impact zones that were needed in the end
};

class ContactFinder {
 public:
  /// @param cancel  is checked at each pass and block of pairs, and lives as long as this
  ContactFinder(const Colliders& colliders, NarrowPhase narrow_phase, int threads,
                const linear::Cancellation& cancel = linear::Cancellation::never())
      : colliders_(&colliders), cancel_(&cancel), solver_(colliders, narrow_phase, threads, cancel) {}

  /// Collects the pairs that may touch while every particle ends within `margin` of x1. x0 must live until the next
  /// call.
  void begin(const VectorX& x0, const VectorX& x1, double margin);

  /// Pairs whose distance at x0 is less than their separation and `thickness`, which is at most the margin.
  std::vector<Contact> close(double thickness) const;

  /// The contacts between x0 and x1, in the order of their time. A pair that had none last time is asked again only
  /// when `moved` has named one of its particles since.
  void find(const VectorX& x1, std::vector<Contact>& found, ResponseCounts& counts);

  /// These particles end elsewhere now: at x1.
  void moved(const VectorX& x1, const std::vector<char>& particles);

 private:
  void collect(const VectorX& x1);
  bool has_room(const VectorX& x1, Index particle) const;

  const Colliders* colliders_;
  const linear::Cancellation* cancel_;
  PairSolver solver_;
  const VectorX* x0_ = nullptr;
  std::vector<Pair> pairs_;
  std::vector<char> asked_;  // by pair: and not touched, and not moved since
  VectorX collected_;        // where particles ended when the pairs were collected
  double margin_ = 0, most_margin_ = 0;
};

}  // namespace touchstone::sim
