// A folder with the motion of a mesh and the proofs of its steps: what `--prove FOLDER` writes.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/separation.hpp>

#include "cli/shared/new_folders.hpp"
#include "io/output_file.hpp"
#include "io/sha256.hpp"
#include "proofs/mesh_motion.hpp"

namespace touchstone::cli {

/// FOLDER/motion.txt and FOLDER/proofs.txt, as docs/proofs.md defines them. They appear with commit(). No byte of them
/// depends on the number of threads.
class MotionProofs {
 public:
  static constexpr char kMotionFile[] = "motion.txt", kProofsFile[] = "proofs.txt";

  /// Adds both files to the outputs of a program, unless the folder's name is empty.
  static void add_files(const std::string& folder, std::vector<std::pair<std::string, std::string>>& outputs);

  /// @param folder   a new or an empty folder
  /// @param threads  how many prove the pairs of a step
  /// @throws FileError; Error  when no two elements could meet, so that nothing could be proved
  MotionProofs(const std::filesystem::path& folder, proofs::MotionElements elements, const Separation& separation,
               int threads);

  /// Takes the next frame, and proves the step to it from the frame before. When this throws, it has not been taken.
  void add(proofs::MotionFrame frame);

  /// Whether there is a step. A motion without one has no proofs, and cannot be committed.
  bool has_steps() const noexcept { return frames_ > 1; }

  std::uint64_t contacts() const noexcept { return contacts_; }  ///< pairs with a contact, over all steps

  /// Puts both files in their places.
  void commit();

  /// "1,024 pairs in 12 steps proved in FOLDER: no contact; not asked: whether the first frame intersects itself, 1
  /// pair of groups; asked about touching alone: 4 pairs, 2 pairs of neighbours", a line: what the checkers say of the
  /// files. Without a pair it says why none needs a proof.
  std::string summary() const;

 private:
  void prove_step(const proofs::MotionFrame& end);

  proofs::StepProver prover_;
  NewFolders folders_;
  std::filesystem::path folder_;
  int threads_;
  io::OutputFile motion_;
  io::SpoolFile steps_;  ///< the proofs; the digest of the whole motion comes before them
  io::Sha256 motion_sum_;
  proofs::MotionFrame last_;
  std::uint64_t frames_ = 0, pairs_ = 0, contacts_ = 0;
};

}  // namespace touchstone::cli
