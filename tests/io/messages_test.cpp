// Messages about hostile text: one line, of bounded length.
// SPDX-License-Identifier: MIT
#include <string>

#include "io/fail.hpp"
#include "support/catch.hpp"

using namespace touchstone;

TEST_CASE("text of any length is shown cut") {
  CHECK(io::in_quotes("abc\n") == "'abc\\n'");
  CHECK(io::shortened("abc\n") == "abc\\n");
  CHECK(io::shortened(std::string(100'000, '1')) == std::string(40, '1') + "...");
}

TEST_CASE("a name that is too long for a file is cut") {
  CHECK(io::printable(std::string(4096, 'x')) == std::string(4096, 'x'));
  CHECK(io::printable(std::string(4097, 'x')) == std::string(40, 'x') + "...");
}

TEST_CASE("a message of somebody else's keeps its words, cut where one is very long") {
  CHECK(io::with_short_words("--size: 12 is not  in range\n") == "--size: 12 is not  in range\\n");
  CHECK(io::with_short_words("").empty());
  CHECK(io::with_short_words(std::string(100, 'x') + " y") == std::string(100, 'x') + " y");
  CHECK(io::with_short_words("a " + std::string(101, 'x') + " b ") == "a " + std::string(40, 'x') + "... b ");
}
