// Every format gives the mesh that was written, bit for bit.
// SPDX-License-Identifier: MIT
#include <cstring>
#include <set>
#include <string>

#include <touchstone/error.hpp>

#include "frames/content.hpp"
#include "frames/frame.hpp"
#include "frames/samples.hpp"
#include "frames/vtk_xml_samples.hpp"
#include "frames/write_obj.hpp"
#include "io/sha256.hpp"
#include "io/temporary_folder.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;
using namespace touchstone::frames;

namespace {

using Faces = std::vector<std::array<MeshIndex, 3>>;
using Edges = std::vector<std::array<MeshIndex, 2>>;
using Indices = std::vector<MeshIndex>;

const ReadOptions kTriangulate = [] {
  ReadOptions options;
  options.triangulate = true;
  return options;
}();

bool same_bits(const double* a, const double* b, std::size_t count) {
  return std::memcmp(a, b, count * sizeof(double)) == 0;
}

Frame read(const TemporaryFolder& folder, const std::string& name, const std::string& content,
           const ReadOptions& options = {}) {
  return read_frame(folder.write(name, content), 0, options);
}

/// Four vertices of an OBJ file, and what follows.
std::string obj_of(const std::string& rest) { return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n" + rest; }

std::string stl_facet(std::initializer_list<float> coordinates) {
  std::string text(12, '\xFF');  // a normal that is not a number
  for (const float x : coordinates) text += bytes_of(x, std::endian::little);
  return text + "ab";
}

}  // namespace

TEST_CASE("every format gives the coordinates bit for bit, and the elements") {
  const TemporaryFolder folder;
  std::set<std::string> names;
  for (const Sample& sample : mesh_samples()) {
    CAPTURE(sample.name);
    CHECK(names.insert(sample.name).second);
    const Frame frame = read(folder, sample.name, sample.content);
    const Topology& topology = *frame.topology;
    CHECK(topology.vertex_count == kVertices);
    CHECK(topology.dimension == 3);
    REQUIRE(frame.positions.size() == 3 * kVertices);
    CHECK(same_bits(frame.positions.data(), sample.floats ? kFloats.data() : kDoubles.data(), 3 * kVertices));
    CHECK(topology.faces == Faces(kFaces.begin(), kFaces.end()));
    CHECK(topology.edges == (sample.edges ? Edges{{3, 4}} : Edges{}));
    CHECK(topology.points == (sample.points ? Indices{5} : Indices{}));
    CHECK(topology.first_number == (sample.name.ends_with(".obj") ? 1 : 0));
    CHECK(topology.face_numbers.empty());
    CHECK(frame.digest == io::sha256(sample.content));
    CHECK(frame_count(folder.path(sample.name), {}) == 1);
    CHECK_THROWS_AS(read_frame(folder.path(sample.name), 1, {}), FileError);
  }
  CHECK(names.size() == 19u + (kReadsVtkXml ? 5 : 0) + (kInflates ? 3 : 0));
}

TEST_CASE("the ending of a name says the format in either case") {
  const TemporaryFolder folder;
  CHECK(read(folder, "A.OBJ", obj_of("")).topology->vertex_count == 4);
  const auto refused = [&](const char* name, const std::string& content, const char* reason) {
    CHECK_THROWS_WITH(read_frame(folder.write(name, content), 0, {}), Catch::Contains(reason));
  };
  for (const char* const name : {"mesh.txt", "obj"}) refused(name, "x", "meshio convert a.inp a.ply");
  for (const char* const name : {"a.abc", "a.USDC", "a.b.fbx"}) refused(name, "", "Blender writes its frames as .obj");
  for (const char* const name : {"a.step", "a.STP", "a.iges"}) refused(name, "", "gmsh -2 a.step -o a.stl");
  refused("a.3mf", "PK\x03\x04", "trimesh.load_mesh('a.3mf').export('a.ply')");
  // What is not there has another fault than its ending.
  CHECK_THROWS_WITH(read_frame(folder.path("none"), 0, {}), Catch::Contains("none: cannot be opened: No such file"));
}

TEST_CASE("packed mesh files and text of UTF-16 are named with the remedy") {
  const TemporaryFolder folder;
  const auto refused = [&](const char* name, const std::string& content, const char* reason) {
    CHECK_THROWS_WITH(read(folder, name, content), Catch::Contains(reason));
  };
  const std::string packed = "\x1F\x8B\x08xxxxxxxxx";
  for (const char* const name : {"a.obj.gz", "a.obj", "a.ply", "a.stl"}) refused(name, packed, "is packed by gzip");
  for (const char* const name : {"a.obj", "a.off", "a.stl"}) refused(name, "\xFF\xFEv", "is text in UTF-16");
  refused("b.obj",
          std::string("v\0 \0"
                      "1\0",
                      6),
          "is text in UTF-16");
  // A binary STL file may have any 80 bytes first.
  std::string facet =
      packed + std::string(80 - packed.size(), ' ') + std::string("\1\0\0\0", 4) + std::string(50, '\0');
  facet[84 + 14] = facet[84 + 15] = facet[84 + 28] = facet[84 + 29] = '\x3f';
  CHECK(read(folder, "b.stl", facet).topology->faces.size() == 1);
}

TEST_CASE("objects and groups of an OBJ file are parts, each once") {
  const TemporaryFolder folder;
  const Frame frame = read(folder, "parts.obj",
                           obj_of("f 1 2 3\no a\nf 1 2 4\ng b c\nf 1 3 4\no d\nf 2 3 4\no a\nf 4 3 2\ng unused\n"));
  CHECK(frame.topology->parts == std::vector<std::string>{"", "a", "a/b c", "d"});
  CHECK(frame.topology->face_parts == std::vector<std::uint32_t>{0, 1, 2, 3, 1});
}

TEST_CASE("an OBJ file counts from 1, and backwards from the vertex that came last") {
  const TemporaryFolder folder;
  const Frame frame = read(folder, "a.obj",
                           "v 0 0 0\nv 1 0 0 0.5\nf -1 -2 3\nv 0 1 0 1 0 0\nv 1 1 1 1 0.5 0 0\nf -1 -2 1\n"
                           "l 1 2/5 -1\np 1 2\n");
  CHECK(frame.topology->faces == Faces{{1, 0, 2}, {3, 2, 0}});
  CHECK(frame.topology->edges == Edges{{0, 1}, {1, 3}});
  CHECK(frame.topology->points == Indices{0, 1});
}

TEST_CASE("polygons are cut into triangles on request, and keep their numbers") {
  const TemporaryFolder folder;
  const std::string text = obj_of("f 1 2 3\nf 1 2 3 4\nf 2 3 4\n");
  CHECK_THROWS_WITH(read(folder, "a.obj", text),
                    Catch::Contains("a.obj:6: face 2 has 4 corners") && Catch::Contains("--triangulate"));
  const Frame frame = read(folder, "a.obj", text, kTriangulate);
  CHECK(frame.topology->faces == Faces{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}, {1, 2, 3}});
  CHECK(frame.topology->face_numbers == Indices{1, 2, 2, 3});

