// SPDX-License-Identifier: MIT
#include "cli/doctor/doctor.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>
#include <utility>

#include "cli/doctor/arithmetic.hpp"
#include "cli/doctor/checks.hpp"
#include "cli/doctor/found_components.hpp"
#include "cli/shared/build_facts.hpp"
#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/words.hpp"
#include "io/output_file.hpp"

namespace touchstone::cli {
namespace {

Check check(std::string name, std::string details, std::string fault) {
  throw_if_interrupted();
  const bool passed = fault.empty();
  return {std::move(name), passed ? std::move(details) : std::move(fault), passed};
}

}  // namespace

std::vector<Check> all_checks() {
  const QuerySolver solver = [](const Query& query) { return solve(query); };
  const auto batch = [](const QueryColumns& queries, VectorWidth width, int threads, Answer* answers) {
    BatchOptions options;
    options.vectors = width;
    options.threads = threads;
    solve_batch(queries, answers, options);
  };
  std::vector<Check> checks;
  // First: what the program was started with. The others set the environment that they need.
  checks.push_back(
      check("at the start", "rounding to nearest, subnormals kept, no traps", fault_of_environment(kThisArithmetic)));
  checks.push_back(check("rounding", "+ - * / and sqrt in four rounding modes", fault_of_rounding(kThisArithmetic)));
  checks.push_back(check("subnormals", "not flushed to zero", fault_of_subnormals(kThisArithmetic)));
  checks.push_back(check("contraction", "the compiler kept a product and a sum apart, and the order of sums",
                         fault_of_contraction(kThisArithmetic)));
  checks.push_back(check("fma", "a fused multiply-add rounds once", fault_of_fused(kThisArithmetic)));
  std::string widths;
  std::string fault = fault_of_vectors(
      [&](const QueryColumns& queries, VectorWidth width, Answer* answers) { batch(queries, width, 1, answers); },
      widths);
  checks.push_back(check("SIMD", widths + " bits give the answers of one query at a time", std::move(fault)));
  fault = fault_of_vectors([&](const QueryColumns& queries, VectorWidth,
                               Answer* answers) { batch(queries, VectorWidth::widest, 0, answers); },
                           widths);
  const unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  checks.push_back(check("threads", counted(threads, "thread") + " give the answers of one", std::move(fault)));
  checks.push_back(check("known answers", "first times 1/3 and (sqrt(5) - 1) / 2, in every environment",
                         fault_of_known_answers(solver)));
  std::size_t count = 0;
  fault = fault_of_bundled(solver, count);
  checks.push_back(check("exact answers", counted(count, "bundled query") + ", by filters and by exact arithmetic",
                         std::move(fault)));
  return checks;
}

int run_doctor() {
  const std::vector<Check> checks = all_checks();
  std::string text = build_facts() + "\nOptional parts\n" + text_of(build_components()) + text_of(found_components()) +
                     "\nNumerical environment\n";
  std::size_t failed = 0;
  for (const Check& each : checks) {
    text += fmt::format("{:<14} {:<4} {}\n", each.name, each.passed ? "ok" : "BAD", each.details);
    failed += each.passed ? 0 : 1;
  }
  text += failed == 0 ? "\nall is well\n" : "\n" + counted(failed, "check") + " failed\n";
  auto console = io::OutputFile::standard_output();
  console.write(text);
  console.commit();
  return failed == 0 ? kAllHold : kRefuted;
}

void add_doctor(CLI::App& program, Command& command) {
  CLI::App* const subcommand = program.add_subcommand(
      "doctor", "Say how this program was built, what is missing, and whether arithmetic is sound here");
  subcommand->footer(
      "Lists the build, its optional parts and what to install for those that are missing. Then it tests for about a\n"
      "second what the proofs of the library assume: rounding in all modes, subnormals, contraction, fused\n"
      "multiply-add, SIMD of each width, threads, and answers that are known exactly.\n\n"
      "A part that is in the build needs a new build when its package is installed later.\n\n"
      "Exit status: 0 every check passed, 1 some check failed, 2 bad usage.");
  subcommand->callback([&command] { command = run_doctor; });
}

}  // namespace touchstone::cli
