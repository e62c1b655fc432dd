// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <cfenv>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "cli/doctor/checks.hpp"
#include "cli/shared/inputs.hpp"
#include "cli/shared/words.hpp"
#include "families/families.hpp"
#include "numbers/doubles/float_environment.hpp"
#include "solver/owned_columns.hpp"

namespace touchstone::cli {
namespace {

constexpr std::array<int, 4> kRoundings = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

/// The same times, nature and features. Levels have weights of their own, each within 2^-50 of the true one.
bool same_answer(const Answer& a, const Answer& b) {
  constexpr double kWeights = 0x1p-49;
  if (a.contact != b.contact) return false;
  if (!a.contact) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(std::fabs(a.weights_a[i] - b.weights_a[i]) <= kWeights)) return false;
    if (!(std::fabs(a.weights_b[i] - b.weights_b[i]) <= kWeights)) return false;
  }
  return a.toi == b.toi && a.toi_upper == b.toi_upper && a.nature == b.nature && a.feature_a == b.feature_a &&
         a.feature_b == b.feature_b;
}

bool same_bits(const Answer& a, const Answer& b) {
  return same_answer(a, b) && a.level == b.level &&
         (!a.contact || (a.weights_a == b.weights_a && a.weights_b == b.weights_b));
}

/// A query whose first time is known by hand.
struct Known {
  const char* about;
  Query query;
  double toi, toi_upper;
};

/// All coordinates times 2^exponent, which changes no time.
Query scaled(Query query, int exponent) {
  for (auto* const corners : {&query.start, &query.end}) {
    for (Vec3& x : *corners) {
      x = {std::ldexp(x.x, exponent), std::ldexp(x.y, exponent), std::ldexp(x.z, exponent)};
    }
  }
  return query;
}

std::vector<Known> known_queries() {
  Query crossing;  // b falls from z = 1 to z = -2 through a, at t = 1/3
  crossing.kind = Kind::edge_edge;
  crossing.start = {{{-1, 0, 0}, {1, 0, 0}, {0, -1, 1}, {0, 1, 1}}};
  crossing.end = {{{-1, 0, 0}, {1, 0, 0}, {0, -1, -2}, {0, 1, -2}}};
  Query golden;  // p = ((1 + t) / 4, 1 / 4) is on the line through 0 and (1, t) when t^2 + t = 1
  golden.kind = Kind::point_edge;
  golden.start = {{{0.25, 0.25, 0}, {0, 0, 0}, {1, 0, 0}, {}}};
  golden.end = {{{0.5, 0.25, 0}, {0, 0, 0}, {1, 1, 0}, {}}};
  constexpr double kThird = 0x1.5555555555555p-2, kThirdUpper = 0x1.5555555555556p-2;
  constexpr double kGolden = 0x1.3c6ef372fe94fp-1, kGoldenUpper = 0x1.3c6ef372fe950p-1;  // (sqrt(5) - 1) / 2
  return {
      {"1/3", crossing, kThird, kThirdUpper},
      {"1/3, with subnormal coordinates", scaled(crossing, -1074), kThird, kThirdUpper},
      {"1/3, with huge coordinates", scaled(crossing, 1021), kThird, kThirdUpper},
      {"(sqrt(5) - 1) / 2", golden, kGolden, kGoldenUpper},
      {"(sqrt(5) - 1) / 2, with subnormal coordinates", scaled(golden, -1070), kGolden, kGoldenUpper},
  };
}

#ifdef TOUCHSTONE_X86_ENVIRONMENT
constexpr unsigned kFlushBits = 0x8040;  // MXCSR: flush-to-zero, denormals-are-zero
void flush_subnormals() { _mm_setcsr(_mm_getcsr() | kFlushBits); }
constexpr std::array<bool, 2> kFlushes = {false, true};
#else
void flush_subnormals() {}
constexpr std::array<bool, 1> kFlushes = {false};
#endif

/// The answer under another environment, which is the default one again afterwards.
Answer answer_under(const QuerySolver& solver, const Query& query, int rounding, bool flush) {
  const numbers::DefaultFloatEnvironment environment;
  std::fesetround(rounding);
  if (flush) flush_subnormals();
  Answer answer = solver(query);
  numbers::set_default_float_environment();
  return answer;
}

/// Queries of each family that has one of this kind.
std::vector<Query> family_queries(Kind kind) {
  constexpr std::uint64_t kEach = 40;
  std::vector<Query> queries;
  for (const auto& info : families::all_families()) {
    if (info.group == families::Group::separation || info.group == families::Group::curved) continue;
    for (std::uint64_t i = 0; i < kEach; ++i) {
      queries.push_back(families::make({info.family, kind, 1, i}));
    }
  }
  return queries;
}

}  // namespace

std::string fault_of_known_answers(const QuerySolver& solver) {
  for (const Known& known : known_queries()) {
    for (const int rounding : kRoundings) {
      for (const bool flush : kFlushes) {
        const Answer answer = answer_under(solver, known.query, rounding, flush);
        if (answer.contact && answer.toi == known.toi && answer.toi_upper == known.toi_upper) continue;
        return fmt::format("the first time is {}, and the answer was: {}", known.about, to_string(answer));
      }
    }
  }
  return {};
}

std::string fault_of_vectors(const BatchSolver& solver, std::string& widths) {
  constexpr std::array<std::pair<VectorWidth, const char*>, 4> kWidths = {{{VectorWidth::none, "none"},
                                                                           {VectorWidth::bits_128, "128"},
                                                                           {VectorWidth::bits_256, "256"},
                                                                           {VectorWidth::bits_512, "512"}}};
  widths.clear();
  for (const auto& [width, name] : kWidths) {
    if (has_vectors(width)) widths += std::string(widths.empty() ? "" : ", ") + name;
  }
  for (const Kind kind : kKinds) {
    const std::vector<Query> queries = family_queries(kind);
    const solver::OwnedColumns columns(queries);
    std::vector<Answer> truth;
    for (const Query& query : queries) truth.push_back(solve(query));
    std::vector<Answer> answers(queries.size());
    for (const auto& [width, name] : kWidths) {
      if (!has_vectors(width)) continue;
      solver(columns.view(), width, answers.data());
      for (std::size_t q = 0; q < queries.size(); ++q) {
        if (same_bits(answers[q], truth[q])) continue;
        return fmt::format("{} bits: query {} of {} gave {}, and by itself {}", name, q, name_of(kind),
                           to_string(answers[q]), to_string(truth[q]));
      }
    }
  }
  return {};
}

std::string fault_of_bundled(const QuerySolver& solver, std::size_t& count) {
  count = 0;
  std::string fault;
  const std::vector<Input> inputs = bundled_touching_inputs();
  for_each_query(inputs, [&](std::size_t input, const io::QueryRecord& record) {
    const auto* const query = std::get_if<Query>(&record.query);
    if (query == nullptr || !fault.empty()) return;  // a rational query has no doubles to test
    ++count;
    const Answer answer = solver(*query);
    const Answer exact = solve(*query, {.method = Method::exact});
    if (answer.contact == record.truth && same_answer(answer, exact)) return;
    fault = fmt::format("{}, query {}: the answer was {}; by exact arithmetic {}", inputs[input].name, record.number,
                        to_string(answer), to_string(exact));
  });
  return fault;
}

}  // namespace touchstone::cli
