// SPDX-License-Identifier: MIT
#include "fuzz/named_solvers.hpp"

#include <array>
#include <string>
#include <utility>

#include <touchstone/curved.hpp>
#include <touchstone/solve.hpp>

#include "baselines/baseline.hpp"
#include "baselines/curved_baseline.hpp"
#include "baselines/separation_baseline.hpp"
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

/// Of an Answer or a baseline's Result.
template <class AnyAnswer>
Reply reply_of(const AnyAnswer& answer) {
  Reply reply;
  reply.contact = answer.contact;
  if (answer.contact) reply.toi = answer.toi;
  return reply;
}

class OurSolver final : public AnsweringSolver {
 public:
  OurSolver(std::string_view name, Method method, const Separation& separation)
      : name_(name), method_(method), separation_(separation) {}

  const std::string& name() const override { return name_; }
  bool supports(Kind) const override { return true; }
  void change_separation(const Separation& separation) override { separation_ = separation; }
  Answer answer(const Query& query) override { return solve(query, {.separation = separation_, .method = method_}); }

  Reply ask(const Query& query) override { return reply_of(answer(query)); }

  bool takes_curves() const override { return true; }
  Answer answer_curved(const CurvedQuery& query, double t_max) override {
    return solve(query, {.t_max = t_max, .separation = separation_, .method = method_});
  }
  Reply ask_curved(const CurvedQuery& query, double t_max) override { return reply_of(answer_curved(query, t_max)); }

 private:
  std::string name_;
  Method method_;
  Separation separation_;
};

/// The same query many times in one batch. A batch works on several queries at once; all must get the same answer.
class BatchSolver final : public AnsweringSolver {
 public:
  explicit BatchSolver(const Separation& separation) { options_.separation = separation; }
  void change_separation(const Separation& separation) override { options_.separation = separation; }

  const std::string& name() const override { return name_; }
  bool supports(Kind) const override { return true; }

  Answer answer(const Query& query) override {
    in_rows(query);
    in_columns(query);
    return common(2 * kCopies);
  }

  Reply ask(const Query& query) override { return reply_of(answer(query)); }

  bool takes_curves() const override { return true; }
  Answer answer_curved(const CurvedQuery& query, double t_max) override {
    BatchOptions options = options_;
    options.t_max = t_max;
    curved_rows_.fill(query);
    solve_batch(curved_rows_.data(), kCopies, answers_.data(), options);
    return common(kCopies);
  }
  Reply ask_curved(const CurvedQuery& query, double t_max) override { return reply_of(answer_curved(query, t_max)); }

 private:
  static constexpr std::size_t kCopies = 9;  // the widest vectors hold eight

  /// The answer that the first `count` have in common; one that differs, if there is one, for that is wrong.
  Answer common(std::size_t count) const {
    for (std::size_t i = 1; i < count; ++i) {
      if (!certify::bit_difference(answers_[i], answers_[0], true).empty()) return answers_[i];
    }
    return answers_[0];
  }

  void in_rows(const Query& query) {
    rows_.fill(query);
    solve_batch(rows_.data(), kCopies, answers_.data(), options_);
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
    solve_batch(columns, answers_.data() + kCopies, options_);
  }

  std::string name_{kBatch};
  BatchOptions options_;
  std::array<Query, kCopies> rows_;
  std::array<CurvedQuery, kCopies> curved_rows_;
  std::array<std::array<double, kCopies>, 24> columns_{};
  std::array<Answer, 2 * kCopies> answers_;
};

std::unique_ptr<SolverUnderTest> baseline_solver(const baselines::Baseline& method) {
  const auto ask = [&method](const Query& query) {
    constexpr double kWholeStep = 1;
    return reply_of(method.solve(query, kWholeStep, method.usual_tolerance));
  };
  return callable_solver(std::string(method.name), ask, method.supports);
}

/// A method that takes a separation.
class SeparationSolver final : public SolverUnderTest {
 public:
  SeparationSolver(const baselines::SeparationBaseline& method, double distance)
      : name_(method.name), method_(method), distance_(distance) {}

  const std::string& name() const override { return name_; }
  bool supports(Kind) const override { return true; }
  void change_separation(const Separation& separation) override { distance_ = separation.distance; }

  Reply ask(const Query& query) override {
    constexpr double kWholeStep = 1;
    return reply_of(method_.solve(query, distance_, kWholeStep, method_.usual_tolerance));
  }

 private:
  std::string name_;
  const baselines::SeparationBaseline& method_;
  double distance_;
};

/// A method for curved queries only.
class CurvedSolver final : public SolverUnderTest {
 public:
  explicit CurvedSolver(const baselines::CurvedBaseline& method) : name_(method.name), method_(method) {}

  const std::string& name() const override { return name_; }
  bool supports(Kind kind) const override { return method_.supports(kind); }
  bool takes_straight() const override { return false; }
  bool takes_curves() const override { return true; }
  Reply ask(const Query&) override { return no_answer(Reply::State::malformed, "it takes curved queries only"); }
  Reply ask_curved(const CurvedQuery& query, double t_max) override {
    return reply_of(method_.solve(query, t_max, method_.usual_tolerance));
  }

 private:
  std::string name_;
  const baselines::CurvedBaseline& method_;
};

}  // namespace

std::vector<std::string_view> solver_names(const Separation& separation) {
  std::vector<std::string_view> names;
  for (const auto& [name, method] : kOurs) names.push_back(name);
  names.push_back(kBatch);
  if (separation.distance == 0) {
    for (const baselines::Baseline& method : baselines::methods()) names.push_back(method.name);
    for (const baselines::CurvedBaseline& method : baselines::curved_methods()) names.push_back(method.name);
  } else if (separation.metric == Metric::euclidean) {
    for (const baselines::SeparationBaseline& method : baselines::separation_methods()) names.push_back(method.name);
  }
  return names;
}

std::unique_ptr<SolverUnderTest> named_solver(std::string_view name, const Separation& separation) {
  for (const auto& [ours, method] : kOurs) {
    if (ours == name) return std::make_unique<OurSolver>(name, method, separation);
  }
  if (name == kBatch) return std::make_unique<BatchSolver>(separation);
  if (separation.distance > 0) {
    const auto* const baseline =
        separation.metric == Metric::euclidean ? baselines::find_separation_method(name) : nullptr;
    if (baseline == nullptr) return nullptr;
    return std::make_unique<SeparationSolver>(*baseline, separation.distance);
  }
  const auto* const curved = baselines::find_curved_method(name);
  if (curved != nullptr) return std::make_unique<CurvedSolver>(*curved);
  const baselines::Baseline* const baseline = baselines::find_method(name);
  return baseline != nullptr ? baseline_solver(*baseline) : nullptr;
}

}  // namespace touchstone::fuzz
