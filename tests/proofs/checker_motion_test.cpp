// Proofs of meshes' motions, written by hand: the checker finds the pairs itself, and wants a proof of each.
// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "proofs/run_checker.hpp"
#include "support/catch.hpp"

using namespace touchstone::tests;

namespace {

const std::string kFirst = "touchstone-motion 1\n";

std::string proofs_of(const std::string& lines, const std::string& end, const std::string& separation = "") {
  return "touchstone-proofs 1\n" + (separation.empty() ? "" : "separation " + separation + "\n") +
         "file mesh - motion.txt\n" + lines + "end " + end + "\n";
}
void accept(const std::string& motion, const std::string& lines, const std::string& end,
            const std::string& separation = "") {
  const CheckerRun run = check_texts(proofs_of(lines, end, separation), {motion});
  INFO(separation << '\n' << motion << lines << run.text);
  CHECK(run.status == 0);
}
void reject(const std::string& message, const std::string& motion, const std::string& lines, const std::string& end,
            const std::string& separation = "") {
  const CheckerRun run = check_texts(proofs_of(lines, end, separation), {motion});
  INFO(separation << '\n' << motion << lines << run.text);
  CHECK(run.status == 1);
  CHECK(run.text.find(message) != std::string::npos);
}
void call_bad(const std::string& message, const std::string& motion) {
  const CheckerRun run = check_texts(proofs_of("step 0\n", "0 0"), {motion});
  INFO(motion.substr(0, 1000) << run.text);
  CHECK(run.status == 2);
  CHECK(run.text.find(message) != std::string::npos);
}

/// Edge 0 lies on the x axis, and edge 1 along y; its heights in the frames are given.
std::string crossing(const std::vector<std::string>& heights, const std::string& more = "") {
  std::string text = kFirst + "vertices 4\nedge 0 1\nedge 2 3\n" + more;
  for (const std::string& z : heights) text += "frame\n-1 0 0\n1 0 0\n0 -1 " + z + "\n0 1 " + z + "\n";
  return text;
}
const std::string kMiddles = "w 0 1\nw 1 1\nw 2 1\nw 3 1\n";

/// `count` contacts at time zero, numbered from `from` on, with weights for all corners.
std::string contacts(int from, int count, int corners) {
  std::string text;
  for (int i = from; i < from + count; ++i) {
    text += std::to_string(i) + " contact 0 0\n";
    for (int c = 0; c < corners; ++c) text += "w " + std::to_string(c) + " 1\n";
  }
  return text;
}

}  // namespace

TEST_CASE("motions: boxes that do not overlap are no pairs, and need no proofs") {
  accept(crossing({"3", "2"}), "step 0\n", "0 0");
  accept(crossing({"3", "2", "0x1p-1000"}), "step 0\nstep 1\n", "0 0");
  reject("a proof too many", crossing({"3", "2"}), "step 0\n0 none\nn\n", "1 0");
  reject("step 1", crossing({"3", "2", "1"}), "step 0\n", "0 0");
  reject("\"end\"", crossing({"3", "2"}), "step 0\nstep 1\n", "0 0");
  reject("step 0", crossing({"3", "2"}), "step 1\n", "0 0");
  reject("step 0", crossing({"3", "2"}), "", "0 0");
}

TEST_CASE("motions: a proof for each pair, which the messages name") {
  const std::string meets = "0 contact 0x1p-1 0x1p-1\nn\n" + kMiddles;
  accept(crossing({"1", "-1"}), "step 0\n" + meets, "1 1");
  accept(crossing({"1", "-1", "-2", "-3"}), "step 0\n" + meets + "step 1\nstep 2\n", "1 1");
  accept(crossing({"2", "1", "-1"}), "step 0\nstep 1\n" + meets, "1 1");
  reject("step 0: pair 0 (edge 0 and edge 1): ", crossing({"1", "-1"}), "step 0\n", "0 0");
  reject("step 1: pair 0 (edge 0 and edge 1): ", crossing({"2", "1", "-1"}), "step 0\nstep 1\n0 none\nn\n", "1 0");
  reject("a proof too many", crossing({"1", "-1"}), "step 0\n" + meets + meets, "2 2");
  reject("pair 0", crossing({"1", "-1"}), "step 0\n1" + meets.substr(1), "1 1");
  // Boxes that touch at one height need a proof, and the elements meet at once.
  accept(crossing({"0", "1"}), "step 0\n0 contact 0 0\n" + kMiddles, "1 1");
  reject("pair 0", crossing({"0", "1"}), "step 0\n", "0 0");
}

