// The meshes of files, as arrays.
// SPDX-License-Identifier: MIT
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <atomic>
#include <string>
#include <vector>

#include "frames/formats.hpp"
#include "python/background.hpp"
#include "python/define.hpp"

namespace touchstone::python {
namespace {

template <class Number, class Rows>
py::array array_of(const Rows& rows, py::ssize_t width) {
  const auto count = static_cast<py::ssize_t>(rows.size() * sizeof(rows[0]) / sizeof(Number));
  if (width == 0) return py::array(py::dtype::of<Number>(), {count}, {}, rows.data());
  return py::array(py::dtype::of<Number>(), {count / width, width}, {}, rows.data());
}

frames::MeshFile read(const std::string& file, bool triangulate) {
  const frames::Format format = frames::format_of(file);
  if (format >= frames::Format::npy) {
    throw FileError(file +
                    ": holds positions without elements, which Mesh takes; NumPy and h5py read those of .npy and .h5");
  }
  const io::WholeFile content = frames::read_content(file, nullptr);
  return frames::read_mesh(format, file, content.bytes(), triangulate);
}

py::tuple read_mesh_file(const std::string& file, bool triangulate) {
  constexpr std::size_t kLong = std::size_t{1} << 20;  // a thread of its own hears Ctrl-C
  const frames::MeshFile mesh = in_background(kLong, [&](const std::atomic<bool>&) { return read(file, triangulate); });
  const frames::Topology& topology = mesh.topology;
  return py::make_tuple(array_of<double>(mesh.positions, 3), array_of<MeshIndex>(topology.faces, 3),
                        array_of<MeshIndex>(topology.edges, 2), array_of<MeshIndex>(topology.points, 0), topology.parts,
                        array_of<std::uint32_t>(topology.face_parts, 0));
}

}  // namespace

void define_mesh_files(py::module_& module) { module.def("read_mesh_file", &read_mesh_file); }

}  // namespace touchstone::python
