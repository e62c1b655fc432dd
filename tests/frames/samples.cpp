// SPDX-License-Identifier: MIT
#include "frames/samples.hpp"

#include <cstdio>
#include <stdexcept>

#include "frames/vtk_xml_samples.hpp"

namespace touchstone::tests {
namespace {

using Coordinates = std::array<double, 3 * kVertices>;

/// One line for each vertex, or each row with a prefix.
std::string rows(const Coordinates& x, const std::string& prefix, const std::string& line_end = "\n") {
  std::string text;
  for (std::size_t i = 0; i < x.size(); i += 3) {
    text += prefix + decimal(x[i]) + ' ' + decimal(x[i + 1]) + ' ' + decimal(x[i + 2]) + line_end;
  }
  return text;
}

template <class Number>
std::string all_bytes(const Coordinates& x, std::endian order) {
  std::string text;
  for (const double value : x) text += bytes_of(static_cast<Number>(value), order);
  return text;
}

Sample obj() {
  return {"mesh.obj",
          "# a comment\nmtllib a.mtl\no thing\n" + rows(kDoubles, "v ") +
              "vt 0 0\nvn 0 0 1\ng left\ns off\nf 1/1/1 2//1 3/1\nusemtl x\nf -6 -4 -3\nl 4 5\np 6\n",
          false, true, true};
}

Sample obj_of_windows() {
  return {"windows.obj",
          "\xEF\xBB\xBF" + rows(kDoubles, "v\t", " \r\n") + "\r\nf 1 2 \\\r\n 3\r\nf 1 3 4\r\nl 4 5\r\np 6", false,
          true, true};
}

Sample ply_text() {
  return {"text.ply",
          "ply\nformat ascii 1.0\ncomment x y\nelement vertex 6\nproperty uchar red\nproperty double x\n"
          "property double y\nproperty double z\nproperty list uchar float more\nelement face 2\n"
          "property list uchar int vertex_indices\nproperty int flags\nelement edge 1\nproperty int vertex1\n"
          "property int vertex2\nelement other 1\nproperty list int float a\nend_header\n" +
              rows(kDoubles, "7 ", " 2 0.5 nan\n") + "3 0 1 2 5\n\n3 0 2 3 5\n3 4\n3 1 2 3\n",
          false, true, false};
}

Sample ply_binary(std::endian order, bool floats) {
  const std::string type = floats ? "float32" : "double";
  std::string text = "ply\nformat binary_" + std::string(order == std::endian::big ? "big" : "little") +
                     "_endian 1.0\nelement vertex 6\nproperty " + type + " x\nproperty " + type + " y\nproperty " +
                     type + " z\nproperty uchar red\nelement face 2\nproperty list uint8 double w\n" +
                     "property list int32 ushort vertex_index\nelement edge 1\nproperty uint vertex1\n" +
                     "property int8 vertex2\nend_header\n";
  for (std::size_t i = 0; i < 3 * kVertices; i += 3) {
    for (std::size_t k = i; k < i + 3; ++k) {
      text += floats ? bytes_of(static_cast<float>(kFloats[k]), order) : bytes_of(kDoubles[k], order);
    }
    text += '\n';
  }
  for (const auto& face : kFaces) {
    text += '\1' + bytes_of(0.5, order) + bytes_of(std::int32_t{3}, order);
    for (const std::uint32_t corner : face) text += bytes_of(static_cast<std::uint16_t>(corner), order);
  }
  text += bytes_of(std::uint32_t{3}, order) + '\4';
  return {(order == std::endian::big ? "big" : "little") + std::string(floats ? "_floats" : "") + ".ply", text, floats,
          true, false};
}

std::string vtk_start(bool binary, const std::string& version, const std::string& set) {
  return "# vtk DataFile Version " + version + "\nany title: POINTS\n" + (binary ? "BINARY" : "ASCII") + "\nDATASET " +
         set + "\n";
}

const std::string kField = "FIELD FieldData 2\nTIME 1 1 double\n0.5\nNAMES 2 2 int\n1 2 3\n4\n";
const std::string kMetadata = "METADATA\nINFORMATION 1\nNAME a LOCATION b\nDATA 1\n\n";

Sample vtk_text() {
  return {"text.vtk",
          vtk_start(false, "3.0", "POLYDATA") + kField + "POINTS 6 double\n" + rows(kDoubles, "") + kMetadata +
              "VERTICES 1 2\n1 5\nLINES 1 3 2 3\n4 POLYGONS 2 8\n3 0 1 2 3 0\n2 3\nPOINT_DATA 6\nVECTORS a junk\nFIELD "
              "d 1\nlines 1 6 float\n",
          false, true, true};
}

Sample vtk_grid() {
  return {"grid.vtk",
          vtk_start(false, "2.0", "UNSTRUCTURED_GRID") + "POINTS 6 double\n" + rows(kDoubles, "") +
              "CELLS 4 13\n3 0 1 2\n3 0 2 3\n2 3 4\n1 5\nCELL_TYPES 4\n5 7\n3\n1\nCELL_DATA 4\n",
          false, true, true};
}

std::string big(std::initializer_list<std::int32_t> values) {
  std::string text;
  for (const std::int32_t value : values) text += bytes_of(value, std::endian::big);
  return text;
}

std::string big64(std::initializer_list<std::int64_t> values) {
  std::string text;
  for (const std::int64_t value : values) text += bytes_of(value, std::endian::big);
  return text;
}

Sample vtk_binary() {
  return {"binary.vtk",
          vtk_start(true, "4.2", "POLYDATA") + "FIELD F 1\nTIME 1 1 double\n" + bytes_of(0.5, std::endian::big) +
              "\nPOINTS 6 float\n" + all_bytes<float>(kFloats, std::endian::big) + "\n" + kMetadata + "VERTICES 1 2\n" +
              big({1, 5}) + "\nLINES 1 3\n" + big({2, 3, 4}) + "\nPOLYGONS 2 8\n" + big({3, 0, 1, 2, 3, 0, 2, 3}) +
              "\n",
          true, true, true};
}

Sample vtk_offsets() {
  return {"offsets.vtk",
          vtk_start(true, "5.1", "UNSTRUCTURED_GRID") + "POINTS 6 double\n" +
              all_bytes<double>(kDoubles, std::endian::big) + "\nCELLS 5 9\nOFFSETS vtktypeint64\n" +
              big64({0, 3, 6, 8, 9}) + "\nCONNECTIVITY vtktypeint64\n" + big64({0, 1, 2, 0, 2, 3, 3, 4, 5}) +
              "\nCELL_TYPES 4\n" + big({5, 5, 3, 1}) + "\nCELL_DATA 4\nwhatever",
          false, true, true};
}

Sample vtk_offsets_text() {
  return {"offsets_text.vtk",
          vtk_start(false, "5.1", "POLYDATA") + "POINTS 6 double\n" + rows(kDoubles, "") +
              "LINES 2 2\nOFFSETS vtktypeint64\n0 2\nCONNECTIVITY vtktypeint64\n3 4\nVERTICES 0 0\n"
              "POLYGONS 3 6\nOFFSETS vtktypeint32\n0 3 6\nCONNECTIVITY int\n0 1 2 0 2 3\n",
          false, true, false};
}

/// Faces and the edge, with comments, colours and an empty line.
Sample off() {
  return {"mesh.off",
          "# a comment\nOFF\n6 3 0 # counts\n" + rows(kDoubles, "", " # a vertex\n") +
              "\n3 0 1 2\n3 0 2 3 0.5 0.5 1\n2 3 4\n",
          false, true, false};
}

Sample off_of_colours() {
  return {"colours.off", "COFF 6 4 0\n" + rows(kDoubles, "", " 255 0 0 255\n") + "3 0 1 2\n3 0 2 3\n2 3 4\n1 5", false,
          true, true};
}

/// The tags of nodes and elements begin with `first`.
std::string msh_rows(int first) {
  std::string text;
  for (std::size_t v = 0; v < kVertices; ++v) {
    text += std::to_string(first + static_cast<int>(v)) + ' ' + decimal(kDoubles[3 * v]) + ' ' +
            decimal(kDoubles[3 * v + 1]) + ' ' + decimal(kDoubles[3 * v + 2]) + '\n';
  }
  return text;
}

Sample msh2() {
  return {"two.msh",
          "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"a $b\"\n$EndPhysicalNames\n$Nodes\n6\n" +
              msh_rows(7) + "$EndNodes\n$Elements\n4\n0 2 2 1 1 7 8 9\n1 2 2 1 1 7 9 10\n2 1 0 10 11\n3 15 1 4 12\n" +
              "$EndElements\n$NodeData\n1\n\"x\"\n$EndNodeData\n",
          false, true, true};
}

Sample msh4() {
  std::string positions = rows(kDoubles, "");
  return {"four.msh",
          "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 1 0\n$EndEntities\n$Nodes\n1 6 2 12\n2 1 0 "
          "6\n2\n4\n6\n8\n10\n12\n" +
              positions +
              "$EndNodes\n$Elements\n3 4 0 3\n2 1 2 2\n0 2 4 6\n1 2 6 8\n1 1 1 1\n2 8 10\n0 1 15 1\n3 12\n" +
              "$EndElements\n",
          false, true, true};
}

/// Positions, then indices of faces, of the edge and of the point. One node, whose three primitives share positions.
/// @param uri  of the buffer: a key and a value, or nothing
std::string gltf_json(int index_type, std::size_t index_size, const std::string& uri) {
  const auto offset = [&](std::size_t index) { return std::to_string(72 + index * index_size); };
  const auto accessor = [&](std::size_t first, int count) {
    return R"({"bufferView":1,"byteOffset":)" + std::to_string(first * index_size) + R"(,"componentType":)" +
           std::to_string(index_type) + R"(,"count":)" + std::to_string(count) + R"(,"type":"SCALAR"})";
  };
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"name":"n"}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":0},"indices":1},)"
         R"({"attributes":{"POSITION":0},"indices":2,"mode":1},{"attributes":{"POSITION":0},"indices":3,"mode":0}]}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3"},)" +
         accessor(0, 6) + "," + accessor(6, 2) + "," + accessor(8, 1) +
         R"(],"bufferViews":[{"buffer":0,"byteLength":72},{"buffer":0,"byteOffset":72,"byteLength":)" +
         std::to_string(9 * index_size) + R"(}],"buffers":[{)" + uri + R"("byteLength":)" + offset(9) + "}]}";
}