TEST_CASE("motions: boxes that are exactly the separation apart are a pair") {
  const std::string at_end = "step 0\n0 contact 1 1\nn\n" + kMiddles;
  for (const char* const metric : {"euclidean ", "max "}) {
    accept(crossing({"3", "2"}), at_end, "1 1", metric + std::string("2"));
    reject("pair 0", crossing({"3", "2"}), "step 0\n", "0 0", metric + std::string("2"));
    accept(crossing({"3", "2"}), "step 0\n", "0 0", metric + std::string("0x1.fffffffffffffffffffp0"));
    reject("a proof too many", crossing({"3", "2"}), at_end, "1 1", metric + std::string("0x1.fffffffffffffp0"));
    accept(crossing({"-3", "-2"}), at_end, "1 1", metric + std::string("2"));
    accept(crossing({"-3", "-2"}), "step 0\n", "0 0", metric + std::string("0x1.fffffffffffffffffffp0"));
  }
  // Coordinates whose difference from D has thousands of bits.
  const std::string small = "0x2." + std::string(1000, '0') + "1p0", tiny = "0x1p-4004";
  accept(crossing({"3", small}), "step 0\n", "0 0", "max 2");
  reject("pair 0", crossing({"3", small}), "step 0\n", "0 0", "max " + small);
  accept(crossing({tiny, "1"}), "step 0\n", "0 0");
  reject("pair 0", crossing({tiny, "1"}), "step 0\n", "0 0", "max " + tiny);
}

TEST_CASE("motions: the order of the pairs") {
  // Edge 0 is long; edge 1 falls through it at one end, edge 2 passes below its other end.
  const std::string frames =
      "frame\n-4 0 0\n4 0 0\n-3 -1 1\n-3 1 1\n3 -1 -2\n3 1 0x1p-1\n"
      "frame\n-4 0 0\n4 0 0\n-3 -1 -1\n-3 1 -1\n3 -1 -2\n3 1 0x1p-1\n";
  const std::string edges = "edge 0 1\nedge 2 3\nedge 4 5\n", swapped = "edge 0 1\nedge 4 5\nedge 2 3\n";
  const std::string meets = " contact 0x1p-1 0x1p-1\nn\nw 0 7\nw 1 1\nw 2 1\nw 3 1\n", misses = " none\nn\n";
  const std::string start = kFirst + "vertices 6\n";
  accept(start + edges + frames, "step 0\n0" + meets + "1" + misses, "2 1");
  accept(start + swapped + frames, "step 0\n0" + misses + "1" + meets, "2 1");
  reject("pair 0 (edge 0 and edge 1)", start + edges + frames, "step 0\n0" + misses + "1" + meets, "2 1");
  reject("pair 1 (edge 0 and edge 2)", start + edges + frames, "step 0\n0" + meets, "1 1");
  reject("pair 1 (edge 0 and edge 2)", start + edges + frames, "step 0\n0" + meets + "1" + meets, "2 2");
}

