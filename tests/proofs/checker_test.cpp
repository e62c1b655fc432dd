// Proofs written by hand, accepted and rejected: one for each rule of docs/proofs.md about a query.
// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "proofs/run_checker.hpp"
#include "proofs/small_proofs.hpp"
#include "support/catch.hpp"

using namespace touchstone::tests;

namespace {

const std::string kPlanes = "different sides";
const std::string kEqual = "not proved to be equal";
const std::string kTimes = "the times must be";
const std::string kHalf = "0 contact 0x1p-1 0x1p-1";

const std::string kBeside =  // (-1 + 2 t, 1)
    rows({{"0", "0", "0"}, {"-1", "1", "0"}}, {{"0", "0", "0"}, {"1", "1", "0"}});

std::string at_rest(const std::vector<Corner>& corners) { return rows(corners, corners); }
/// Two edges along x and y; the second one moves along z.
std::string crossing(const char* start, const char* end) {
  return rows({{"-1", "0", "0"}, {"1", "0", "0"}, {"0", "-1", start}, {"0", "1", start}},
              {{"-1", "0", "0"}, {"1", "0", "0"}, {"0", "-1", end}, {"0", "1", end}});
}
/// A vertex that moves along z, above the inside of a face.
std::string landing(const char* start, const char* end) {
  return rows({{"0", "0", start}, {"-4", "-4", "0"}, {"4", "-4", "0"}, {"0", "4", "0"}},
              {{"0", "0", end}, {"-4", "-4", "0"}, {"4", "-4", "0"}, {"0", "4", "0"}});
}

}  // namespace

TEST_CASE("one piece proves that there is no contact, for each kind") {
  accept(kPoints, kApart, {"0 none", "d 1 0 0"});
  accept(kPoints, kApart, {"0 none", "d -1 0 0"});
  accept(kPoints, kApart, {"0 none", "d 0x1p-900 0 0"});
  accept("edge-edge", crossing("2", "1"), {"0 none", "n"});
  accept("edge-edge", crossing("-2", "-1"), {"0 none", "n"});
  accept("edge-edge", crossing("2", "1"), {"0 none", "d 0 0 1"});
  accept("vertex-face", landing("2", "1"), {"0 none", "n"});
  accept("vertex-face", landing("2", "1"), {"0 none", "d 0 0 7"});
  const std::string edge = at_rest({{"0", "0", "1"}, {"-1", "0", "0"}, {"1", "0", "0"}});
  accept("point-edge", edge, {"0 none", "d 0 0 1"});
  reject("a piece", "point-edge", edge, {"0 none", "n"});
  reject("a piece", kPoints, kApart, {"0 none", "n"});
  reject(kPlanes, "edge-edge", crossing("2", "-1"), {"0 none", "n"});
  reject(kPlanes, "vertex-face", landing("2", "-1"), {"0 none", "n"});
  reject(kPlanes, "point-edge", edge, {"0 none", "d 1 0 0"});  // the corners are on two sides
  reject(kPlanes, kPoints, kApart, {"0 none", "d 0 0 0"});
  reject(kPlanes, kPoints, kApart, {"0 none", "d 0 1 0"});
}

TEST_CASE("the number of coefficients of a direction decides how near the Bernstein coefficients are to the values") {
  accept(kPoints, kApart, {"0 none", "d 1 0 0 0 0 0"});
  accept(kPoints, kApart, {"0 none", "d 1 0 0 1 0 0"});
  reject(kPlanes, kPoints, kApart, {"0 none", "d 1 0 0 -2 0 0"});
  // (1 - 3 t + 3 t^2) 2 > 0 has the coefficients 2, -1, 2 for d = 2, and a positive one for each i if d = 8.
  const std::string still = on_axis("2", "2");
  reject(kPlanes, kPoints, still, {"0 none", "d 1 0 0 -3 0 0 3 0 0"});
  accept(kPoints, still, {"0 none", "d 1 0 0 -3 0 0 3 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0"});
  reject("a piece", kPoints, kApart, {"0 none", "d 1 0"});
  reject("a piece", kPoints, kApart, {"0 none", "d 1 0 0 0"});
  reject("a piece", kPoints, kApart, {"0 none", "d"});
  reject("a piece", kPoints, kApart, {"0 none", "e 1 0 0"});
  std::string most = "d 1 0 0";
  for (int i = 0; i < 32; ++i) most += " 0 0 0";
  accept(kPoints, kApart, {"0 none", most});
  call_bad("at most 33", kPoints, kApart, {"0 none", most + " 0 0 0"});
}

