// The bodies of `touchstone bodies`, and the names of their elements.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <touchstone/bodies.hpp>

#include "cli/bodies/bodies.hpp"
#include "sequence/element_names.hpp"
#include "sequence/results.hpp"

namespace touchstone::cli {

class BodyFiles {
 public:
  /// @throws FileError  for files that are no meshes in space, fewer than two bodies, and rules that leave no pair
  explicit BodyFiles(const BodiesRunOptions& options);

  const Bodies& bodies() const noexcept { return bodies_; }
  const std::vector<std::string>& files() const noexcept { return files_; }
  const std::vector<std::string>& names() const noexcept { return names_; }

  /// The rules of all bodies, by their names.
  const sequence::PartRules& rules() const noexcept { return rules_; }

  /// Of all bodies, as if they were one mesh.
  const sequence::MeshFacts& facts() const noexcept { return facts_; }

  /// An element as its file counts it. Its part is the body.
  sequence::NamedElement named(MeshElement sort, const BodyElement& element);
  sequence::PairContact named(const BodyContact& contact);
  sequence::RestContact named(const BodyIntersection& one);

  /// What the file of a body holds.
  const frames::Topology& topology(std::size_t body) const { return *topologies_[body]; }

 private:
  void read(const BodiesRunOptions& options, std::size_t body);
  void set_rules(const sequence::PartOptions& options);

  std::vector<std::string> files_, names_;
  std::vector<std::shared_ptr<const frames::Topology>> topologies_;
  Bodies bodies_;
  sequence::PartRules rules_;
  sequence::MeshFacts facts_;
  std::vector<sequence::ElementNames> elements_;  ///< of each body
};

}  // namespace touchstone::cli