  const std::string grid =
      "# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
      "0 0 0 1 0 0 1 1 0 0 1 0\nCELLS 3 12 2 0 1 4 0 1 2 3 3 0 1 2 CELL_TYPES 3 3 9 5\n";
  const Frame cells = read(folder, "a.vtk", grid, kTriangulate);
  CHECK(cells.topology->faces == Faces{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}});
  CHECK(cells.topology->face_numbers == Indices{1, 1, 2});
}

TEST_CASE("the surface of tetrahedra is kept, turned outwards, and triangles of the file are not there twice") {
  const TemporaryFolder folder;
  // Two tetrahedra on both sides of the triangle 1 2 3.
  const std::string points = "0 0 0 1 0 0 0 1 0 0 0 1 1 1 1\n";
  const std::string grid = "# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 double\n" + points;
  const Frame two = read(folder, "two.vtk", grid + "CELLS 2 10\n4 0 1 2 3\n4 1 2 3 4\nCELL_TYPES 2\n10\n10\n");
  REQUIRE(two.topology->faces.size() == 6);
  for (const auto& [a, b, c] : two.topology->faces) {
    // The product with the way from the middle of all to a corner: outwards.
    const double* const x = two.positions.data();
    std::array<double, 3> u, w, out;
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = x[3 * b + k] - x[3 * a + k];
      w[k] = x[3 * c + k] - x[3 * a + k];
      out[k] = x[3 * a + k] - 0.4;
    }
    const double volume = out[0] * (u[1] * w[2] - u[2] * w[1]) + out[1] * (u[2] * w[0] - u[0] * w[2]) +
                          out[2] * (u[0] * w[1] - u[1] * w[0]);
    CHECK(volume > 0);
  }
  CHECK(two.topology->face_numbers == Indices{0, 0, 0, 1, 1, 1});
  const Frame given =
      read(folder, "given.vtk", grid + "CELLS 3 14\n4 0 1 2 3\n3 2 1 0\n4 1 2 3 4\nCELL_TYPES 3\n10\n5\n10\n");
  CHECK(given.topology->faces.size() == 6);
  CHECK(given.topology->faces.front() == std::array<MeshIndex, 3>{2, 1, 0});
  try {
    read(folder, "three.vtk", grid + "CELLS 3 15\n4 0 1 2 3\n4 1 2 3 4\n4 2 1 3 0\nCELL_TYPES 3\n10\n10\n10\n");
    FAIL("a face of three tetrahedra");
  } catch (const FileError& error) {
    CHECK(std::string(error.what()).find("tetrahedra 0, 1 and 2 share the face of the vertices 1, 2 and 3") !=
          std::string::npos);
  }
  const Frame msh =
      read(folder, "t.msh",
           "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n"
           "$Elements\n2\n7 4 0 1 2 3 4\n9 2 0 1 2 3\n$EndElements\n");
  CHECK(msh.topology->first_number == 1);
  CHECK(msh.topology->faces.size() == 4);
  CHECK(msh.topology->face_numbers == Indices{9, 7, 7, 7});
}

