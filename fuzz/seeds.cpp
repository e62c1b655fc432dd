// SPDX-License-Identifier: MIT
#include "seeds.hpp"

#include "families/families.hpp"
#include "io/queries/query_array.hpp"
#include "io/queries/query_writer.hpp"
#include "pipes/protocol.hpp"
#include "query_bytes.hpp"
#include "scene/scene_file.hpp"
#include "scene/shipped_scenes.hpp"
#include "sim/checkpoint.hpp"

namespace touchstone::fuzzing {
namespace {

constexpr std::uint64_t kSeed = 1;

/// A few of each family and kind.
std::vector<Query> queries(std::uint64_t each) {
  std::vector<Query> all;
  for (const families::FamilyInfo& family : families::all_families()) {
    for (const Kind kind : kKinds) {
      for (std::uint64_t i = 0; i < each; ++i) all.push_back(families::make({family.family, kind, kSeed, i}));
    }
  }
  return all;
}

std::vector<std::string> query_seeds() {
  std::vector<std::string> seeds;
  for (const Query& query : queries(8)) seeds.push_back(bytes_for(query));
  return seeds;
}

std::vector<std::string> query_file_seeds() {
  std::vector<std::string> seeds;
  for (const Query& query : queries(1)) {
    std::string seed(1, static_cast<char>(static_cast<unsigned>(query.kind) + 4 * (seeds.size() % 8)));
    if (seeds.size() % 3 == 0) seed += "# a comment\n\n";
    io::append_query(seed, query, seeds.size() % 2 == 0);
    if (seed.size() < 4000) seeds.push_back(seed);
  }
  seeds.push_back(std::string(1, '\3') + "1,3,0,1,-5,7,1\r\n0,1,0,1,0,1,1\r\n1,3,0,1,-5,7,1\r\n0,1,0,1,0,1,1\r\n");
  const std::string turn = "motion,0,1,0,0,0,1,0,0,1,0,0,0,0,0,0\n";
  seeds.push_back("\x23query,1\n" + turn + "body,0,5,0,0\ncurve,0,0,0x1p-1,1,1e-3,-2\n");
  seeds.push_back("\x21# a comment\n\nquery,0\r\n" + turn +
                  "motion,3,1,2,0,-1,3,0,1,1,1,2,3,-4,0,7\nbody,3, 1 ,2,3\nbody,0,1,1,1\nbody,0,1,2,1\ncurve,0,0,0\n");
  seeds.push_back("\3touchstone-curved,1\nquery,0\ncurve,0,0,0\ncurve,1,0,0,2,0,0,3,0,0,4,4,4\nquery,1\n");
  const std::string zeros(2 * 2 * 3 * sizeof(double), '\0');
  seeds.push_back(std::string(1, '\3') +
                  io::BinaryHeader{Kind::point_point, 3, 1, true, Separation{0.25, Metric::max}}.bytes() + zeros +
                  "\1");
  seeds.push_back(std::string(1, '\7') + io::npy_query_header(Kind::point_point, 1) + zeros);
  return seeds;
}

std::vector<std::string> answers_file_seeds() {
  std::vector<std::string> seeds{
      "\1query,contact\n0,1\n1,0\n",
      "\2file,query,contact,toi\na.csv,0,1,0x1p-1\n\"b,\"\"c\"\".csv\",1,1,0.25\na.csv,2,0,\n",
      "\3toi,contact,query\r\n,0,7\r\n\r\n1e-3,1,8\r\n",
      "\4file,query,contact,toi,toi_upper,nature,feature_a,feature_b,level\nx,0,1,0x1p-2,0x1p-2,crossing,a,b,filter\n"};
  return seeds;
}

std::vector<std::string> pipe_line_seeds() {
  std::vector<std::string> seeds{"0",      "1",          "1 0x1.8p-2\r", "1 0.5",   "1 -1e-310",         "1 nan",
                                 "1 -inf", "1 infinity", "unsupported",  "1 1e999", "1 0x.0000001p-1074"};
  for (const Query& query : queries(1)) {
    std::string line = pipes::query_line(query);
    line.pop_back();
    seeds.push_back(line);
  }
  return seeds;
}

std::vector<std::string> scene_file_seeds() {
  std::vector<std::string> seeds{
      R"({"touchstone_scene": 1, "particles": [{"position": [0, 0, 0], "pinned": [true, false, true], "mass": 1}]})",
      R"({"touchstone_scene": 1, "name": "hung", "settings": {"time_step": 0.01, "integrator": "tr-bdf2",
          "contact": {"friction": 0.3, "passes": 5}}, "cables": [{"from": [0, 0, 0], "to": [1, 0, 0], "segments": 3,
          "radius": 0.01, "density": 1000, "young": 1e6, "poisson": 0.5, "start": {"hold": "clamped", "twist_rate": 1}}]})",
      R"({"touchstone_scene": 1, "particles": [{"position": [0, 0, 0], "path": [{"time": 0, "position": [0, 0, 0]}]},
          {"position": [1, 0, 0], "mass": 1}, {"position": [0, 1, 0], "mass": 1}], "surfaces": [{"faces": [[0, 1, 2]],
          "stiffness": 10}], "wires": [[0, 1]], "springs": [{"particles": [1, 2], "stiffness": 5, "collides": false}]})",
      R"({"touchstone_scene": 1, "particles": [{"position": [0, 0, 0], "pinned": true}, {"position": [1, 0, 0], "mass": 1},
          {"position": [0, 1, 0], "mass": 1}, {"position": [0, 0, 9], "mass": 1, "radius": 0.25}],
          "faces": [{"particles": [0, 1, 2], "radius": 0.001}, [0, 2, 1]], "wires": [{"particles": [0, 1], "radius": 0.5}],
          "springs": [{"particles": [1, 2], "stiffness": 5, "radius": 1e-12}],
          "surfaces": [{"faces": [[1, 0, 2]], "stiffness": 1, "radius": 0.01}],
          "cables": [{"from": [0, 0, 3], "to": [1, 0, 3], "segments": 2, "radius": 0.01, "solid": true, "density": 1000,
          "stretch": 1}]})"};
  for (const sim::ShippedScene& shipped : sim::shipped_scenes()) {
    const sim::Scene scene = shipped.make(shipped.least);
    const std::string text = sim::scene_to_json(scene);
    if (text.size() > 8000) continue;
    seeds.push_back(text);
    seeds.push_back(sim::checkpoint_to_json(sim::Simulation(scene, {})));
  }
  return seeds;
}

