// The stability table: every method at every setting of every dial, and the settings at which each breaks.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "report/report.hpp"
#include "stress/dials.hpp"

namespace touchstone::stress {

struct Options {
  std::uint64_t seed = 1;
  std::size_t count = 200;         ///< queries at a setting, of each kind
  std::vector<const Dial*> which;  ///< empty: all dials
  Separation separation = {};      ///< what every query asks about
};

/// All settings of one dial, for one kind.
struct Table {
  const Dial* dial;
  Kind kind;
  std::vector<report::SetResults> settings;  ///< in the order of the dial's; SetResults::exponent is the setting
};

struct Stress {
  Options options;
  std::vector<report::Contestant> contestants;
  std::vector<Table> tables;
  std::size_t oracle_asked = 0;
  std::vector<std::string> oracle_differs;  ///< one line for each query where the judge and the oracle differ
};

/// Gives every query to every method. Method::exact judges the answers. The oracle checks Method::exact on some queries
/// of each set.
Stress run_stress(const Options& options, const report::Progress& progress);

/// Answers of `touchstone` that are wrong, or whose time is not the exact one.
std::size_t own_errors(const Stress& stress);

/// The result of `touchstone` at one setting.
const report::Result& own_result(const report::SetResults& setting);

/// The run time of `touchstone` along one dial, in microseconds a query.
struct Growth {
  double gentle = 0;   ///< at the gentle setting
  double low = 0;      ///< at the lowest setting
  double high = 0;     ///< at the highest one
  double slowest = 0;  ///< at the slowest of all
  int slowest_at = 0;  ///< that setting
};
Growth growth(const Table& table);

std::string markdown_text(const Stress& stress);
std::string picture_name(const Table& table);  ///< "scale-edge-edge"

/// Writes stress.md, stress.csv and plots/NAME.svg into `folder`, which has a folder `plots`. @throws FileError
void write_stress(const Stress& stress, const std::string& folder);

}  // namespace touchstone::stress