TEST_CASE("a file without elements has loose points") {
  const TemporaryFolder folder;
  CHECK(read(folder, "a.obj", obj_of("")).topology->points == Indices{0, 1, 2, 3});
  CHECK(read(folder, "a.obj", obj_of("l 1 2")).topology->points.empty());
}

TEST_CASE("equal corners of an STL file are one vertex, whatever the sign of 0") {
  const TemporaryFolder folder;
  const std::string text =
      "solid left one\n facet normal nan 0 0\n  outer loop\n   vertex 0 -0 1\n   vertex 1e0 0 1\n   vertex 0 1 1\n"
      "  endloop\n endfacet\nendsolid left one\nSOLID right\nFACET NORMAL 0 0 1 OUTER LOOP VERTEX 1 0 1 VERTEX 1 1 1 "
      "VERTEX 0 0x1p0 1 ENDLOOP ENDFACET endsolid";
  // A facet's normal takes its line, so the second solid is wrong where all is on one line.
  CHECK_THROWS_AS(read(folder, "a.stl", text), FileError);
  std::string right = text;
  right.insert(right.find("OUTER"), 1, '\n');
  const Frame frame = read(folder, "a.stl", right);
  CHECK(frame.topology->faces == Faces{{0, 1, 2}, {1, 3, 2}});
  const std::array<double, 12> positions = {0, -0.0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
  REQUIRE(frame.positions.size() == positions.size());
  CHECK(same_bits(frame.positions.data(), positions.data(), positions.size()));
  CHECK(frame.topology->parts == std::vector<std::string>{"left one", "right"});
  CHECK(frame.topology->face_parts == std::vector<std::uint32_t>{0, 1});
  CHECK(frame.topology->joined_vertices == 2);  // 1 and 2: the file does not say that they are one
  const std::size_t facet = right.find("FACET"), second = right.find("endsolid", facet);
  const std::string thrice = right + "\nsolid third\n" + right.substr(facet, second - facet) + " endsolid";
  CHECK(read(folder, "a.stl", thrice).topology->joined_vertices == 3);
  CHECK(read(folder, "a.stl", right.substr(0, right.find("SOLID"))).topology->joined_vertices == 0);

  const std::string start = "solid, but binary";
  const std::string binary = start + std::string(80 - start.size(), ' ') +
                             bytes_of(std::uint32_t{2}, std::endian::little) +
                             stl_facet({0, -0.0F, 1, 1, 0, 1, 0, 1, 1}) + stl_facet({1, -0.0F, 1, 1, 1, 1, 0, 1, 1});
  const Frame again = read(folder, "b.stl", binary);
  CHECK(again.topology->faces == frame.topology->faces);
  REQUIRE(again.positions.size() == positions.size());
  CHECK(same_bits(again.positions.data(), positions.data(), positions.size()));
  CHECK(again.topology->parts.empty());
}

TEST_CASE("many corners of an STL file are merged as their coordinates say") {
  const TemporaryFolder folder;
  constexpr int kSide = 40;
  std::string text = "solid\n";
  for (int i = 0; i < kSide; ++i) {
    for (int k = 0; k < kSide; ++k) {
      const auto vertex = [&](int a, int b) {
        return "vertex " + std::to_string(i + a) + " " + std::to_string(k + b) + " 0\n";
      };
      text += "facet normal 0 0 0\nouter loop\n" + vertex(0, 0) + vertex(1, 0) + vertex(0, 1) + "endloop\nendfacet\n";
    }
  }
  const Frame frame = read(folder, "a.stl", text + "endsolid\n");
  CHECK(frame.topology->vertex_count == (kSide + 1) * (kSide + 1) - 1);
  REQUIRE(frame.topology->faces.size() == kSide * kSide);
  for (std::size_t i = 0; i < frame.topology->faces.size(); ++i) {
    const auto& face = frame.topology->faces[i];
    const auto x = [&](int corner, int k) { return frame.positions[3 * std::size_t{face[corner]} + k]; };
    const auto a = static_cast<double>(i / kSide), b = static_cast<double>(i % kSide);
    REQUIRE((x(0, 0) == a && x(0, 1) == b && x(1, 0) == a + 1 && x(1, 1) == b && x(2, 0) == a && x(2, 1) == b + 1));
  }
}

TEST_CASE("the nodes of a glTF file are parts at their places, and mirrors turn faces round") {
  const TemporaryFolder folder;
  std::string buffer;
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 2.f, 0.f, 0.f, 0.f, 3.f}) {
    buffer += bytes_of(x, std::endian::little);
  }
  folder.write("with blank.bin", buffer);
  const auto file = [&](const std::string& nodes, const std::string& primitive, const std::string& more = "") {
    return folder.write(
        "a.gltf", R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[]},{"nodes":[0]}],"scene":1,"nodes":)" + nodes +
                      R"(,"meshes":[{"name":"m","primitives":[{"attributes":{"POSITION":0})" + primitive +
                      R"(}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}],)"
                      R"("bufferViews":[{"buffer":0,"byteLength":48}],"buffers":[{"byteLength":48,)"
                      R"("uri":"with%20blank.bin"}])" +
                      more + "}");
  };
  const std::string strip = R"(,"mode":5)";
  const Frame frame = read_frame(
      file(R"([{"children":[1,2,3],"translation":[10,0,0]},{"mesh":0,"name":"one"},{"mesh":0,"scale":[1,-1,1]},)"
           R"({"mesh":0,"matrix":[0,1,0,0,-1,0,0,0,0,0,1,0,5,6,7,1],"children":[4]},)"
           R"({"name":"one","mesh":0,"rotation":[0,0,1,1]}])",
           strip, R"(,"animations":[{},{}])"),
      0, {});
  const Topology& topology = *frame.topology;
  CHECK(topology.parts == std::vector<std::string>{"one", "m", "m (node 3)", "one (node 4)"});
  CHECK(topology.animations == 2);
  CHECK(topology.moved_vertices == 16);
  CHECK(topology.unshown_meshes == 0);
  CHECK(topology.vertex_count == 16);
  CHECK(topology.faces ==
        Faces{{0, 1, 2}, {1, 3, 2}, {4, 6, 5}, {5, 6, 7}, {8, 9, 10}, {9, 11, 10}, {12, 13, 14}, {13, 15, 14}});
  CHECK(topology.face_parts == std::vector<std::uint32_t>{0, 0, 1, 1, 2, 2, 3, 3});
  const auto at = [&](std::size_t vertex) {
    return std::vector<double>(frame.positions.begin() + 3 * static_cast<int>(vertex),
                               frame.positions.begin() + 3 * static_cast<int>(vertex) + 3);
  };
  CHECK(at(1) == std::vector<double>{11, 0, 0});
  CHECK(at(6) == std::vector<double>{10, -2, 0});
  CHECK(at(9) == std::vector<double>{15, 7, 7});   // x turns to y
  CHECK(at(10) == std::vector<double>{13, 6, 7});  // y to -x
  CHECK(at(13) == std::vector<double>{14, 6, 7});  // a turn by 90 degrees in one by 90 degrees
  CHECK(at(15) == std::vector<double>{15, 6, 10});

  // Names that a node has already, and meshes outside the scene.
  const Frame same = read_frame(file(R"x([{"children":[1,2,3]},{"mesh":0,"name":"A"},{"mesh":0,"name":"A"},)x"
                                     R"x({"mesh":0,"name":"A (node 2)"},{"mesh":0}])x",
                                     strip),
                                0, {});
  CHECK(same.topology->parts == std::vector<std::string>{"A", "A (node 2)", "A (node 2) (node 3)"});
  CHECK(same.topology->unshown_meshes == 1);
  CHECK(same.topology->moved_vertices == 0);
  CHECK(frames::files_beside(folder.path("a.gltf")) == std::vector<std::string>{folder.path("with blank.bin")});

  const std::string node = R"([{"mesh":0}])";
  CHECK(read_frame(file(node, R"(,"mode":6)"), 0, {}).topology->faces == Faces{{1, 2, 0}, {2, 3, 0}});
  CHECK(read_frame(file(node, R"(,"mode":2)"), 0, {}).topology->edges == Edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  CHECK(read_frame(file(node, R"(,"mode":3)"), 0, {}).topology->edges.size() == 3);
  CHECK(read_frame(file(node, R"(,"mode":0)"), 0, {}).topology->points.size() == 4);
  const std::string before = read_frame(file(node, strip), 0, {}).digest;
  folder.write("with blank.bin", buffer.substr(4) + buffer.substr(0, 4));
  CHECK(read_frame(file(node, strip), 0, {}).digest != before);
}

