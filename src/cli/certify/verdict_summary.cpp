// SPDX-License-Identifier: MIT
#include "cli/certify/verdict_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "cli/shared/command_line/common_options.hpp"
#include "cli/shared/command_line/turns.hpp"
#include "cli/shared/progress/summary.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "numbers/written_number.hpp"

namespace touchstone::cli {
namespace {

template <class Distance, class ForPerson>
std::string range(const certify::ErrorBucket<Distance>& bucket, ForPerson for_person) {
  if (!bucket.below) return "at least " + for_person(bucket.from);
  return "at least " + for_person(bucket.from) + " and less than " + for_person(*bucket.below);
}

}  // namespace

std::string verdicts_for_person(const certify::VerdictCounts& verdicts) {
  const auto row = [](Verdict verdict, std::uint64_t number, std::string_view meaning) {
    return summary_line(name_of(verdict), number > 0 && !meaning.empty()
                                              ? fmt::format("{} ({})", grouped(number), meaning)
                                              : grouped(number));
  };
  return row(Verdict::holds, verdicts.holds, "") +
         row(Verdict::missed, verdicts.missed, "contact denied, but there is one") +
         row(Verdict::phantom, verdicts.phantom, "contact claimed, but there is none") +
         row(Verdict::late, verdicts.late, "toi after the exact time: stepping there passes through");
}

namespace {

/// @param what  of the claims; @param side  of the exact time they are on
std::string errors_for_person(std::string_view heading, std::string_view what, std::string_view side,
                              const certify::TimeErrors& errors) {
  if (errors.claims() == 0) return "";
  const auto ulps = [](std::uint64_t number) { return grouped(number); };
  const auto time = [](double value) { return fmt::format("{:.3g}", value); };
  return summary_line(heading, fmt::format("{} {}", counted(errors.claims(), "claim"), what)) +
         summary_line("", fmt::format("{} to {} doubles {} the exact time; median {}", grouped(errors.least_ulps()),
                                      grouped(errors.most_ulps()), side, range(errors.median_ulps(), ulps))) +
         summary_line("", fmt::format("{:.3g} to {:.3g} of the step {} it; median {}", errors.least_time(),
                                      errors.most_time(), side, range(errors.median_time(), time)));
}

/// A line for zero, and one for each four buckets: from 16^k on, and below 16^(k+1).
template <class Distance, class ForPerson>
std::string rows_of(const std::vector<certify::ErrorBucket<Distance>>& buckets, ForPerson for_person) {
  struct Row {
    Distance from;
    std::uint64_t claims;
  };
  std::vector<Row> rows;
  std::uint64_t most = 0;
  int last = 0;
  for (const auto& bucket : buckets) {
    const int exponent = bucket.from == 0 ? std::numeric_limits<int>::min()
                                          : 4 * static_cast<int>(std::floor(std::ilogb(bucket.from) / 4.0));
    const auto from = static_cast<Distance>(bucket.from == 0 ? 0 : std::ldexp(1.0, exponent));
    if (rows.empty() || exponent != last) rows.push_back({from, 0});
    last = exponent;
    rows.back().claims += bucket.claims;
    most = std::max(most, rows.back().claims);
  }
  std::string text;
  for (const Row& row : rows) {
    constexpr std::uint64_t kWidth = 40;
    const auto bar = static_cast<std::size_t>((row.claims * kWidth + most - 1) / most);
    text +=
        fmt::format("    from {:<22}{:>14}  {}\n", for_person(row.from), grouped(row.claims), std::string(bar, '#'));
  }
  return text;
}

}  // namespace

std::string early_for_person(const certify::TimeErrors& early) {
  return errors_for_person("early", "with a toi that holds", "before", early);
}

std::string late_for_person(const certify::TimeErrors& late) {
  return errors_for_person("late by", "with a toi that is late", "after", late);
}

std::string outside_for_person(std::uint64_t below_0, std::uint64_t above_1) {
  if (below_0 + above_1 == 0) return "";
  return summary_line("outside", fmt::format("{} with a toi outside [0, 1], counted here alone: {} below 0, {} above 1",
                                             counted(below_0 + above_1, "claim"), grouped(below_0), grouped(above_1)));
}

std::string histogram_for_person(std::string_view heading, const certify::TimeErrors& errors) {
  if (errors.claims() == 0) return "";
  return fmt::format("  how {}, in doubles\n", heading) +
         rows_of(errors.ulps(), [](std::uint64_t number) { return grouped(number); }) +
         fmt::format("  how {}, in parts of the step\n", heading) +
         rows_of(errors.times(), [](double value) { return fmt::format("{:.3g}", value); });
}

std::string refuted_for_person(const certify::RefutedClaim& refuted, io::Turns turns, io::Decimals decimals) {
  const Claim& claim = refuted.claim;
  std::string claimed = claim.contact ? "contact" : "no contact";
  const std::string& written = claim.toi_as_written;
  const Answer& answer = refuted.answer;
  if (!written.empty() && !numbers::is_exactly_a_double(written)) {
    claimed += " at " + io::shortened(written);
    if (refuted.verdict == Verdict::late && *claim.toi <= answer.toi) {
      claimed += ", as it is written; the double nearest to it is not late: --as-doubles judges that";
    }
  } else if (claim.toi) {
    claimed += " at " + time_for_person(*claim.toi);
  }
  const std::string truth =
      answer.contact ? fmt::format("contact at {}, {}", time_for_person(answer.toi), contact_for_person(answer))
                     : "no contact";
  return fmt::format("  {} query {} ({}): {}\n    claim: {}\n    exact: {}\n    {}{}{}\n", io::printable(refuted.file),
                     refuted.query, rows_text(refuted.first_row, refuted.last_row), name_of(refuted.verdict), claimed,
                     truth, explain_command(refuted.file, refuted.kind(), refuted.query, refuted.separation),
                     turns_argument(turns), decimals_argument(decimals));
}

}  // namespace touchstone::cli
