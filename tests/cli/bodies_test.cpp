// touchstone bodies: first contacts of bodies that turn between recorded poses, and what its verdict leaves out.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/body_runs.hpp"

using namespace touchstone;
using namespace touchstone::tests;

TEST_CASE("bodies: a bar that turns a quarter meets a wall where its corner does") {
  const BarAndWall scene;
  const Run free = scene.run(BarAndWall::quarter_turn("1.6875"));  // 1.4375 > sqrt(2)
  CHECK(free.status == 0);
  CHECK(free.out ==
        "1 step, free of contact (2 bodies: 16 vertices, 36 edges, 24 faces); elements of one body were never "
        "compared; the start was asked about intersections, too\n");
  const Run hit = scene.run(BarAndWall::quarter_turn("1.625"), {"--threads", "2"});  // 1.375 < sqrt(2)
  CHECK(hit.status == 1);
  CHECK(hit.out.starts_with("1 step: 0 free, 1 not free; the first at time 0.7"));
  CHECK(occurrences(hit.out, "\n0 -> 2: first contact at t in [") == 1);
  CHECK(occurrences(hit.out, " of bar and ") > 0);

  const Run json = scene.run(BarAndWall::quarter_turn("1.625"), {"--json"});
  CHECK(json.status == 1);
  CHECK(json.err.starts_with("1 step: 0 free, 1 not free"));
  const auto step = nlohmann::json::parse(json.out);
  // The corner is at 1.375 from the axis where the body has turned by 45 degrees minus acos(1.375 / sqrt(2)).
  const double s = std::sqrt(0.5);
  const double q = std::tan((std::acos(-1.0) / 4 - std::acos(1.375 / std::sqrt(2.0))) / 2);
  CHECK(double(step["toi"]) == Approx(q / (s + q - q * s)).epsilon(1e-12));
  CHECK(double(step["time"]) == Approx(2 * double(step["toi"])));
  CHECK(step["start_asked"] == true);
  CHECK(step["first"][0]["first"]["part"] == "bar");
  CHECK(step["first"][0]["second"]["part"] == "wall");
  CHECK(step["first"][0]["weights_a"].size() == 3);

  const Run near = scene.run(BarAndWall::quarter_turn("1.6875"), {"--separation", "0.0625"});
  CHECK(near.status == 1);
  CHECK(occurrences(near.out, "separation 0x1p-4 (0.0625), euclidean)") == 1);
}

TEST_CASE("bodies: a pose of the other sign turns the shorter way, unless the signs are to be taken as they are") {
  const BarAndWall scene;
  const std::string poses = std::string(kHeader) +
                            "0,bar,0,0,0,1,0,0,0\n1,bar,0,0,0,-0.998750260394966,0,0,-0.049979169270678\n"
                            "0,wall,1.625,0,0,1,0,0,0\n1,wall,1.625,0,0,1,0,0,0\n";
  const Run shorter = scene.run(poses);
  CHECK(shorter.status == 0);
  CHECK(occurrences(first_line(shorter.out),
                    "; 1 of 2 turns goes the longer way by the signs of the quaternions (q0 . "
                    "q1 < 0) and was taken the shorter way") == 1);
  const Run given = scene.run(poses, {"--as-given"});
  CHECK(given.status == 1);
  CHECK(occurrences(first_line(given.out), "may be meant the shorter way") == 1);
  // Of two turns by 180 degrees neither is shorter.
  const Run half = scene.run(std::string(kHeader) + "0,bar,0,0,0,1,0,0,0\n1,bar,0,0,0,0,0,0,-1\n");
  CHECK(occurrences(first_line(half.out),
                    "; 1 of 1 turns has 180 degrees, one way or the other by the signs of the quaternions") == 1);
  // A whole turn goes through a quaternion that is zero.
  const Run whole = scene.run(std::string(kHeader) + "0,bar,0,0,0,1,0,0,0\n1,bar,0,0,0,-1,0,0,0\n", {"--as-given"});
  check_refused(whole, "poses.csv: 0 -> 1: by the signs of its quaternions body 'bar' makes a whole turn");
}

