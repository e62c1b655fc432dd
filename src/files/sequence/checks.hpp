// The checks of frames and steps, with errors that name files and count as the files do.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include <touchstone/mesh.hpp>

#include "frames/frame.hpp"
#include "sequence/frame_list.hpp"
#include "sequence/results.hpp"

namespace touchstone::sequence {

/// The vertices of a file that collide as points: its points that are in no element or, in a file without faces, edges
/// and points, all vertices.
std::vector<MeshIndex> loose_points(const frames::Topology& topology);

/// The mesh of a topology. Vertices that are in no element do not collide.
/// @param file  the name for messages
/// @throws FileError  for elements that Mesh refuses, by their numbers in the file, and for parts of which the rules
///                    leave nothing to ask about
Mesh mesh_of(const frames::Topology& topology, const Separation& separation, const std::string& file,
             const PartRules& parts = {});

/// How frames and steps are checked.
struct CheckOptions {
  int threads = 1;
  bool clearance = false;                   ///< whether the least distance is asked for, too
  bool classes = false;                     ///< of frames: whether it is asked for how parts lie to each other
  const std::atomic<bool>* stop = nullptr;  ///< as MeshOptions has it
};

/// @throws FileError  for a mesh whose parts have no classes: one in the plane, one with fewer than two parts, or one
///                    whose parts share vertices
void check_has_classes(const frames::Topology& topology, const std::string& file);

/// @throws FileError  for a coordinate that is not finite, by the vertex's number in the file
void check_positions(const frames::Frame& frame, const FrameName& name);

/// @throws FileError  naming both frames and the first difference, unless both have the same vertices and elements
void check_same_elements(const frames::Topology& before, const FrameName& name_before, const frames::Topology& after,
                         const FrameName& name_after);

/// @throws FileError  naming both frames, unless both have the same parts: their names, and the faces in them
void check_same_parts(const frames::Topology& before, const FrameName& name_before, const frames::Topology& after,
                      const FrameName& name_after);

/// Where a frame intersects itself.
/// @param index  its place in the sequence
Result check_frame(const Mesh& mesh, const frames::Frame& frame, std::size_t index, const CheckOptions& options);

/// The contacts of a step. Numbers and names are those of the first frame. A step that is not free gets the
/// intersections of its last frame too.
/// @param index  the place of the first frame in the sequence
Result check_step(const Mesh& mesh, const frames::Frame& before, const frames::Frame& after, std::size_t index,
                  const CheckOptions& options);

/// The query of a pair in a step.
Query query_of(const PairContact& pair, const frames::Frame& before, const frames::Frame& after);

}  // namespace touchstone::sequence
