// SPDX-License-Identifier: MIT
#include "cli/simulate/paths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <vector>

#include <touchstone/error.hpp>
#include <touchstone/query.hpp>

#include "cli/shared/proofs/motion_proofs.hpp"
#include "io/fail.hpp"
#include "io/queries/kind_of_file.hpp"
#include "scene/shipped_scenes.hpp"

namespace touchstone::cli {
namespace {

namespace fs = std::filesystem;

/// The absolute path with links resolved, as far as the path exists.
fs::path resolved_path(const fs::path& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  fs::path resolved = fs::weakly_canonical(absolute, error);
  return error || resolved.empty() ? absolute.lexically_normal() : resolved;
}

struct NamedFile {
  std::string option;  // the option that names the file
  fs::path path, resolved;
  bool input = false;

  NamedFile(std::string name, const fs::path& at, bool is_input)
      : option(std::move(name)), path(at), resolved(resolved_path(at)), input(is_input) {}
};

class Files {
 public:
  void add(const char* option, const std::string& path, bool input = false) {
    if (!path.empty()) files_.emplace_back(option, path, input);
  }
  void add_in(const char* option, const fs::path& folder, std::string_view name) {
    files_.emplace_back(option, folder / name, false);
  }
  void frames_in(const fs::path& folder) { frames_ = resolved_path(folder); }
  void candidates_in(const fs::path& folder) { candidates_.push_back(resolved_path(folder)); }

  void check() const {
    for (const NamedFile& file : files_) {
      for (const NamedFile& other : files_) {
        if (&file < &other) check_same(file, other);
        if (&file != &other) check_inside(file, other);
      }
      if (is_frame(file)) {
        throw Error(fmt::format("{} names {}, which may be one of the frames of --out", file.option, shown(file)));
      }
      if (is_candidates(file)) {
        throw Error(fmt::format("{} names {}, which may be one of the files of --queries", file.option, shown(file)));
      }
    }
  }

 private:
  static std::string shown(const NamedFile& file) { return io::printable(file.path.string()); }

  static void check_same(const NamedFile& a, const NamedFile& b) {
    if (a.resolved != b.resolved || (a.input && b.input)) return;
    const NamedFile& out = a.input ? b : a;
    if (a.input || b.input) {
      // A run reads its old checkpoint whole before it replaces that by the new one.
      if (a.option == "--resume" && b.option == "--checkpoint") return;
      throw Error(fmt::format("{} would write over {}, which is read", out.option, shown(out)));
    }
    std::error_code ignored;
    if (fs::is_character_file(a.resolved, ignored)) return;  // such as /dev/null
    throw Error(fmt::format("{} and {} name the same file, {}", a.option, b.option, shown(b)));
  }

  /// Whether `inner` could be written only if `outer` were a folder.
  static void check_inside(const NamedFile& outer, const NamedFile& inner) {
    if (outer.input || inner.input || outer.resolved == inner.resolved) return;
    const auto [end, rest] =
        std::mismatch(outer.resolved.begin(), outer.resolved.end(), inner.resolved.begin(), inner.resolved.end());
    if (end != outer.resolved.end()) return;
    throw Error(fmt::format("{} names {}, which {} needs as a folder", outer.option, shown(outer), inner.option));
  }

  bool is_frame(const NamedFile& file) const {
    const std::string name = file.resolved.filename().string();
    return !frames_.empty() && file.resolved.parent_path() == frames_ && name.starts_with("frame-") &&
           name.ends_with(".vtk");
  }

  bool is_candidates(const NamedFile& file) const {
    const std::string name = file.resolved.filename().string();
    return std::count(candidates_.begin(), candidates_.end(), file.resolved.parent_path()) > 0 &&
           name.starts_with("candidates-") && name.ends_with(".csv");
  }

  std::vector<NamedFile> files_;
  std::vector<fs::path> candidates_;  // folders
  fs::path frames_;                   // empty: the run writes no frames
};

}  // namespace

std::string frame_name(std::uint64_t step) { return fmt::format("frame-{:06}.vtk", step); }

std::string candidates_name(double separation) {
  return separation > 0 ? fmt::format("candidates-{:a}.csv", separation) : "candidates.csv";
}

void check_paths(const SimulateOptions& options) {
  Files files;
  if (sim::find_shipped_scene(options.scene) == nullptr) files.add("SCENE", options.scene, true);
  files.add("--resume", options.resume, true);
  files.add("--proof", options.proof);
  files.add("--energies", options.energies);
  files.add("--checkpoint", options.checkpoint);
  files.add("--scene-out", options.scene_out);
  files.add("--html", options.html);
  if (!options.out.empty()) {
    const fs::path out = options.out;
    for (const char* ending : {".csv", ".svg"}) files.add_in("--out", out, std::string(kEnergies) + ending);
    files.add_in("--out", out / kFrameFolder, kFrameIndex);
    files.frames_in(out / kFrameFolder);
  }
  if (!options.prove.empty()) {
    for (const char* name : {MotionProofs::kMotionFile, MotionProofs::kProofsFile}) {
      files.add_in("--prove", options.prove, name);
    }
  }
  if (!options.queries.empty()) {
    for (const Kind kind : kKinds) {
      const fs::path folder = fs::path(options.queries) / name_of(kind);
      files.add_in("--queries", folder, candidates_name(0));
      files.candidates_in(folder);
    }
  }
  files.check();
}

}  // namespace touchstone::cli
