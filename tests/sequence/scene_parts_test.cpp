// The parts of a scene: their names, and the labels of its frames.
// SPDX-License-Identifier: MIT
#include "sequence/parts/scene_parts.hpp"

#include <filesystem>

#include "io/temporary_folder.hpp"
#include "sequence/element_names.hpp"
#include "sequence/refusal.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using namespace touchstone::sequence;

namespace {

using Texts = std::vector<std::string>;

/// Empty mesh files: their names and numbers of frames are all that counts.
struct Files {
  TemporaryFolder folder;

  explicit Files(const Texts& names) {
    for (const std::string& name : names) {
      std::filesystem::create_directories(std::filesystem::path(folder.path(name)).parent_path());
      folder.write(name, "");
    }
  }
  std::vector<ScenePart> moving(const Texts& arguments) const {
    Texts paths;
    for (const std::string& argument : arguments) paths.push_back(folder.path(argument));
    return moving_parts(paths, {});
  }
};

Texts names_of(const std::vector<ScenePart>& parts) {
  Texts names;
  for (const ScenePart& part : parts) names.push_back(part.name);
  return names;
}

}  // namespace

TEST_CASE("a part has the name of its file, the text that its files start with, or its folder") {
  const Files files({"plate.obj", "lid-0001.obj", "lid-0002.obj", "arm/1.obj", "arm/2.obj", "g2.off", "g10.off",
                     "wing/a1-2.obj", "wing/a1-3.obj"});
  const auto parts = files.moving({"plate.obj", "lid-*.obj", "arm/", "g*.off", "wing/*.obj"});
  CHECK(names_of(parts) == Texts{"plate", "lid", "arm", "g", "a1"});
  CHECK(names_of(files.moving({"plate.obj", "arm/*.obj"})) == Texts{"plate", "arm"});
  CHECK(names_of(files.moving({"plate.obj", "wing"})) == Texts{"plate", "wing"});
  CHECK(parts[0].is_at_rest());
  CHECK(parts[3].frames[0].label() == "g2.off");  // by number
  CHECK(parts[3].at(1).label() == "g10.off");
  CHECK(parts[0].at(1).label() == "plate.obj");
}

TEST_CASE("no two parts have one name, also as results cut it") {
  const std::string deep(90, 'd');
  const Files files({"a/x.obj", "b/x.obj", "m-1.obj", "m-2.obj"});
  const auto parts = files.moving({"a/x.obj", "b/x.obj", "m-*.obj"});
  CHECK(parts[0].name == files.folder.path("a/x.obj"));
  CHECK(parts[2].name == files.folder.path("m-*.obj"));
  const Files far({deep + "/" + deep + "/a/x.obj", deep + "/" + deep + "/b/x.obj", "m-1.obj", "m-2.obj"});
  const auto cut = far.moving({deep + "/" + deep + "/a/x.obj", deep + "/" + deep + "/b/x.obj", "m-*.obj"});
  CHECK(cut[0].name.starts_with("1: "));
  CHECK(cut[1].name.starts_with("2: "));
  CHECK(shown_part(cut[0].name) != shown_part(cut[1].name));
}

TEST_CASE("frames have the labels of the part that moves, or numbers") {
  const Files files({"plate.obj", "lid-1.obj", "lid-2.obj", "arm/1.obj", "arm/2.obj"});
  CHECK(frames_of(files.moving({"plate.obj", "lid-*.obj"}))[1].label() == "lid-2.obj");
  CHECK(frames_of(files.moving({"arm", "lid-*.obj"}))[1].label() == "frame 1");
  const auto rest = frames_of(parts_at_rest({files.folder.path("plate.obj"), files.folder.path("arm")}, {}));
  REQUIRE(rest.size() == 1);
  CHECK(rest[0].label() == "plate.obj + 1.obj + 2.obj");
}

TEST_CASE("the vertex that a result names is that of its part") {
  frames::Topology scene;
  scene.vertex_count = 5;
  scene.parts = {"plate", "none", std::string(120, 'x')};
  scene.vertex_parts = {0, 0, 2, 2, 2};
  scene.vertex_numbers = {1, 2, 0, 1, 2};
  NamedElement named;
  const auto found = [&](const std::string& part, std::uint64_t number) {
    named.part = part;
    named.vertices[0] = number;
    return vertex_named(scene, named, 0);
  };
  CHECK(found("plate", 1) == MeshIndex{0});
  CHECK(found("plate", 2) == MeshIndex{1});
  CHECK_FALSE(found("plate", 0));
  CHECK_FALSE(found("plate", 3));
  CHECK_FALSE(found("none", 0));
  CHECK_FALSE(found("other", 1));
  CHECK(found(shown_part(scene.parts[2]), 0) == MeshIndex{2});
  CHECK(found(shown_part(scene.parts[2]), 2) == MeshIndex{4});
  CHECK_FALSE(found(shown_part(scene.parts[2]), 3));
  scene.vertex_parts.clear();
  scene.vertex_numbers.clear();
  scene.first_number = 1;
  CHECK(found("any", 5) == MeshIndex{4});
  CHECK_FALSE(found("any", 6));
  CHECK_FALSE(found("any", 0));
}
