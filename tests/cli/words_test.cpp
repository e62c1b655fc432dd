// Numbers and names for a person.
// SPDX-License-Identifier: MIT
#include "cli/shared/words.hpp"

#include "cli/run_program.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::cli;

TEST_CASE("numbers are grouped and counted") {
  CHECK(grouped(0) == "0");
  CHECK(grouped(999) == "999");
  CHECK(grouped(1000) == "1,000");
  CHECK(grouped(1234567) == "1,234,567");
  CHECK(counted(1, "query") == "1 query");
  CHECK(counted(2, "query") == "2 queries");
  CHECK(counted(0, "file") == "0 files");
  CHECK(counted(1024, "thread") == "1,024 threads");
  CHECK(counted(1, "vertex") == "1 vertex");
  CHECK(counted(8, "vertex") == "8 vertices");
}

TEST_CASE("shares never round to all or nothing when it is not") {
  CHECK(percentage(0, 0) == "0.0 %");
  CHECK(percentage(0, 10) == "0.0 %");
  CHECK(percentage(1, 8) == "12.5 %");
  CHECK(percentage(10, 10) == "100.0 %");
  CHECK(percentage(1, 1'000'000) == "< 0.1 %");
  CHECK(percentage(999'999, 1'000'000) == "> 99.9 %");
}

TEST_CASE("the explain command can be pasted into a shell") {
  CHECK(explain_command("data/edge-edge/a.csv", Kind::edge_edge, 3) ==
        "touchstone explain --query 3 data/edge-edge/a.csv");
  CHECK(explain_command("data/a b.csv", Kind::point_edge, 3) ==
        "touchstone explain --kind point-edge --query 3 'data/a b.csv'");
  CHECK(explain_command("edge-edge/it's.csv", Kind::edge_edge, 0) ==
        "touchstone explain --query 0 'edge-edge/it'\\''s.csv'");
  CHECK(explain_command("-x/edge-edge/a.csv", Kind::edge_edge, 0) ==
        "touchstone explain --query 0 -- -x/edge-edge/a.csv");
  CHECK(shell_word("") == "''");
  CHECK(shell_word("it's\\ \x1b[1m\n\xe2\x80\xae") == "$'it\\'s\\\\ \\x1b[1m\\n\\xe2\\x80\\xae'");
}

TEST_CASE("a verdict's colour ends before what it is about, and only a terminal gets it") {
  using cli::VerdictLine;
  CHECK(cli::with_colour("2 steps, all free (3 vertices); x\n", VerdictLine::first, true) ==
        "\033[32m2 steps, all free\033[0m (3 vertices); x\n");
  CHECK(cli::with_colour("a\n1 step: 0 free; x (y)\n", VerdictLine::last, false) ==
        "a\n\033[31m1 step: 0 free\033[0m; x (y)\n");
  CHECK(cli::with_colour("3 steps, 0 crossings\nrest (x)\n", VerdictLine::first, true) ==
        "\033[32m3 steps, 0 crossings\033[0m\nrest (x)\n");
  CHECK(cli::with_colour("x", VerdictLine::last, true) == "\033[32mx\033[0m");
  CHECK(cli::with_colour("", VerdictLine::last, true) == "");
  CHECK(tests::run_program({"certify"}).out.find('\033') == std::string::npos);
}
