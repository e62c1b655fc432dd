// SPDX-License-Identifier: MIT
#include "cli/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "io/fail.hpp"
#include "io/times.hpp"
#include "numbers/written_number.hpp"

namespace touchstone::cli {
namespace {

std::string line(std::string_view heading, std::string_view text) { return fmt::format("  {:<12}{}\n", heading, text); }

void append(std::string& list, const std::string& item) {
  if (!list.empty()) list += ", ";
  list += item;
}

template <class Distance, class ForPerson>
std::string range(const certify::EarlyBucket<Distance>& bucket, ForPerson for_person) {
  if (!bucket.below) return "at least " + for_person(bucket.from);
  return "at least " + for_person(bucket.from) + " and less than " + for_person(*bucket.below);
}

}  // namespace

void Counts::add(const Answer& answer) noexcept {
  ++queries;
  ++levels[static_cast<std::size_t>(answer.level)];
  ++natures[static_cast<std::size_t>(answer.nature)];
}

void Counts::merge(const Counts& other) noexcept {
  queries += other.queries;
  for (std::size_t i = 0; i < levels.size(); ++i) levels[i] += other.levels[i];
  for (std::size_t i = 0; i < natures.size(); ++i) natures[i] += other.natures[i];
}

std::string counts_for_person(const Counts& counts) {
  std::string levels;
  for (const Level level : {Level::filter, Level::bracket, Level::exact, Level::oracle}) {
    const auto number = counts.levels[static_cast<std::size_t>(level)];
    if (number > 0)
      append(levels, fmt::format("{} {} ({})", level_name(level), grouped(number), share(number, counts.queries)));
  }
  std::string natures;
  for (const Nature nature : {Nature::crossing, Nature::grazing, Nature::sustained, Nature::isolated}) {
    const auto number = counts.natures[static_cast<std::size_t>(nature)];
    if (number > 0) append(natures, fmt::format("{} {}", grouped(number), nature_name(nature)));
  }
  const std::uint64_t contacts = counts.queries - counts.natures[static_cast<std::size_t>(Nature::none)];
  return line("contacts", grouped(contacts) + (natures.empty() ? "" : ": " + natures)) + line("decided by", levels);
}

std::string speed_for_person(std::uint64_t queries, double seconds, int threads) {
  const auto count = static_cast<double>(queries > 0 ? queries : 1);
  seconds = std::max(seconds, 1e-9);
  return line("time", fmt::format("{:.2f} s: {:.2f} microseconds a query, {} queries a second, {}", seconds,
                                  seconds / count * 1e6, grouped(static_cast<std::uint64_t>(count / seconds)),
                                  counted(static_cast<std::uint64_t>(threads), "thread")));
}

std::string verdicts_for_person(const certify::VerdictCounts& verdicts) {
  const auto row = [](Verdict verdict, std::uint64_t number, std::string_view meaning) {
    return line(verdict_name(verdict),
                number > 0 && !meaning.empty() ? fmt::format("{} ({})", grouped(number), meaning) : grouped(number));
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
  return line("early", fmt::format("{} with a toi that holds", counted(early.claims(), "claim"))) +
         line("", fmt::format("{} to {} doubles before the exact time; median {}", grouped(early.least_ulps()),
                              grouped(early.most_ulps()), range(early.median_ulps(), ulps))) +
         line("", fmt::format("{:.3g} to {:.3g} of the step before it; median {}", early.least_time(),
                              early.most_time(), range(early.median_time(), time)));
}

std::string refuted_for_person(const certify::RefutedClaim& refuted) {
  const Claim& claim = refuted.claim;
  std::string claimed = claim.contact ? "contact" : "no contact";
  const std::string& written = claim.toi_as_written;
  if (!written.empty() && !numbers::is_exactly_a_double(written)) {
    claimed += " at " + io::shortened(written);
  } else if (claim.toi) {
    claimed += " at " + time_for_person(*claim.toi);
  }
  const Answer& answer = refuted.answer;
  const std::string truth =
      answer.contact ? fmt::format("contact at {}, {}", time_for_person(answer.toi), contact_for_person(answer))
                     : "no contact";
  return fmt::format("  {} query {} (rows {} to {}): {}\n    claim: {}\n    exact: {}\n    {}\n",
                     io::printable(refuted.file), refuted.query, refuted.first_row, refuted.last_row,
                     verdict_name(refuted.verdict), claimed, truth,
                     explain_command(refuted.file, refuted.as_given.kind, refuted.query));
}

}  // namespace touchstone::cli