TEST_CASE("bodies: a turn as slerp has it is free, meets in a range of times, or is left open") {
  const BarAndWall scene;
  // 160 degrees about z from time 0 to 8; the wall is where the first corner, sqrt(2) away, is after 30 of its 45.
  const double turn = std::acos(-1.0) * 160 / 180, at = std::sqrt(2.0) * std::cos(std::acos(-1.0) / 12);
  const auto poses = [&](double x) {
    const std::string end = std::to_string(std::cos(turn / 2)) + ",0,0," + std::to_string(std::sin(turn / 2));
    const std::string wall = ",wall," + std::to_string(x) + ",0,0,1,0,0,0\n";
    return std::string(kHeader) + "0,bar,0,0,0,1,0,0,0\n8,bar,0,0,0," + end + "\n0" + wall + "8" + wall;
  };
  const Run hit = scene.run(poses(at + 0.25), {"--slerp", "--json", "--threads", "2"});
  CHECK(hit.status == 1);
  CHECK(hit.err.starts_with("1 step: 0 free, 1 not free; none before time 1.4"));
  CHECK(occurrences(hit.err, "; turns were read as slerp has them, at a constant rate; ") == 1);
  const auto step = nlohmann::json::parse(hit.out);
  CHECK(step["verdict"] == "contact");
  const double time = 30.0 / 160;  // the rational arc is there at 0.205
  CHECK(double(step["free_until"]) == Approx(time).margin(1e-4));
  CHECK(double(step["contact_by"]) == Approx(time).margin(1e-4));
  CHECK(double(step["free_until"]) < double(step["contact_by"]));
  CHECK(step["pairs"][0]["verdict"] == "contact");
  CHECK(step["pairs"][0]["first"]["part"] == "bar");
  CHECK(step["pairs"][0]["deviation"] > 0);
  CHECK(step["intersections"].empty());
  const std::string lines = scene.run(poses(at + 0.25), {"--slerp"}).out;
  CHECK(occurrences(lines, "\n0 -> 8: a contact in t from 0.187") == 1);
  CHECK(occurrences(lines, " of wall: contact, t from 0.187") > 0);

  CHECK(scene.run(poses(1.75), {"--slerp"}).out.starts_with("1 step, free of contact (2 bodies: "));
  // A corner comes within 1e-9 of the wall: closer than few arcs tell.
  const std::string near = std::string(kHeader) + "0,bar,0,0,0,1,0,0,0\n1,bar,0,0,0," + kTurned +
                           "\n0,wall,1.6642135633730951,0,0,1,0,0,0\n1,wall,1.6642135633730951,0,0,1,0,0,0\n";
  const Run open = scene.run(near, {"--slerp", "--arcs", "64", "--clearance"});
  CHECK(open.status == 1);
  CHECK(open.out.starts_with("1 step: 0 free, 0 not free, 1 open; none before time 0.4"));
  CHECK(occurrences(open.out, "\n0 -> 1: open: free up to t = 0.4") == 1);
  CHECK(occurrences(open.out, " of wall: open from t = 0.4") > 0);
  CHECK(occurrences(open.out, "; least distance 0.") == 1);
  CHECK(scene.run(near, {"--slerp", "--arcs", "65536"}).status == 0);

  const Run inside = scene.run(BarAndWall::quarter_turn("0"), {"--slerp"});
  CHECK(inside.status == 1);
  CHECK(occurrences(inside.out, "at the start ") == 1);
  CHECK(scene.run(BarAndWall::quarter_turn("0"), {"--slerp", "--json"}).out.find("\"intersections\":[{") !=
        std::string::npos);
  check_refused(scene.run(near, {"--slerp", "--prove", scene.folder.path("proved")}), "--slerp excludes --prove");
  check_refused(scene.run(near, {"--slerp", "--html", scene.folder.path("page.html")}), "--slerp excludes --html");
  check_refused(scene.run(near, {"--slerp", "--free-step", scene.folder.path("free.csv")}),
                "--slerp excludes --free-step");
  check_refused(scene.run(near, {"--slerp", "--arcs", "100"}), "100 must be a power of two");
  check_refused(scene.run(near, {"--slerp", "--arcs", "4"}), "4 must be a whole number from 64 to 1048576");
  check_refused(scene.run(near, {"--arcs", "64"}), "--arcs requires --slerp");
}

