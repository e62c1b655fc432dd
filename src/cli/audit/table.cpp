// SPDX-License-Identifier: MIT
#include "cli/audit/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "cli/shared/words.hpp"
#include "io/fail.hpp"

namespace touchstone::cli {
namespace {

using fuzz::FailureClass;
using fuzz::FailureTable;

std::uint64_t count_of(const FailureTable::Row& total, std::initializer_list<FailureClass> classes) {
  std::uint64_t count = 0;
  for (const FailureClass failure : classes) count += total.failures[FailureTable::index(failure)];
  return count;
}

/// "1.5", "2.5e+06"
std::string microseconds(double time) { return time < 1e6 ? fmt::format("{:.1f}", time) : fmt::format("{:.1e}", time); }

/// How early: the end of the median's bucket, and the greatest.
std::array<std::string, 2> early_texts(const certify::TimeErrors& early) {
  if (early.claims() == 0) return {"-", "-"};
  const auto below = early.median_time().below;
  return {early.median_time().from == 0 ? "0" : fmt::format("{:.1e}", below.value_or(1)),
          early.most_time() == 0 ? "0" : fmt::format("{:.1e}", early.most_time())};
}

using AuditLine = std::array<std::string, 12>;

/// Lines whose columns are as wide as their longest cells; the first two start at the left.
std::string lined_up(const std::vector<AuditLine>& lines) {
  std::array<std::size_t, std::tuple_size_v<AuditLine>> widths{};
  for (const AuditLine& line : lines) {
    for (std::size_t c = 0; c < line.size(); ++c) widths[c] = std::max(widths[c], line[c].size());
  }
  std::string text;
  for (const AuditLine& line : lines) {
    for (std::size_t c = 0; c < line.size(); ++c) {
      text += c < 2 ? fmt::format("{:<{}}  ", line[c], widths[c]) : fmt::format("{:>{}}  ", line[c], widths[c]);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  }
  return text;
}

std::string motion_text(const fuzz::Claims& claims) {
  switch (claims.motion) {
    case fuzz::ClaimedMotion::straight: return "any straight motion";
    case fuzz::ClaimedMotion::translations: return "both elements translate";
    case fuzz::ClaimedMotion::cast: return "the first element translates";
    case fuzz::ClaimedMotion::still: return "nothing moves";
  }
  return {};
}

std::string claims_text(const fuzz::EngineQuestion& q) {
  const fuzz::Claims& c = q.claims;
  std::string text = motion_text(c);
  if (c.in_plane) text += ", in the plane";
  if (c.starts_apart) text += ", apart at the start";
  text += c.floats ? ", in floats" : ", in doubles";
  if (std::isfinite(c.greatest)) text += fmt::format(", greatest coordinate from {} to {}", c.least, c.greatest);
  if (c.least_element > 0) text += fmt::format(", no element below {} of the extent", c.least_element);
  if (q.separation > 0) text += fmt::format("; contact at distance {}", q.separation);
  const fuzz::EngineTolerance& t = q.tolerance;
  text += "; tolerance";
  if (t.length > 0) text += fmt::format(" {}", t.length);
  if (t.relative > 0)
    text += fmt::format("{} {:.2g} of the greatest coordinate", t.length > 0 ? " plus" : "", t.relative);
  if (t.time > 0) text += fmt::format("{} {:.2g} of the step", t.length > 0 || t.relative > 0 ? "," : "", t.time);
  if (t.length == 0 && t.relative == 0 && t.time == 0) text += " none";
  return text;
}

}  // namespace

bool failed(const AuditRow& row) { return row.outcome.table.total().failed() > 0; }

std::string audit_table(const std::vector<AuditRow>& rows) {
  std::vector<AuditLine> lines = {{"engine/question", "kind", "queries", "missed", "phantom", "late", "tolerated",
                                   "early", "at most", "crashes", "unknown", "us"}};
  for (const AuditRow& row : rows) {
    const FailureTable::Row total = row.outcome.table.total();
    const auto count = [&](std::initializer_list<FailureClass> classes) { return grouped(count_of(total, classes)); };
    const auto [median, most] = early_texts(row.outcome.early);
    const double queries = static_cast<double>(std::max<std::uint64_t>(row.outcome.queries, 1));
    lines.push_back({row.name, std::string(name_of(row.kind)), grouped(total.cases), count({FailureClass::missed}),
                     count({FailureClass::phantom}), count({FailureClass::late}), grouped(row.outcome.allowed), median,
                     most, count({FailureClass::crash, FailureClass::hang}),
                     count({FailureClass::malformed, FailureClass::nan}),
                     microseconds(1e6 * row.outcome.solver_seconds / queries)});
  }
  return lined_up(lines);
}

std::string engines_text(const std::vector<AuditedEngine>& engines) {
  std::string text;
  for (const AuditedEngine& engine : engines) {
    if (!engine.missing.empty()) text += fmt::format("{}: not asked: {}\n", engine.name, io::printable(engine.missing));
    for (const fuzz::EngineQuestion& q : engine.questions) {
      text += fmt::format("{}/{}: {}: {}\n  {}\n", engine.name, q.name, io::printable(q.engine), io::printable(q.asks),
                          claims_text(q));
      for (const std::string& note : q.notes) text += fmt::format("  {}\n", io::printable(note));
    }
  }
  return text;
}

}  // namespace touchstone::cli
