// What the readers refuse, and the line that their messages name.
// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <touchstone/error.hpp>

#include "frames/frame.hpp"
#include "frames/samples.hpp"
#include "io/temporary_folder.hpp"
#include "support/catch.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

struct Fault {
  std::string name;
  std::string content;
  std::string message;  ///< a part of it; it starts with ":LINE: " or ": "
};

Sample sample_called(const std::string& name) {
  for (const Sample& sample : mesh_samples()) {
    if (sample.name == name) return sample;
  }
  FAIL("no sample " + name);
  return {};
}

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::vector<Fault> obj_faults() {
  return {
      {"a.obj", "", ": has no vertex"},
      {"a.obj", "# nothing\n", ": has no vertex"},
      {"a.obj", "v 0 0\n", ":1: the line ends before z of a vertex"},
      {"a.obj", "v 0 0 0\nvt 0 0 f 1 1 1\n", ":2: 'f' after 'vt', where a number should be"},
      {"a.obj", "v 0 0 0\nvn nan 0 \\\nf 1 1 1\n", ":3: 'f' after 'vn'"},
      {"a.obj", "v 0 0", ":1: the file ends before z of a vertex"},
      {"a.obj", "v 0 0 nan\n", ":1: z of a vertex: 'nan' is no finite number"},
      {"a.obj", "v 0 0 -inf\n", ":1: z of a vertex: '-inf' is no finite number"},
      {"a.obj", "v 0 1e400 0\n", ":1: y of a vertex: '1e400' is beyond the greatest double"},
      {"a.obj", "v 0 1e-400 0\n", ":1: y of a vertex: '1e-400' is closer to 0 than any double"},
      {"a.obj", "v 0 1e+-4 0\n", ":1: y of a vertex: '1e+-4' is no finite number"},
      {"a.obj", "v 0 +-4 0\n", ":1: y of a vertex: '+-4'"},
      {"a.obj", "v 0 1,5 0\n", ":1: y of a vertex: '1,5' is no finite number"},
      {"a.obj", "v 0 0 0 1 1\n", ":1: a vertex has 5 numbers"},
      {"a.obj", "v 0 0 0 1 1 1 1 1\n", ":1: a vertex has 8 numbers"},
      {"a.obj", kTriangle + "f 1 2\n", ":4: face 1 has 2 corners"},
      {"a.obj", kTriangle + "f 1 2 3\nf\n", ":5: face 2 has 0 corners"},
      {"a.obj", kTriangle + "f 0 1 2\n", ":4: vertex 0 does not exist"},
      {"a.obj", kTriangle + "\nf 1 2 4\n", ":5: vertex 4 does not exist: the vertices have the numbers 1 to 3"},
      {"a.obj", kTriangle + "f 1 2 -4\n", ":4: vertex -4 counts backwards"},
      {"a.obj", kTriangle + "f 1 2 99999999999999999999\n", ":4: a vertex: '99999999999999999999' is no integer"},
      {"a.obj", kTriangle + "f 1 2 4294967296\n", ":4: vertex 4294967296"},
      {"a.obj", kTriangle + "f 1 2 3x\n", ":4: a vertex: '3x' is no integer"},
      {"a.obj", kTriangle + "f 1 2 3/\n", ":4: the line ends before the texture of a corner"},
      {"a.obj", kTriangle + "f 1 2 3/1/1/1\n", ":4: the normal of a corner"},
      {"a.obj", kTriangle + "f 1 2 3.0\n", ":4: a vertex: '3.0' is no integer"},
      {"a.obj", kTriangle + "l 1\n", ":4: a line has two vertices"},
      {"a.obj", kTriangle + "p\n", ":4: a point has a vertex"},
      {"a.obj", kTriangle + "polygon 1 2 3\n", ":4: 'polygon' is no keyword"},
      {"a.obj", kTriangle + "surf 0 1\n", ":4: 'surf' is about free-form"},
      {"a.obj", kTriangle + "g a\\\nv 1 1 1\n", ":4: a name ends with a backslash"},
      {"a.obj", kTriangle + std::string("\0\n", 2), ":4: '\\x00' is no keyword"},
      {"a.obj", "v 0 0 0\\\n 1\nv 1 0\n", ":3: the line ends"},
  };
}