TEST_CASE("a frame with the topology of an earlier one shares it") {
  const TemporaryFolder folder;
  const Frame first = read(folder, "a.obj", obj_of("f 1 2 3\n"));
  const std::string second = folder.write("b.obj", "# moved\n" + obj_of("f 1 2 3\n"));
  CHECK(read_frame(second, 0, {}, first.topology).topology == first.topology);
  const std::string third = folder.write("c.obj", obj_of("f 1 3 2\n"));
  const Frame other = read_frame(third, 0, {}, first.topology);
  CHECK(other.topology != first.topology);
  CHECK(other.topology->faces == Faces{{0, 2, 1}});
}

TEST_CASE("what append_obj writes reads back as the same mesh") {
  const TemporaryFolder folder;
  Topology topology;
  topology.vertex_count = kVertices;
  topology.first_number = 1;
  topology.faces = {{0, 1, 2}, {0, 2, 3}, {1, 2, 3}};
  topology.edges = {{3, 4}};
  topology.points = {5};
  topology.parts = {"a b", "", "c"};
  topology.face_parts = {2, 0, 1};
  std::string text = "# start\n";
  append_obj(text, topology, kDoubles.data());
  const Frame frame = read(folder, "a.obj", text);
  CHECK(same_bits(frame.positions.data(), kDoubles.data(), kDoubles.size()));
  CHECK(frame.topology->faces == topology.faces);
  CHECK(frame.topology->edges == topology.edges);
  CHECK(frame.topology->points == topology.points);
  CHECK(frame.topology->parts == std::vector<std::string>{"c", "a b", ""});

  Topology plane;
  plane.vertex_count = 2;
  plane.dimension = 2;
  plane.edges = {{0, 1}};
  std::string flat;
  const std::array<double, 4> positions = {0.1, 1e300, -2, 0.5};
  append_obj(flat, plane, positions.data());
  CHECK(flat == "v 0.1 1e+300 0\nv -2 0.5 0\nl 1 2\n");
}
