// The meshes of files, as arrays.
// SPDX-License-Identifier: MIT
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>

#include "frames/formats.hpp"
#include "python/background.hpp"
#include "python/define.hpp"
#include "sequence/element_faults.hpp"
#include "sequence/frame_order.hpp"
#include "sequence/repairs.hpp"

namespace touchstone::python {
namespace {

template <class Number, class Rows>
py::array array_of(const Rows& rows, py::ssize_t width) {
  const auto count = static_cast<py::ssize_t>(rows.size() * sizeof(rows[0]) / sizeof(Number));
  if (width == 0) return py::array(py::dtype::of<Number>(), {count}, {}, rows.data());
  return py::array(py::dtype::of<Number>(), {count / width, width}, {}, rows.data());
}

/// What `work` returns. A message names the options of the program; here it names the arguments of Python.
template <class Work>
auto in_words_of_python(const Work& work) {
  try {
    return work();
  } catch (const FileError& error) {
    std::string text = error.what();
    for (const auto& [option, argument] : {std::pair{"--triangulate", "triangulate=True"},
                                           {"--weld", "weld=True"},
                                           {"mesh --drop-degenerate", "drop_degenerate=True"}}) {
      for (std::size_t at = 0; (at = text.find(option, at)) != std::string::npos;) {
        text.replace(at, std::string(option).size(), argument);
      }
    }
    throw FileError(text);
  }
}

/// Reads mesh files and mends them: one, or the frames of one animation.
class MeshReader {
 public:
  using BoundToPython = void;

  MeshReader(bool triangulate, const sequence::RepairOptions& repairs)
      : triangulate_(triangulate), repairs_(repairs, false) {}

  /// (positions, faces, edges, points, parts, face_parts, welded_vertices, dropped_elements)
  py::tuple read(const std::string& file) {
    constexpr std::size_t kLong = std::size_t{1} << 20;  // a thread of its own hears Ctrl-C
    const frames::Frame frame = in_background(
        kLong, [&](const std::atomic<bool>&) { return in_words_of_python([&] { return frame_of(file); }); });
    topology_ = frame.topology;
    const frames::Topology& topology = *topology_;
    return py::make_tuple(array_of<double>(frame.positions, 3), array_of<MeshIndex>(topology.faces, 3),
                          array_of<MeshIndex>(topology.edges, 2), array_of<MeshIndex>(topology.points, 0),
                          topology.parts, array_of<std::uint32_t>(topology.face_parts, 0), topology.welded_vertices,
                          topology.dropped_elements);
  }

  /// @throws FileError  for what Mesh refuses of the elements that were read last, by their numbers in the file
  void check_elements(const std::string& file) const {
    if (topology_) in_words_of_python([&] { sequence::check_elements(*topology_, file); });
  }

 private:
  frames::Frame frame_of(const std::string& file) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) {
      throw FileError(file + ": is a folder; read_frames reads the frames in it");
    }
    const frames::Format format = frames::format_of(file);
    if (format >= frames::Format::npy) {
      throw FileError(file +
                      ": holds positions without elements, which Mesh takes; NumPy and h5py read those of .npy "
                      "and .h5");
    }
    const io::WholeFile content = frames::read_content(file, nullptr);
    frames::MeshFile mesh = frames::read_mesh(format, file, content.bytes(), triangulate_);
    frames::Frame frame{
        std::make_shared<const frames::Topology>(std::move(mesh.topology)), std::move(mesh.positions), {}};
    repairs_.mend(frame, {file});
    return frame;
  }

  bool triangulate_;
  sequence::Repairs repairs_;
  std::shared_ptr<const frames::Topology> topology_;
};

/// The files of patterns and folders, in the order given or that of their numbers.
std::vector<std::string> frame_files(const std::vector<std::string>& names, bool in_order) {
  return in_order ? sequence::as_given(names)
                  : sequence::in_order(sequence::expand_patterns(names), sequence::Gaps::refused,
                                       "in_order=True takes the files in the order given");
}

}  // namespace

void define_mesh_files(py::module_& module) {
  define_class<MeshReader>(module, "MeshReader", "Reads mesh files: one, or the frames of one animation.")
      .def(py::init([](bool triangulate, bool weld, bool drop_degenerate) {
             return MeshReader(triangulate, {weld, false, drop_degenerate});
           }),
           py::arg("triangulate"), py::arg("weld"), py::arg("drop_degenerate"))
      .def("read", &MeshReader::read)
      .def("check_elements", &MeshReader::check_elements);
  module.def("frame_files", &frame_files);
}

}  // namespace touchstone::python
