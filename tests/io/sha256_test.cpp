// The digest against those that FIPS 180-4 and its examples give, with and without the processor's instructions.
// SPDX-License-Identifier: MIT
#include "io/sha256.hpp"

#include <string>
#include <string_view>

#include "support/catch.hpp"

using namespace touchstone;

TEST_CASE("the digests of the standard's examples") {
  const auto check = [](const std::string& text, const std::string& digest) {
    CHECK(io::sha256(text) == digest);
    CHECK(io::sha256_in_portable_code(text) == digest);
  };
  check("", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  check("abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  check("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  check(std::string(1'000'000, 'a'), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("the processor's instructions give the same digest at every length") {
  std::string text;
  for (int i = 0; i < 300; ++i) {
    CAPTURE(i);
    CHECK(io::sha256(text) == io::sha256_in_portable_code(text));
    text += static_cast<char>(31 * i + i / 7);
  }
}

TEST_CASE("bytes that come in pieces of any length have the digest of the whole") {
  std::string text;
  for (int i = 0; i < 700; ++i) text += static_cast<char>(17 * i + i / 5);
  for (std::size_t piece = 1; piece < 200; piece += 7) {
    io::Sha256 sum;
    for (std::size_t at = 0; at < text.size(); at += piece) {
      sum.add(std::string_view(text).substr(at, piece));
      sum.add("");
    }
    CAPTURE(piece);
    CHECK(sum.digest() == io::sha256(text));
  }
}