template <class Index>
std::string gltf_buffer() {
  std::string bytes;
  for (const double x : kFloats) bytes += bytes_of(static_cast<float>(x), std::endian::little);
  for (const int i : {0, 1, 2, 0, 2, 3, 3, 4, 5}) bytes += bytes_of(static_cast<Index>(i), std::endian::little);
  return bytes;
}

Sample gltf_embedded() {
  const std::string uri =
      R"("uri":"data:application/octet-stream;base64,)" + base64(gltf_buffer<std::uint32_t>()) + "\",";
  return {"mesh.gltf", gltf_json(5125, 4, uri), true, true, true};
}

Sample gltf_binary() {
  return {"mesh.glb", glb(gltf_json(5121, 1, ""), gltf_buffer<std::uint8_t>()), true, true, true};
}

Sample gltf_of_short_indices() {
  return {"short.glb", glb(gltf_json(5123, 2, ""), gltf_buffer<std::uint16_t>()), true, true, true};
}

}  // namespace

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::invalid_argument("nothing to replace: " + from);
  return text.replace(at, from.size(), to);
}

std::string glb(std::string json, std::string buffer) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
  const auto number = [](std::size_t n) { return bytes_of(static_cast<std::uint32_t>(n), std::endian::little); };
  return "glTF" + number(2) + number(28 + json.size() + buffer.size()) + number(json.size()) + "JSON" + json +
         number(buffer.size()) + std::string("BIN\0", 4) + buffer;
}