TEST_CASE("a byte order mark at the start of a file is skipped, and nowhere else") {
  const std::string mark = "\xEF\xBB\xBF";
  const std::string query = on_axis("1", "2");
  const std::string proofs = proofs_of("point-point", {"0 none", "d 1 0 0"});
  CHECK(check_texts(mark + proofs, {mark + query}).status == 0);
  CHECK(check_texts(mark + mark + proofs, {query}).status == 2);
  CHECK(check_texts(proofs, {query + mark}).status == 2);
}

TEST_CASE("pieces cover the time in order") {
  const Lines two = {"0 none", "d -1 1 0 to 0x1p-1", "d 1 1 0"};
  accept(kPoints, kBeside, two);
  accept(kPoints, kBeside, {"0 none", "d -1 1 0 to 0x1p-2", "d 0 1 0 to 0x3p-2", "d 1 1 0"});
  reject(kPlanes, kPoints, kBeside, {"0 none", "d -1 1 0"});  // zero at the end
  reject(kPlanes, kPoints, kBeside, {"0 none", "d 1 1 0 to 0x1p-1", "d -1 1 0"});
  const std::string order = "the number after \"to\"";
  reject(order, kPoints, kBeside, {"0 none", "d 0 1 0 to 0", "d 0 1 0"});
  reject(order, kPoints, kBeside, {"0 none", "d 0 1 0 to -1", "d 0 1 0"});
  reject(order, kPoints, kBeside, {"0 none", "d 0 1 0 to 1", "d 0 1 0"});
  reject(order, kPoints, kBeside, {"0 none", "d 0 1 0 to 2", "d 0 1 0"});
  reject(order, kPoints, kBeside, {"0 none", "d 0 1 0 to 0x1p-1", "d 0 1 0 to 0x1p-1", "d 0 1 0"});
  reject(order, kPoints, kBeside, {"0 none", "d 0 1 0 to 0x1p-1", "d 0 1 0 to 0x1p-2", "d 0 1 0"});
  reject("a piece", kPoints, kBeside, {"0 none", "d 0 1 0 to 0x1p-1"});
  reject("a piece", kPoints, kBeside, {"0 none"});
  reject("", kPoints, kBeside, {"0 none", "d 0 1 0", "d 0 1 0"});
  call_bad("is no number", kPoints, kBeside, {"0 none", "d 0 1 0 to x", "d 0 1 0"});
}

TEST_CASE("a contact at a double") {
  accept(kPoints, kMeeting, Lines{kHalf, "d -1 0 0"} + kWeights);
  accept(kPoints, kMeeting, Lines{kHalf, "d -1 0 0 to 0x1p-2", "d -1 0 0"} + kWeights);
  accept(kPoints, kMeeting, {kHalf, "d -1 0 0", "w 1 0x1p-3 1", "w 0 7"});
  reject(kPlanes, kPoints, kMeeting, Lines{kHalf, "d 0 1 0"} + kWeights);
  reject("a piece", kPoints, kMeeting, Lines{kHalf} + kWeights);
  reject(kEqual, kPoints, kPassing, Lines{kHalf, "d -1 0 0"} + kWeights);
  reject(kPlanes, kPoints, kMeeting, Lines{"0 contact 0x3p-2 0x3p-2", "d -1 0 0"} + kWeights);
  accept("edge-edge", crossing("1", "-1"), {kHalf, "n", "w 0 1", "w 1 1", "w 2 1", "w 3 1"});
  reject(kEqual, "edge-edge", crossing("1", "-1"), {kHalf, "n", "w 0 1", "w 1 1", "w 2 2", "w 3 1"});
  accept("vertex-face", landing("1", "-1"), {kHalf, "n", "w 0 1", "w 1 1", "w 2 1", "w 3 2"});
  accept("point-edge", at_rest({{"0", "0", "0"}, {"-1", "0", "0"}, {"1", "0", "0"}}),
         {"0 contact 0 0", "w 0 1", "w 1 1", "w 2 1"});
  // The coefficients but the first may vanish only in the last piece: here the third one does, at t = 1/2.
  const std::string bounce = rows({{"0", "0", "0"}, {"-1", "1", "0"}}, {{"0", "0", "0"}, {"1", "-1", "0"}});
  accept(kPoints, bounce, Lines{kHalf, "d -1 0 0 to 0x1p-2", "d 0 1 0"} + kWeights);
  reject(kPlanes, kPoints, kBeside, {"0 none", "d -1 0 0 to 0x1p-1", "d 1 1 0"});
}