std::vector<Fault> ply_faults() {
  const std::string text = sample_called("text.ply").content;
  const std::string binary = sample_called("little.ply").content;
  return {
      {"a.ply", "", ":1: is no PLY file"},
      {"a.ply", "plywood\n", ":1: is no PLY file"},
      {"a.ply", replaced(text, "ascii 1.0", "ascii 1.1"), ":2: format 'ascii 1.1'"},
      {"a.ply", replaced(text, "format ascii 1.0\n", ""), ":17: the header has no 'format'"},
      {"a.ply", text.substr(0, text.find("end_header")), "the file ends before 'end_header'"},
      {"a.ply", replaced(text, "property double z\n", ""), ": element 'vertex' has no property 'z'"},
      {"a.ply", replaced(text, "property double z", "property list int double z"),
       "is a list, and should be one number"},
      {"a.ply", replaced(text, "property double z", "property half z"), ":8: 'half' is no type"},
      {"a.ply", replaced(text, "property double z", "property double y"), ":8: property 'y' is there twice"},
      {"a.ply", replaced(text, "uchar int vertex_indices", "float int vertex_indices"), "type of integers"},
      {"a.ply", replaced(text, "uchar int vertex_indices", "uchar float vertex_indices"), "type of integers"},
      {"a.ply", replaced(text, "vertex_indices", "corners"), "has no property 'vertex_index'"},
      {"a.ply", replaced(text, "element face", "element faces"), ": element 'faces' has the property 'vertex_indices'"},
      {"a.ply", replaced(text, "element edge", "element Edge"), ": element 'Edge' has the property 'vertex1'"},
      {"a.ply",
       replaced(text, "other 1\nproperty list int float a", "material 1\nproperty list int float vertex_indices"),
       ": element 'material' has the property 'vertex_indices'"},
      {"a.ply", replaced(text, "list int float a", "float vertex1"), ": element 'other' has the property 'vertex1'"},
      {"a.ply", replaced(text, "list int float a", "list int int a"),
       ": element 'other' has the property 'a', which may"},
      {"a.ply", replaced(text, "property list int float a", "property int a\nproperty uchar b"),
       ": element 'other' has the property 'b', which may be a number of a vertex"},
      {"a.ply", replaced(text, "element vertex 6", "element vertex 6000000000"), "is too short for them"},
      {"a.ply", replaced(text, "element vertex 6", "element vertex -6"), ":4: a number of elements is negative"},
      {"a.ply", replaced(text, "element vertex 6", "element vertex 5"), ":24: vertex 7 does not exist"},
      {"a.ply", replaced(text, "element vertex 6", "element vertex 7"), ":25: the line ends before more"},
      {"a.ply", replaced(text, "element edge", "element face"), ":13: element 'face' is there twice"},
      {"a.ply", replaced(text, "element other 1\nproperty list int float a", "element other 1"), "has no property"},
      {"a.ply", replaced(text, "3 0 2 3 5\n", "3 0 2 6 5\n"), ":27: vertex 6 does not exist"},
      {"a.ply", replaced(text, "3 0 2 3 5\n", "-3 0 2 3 5\n"), ":27: a list has -3 items"},
      {"a.ply", replaced(text, "3 0 2 3 5\n", "4 0 2 3 4 5\n"), ":27: face 1 has 4 corners"},
      {"a.ply", text + "1\n", ":30: '1' follows the last element"},
      {"a.ply", replaced(text, "0.5 nan", "0.5"), ":19: the line ends before more"},
      {"a.ply", binary.substr(0, binary.size() - 1), ": ends before the last element"},
      {"a.ply", binary + "x", ": 1 bytes follow the last element"},
      {"a.ply", replaced(binary, "element edge", "element tristrips"), "strips of triangles"},
  };
}