std::string decimal(double value) {
  std::array<char, 40> text;
  const int size = std::snprintf(text.data(), text.size(), "%.17g", value);
  return {text.data(), static_cast<std::size_t>(size)};
}

std::vector<Sample> mesh_samples() {
  std::vector<Sample> samples = {obj(),
                                 obj_of_windows(),
                                 ply_text(),
                                 ply_binary(std::endian::little, false),
                                 ply_binary(std::endian::big, false),
                                 ply_binary(std::endian::little, true),
                                 ply_binary(std::endian::big, true),
                                 vtk_text(),
                                 vtk_grid(),
                                 vtk_binary(),
                                 vtk_offsets(),
                                 vtk_offsets_text(),
                                 off(),
                                 off_of_colours(),
                                 msh2(),
                                 msh4(),
                                 gltf_embedded(),
                                 gltf_binary(),
                                 gltf_of_short_indices()};
  const std::vector<Sample> more = vtk_xml_samples();
  samples.insert(samples.end(), more.begin(), more.end());
  return samples;
}

std::string npy(std::string_view descr, bool fortran, std::string_view shape, const std::string& values, int version) {
  std::string header = "{'descr': '" + std::string(descr) + "', 'fortran_order': " + (fortran ? "True" : "False") +
                       ", 'shape': " + std::string(shape) + ", }";
  header.resize((header.size() + 64) / 64 * 64, ' ');
  header.back() = '\n';
  const std::string length = version == 1 ? bytes_of(static_cast<std::uint16_t>(header.size()), std::endian::little)
                                          : bytes_of(static_cast<std::uint32_t>(header.size()), std::endian::little);
  return "\x93NUMPY" + std::string{static_cast<char>(version), '\0'} + length + header + values;
}

Sample npy_sample() {
  return {"array.npy", npy("<f8", false, "(6, 3)", all_bytes<double>(kDoubles, std::endian::little)), false, false,
          true};
}

}  // namespace touchstone::tests