TEST_CASE("bodies: intersections at the start are asked, or the verdict says that they were not") {
  const BarAndWall scene;
  const std::string poses = BarAndWall::quarter_turn("0");  // the wall goes through the bar
  const Run run = scene.run(poses);
  CHECK(run.status == 1);
  CHECK(occurrences(run.out, "0 -> 2: at the start ") + occurrences(run.out, "  at the start ") == 1);
  CHECK(occurrences(run.out, " pierces face ") > 0);

  const TemporaryFolder folder;
  const std::string small = folder.write("small.obj", box_obj(1, 1, 1)),
                    big = folder.write("big.obj", box_obj(9, 9, 9));
  const std::string still =
      folder.write("still.csv", std::string(kHeader) + "0,small,0,0,0,1,0,0,0\n1,small,1,0,0,1,0,0,0\n");
  const Run inside = run_program({"bodies", small, big, "--poses", still});
  CHECK(inside.status == 1);
  CHECK(occurrences(inside.out, " of small is inside the closed surface of face ") == 1);
  CHECK(occurrences(first_line(inside.out), "; 1 of 2 bodies is at rest: no pose names it") == 1);
  const Run unasked = run_program({"bodies", small, big, "--poses", still, "--no-start"});
  CHECK(unasked.status == 0);
  CHECK(occurrences(unasked.out, "; whether bodies intersect at the start was not asked") == 1);
}

TEST_CASE("bodies: pairs are left out by name, and the verdict says which") {
  const BarAndWall scene;
  const std::string floor = scene.folder.write("floor.obj", "v -9 -9 -4\nv 9 -9 -4\nv 0 9 -4\nf 1 2 3\n");
  const std::string poses = BarAndWall::quarter_turn("1.625");
  const Run run = scene.run(poses, {floor, "--ignore", "b*,wall", "--ignore", "floor,wall"});
  CHECK(run.status == 0);
  CHECK(occurrences(run.out,
                    "; 2 of 3 pairs of bodies were left out; these bodies were not asked about: bar and wall, "
                    "wall and floor") == 1);
  CHECK(scene.run(poses, {floor, "--only-between", "bar,floor"}).status == 0);
  CHECK(scene.run(poses, {floor, "--only-between", "bar,wall"}).status == 1);
  check_refused(
      scene.run(poses, {"--ignore", "bar,wal"}),
      "--ignore: 'bar,wal' names no two bodies: it must be two names of bodies, such as A,B, or patterns; the "
      "bodies are bar, wall");
  check_refused(scene.run(poses, {"--ignore", "bar,wall"}), "leave no pair of bodies to ask about");
}

TEST_CASE("bodies: a free step ends at poses that were proved free") {
  const BarAndWall scene;
  const std::string table = scene.folder.path("free.csv");
  CHECK(scene.run(BarAndWall::quarter_turn("1.625"), {"--free-step", table}).status == 1);
  const auto lines = lines_of(scene.folder.read("free.csv"));
  REQUIRE(lines.size() == 3);
  CHECK(lines[1].starts_with("0,2,shortened,0.3"));
  CHECK(lines[2].starts_with("0,2,shortened,0.3"));
  // The poses are read again under another time, and the step to them is free.
  std::string again = "time,body,x,y,z,qw,qx,qy,qz\n0,bar,0,0,0,1,0,0,0\n0,wall,1.625,0,0,1,0,0,0\n";
  for (const std::size_t i : {1, 2}) {
    again += "1" + lines[i].substr(lines[i].find(i == 1 ? ",bar," : ",wall,")) + "\n";
  }
  CHECK(scene.run(again).status == 0);
  check_refused(scene.run(BarAndWall::quarter_turn("1.625"), {"--free-step", scene.bar}), "what is written is CSV");
  check_refused(scene.run(BarAndWall::quarter_turn("1.625"), {"--free-step", scene.folder.path("poses.csv")}),
                "is also an input");
  CHECK(scene.folder.read("bar.obj") == box_obj(1, 1, 3));
}

