// SPDX-License-Identifier: MIT
#include "cli/shared/findings/solvers.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>

#include <touchstone/error.hpp>

#include "cli/shared/words.hpp"
#include "fuzz/named_solvers.hpp"
#include "fuzz/processes/pipe_solver.hpp"
#include "fuzz/processes/plugin_solver.hpp"
#include "io/fail.hpp"

namespace touchstone::cli {
namespace {

bool is_path(const std::string& solver) {
  return solver.find('/') != std::string::npos || solver.ends_with(".so") || solver.ends_with(".dylib");
}

}  // namespace

fuzz::SolverFactory solver_factory(const SolverChoice& choice, const SeparationOption& option) {
  const Separation& separation = option.separation;
  fuzz::Limits limits;
  limits.answer = std::chrono::milliseconds(static_cast<std::int64_t>(std::ceil(1000 * choice.limit)));
  if (choice.any_memory) limits.memory = 0;
  if (!choice.command.empty()) {
    return [command = choice.command, limits, separation] { return fuzz::run_command(command, limits, separation); };
  }
  if (is_path(choice.solver)) {
    return [path = choice.solver, limits, separation] { return fuzz::load_plugin(path, limits, separation); };
  }
  if (fuzz::named_solver(choice.solver, separation) == nullptr) {
    std::string names;
    for (const auto name : fuzz::solver_names(separation)) names.append(names.empty() ? "" : ", ").append(name);
    std::string about;
    if (separation.distance > 0) about = " for " + separation_for_person(separation);
    if (option.each) about = fmt::format(" for separations of each query's own, {}", name_of(separation.metric));
    throw Error(fmt::format("{} is no solver{}; they are {}", io::in_quotes(choice.solver), about, names));
  }
  return [name = choice.solver, separation] { return fuzz::named_solver(name, separation); };
}

std::string solver_options(const SolverChoice& choice) {
  std::string options = choice.command.empty() ? "--solver " + shell_word(choice.solver)
                                               : "--solver-command " + shell_word(choice.command);
  if (choice.limit != SolverChoice().limit) options += fmt::format(" --limit {}", choice.limit);
  return options;
}

}  // namespace touchstone::cli
