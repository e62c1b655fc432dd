// SPDX-License-Identifier: MIT
#include "fuzz/named_solvers.hpp"

#include <array>
#include <string>
#include <utility>

#include <touchstone/solve.hpp>

#include "baselines/baseline.hpp"
#include "certify/answer_check.hpp"
#include "fuzz/answering_solver.hpp"
#include "fuzz/callable_solver.hpp"

namespace touchstone::fuzz {
namespace {

constexpr std::array<std::pair<std::string_view, Method>, 4> kOurs{{{"touchstone", Method::fast},
                                                                    {"exact", Method::exact},
                                                                    {"oracle", Method::oracle},
                                                                    {"fast-cgal", Method::fast_cgal}}};

constexpr std::string_view kBatch = "batch";

Reply reply_of(const Answer& answer) {
  Reply reply;
  reply.contact = answer.contact;
  if (answer.contact) reply.toi = answer.toi;
  return reply;
}

class OurSolver final : public AnsweringSolver {
 public:
  OurSolver(std::string_view name, Method method) : name_(name), method_(method) {}

  const std::string& name() const override { return name_; }
  bool supports(Kind) const override { return true; }
  Answer answer(const Query& query) override { return solve(query, method_); }

  Reply ask(const Query& query) override { return reply_of(answer(query)); }

 private:
  std::string name_;
  Method method_;
};

/// The same query many times in one batch. A batch works on several queries at once; all must get the same answer.
class BatchSolver final : public AnsweringSolver {
 public:
  const std::string& name() const override { return name_; }
  bool supports(Kind) const override { return true; }

  Answer answer(const Query& query) override {
    in_rows(query);
    in_columns(query);
    for (const Answer& other : answers_) {
      if (!certify::bit_difference(other, answers_.front(), true).empty()) return other;  // one of them is wrong
    }
    return answers_.front();
  }

  Reply ask(const Query& query) override { return reply_of(answer(query)); }

 private:
  static constexpr std::size_t kCopies = 9;  // the widest vectors hold eight

  void in_rows(const Query& query) {
    rows_.fill(query);
    solve_batch(rows_.data(), kCopies, answers_.data());
  }

  void in_columns(const Query& query) {
    QueryColumns columns;
    columns.kind = query.kind;
    columns.count = kCopies;
    std::size_t next = 0;
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
      for (const bool start : {true, false}) {
        const Vec3& corner = (start ? query.start : query.end)[i];
        const std::array<double, 3> values{corner.x, corner.y, corner.z};
        for (std::size_t k = 0; k < 3; ++k) {
          columns_[next].fill(values[k]);
          (start ? columns.start : columns.end)[i][k] = columns_[next++].data();
        }
      }
    }
    solve_batch(columns, answers_.data() + kCopies);
  }

  std::string name_{kBatch};
  std::array<Query, kCopies> rows_;
  std::array<std::array<double, kCopies>, 24> columns_{};
  std::array<Answer, 2 * kCopies> answers_;
};

std::unique_ptr<SolverUnderTest> baseline_solver(const baselines::Baseline& method) {
  const auto ask = [&method](const Query& query) {
    constexpr double kWholeStep = 1;
    const baselines::Result result = method.solve(query, kWholeStep, method.usual_tolerance);
    Reply reply;
    reply.contact = result.contact;
    if (result.contact) reply.toi = result.toi;
    return reply;
  };
  return callable_solver(std::string(method.name), ask, method.supports);
}

}  // namespace

std::vector<std::string_view> solver_names() {
  std::vector<std::string_view> names;
  for (const auto& [name, method] : kOurs) names.push_back(name);
  names.push_back(kBatch);
  for (const baselines::Baseline& method : baselines::methods()) names.push_back(method.name);
  return names;
}

std::unique_ptr<SolverUnderTest> named_solver(std::string_view name) {
  for (const auto& [ours, method] : kOurs) {
    if (ours == name) return std::make_unique<OurSolver>(name, method);
  }
  if (name == kBatch) return std::make_unique<BatchSolver>();
  const baselines::Baseline* const baseline = baselines::find_method(name);
  return baseline != nullptr ? baseline_solver(*baseline) : nullptr;
}

}  // namespace touchstone::fuzz
