// SPDX-License-Identifier: MIT
#include "cli/fuzz_solvers.hpp"

#include <fmt/format.h>

#include <memory>

#include <touchstone/error.hpp>

#include "cli/words.hpp"
#include "fuzz/named_solvers.hpp"
#include "io/fail.hpp"

namespace touchstone::cli {
namespace {

bool is_path(const std::string& solver) {
  return solver.find('/') != std::string::npos || solver.ends_with(".so") || solver.ends_with(".dylib");
}

}  // namespace

fuzz::SolverFactory solver_factory(const SolverChoice& choice) {
  if (!choice.command.empty()) throw Error("--solver-command: this build cannot run other programs as solvers");
  if (is_path(choice.solver)) io::fail(choice.solver, "this build cannot load plugins as solvers");
  if (fuzz::named_solver(choice.solver) == nullptr) {
    std::string names;
    for (const auto name : fuzz::solver_names()) names.append(names.empty() ? "" : ", ").append(name);
    throw Error(fmt::format("{} is no solver; they are {}", io::in_quotes(choice.solver), names));
  }
  return [name = choice.solver] { return fuzz::named_solver(name); };
}

std::string solver_options(const SolverChoice& choice) {
  if (!choice.command.empty()) return "--solver-command " + shell_word(choice.command);
  return "--solver " + shell_word(choice.solver);
}

}  // namespace touchstone::cli
