// SPDX-License-Identifier: MIT
#include "cli/shared/proofs/motion_proofs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <system_error>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>

#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/progress/pipeline.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "proofs/proof_text.hpp"

namespace touchstone::cli {
namespace {

namespace fs = std::filesystem;

/// Some neighbouring pairs of a step, and their proofs.
struct Block {
  std::size_t first = 0, last = 0;
  std::string text;
  std::uint64_t contacts = 0;
  std::exception_ptr error;
};

/// `folder`, which is made when it is missing. @throws FileError when it holds anything
fs::path empty_folder(NewFolders& folders, const fs::path& folder) {
  folders.make(folder);
  std::error_code error;
  for (fs::directory_iterator file(folder, error), end; !error && file != end; file.increment(error)) {
    // A process that was killed leaves its temporary file behind; OutputFile removes it.
    const std::string name = file->path().filename().string();
    if (name.rfind(std::string(MotionProofs::kMotionFile) + ".touchstone-", 0) == 0) continue;
    if (name.rfind(std::string(MotionProofs::kProofsFile) + ".touchstone-", 0) == 0) continue;
    io::fail(folder.string(), "holds " + io::printable(name) +
                                  "; the motion and its proofs go into a new or an empty folder, so that they belong "
                                  "together");
  }
  if (error) io::fail(folder.string(), "cannot be read: " + io::system_reason(error.value()));
  return folder;
}

/// @throws Error  when no two elements could meet: a proof of nothing is none, and the checker refuses it
proofs::StepProver prover_of(proofs::MotionElements elements, const Separation& separation) {
  proofs::StepProver prover(std::move(elements), separation);
  if (prover.has_pair()) return prover;
  const proofs::MotionElements& all = prover.elements();
  throw Error(fmt::format(
      "--prove: there is nothing to prove: of {}, {} and {} no two share no vertex, are asked about and are neither "
      "all fixed nor all on one body",
      counted(all.points.size(), "point"), counted(all.edges.size(), "edge"), counted(all.faces.size(), "face")));
}

}  // namespace

void MotionProofs::add_files(const std::string& folder, std::vector<std::pair<std::string, std::string>>& outputs) {
  if (folder.empty()) return;
  for (const char* name : {kMotionFile, kProofsFile})
    outputs.emplace_back("--prove", (fs::path(folder) / name).string());
}

MotionProofs::MotionProofs(const fs::path& folder, proofs::MotionElements elements, const Separation& separation,
                           int threads)
    : prover_(prover_of(std::move(elements), separation)),
      folder_(empty_folder(folders_, folder)),
      threads_(threads),
      motion_((folder_ / kMotionFile).string()),
      steps_((folder_ / kProofsFile).string()) {
  const std::string head = proofs::motion_head(prover_.elements());
  motion_.write(head);
  motion_sum_.add(head);
}

void MotionProofs::prove_step(const proofs::MotionFrame& end) {
  const std::vector<proofs::MotionPair> pairs = prover_.pairs(last_, end, threads_);
  steps_.write(fmt::format("step {}\n", frames_ - 1));
  constexpr std::size_t kPairs = 64;  // of a block: enough work for a thread, and small beside a step with many pairs
  std::size_t next = 0;
  std::uint64_t contacts = 0;
  run_in_order<Block>(
      pairs.size() > kPairs ? threads_ : 1,
      [&](Block& block) {
        block.first = next;
        block.last = next = std::min(pairs.size(), next + kPairs);
        return block.first < block.last;
      },
      [&](Block& block) {
        for (std::size_t i = block.first; i < block.last; ++i) {
          try {
            if (prover_.append_proof(block.text, i, pairs[i], last_, end).contact) ++block.contacts;
          } catch (const Error& error) {
            throw Error(fmt::format("step {} of the motion, pair {}: {}", frames_ - 1, i, error.what()));
          }
        }
      },
      [&](Block& block) {
        steps_.write(block.text);
        contacts += block.contacts;
      });
  pairs_ += pairs.size();
  contacts_ += contacts;
}

void MotionProofs::add(proofs::MotionFrame frame) {
  throw_if_interrupted();
  if (frames_ > 0) {
    const std::uint64_t before = steps_.size();
    try {
      prove_step(frame);
    } catch (...) {
      steps_.cut(before);
      throw;
    }
  }
  std::string text;
  proofs::append_frame(text, frame);
  motion_.write(text);
  motion_sum_.add(text);
  last_ = std::move(frame);
  ++frames_;
}

void MotionProofs::commit() {
  io::OutputFile out((folder_ / kProofsFile).string());
  std::string head = proofs::kFirstLine;
  proofs::append_separation(head, prover_.separation());
  // The name is the same wherever the folder is.
  head += fmt::format("file mesh {} {}\n", motion_sum_.digest(), kMotionFile);
  out.write(head);
  steps_.copy_to(out);
  out.write(fmt::format("end {} {}\n", pairs_, contacts_));
  motion_.commit();
  out.commit();
  folders_.keep();
}

std::string MotionProofs::summary() const {
  const std::string answer = pairs_ == 0      ? "no two elements that are asked about come near enough to need a proof"
                             : contacts_ == 0 ? "no contact"
                                              : counted(contacts_, "contact");
  const proofs::MotionElements& all = prover_.elements();
  std::string not_asked = "whether the first frame intersects itself", touching;
  if (!all.groups.ignored.empty()) not_asked += ", " + counted(all.groups.ignored.size(), "pair") + " of groups";
  for (const std::string& some :
       {all.touching.empty() ? "" : counted(all.touching.size(), "pair"),
        all.radii.near.empty() ? "" : counted(all.radii.near.size(), "pair") + " of neighbours"}) {
    if (!some.empty()) touching += (touching.empty() ? "; asked about touching alone: " : ", ") + some;
  }
  return fmt::format("{} in {} proved in {}: {}; not asked: {}{}\n", counted(pairs_, "pair"),
                     counted(frames_ - 1, "step"), io::printable(folder_.string()), answer, not_asked, touching);
}

}  // namespace touchstone::cli