std::vector<Fault> stl_faults() {
  const std::string start = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
  const std::string rest = "endloop\nendfacet\nendsolid\n";
  return {
      {"a.stl", "", ": has no facet"},
      {"a.stl", "solid\nendsolid\n", ": has no facet"},
      {"a.stl", "v 0 0 0\n", ":1: 'v' where 'solid' should be"},
      {"a.stl", start + rest, ":6: 'endloop' where 'vertex' should be"},
      {"a.stl", start + "vertex 0 1 0\nvertex 1 1 0\n" + rest, ":7: a facet has three vertices"},
      {"a.stl", start + "vertex 0 nan 0\n" + rest, ":6: a coordinate: 'nan' is no finite number"},
      {"a.stl", start + "vertex 0 1\n" + rest, ":7: a coordinate: 'endloop' is no finite number"},
      {"a.stl", start + "vertex 0 1 0\nendloop\nendfacet\n", "the file ends where 'facet' or 'endsolid'"},
      {"a.stl", start + "vertex 0 1 0\n" + rest + "junk", ":10: 'junk' where 'solid' should be"},
      {"a.stl", std::string(84, '\0'), ": is a binary STL file without a facet"},
      {"a.stl", std::string(80, '\0') + std::string("\1\0\0\0", 4) + std::string(49, '\0'),
       ": is no STL file: it is not text, and a binary file of 1 facets has 134 bytes, not 133"},
      {"a.stl", std::string(80, '\0') + std::string("\1\0\0\0", 4) + std::string(50, '\xFF'),
       ": facet 0 has a corner that is not finite"},
  };
}

std::vector<Fault> vtk_faults() {
  const std::string text = sample_called("text.vtk").content;
  const std::string grid = sample_called("grid.vtk").content;
  const std::string binary = sample_called("binary.vtk").content;
  const std::string offsets = sample_called("offsets_text.vtk").content;
  return {
      {"a.vtk", "", ":1: is no legacy VTK file"},
      {"a.vtk", "<?xml version=\"1.0\"?>\n", ":1: is no legacy VTK file"},
      {"a.vtk", replaced(text, "3.0", "1.0"), ":1: version '1.0'"},
      {"a.vtk", replaced(text, "ASCII", "TEXT"), ":3: 'TEXT' where ASCII or BINARY"},
      {"a.vtk", replaced(text, "POLYDATA", "STRUCTURED_GRID"), ":4: DATASET 'STRUCTURED_GRID'"},
      {"a.vtk", text.substr(0, text.find("FIELD")), ": has no POINTS"},
      {"a.vtk", replaced(text, "POINTS 6 double", "POINTS 6 int"), "points of type 'int'"},
      {"a.vtk", replaced(text, "POINTS 6 double", "POINTS 600 double"), "too short"},
      {"a.vtk", replaced(text, "POINTS 6 double", "POINTS 7 double"), "'METADATA' is no finite number"},
      {"a.vtk", replaced(text, "POINTS 6 double", "POINTS 5 double"), "where VERTICES, LINES, POLYGONS"},
      {"a.vtk", replaced(text, "3 0 1 2 3 0", "2 0 1 4 0 2").replace(text.find("POLYGONS"), 8, "TRIANGLE_STRIPS"),
       ": strip 0 has 2 corners; a strip of triangles has three or more"},
      {"a.vtk", replaced(text, "POLYGONS", "LINES"), "'LINES' where VERTICES"},
      {"a.vtk", text + "LINES 1 3\n2 0 1\n", "'LINES' after the data of points or cells"},
      {"a.vtk", grid + "\ncells 1 4\n3 0 1 2", "'cells' after the data of points or cells"},
      {"a.vtk", replaced(text, "3 0\n2 3\n", "3 0\n2 6\n"), "vertex 6 does not exist"},
      {"a.vtk", replaced(text, "3 0\n2 3\n", "3 0\n2 -1\n"), "vertex -1 does not exist"},
      {"a.vtk", replaced(text, "POLYGONS 2 8", "POLYGONS 2 9"), "integers fewer"},
      {"a.vtk", replaced(text, "POLYGONS 2 8", "POLYGONS 2 7"), "more integers than the section announces"},
      {"a.vtk", replaced(text, "3 0\n2 3\n", "3 0\n2 3.5\n"), "'3.5' is no integer"},
      {"a.vtk", replaced(text, "NAMES 2 2 int", "NAMES 2 2 string"), "type 'string', which is not read"},
      {"a.vtk", replaced(grid, "\n5 7\n3\n1\n", "\n5 12\n3\n1\n"), ": cell 1 has the type 12"},
      {"a.vtk", replaced(grid, "\n5 7\n3\n1\n", "\n5 10\n3\n1\n"), ": cell 1 of type 10 has 3 corners; right are 4"},
      {"a.vtk", replaced(grid, "\n5 7\n3\n1\n", "\n3 7\n3\n1\n"), ": cell 0 of type 3 has 3 corners"},
      {"a.vtk", grid.substr(0, grid.find("CELL_TYPES")), "4 CELLS and 0 CELL_TYPES"},
      {"a.vtk", binary.substr(0, binary.size() - 3), "announces 8 items, and is too short"},
      {"a.vtk", replaced(offsets, "0 3 6\n", "0 7 6\n"), "offset 1 is 7"},
      {"a.vtk", replaced(offsets, "0 3 6\n", "0 3 5\n"), "the last offset is 5"},
      {"a.vtk", replaced(offsets, "0 3 6\n", "1 3 6\n"), "offset 0 is 1"},
      {"a.vtk", replaced(offsets, "CONNECTIVITY int", "CONNECTIVITY float"), "type 'float'"},
  };
}

