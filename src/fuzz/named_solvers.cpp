// SPDX-License-Identifier: MIT
#include "fuzz/named_solvers.hpp"

#include <array>
#include <string>
#include <utility>

#include <touchstone/solve.hpp>

#include "baselines/baseline.hpp"
#include "fuzz/answering_solver.hpp"
#include "fuzz/callable_solver.hpp"

namespace touchstone::fuzz {
namespace {

constexpr std::array<std::pair<std::string_view, Method>, 3> kOurs{
    {{"touchstone", Method::fast}, {"exact", Method::exact}, {"oracle", Method::oracle}}};

class OurSolver final : public AnsweringSolver {
 public:
  OurSolver(std::string_view name, Method method) : name_(name), method_(method) {}

  const std::string& name() const override { return name_; }
  bool supports(Kind) const override { return true; }
  Answer answer(const Query& query) override { return solve(query, method_); }

  Reply ask(const Query& query) override {
    const Answer given = answer(query);
    Reply reply;
    reply.contact = given.contact;
    if (given.contact) reply.toi = given.toi;
    return reply;
  }

 private:
  std::string name_;
  Method method_;
};

std::unique_ptr<SolverUnderTest> baseline_solver(const baselines::Method& method) {
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
  for (const baselines::Method& method : baselines::methods()) names.push_back(method.name);
  return names;
}

std::unique_ptr<SolverUnderTest> named_solver(std::string_view name) {
  for (const auto& [ours, method] : kOurs) {
    if (ours == name) return std::make_unique<OurSolver>(name, method);
  }
  const baselines::Method* const baseline = baselines::find_method(name);
  return baseline != nullptr ? baseline_solver(*baseline) : nullptr;
}

}  // namespace touchstone::fuzz
