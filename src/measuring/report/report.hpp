// Error against run time of every method: a folder with tables, numbers and pictures.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <touchstone/separation.hpp>

#include "report/measure.hpp"
#include "report/scene_runs.hpp"

namespace touchstone::report {

/// The amount of measuring.
struct Size {
  bool quick = false;
  std::uint64_t seed = 1;
  Separation separation = {};  ///< what every query asks about
};

/// All that is in a report.
struct Report {
  Size size;
  std::vector<Contestant> contestants;
  std::vector<Contestant> curved_contestants;  ///< of the sets with curved motion
  std::vector<Contestant> body_contestants;    ///< of those of whole bodies
  std::vector<SetResults> sets;
  std::vector<SetResults> scales;  ///< one set at several scales, ascending; contestants at usual tolerances
  SceneRuns scene_runs;
  std::vector<std::string> remarks;  ///< on queries that the sets leave out; whole sentences
};

/// Called often, with the current task and the fraction of all work that is done; may throw to end the work.
using Progress = std::function<void(std::string_view what, double fraction)>;

/// The most queries of one `given` set that are used.
std::size_t most_given(const Size& size) noexcept;

/// Measures the simulation-like sets, the random and the near ones, `given` ones (their truth need not be filled in),
/// those of curved motion and of whole bodies, the scales, and scenes. Takes minutes, or some seconds when quick.
Report make_report(const Size& size, std::vector<QuerySet> given, const Progress& progress);

/// Writes report.md, report.csv, simulation.csv and plots/NAME.svg into `folder`, which has a folder `plots`.
/// @throws FileError
void write_report(const Report& report, const std::string& folder);

}  // namespace touchstone::report
