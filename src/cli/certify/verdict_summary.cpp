// SPDX-License-Identifier: MIT
#include "cli/certify/verdict_summary.hpp"

#include <fmt/format.h>

#include "cli/shared/command_line/turns.hpp"
#include "cli/shared/progress/summary.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "numbers/written_number.hpp"

namespace touchstone::cli {
namespace {

template <class Distance, class ForPerson>
std::string range(const certify::EarlyBucket<Distance>& bucket, ForPerson for_person) {
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

std::string early_for_person(const certify::EarlyTally& early) {
  if (early.claims() == 0) return "";
  const auto ulps = [](std::uint64_t number) { return grouped(number); };
  const auto time = [](double value) { return fmt::format("{:.3g}", value); };
  return summary_line("early", fmt::format("{} with a toi that holds", counted(early.claims(), "claim"))) +
         summary_line("", fmt::format("{} to {} doubles before the exact time; median {}", grouped(early.least_ulps()),
                                      grouped(early.most_ulps()), range(early.median_ulps(), ulps))) +
         summary_line("", fmt::format("{:.3g} to {:.3g} of the step before it; median {}", early.least_time(),
                                      early.most_time(), range(early.median_time(), time)));
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
  return fmt::format("  {} query {} (rows {} to {}): {}\n    claim: {}\n    exact: {}\n    {}{}{}\n",
                     io::printable(refuted.file), refuted.query, refuted.first_row, refuted.last_row,
                     name_of(refuted.verdict), claimed, truth,
                     explain_command(refuted.file, refuted.kind(), refuted.query, refuted.separation),
                     turns_argument(turns), decimals == io::Decimals::nearest_double ? " --as-doubles" : "");
}

}  // namespace touchstone::cli
