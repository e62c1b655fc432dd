// The lines of programs that are asked over pipes. Any bytes are an answer or none; a time has the value that the C
// library reads; a query that can be read is written back unchanged.
// SPDX-License-Identifier: MIT
#include "pipes/protocol.hpp"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <string>

#include "targets.hpp"

namespace touchstone::fuzzing {
namespace {

bool same_number(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

void check_answer(std::string_view line) {
  const auto answer = pipes::read_answer_line(line);
  if (!answer) return;
  if (line.find('\n') != std::string_view::npos) throw Finding("an answer of two lines");
  if (!answer->supported && answer->contact) throw Finding("an answer to what is not supported");
  if (!answer->toi) return;
  if (!answer->contact) throw Finding("a time without contact");
  // The C locale is in force here, so strtod is the judge of numbers.
  const std::string text(line.substr(line.find('1') + 1));
  char* end = nullptr;
  const double expected = std::strtod(text.c_str(), &end);
  if (std::string_view(end).find_first_not_of(" \t\r") != std::string_view::npos || end == text.c_str()) {
    throw Finding("strtod does not read this number to its end: " + text);
  }
  if (!same_number(expected, *answer->toi)) throw Finding("strtod reads another number here: " + text);
  const std::string& written = answer->toi_as_written;
  if (written.empty()) return;
  if (!std::isfinite(expected) || !same_number(std::strtod(written.c_str(), nullptr), expected)) {
    throw Finding("the time as it is written is another number: " + written + " for " + text);
  }
}

void check_query(std::string_view line) {
  const auto query = pipes::read_query_line(line);
  if (!query) return;
  std::string written = pipes::query_line(*query);
  if (written.back() != '\n') throw Finding("a query's line without its line feed");
  written.pop_back();
  const auto again = pipes::read_query_line(written);
  if (!again || pipes::query_line(*again) != written + "\n")
    throw Finding("a query's line is not read back: " + written);
}

}  // namespace

void fuzz_pipe_lines(Bytes input) {
  const std::string_view text = as_text(input);
  check_answer(text);
  check_query(text);
}

}  // namespace touchstone::fuzzing