TEST_CASE("bodies: columns are read by their names, in any order") {
  const BarAndWall scene;
  const std::string free = scene.run(BarAndWall::quarter_turn("1.6875")).out;
  const auto same = [&](const std::string& header, const std::array<int, 9>& order,
                        const std::vector<std::string>& more = {}) {
    const std::array<std::array<std::string, 9>, 4> rows = {
        {{"0", "bar", "0", "0", "0", "1", "0", "0", "0"},
         {"2e0", "bar", "0", "0", "0", "0.70710678118654757", "0", "0", "0.70710678118654757"},
         {"-0", "wall", "1.6875", "0", "0", "1", "0", "0", "0"},
         {"2", "\"wall\"", "1.6875", "0", "0", "1", "0", "0", "0"}}};
    std::string text = header;
    for (const auto& row : rows) {
      for (std::size_t i = 0; i < 9; ++i) text += (i == 0 ? "" : ", ") + row[static_cast<std::size_t>(order[i])];
      text += "\r\n";
    }
    CAPTURE(header);
    const Run run = scene.run(text, more);
    CHECK(run.err == "");
    CHECK(run.out == free);
  };
  same("Time,Body,tx,ty,tz,qx,qy,qz,qw\n", {0, 1, 2, 3, 4, 6, 7, 8, 5});
  same("qw,qx,qy,qz,px,py,pz,name,timestamp\n", {5, 6, 7, 8, 2, 3, 4, 1, 0});
  same("t,body,px,py,pz,w,x,y,z\n", {0, 1, 2, 3, 4, 5, 6, 7, 8});
  same(
      "time,body,pose.position.x,pose.position.y,pose.position.z,pose.orientation.x,pose.orientation.y,"
      "pose.orientation.z,pose.orientation.w\n",
      {0, 1, 2, 3, 4, 6, 7, 8, 5});
  same("", {0, 1, 2, 3, 4, 5, 6, 7, 8}, {"--quaternion", "wxyz"});
  same("", {0, 1, 2, 3, 4, 6, 7, 8, 5}, {"--quaternion", "xyzw"});
}