TEST_CASE("motions: all sorts of pairs") {
  // A face 0 1 2, points 3 and 4, an edge 5 6, and its start 5 as a point. With D = 100 all are in contact at once.
  const auto motion = [](const std::string& points, const std::string& more = "") {
    std::string text = kFirst + "vertices 7\n" + points + "face 0 1 2\nedge 5 6\n" + more;
    for (int frame = 0; frame < 2; ++frame) text += "frame\n0 0 0\n1 0 0\n0 1 0\n3 3 3\n4 3 3\n5 0 1\n6 0 1\n";
    return text;
  };
  const std::string far = "euclidean 100";
  // point-face: 0, 1; point-edge: 0, 1; point-point: 0-1
  accept(motion("point 3\npoint 4\n"), "step 0\n" + contacts(0, 2, 4) + contacts(2, 2, 3) + contacts(4, 1, 2), "5 5",
         far);
  // Point 2 is a corner of the face, and of no edge: no pair with the face.
  const std::string with_corner = "step 0\n" + contacts(0, 2, 4) + contacts(2, 3, 3) + contacts(5, 3, 2);
  accept(motion("point 3\npoint 4\npoint 0\n"), with_corner, "8 8", far);
  reject("pair 7 (point 1 and point 2)", motion("point 3\npoint 4\npoint 0\n"),
         "step 0\n" + contacts(0, 2, 4) + contacts(2, 3, 3) + contacts(5, 2, 2), "7 7", far);
  // Point 2 is a corner of the edge: a pair with the face alone.
  accept(motion("point 3\npoint 4\npoint 5\n"), "step 0\n" + contacts(0, 3, 4) + contacts(3, 2, 3) + contacts(5, 1, 2),
         "6 6", far);
  // Edges come first. Edges that share a vertex are no pair.
  accept(motion("point 3\n", "edge 3 4\n"), "step 0\n" + contacts(0, 1, 4) + contacts(1, 1, 4), "2 2", far);
  call_bad("there is nothing to check", motion("", "edge 6 4\n"));
  reject("a proof too many", motion("", "edge 6 4\n"), "step 0\n" + contacts(0, 1, 4), "1 1", far);
  // The edges of a face and its corners are no elements without lines of their own.
  call_bad("there is nothing to check", motion(""));
  // Elements of fixed vertices alone are no pairs.
  accept(motion("point 3\npoint 4\n", "fixed 3\nfixed 4\n"), "step 0\n" + contacts(0, 2, 4) + contacts(2, 2, 3), "4 4",
         far);
  accept(motion("point 3\npoint 4\n", "fixed 3\nfixed 4\nfixed 0\nfixed 1\nfixed 2\nfixed 6\n"),
         "step 0\n" + contacts(0, 2, 3), "2 2", far);
  accept(motion("point 3\npoint 4\n", "fixed 3\n"),
         "step 0\n" + contacts(0, 2, 4) + contacts(2, 2, 3) + contacts(4, 1, 2), "5 5", far);
}

TEST_CASE("motions: pairs that a sweep along any axis alone would miss or invent") {
  // A grid of points, each at the distance 1 from its neighbours. With D = 1 (max) each has its 26 neighbours.
  const auto grid = [](int dx, int dy, int dz) {
    std::string text = kFirst + "vertices 60\n";
    for (int i = 0; i < 60; ++i) text += "point " + std::to_string(i) + "\n";
    for (int frame = 0; frame < 2; ++frame) {
      text += "frame\n";
      for (int i = 0; i < 60; ++i) {
        const int x = i % 3, y = i / 3 % 4, z = i / 12;
        text += std::to_string(dx * x) + " " + std::to_string(dy * y) + " " + std::to_string(dz * z) + "\n";
      }
    }
    return text;
  };
  const auto neighbours = [](int nx, int ny, int nz) {  // of a grid, each pair once
    return ((3 * nx - 2) * (3 * ny - 2) * (3 * nz - 2) - nx * ny * nz) / 2;
  };
  const auto check = [](const std::string& motion, int pairs) {
    const std::string count = std::to_string(pairs);
    accept(motion, "step 0\n" + contacts(0, pairs, 2), count + " " + count, "max 1");
    reject("pair " + std::to_string(pairs - 1), motion, "step 0\n" + contacts(0, pairs - 1, 2), count + " " + count,
           "max 1");
    reject("a proof too many", motion, "step 0\n" + contacts(0, pairs + 1, 2), count + " " + count, "max 1");
  };
  check(grid(1, 1, 1), neighbours(3, 4, 5));
  check(grid(2, 1, 1), 3 * neighbours(1, 4, 5));
  check(grid(1, 2, 1), 4 * neighbours(3, 1, 5));
  check(grid(1, 1, 2), 5 * neighbours(3, 4, 1));
}

namespace {

/// Vertex 0 is the point `point` of a body at the origin that turns from the first quaternion to the second one, and
/// vertex 1 rests.
std::string turning(const std::string& point, const std::string& from, const std::string& to,
                    const std::string& other) {
  std::string text = kFirst + "vertices 2\npoint 0\npoint 1\nbody 0 0 " + point + "\n";
  for (const std::string& q : {from, to}) text += "frame\n" + q + " 0 0 0\n" + other + "\n";
  return text;
}

}  // namespace