/// A byte for the format, and a mesh of four vertices.
std::vector<std::string> mesh_file_seeds() {
  const std::string ply =
      "_endian 1.0\nelement vertex 4\nproperty char x\nproperty char y\nproperty char z\nelement face 2\n"
      "property list uchar char vertex_indices\nend_header\n";
  const std::string corners("abcdefghijkl\3\0\1\2\4\3\2\1\0", 21);
  const std::string vtk = "\nBINARY\nDATASET POLYDATA\nPOINTS 2 float\n" + std::string(24, '\1') + "\nLINES ";
  std::string stl = std::string(80, ' ') + std::string("\1\0\0\0", 4);
  for (int i = 0; i < 50; ++i) stl += static_cast<char>(i);
  const std::string gltf =
      R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"rotation":[0,0,1,2],"children":[1]},)"
      R"({"mesh":0,"name":"b","scale":[1,-1,1]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}},)"
      R"({"attributes":{"POSITION":0},"indices":1,"mode":5}]}],"accessors":[)"
      R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
      R"({"bufferView":0,"byteOffset":1,"componentType":5121,"count":4,"type":"SCALAR"}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":36,"byteOffset":0}],"buffers":[{"byteLength":36,"uri":)"
      R"("data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
  const auto bytes = [](std::size_t number) {
    return std::string{static_cast<char>(number & 255), static_cast<char>(number >> 8), '\0', '\0'};
  };
  const auto array = [](const std::string& attributes, const std::string& values) {
    return "<DataArray type=\"" + attributes + "\">" + values + "</DataArray>";
  };
  const std::string vtu = "VTKFile type=\"UnstructuredGrid\"";
  const std::string piece = "><UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"2\"><Points>";
  const std::string grid = "<" + vtu + piece + array("Float64\" NumberOfComponents=\"3", "0 0 0 1 0 0 0 1 0 0 0 1") +
                           "</Points><Cells>" + array("Int32\" Name=\"connectivity", "0 1 2 3\n0 1") +
                           array("Int8\" Name=\"offsets", "4 6") + array("UInt8\" Name=\"types", "10 3") +
                           "</Cells></Piece></UnstructuredGrid></VTKFile>";
  // The same in base64, compressed by zlib.
  const std::string compressed =
      "<" + vtu + " byte_order=\"LittleEndian\" compressor=\"vtkZLibDataCompressor\"" + piece +
      array("Float32\" format=\"binary\" NumberOfComponents=\"3", "AQAAAACAAAAwAAAAEAAAAA==eJxjYEAGDfYMBPgAJ70CPg==") +
      "</Points><Cells>" +
      array("Int8\" format=\"binary\" Name=\"connectivity", "AQAAAACAAAAGAAAADgAAAA==eJxjYGRiZmAEAAAdAAg=") +
      array("Int8\" format=\"binary\" Name=\"offsets", "AQAAAACAAAACAAAACgAAAA==eJxjYQMAABAACw==") +
      array("UInt8\" format=\"binary\" Name=\"types", "AQAAAACAAAACAAAACgAAAA==eJzjYgYAABkADg==") +
      "</Cells></Piece></UnstructuredGrid></VTKFile>";
  const std::string poly =
      "<VTKFile type=\"PolyData\" byte_order=\"BigEndian\"><PolyData><Piece NumberOfPoints=\"2\" NumberOfLines=\"1\">"
      "<Points>" +
      array("Float32\" format=\"appended\" offset=\"0\" NumberOfComponents=\"3", "") + "</Points><Lines>" +
      array("Int8\" format=\"appended\" offset=\"28\" Name=\"connectivity", "") +
      array("Int8\" format=\"appended\" offset=\"34\" Name=\"offsets", "") +
      "</Lines></Piece></PolyData><AppendedData encoding=\"raw\">_" + std::string("\0\0\0\x18", 4) +
      std::string(24, '\1') + std::string("\0\0\0\2\0\1\0\0\0\1\2", 11) + "</AppendedData></VTKFile>";
  return {
      "\1v 0 0 0\nv 1 0 .5\nv 0x1p-3 1 0 1\nv 1 1 1 1 0 0\ng a b\nf 1/1/1 2//2 3/3\no c\nf -4 -3 -2 -1\nl 1 2 4\np 4\n",
      "\2ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face "
      "1\n"
      "property list uchar int vertex_index\nelement edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n"
      "0 0 0\n1 0 0\n0 1e-1 0\n3 0 1 2\n0 2\n",
      "\3ply\nformat binary_little" + ply + corners,
      "\3ply\nformat binary_big" + ply + corners,
      "\4solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "-0\nendloop\nendfacet\nendsolid\n",
      "\4" + stl,
      "\7# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0 1 0 0 0 1 0 1 1 0\n"
      "METADATA\n\nCELLS 3 10\n4 0 1 3 2\n2 0 1\n1 3\nCELL_TYPES 3\n9 3 1\n",
      "\6# vtk DataFile Version 4.2\n" + vtk + "1 3\n" + std::string("\0\0\0\2\0\0\0\0\0\0\0\1", 12),
      "\6# vtk DataFile Version 5.1\n" + vtk + "2 2\nOFFSETS vtktypeint32\n" + std::string("\0\0\0\0\0\0\0\2", 8) +
          "\nCONNECTIVITY vtktypeint32\n" + std::string("\0\0\0\0\0\0\0\1", 8),
      "\13COFF 4 3 0 # c\n0 0 0 1\n1 0 0\n0 1 0\n1 1 .5\n3 0 1 2\n4 0 1 3 2 1\n2 0 3\n",
      "\14$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n"
      "$Elements\n2\n1 4 2 1 1 1 2 3 4\n2 1 0 1 2\n$EndElements\n",
      "\14$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n"
      "$EndNodes\n$Elements\n1 1 1 1\n2 1 2 1\n1 1 2 3\n$EndElements\n",
      "\20" + grid,
      "\21" + compressed,
      "\20" + poly,
      "\16" + gltf,
      std::string("\16glTF\2\0\0\0", 9) + bytes(20 + gltf.size()) + bytes(gltf.size()) + "JSON" + gltf,
      std::string("\10\x93NUMPY\1\0\73\0", 11) + "{'descr': '|u1', 'fortran_order': False, 'shape': (1, 3), }" +
          std::string("\0\1\5", 3)};
}

}  // namespace

std::vector<std::string> seeds_for(std::string_view target) {
  if (target == "query") return query_seeds();
  if (target == "query_file") return query_file_seeds();
  if (target == "answers_file") return answers_file_seeds();
  if (target == "pipe_lines") return pipe_line_seeds();
  if (target == "scene_file") return scene_file_seeds();
  if (target == "mesh_file") return mesh_file_seeds();
  return {};
}

}  // namespace touchstone::fuzzing
