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

TEST_CASE("names are shown as UTF-8 that a terminal does not obey") {
  CHECK(io::printable("a\x1b[1m\n\t\r\x7f") == "a\\x1b[1m\\n\\t\\r\\x7f");
  for (const char* const plain : {"\xc3\xa9 \xe2\x82\xac \xf0\x9f\x8e\x88", "\xd9\x85\xe2\x80\x8c\xd9\x85", "\\x1b"}) {
    CHECK(io::printable(plain) == plain);
  }
  // U+202E and other marks of direction, C1 controls, line separators, no width; and what is no UTF-8.
  CHECK(io::printable("a\xe2\x80\xae"
                      "cod.b") ==
        "a\\xe2\\x80\\xae"
        "cod.b");
  for (const char* const hidden :
       {"\xe2\x80\x8e", "\xe2\x80\x8f", "\xe2\x80\xaa", "\xe2\x81\xa6", "\xe2\x81\xa9", "\xef\xbb\xbf", "\xc2\x80",
        "\xc2\x9f", "\xe2\x80\xa8", "\xe2\x80\x8b", "\xd8\x9c", "\xff", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80",
        "\xe2\x82", "\xe0\x82\xac"}) {
    const std::string text = io::printable(hidden);
    CAPTURE(text);
    CHECK(text.size() == 4 * std::string(hidden).size());
    CHECK(text.find_first_not_of("\\x0123456789abcdef") == std::string::npos);
    CHECK(io::printable(text) == text);
  }
}

TEST_CASE("a message of somebody else's keeps its words, cut where one is very long") {
  CHECK(io::with_short_words("--size: 12 is not  in range\n") == "--size: 12 is not  in range\\n");
  CHECK(io::with_short_words("").empty());
  CHECK(io::with_short_words(std::string(100, 'x') + " y") == std::string(100, 'x') + " y");
  CHECK(io::with_short_words("a " + std::string(101, 'x') + " b ") == "a " + std::string(40, 'x') + "... b ");
}
