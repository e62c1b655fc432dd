// SPDX-License-Identifier: MIT
#include "report/contestant.hpp"

#include <fmt/format.h>

#include <cmath>

#include <touchstone/solve.hpp>

#include "report/do_not_optimize.hpp"

namespace touchstone::report {
namespace {

constexpr double kWholeStep = 1;

Claim claim_of(bool contact, double toi) {
  Claim claim;
  claim.contact = contact;
  if (contact && std::isfinite(toi)) claim.toi = toi;
  return claim;
}

void append_ours(std::vector<Contestant>& all) {
  all.push_back({"exact_only", "exact arithmetic alone; never wrong", nullptr, Method::exact, 0});
  if (has_method(Method::fast_cgal)) {
    all.push_back({"touchstone_cgal", "filters, brackets, and CGAL where they are uncertain; never wrong", nullptr,
                   Method::fast_cgal, 0});
  }
  all.push_back(
      {"touchstone", "the whole cascade: filters, brackets, exact arithmetic; never wrong", nullptr, Method::fast, 0});
}

/// The baselines for a separation. They are Euclidean; their tolerance is a fraction of the gap at the start.
void append_thick(Metric metric, std::vector<Contestant>& all) {
  if (metric != Metric::euclidean) return;
  for (const baselines::SeparationBaseline& method : baselines::separation_methods()) {
    Contestant contestant{std::string(method.name), std::string(method.about), nullptr, Method::fast, 0, &method};
    if (method.tolerance == baselines::Tolerance::none) {
      all.push_back(contestant);
      continue;
    }
    for (const double tolerance : {0.1, 1e-2, 1e-3}) {
      contestant.tolerance = tolerance;
      all.push_back(contestant);
    }
  }
}

}  // namespace

std::string Contestant::tolerance_text() const {
  if (tolerance == 0) return {};
  const double power = std::round(std::log10(tolerance));
  const std::string text = fmt::format("1e{:.0f}", power);
  return std::stod(text) == tolerance ? text : fmt::format("{:g}", tolerance);
}

std::string Contestant::label() const { return tolerance == 0 ? name : name + " " + tolerance_text(); }

std::vector<Contestant> contestants(const std::vector<double>& tolerances, const Separation& separation) {
  std::vector<Contestant> all;
  if (separation.distance > 0) {
    append_thick(separation.metric, all);
    append_ours(all);
    return all;
  }
  for (const baselines::Baseline& method : baselines::methods()) {
    Contestant contestant{std::string(method.name), std::string(method.about), &method, Method::fast, 0};
    if (!method.has_tolerance()) {
      all.push_back(contestant);
      continue;
    }
    for (const double tolerance : tolerances) {
      contestant.tolerance = tolerance;
      all.push_back(contestant);
    }
  }
  append_ours(all);
  return all;
}

std::vector<Contestant> curved_contestants(const std::vector<double>& tolerances, const Separation& separation) {
  std::vector<Contestant> all;
  if (separation.distance == 0) {
    for (const baselines::CurvedBaseline& method : baselines::curved_methods()) {
      Contestant contestant{std::string(method.name), std::string(method.about), nullptr, Method::fast, 0};
      contestant.curved = &method;
      for (const double tolerance : tolerances) {
        contestant.tolerance = tolerance;
        all.push_back(contestant);
      }
    }
  }
  append_ours(all);
  return all;
}

std::vector<Contestant> body_contestants() {
  std::vector<Contestant> all;
  for (const baselines::BodyBaseline& method : baselines::body_methods()) {
    Contestant contestant{std::string(method.name), std::string(method.about), nullptr, Method::fast, 0};
    contestant.whole = &method;
    for (const double tolerance : method.tolerances) {
      contestant.tolerance = tolerance;
      all.push_back(contestant);
    }
  }
  all.push_back({"touchstone", "first_contact of whole bodies; never wrong", nullptr, Method::fast, 0});
  return all;
}

namespace {

template <class AnyQuery>
ContestantReply reply_of_solver(Method method, const AnyQuery& query, const Separation& separation) {
  const Answer answer = solve(query, {.separation = separation, .method = method});
  return {claim_of(answer.contact, answer.toi), answer.level};
}

ContestantReply reply_of(const baselines::Result& result) {
  return {claim_of(result.contact, result.toi), Level::exact};
}

}  // namespace

ContestantReply ask(const Contestant& contestant, const baselines::MovingBodies& step, const Separation&) {
  if (contestant.whole != nullptr) return reply_of(contestant.whole->solve(step, contestant.tolerance));
  const FirstBodyContact first = first_contact(step.bodies, step.motions);
  return {claim_of(first.contact, first.toi), first.contact ? first.earliest.front().answer.level : Level::filter};
}

void ask_all(const Contestant& contestant, const std::vector<baselines::MovingBodies>& steps, std::size_t count,
             const Separation& separation) {
  for (std::size_t i = 0; i < count; ++i) do_not_optimize(ask(contestant, steps[i], separation));
}

ContestantReply ask(const Contestant& contestant, const CurvedQuery& query, const Separation& separation) {
  if (contestant.curved == nullptr) return reply_of_solver(contestant.method, query, separation);
  return reply_of(contestant.curved->solve(query, kWholeStep, contestant.tolerance));
}

void ask_all(const Contestant& contestant, const std::vector<CurvedQuery>& queries, std::size_t count,
             const Separation& separation) {
  if (contestant.curved == nullptr) {
    for (std::size_t i = 0; i < count; ++i)
      do_not_optimize(solve(queries[i], {.separation = separation, .method = contestant.method}));
    return;
  }
  const auto function = contestant.curved->solve;
  for (std::size_t i = 0; i < count; ++i) do_not_optimize(function(queries[i], kWholeStep, contestant.tolerance));
}

ContestantReply ask(const Contestant& contestant, const Query& query, const Separation& separation) {
  if (contestant.thick != nullptr) {
    return reply_of(contestant.thick->solve(query, separation.distance, kWholeStep, contestant.tolerance));
  }
  if (contestant.baseline != nullptr) {
    return reply_of(contestant.baseline->solve(query, kWholeStep, contestant.tolerance));
  }
  return reply_of_solver(contestant.method, query, separation);
}

void ask_all(const Contestant& contestant, const std::vector<Query>& queries, std::size_t count,
             const Separation& separation) {
  // Each sort of method has a loop of its own, so that no query pays for the choice.
  if (contestant.thick != nullptr) {
    const auto function = contestant.thick->solve;
    for (std::size_t i = 0; i < count; ++i) {
      do_not_optimize(function(queries[i], separation.distance, kWholeStep, contestant.tolerance));
    }
  } else if (contestant.baseline == nullptr && separation.distance > 0) {
    for (std::size_t i = 0; i < count; ++i)
      do_not_optimize(solve(queries[i], {.separation = separation, .method = contestant.method}));
  } else if (contestant.baseline != nullptr) {
    const auto function = contestant.baseline->solve;
    for (std::size_t i = 0; i < count; ++i) do_not_optimize(function(queries[i], kWholeStep, contestant.tolerance));
  } else {
    for (std::size_t i = 0; i < count; ++i) do_not_optimize(solve(queries[i], {.method = contestant.method}));
  }
}

}  // namespace touchstone::report