TEST_CASE("motions: a body's pose moves its elements") {
  // Edge 0, of the body, falls through edge 1.
  const auto falls = [](const std::string& more) {
    return kFirst + "vertices 4\nedge 0 1\nedge 2 3\nbody 1 0 1 0 0\nbody 0 0 -1 0 0\n" + more;
  };
  const std::string rest = "0 -1 0\n0 1 0\n";
  const std::string frames = "frame\n1 0 0 0 0 0 1\n" + rest + "frame\n-3 0 0 0 0 0 -1\n" + rest;
  const std::string good = "frame\n1 0 0 0 0 0 1\n" + rest + "frame\n3 0 0 0 0 0 -1\n" + rest;
  const std::string meets = "0 contact 0x1p-1 0x1p-1\nd 0 0 1\n" + kMiddles;
  accept(falls("") + good, "step 0\n" + meets, "1 1");
  reject("pair 0 (edge 0 and edge 1)", falls("") + good, "step 0\n", "0 0");
  reject("pair 0 (edge 0 and edge 1)", falls("") + good, "step 0\n0 none\nd 0 0 1\n", "1 0");
  call_bad("turns too far", falls("") + frames);
  call_bad("body 0 in frame 1 is fixed, but has moved", falls("fixed 1\n") + good);
  call_bad("7 numbers of body 0 in frame 0", falls("") + "frame\n1 0 0 0 0 0\n" + rest);
  call_bad("7 numbers of body 0 in frame 1", falls("") + "frame\n1 0 0 0 0 0 1\n" + rest + "frame\n" + rest);
  call_bad("3 numbers of vertex 2 in frame 0", falls("") + "frame\n1 0 0 0 0 0 1\nframe\n");
  call_bad("such a line already", falls("body 0 1 0 0 0\n") + good);
  call_bad("7 numbers of body 1 in frame 0", falls("body 2 1 0 0 0\n") + good);
  call_bad("the number of a body", falls("body 2 1073741823 0 0 0\n") + good);
  call_bad("body 1 in frame 0", falls("body 2 1073741822 0 0 0\n") + good);
  call_bad("is no vertex", falls("body 4 0 0 0 0\n") + good);
  call_bad("body V B X Y Z", falls("body 2 0 0 0\n") + good);
  call_bad("is no number", falls("body 2 0 0 0 0.5\n") + good);
  // All on one body, or fixed: no pair in any step, so that there is nothing to check.
  call_bad(
      "2 edges, 0 faces, 4 vertices on 1 body, where 0 has vertices 0 to 3, 4 corners are no points, but no two "
      "elements",
      falls("body 2 0 0 -1 0\nbody 3 0 0 1 0\n") + "frame\n1 0 0 0 0 0 1\nframe\n1 0 0 0 0 0 2\n");
  const std::string still = "frame\n1 0 0 0 0 0 0\n" + rest;
  reject("pair 0", falls("fixed 2\nfixed 3\nfixed 0\n") + still + still, "step 0\n", "0 0");
  call_bad(
      "4 fixed vertices, 2 vertices on 1 body, where 0 has vertices 0 to 1, 4 corners are no points, but no two "
      "elements",
      falls("fixed 2\nfixed 3\nfixed 0\nfixed 1\n") + still + still);
}

TEST_CASE("motions: the box of a body's vertex is around the quotients of Bernstein coefficients, rounded outwards") {
  // A quarter turn of (1, 0, 0): the quotients are (1, 0), (1, 2/3), (1/2, 1) and (0, 1).
  const auto quarter = [](const std::string& other) { return turning("1 0 0", "1 0 0 0", "1 0 0 1", other); };
  const std::string below_one = "max 0x1.fffffffffffffp-1";
  for (const char* const other : {"2 1 0", "-1 0x1p-1 0", "1 2 0", "0x1p-1 -1 0", "0 0 1", "1 1 -1"}) {
    reject("pair 0 (point 0 and point 1)", quarter(other), "step 0\n", "0 0", "max 1");
    accept(quarter(other), "step 0\n", "0 0", below_one);
  }
  // To (1, 0, 0, 1/2): the greatest y is 4/5, which is no double, and the least x 3/5.
  const auto less = [](const std::string& other) { return turning("1 0 0", "1 0 0 0", "1 0 0 0x1p-1", other); };
  reject("pair 0", less("0x1.3333333333333p-1 0 0"), "step 0\n", "0 0");
  accept(less("0x1.3333333333332p-1 0 0"), "step 0\n", "0 0");
  reject("pair 0", less("1 0x1.999999999999ap-1 0"), "step 0\n", "0 0");
  accept(less("1 0x1.999999999999bp-1 0"), "step 0\n", "0 0");
  // The same with the signs of the point and of both quaternions changed, and with other lengths.
  const auto opposite = [](const std::string& other) { return turning("-1 0 0", "-7 0 0 0", "-4 0 0 -2", other); };
  reject("pair 0", opposite("-0x1.3333333333333p-1 0 0"), "step 0\n", "0 0");
  accept(opposite("-0x1.3333333333332p-1 0 0"), "step 0\n", "0 0");
  reject("pair 0", opposite("-1 -0x1.999999999999ap-1 0"), "step 0\n", "0 0");
  accept(opposite("-1 -0x1.999999999999bp-1 0"), "step 0\n", "0 0");
}

