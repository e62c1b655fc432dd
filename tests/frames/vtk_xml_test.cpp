// VTK's XML files: what is in them, and what is refused. The files of mesh_samples() are checked by formats_test.cpp.
// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <touchstone/error.hpp>

#include "frames/frame.hpp"
#include "frames/vtk_xml_samples.hpp"
#include "io/temporary_folder.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

using Faces = std::vector<std::array<MeshIndex, 3>>;
using Edges = std::vector<std::array<MeshIndex, 2>>;
using Indices = std::vector<MeshIndex>;

std::string array_of(const std::string& attributes, const std::string& values) {
  return "<DataArray type=\"" + attributes + "\">" + values + "</DataArray>";
}

std::string list_of(const std::string& name, const std::string& corners, const std::string& ends,
                    const std::string& more = {}) {
  return "<" + name + ">" + array_of("Int32\" Name=\"connectivity", corners) +
         array_of("Int32\" Name=\"offsets", ends) + more + "</" + name + ">";
}

const std::string kFivePoints =
    "<Points>" + array_of("Float64\" NumberOfComponents=\"3", "0 0 0 1 0 0 0 1 0 0 0 1 1 1 1") + "</Points>";

std::string grid_piece(int cells, const std::string& corners, const std::string& ends, const std::string& types) {
  return "<Piece NumberOfPoints=\"5\" NumberOfCells=\"" + std::to_string(cells) + "\">" + kFivePoints +
         list_of("Cells", corners, ends, array_of("UInt8\" Name=\"types", types)) + "</Piece>";
}

std::string file_of(const std::string& data_set, const std::string& pieces) {
  return "<VTKFile type=\"" + data_set + "\"><" + data_set + ">" + pieces + "</" + data_set + "></VTKFile>";
}

std::string grid(int cells, const std::string& corners, const std::string& ends, const std::string& types) {
  return file_of("UnstructuredGrid", grid_piece(cells, corners, ends, types));
}

std::shared_ptr<const frames::Topology> topology_of(const std::string& name, const std::string& content,
                                                    bool triangulate = false) {
  const TemporaryFolder folder;
  frames::ReadOptions options;
  options.triangulate = triangulate;
  return frames::read_frame(folder.write(name, content), 0, options).topology;
}

/// The message behind the name of the file.
std::string fault_of(const std::string& content) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.vtu", content);
  try {
    frames::read_frame(file, 0, {});
  } catch (const FileError& error) {
    const std::string what = error.what();
    CHECK(what.find('\n') == std::string::npos);
    return what.substr(file.size());
  }
  return "none";
}

template <class Index>
void check_width(const std::string& type, std::endian order, bool appended) {
  CAPTURE(type, appended);
  XmlWriter writer({order, 4, 0, appended, false, false});
  const std::string attributes = "type=\"" + type + "\" Name=";
  std::string piece = "<Piece NumberOfPoints=\"3\" NumberOfCells=\"2\"><Points>" +
                      writer.numbers<float>("type=\"Float32\" NumberOfComponents=\"3\"",
                                            std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0});
  piece += "</Points><Cells>" + writer.numbers<Index>(attributes + "\"connectivity\"", Indices{2, 1, 0, 1, 2});
  piece += writer.numbers<Index>(attributes + "\"offsets\"", Indices{3, 5});
  piece += writer.numbers<Index>(attributes + "\"types\"", Indices{5, 3}) + "</Cells></Piece>";
  const auto topology = topology_of("a.vtu", writer.file("UnstructuredGrid", piece));
  CHECK(topology->faces == Faces{{2, 1, 0}});
  CHECK(topology->edges == Edges{{1, 2}});
}

}  // namespace

TEST_CASE("integers of a VTK XML file have any width and byte order") {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    for (const bool appended : {false, true}) {
      check_width<std::int8_t>("Int8", order, appended);
      check_width<std::uint8_t>("UInt8", order, appended);
      check_width<std::int16_t>("Int16", order, appended);
      check_width<std::uint16_t>("UInt16", order, appended);
      check_width<std::int32_t>("Int32", order, appended);
      check_width<std::uint32_t>("UInt32", order, appended);
      check_width<std::int64_t>("Int64", order, appended);
      check_width<std::uint64_t>("UInt64", order, appended);
    }
  }
}

