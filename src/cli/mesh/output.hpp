// What `touchstone mesh` writes: lines for a person, the table of pairs, query files, the journal and the report.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/mesh/mesh.hpp"
#include "cli/shared/new_folders.hpp"
#include "frames/frame.hpp"
#include "io/output_file.hpp"
#include "sequence/journal.hpp"
#include "sequence/results.hpp"

namespace touchstone::cli {

/// Where the finished results of an unfinished report are; nothing for a report that is a pipe or device, beside which
/// no file belongs, and for none.
std::optional<std::string> journal_path(const std::string& report);

class MeshOutput {
 public:
  /// Opens the files, so that one that cannot be written is found before the run. @throws FileError
  MeshOutput(const MeshRunOptions& options, sequence::Heading heading);

  /// The results of an earlier run, in their order.
  const std::vector<sequence::Finished>& finished() const noexcept;

  /// The file that they were read from, for messages.
  const std::string& finished_file() const noexcept { return finished_file_; }

  void add_frame(sequence::FrameEntry frame) { report_.frames.push_back(std::move(frame)); }

  /// Takes the next result.
  /// @param before  its frame, or the first one of its step
  /// @param after   the last frame of the step
  /// @param known   whether an earlier run found it
  void add(sequence::Finished finished, const frames::Frame& before, const frames::Frame& after, bool known);

  /// The lines about all results.
  std::string counts_summary() const;

  /// Writes what is left, and puts all files in their places. @returns whether every step is free
  bool finish();

 private:
  struct QueryFile {
    io::OutputFile file;
    std::string path;
    std::uint64_t queries = 0;
  };

  void take_finished_report();
  std::string pair_lines(const std::vector<sequence::PairContact>& pairs, const sequence::Result& result,
                         const frames::Frame& before, const frames::Frame& after, const std::string& indent);
  std::string write_query(const sequence::PairContact& pair, const sequence::Result& result,
                          const frames::Frame& before, const frames::Frame& after);
  std::string lines_of(const sequence::Result& result, const frames::Frame& before, const frames::Frame& after);
  const std::string& label(std::size_t frame) const;

  const MeshRunOptions& options_;
  sequence::Report report_;        ///< without --report, its results are only counted
  sequence::ResultCounts counts_;  ///< of the results so far
  std::size_t polygon_folds_ = 0;  ///< of the folds in counts_, those among triangles of one polygon
  std::size_t first_frame_;
  std::optional<sequence::Journal> journal_;
  std::vector<sequence::Finished> from_report_;  ///< of a report that is there already
  std::string finished_file_;
  std::optional<io::OutputFile> report_file_, pairs_file_;
  NewFolders folders_;
  std::array<std::array<std::optional<QueryFile>, 2>, 4> queries_;  ///< by Kind, then contacts and folds
  io::OutputFile console_;
};

}  // namespace touchstone::cli