TEST_CASE("motions: the report") {
  const std::string proofs = proofs_of("step 0\nstep 1\n", "0 0", "max 0x1p-2"), motion = crossing({"3", "2", "1"});
  const CheckerRun refused = check_texts(proofs, {motion}, "");
  CHECK(refused.status == 1);
  CHECK(refused.text.rfind("rejected: no query was checked: no two elements that are ", 0) == 0);
  const CheckerRun run = check_texts(proofs, {motion});
  INFO(run.text);
  CHECK(run.status == 0);
  const std::string none_near = "no two elements that are asked about come near enough to need a proof";
  CHECK(
      run.text.find(": 0 mesh queries in 2 steps with separation max 0x1p-2: 3 frames, 4 vertices, 0 points, 2 edges, "
                    "0 faces, 4 corners are no points; " +
                    none_near + "; the proofs name no digest of the file\n") != std::string::npos);
  CHECK(run.text.find("\n0 queries checked: " + none_near +
                      "; not asked: whether a first frame intersects itself, and what lines above leave out\n") !=
        std::string::npos);
}

TEST_CASE("motions: the report names the vertices of groups, and counts pairs that are near along no edges") {
  const std::string frame = "frame\n0 0 0\n1 0 0\n2 0 0\n9 0 0\n19 0 0\n29 0 0\n";
  const auto report = [&](const std::string& lines) {
    return check_texts(proofs_of("step 0\n", "0 0"),
                       {kFirst + "vertices 6\npoint 3\npoint 4\npoint 5\nedge 0 1\nedge 1 2\n" + lines + frame + frame})
        .text;
  };
  const auto says = [&](const std::string& lines, const std::string& words) {
    const std::string text = report(lines);
    CAPTURE(lines, words, text);
    CHECK(text.find("2 edges, 0 faces" + words + "; no two elements that are ") != std::string::npos);
  };
  const std::string corners = ", 3 corners are no points";
  says("", corners);
  says("group 0 7\ngroup 4 7\ngroup 5 7\ngroup 1 9\ngroup 2 8\nignore 8 7\nignore 5 5\n",
       ", 3 groups of vertices, 2 pairs of groups not asked about: 5-5 7-8, where 5 has no vertex, "
       "7 has vertex 0 and vertices 4 to 5, 8 has vertex 2" +
           corners);
  says("touching edge-edge 0 1\n", ", 1 pair asked about touching alone" + corners);
  says("touching edge-edge 0 1\ntouching point-edge 0 1\ntouching point-point 0 1\n",
       ", 3 pairs asked about touching alone, 2 of them joined by no edges" + corners);
  says("touching vertex-face 0 7\n", ", 1 pair asked about touching alone, 1 of them joined by no edges" + corners);
}

TEST_CASE("motions: proofs of nothing are refused") {
  const std::string frames = "frame\n0 0 0\n9 0 0\nframe\n0 0 0\n9 0 0\n";
  const auto bad = [&](const std::string& elements) {
    call_bad("there is nothing to check: 2 frames, 2 vertices, ", kFirst + "vertices 2\n" + elements + frames);
  };
  bad("");  // positions alone
  call_bad("0 faces, 2 vertices are in no element, but no two", kFirst + "vertices 2\n" + frames);
  call_bad("0 faces, 1 vertex is in no element, but no two", kFirst + "vertices 2\npoint 0\n" + frames);
  bad("point 0\n");
  bad("edge 0 1\npoint 0\n");
  bad("edge 0 1\nedge 1 0\n");
  bad("point 0\npoint 1\nfixed 0\nfixed 1\n");
  accept(kFirst + "vertices 2\npoint 0\npoint 1\n" + frames, "step 0\n", "0 0");
  accept(kFirst + "vertices 2\npoint 0\npoint 1\nfixed 0\n" + frames, "step 0\n", "0 0");
  // Many fixed elements in one place, or on one body, are no work.
  std::string crowd = kFirst + "vertices 20000\npoint 19999\n", rows;
  for (int v = 0; v < 19999; ++v) crowd += "point " + std::to_string(v) + "\nfixed " + std::to_string(v) + "\n";
  for (int v = 0; v < 19999; ++v) rows += "0 0 0\n";
  accept(crowd + "frame\n" + rows + "1 0 0\nframe\n" + rows + "2 0 0\n", "step 0\n", "0 0");
  std::string head = kFirst + "vertices 20000\n";
  for (int v = 0; v < 20000; v += 2) {
    head += "edge " + std::to_string(v) + " " + std::to_string(v + 1) + "\n";
    for (const int w : {v, v + 1}) head += "body " + std::to_string(w) + " 0 " + std::to_string(w) + " 0 0\n";
  }
  call_bad(
      "10000 edges, 0 faces, 20000 vertices on 1 body, where 0 has vertices 0 to 19999, 20000 corners are no points, "
      "but",
      head + "frame\n1 0 0 0 0 0 0\nframe\n1 0 0 0 0 0 1\n");
}