TEST_CASE("a contact at time zero has no pieces") {
  const std::string same = on_axis("0", "5");
  accept(kPoints, same, Lines{"0 contact 0 0"} + kWeights);
  accept(kPoints, same, Lines{"0 contact -0 0x0p0"} + kWeights);
  reject("may all be zero", kPoints, same, Lines{"0 contact 0 0", "d 1 0 0"} + kWeights);
  reject(kEqual, kPoints, kApart, Lines{"0 contact 0 0"} + kWeights);
  // The root 2^-1075 lies between 0 and the least double. The piece covers [0, 0].
  const Lines least = Lines{"0 contact 0 0x1p-1074", "d -1 0 0", "root -1 0x1p1075"} + kWeights;
  std::string power = "1";
  for (int i = 0; i < 1075; ++i) {
    int carry = 0;
    for (auto digit = power.rbegin(); digit != power.rend(); ++digit) {
      const int twice = 2 * (*digit - '0') + carry;
      *digit = static_cast<char>('0' + twice % 10);
      carry = twice / 10;
    }
    if (carry > 0) power.insert(power.begin(), '1');
  }
  power.back() = static_cast<char>(power.back() - 1);  // 2^1075 is even and no multiple of 10
  accept(kPoints, on_axis("-1", power.c_str()), least);
  reject(kPlanes, kPoints, on_axis("0", power.c_str()), least);
}

TEST_CASE("a contact between two neighbouring doubles") {
  const Lines start = {kTwoThirds, "d -1 0 0"};
  accept(kPoints, kPassing, start + Lines{"root -2 3"} + kWeights);
  accept(kPoints, kPassing, start + Lines{"root 4 -6"} + kWeights);
  accept(kPoints, kPassing, start + Lines{"root -2 1 3"} + Lines{"w 0 1 1", "w 1 1 1"});
  const std::string between = " between 0x1.55555555555552p-1 0x1.55555555555558p-1";
  accept(kPoints, kPassing, start + Lines{"root -2 3" + between} + kWeights);
  reject("T <= LOW", kPoints, kPassing, start + Lines{"root -2 3 between 0x1p-1 1"} + kWeights);
  reject("T <= LOW", kPoints, kPassing,
         start + Lines{"root -2 3 between 0x1.55555555555558p-1 0x1.55555555555552p-1"} + kWeights);
  reject("T <= LOW", kPoints, kPassing,
         start + Lines{"root -2 3 between 0x1.55555555555558p-1 0x1.55555555555558p-1"} + kWeights);
  reject("change its sign", kPoints, kPassing,
         start + Lines{"root -2 3 between 0x1.55555555555550p-1 0x1.55555555555551p-1"} + kWeights);
  reject("change its sign", kPoints, kPassing, start + Lines{"root -1 2"} + kWeights);
  reject("change its sign", kPoints, kPassing, start + Lines{"root -0x1.5555555555555p-1 1"} + kWeights);
  reject("leading coefficient", kPoints, kPassing, start + Lines{"root 1"} + kWeights);
  reject("leading coefficient", kPoints, kPassing, start + Lines{"root -2 3 0"} + kWeights);
  reject("\"root\"", kPoints, kPassing, start + Lines{"root"} + kWeights);
  reject("\"root\"", kPoints, kPassing, start + kWeights);
  reject("may all be zero", kPoints, kMeeting, Lines{kHalf, "d -1 0 0", "root -1 2"} + kWeights);
  reject(kEqual, kPoints, kPassing, start + Lines{"root -0x2.00000000000001p0 3"} + kWeights);
  call_bad("is no number", kPoints, kPassing, start + Lines{"root -2 3 between 1"} + kWeights);
  // A weight that is a multiple of g vanishes at the root.
  const std::string end =
      rows({{"0", "0", "0"}, {"-2", "0", "0"}, {"-3", "0", "0"}}, {{"0", "0", "0"}, {"1", "0", "0"}, {"-3", "0", "0"}});
  accept("point-edge", end, start + Lines{"root -2 3"} + Lines{"w 0 1", "w 1 1", "w 2 2 -3"});
  accept("point-edge", end, start + Lines{"root -6 9"} + Lines{"w 0 1", "w 1 1", "w 2 2 -3"});
  accept("point-edge", end, start + Lines{"root -0x3p-3 0x9p-4"} + Lines{"w 0 1", "w 1 1", "w 2 0x2p-9 -0x3p-9"});
  reject("corner 2 may be negative", "point-edge", end,
         start + Lines{"root -2 3"} + Lines{"w 0 1", "w 1 1", "w 2 2 -4"});
}