std::vector<Fault> off_faults() {
  const std::string text = sample_called("colours.off").content;
  return {
      {"a.off", "", ": is empty"},
      {"a.off", "# only\n", ": is empty"},
      {"a.off", "OFX\n", ":1: begins with 'OFX'; right are OFF, COFF"},
      {"a.off", "OFF BINARY\n", ":1: the number of vertices: 'BINARY' is no integer"},
      {"a.off", "OFF\n", "the file ends before the number of vertices"},
      {"a.off", "OFF\n-1 0 0\n", ":2: the number of vertices is negative"},
      {"a.off", replaced(text, "6 4 0", "7 4 0"), "the file ends before the last face"},
      {"a.off", replaced(text, "6 4 0", "6 5 0"), "the file ends before the last face"},
      {"a.off", replaced(text, "6 4 0", "6 3 0"), "more lines than 6 vertices and 3 faces"},
      {"a.off", replaced(text, "6 4 0", "600 4 0"), "announces 600 items, and is too short"},
      {"a.off", replaced(text, " 255 0 0 255", " 255 red"), "'red' is no finite number"},
      {"a.off", replaced(text, "3 0 2 3", "3 0 2 6"), "vertex 6 does not exist"},
      {"a.off", replaced(text, "3 0 2 3", "3 0 -2 3"), "vertex -2 does not exist"},
      {"a.off", replaced(text, "3 0 2 3", "4 0 2 3 1"), "face 1 has 4 corners"},
      {"a.off", replaced(text, "3 0 2 3", "5 0 2 3 1"), "the line ends before a corner of a face"},
      {"a.off", replaced(text, "3 0 2 3", "0"), "a face of 0 corners"},
  };
}

std::vector<Fault> msh_faults() {
  const std::string text = sample_called("two.msh").content, blocks = sample_called("four.msh").content;
  return {
      {"a.msh", "", ": has no $Elements"},
      {"a.msh", "ply\n", ":2: 'ply' where a section should be"},
      {"a.msh", "$Nodes\n", "$MeshFormat is not the first section"},
      {"a.msh", replaced(text, "2.2", "2.1"), "version '2.1'; 2.2 and 4.1 are read"},
      {"a.msh", replaced(text, "2.2 0", "2.2 1"), "a binary file"},
      {"a.msh", replaced(text, "$EndNodes", "$EndNode"), "'$EndNode' where $EndNodes should be"},
      {"a.msh", replaced(text, "$NodeData", "$Nodedata"), "the section 'Nodedata' is not known"},
      {"a.msh", replaced(text, "$EndNodeData", ""), "the file ends before $EndNodeData"},
      {"a.msh", text.substr(0, text.find("$Elements")), "has no $Elements"},
      {"a.msh", replaced(text, "$Nodes\n6", "$Nodes\n7"), "'$EndNodes' is no integer"},
      {"a.msh", replaced(text, "$Nodes\n6", "$Nodes\n600"), ":9: announces 600 items, and is too short"},
      {"a.msh", replaced(text, "\n8 ", "\n7 "), "node 7 is there twice"},
      {"a.msh", replaced(text, "1 7 8 9\n", "1 7 8 13\n"), "node 13 does not exist"},
      {"a.msh", replaced(text, "0 2 2 1 1 7", "-1 2 2 1 1 7"), "element -1: numbers are from 0"},
      {"a.msh", replaced(text, "0 2 2 1 1 7", "0 5 2 1 1 7"), "element 0 has the type 5; 1 to 4 and 15 are read"},
      {"a.msh", replaced(blocks, "2 1 0 6\n", "2 1 1 6\n"), "parametric nodes are not read"},
      {"a.msh", replaced(blocks, "3 4 0 3\n", "2 4 0 3\n"), "where $EndElements should be"},
      {"a.msh", text + "$Nodes\n", "$Nodes are there twice"},
  };
}

