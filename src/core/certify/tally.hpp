// Counts of verdicts, and of the levels and natures of the exact answers. The tallies of parts of the queries add up to
// the tally of all.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <variant>

#include <touchstone/answer.hpp>
#include <touchstone/certify.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "certify/time_errors.hpp"

namespace touchstone::certify {

struct VerdictCounts {
  std::uint64_t holds = 0;
  std::uint64_t missed = 0;
  std::uint64_t phantom = 0;
  std::uint64_t late = 0;

  std::uint64_t refuted() const noexcept { return missed + phantom + late; }
  std::uint64_t claims() const noexcept { return holds + refuted(); }
  void add(Verdict verdict) noexcept;
  void merge(const VerdictCounts& other) noexcept;
};

struct Tally {
  VerdictCounts verdicts;
  std::array<std::uint64_t, 4> levels{};   ///< by Level: which level decided
  std::array<std::uint64_t, 6> natures{};  ///< by Nature of the exact answer, Nature::none first
  TimeErrors early;                        ///< of claims that hold and have a toi in [0, 1]
  TimeErrors late;                         ///< of those that are late: from the answer's toi on
  std::uint64_t below_0 = 0, above_1 = 0;  ///< claims of contact with another toi, which hold, or are late

  void add(const Claim& claim, const Answer& answer, Verdict verdict) noexcept;
  void merge(const Tally& other) noexcept;
};

/// Wrong claims that do not count as refuted.
struct NotCounted {
  std::uint64_t late = 0;   ///< within a limit
  std::uint64_t other = 0;  ///< of classes that were not asked for

  std::uint64_t claims() const noexcept { return late + other; }
  void merge(const NotCounted& more) noexcept { late += more.late, other += more.other; }
};

/// Whether a wrong claim counts as refuted. If not, it is added to the others.
bool counts(const Counting<Verdict>& counting, const Claim& claim, const Answer& answer, Verdict verdict,
            NotCounted& not_counted) noexcept;

/// The verdicts on one file's claims.
struct FileTally {
  std::string file;
  Kind kind = Kind::edge_edge;
  VerdictCounts verdicts;
};

/// A claim that does not hold, with all that a person needs to check it.
struct RefutedClaim {
  std::string file;
  std::uint64_t query = 0;      ///< counted from 0 within the file
  std::uint64_t first_row = 0;  ///< lines of the file, counted from 1
  std::uint64_t last_row = 0;
  Claim claim;
  Verdict verdict = Verdict::missed;
  Answer answer;
  /// The coordinates as the file writes them, or a curved query in doubles.
  std::variant<RationalQuery, CurvedQuery> as_given;
  Separation separation;  ///< what the claim is about

  Kind kind() const {
    return std::visit([](const auto& given) { return given.kind; }, as_given);
  }
};

}  // namespace touchstone::certify