TEST_CASE("the times of a contact") {
  const Lines rest = Lines{"d -1 0 0", "root -2 3"} + kWeights;
  for (const char* const times :
       {"0x1.5555555555555p-1 0x1.5555555555557p-1", "0x1.5555555555556p-1 0x1.5555555555555p-1", "0x1p-1 1", "2 2",
        "-1 -1", "1 0x1.0000000000001p0", "-0x1p-1074 0", "0x1.55555555555558p-1 0x1.55555555555558p-1",
        "0x1p-1075 0x1p-1075"}) {
    reject(kTimes, kPoints, kPassing, Lines{std::string("0 contact ") + times} + rest);
  }
  reject("none", kPoints, kPassing, Lines{"0 contact 1"} + rest);
  reject("none", kPoints, kPassing, Lines{"0 contact 1 1 1"} + rest);
  call_bad("is no number", kPoints, kPassing, Lines{"0 contact 1 one"} + rest);
  accept(kPoints, on_axis("-1", "0"), Lines{"0 contact 1 1", "d -1 0 0"} + kWeights);
}

TEST_CASE("weights") {
  const std::string line = at_rest({{"2", "0", "0"}, {"0", "0", "0"}, {"1", "0", "0"}});  // a point beside an edge
  const std::string end = at_rest({{"0", "0", "0"}, {"0", "0", "0"}, {"1", "0", "0"}});
  const std::string now = "0 contact 0 0";
  reject("corner 1 may be negative", "point-edge", line, {now, "w 0 1", "w 1 -1", "w 2 2"});
  accept("point-edge", end, {now, "w 0 1", "w 1 1", "w 2 0"});
  accept("point-edge", end, {now, "w 1 1", "w 0 1"});
  accept("point-edge", end, {now, "w 1 1 -5", "w 0 1 0 0"});
  reject("may all be zero", "point-edge", end, {now, "w 0 0", "w 1 0", "w 2 0"});
  reject("may all be zero", "point-edge", end, {now});
  reject("may all be zero", "point-edge", end, {now, "w 0 1"});
  reject("may all be zero", "point-edge", end, {now, "w 1 1"});
  reject("has no weight yet", "point-edge", end, {now, "w 0 1", "w 1 1", "w 0 1"});
  reject("has no weight yet", "point-edge", end, {now, "w 0 1", "w 1 1", "w 3 1"});
  reject("has no weight yet", "point-edge", end, {now, "w 0 1", "w 01 1"});
  reject("has no weight yet", "point-edge", end, {now, "w 0 1", "w 1"});
  reject("has no weight yet", "point-edge", end, {now, "w 0 1", "w -1 1"});
  reject("may all be zero", kPoints, kMeeting, {kHalf, "d -1 0 0", "w 0 -1 2", "w 1 -1 2"});
  reject("may all be zero", kPoints, kPassing, {kTwoThirds, "d -1 0 0", "root -2 3", "w 0 -2 3", "w 1 -2 3"});
  call_bad("is no number", "point-edge", end, {now, "w 0 1", "w 1 x"});
}