TEST_CASE("motions: files with an error") {
  const std::string head = kFirst + "vertices 2\n", frame = "frame\n0 0 0\n1 0 0\n";
  const std::string points = "point 0\npoint 1\n";
  accept(head + points + frame + frame, "step 0\n", "0 0");
  accept("# x\r\n" + head + "\n" + points + frame + " # y\r\n" + frame + "\n", "step 0\n", "0 0");
  call_bad("nothing to check", kFirst + "vertices 0\nframe\nframe");
  call_bad("touchstone-motion 1", "");
  call_bad("touchstone-motion 1", "touchstone-motion 2\nvertices 2\n" + frame + frame);
  call_bad("vertices N", kFirst);
  call_bad("vertices N", kFirst + frame + frame);
  for (const char* const count : {"-1", "02", "two", "1073741824", "99999999999999999999", "2 2", "0x1p1", ""}) {
    call_bad("vertices N", kFirst + "vertices " + count + "\n" + frame + frame);
  }
  for (const char* const vertex : {"2", "-1", "00", "x", "1073741824"}) {
    call_bad("is no vertex", head + "point " + vertex + "\n" + frame + frame);
    call_bad("is no vertex", head + "edge 0 " + vertex + "\n" + frame + frame);
    call_bad("is no vertex", head + "fixed " + vertex + "\n" + frame + frame);
  }
  for (const char* const line :
       {"point", "point 0 1", "edge 0", "edge 0 1 0", "face 0 1", "fixed", "fixed 0 1", "ring 0"}) {
    call_bad("here must be ", head + line + "\n" + frame + frame);
  }
  call_bad("twice", head + "edge 1 1\n" + frame + frame);
  call_bad("twice", kFirst + "vertices 3\nface 0 1 0\n" + frame + frame);
  call_bad("such a line already", head + "point 0\npoint 1\npoint 0\n" + frame + frame);
  call_bad("such a line already", head + "fixed 0\nfixed 0\n" + frame + frame);
  call_bad("has moved", head + "fixed 1\n" + frame + "frame\n0 0 0\n1 0 1\n");
  call_bad("has moved", head + "fixed 0\n" + frame + "frame\n0x1p-19000 0 0\n1 0 1\n");
  call_bad("at least two frames", head + frame);
  call_bad("frame 0", head);
  call_bad("vertex 1 in frame 1", head + frame + "frame\n0 0 0\n");
  call_bad("vertex 0 in frame 1", head + frame + "frame\n0 0\n1 0 0\n");
  call_bad("vertex 1 in frame 0", head + "frame\n0 0 0\n1 0 0 0\n" + frame);
  call_bad("\"frame\"", head + frame + frame + "0 0 0\n");
  call_bad("\"frame\"", head + frame + "point 0\n" + frame);
  call_bad("\"frame\"", head + "frame 0\n0 0 0\n1 0 0\n" + frame);
  call_bad("is no number", head + "frame\n0 0 0.5\n1 0 0\n" + frame);
  // A short line asks for no memory: neither a count nor the greatest vertex.
  call_bad("frame 0", kFirst + "vertices 1073741823\n");
  call_bad("vertex 1 in frame 0", kFirst + "vertices 1073741823\npoint 1073741822\nfixed 1073741822\nframe\n0 0 0\n");
}
