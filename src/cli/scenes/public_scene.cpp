// SPDX-License-Identifier: MIT
#include "cli/scenes/public_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <system_error>

#include <touchstone/error.hpp>

#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/words.hpp"
#include "io/fail.hpp"
#include "io/whole_file.hpp"
#include "json/json_node.hpp"
#include "sequence/checks.hpp"
#include "sequence/frame_list.hpp"

namespace touchstone::cli {
namespace {

namespace fs = std::filesystem;

/// The files and folders in a folder, in the order of their names; none where it is none.
std::vector<fs::path> contents_of(const fs::path& folder) {
  std::vector<fs::path> all;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    all.push_back(at->path());
  }
  std::sort(all.begin(), all.end());
  return all;
}

bool is_scene(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(folder / "frames", ignored);
}

std::string digits_at_end(const std::string& name) {
  return name.substr(name.find_last_not_of("0123456789") + 1);  // npos + 1 is 0
}

void add_steps(const fs::path& scene, std::vector<PublicStepFiles>& steps) {
  std::vector<std::string> frames;
  for (const fs::path& file : contents_of(scene / "frames")) frames.push_back(file.string());
  frames = sequence::in_order(std::move(frames), sequence::Gaps::refused);
  if (frames.size() < 2) io::fail((scene / "frames").string(), "holds no two mesh files, which a step needs");
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    steps.push_back({scene, frames[i], frames[i + 1], digits_at_end(fs::path(frames[i]).stem().string())});
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

json::JsonDocument read_list(const std::string& file) {
  const auto content = io::WholeFile::read(file, io::kJsonLimits, throw_if_interrupted);
  return json::parse_json(content.bytes());
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
      node.fail(fmt::format("{} is no {}, which have the numbers {} to {}", number, name, first, first + count - 1));
    }
    return static_cast<MeshIndex>(number - first);
  }

  const Mesh& mesh_;
  std::vector<MeshIndex> edges_;  // by their order in the data set
};

/// Appends the pairs of one kind. @param suffix  "ee" or "vf"
void add_judged(const PublicStepFiles& files, const char* suffix, const PublicNumbers& numbers,
                std::vector<JudgedPair>& judged) {
  const std::string boxes = (files.scene / "boxes" / (files.number + suffix + ".json")).string();
  const std::string truths = (files.scene / "mma_bool" / (files.number + suffix + "_mma_bool.json")).string();
  std::error_code ignored;
  const bool has_boxes = fs::exists(boxes, ignored), has_truths = fs::exists(truths, ignored);
  if (!has_boxes && !has_truths) return;
  if (!has_boxes) io::fail(boxes, fmt::format("is missing: {} says the truth about its pairs", io::printable(truths)));
  if (!has_truths)
    io::fail(truths, fmt::format("is missing: it says whether the pairs of {} touch", io::printable(boxes)));
  const auto read_pairs = [&] {
    const json::JsonDocument document = read_list(boxes);
    const bool edges = std::string_view(suffix) == "ee";
    std::vector<MeshPair> pairs;
    for (const json::JsonNode& node : json::JsonNode(document.value(), "the list").items()) {
      const std::vector<json::JsonNode> two = node.items();
      if (two.size() != 2) node.fail(fmt::format("has {} numbers; a pair has 2", two.size()));
      if (edges) {
        const MeshIndex a = numbers.edge(two[0]), b = numbers.edge(two[1]);
        pairs.push_back({Kind::edge_edge, std::min(a, b), std::max(a, b)});
      } else {
        pairs.push_back({Kind::vertex_face, numbers.vertex(two[0]), numbers.face(two[1])});
      }
    }
    return pairs;
  };
  const auto read_truths = [&] {
    const json::JsonDocument document = read_list(truths);
    std::vector<bool> all;
    for (const json::JsonNode& node : json::JsonNode(document.value(), "the list").items())
      all.push_back(node.boolean());
    return all;
  };
  const auto of_file = [](const std::string& file, const auto& read_it) {
    try {
      return read_it();
    } catch (const FileError&) {
      throw;
    } catch (const Error& error) {
      io::fail(file, error.what());
    }
  };
  const std::vector<MeshPair> pairs = of_file(boxes, read_pairs);
  const std::vector<bool> touches = of_file(truths, read_truths);
  if (pairs.size() != touches.size()) {
    io::fail(truths, fmt::format("has {}, and {} has {}", counted(touches.size(), "truth"), io::printable(boxes),
                                 counted(pairs.size(), "pair")));
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) judged.push_back({pairs[i], touches[i]});
}

}  // namespace

std::string PublicStepFiles::label() const {
  return fs::path(scene).lexically_normal().filename().string() + (number.empty() ? "" : " " + number);
}

std::vector<PublicStepFiles> find_public_steps(const std::vector<std::string>& folders) {
  std::vector<PublicStepFiles> steps;
  for (const std::string& name : folders) {
    fs::path folder = name;
    if (!folder.has_filename()) folder = folder.parent_path();  // "scenes/"
    const std::size_t before = steps.size();
    if (is_scene(folder)) {
      add_steps(folder, steps);
    } else {
      for (const fs::path& inner : contents_of(folder)) {
        if (is_scene(inner)) add_steps(inner, steps);
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
  step.name = files.label();
  const frames::Frame before = read(files.before, nullptr), after = read(files.after, before.topology);
  sequence::check_same_elements(*before.topology, {files.before}, *after.topology, {files.after});
  step.mesh = sequence::mesh_of(*before.topology, {}, files.before);
  step.x0 = before.positions;
  step.x1 = after.positions;
  const PublicNumbers numbers(step.mesh);
  for (const char* suffix : {"ee", "vf"}) add_judged(files, suffix, numbers, step.judged);
  return step;
}

}  // namespace touchstone::cli