std::vector<Fault> npy_faults() {
  const std::string good = npy_sample().content;
  const std::string nan = bytes_of(std::bit_cast<double>(~std::uint64_t{0}), std::endian::little);
  return {
      {"a.npy", "", ": ends too early"},
      {"a.npy", "v 0 0 0\n#####", ": is no .npy file"},
      {"a.npy", good.substr(0, 40), ": ends too early"},
      {"a.npy", good.substr(0, good.size() - 1),
       ": an array of shape (6, 3) has 18 values of 8 bytes, and the file has 143"},
      {"a.npy", good + "x", "the file has 145 bytes"},
      {"a.npy", replaced(good, "(6, 3)", "(9, 2,"), "where an extent should be"},
      {"a.npy", replaced(good, "(6, 3)", "(3, 6)"), "shape (3, 6); positions have the shape"},
      {"a.npy", replaced(good, "(6, 3)", "(18,) "), "shape (18,); positions have the shape"},
      {"a.npy", npy("<f8", false, "(0, 3)", ""), "shape (0, 3); positions"},
      {"a.npy", npy("<f8", false, "(0, 4, 3)", ""), "shape (0, 4, 3); positions"},
      {"a.npy", npy("<f8", false, "(999999999999999999, 999999999999999999, 3)", ""), "more than 2^64 values"},
      {"a.npy", npy("<f8", false, "(1000000000, 3)", nan), "has 3000000000 values"},
      {"a.npy", replaced(good, "<f8", "<c8"), "has the type '<c8'"},
      {"a.npy", replaced(good, "<f8", "<i8"), "holds integers"},
      {"a.npy", replaced(good, "'<f8'", "[('x"), "describes records"},
      {"a.npy", replaced(good, "fortran", "fartran"), "has the key 'fartran_order'"},
      {"a.npy", replaced(good, "False", "Wrong"), "where True or False"},
      {"a.npy", replaced(good, "'shape': (6, 3), }", "                  "), "where ''' should be"},
      {"a.npy", replaced(good, "\1", "\4"), "of version 4.0"},
      {"a.npy", npy("<f8", false, "(1, 3)", nan + nan + nan),
       ": vertex 0 of frame 0 has a coordinate that is not finite"},
  };
}

