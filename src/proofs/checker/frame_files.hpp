// The frames of a motion beside the mesh files of a person, for the option --frames of touchstone-check.
// SPDX-License-Identifier: MIT
#pragma once

#include "checker/mesh_files.hpp"
#include "checker/motion.hpp"

namespace checker {

/// The files of the frames. The vertices of a frame are those of one file, or of several parts one after the other.
class FrameFiles {
 public:
  /// The files of a part of the mesh. One file, beside other parts, is at rest.
  void add(const std::string& pattern) { sequences_.push_back({files_of(pattern), "", {}}); }

  bool empty() const { return sequences_.empty(); }

  /// ", whose frames are those of the 4 files: a-0.obj to a-2.obj (vertices 0 to 7), b.obj at rest (vertices 8 to 11)"
  std::string summary() const {
    if (empty()) return "";
    std::size_t count = 0, first = 0;
    std::string text;
    for (const Sequence& sequence : sequences_) {
      count += sequence.files.size();
      text += (text.empty() ? " " : ", ") + printable(sequence.files.front());
      if (sequence.files.size() > 1) text += " to " + printable(sequence.files.back());
      if (is_at_rest(sequence)) text += " at rest";
      const std::size_t size = sequence.mesh.positions.size() / 3;
      text += size == 0 ? " (no vertex)" : " (" + vertices(first, first + size - 1) + ")";
      first += size;
    }
    return ", whose frames are those of the " + counted(count, "file", "files") + ":" + text;
  }

  /// @param end  0 for the first frame of the step, 1 for the second one
  /// @throws Rejected unless that frame is its files, bit by bit, and its elements are their triangles, lines and
  /// points, with the sides and corners of these; other vertices may be points, too
  void check_frame(const MotionFile& motion, std::size_t end) {
    if (empty()) return;
    const std::size_t frame = motion.frame_count() - 2 + end;
    if (motion.body_count() > 0) throw Rejected("a motion with bodies has poses; --frames compares vertices");
    const Elements elements(motion);
    Elements of_files;
    std::uint32_t first = 0;
    for (Sequence& sequence : sequences_) {
      if (frame >= sequence.files.size() && !is_at_rest(sequence))
        throw Rejected("the motion has more frames than --frames names files");
      const std::string& file = sequence.files[is_at_rest(sequence) ? 0 : frame];
      if (sequence.name != file) {
        MeshFile mesh = read_mesh(file);
        require(sequence.name.empty() || mesh.positions.size() == sequence.mesh.positions.size(),
                file + ": " + counted(mesh.positions.size() / 3, "vertex", "vertices") + ", and " + sequence.name +
                    " has another number");
        sequence.mesh = std::move(mesh);
      }
      sequence.name = file;
      check_sequence(motion.coordinates(end), elements, sequence, first,
                     file + " and frame " + std::to_string(frame) + ": ", of_files);
      first += static_cast<std::uint32_t>(sequence.mesh.positions.size() / 3);
    }
    const std::string what = "frame " + std::to_string(frame) + ": ";
    require(first == motion.vertex_count(), sequences_.back().name + " and " + what + std::to_string(first) +
                                                " vertices, and " + std::to_string(motion.vertex_count()));
    const auto [corners, sides] = motion.undeclared();
    require(corners == 0, what + counted(corners, "corner is no point", "corners are no points"));
    require(sides == 0, what + counted(sides, "side is no edge", "sides are no edges"));
    // Another edge would take its ends out of the loose points, and another face its sides out of the wires.
    for (const Element& face : motion.elements(2)) {
      require(of_files.faces.count(sorted(face.vertices)) > 0,
              what + "face " + std::to_string(face.number) + " of the motion is none of the files");
    }
    for (const Element& edge : motion.elements(1)) {
      require(of_files.edges.count(side(edge.vertices[0], edge.vertices[1])) > 0,
              what + "edge " + std::to_string(edge.number) + " of the motion is no line of the files and no side");
    }
  }

  /// @throws Rejected if there are more files than frames
  void check_count(std::size_t frames) const {
    for (const Sequence& sequence : sequences_) {
      require(sequence.files.size() <= frames, "--frames names more files than the motion has frames");
    }
  }

 private:
  struct Sequence {
    std::vector<std::string> files;
    std::string name;  ///< of the file that was read last
    MeshFile mesh;
  };

  /// Those of a motion or of its files by their vertices, in ascending order.
  struct Elements {
    std::set<std::array<std::uint32_t, 3>> faces;
    std::set<std::array<std::uint32_t, 2>> edges;
    std::set<std::uint32_t> points;

    Elements() = default;
    explicit Elements(const MotionFile& motion) {
      for (const Element& point : motion.elements(0)) points.insert(point.vertices[0]);
      for (const Element& edge : motion.elements(1)) edges.insert(side(edge.vertices[0], edge.vertices[1]));
      for (const Element& face : motion.elements(2)) faces.insert(sorted(face.vertices));
    }
  };
  static std::array<std::uint32_t, 3> sorted(std::array<std::uint32_t, 3> face) {
    std::sort(face.begin(), face.end());
    return face;
  }

  static void require(bool holds, const std::string& reason) {
    if (!holds) throw Rejected(reason);
  }
  bool is_at_rest(const Sequence& sequence) const { return sequences_.size() > 1 && sequence.files.size() == 1; }

  static void check_sequence(const std::vector<Number>& coordinates, const Elements& elements, const Sequence& sequence,
                             std::uint32_t first, const std::string& what, Elements& of_files) {
    const MeshFile& mesh = sequence.mesh;
    const std::size_t begin = 3 * std::size_t{first}, end = begin + mesh.positions.size();
    require(end <= coordinates.size(), what + std::to_string(mesh.positions.size() / 3) + " vertices, and " +
                                           std::to_string((coordinates.size() - begin) / 3));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      require(compare(mesh.positions[i], coordinates[begin + i]) == 0,
              what + "the coordinates of vertex " + std::to_string(i / 3) + ", counted from 0, differ");
    }
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
      std::array<std::uint32_t, 3> face = sorted(mesh.faces[i]);
      for (std::uint32_t& v : face) v += first;
      require(elements.faces.count(face) > 0,
              what + "face " + std::to_string(mesh.numbers[i]) + " of the file, counted from 0, is none of the motion");
      of_files.faces.insert(face);
      for (std::size_t k = 0; k < 3; ++k) of_files.edges.insert(side(face[k], face[(k + 1) % 3]));
    }
    for (const auto& [v, w] : mesh.edges) {
      of_files.edges.insert(side(first + v, first + w));
      require(elements.edges.count(side(first + v, first + w)) > 0,
              what + "a line of the file is no edge of the motion");
    }
    std::vector<std::uint32_t> points = mesh.points;
    if (mesh.faces.empty() && mesh.edges.empty() && points.empty()) {  // of vertices alone, all are points
      points.resize(mesh.positions.size() / 3);
      std::iota(points.begin(), points.end(), 0U);
    }
    for (const std::uint32_t v : points) {
      require(elements.points.count(first + v) > 0, what + "a point of the file is none of the motion");
    }
  }

  std::vector<Sequence> sequences_;
};

}  // namespace checker