TEST_CASE("coordinates may be any fractions") {
  const std::string thirds = "0,1,0,1,0,1,0\n2,3,0,1,0,5,0\n0,1,0,1,0,1,0\n1,7,0,1,0,1,0\n";
  accept(kPoints, thirds, {"0 none", "d 1 0 0"});
  accept(kPoints, thirds, {"0 none", "d 1 0 0"}, "euclidean 0x2p-4");
  reject(kPlanes, kPoints, thirds, {"0 none", "d 1 0 0"}, "max 0x3p-4");
  accept(kPoints, "# a comment\n 0 ,1, 0,1,0,1 , 0\r\n\n2,1,0,1,0,1,0\n0,1,0,1,0,1,0\n000003,4096,-0,1,0,1,0",
         {"0 none", "d 1 0 0"});
}

TEST_CASE("a separation: pieces") {
  const std::string apart = on_axis("3", "2");
  for (const char* const metric : {"euclidean ", "max "}) {
    accept(kPoints, apart, {"0 none", "d 1 0 0"}, metric + std::string("1"));
    accept(kPoints, apart, {"0 none", "d -5 0 0"}, metric + std::string("0x1.fffffffffffffp0"));
    accept(kPoints, apart, {"0 none", "d 1 0 0 to 0x1p-1", "d 1 0 0 1 0 0"}, metric + std::string("1"));
    reject(kPlanes, kPoints, apart, {"0 none", "d 1 0 0"}, metric + std::string("2"));
    reject(kPlanes, kPoints, apart, {"0 none", "d 1 0 0"}, metric + std::string("3"));
    accept("edge-edge", crossing("3", "2"), {"0 none", "n"}, metric + std::string("0x1.fp0"));
    reject(kPlanes, "edge-edge", crossing("3", "2"), {"0 none", "n"}, metric + std::string("2"));
    accept("vertex-face", landing("-3", "-2"), {"0 none", "n"}, metric + std::string("0x1.fp0"));
    reject(kPlanes, "vertex-face", landing("-3", "-2"), {"0 none", "n"}, metric + std::string("2"));
    // The squares are large enough, but the edge reaches to both sides, or the point passes.
    const std::string through = at_rest({{"0", "0", "0"}, {"-3", "0", "0"}, {"3", "0", "0"}});
    reject(kPlanes, "point-edge", through, {"0 none", "d 1 0 0"}, metric + std::string("1"));
    reject(kPlanes, kPoints, on_axis("-3", "3"), {"0 none", "d 1 0 0"}, metric + std::string("1"));
  }
  const std::string diagonal = at_rest({{"0", "0", "0"}, {"3", "3", "0"}});  // 4.24 or 3 apart
  accept(kPoints, diagonal, {"0 none", "d 1 1 0"}, "euclidean 4");
  reject(kPlanes, kPoints, diagonal, {"0 none", "d 1 0 0"}, "euclidean 4");
  reject(kPlanes, kPoints, diagonal, {"0 none", "d 1 1 0"}, "max 4");
  reject(kPlanes, kPoints, diagonal, {"0 none", "d 1 1 0"}, "max 3");
  accept(kPoints, diagonal, {"0 none", "d 1 1 0"}, "max 2");
  accept(kPoints, diagonal, {"0 none", "d 1 0 0"}, "max 0x1.7fffp1");
  reject(kPlanes, kPoints, diagonal, {"0 none", "d 1 -1 0"}, "max 0x1p-9");
  // A sum of three directions at once needs all eight signs.
  const std::string corner = at_rest({{"0", "0", "0"}, {"4", "-4", "4"}});
  accept(kPoints, corner, {"0 none", "d 1 -1 1"}, "max 0x1.ffp1");
  reject(kPlanes, kPoints, corner, {"0 none", "d 1 -1 1"}, "max 4");
}

