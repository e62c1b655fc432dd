// All methods give the same answer to one query, in every field.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/solve.hpp>

#include "certify/answer_check.hpp"
#include "query_bytes.hpp"
#include "solver/owned_columns.hpp"
#include "support/query_text.hpp"
#include "targets.hpp"

namespace touchstone::fuzzing {
namespace {

/// One answer of the oracle takes as long as hundreds of the others.
constexpr std::uint64_t kOracleOneIn = 256;
constexpr std::uint64_t kBatchOneIn = 8;
constexpr int kBatch = 11;  // a whole vector of lanes, and some over

void demand(const std::string& fault, const char* what, const Question& question, const Answer& one,
            const Answer& other) {
  if (fault.empty()) return;
  throw Finding(std::string(what) + ": " + fault + "\n  " + tests::cpp_initializer(question.query) + ", t_max " +
                tests::hexfloat(question.t_max) + "\n  one says   " + tests::describe(one) + "\n  other says " +
                tests::describe(other));
}

void compare(const char* what, const Question& question, const Answer& one, const Answer& other) {
  demand(certify::decision_difference(one, other), what, question, one, other);
  demand(certify::weight_difference(one, other), what, question, one, other);
}

/// Batches take several queries through the first filter at once, each in a lane of its own.
void check_batch(const Question& question, const Answer& fast) {
  Query reversed = question.query;
  std::swap(reversed.start, reversed.end);
  std::vector<Query> queries;
  for (int i = 0; i < kBatch; ++i) queries.push_back(i % 3 == 0 ? reversed : question.query);
  BatchOptions options;
  options.t_max = question.t_max;
  const auto answers = solve_batch(solver::OwnedColumns(queries).view(), options);
  const Answer backwards = solve(reversed, question.t_max);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const Answer& alone = i % 3 == 0 ? backwards : fast;
    demand(certify::bit_difference(answers[i], alone, false), "a batch and one query alone differ", question,
           answers[i], alone);
  }
}

}  // namespace

void fuzz_query(Bytes input) {
  const Question question = question_from(input);
  const Query& query = question.query;
  const Answer fast = solve(query, question.t_max);
  const Answer exact = solve(query, {.t_max = question.t_max, .method = Method::exact});
  demand(certify::malformation(query.kind, fast, question.t_max), "the cascade's answer is malformed", question, fast,
         exact);
  demand(certify::malformation(query.kind, exact, question.t_max), "the exact answer is malformed", question, fast,
         exact);
  compare("cascade and exact level differ", question, fast, exact);
  if (solve(query, {.t_max = question.t_max, .wanted = Wanted::contact}).contact != exact.contact) {
    demand("the contact alone says otherwise", "the contact alone and exact level differ", question, fast, exact);
  }
  if (hash_of(input) % kBatchOneIn == 1) check_batch(question, fast);
  if (hash_of(input) % kOracleOneIn == 0) {
    compare("exact level and oracle differ", question, exact,
            solve(query, {.t_max = question.t_max, .method = Method::oracle}));
  }
}

}  // namespace touchstone::fuzzing
