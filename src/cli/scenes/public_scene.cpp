// SPDX-License-Identifier: MIT
#include "cli/scenes/public_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include <touchstone/error.hpp>

#include "cli/shared/json_list.hpp"
#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "json/json_node.hpp"
#include "sequence/checks.hpp"
#include "sequence/frame_list.hpp"

namespace touchstone::cli {
namespace {

namespace fs = std::filesystem;

/// The files and folders in a folder, in the order of their names, but those that are hidden.
std::vector<fs::path> contents_of(const fs::path& folder) {
  std::vector<fs::path> all;
  std::error_code error;
  fs::directory_iterator at(folder, error);
  for (; !error && at != fs::directory_iterator(); at.increment(error)) {
    if (at->path().filename().string().front() != '.') all.push_back(at->path());
  }
  if (error) io::fail(folder.string(), error.message());
  std::sort(all.begin(), all.end());
  return all;
}

bool is_folder(const fs::path& folder) {
  std::error_code error;
  const auto status = fs::status(folder, error);
  if (status.type() == fs::file_type::none) io::fail(folder.string(), error.message());  // it may be there
  return fs::is_directory(status);
}

std::string digits_at_end(const std::string& name) {
  return name.substr(name.find_last_not_of("0123456789") + 1);  // npos + 1 is 0
}

/// Takes what the files of a folder say of the steps.
/// @param ending  of a file's name after the step's number and "ee" or "vf"
void add_truths(const fs::path& folder, const std::string& ending, std::string PublicStepFiles::Truth::*half,
                std::map<std::string, PublicStepFiles>& steps) {
  if (!is_folder(folder)) return;
  for (const fs::path& file : contents_of(folder)) {
    const std::string name = file.filename().string();
    for (const auto& [suffix, truth] : {std::pair{"ee", &PublicStepFiles::edges}, {"vf", &PublicStepFiles::faces}}) {
      const std::string end = suffix + ending;
      if (!name.ends_with(end)) continue;
      const auto step = steps.find(name.substr(0, name.size() - end.size()));
      if (step == steps.end()) io::fail(file.string(), "belongs to no step: no frame's name ends in its number");
      step->second.*truth.*half = file.string();
    }
  }
}

void check_halves(const PublicStepFiles::Truth& truth, const fs::path& scene) {
  if (truth.pairs.empty() == truth.verdicts.empty()) return;
  const bool has_pairs = !truth.pairs.empty();
  io::fail(
      has_pairs ? truth.pairs : truth.verdicts,
      fmt::format("has no other half in {}", io::printable((scene / (has_pairs ? "mma_bool" : "boxes")).string())));
}

void add_steps(const fs::path& scene, std::vector<PublicStepFiles>& steps) {
  std::vector<std::string> frames;
  for (const fs::path& file : contents_of(scene / "frames")) frames.push_back(file.string());
  if (frames.size() < 2) io::fail((scene / "frames").string(), "holds no two mesh files, which a step needs");
  frames = sequence::in_order(std::move(frames), sequence::Gaps::refused);
  std::map<std::string, PublicStepFiles> by_number;
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    const std::string number = digits_at_end(fs::path(frames[i]).stem().string());
    if (number.empty()) io::fail(frames[i], "has a name that ends in no number, which is to be the step's");
    numbers.push_back(number);
    PublicStepFiles& step = by_number[number];
    step.name = scene.filename().string() + " " + number;
    step.before = frames[i];
    step.after = frames[i + 1];
  }
  add_truths(scene / "boxes", ".json", &PublicStepFiles::Truth::pairs, by_number);
  add_truths(scene / "mma_bool", "_mma_bool.json", &PublicStepFiles::Truth::verdicts, by_number);
  for (const std::string& number : numbers) {
    PublicStepFiles& step = by_number[number];
    check_halves(step.edges, scene);
    check_halves(step.faces, scene);
    steps.push_back(std::move(step));
  }
}

frames::Frame read(const std::string& file, const std::shared_ptr<const frames::Topology>& earlier) {
  frames::ReadOptions options;
  options.checkpoint = throw_if_interrupted;
  frames::Frame frame = frames::read_frame(file, 0, options, earlier);
  sequence::check_positions(frame, {file});
  if (frame.topology->dimension != 3) io::fail(file, "is in the plane; a public scene is in space");
  return frame;
}

/// The elements of a mesh by the numbers of the data set.
class PublicNumbers {
 public:
  explicit PublicNumbers(const Mesh& mesh) : mesh_(mesh), edges_(mesh.edges().size()) {
    for (std::size_t e = 0; e < edges_.size(); ++e) edges_[e] = static_cast<MeshIndex>(e);
    const auto key = [&](MeshIndex e) {
      const auto& [a, b] = mesh.edges()[e];
      return std::array{std::max(a, b), std::min(a, b)};
    };
    std::sort(edges_.begin(), edges_.end(), [&](MeshIndex a, MeshIndex b) { return key(a) < key(b); });
  }

