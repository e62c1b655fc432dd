// Hundreds of hostile files: each is an error of one line or a frame whose numbers make sense, in little memory.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include <touchstone/error.hpp>

#include "frames/frame.hpp"
#include "frames/samples.hpp"
#include "io/temporary_folder.hpp"
#include "seeded/rng.hpp"
#include "support/catch.hpp"

namespace {

std::size_t largest_block = 0;

void* noted(std::size_t size) {
  if (size > largest_block) largest_block = size;
  void* const memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) { return noted(size); }
void* operator new[](std::size_t size) { return noted(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return std::malloc(size == 0 ? 1 : size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

using namespace touchstone;
using namespace touchstone::tests;

namespace {

struct Counts {
  int errors = 0, frames = 0;
};

template <class Elements>
void check_indices(const Elements& elements, std::size_t vertices) {
  for (const auto& element : elements) {
    for (const MeshIndex vertex : element) {
      if (vertex >= vertices) FAIL("vertex " << vertex << " of " << vertices);
    }
  }
}

void check_frame(const frames::Frame& frame) {
  const frames::Topology& topology = *frame.topology;
  REQUIRE(topology.vertex_count > 0);
  REQUIRE((topology.dimension == 2 || topology.dimension == 3));
  REQUIRE(frame.positions.size() == topology.vertex_count * static_cast<std::size_t>(topology.dimension));
  for (const double x : frame.positions) {
    if (!std::isfinite(x)) FAIL("a coordinate is not finite");
  }
  check_indices(topology.faces, topology.vertex_count);
  check_indices(topology.edges, topology.vertex_count);
  for (const MeshIndex point : topology.points) REQUIRE(point < topology.vertex_count);
  REQUIRE((topology.face_numbers.empty() || topology.face_numbers.size() == topology.faces.size()));
  REQUIRE((topology.face_parts.empty() || topology.face_parts.size() == topology.faces.size()));
  for (const std::uint32_t part : topology.face_parts) REQUIRE(part < topology.parts.size());
  REQUIRE(!(topology.faces.empty() && topology.edges.empty() && topology.points.empty()));
  REQUIRE(frame.digest.size() == 64);
}

/// Reads a file with and without triangulation.
void try_file(const std::string& name, std::size_t size, Counts& counts, const std::string& topology = {}) {
  for (const bool triangulate : {false, true}) {
    frames::ReadOptions options;
    options.triangulate = triangulate;
    options.topology_file = topology;
    largest_block = 0;
    try {
      const frames::Frame frame = frames::read_frame(name, 0, options);
      check_frame(frame);
      ++counts.frames;
    } catch (const FileError& error) {
      const std::string what = error.what();
      CHECK(what.find('\n') == std::string::npos);
      CHECK(what.size() < name.size() + 400);
      for (const char c : what) {
        if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7F) FAIL("a control character");
      }
      ++counts.errors;
    }
    // A vector doubles its room, and an element of a few bytes takes up to 24.
    if (largest_block > (std::size_t{1} << 17) + 48 * size) FAIL(largest_block << " bytes for a file of " << size);
  }
}

/// The samples, an STL file of text and one of bytes, and an array.
std::vector<Sample> all_samples() {
  std::vector<Sample> samples = mesh_samples();
  samples.push_back(npy_sample());
  const std::string vertices = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";
  samples.push_back(
      {"text.stl", "solid a\nfacet normal 0 0 1\nouter loop\n" + vertices + "endloop\nendfacet\nendsolid a\n"});
  std::string binary(80, ' ');
  binary += bytes_of(std::uint32_t{2}, std::endian::little);
  for (int i = 0; i < 24; ++i)
    binary += bytes_of(static_cast<float>(i % 5), std::endian::little) + (i % 12 == 11 ? "ab" : "");
  samples.push_back({"binary.stl", binary});
  return samples;
}

}  // namespace

TEST_CASE("a valid file cut at any place, or with changed bytes, is an error or a frame", "[slow]") {
  const TemporaryFolder folder;
  seeded::Rng rng(11);
  Counts counts;
  int files = 0;
  for (const Sample& sample : all_samples()) {
    CAPTURE(sample.name);
    const auto attempt = [&](const std::string& content) {
      CAPTURE(content);
      try_file(folder.write(sample.name, content), content.size(), counts);
      ++files;
    };
    Counts whole;
    try_file(folder.write(sample.name, sample.content), sample.content.size(), whole);
    CHECK(whole.frames == 2);
    for (std::size_t size = 0; size < sample.content.size(); size += 1 + sample.content.size() / 50) {
      attempt(sample.content.substr(0, size));
    }
    for (int i = 0; i < 150; ++i) {
      std::string content = sample.content;
      for (int changes = rng.between(1, 4); changes > 0; --changes) {
        const std::size_t at = rng.below(content.size());
        switch (rng.between(0, 5)) {
          case 0: content[at] = static_cast<char>(rng.bits()); break;
          case 1: content[at] ^= static_cast<char>(1U << rng.below(8)); break;
          case 2: content.insert(at, content.substr(rng.below(content.size()), rng.below(20))); break;
          case 3: content.erase(at, 1 + rng.below(8)); break;
          case 4: content[at] = " \n\r\t-0919e.x#\\/"[rng.below(15)]; break;
          default: content.insert(at, std::string(1 + rng.below(30), static_cast<char>('0' + rng.below(10)))); break;
        }
        if (content.empty()) content.push_back('x');
      }
      attempt(content);
    }
  }
  std::printf("%d files: %d errors, %d frames\n", files, counts.errors, counts.frames);
  CHECK(files > 2500);
  CHECK(counts.errors > 1000);
  CHECK(counts.frames > 200);
}

TEST_CASE("junk under every ending is an error") {
  const TemporaryFolder folder;
  seeded::Rng rng(12);
  Counts counts;
  for (const std::string ending : {"obj", "ply", "stl", "vtk", "npy", "gltf", "glb", "pc2", "mdd"}) {
    const std::string start = ending == "obj"   ? "v "
                              : ending == "ply" ? "ply\nformat binary_little_endian 1.0\nelement vertex 9\n"
                              : ending == "stl" ? "solid"
                              : ending == "glb" ? std::string("glTF\2\0\0\0", 8)
                              : ending == "pc2" ? std::string("POINTCACHE2\0\1\0\0\0", 16)
                              : ending == "vtk" ? "# vtk DataFile Version 5.1\n\nBINARY\nDATASET POLYDATA\n"
                                                : "\x93NUMPY\1";
    for (const std::size_t size : {0, 1, 2, 83, 84, 85, 1000, 100'000}) {
      std::string junk(size, '\0');
      for (char& byte : junk) byte = static_cast<char>(rng.bits());
      for (const std::string& content :
           {junk, start + junk, std::string(size, '\0'), start + std::string(size, '\n'),
            start + std::string(size, ' '), start + std::string(size, '9'), std::string(size, '-'),
            start + std::string(size, '\\'), std::string(size, '\r')}) {
        CAPTURE(ending, size, content.substr(0, 100));
        try_file(folder.write("junk." + ending, content), content.size(), counts);
      }
    }
  }
  CHECK(counts.frames == 0);
  CHECK(counts.errors == 2 * 9 * 8 * 9);
}

TEST_CASE("counts that no file can hold ask for no memory") {
  const TemporaryFolder folder;
  Counts counts;
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string binary =
      "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty char x\nproperty char y\n"
      "property char z\n";
  const std::string vtk = "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\n";
  const std::string msh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n";
  const std::string points = vtk + "POINTS 1 float\n0 0 0\n";
  const std::string newer =
      "# vtk DataFile Version 5.1\n\nBINARY\nDATASET POLYDATA\nPOINTS 1 float\n" + std::string(12, '\0');
  const std::string grid = "# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 1 float\n0 0 0\n";
  for (const std::string count : {"100000", "4294967295", "4294967296", "1000000000000", "999999999999999999",
                                  "9223372036854775807", "18446744073709551615", "-1"}) {
    const std::vector<Sample> files = {
        {"a.ply", ply + "element other " + count + "\nproperty int a\nend_header\n0 0 0\n"},
        {"a.ply", ply + "element face " + count + "\nproperty list int int vertex_index\nend_header\n0 0 0\n"},
        {"a.ply", ply + "element face 1\nproperty list int int vertex_index\nend_header\n0 0 0\n" + count + " 0 0 0\n"},
        {"a.ply", ply + "element other 1\nproperty list int float a\nend_header\n0 0 0\n" + count + " 0 0 0\n"},
        {"a.ply", "ply\nformat ascii 1.0\nelement vertex " + count +
                      "\nproperty int x\nproperty int y\nproperty int z\n" + "end_header\n0 0 0\n"},
        {"a.ply", binary + "element other " + count + "\nproperty list uint double a\nend_header\n" +
                      std::string("\0\0\0\xFF\xFF\xFF\xFF", 7)},
        {"a.vtk", vtk + "POINTS " + count + " double\n0 0 0\n"},
        {"a.vtk", vtk + "FIELD a " + count + "\nb " + count + " " + count + " double\n0 0 0\n"},
        {"a.vtk", vtk + "FIELD a 1\nb 2 " + count + " double\n0 0 0\n"},
        {"a.vtk", points + "POLYGONS " + count + " " + count + "\n3 0 0 0\n"},
        {"a.vtk", points + "LINES 1 " + count + "\n" + count + " 0 0 0\n"},
        {"a.vtk", points + "VERTICES 1 2\n" + count + " 0\n"},
        {"a.vtk", newer + "\nPOLYGONS " + count + " " + count + "\nOFFSETS vtktypeint64\n" + std::string(16, '\0')},
        {"a.vtk", newer + "\nPOLYGONS 2 " + count + "\nOFFSETS vtktypeint64\n" + std::string(16, '\0')},
        {"a.vtk", grid + "CELLS " + count + " " + count + "\n1 0\nCELL_TYPES " + count + "\n1\n"},
        {"a.vtk", grid + "CELLS 1 2\n1 0\nCELL_TYPES " + count + "\n1\n"},
        {"a.npy", npy("<f8", false, "(" + count + ", 3)", std::string(24, '\0'))},
        {"a.npy", npy("<f8", false, "(" + count + ", " + count + ", 3)", std::string(24, '\0'))},
        {"a.npy", npy("<f4", true, "(3, " + count + ", 2)", std::string(24, '\0'))},
        {"a.off", "OFF " + count + " 0 0\n0 0 0\n"},
        {"a.off", "OFF 1 " + count + " 0\n0 0 0\n1 0\n"},
        {"a.off", "OFF 1 1 0\n0 0 0\n" + count + " 0\n"},
        {"a.msh", msh + count + "\n1 0 0 0\n"},
        {"a.msh", msh + "1\n1 0 0 0\n$EndNodes\n$Elements\n" + count + "\n1 15 0 1\n"},
        {"a.msh", msh + "1\n1 0 0 0\n$EndNodes\n$Elements\n1\n1 15 " + count + " 1\n$EndElements\n"},
        {"a.obj", "v 0 0 0\nf 1 1 " + count + "\n"},
        {"a.obj", "v 0 0 0\nf 1 1 1/" + count + "x\n"},
        {"a.stl", std::string(80, '\0') + std::string("\xFF\xFF\xFF\xFF", 4) + std::string(50, '\0')},
    };
    for (const Sample& file : files) {
      CAPTURE(count, file.name, file.content);
      const int frames = counts.frames;
      try_file(folder.write(file.name, file.content), file.content.size(), counts);
      const bool is_last_vertex = file.name == "a.obj" && file.content.find("f 1 1 -1\n") != std::string::npos;
      CHECK(counts.frames == frames + (is_last_vertex ? 2 : 0));
    }
  }
  CHECK(counts.errors >= 2 * 8 * 28 - 2);
}

TEST_CASE("a short glTF file does not stand for any number of vertices") {
  const TemporaryFolder folder;
  std::string nodes, roots;
  for (int i = 0; i < 3000; ++i) {
    nodes += std::string(i == 0 ? "" : ",") + R"({"mesh":0})";
    roots += (i == 0 ? "" : ",") + std::to_string(i);
  }
  const std::string file = folder.write(
      "a.gltf",
      R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[)" + roots + R"(]}],"nodes":[)" + nodes +
          R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":0}]}],"accessors":[)"
          R"({"bufferView":0,"componentType":5126,"count":30000,"type":"VEC3"}],)"
          R"("bufferViews":[{"buffer":0,"byteLength":360000}],"buffers":[{"byteLength":360000,"uri":"a.bin"}]})");
  folder.write("a.bin", std::string(360000, '\0'));
  try {
    frames::read_frame(file, 0, {});
    FAIL_CHECK("no error");
  } catch (const FileError& error) {
    CHECK(std::string(error.what()).find("too many for a file of this size") != std::string::npos);
  }
}

TEST_CASE("a million faces on one line, and numbers of a million digits") {
  const TemporaryFolder folder;
  constexpr int kFaces = 1'000'000;
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  Counts counts;
  const auto attempt = [&](const std::string& name, const std::string& content) {
    try_file(folder.write(name, content), content.size(), counts);
  };
  std::string faces;
  for (int i = 0; i < kFaces; ++i) faces += "f 1 2 3 ";
  attempt("faces.obj", vertices + faces);
  CHECK(counts.errors == 2);

  std::string corners = "f";
  for (int i = 0; i < kFaces; ++i) corners += " 1 2 3";
  attempt("corners.obj", vertices + corners);
  CHECK(counts.errors == 3);  // one polygon, which can be cut
  CHECK(counts.frames == 1);

  std::string cells =
      "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 3 float 0 0 0 1 0 0 0 1 0 POLYGONS " +
      std::to_string(kFaces) + " " + std::to_string(4 * kFaces);
  cells[cells.find("float ") + 5] = '\n';
  cells += '\n';
  for (int i = 0; i < kFaces; ++i) cells += " 3 0 1 2";
  attempt("cells.vtk", cells);
  CHECK(counts.frames == 3);

  const std::string nines(1'000'000, '9');
  const std::string zeros(1'000'000, '0');
  for (const std::string& number :
       {"0." + nines, "0." + zeros + "1e1000000", zeros + "1", std::string("1") + zeros + "e-1000000"}) {
    attempt("digits.obj", "v 0 1 " + number + "\n");
  }
  CHECK(counts.frames == 11);
  attempt("digits.obj", "v 0 1 " + nines + "\n");
  attempt("digits.obj", vertices + "f 1 2 " + nines + "\n");
  attempt("name.obj", vertices + nines + "\n");
  attempt("name.obj", vertices + "f 1 2 3" + nines + "\n");
  CHECK(counts.frames == 11);
  attempt("group.obj", vertices + "g " + nines + "\nf 1 2 3\n");
  attempt("continued.obj", "v 0 0" + std::string(500'000, ' ') + "\\\n" + "1\n# " + nines);
  CHECK(counts.frames == 15);
}

TEST_CASE("hostile topology files") {
  const TemporaryFolder folder;
  seeded::Rng rng(13);
  Counts counts;
  const std::string array = folder.write("array.npy", npy_sample().content);
  const std::string indices = npy("<i2", false, "(2, 3)", std::string("\0\0\1\0\2\0\0\0\2\0\3\0", 12));
  for (int i = 0; i < 200; ++i) {
    std::string content = indices;
    const bool index = rng.one_in(2);  // a low byte of one
    const std::size_t at = index ? content.size() - 12 + 2 * rng.below(6) : rng.below(content.size());
    content[at] = static_cast<char>(index ? rng.below(9) : rng.bits());
    if (rng.one_in(3)) content.resize(rng.below(content.size()));
    CAPTURE(i);
    try_file(array, content.size() + 400, counts, folder.write(std::to_string(i) + ".npy", content));
  }
  CHECK(counts.errors > 100);
  CHECK(counts.frames > 50);
}
