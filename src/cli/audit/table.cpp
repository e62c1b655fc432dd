// SPDX-License-Identifier: MIT
#include "cli/audit/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

/// How early: the end of the median's bucket, and the greatest.
std::string early_text(const certify::TimeErrors& early) {
  if (early.claims() == 0) return fmt::format("{:>9}{:>9}", "-", "-");
  const auto below = early.median_time().below;
  return fmt::format("{:>9}{:>9}", early.median_time().from == 0 ? "0" : fmt::format("{:.1e}", below.value_or(1)),
                     early.most_time() == 0 ? "0" : fmt::format("{:.1e}", early.most_time()));
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
  std::string text =
      fmt::format("{:<22}{:<12}{:>9}{:>9}{:>9}{:>9}{:>10}{:>9}{:>9}{:>8}{:>9}{:>8}\n", "engine/question", "kind",
                  "queries", "missed", "phantom", "late", "tolerated", "early", "at most", "crashes", "unknown", "us");
  for (const AuditRow& row : rows) {
    const FailureTable::Row total = row.outcome.table.total();
    const double queries = static_cast<double>(std::max<std::uint64_t>(row.outcome.queries, 1));
    text +=
        fmt::format("{:<22}{:<12}{:>9}{:>9}{:>9}{:>9}{:>10}{}{:>8}{:>9}{:>8.1f}\n", row.name, name_of(row.kind),
                    grouped(total.cases), grouped(count_of(total, {FailureClass::missed})),
                    grouped(count_of(total, {FailureClass::phantom})), grouped(count_of(total, {FailureClass::late})),
                    grouped(row.outcome.allowed), early_text(row.outcome.early),
                    grouped(count_of(total, {FailureClass::crash, FailureClass::hang})),
                    grouped(count_of(total, {FailureClass::malformed, FailureClass::nan})),
                    1e6 * row.outcome.solver_seconds / queries);
  }
  return text;
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