  MeshIndex vertex(const json::JsonNode& node) const { return within(node, 0, mesh_.vertex_count(), "vertex"); }
  MeshIndex edge(const json::JsonNode& node) const {
    return edges_[within(node, mesh_.vertex_count(), edges_.size(), "edge")];
  }
  MeshIndex face(const json::JsonNode& node) const {
    return within(node, mesh_.vertex_count() + edges_.size(), mesh_.faces().size(), "face");
  }

 private:
  static MeshIndex within(const json::JsonNode& node, std::size_t first, std::size_t count, const char* name) {
    const std::size_t number = node.index();
    if (number < first || number >= first + count) {
      node.fail(count == 0 ? fmt::format("{} is no {}: there is none", number, name)
                           : fmt::format("{} is no {}, which have the numbers {} to {}", number, name, first,
                                         first + count - 1));
    }
    return static_cast<MeshIndex>(number - first);
  }

  const Mesh& mesh_;
  std::vector<MeshIndex> edges_;  // by their order in the data set
};

/// Appends the pairs of one kind.
void add_judged(const PublicStepFiles::Truth& truth, bool edges, const PublicNumbers& numbers, PublicStep& step) {
  if (truth.pairs.empty()) return;
  std::set<MeshPair> once;
  const auto read_pair = [&](const json::JsonNode& node) {
    const std::vector<json::JsonNode> two = node.items();
    if (two.size() != 2) node.fail(fmt::format("has {} numbers; a pair has 2", two.size()));
    MeshPair pair{Kind::vertex_face, 0, 0};
    if (edges) {
      const auto [a, b] = std::minmax({numbers.edge(two[0]), numbers.edge(two[1])});
      if (a == b) node.fail("is an edge and itself");
      pair = {Kind::edge_edge, a, b};
    } else {
      pair = {Kind::vertex_face, numbers.vertex(two[0]), numbers.face(two[1])};
    }
    if (!once.insert(pair).second) node.fail("is a pair that the list has already");
    return pair;
  };
  const std::vector<MeshPair> pairs = read_json_list<MeshPair>(truth.pairs, read_pair);
  const std::vector<bool> touches =
      read_json_list<bool>(truth.verdicts, [](const json::JsonNode& node) { return node.boolean(); });
  if (pairs.size() != touches.size()) {
    io::fail(truth.verdicts, fmt::format("has {}, and {} has {}", counted(touches.size(), "truth"),
                                         io::printable(truth.pairs), counted(pairs.size(), "pair")));
  }
  step.has_truth = true;
  for (std::size_t i = 0; i < pairs.size(); ++i) step.judged.push_back({pairs[i], touches[i]});
}

}  // namespace

std::vector<std::string> PublicStepFiles::all() const {
  std::vector<std::string> files = {before, after};
  for (const Truth& truth : {edges, faces}) {
    if (!truth.pairs.empty()) files.insert(files.end(), {truth.pairs, truth.verdicts});
  }
  return files;
}

std::vector<PublicStepFiles> find_public_steps(const std::vector<std::string>& folders) {
  std::vector<PublicStepFiles> steps;
  for (const std::string& name : folders) {
    fs::path folder = fs::path(name).lexically_normal();
    if (!folder.has_filename()) folder = folder.parent_path();  // "scenes/"
    if (!is_folder(folder)) io::fail(name, "is no folder");
    const std::size_t before = steps.size();
    if (is_folder(folder / "frames")) {
      add_steps(folder, steps);
    } else {
      for (const fs::path& inner : contents_of(folder)) {
        if (is_folder(inner) && is_folder(inner / "frames")) add_steps(inner, steps);
      }
    }
    if (steps.size() == before) {
      io::fail(name, "holds no scene; a scene is a folder with the folder frames, and perhaps boxes and mma_bool");
    }
  }
  return steps;
}

PublicStep read_public_step(const PublicStepFiles& files) {
  PublicStep step;
  step.name = files.name;
  const frames::Frame before = read(files.before, nullptr), after = read(files.after, before.topology);
  sequence::check_same_elements(*before.topology, {files.before}, *after.topology, {files.after});
  step.mesh = sequence::mesh_of(*before.topology, {}, files.before);
  step.x0 = before.positions;
  step.x1 = after.positions;
  const PublicNumbers numbers(step.mesh);
  add_judged(files.edges, true, numbers, step);
  add_judged(files.faces, false, numbers, step);
  return step;
}

}  // namespace touchstone::cli