TEST_CASE("a separation: meetings") {
  for (const char* const metric : {"euclidean ", "max "}) {
    const std::string two = metric + std::string("2"), one = metric + std::string("1");
    accept(kPoints, on_axis("3", "1"), Lines{kHalf, "d 1 0 0"} + kWeights, two);
    reject(kPlanes, kPoints, on_axis("3", "1"), Lines{"0 contact 0x3p-2 0x3p-2", "d 1 0 0"} + kWeights, two);
    reject("within the separation", kPoints, on_axis("4", "1"), Lines{kHalf, "d 1 0 0"} + kWeights, two);
    accept(kPoints, on_axis("3", "0"), Lines{kTwoThirds, "d 1 0 0", "root -2 3"} + kWeights, one);
    accept(kPoints, on_axis("-3", "0"), {kTwoThirds, "d 1 0 0", "root -2 3", "w 0 1 1", "w 1 2"}, one);
    reject("within the separation", kPoints, on_axis("3", "0"),
           Lines{kTwoThirds, "d 1 0 0", "root -0x2.00000000000001p0 3"} + kWeights, one);
    accept(kPoints, on_axis("1", "0"), Lines{"0 contact 0 0"} + kWeights, two);
    accept(kPoints, on_axis("2", "0"), Lines{"0 contact 0 0"} + kWeights, two);
    reject("within the separation", kPoints, on_axis("3", "0"), Lines{"0 contact 0 0"} + kWeights, two);
    accept("edge-edge", crossing("3", "1"), {kHalf, "n", "w 0 1", "w 1 1", "w 2 1", "w 3 1"}, two);
    accept("vertex-face", landing("3", "1"), {kHalf, "n", "w 0 1", "w 1 1", "w 2 1", "w 3 2"}, two);
    reject("within the separation", "vertex-face", landing("3", "1"), {kHalf, "n", "w 0 1", "w 1 1"}, two);
  }
  const std::string diagonal = at_rest({{"0", "0", "0"}, {"3", "3", "3"}});  // 5.2 or 3 apart
  accept(kPoints, diagonal, Lines{"0 contact 0 0"} + kWeights, "max 3");
  reject("within the separation", kPoints, diagonal, Lines{"0 contact 0 0"} + kWeights, "euclidean 5");
  accept(kPoints, diagonal, Lines{"0 contact 0 0"} + kWeights, "euclidean 0x5.4p0");
  for (const Corner& far : {Corner{"4", "0", "0"}, Corner{"0", "-4", "0"}, Corner{"0", "0", "4"}}) {
    reject("within the separation", kPoints, at_rest({{"0", "0", "0"}, far}), Lines{"0 contact 0 0"} + kWeights,
           "max 3");
  }
}

TEST_CASE("a separation: its line") {
  const Lines proof = {"0 none", "d 1 0 0"};
  reject("separation euclidean D", kPoints, kApart, proof, "manhattan 1");
  reject("separation euclidean D", kPoints, kApart, proof, "max");
  reject("separation euclidean D", kPoints, kApart, proof, "max 1 1");
  reject("above zero", kPoints, kApart, proof, "max 0");
  reject("above zero", kPoints, kApart, proof, "max -1");
  call_bad("is no number", kPoints, kApart, proof, "max one");
  reject("file KIND", kPoints, kApart, proof, "max 1\nseparation max 1");
  const CheckerRun run = check_texts(proofs_of(kPoints, proof, "max 0x1p-3"), {kApart});
  INFO(run.text);
  CHECK(run.status == 0);
  CHECK(run.text.find("1 point-point query with separation max 0x1p-3; the proofs name no digest") !=
        std::string::npos);
}

TEST_CASE("a separation belongs to one file") {
  const std::string near = on_axis("1", "1");
  const std::string file = "file point-point - queries.csv\n";
  const std::string none = file + "0 none\nd 1 0 0\n", touch = file + "0 contact 0 0\nw 0 1\nw 1 1\n";
  const std::string first = "touchstone-proofs 1\n", two = "separation max 2\n";
  CHECK(check_texts(first + two + touch + none + "end 2 1\n", {near, near}).status == 0);
  CHECK(check_texts(first + none + two + touch + "end 2 1\n", {near, near}).status == 0);
  refuse_with(1, "file1: query 0: ", first + two + touch + touch + "end 2 2\n", {near, near});
  refuse_with(1, "file0: query 0: ", first + touch + two + touch + "end 2 2\n", {near, near});
  refuse_with(1, "file1: query 0: ", first + two + touch + two + none + "end 2 1\n", {near, near});
}
