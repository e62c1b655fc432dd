// The page of bodies that were checked.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <touchstone/bodies.hpp>

#include "cli/bodies/body_files.hpp"
#include "cli/bodies/pose_file.hpp"
#include "io/output_file.hpp"
#include "view/animation.hpp"

namespace touchstone::cli {

/// Takes the steps as they are checked. Its times are those of the recording.
class BodyAnimation {
 public:
  /// All three outlive this. @throws Error for more vertices than a page holds
  BodyAnimation(BodyFiles& files, const RecordedPoses& poses);

  /// The next step.
  void add(const std::vector<RigidMotion>& motions, const FirstBodyContact& found);

  /// @param summary  text of several lines  @returns the size in bytes
  std::uint64_t write(io::OutputFile& file, const std::string& summary) const;

 private:
  view::AnimationElement element(MeshElement sort, const BodyElement& of) const;
  void add_contacts(const std::vector<BodyContact>& contacts, double time, const std::vector<RigidMotion>& motions);
  void add_intersections(const std::vector<BodyIntersection>& found, const std::vector<RigidMotion>& motions);
  void add_frame(const std::vector<RigidMotion>& motions, double fraction, double time);

  BodyFiles& files_;
  const RecordedPoses& poses_;
  view::Animation animation_;
  std::size_t steps_ = 0;
  std::size_t contacts_ = 0, intersections_ = 0;  ///< since the frame before
};

}  // namespace touchstone::cli