TEST_CASE("bodies: a table of poses that is wrong is refused by its row") {
  const BarAndWall scene;
  const auto refused = [&](const std::string& poses, const std::string& reason,
                           const std::vector<std::string>& more = {}) {
    check_refused(scene.run(poses, more), "poses.csv:" + reason);
  };
  const std::string header = kHeader, start = "0,bar,0,0,0,1,0,0,0\n", end = "1,bar,0,0,0,1,0,0,0\n";
  refused("", " is empty");
  refused(header, " has poses at 0 times; a step needs two");
  refused(header + start, " has poses at 1 time; a step needs two");
  refused(header + "0,bar,0,nan,0,1,0,0,0\n", "2: y is 'nan'; it must be a finite number");
  refused(header + "0,bar,0,0,0,1,0,-inf,0\n", "2: qy is '-inf'");
  refused(header + "1e999,bar,0,0,0,1,0,0,0\n", "2: time is '1e999'");
  refused(header + start + "1,bar,0,0,0,0,0,-0,0\n", "3: the quaternion is zero");
  refused(header + start + "1,bar,0,0,0,1,0,0\n", "3: 8 columns where the first line has 9");
  refused(header + start + end + "0.5,bar,0,0,0,1,0,0,0\n",
          "4: time 0.5 of body 'bar' comes after its time 1 in row 3");
  refused(header + start + "0.0,bar,0,0,0,1,0,0,0\n", "3: body 'bar' is at time 0 twice, here and in row 2");
  refused(header + "1700000000000000001,bar,0,0,0,1,0,0,0\n1700000000000000002,bar,0,0,0,1,0,0,0\n",
          "3: body 'bar' is at time 1.7e+18 twice, here and in row 2; it has one pose at each time, and times are "
          "doubles, which are 256 apart there");
  refused(header + start + "1,bat,0,0,0,1,0,0,0\n", "3: no file is the body 'bat'; did you mean bar?");
  refused(header + start + "1,zeppelin,0,0,0,1,0,0,0\n", "3: no file is the body 'zeppelin'; the bodies are bar, wall");
  refused(header + start + end + "1,wall,3,0,0,1,0,0,0\n", " body 'wall' has no pose at time 0, which other bodies");
  refused(header + start + end + "0,wall,3,0,0,1,0,0,0\n", " body 'wall' has no pose at time 1, which other bodies");
  refused("time,body,x,y,z,q0,q1,q2,q3\n" + start + end, "1: no column is qw");
  refused("time,frame_id,x,y,z,qw,qx,qy,qz\n",
          "1: no column is body: the first line names the columns with commas "
          "between them, in any order, such as time,body,x,y,z,qw,qx,qy,qz; names of body are body, name, object, "
          "link, id");
  refused(
      "frame,body,x,y,z,qw,qx,qy,qz\n",
      "1: no column is time: the first line names the columns with commas "
      "between them, in any order, such as time,body,x,y,z,qw,qx,qy,qz; names of time are time, t, timestamp, stamp");
  refused("time,body,x,y,z,qw,qx,qy\n", "1: no column is qz");
  refused("time,body,x,y,z,qw,qx,qy,qz,q_z\n", "1: the columns 'qz' and 'q_z' both say qz");
  refused("time;body;x;y;z;qw;qx;qy;qz\n", " has poses at 0 times");
  refused("time|body|x|y|z|qw|qx|qy|qz\n", "1: no column is time");
  refused(start + end, "1: the first line names no columns, so the order of the quaternion is not known");
  refused("0,bar,0,0,0,1,0,0\n", "1: 8 columns; where no first line names the columns", {"--quaternion", "wxyz"});
  refused(header + start + end, "1: this line names the columns, and --quaternion is", {"--quaternion", "wxyz"});
  refused(header + std::string("0,bar,0,0,0,1,0,0,\0\n", 19), "2: a zero byte");
  refused(header + "0,\"bar,0,0,0,1,0,0,0\n", "2: the file ends inside quotes");

  // Two bodies at times that are one double.
  const std::string far = "1700000000000000";
  const Run merged = scene.run(header + far + "001,bar,-9,0,0,1,0,0,0\n" + far + "002,wall,9,0,0,1,0,0,0\n" + far +
                               "901,bar,-9,0,0,1,0,0,0\n" + far + "902,wall,9,0,0,1,0,0,0\n");
  CHECK(occurrences(merged.out, "; times are doubles, which are 256 apart there") == 1);
  const Run more = scene.run("time,body,x,y,z,qw,qx,qy,qz,vx,vy\n0,bar,-9,0,0,2,0,0,0,7,7\n1,bar,-9,0,0,1,0,0,0,a,\n");
  CHECK(more.status == 0);
  CHECK(occurrences(more.out, "times are doubles") == 0);
  CHECK(occurrences(more.out, "; 1 quaternion has a length that is not 1, the first in row 2") == 1);
  CHECK(occurrences(more.out, "; 2 columns of the poses were not read: 'vx', 'vy'") == 1);
}

