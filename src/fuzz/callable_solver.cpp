// SPDX-License-Identifier: MIT
#include "fuzz/callable_solver.hpp"

#include <exception>
#include <utility>

#include "numbers/doubles/float_environment.hpp"

namespace touchstone::fuzz {
namespace {

class CallableSolver final : public SolverUnderTest {
 public:
  CallableSolver(std::string name, Callable callable, std::function<bool(Kind)> supports)
      : name_(std::move(name)), callable_(std::move(callable)), supports_(std::move(supports)) {}

  const std::string& name() const override { return name_; }
  bool supports(Kind kind) const override { return !supports_ || supports_(kind); }

  Reply ask(const Query& query) override {
    // A callable that changes the environment must spoil neither the next question nor the engine's queries.
    struct Restore {
      ~Restore() { numbers::set_default_float_environment(); }
    } const restore;
    try {
      return callable_(query);
    } catch (const std::exception& error) {
      return no_answer(Reply::State::crashed, std::string("exception: ") + error.what());
    } catch (...) {
      return no_answer(Reply::State::crashed, "exception of an unknown type");
    }
  }

 private:
  std::string name_;
  Callable callable_;
  std::function<bool(Kind)> supports_;
};

}  // namespace

std::unique_ptr<SolverUnderTest> callable_solver(std::string name, Callable callable,
                                                 std::function<bool(Kind)> supports) {
  return std::make_unique<CallableSolver>(std::move(name), std::move(callable), std::move(supports));
}

}  // namespace touchstone::fuzz
