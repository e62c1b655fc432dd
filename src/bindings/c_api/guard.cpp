// Status codes and messages of the C interface, and the names of numbers.
// SPDX-License-Identifier: MIT
#include "c_api/guard.hpp"

#include <array>
#include <cstddef>
#include <cstdio>

#include <touchstone/answer.hpp>
#include <touchstone/version.hpp>

namespace touchstone::c_api {

namespace {

// An array, because a string would need memory just when there may be none.
thread_local std::array<char, 1001> last_error{};

/// What version 1 of the structure had.
constexpr std::size_t kFirstOptionsSize = offsetof(touchstone_options, kept_fraction) + sizeof(double);

/// The names are string literals, so they end in a zero. An empty view may have no text at all.
const char* text_of(std::string_view name) noexcept { return name.empty() ? "" : name.data(); }

/// The enumerator with this number; one that has no name for a number that is no byte.
template <typename Enum>
Enum enumerator(int number) noexcept {
  return static_cast<Enum>(number >= 0 && number < 255 ? number : 255);
}

}  // namespace

int failed(touchstone_status_code status, const char* message) noexcept {
  std::snprintf(last_error.data(), last_error.size(), "%s", message);
  return status;
}

touchstone_options options_of(const touchstone_options* options, unsigned has) {
  const touchstone_options defaults = TOUCHSTONE_OPTIONS_INIT;
  if (options == nullptr) return defaults;
  touchstone_options given = grown(*options, defaults, kFirstOptionsSize, "options");
  // 0 stands for the default: an options structure that a program has cleared has not asked for arcs.
  if (given.arcs == 0) given.arcs = defaults.arcs;
  if (given.most_arcs == 0) given.most_arcs = defaults.most_arcs;
  const auto refuse = [&](HasOptions option, bool is_default, const char* name) {
    if ((has & option) != 0 || is_default) return;
    throw InvalidArgument(std::string(name) +
                          " is set, and this function has no such option: leave it as TOUCHSTONE_OPTIONS_INIT sets it");
  };
  refuse(kHasTMax, given.t_max == defaults.t_max, "t_max");
  refuse(kHasSeparation, given.separation == 0, "separation");
  refuse(kHasSeparation, given.metric == defaults.metric, "metric");
  refuse(kHasSeparations, given.separations == nullptr && given.separation_count == 0, "separations");
  refuse(kHasKeptFraction, given.kept_fraction == 0, "kept_fraction");
  refuse(kHasWanted, given.wanted == defaults.wanted, "wanted");
  refuse(kHasFloat32, given.float32 == 0, "float32");
  refuse(kHasCheckStart, given.check_start == 0, "check_start");
  refuse(kHasMethod, given.method == defaults.method, "method");
  refuse(kHasArcs, given.arcs == defaults.arcs, "arcs");
  refuse(kHasArcs, given.most_arcs == defaults.most_arcs, "most_arcs");
  return given;
}

Kind kind_of(int kind) {
  const int last = static_cast<int>(kKinds.size()) - 1;
  if (kind >= 0 && kind <= last) return static_cast<Kind>(kind);  // touchstone/kinds.h: the numbers are the same
  throw InvalidArgument("the kind is " + std::to_string(kind) + "; it must be in [0, " + std::to_string(last) + "]");
}

Metric metric_of(int metric) {
  switch (metric) {
    case TOUCHSTONE_METRIC_EUCLIDEAN: return Metric::euclidean;
    case TOUCHSTONE_METRIC_MAX: return Metric::max;
    default: throw InvalidArgument("the metric is " + std::to_string(metric) + "; it must be 0 or 1");
  }
}

Wanted wanted_of(int wanted) {
  switch (wanted) {
    case TOUCHSTONE_WANTED_ALL: return Wanted::all;
    case TOUCHSTONE_WANTED_FEATURES: return Wanted::features;
    case TOUCHSTONE_WANTED_TIME: return Wanted::time;
    case TOUCHSTONE_WANTED_CONTACT: return Wanted::contact;
    default: throw InvalidArgument("what is wanted is " + std::to_string(wanted) + "; it must be in [0, 3]");
  }
}

Method method_of(int method) {
  switch (method) {
    case TOUCHSTONE_METHOD_FAST: return Method::fast;
    case TOUCHSTONE_METHOD_EXACT: return Method::exact;
    case TOUCHSTONE_METHOD_ORACLE: return Method::oracle;
    case TOUCHSTONE_METHOD_FAST_CGAL: return Method::fast_cgal;
    default: throw InvalidArgument("the method is " + std::to_string(method) + "; it must be in [0, 3]");
  }
}

}  // namespace touchstone::c_api

using namespace touchstone;

extern "C" {

uint32_t touchstone_c_version(void) { return TOUCHSTONE_C_VERSION; }

const char* touchstone_version(void) { return version(); }

const char* touchstone_last_error(void) { return c_api::last_error.data(); }

const char* touchstone_nature_name(int nature) { return c_api::text_of(name_of(c_api::enumerator<Nature>(nature))); }

const char* touchstone_feature_name(int feature) {
  return c_api::text_of(name_of(c_api::enumerator<Feature>(feature)));
}

const char* touchstone_level_name(int level) { return c_api::text_of(name_of(c_api::enumerator<Level>(level))); }

const char* touchstone_trend_name(int trend) { return c_api::text_of(name_of(c_api::enumerator<Trend>(trend))); }

}  // extern "C"