TEST_CASE("bodies: files that are no two bodies are refused") {
  const BarAndWall scene;
  const std::string poses = scene.folder.write("p.csv", BarAndWall::quarter_turn("9"));
  const auto run = [&](const std::vector<std::string>& files) {
    return run_program(with({"bodies", "--poses", poses}, files));
  };
  check_refused(run({scene.bar}), "there is only 1 body");
  check_refused(run({scene.bar, scene.bar}), "is given twice; two bodies of one file have names");
  check_refused(run({"left=", scene.wall}), "has no file behind the =");
  check_refused(run({"=" + scene.bar, scene.wall}), "has no name before the =");
  check_refused(run({"bar=" + scene.bar, scene.bar}), "two bodies are named 'bar'");
  check_refused(run({"bar=" + scene.folder.path("*.obj"), scene.wall}), " names 2 files");
  check_refused(run({scene.bar, scene.folder.write("bad.obj", "v 0 0 0\nf 1 2 3\n")}), "bad.obj");
  check_refused(run({scene.bar, scene.folder.path("none.obj")}), "none.obj");
  check_refused(run_program({"bodies", scene.bar, scene.wall}), "--poses is required");
  check_refused(run_program({"bodies", scene.bar, scene.wall, "--poses", scene.folder.path("none.csv")}), "none.csv");

  // Two files of one name are named by their paths.
  const TemporaryFolder other;
  const std::string second = other.write("bar.obj", box_obj(1, 1, 1));
  check_refused(run({scene.bar, second, scene.wall}), "p.csv:2: no file is the body 'bar'; the bodies are ");
  const std::string both =
      scene.folder.write("both.csv", kHeader + ("0," + second) + ",9,0,0,1,0,0,0\n1," + second + ",0,0,0,1,0,0,0\n");
  const Run paths = run_program({"bodies", scene.bar, second, "--poses", both});
  CHECK(paths.status == 1);
  CHECK(occurrences(paths.out, " of " + second) > 0);

  // Two bodies of one file.
  const std::string twins =
      scene.folder.write("twins.csv", std::string(kHeader) + "0,left,0,0,0,1,0,0,0\n1,left,4,0,0,1,0,0,0\n" +
                                          "0,right,3,0,0,1,0,0,0\n1,right,3,0,0,1,0,0,0\n");
  const Run pair = run_program({"bodies", "left=" + scene.bar, "right=" + scene.bar, "--poses", twins});
  CHECK(pair.status == 1);
  CHECK(occurrences(pair.out, "first contact at t = 0x1p-2 (0.25)") == 1);
  CHECK(occurrences(pair.out, " of right") > 0);

  // Repairs as those of mesh.
  const std::string broken = scene.folder.write("wall2.obj", box_obj(0.25, 8, 8) + "f 1 3 4\n");
  check_refused(run_program({"bodies", scene.bar, broken, "--poses", poses}), "wall2.obj");
  const std::string rest =
      scene.folder.write("rest.csv", std::string(kHeader) + "0,bar,9,0,0,1,0,0,0\n1,bar,8,0,0,1,0,0,0\n");
  const Run mended = run_program({"bodies", scene.bar, broken, "--poses", rest, "--drop-degenerate"});
  CHECK(mended.status == 0);
  CHECK(occurrences(mended.out, "; 1 element of the file was left out") == 1);
}

TEST_CASE("bodies: a recording of a hundred thousand rows is read and asked at once") {
  const BarAndWall scene;
  std::string poses = kHeader;
  for (int i = 0; i < 50'000; ++i) {
    const std::string time = std::to_string(i);
    poses += time + ",wall,9,0,0,1,0,0,0\n" + time + ",bar,0,0," + std::to_string(i % 2) + ",1,0,0,0\n";
  }
  const Run run = scene.run(poses);
  CHECK(run.status == 0);
  CHECK(run.out.starts_with("49,999 steps, all free of contact"));
  const Run stopped =
      run_program({"bodies", scene.bar, scene.wall, "--poses", scene.folder.path("poses.csv"), "--json"},
                  {.standard_output = "/dev/null", .interrupt_after = 0.05});
  CHECK((stopped.status == 130 || stopped.status == 0));
}

TEST_CASE("bodies: steps after one that is not free are asked whether they start so") {
  const BarAndWall scene;
  const Run run = scene.run(std::string(kHeader) +
                            "0,bar,0,0,0,1,0,0,0\n0,wall,3,0,0,1,0,0,0\n1,bar,3,0,0,1,0,0,0\n1,wall,3,0,0,1,0,0,0\n"
                            "2,bar,3,0,0.125,1,0,0,0\n2,wall,3,0,0,1,0,0,0\n");
  CHECK(run.status == 1);
  CHECK(run.out.starts_with("2 steps: 0 free, 2 not free; the first at time "));
  CHECK(occurrences(run.out, "1 -> 2: ") == 1);
  CHECK(occurrences(run.out, "at the start") > 0);
}
