// SPDX-License-Identifier: MIT
#include "report/text.hpp"

#include <fmt/format.h>

#include "io/times.hpp"

namespace touchstone::report {

std::string percent(double fraction) { return fraction == 0 ? "0" : fmt::format("{:.3g} %", 100 * fraction); }

std::string ulps(std::int64_t error) {
  if (error > -100'000 && error < 100'000) return fmt::format("{}", error);
  return fmt::format("{:.1e}", static_cast<double>(error));
}

std::string asked_text(const Result& result, const QuerySet& set) {
  const std::string whole = fmt::format("{}", set.size());
  return result.asked == set.size() ? whole : fmt::format("{} of {}", result.asked, whole);
}

std::string separation_arguments(const Separation& separation) {
  if (separation.distance == 0) return {};
  return " --separation " + io::hexfloat(separation.distance) +
         (separation.metric == Metric::euclidean ? std::string()
                                                 : " --metric " + std::string(name_of(separation.metric)));
}

}  // namespace touchstone::report