TEST_CASE("cells of a VTK XML file are those that the legacy format has") {
  struct Cell {
    std::string corners, type;
  };
  const std::vector<Cell> cells = {{"4", "1"},       {"0 3", "2"},     {"0 1", "3"},
                                   {"0 1 4", "4"},   {"0 1 2", "5"},   {"0 1 2 3 4", "6"},
                                   {"1 2 3 4", "7"}, {"0 1 4 2", "9"}, {"0 1 2 3", "10"}};
  std::string corners, ends, types, legacy;
  int count = 0;
  for (const Cell& cell : cells) {
    const auto size = static_cast<int>(cell.corners.size() / 2 + 1);
    corners += cell.corners + ' ';
    ends += std::to_string(count += size) + ' ';
    types += cell.type + '\n';
    legacy += std::to_string(size) + ' ' + cell.corners + '\n';
  }
  const std::string start =
      "# vtk DataFile Version 3.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 double\n"
      "0 0 0 1 0 0 0 1 0 0 0 1 1 1 1\nCELLS 9 ";
  const auto expected =
      topology_of("a.vtk", start + std::to_string(count + 9) + '\n' + legacy + "CELL_TYPES 9\n" + types, true);
  const auto found = topology_of("a.vtu", grid(9, corners, ends, types), true);
  CHECK(*found == *expected);
  CHECK(found->points == Indices{4, 0, 3});
  CHECK(found->edges == Edges{{0, 1}, {0, 1}, {1, 4}});
  const Faces faces = {{0, 1, 2}, {0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {1, 2, 3}, {1, 3, 4}, {0, 1, 4}, {0, 4, 2}};
  CHECK(Faces(found->faces.begin(), found->faces.begin() + 8) == faces);
  CHECK(Indices(found->face_numbers.begin(), found->face_numbers.begin() + 8) == Indices{4, 5, 5, 5, 6, 6, 7, 7});
  CHECK_THAT(fault_of(grid(9, corners, ends, types)),
             Catch::Contains("face 6 has 4 corners") && Catch::Contains("--triangulate"));
}

TEST_CASE("faces of poly data count polygons, then strips, in XML and in the legacy format") {
  const std::string piece =
      "<Piece NumberOfPoints=\"5\" NumberOfStrips=\"1\" NumberOfPolys=\"1\" NumberOfVerts=\"1\">" + kFivePoints +
      list_of("Strips", "0 1 2 3", "4") + list_of("Polys", "2 3 4", "3") + list_of("Verts", "0 4", "2") + "</Piece>";
  const auto found = topology_of("a.vtp", file_of("PolyData", piece));
  CHECK(found->faces == Faces{{2, 3, 4}, {0, 1, 2}, {1, 3, 2}});
  CHECK(found->face_numbers == Indices{0, 1, 1});
  CHECK(found->points == Indices{0, 4});
  const std::string legacy =
      "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 5 double\n0 0 0 1 0 0 0 1 0 0 0 1 1 1 1\n"
      "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\nPOLYGONS 1 4\n3 2 3 4\nVERTICES 1 3\n2 0 4\n";
  CHECK(*topology_of("a.vtk", legacy) == *found);
}

TEST_CASE("vertices and cells of a later piece are numbered on") {
  const std::string empty = "<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"></Piece>";
  const auto grids = topology_of("a.vtu", file_of("UnstructuredGrid", grid_piece(2, "0 1 0 1 2", "2 5", "3 5") + empty +
                                                                          grid_piece(1, "2 3 4", "3", "5")));
  CHECK(grids->vertex_count == 10);
  CHECK(grids->faces == Faces{{0, 1, 2}, {7, 8, 9}});
  CHECK(grids->face_numbers == Indices{1, 2});
  const std::string poly =
      "<Piece NumberOfPoints=\"5\" NumberOfPolys=\"1\">" + kFivePoints + list_of("Polys", "2 3 4", "3") + "</Piece>";
  const auto lists = topology_of("a.vtp", file_of("PolyData", poly + poly));
  CHECK(lists->faces == Faces{{2, 3, 4}, {7, 8, 9}});
}

TEST_CASE("each fault of a VTK XML file is an error with its line and reason") {
  const std::string good = grid(2, "0 1 2\n2 3 4", "3 6", "5 5");
  CHECK(fault_of(good) == "none");
  struct Fault {
    std::string from, to, message;
  };
  const std::vector<Fault> faults = {
      {"<VTKFile", "<vtkfile", ":1: the element 'vtkfile' where VTKFile should be"},
      {"type=\"UnstructuredGrid\"", "type=\"ImageData\"", ":1: VTKFile of type 'ImageData'"},
      {"type=\"UnstructuredGrid\"", "type=\"PolyData\"", ":1: the element 'UnstructuredGrid' where the data set"},
      {"type=\"UnstructuredGrid\"", "type=\"UnstructuredGrid\" version=\"3.0\"", "version '3.0'"},
      {"type=\"UnstructuredGrid\"", "type=\"UnstructuredGrid\" byte_order=\"PDP\"", "byte_order 'PDP'"},
      {"type=\"UnstructuredGrid\"", "type=\"UnstructuredGrid\" header_type=\"UInt8\"", "header_type 'UInt8'"},
      {"</VTKFile>", "", ":2: is no XML: no element found"},
      {"</VTKFile>", "</VTKFile>junk", ":2: is no XML: "},
      {"</Piece>", "", ":2: is no XML: mismatched tag"},
      {"<Piece", "junk<Piece", "has text where only elements should be"},
      {"<Piece", "<Pieces/><Piece", "the element 'Pieces' where Piece should be"},
      {"<Points>", "<Polys/><Points>", "the element 'Polys' where a list of points or cells should be"},
      {"NumberOfPoints", "NumberOfPoint", "a Piece without NumberOfPoints"},
      {"NumberOfPoints=\"5\"", "NumberOfPoints=\"-5\"", "NumberOfPoints is '-5'; it must be a number from 0 to 2^40"},
      {"NumberOfPoints=\"5\"", "NumberOfPoints=\"5000\"", "a DataArray of 15000 values is too short"},
      {"NumberOfPoints=\"5\"", "NumberOfPoints=\"4\"", "'1' after the last value of a DataArray"},
      {"1 1 1<", "1 1  <", ":1: a DataArray ends before the last of its 15 values"},
      {"NumberOfCells=\"2\"", "NumberOfCells=\"1\"", ":2: '6' after the last value"},
      {"NumberOfComponents=\"3\"", "NumberOfComponents=\"2\"", "has 2 components; right is 3"},
      {"Float64", "Int64", "must have the type Float32 or Float64"},
      {"Float64", "Float16", "a DataArray of type 'Float16', which is not read"},
      {"Float64\"", "Float64\" format=\"hex\"", "a DataArray of format 'hex'"},
      {"0 0 0 1 0 0", "0 0 0 1 0 nan", "'nan' is no finite number"},
      {"0 0 0 1 0 0", "0 0 0 1 0 <b/>", "the element 'b' where the end of the array should be"},
      {"0 0 0 1 0 0", "0 0 0 1 0 &#48;", "'&#48;' is no finite number"},
      {"\"connectivity\"", "\"Connectivity\"", "this Piece has no DataArray of connectivity"},
      {"\"offsets\"", "\"connectivity\"", "this Piece has no DataArray of offsets"},
      {"\"types\"", "\"offsets\"", "a second DataArray of offsets"},
      {"3 6<", "6 3<", "the offset of cell 1 is 3"},
      {"3 6<", "3 7<", "a DataArray"},
      {"3 6<", "3 5<", ":2: '4' after the last value"},
      {"3 6<", "3.0 6<", "'3.0' is no integer"},
      {"3 6<", "3 99999999999999<", ":1: has more than 4"},
      {"2 3 4<", "2 3 5<", "vertex 5 does not exist: the vertices have the numbers 0 to 4"},
      {"2 3 4<", "2 3 -1<", "vertex -1 does not exist"},
      {"5 5<", "5 3<", "cell 1 of type 3 has 3 corners; right are 2"},
      {"5 5<", "5 12<", "cell 1 has the type 12; 1 to 7, 9 and 10 are read"},
      {"5 5<", "5 42<", "cell 1 has the type 42"},
      {"Float64\"", "Float64\" format=\"appended\" offset=\"0\"", "has an offset beyond the appended data"},
      {"Float64\"", "Float64\" format=\"appended\"", "offset is ''"},
      {"Float64\"", "Float64\" format=\"binary\"", "VTKFile has no byte_order"},
  };
  for (const Fault& fault : faults) {
    CAPTURE(fault.from, fault.to, fault.message);
    const std::string found = fault_of(replaced(good, fault.from, fault.to));
    CAPTURE(found);
    CHECK((fault.message.front() == ':' ? found.starts_with(fault.message)
                                        : found.find(fault.message) != std::string::npos));
  }
}

TEST_CASE("a VTK XML file of few bytes cannot stand for a text or for arrays of any length") {
  const std::string good = grid(1, "0 1 2", "3", "5");
  std::string entities = "<!DOCTYPE VTKFile [<!ENTITY a0 \"0 0 0 0 0 0 0 0\">";
  for (int i = 0; i < 20; ++i) {
    entities += "<!ENTITY a" + std::to_string(i + 1) + " \"";
    for (int k = 0; k < 10; ++k) entities += "&a" + std::to_string(i) + ";";
    entities += "\">";
  }
  CHECK_THAT(fault_of(entities + "]>" + replaced(good, "0 0 0", "&a20;")), Catch::Contains("has a DOCTYPE"));
  CHECK_THAT(fault_of("<!DOCTYPE a SYSTEM \"file:///etc/passwd\">" + good), Catch::Contains("has a DOCTYPE"));

  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  CHECK_THAT(fault_of(replaced(good, "<Points>", "<PointData>" + deep + "<Points>")), Catch::Contains("is no XML"));

  // Two pieces whose points are in the same bytes.
  XmlWriter writer({std::endian::little, 4, 0, true, true, false});
  const std::string piece =
      "<Piece NumberOfPoints=\"2\"><Points>" +
      writer.numbers<double>("type=\"Float64\" NumberOfComponents=\"3\"", std::vector<double>(6)) + "</Points></Piece>";
  CHECK(fault_of(writer.file("UnstructuredGrid", piece)) == "none");
  CHECK_THAT(fault_of(writer.file("UnstructuredGrid", piece + piece)),
             Catch::Contains("overlaps another one in the appended data"));
}

TEST_CASE("appended data are cut off, or something else follows them") {
  for (const Sample& sample : vtk_xml_samples()) {
    if (sample.name != "raw.vtu" && sample.name != "appended.vtp") continue;
    CAPTURE(sample.name);
    const std::string& good = sample.content;
    CHECK(fault_of(good) == "none");
    CHECK_THAT(fault_of(replaced(good, "</AppendedData>", "")), Catch::Contains("the file is cut off"));
    CHECK_THAT(fault_of(replaced(good, "</VTKFile>", "")), Catch::Contains("has something else after AppendedData"));
    CHECK_THAT(fault_of(good + "x"), Catch::Contains("has something else after AppendedData"));
    CHECK_THAT(fault_of(replaced(good, "   _", "   ")), Catch::Contains("does not begin with an underscore"));
    CHECK_THAT(fault_of(replaced(good, "encoding=\"", "encoding=\"x")), Catch::Contains("right are raw and base64"));
    CHECK_THAT(fault_of(replaced(good, "NumberOfPoints=\"6\"", "NumberOfPoints=\"7\"")), Catch::Contains("bytes"));
    CHECK_THAT(fault_of(replaced(good, "offset=\"0\"", "offset=\"99999\"")),
               Catch::Contains("has an offset beyond the appended data"));
  }
}

TEST_CASE("values in base64 are refused where they are none, or where there are more or fewer") {
  const std::string point = base64(std::string("\x18\0\0\0", 4)), zeros = base64(std::string(24, '\0'));
  const auto file = [](const std::string& values) {
    return "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\"><UnstructuredGrid><Piece "
           "NumberOfPoints=\"1\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"binary\">" +
           values + "</DataArray></Points></Piece></UnstructuredGrid></VTKFile>";
  };
  CHECK(fault_of(file(point + zeros)) == "none");
  CHECK(fault_of(file(" " + point + "\n" + zeros.substr(0, 5) + "\n" + zeros.substr(5) + "\n")) == "none");
  CHECK(fault_of(file(base64(std::string("\x18\0\0\0", 4) + std::string(24, '\0')))) == "none");
  CHECK_THAT(fault_of(file(point)), Catch::Contains("is too short for the 24 bytes"));
  CHECK_THAT(fault_of(file(point + zeros.substr(4))), Catch::Contains("is too short for the 24 bytes"));
  CHECK_THAT(fault_of(file(point + zeros + "AAAA")), Catch::Contains("has more in base64"));
  CHECK_THAT(fault_of(file(point + replaced(zeros, "AAAA", "A?AA"))), Catch::Contains("is cut off, or no base64"));
  CHECK_THAT(fault_of(file(point + replaced(zeros, "AAAA", "A=AA"))), Catch::Contains("is cut off, or no base64"));
  CHECK_THAT(fault_of(file(point + replaced(zeros, "AAAA", "AA=A"))), Catch::Contains("is cut off, or no base64"));
  CHECK_THAT(fault_of(file("")), Catch::Contains("ends within its header"));
  CHECK_THAT(fault_of(file(base64(std::string("\x19\0\0\0", 4)) + zeros)), Catch::Contains("announces 25 bytes"));
  const std::string nan = base64(std::string(24, '\xFF'));
  CHECK_THAT(fault_of(file(point + nan)), Catch::Contains("has a coordinate that is not finite, of point 0"));
}

TEST_CASE("compressed values of a VTK XML file are exactly as long as they say") {
  const std::endian order = std::endian::little;
  const auto header = [&](std::initializer_list<std::uint64_t> numbers) {
    std::string bytes;
    for (const std::uint64_t number : numbers) bytes += bytes_of(number, order);
    return bytes;
  };
  const auto file = [&](const std::string& values, std::uint64_t points = 1) {
    return "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
           "compressor=\"vtkZLibDataCompressor\"><UnstructuredGrid><Piece NumberOfPoints=\"" +
           std::to_string(points) +
           "\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"appended\" offset=\"0\"/>"
           "</Points></Piece></UnstructuredGrid><AppendedData encoding=\"raw\">_" +
           values + "</AppendedData></VTKFile>";
  };
  const std::string zeros(24, '\0'), block = stored(zeros), half = stored(zeros.substr(12));
  if (!kInflates) {
    CHECK_THAT(fault_of(file(header({1, 24, 0, block.size()}) + block)), Catch::Contains("zlib1g-dev"));
    return skip("this build has no zlib (Debian: zlib1g-dev)");
  }
  CHECK(fault_of(file(header({1, 24, 0, block.size()}) + block)) == "none");
  CHECK(fault_of(file(header({1, 24, 24, block.size()}) + block)) == "none");
  CHECK(fault_of(file(header({1, 100, 24, block.size()}) + block)) == "none");
  CHECK(fault_of(file(header({2, 12, 0, half.size(), half.size()}) + half + half)) == "none");
  const std::string wrong = "has blocks that do not make up the 24 bytes";
  const std::uint64_t huge = ~std::uint64_t{0};
  CHECK_THAT(fault_of(file(header({1, 23, 0, block.size()}) + block)), Catch::Contains(wrong));
  CHECK_THAT(fault_of(file(header({1, 24, 23, block.size()}) + block)), Catch::Contains(wrong));
  CHECK_THAT(fault_of(file(header({1, huge, 0, block.size()}) + block)), Catch::Contains(wrong));
  CHECK_THAT(fault_of(file(header({2, huge, 25, block.size(), 0}) + block)), Catch::Contains(wrong));
  CHECK_THAT(fault_of(file(header({0, 0, 0}))), Catch::Contains(wrong));
  CHECK_THAT(fault_of(file(header({huge, 24, 0}))), Catch::Contains("is too short for its blocks"));
  CHECK_THAT(fault_of(file(header({1, 24, 0, huge}) + block)), Catch::Contains("is too short for its blocks"));
  const std::string broken = "has a block that zlib cannot read";
  CHECK_THAT(fault_of(file(header({1, 24, 0, block.size()}) + replaced(block, "\x78", "\x79"))),
             Catch::Contains(broken));
  CHECK_THAT(fault_of(file(header({1, 24, 0, block.size()}) + stored(zeros.substr(1)) + " ")), Catch::Contains(broken));
  const std::string longer = stored(zeros + ' ');
  CHECK_THAT(fault_of(file(header({1, 24, 0, longer.size()}) + longer)), Catch::Contains(broken));
  CHECK_THAT(fault_of(file(header({1, 24000000, 0, block.size()}) + block, 1000000)),
             Catch::Contains("is too short for the 24000000 bytes"));
  CHECK_THAT(fault_of(file(header({1, 120000000, 0, block.size()}) + block, 5000000)),
             Catch::Contains("vertices, cells and corners, too many for a file of this size"));
  CHECK_THAT(fault_of(replaced(file(header({1, 24, 0, block.size()}) + block), "ZLib", "LZ4")),
             Catch::Contains("has the compressor 'vtkLZ4DataCompressor', which is not read"));
}
