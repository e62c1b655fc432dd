// SPDX-License-Identifier: MIT
#include "cli/mesh/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include <touchstone/error.hpp>

#include "cli/shared/mesh_results.hpp"
#include "cli/shared/whole_file.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "io/queries/kind_of_file.hpp"
#include "io/queries/query_writer.hpp"
#include "io/queries/separation_text.hpp"
#include "io/times.hpp"
#include "sequence/checks.hpp"
#include "sequence/pairs_table.hpp"
#include "sequence/report_json.hpp"
#include "sequence/results_json.hpp"

namespace touchstone::cli {
namespace {

namespace fs = std::filesystem;

bool is_there(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

/// "least distance 0.25: vertex 3 and face 5 (6-7-8), from t = 0.5". Empty where it was not asked for, and where the
/// frame or step was found to intersect itself or to touch without it.
std::string clearance_of(const sequence::Result& result, const Separation& separation) {
  if (!result.clearance) return {};
  const sequence::Clearance& clearance = *result.clearance;
  if (clearance.starts_intersecting()) return result.step && result.free() ? "its first frame intersects itself" : "";
  if (clearance.distance == 0 && separation.distance == 0 && !result.free()) return {};
  std::string text = least_distance_for_person(clearance.distance, separation.metric);
  if (clearance.pairs == 0) return text;
  text +=
      fmt::format(": {} and {}", element_for_person(clearance.pair.first), element_for_person(clearance.pair.second));
  if (result.step) text += ", from " + time_range(clearance.toi, clearance.toi_upper);
  return clearance.pairs == 1 ? text : text + fmt::format(", and {}", counted(clearance.pairs - 1, "more pair"));
}

std::string contact_of(const sequence::PairContact& pair) {
  Answer answer;
  answer.contact = true;
  answer.nature = pair.nature;
  answer.feature_a = pair.feature_a;
  answer.feature_b = pair.feature_b;
  return contact_for_person(answer);
}

std::string intersections_of(const sequence::Result& result) {
  sequence::IntersectionCounts counts;
  counts.add(result.intersections);
  return intersections_for_person(counts);
}

/// Whether the edge of a fold is one of a triangle that --triangulate cut from the same polygon as the face.
bool is_within_polygon(const sequence::RestContact& contact, const frames::Topology& topology) {
  if (!topology.vertex_numbers.empty() || contact.sort != IntersectionSort::folds ||
      contact.second.element != MeshElement::face)
    return false;
  const auto& numbers = topology.face_numbers;  // in ascending order
  const auto [first, last] = std::equal_range(numbers.begin(), numbers.end(), contact.second.face);
  const auto* const faces = topology.faces.data();
  return std::any_of(faces + (first - numbers.begin()), faces + (last - numbers.begin()), [&](const auto& corners) {
    return std::all_of(contact.first.vertices.begin(), contact.first.vertices.begin() + 2, [&](std::uint64_t vertex) {
      return std::find(corners.begin(), corners.end(), vertex - topology.first_number) != corners.end();
    });
  });
}

// In the folder of each kind: the pairs that the run's separation is about, and ends of wires with wires beside them.
constexpr const char* kQueriesFiles[] = {"contacts.csv", "folds.csv"};

}  // namespace

std::optional<std::string> journal_path(const std::string& report) {
  std::error_code ignored;
  if (report.empty() || report == "-" || fs::is_other(fs::status(report, ignored))) return std::nullopt;
  return report + ".progress";
}

MeshOutput::MeshOutput(const MeshRunOptions& options, sequence::Heading heading)
    : options_(options), console_(io::OutputFile::standard_output()) {
  report_.heading = std::move(heading);
  first_frame_ = sequence::range_of(report_.heading).first;
  const std::string& report = options.report;
  const std::optional<std::string> journal = journal_path(report);
  if (journal && options.resume && !is_there(*journal) && is_there(report)) {
    take_finished_report();
  } else if (!report.empty() && report != "-") {
    report_file_.emplace(report);  // first, so that an error names the file that was named
    if (journal) {
      finished_file_ = *journal;
      const auto earlier = options.resume ? sequence::Earlier::continued : sequence::Earlier::refused;
      journal_.emplace(*journal, report_.heading, earlier);
    }
  }
  if (!options.pairs.empty()) pairs_file_.emplace(options.pairs).write(sequence::kPairsHeader);
  if (!options.queries.empty()) folders_.make(options.queries);
}

void MeshOutput::take_finished_report() {
  finished_file_ = options_.report;
  const std::string text = whole_file(options_.report);
  sequence::Report report = naming_file(options_.report, [&] {
    sequence::Report read = sequence::report_from(text);
    const std::string difference = sequence::difference_of(read.heading, report_.heading, "this run");
    if (!difference.empty()) throw Error(difference + "; without --resume it is replaced");
    return read;
  });
  for (sequence::Result& result : report.results) {
    const std::size_t frame = result.frame - first_frame_;
    std::vector<std::string> digests = {report.frames[frame].digest};
    if (result.step) digests.push_back(report.frames[frame + 1].digest);
    from_report_.push_back({std::move(result), std::move(digests)});
  }
}

const std::vector<sequence::Finished>& MeshOutput::finished() const noexcept {
  return journal_ ? journal_->finished() : from_report_;
}

const std::string& MeshOutput::label(std::size_t frame) const { return report_.frames[frame - first_frame_].label; }

void MeshOutput::add(sequence::Finished finished, const frames::Frame& before, const frames::Frame& after, bool known) {
  if (journal_ && !known) journal_->add(finished);
  const sequence::Result& result = finished.result;
  if (pairs_file_) {
    pairs_file_->write(sequence::pair_rows(result, label(result.frame),
                                           result.step ? label(result.frame + 1) : std::string(), options_.numbers));
  }
  const std::string lines = lines_of(result, before, after);  // writes the queries, too
  if (options_.json) {
    console_.write(sequence::result_line(result, label(result.frame), result.step ? label(result.frame + 1) : "") +
                   "\n");
    console_.commit();
  } else if (options_.report != "-") {
    console_.write(lines);
    console_.commit();  // a step may take minutes
  }
  counts_.add(report_.heading.question, result);
  if (!result.step) {
    polygon_folds_ += static_cast<std::size_t>(
        std::count_if(result.intersections.begin(), result.intersections.end(),
                      [&](const auto& contact) { return is_within_polygon(contact, *before.topology); }));
  }
  if (!options_.report.empty()) report_.results.push_back(std::move(finished.result));
}

std::string MeshOutput::lines_of(const sequence::Result& result, const frames::Frame& before,
                                 const frames::Frame& after) {
  const std::string clearance = clearance_of(result, report_.heading.separation);
  const std::string more = clearance.empty() ? clearance : "; " + clearance;
  if (!result.step) {
    std::string classes;
    for (const auto& [a, b, sort] : result.classes.value_or(std::vector<sequence::PartRelation>())) {
      classes += sort == mesh::Relation::inside ? fmt::format("  {} is inside {}\n", a, b)
                                                : fmt::format("  {} and {}: {}\n", a, b, name_of(sort));
    }
    if (result.free()) return label(result.frame) + ": no intersection" + more + "\n" + classes;
    std::string text = fmt::format("{}: {}\n", label(result.frame), intersections_of(result));
    if (result.coinciding > 0) text += fmt::format("  {} vertices lie exactly on others\n", grouped(result.coinciding));
    return text + intersection_lines(result.intersections, "  ") + classes;
  }
  std::string text = label(result.frame) + " -> " + label(result.frame + 1) + ": ";
  if (result.free()) {
    if (counts_.ends_intersecting) return text + "free of contact; its first frame intersects itself\n";
    const bool starts_intersecting = result.clearance && result.clearance->starts_intersecting();
    return text + (starts_intersecting ? "free of contact" : "free") + more + "\n";
  }
  if (!result.first.empty()) {
    text += fmt::format("first contact at {}, {}\n", time_range(result.toi, result.toi_upper),
                        counted(result.first.size(), "pair"));
    text += pair_lines(result.first, result, before, after, "  ");
    if (!result.at_start.empty()) text += "  " + pairs_are(result.at_start.size()) + "\n";
  } else {
    text += pairs_are(result.at_start.size()) + "\n";
  }
  text += pair_lines(result.at_start, result, before, after, result.first.empty() ? "  " : "    ");
  if (!clearance.empty()) text += "  " + clearance + "\n";
  if (!result.intersections.empty()) {
    text += fmt::format("  {} then has {}\n", label(result.frame + 1), intersections_of(result));
    text += intersection_lines(result.intersections, "    ");
  }
  return text;
}

std::string MeshOutput::pair_lines(const std::vector<sequence::PairContact>& pairs, const sequence::Result& result,
                                   const frames::Frame& before, const frames::Frame& after, const std::string& indent) {
  std::string text;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::string command = options_.queries.empty() ? std::string() : write_query(pairs[i], result, before, after);
    if (i >= kShownPairs) continue;
    text += fmt::format("{}{}: {}\n", indent, pair_for_person(pairs[i]), contact_of(pairs[i]));
    if (!command.empty()) text += fmt::format("{}  {}\n", indent, command);
  }
  return text + more_line(pairs.size(), indent);
}

std::string MeshOutput::write_query(const sequence::PairContact& pair, const sequence::Result& result,
                                    const frames::Frame& before, const frames::Frame& after) {
  // Neighbours along a wire, and those of --self, are asked about touching alone. An answer about a separation has
  // a trend.
  const bool fold = report_.heading.separation.distance > 0 && pair.trend == Trend::none;
  const Separation separation = fold ? Separation() : report_.heading.separation;
  auto& target = queries_[static_cast<std::size_t>(pair.kind)][fold ? 1 : 0];
  if (!target) {
    const fs::path folder = fs::path(options_.queries) / name_of(pair.kind);
    folders_.make(folder);
    const std::string path = (folder / kQueriesFiles[fold ? 1 : 0]).string();
    target.emplace(QueryFile{io::OutputFile(path), path});
    if (separation.distance > 0) target->file.write(io::separation_comment(separation));
  }
  std::string text =
      fmt::format("# step {} -> {}: {}\n", label(result.frame), label(result.frame + 1), pair_for_person(pair));
  io::append_query(text, sequence::query_of(pair, before, after), true);
  target->file.write(text);
  return explain_command(target->path, pair.kind, target->queries++, separation);
}

std::string MeshOutput::counts_summary() const {
  std::string text = counts_for_person(report_.heading, report_.frames, counts_);
  if (polygon_folds_ == 0 || polygon_folds_ < counts_.intersections.folds) return text;
  text.pop_back();
  return text +
         "; all folds are among triangles of one polygon, which --triangulate cut: cut the polygons in the program "
         "that wrote the file, if they are not convex\n";
}

bool MeshOutput::finish() {
  if (pairs_file_) pairs_file_->commit();
  for (const Kind kind : kKinds) {
    for (std::size_t i = 0; i < std::size(kQueriesFiles); ++i) {
      auto& queries = queries_[static_cast<std::size_t>(kind)][i];
      if (queries) {
        queries->file.commit();
      } else if (!options_.queries.empty()) {
        // A file of an earlier run would pass for one of this run.
        const fs::path file = fs::path(options_.queries) / name_of(kind) / kQueriesFiles[i];
        std::error_code ignored;
        if (fs::is_regular_file(file, ignored)) fs::remove(file, ignored);
      }
    }
  }
  folders_.keep();
  if (report_file_) {
    report_file_->write(sequence::report_text(report_));
    report_file_->commit();
  }
  if (journal_) journal_->remove();
  if (options_.report == "-") {
    console_.write(sequence::report_text(report_));
  } else if (options_.json) {
    print_error(counts_summary());
  } else {
    console_.write(in_colour(counts_summary(), VerdictLine::last, counts_.all_free()));
  }
  console_.commit();
  return counts_.all_free();
}

}  // namespace touchstone::cli
