// Digests, and JSON files that contain their own digest.
// SPDX-License-Identifier: MIT
#include "io/sealed_json.hpp"

#include <string>

#include "io/sha256.hpp"
#include "support/catch.hpp"

using namespace touchstone;

TEST_CASE("SHA-256 is that of FIPS 180-4") {
  CHECK(io::sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(io::sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(io::sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(io::sha256(std::string(1'000'000, 'a')) == "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("SHA-256 of every length around a block is a digest of its own") {
  std::string before;
  for (std::size_t size = 0; size < 200; ++size) {
    const std::string digest = io::sha256(std::string(size, '\xFF'));
    CHECK(digest.size() == 64);
    CHECK(digest != before);
    before = digest;
  }
  // As sha256sum computes them.
  CHECK(io::sha256(std::string(55, 'x')) == "d5e285683cd4efc02d021a5c62014694958901005d6f71e89e0989fac77e4072");
  CHECK(io::sha256(std::string(56, 'x')) == "04c26261370ee7541549d16dee320c723e3fd14671e66a099afe0a377c16888e");
  CHECK(io::sha256(std::string(64, 'x')) == "7ce100971f64e7001e8fe5a51973ecdfe1ced42befe7ee8d5fd6219506b5393c");
}

TEST_CASE("a sealed object begins with the digest of what follows the first line") {
  const std::string text = io::sealed_json("{\n \"a\": 1\n}\n");
  const std::string rest = "\n \"a\": 1\n}\n";
  CHECK(text == "{\"sha256\": \"" + io::sha256(rest) + "\",\n" + rest);
  CHECK(io::seal_holds(text));
}

TEST_CASE("any change of a sealed text breaks the seal") {
  const std::string good = io::sealed_json("{\"a\": [1, 2, 3]}");
  REQUIRE(io::seal_holds(good));
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    std::string text = good;
    text[bit / 8] = static_cast<char>(text[bit / 8] ^ (1 << bit % 8));
    CAPTURE(bit);
    REQUIRE_FALSE(io::seal_holds(text));
  }
  for (const std::string& text : {std::string(), std::string("{"), good.substr(1), good + " ", good + good,
                                  good.substr(0, good.size() - 1), std::string("{").append(good, good.find('\n'))}) {
    CHECK_FALSE(io::seal_holds(text));
  }
}
