// Collects the failures over thousands of seeded queries. It fails the test case, prints
// the first few failures with all that is needed to repeat them, and counts the rest.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>

#include "support/catch.hpp"
#include "support/query_families.hpp"
#include "support/query_text.hpp"
#include "support/slow_build.hpp"

namespace touchstone::tests {

/// The one case to run instead of all, from the environment variable TOUCHSTONE_CASE.
inline std::optional<CaseId> chosen_case() {
  const char* text = std::getenv("TOUCHSTONE_CASE");
  if (text == nullptr || *text == '\0') return std::nullopt;
  const std::optional<CaseId> id = parse_case(text);
  if (!id) FAIL("TOUCHSTONE_CASE is not \"family kind seed index\": " << text);
  return id;
}

/// "label: wrong", or nothing when nothing is wrong.
inline std::string labelled(std::string label, const std::string& wrong) {
  return wrong.empty() ? wrong : label.append(": ").append(wrong);
}

class Report {
 public:
  /// `message` is empty when all is well.
  void add(const CaseId& id, const Query& query, const std::string& message) {
    ++checked_;
    if (message.empty()) return;
    if (++failed_ > kPrinted) return;
    UNSCOPED_INFO("repeat this alone with TOUCHSTONE_CASE=\"" << case_name(id) << "\"");
    FAIL_CHECK(case_name(id) << ": " << message << "\n  " << cpp_initializer(query));
  }

  std::size_t checked() const { return checked_; }

  /// To be called at the end of a test case: fails when anything did, or when nothing was checked.
  void finish() const {
    if (failed_ > 0) FAIL_CHECK(failed_ << " of " << checked_ << " failed");
    CHECK(checked_ > 0);
  }

 private:
  static constexpr std::size_t kPrinted = 5;
  std::size_t checked_ = 0;
  std::size_t failed_ = 0;
};

/// Calls f(CaseId) for `count` cases of every kind and family that `wanted` accepts, or for the chosen case alone.
template <typename Wanted, typename F>
void for_each_case(std::uint64_t seed, std::size_t count, Wanted&& wanted, F&& f) {
  if (const std::optional<CaseId> only = chosen_case()) {
    if (only->seed == seed && wanted(info(only->family), only->kind)) f(*only);
    return;
  }
  for (const FamilyInfo& family : all_families()) {
    for (const Kind kind : kKinds) {
      if (!wanted(family, kind)) continue;
      for (std::size_t index = 0; index < effort(count); ++index) f(CaseId{family.family, kind, seed, index});
    }
  }
}

}  // namespace touchstone::tests
