// `touchstone doctor`, `touchstone --version --verbose`, and that each check of the doctor finds the fault that it is
// for.
// SPDX-License-Identifier: MIT
#include <cfenv>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include <touchstone/solve.hpp>
#include <touchstone/vector_width.hpp>
#include <touchstone/version.hpp>

#include "cli/doctor/checks.hpp"
#include "cli/run_program.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::cli;
using namespace touchstone::tests;

namespace {

double flushed(double x) { return std::fabs(x) < std::numeric_limits<double>::min() ? 0.0 : x; }

/// Off by one unit in the last place.
double next(double x) { return std::nextafter(x, 2 * x); }

/// What the line of a check or a part says: its second word and the rest.
std::string line_of(const std::string& text, const std::string& heading) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(heading + " ", 0) == 0) return line.substr(line.find_first_not_of(' ', heading.size()));
  }
  return "no line " + heading;
}

}  // namespace

TEST_CASE("the version with --verbose says how the program was built") {
  const Run run = run_program({"--version", "--verbose"});
  CHECK(run.status == 0);
  CHECK(run.err == "");
  CHECK(run.out.rfind(std::string("touchstone ") + version() + "\n", 0) == 0);
  CAPTURE(run.out);
#if defined(__clang__)
  CHECK(occurrences(line_of(run.out, "compiler"), "Clang " + std::to_string(__clang_major__) + ".") == 1);
#elif defined(__GNUC__)
  CHECK(occurrences(line_of(run.out, "compiler"), "GNU " + std::to_string(__GNUC__) + ".") == 1);
#endif
  CHECK(occurrences(line_of(run.out, "flags"), "-ffp-contract=off") == 1);
  for (const char* library : {"CGAL ", "Boost ", "GMP ", "MPFR ", "Eigen ", "CLI11 ", "fmt ", "nlohmann-json "}) {
    CAPTURE(library);
    CHECK(occurrences(line_of(run.out, "libraries"), library) == 1);
  }
  const std::string width = has_vectors(VectorWidth::bits_512)   ? "512 bits on"
                            : has_vectors(VectorWidth::bits_256) ? "256 bits on"
                                                                 : "128 bits on";
  CHECK(line_of(run.out, "SIMD").rfind(width, 0) == 0);
  CHECK(run_program({"--verbose", "--version"}).out == run.out);

  const Run alone = run_program({"--verbose"});
  CHECK(alone.status == 2);
  CHECK(alone.out == "");
}

TEST_CASE("the doctor finds this machine sound") {
  const Run run = run_program({"doctor"});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 0);
  for (const char* check :
       {"at the start", "rounding", "subnormals", "contraction", "fma", "SIMD", "known answers", "exact answers"}) {
    CAPTURE(check);
    CHECK(occurrences(run.out, std::string("\n") + check + " ") > 0);
  }
  CHECK(occurrences(run.out, " BAD ") == 0);
  CHECK(occurrences(run.out, "\nall is well\n") == 1);
}

TEST_CASE("the doctor's checks pass this machine's arithmetic, and each fault is found") {
  const auto faults = [](const Arithmetic& a) {
    std::string found;
    if (!fault_of_environment(a).empty()) found += "start ";
    if (!fault_of_rounding(a).empty()) found += "rounding ";
    if (!fault_of_subnormals(a).empty()) found += "subnormals ";
    if (!fault_of_contraction(a).empty()) found += "contraction ";
    if (!fault_of_fused(a).empty()) found += "fma ";
    return found;
  };
  CHECK(faults(kThisArithmetic) == "");

  Arithmetic a = kThisArithmetic;
  a.product = [](double x, double y) { return flushed(kThisArithmetic.product(x, y)); };
  CHECK(faults(a) == "start rounding subnormals ");
  a = kThisArithmetic;
  a.quotient = [](double x, double y) { return kThisArithmetic.product(x, kThisArithmetic.quotient(1, y)); };
  CHECK(faults(a) == "rounding ");  // two roundings; 1 / 2^-60 is exact
  a = kThisArithmetic;
  a.root = [](double x) { return next(kThisArithmetic.root(x)); };
  CHECK(faults(a) == "rounding ");
  a = kThisArithmetic;
  a.sum = [](double x, double y) {  // it ignores the rounding mode
    const int mode = std::fegetround();
    std::fesetround(FE_TONEAREST);
    const double sum = kThisArithmetic.sum(x, y);
    std::fesetround(mode);
    return sum;
  };
  CHECK(faults(a) == "rounding ");
  a = kThisArithmetic;
  a.product_and_sum = [](double x, double y, double z) { return std::fma(x, y, z); };
  CHECK(faults(a) == "contraction ");
  a = kThisArithmetic;
  a.sum_of_three = [](double x, double y, double z) { return kThisArithmetic.sum(x, kThisArithmetic.sum(y, z)); };
  CHECK(faults(a) == "contraction ");
  a = kThisArithmetic;
  a.fused = [](double x, double y, double z) { return kThisArithmetic.sum(kThisArithmetic.product(x, y), z); };
  CHECK(faults(a) == "fma ");
}

TEST_CASE("the doctor finds the environment that the program is started in") {
  std::fesetround(FE_UPWARD);
  const std::string fault = fault_of_environment(kThisArithmetic);
  std::fesetround(FE_TONEAREST);
  CHECK(fault == "it rounds upward");
}

TEST_CASE("the doctor finds wrong answers") {
  std::size_t count = 0;
  const QuerySolver right = [](const Query& query) { return solve(query); };
  CHECK(fault_of_known_answers(right) == "");
  CHECK(fault_of_bundled(right, count) == "");
  CHECK(count > 400);

  const QuerySolver late = [](const Query& query) {
    Answer answer = solve(query);
    answer.toi = std::nextafter(answer.toi, 2.0);
    return answer;
  };
  CHECK(occurrences(fault_of_known_answers(late), "the first time is 1/3") == 1);
  CHECK(occurrences(fault_of_bundled(late, count), "by exact arithmetic") == 1);
  const QuerySolver rounds = [&](const Query& query) {
    return std::fegetround() == FE_UPWARD ? late(query) : solve(query);
  };
  CHECK(fault_of_known_answers(rounds) != "");

  std::string widths;
  const BatchSolver batch = [](const QueryColumns& queries, VectorWidth width, Answer* answers) {
    BatchOptions options;
    options.vectors = width;
    solve_batch(queries, answers, options);
  };
  CHECK(fault_of_vectors(batch, widths) == "");
  CHECK(widths.rfind("none, 128", 0) == 0);
  const BatchSolver last_wrong = [&](const QueryColumns& queries, VectorWidth width, Answer* answers) {
    batch(queries, width, answers);
    if (width == VectorWidth::bits_128) answers[queries.count - 1].contact ^= true;
  };
  CHECK(occurrences(fault_of_vectors(last_wrong, widths), "128 bits: query ") == 1);
}
