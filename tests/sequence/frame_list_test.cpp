// Which files are the frames of a sequence, and in which order.
// SPDX-License-Identifier: MIT
#include "sequence/frame_list.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <touchstone/error.hpp>

#include "io/temporary_folder.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::sequence;
using Catch::Contains;
using touchstone::tests::TemporaryFolder;

namespace {

using NameList = std::vector<std::string>;

std::string refusal_of(const NameList& files, Gaps gaps = Gaps::refused, const std::string& advice = "Ask.") {
  try {
    static_cast<void>(in_order(files, gaps, advice));
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("files are in the order of the number in which their names differ") {
  CHECK(in_order({"a/c-10.obj", "a/c-8.obj", "a/c-9.obj"}, Gaps::refused) ==
        NameList{"a/c-8.obj", "a/c-9.obj", "a/c-10.obj"});
  CHECK(in_order({"run2/c-03.obj", "run2/c-01.obj", "run2/c-02.obj"}, Gaps::refused) ==
        NameList{"run2/c-01.obj", "run2/c-02.obj", "run2/c-03.obj"});
  CHECK(in_order({"30", "10", "20"}, Gaps::refused) == NameList{"10", "20", "30"});
  CHECK(in_order({"x009.5.ply", "x010.5.ply", "x008.5.ply"}, Gaps::refused) ==
        NameList{"x008.5.ply", "x009.5.ply", "x010.5.ply"});
  // Any two numbers have a stride.
  CHECK(in_order({"f7", "f3"}, Gaps::refused) == NameList{"f3", "f7"});
}

TEST_CASE("names that differ in several numbers are in the order of the one that is a frame's own") {
  CHECK(in_order({"f-10-t0.10", "f-1-t0.1", "f-2-t0.2"}, Gaps::allowed) ==
        NameList{"f-1-t0.1", "f-2-t0.2", "f-10-t0.10"});
  const NameList times = {"t0.9-f9", "t1.0-f10", "t1.1-f11", "t1.2-f12"};
  for (const NameList& names :
       {NameList{times[1], times[2], times[3], times[0]}, NameList{times.rbegin(), times.rend()}}) {
    CHECK(in_order(names, Gaps::refused) == times);
  }
  // The stride of one of the numbers is enough.
  CHECK(in_order({"t013-f3", "t007-f2", "t004-f1"}, Gaps::refused) == NameList{"t004-f1", "t007-f2", "t013-f3"});
  CHECK(refusal_of({"f-1-t0.1", "f-2-t0.2", "f-4-t0.4"}).find("frame 3 is missing between f-2-t0.2") !=
        std::string::npos);
}

TEST_CASE("files of other names are frames or parts, and nothing is guessed") {
  for (const Gaps gaps : {Gaps::refused, Gaps::allowed}) {
    CHECK(refusal_of({"d/gear.obj", "d/shaft.obj"}, gaps) ==
          "d/shaft.obj: the name differs from gear.obj in more than numbers. Ask.");
    CHECK(refusal_of({"f1.obj", "f2.obj", "g3.obj"}, gaps) ==
          "g3.obj: the name differs from f1.obj in more than numbers. Ask.");
    for (const NameList& names : {NameList{"one.obj", "one.obj"}, NameList{"c-1.obj", "c-2.obj", "c-1.obj"}}) {
      CHECK(refusal_of(names, gaps) == names[0] + ": is given twice; its frames would count twice: name it once");
    }
    for (const NameList& names :
         {NameList{"b2.obj", "a1.obj"}, NameList{"x1.obj", "x1.ply"}, NameList{"c2", "c1", "c"}}) {
      CHECK(refusal_of(names, gaps).find("in more than numbers") != std::string::npos);
    }
    // No number is a frame's own, or two of them give different orders.
    for (const NameList& names : {NameList{"take2-f1", "take1-f2", "take1-f1"}, NameList{"b2-1", "b1-2", "b3-3"}}) {
      CHECK(refusal_of(names, gaps) == names[1] + ": the name differs from " + names[0] +
                                           " in several numbers, which do not say the order of the frames. Ask.");
    }
    // More digits than a number has are text.
    CHECK_FALSE(refusal_of({"f12345678901234567892", "f12345678901234567891"}, gaps).empty());
  }
  CHECK(in_order({"gear.obj"}, Gaps::refused) == NameList{"gear.obj"});
}

TEST_CASE("files can be taken as given, the files of one pattern have the order of their numbers") {
  const TemporaryFolder folder;
  for (const char* name : {"f-1.obj", "f-2.obj", "f-10.obj", "f-40.obj", "gear.obj", "shaft.obj"}) {
    folder.write(name, "");
  }
  const std::string two = folder.path("f-2.obj"), ten = folder.path("f-10.obj"), gear = folder.path("gear.obj");
  CHECK(as_given({ten, gear, two, two}) == NameList{ten, gear, two, two});
  CHECK(as_given({gear, folder.path("f-*.obj"), two}) ==
        NameList{gear, folder.path("f-1.obj"), two, ten, folder.path("f-40.obj"), two});
  CHECK(as_given({folder.path("[gs]*.obj")}) == NameList{gear, folder.path("shaft.obj")});
  CHECK_THROWS_AS(as_given({folder.path("g-*.obj")}), FileError);
}

TEST_CASE("a number that is missing or there twice is named") {
  CHECK(refusal_of({"d/cloth-8.obj", "d/cloth-5.obj", "d/cloth-6.obj"}) ==
        "d/cloth-8.obj: frame 7 is missing between cloth-6.obj and cloth-8.obj; other frames of the sequence are 1 "
        "apart. Ask.");
  CHECK(refusal_of({"c-0", "c-10", "c-20", "c-40", "c-50"}).find("frame 30 is missing between c-20 and c-40") !=
        std::string::npos);
  CHECK(refusal_of({"c-0", "c-3", "c-5"}).find("frame 2 is missing between c-0 and c-3") != std::string::npos);
  CHECK(refusal_of({"c-1.obj", "c-01.obj"}) ==
        "c-01.obj: has the same number as c-1.obj, and a sequence has each number once. Ask.");
  CHECK(refusal_of({"c-1", "c-2", "c-4"}, Gaps::refused, "").ends_with("are 1 apart"));
  CHECK(refusal_of({"c-1", "c-2", "c-4"}, Gaps::allowed).empty());
  CHECK(refusal_of({"c-1\n2", "c-1\n4", "c-1\n5"}).find('\n') == std::string::npos);
}

TEST_CASE("a pattern is expanded, unless it is the name of a file") {
  const TemporaryFolder folder;
  for (const char* name : {"f-1.obj", "f-2.obj", "f-10.obj", "[x].obj"}) folder.write(name, "");
  auto files = expand_patterns({folder.path("f-*.obj")});
  std::sort(files.begin(), files.end());
  CHECK(files == NameList{folder.path("f-1.obj"), folder.path("f-10.obj"), folder.path("f-2.obj")});
  CHECK(expand_patterns({folder.path("f-?.obj")}).size() == 2);
  CHECK(expand_patterns({folder.path("[x].obj")}) == NameList{folder.path("[x].obj")});
  CHECK(expand_patterns({"none.obj", "-"}) == NameList{"none.obj", "-"});
  CHECK_THROWS_AS(expand_patterns({"no such file"}), FileError);
  CHECK_THROWS_AS(expand_patterns({folder.path("g-*.obj")}), FileError);
}

TEST_CASE("a folder stands for the mesh files in it, which are of one format") {
  const TemporaryFolder folder;
  for (const char* name :
       {"r [1]/f-1.obj", "r [1]/f-2.obj", "r [1]/notes.txt", "r [1]/.hidden.obj", "r [1]/f-3.obj/x"}) {
    folder.write(name, "");
  }
  const std::string run = folder.path("r [1]");
  CHECK(expand_patterns({run}) == NameList{run + "/f-1.obj", run + "/f-2.obj"});
  CHECK(expand_patterns({run + "/"}) == NameList{run + "/f-1.obj", run + "/f-2.obj"});
  folder.write("r [1]/a.PLY", "");
  CHECK_THROWS_WITH(expand_patterns({run}),
                    Contains("files of several formats (2 .obj, 1 .ply); name those of one, such as "));
  folder.write("mixed/a.obj", "");
  folder.write("mixed/b.FBX", "");
  CHECK_THROWS_WITH(expand_patterns({folder.path("mixed")}), Contains("b.FBX, a format that is not read"));
  folder.write("models/a.step", "");
  CHECK_THROWS_WITH(expand_patterns({folder.path("models")}), Contains("a.step: is a file of curved surfaces"));
  for (const std::string ending : {"obj", "ply", "stl", "vtk", "vtu", "vtp", "off", "msh", "gltf", "glb", "npy", "h5",
                                   "hdf5", "pc2", "mdd", "VTU", "Stl"}) {
    folder.write(ending + "/f-1." + ending, "");
    folder.write(ending + "/f-2." + ending, "");
    CHECK(expand_patterns({folder.path(ending)}).size() == 2);
  }
  const std::string one = folder.path("one");
  folder.write("one/f-1.OBJ", "");
  folder.write("one/f-2.obj", "");
  CHECK(expand_patterns({one}) == NameList{one + "/f-1.OBJ", one + "/f-2.obj"});
  CHECK_THROWS_WITH(expand_patterns({folder.path("nothing")}), Contains("nothing: is no file, no folder, and no"));
  folder.write("none/notes.txt", "");
  CHECK_THROWS_WITH(expand_patterns({folder.path("none")}), Contains("is a folder without mesh files"));
}

TEST_CASE("the label of a frame is one line of valid UTF-8") {
  CHECK(FrameName{"a/b/c-1.obj", 0, false}.label() == "c-1.obj");
  CHECK(FrameName{"a/run.npy", 7, true}.label() == "run.npy[7]");
  CHECK(FrameName{"a/b/c-1.obj", 0, false, 1}.label() == "b/c-1.obj");
  CHECK(FrameName{"x/../b/./c-1.obj", 0, false, 1}.label() == "b/c-1.obj");
  CHECK(FrameName{"a/x\ny\x1b[1m.obj", 0, false}.label() == "x\\ny\\x1b[1m.obj");
  CHECK(FrameName{"a/\xff\x41.obj", 0, false}.label() == "\\xff\x41.obj");
}