std::vector<Fault> gltf_faults() {
  const std::string good = sample_called("mesh.gltf").content, binary = sample_called("mesh.glb").content;
  const auto changed = [&](const std::string& from, const std::string& to) {
    return Fault{"a.gltf", replaced(good, from, to), ""};
  };
  std::vector<Fault> faults = {
      {"a.gltf", "", ": no JSON"},
      {"a.gltf", "[]", ": the file"},
      {"a.gltf", "{}", "asset"},
      {"a.glb", binary.substr(0, 19), "its header is another one"},
      {"a.glb", binary + "x", "and says that it has"},
      {"a.glb", replaced(binary, "JSON", "JSOX"), "does not begin with its JSON"},
  };
  const auto add = [&](const std::string& from, const std::string& to, const std::string& message) {
    faults.push_back(changed(from, to));
    faults.back().message = message;
  };
  add("\"2.0\"", "\"1.0\"", "asset.version: must be 2.x");
  add("\"scene\":0", "\"scene\":1", "scene: ");
  add("\"scenes\"", "\"scenery\"", "has no scenes: it shows nothing");
  add("{\"nodes\":[0]}", "{\"nodes\":[0,0]}", "scenes[0].nodes[1]: is a node that is in the scene already");
  add("\"mesh\":0,\"name\"", "\"children\":[0],\"name\"",
      "nodes[0].children[0]: is a node that is in the scene already");
  add("\"mesh\":0", "\"mesh\":0,\"skin\":0", "has a skin");
  add("\"mesh\":0", "\"mesh\":0,\"weights\":[0,0.5]", "nodes[0].weights[1]: is that of a morph target");
  add("\"mesh\":0", "\"mesh\":0,\"rotation\":[0,0,0,0]", "nodes[0].rotation: is no quaternion");
  add("\"mesh\":0", "\"mesh\":0,\"scale\":[1e300,1,1],\"translation\":[1e308,1e308,0]", "not finite");
  add("\"mesh\":0", "\"mesh\":0,\"matrix\":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]", "the last row 0 0 0 1");
  add("\"mesh\":0", "\"mesh\":7", "nodes[0].mesh");
  add("\"POSITION\":0", "\"POSITIONS\":0", "POSITION");
  add("\"mode\":1", "\"mode\":7", "mode");
  add("\"indices\":2,\"mode\":1", "\"indices\":3,\"mode\":1", "has 1 indices, which do not make whole elements");
  add("5126", "5125", "accessors[0].componentType: must be 5126");
  add("VEC3", "VEC2", "accessors[0].type: must be VEC3");
  add("\"count\":6", "\"count\":7", "accessors[0]: reaches beyond its buffer view");
  add("\"count\":6", "\"count\":5", "has the index 5 of 5 positions");
  add("\"count\":6", "\"count\":6,\"sparse\":{}", "is sparse or compressed");
  add("\"byteLength\":72", "\"byteLength\":720", "bufferViews[0]: reaches beyond its buffer");
  add("\"byteLength\":72", "\"byteLength\":72,\"byteStride\":8", "its stride is none");
  add("\"byteLength\":108", "\"byteLength\":109", "must have 109 bytes, and has 108");
  add(";base64,", ";base65,", "must be data:...;base64");
  for (const char* const junk : {"?", "A", " AAA", "AA==", "\\n"}) {
    add(";base64,", std::string(";base64,") + junk, "must be data:...;base64");
  }
  add("data:application", "http:application", "must be the name of a file beside");
  add("data:application", "../x", "must be the name of a file beside");
  add("\"buffers\"", "\"buffer\"", "bufferViews[0].buffer: is an index into a list without items");
  add("\"mesh\":0,", "\"mesh\":0,\"extensions\":{\"EXT_mesh_gpu_instancing\":{}},",
      "EXT_mesh_gpu_instancing is not read");
  add("{\"asset\"", "{\"extensionsRequired\":[\"KHR_draco_mesh_compression\"],\"asset\"",
      "is an extension that is not read");
  return faults;
}

}  // namespace

TEST_CASE("each fault is an error with its place and reason, on one line") {
  const TemporaryFolder folder;
  std::vector<Fault> faults;
  for (const auto& list : {obj_faults(), ply_faults(), stl_faults(), vtk_faults(), off_faults(), msh_faults(),
                           npy_faults(), gltf_faults()}) {
    faults.insert(faults.end(), list.begin(), list.end());
  }
  for (const Fault& fault : faults) {
    const std::string file = folder.write(fault.name, fault.content);
    CAPTURE(fault.name, fault.content, fault.message);
    try {
      frames::read_frame(file, 0, {});
      FAIL_CHECK("no error");
    } catch (const FileError& error) {
      const std::string what = error.what();
      REQUIRE(what.starts_with(file + ':'));
      const std::string rest = what.substr(file.size());
      CAPTURE(rest);
      CHECK((fault.message.front() == ':' ? rest.starts_with(fault.message)
                                          : rest.find(fault.message) != std::string::npos));
      CHECK(what.find('\n') == std::string::npos);
    }
  }
  CHECK(faults.size() > 100);
}

TEST_CASE("options that say nothing about a file are refused") {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.obj", kTriangle);
  frames::ReadOptions options;
  options.dataset = "x";
  CHECK_THROWS_AS(frames::read_frame(file, 0, options), FileError);
  CHECK_THROWS_AS(frames::frame_count(file, options), FileError);
  CHECK_THROWS_AS(frames::frame_count(folder.path("none.obj"), {}), FileError);
  CHECK_THROWS_AS(frames::frame_count(folder.path("none.npy"), {}), FileError);
  CHECK_THROWS_AS(frames::read_frame(folder.path(""), 0, {}), FileError);
}
