// SPDX-License-Identifier: MIT
#include "cli/simulate/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/shared/words.hpp"
#include "sim/left_out.hpp"
#include "sim/output_text.hpp"

namespace touchstone::cli {

void StepTotals::add(const std::vector<sim::SubstepRecord>& records) {
  ++steps;
  for (const sim::SubstepRecord& record : records) {
    ++substeps;
    gained += static_cast<std::uint64_t>(record.gained_energy);
    if (record.excess > 1) ++inaccurate;
    first_order += static_cast<std::uint64_t>(record.first_order);
    separated += record.proof.separations.pairs;
    largest_separation = std::max(largest_separation, record.proof.separations.largest);
  }
}

std::string simulation_for_person(const sim::Simulation& simulation, const StepTotals& totals,
                                  std::string_view run_times) {
  constexpr std::size_t kMostShown = 20;
  const auto& crossings = simulation.crossings();
  std::string text = fmt::format("{} steps, {} crossings{}\n", totals.steps, crossings.size(),
                                 sim::left_out_for_person(simulation, totals.steps));
  for (std::size_t i = 0; i < crossings.size() && i < kMostShown; ++i) {
    text += "crossing: " + sim::crossing_for_person(simulation, crossings[i]) + "\n";
  }
  if (crossings.size() > kMostShown) text += fmt::format("crossing: {} more\n", grouped(crossings.size() - kMostShown));
  text += sim::checked_for_person(simulation, totals.steps);
  if (simulation.ignores_radii()) {
    text += "the radii of the scene were left aside: the narrow phase of the paper knows no separation\n";
  } else if (simulation.has_separations()) {
    text += totals.separated > 0
                ? fmt::format(
                      "every pair asked about stayed farther apart than its separation ({}, with separations "
                      "of up to {} m)\n",
                      counted(totals.separated, "pair"), totals.largest_separation)
                : "no pair with a separation came near enough to be asked about\n";
  }
  if (totals.substeps > totals.steps) {
    const std::string refused = sim::refused_for_person(simulation.refused(), {});
    text += fmt::format("{} in {}{}{}\n", counted(totals.steps, "step"), counted(totals.substeps, "part"),
                        refused.empty() ? "" : "; of the tries of parts ", refused);
  }
  if (totals.gained > 0)
    text += fmt::format("in {} energy was gained: too short to be cut again\n", counted(totals.gained, "part"));
  if (totals.inaccurate > 0) {
    text += fmt::format("{} less accurate than the tolerance: too short to be cut again\n",
                        counted(totals.inaccurate, "part"));
  }
  if (totals.first_order > 0) {
    text +=
        fmt::format("{} of first order, by implicit-euler: the scene's integrator gained energy or did not converge\n",
                    counted(totals.first_order, "part"));
  }
  return text.append(run_times);
}

std::string run_times_for_person(const sim::Simulation& simulation, double rate) {
  std::string text;
  if (const auto& times = simulation.times(); times.total() > 0) {
    const auto percentage = [&](double seconds) { return 100 * seconds / times.total(); };
    text += fmt::format(
        "of {:.2f} s of processor time: integration {:.0f} %, solving with contacts {:.0f} %, finding and answering "
        "contacts {:.0f} %, proof {:.0f} %\n",
        times.total(), percentage(times.integration), percentage(times.contacts), percentage(times.response),
        percentage(times.proof));
  }
  return text + fmt::format("{:.1f} steps a second\n", rate);
}

}  // namespace touchstone::cli
