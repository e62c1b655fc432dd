// The readers of mesh files. Any bytes are a mesh or an error of one line. A mesh that is written as OBJ reads back as
// the same mesh.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <iterator>
#include <string>

#include <touchstone/error.hpp>

#include "frames/formats.hpp"
#include "frames/write_obj.hpp"
#include "targets.hpp"

namespace touchstone::fuzzing {
namespace {

using frames::Format;

constexpr frames::ArrayShape kShape{1, 6, 3};

// The numbers of formats in files of the corpus, which stay as they are. The first byte of an input says the format, and
// whether polygons are cut into triangles.
constexpr Format kFormats[] = {Format::obj, Format::ply, Format::stl,  Format::vtk,    Format::npy,
                               Format::off, Format::msh, Format::gltf, Format::vtk_xml};

template <class Elements>
void check_indices(const Elements& elements, std::size_t vertices) {
  for (const auto& element : elements) {
    for (const MeshIndex vertex : element) {
      if (vertex >= vertices) throw Finding("an element has the vertex " + std::to_string(vertex));
    }
  }
}

void check_topology(const frames::Topology& topology) {
  check_indices(topology.faces, topology.vertex_count);
  check_indices(topology.edges, topology.vertex_count);
  check_indices(std::array{topology.points}, topology.vertex_count);
  if (!topology.face_numbers.empty() && topology.face_numbers.size() != topology.faces.size()) {
    throw Finding("some faces have a number, and some have none");
  }
  if (!topology.face_parts.empty() && topology.face_parts.size() != topology.faces.size()) {
    throw Finding("some faces have a part, and some have none");
  }
  for (const std::uint32_t part : topology.face_parts) {
    if (part >= topology.parts.size()) throw Finding("a face has a part that does not exist");
  }
}

void check_written(const frames::MeshFile& mesh) {
  std::string text;
  frames::append_obj(text, mesh.topology, mesh.positions.data());
  frames::MeshFile again;
  try {
    again = frames::read_obj("written.obj", text, false);
  } catch (const Error& error) {
    throw Finding("what was written does not read back: " + std::string(error.what()) + "\n" + text);
  }
  const bool same = again.positions == mesh.positions && again.topology.faces == mesh.topology.faces &&
                    again.topology.edges == mesh.topology.edges && again.topology.points == mesh.topology.points;
  if (!same) throw Finding("read back it is another mesh:\n" + text);
}

void check_mesh(const frames::MeshFile& mesh) {
  if (mesh.positions.size() != 3 * mesh.topology.vertex_count) throw Finding("not three coordinates for each vertex");
  for (const double x : mesh.positions) {
    if (!std::isfinite(x)) throw Finding("a coordinate is not finite");
  }
  check_topology(mesh.topology);
  check_written(mesh);
}

}  // namespace

void fuzz_mesh_file(Bytes input) {
  if (input.empty()) return;
  const unsigned choice = input.front();
  const std::string_view content = as_text(input.subspan(1));
  const bool triangulate = choice % 2 != 0;
  const Format format = kFormats[choice / 2 % std::size(kFormats)];
  try {
    if (format == Format::npy) {
      check_topology(frames::topology_from("input.npy", content, kShape, triangulate));
    } else {
      check_mesh(frames::read_mesh(format, "input", content, triangulate));
    }
  } catch (const FileError& error) {
    const std::string what = error.what();
    if (what.empty() || what.find('\n') != std::string::npos) throw Finding("the error is not one line: " + what);
  }
}

}  // namespace touchstone::fuzzing
