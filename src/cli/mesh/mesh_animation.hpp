// The page of a checked animation.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <touchstone/mesh.hpp>

#include "frames/frame.hpp"
#include "io/output_file.hpp"
#include "sequence/results.hpp"
#include "view/animation.hpp"

namespace touchstone::cli {

/// Takes frames and results as they are found. Time counts frames: a contact in the step from frame 3 to frame 4 at
/// t = 0.25 is at 3.25.
class MeshAnimation {
 public:
  /// @throws Error for more vertices than a page holds
  MeshAnimation(const Mesh& mesh, std::shared_ptr<const frames::Topology> topology, const Separation& separation);

  /// The result about a frame, or about a step from `before` to `after`.
  void add_result(const sequence::Result& result, const frames::Frame& before, const frames::Frame& after);

  /// A frame, after the results that end with it. @throws Error for other elements than those of the first frame
  void add_frame(std::size_t number, const std::string& label, const frames::Frame& frame);

  /// @param question  text: what was asked  @param summary  text of several lines  @returns the size in bytes
  std::uint64_t write(io::OutputFile& file, const std::string& question, const std::string& summary) const;

 private:
  MeshIndex vertex(const sequence::NamedElement& named, std::size_t corner) const;
  view::AnimationElement element(const sequence::NamedElement& named) const;
  void add_contacts(const std::vector<sequence::PairContact>& pairs, double time, const sequence::Result& result,
                    const frames::Frame& before, const frames::Frame& after);
  void add_intersections(const std::vector<sequence::RestContact>& found, std::size_t number,
                         const frames::Frame& frame);

  std::shared_ptr<const frames::Topology> topology_;
  Separation separation_;
  std::map<std::vector<std::uint32_t>, std::uint32_t> edges_, faces_;  ///< by their sorted corners; made when needed
  view::Animation animation_;
  std::string first_label_, last_label_;
  std::size_t contacts_ = 0, intersections_ = 0;  ///< since the frame before
};

}  // namespace touchstone::cli
