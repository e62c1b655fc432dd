// SPDX-License-Identifier: MIT
#include "report/report.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

#include "seeded/rng.hpp"
#include "io/fail.hpp"
#include "io/output_file.hpp"
#include "report/csv.hpp"
#include "report/families.hpp"
#include "report/gnuplot.hpp"
#include "report/markdown.hpp"
#include "report/plots.hpp"

namespace touchstone::report {
namespace {

namespace fs = std::filesystem;

const std::vector<double> kTolerances{1e-3, 1e-6, 1e-9};
constexpr std::array<int, 11> kExponents{-900, -600, -300, -100, -30, 0, 30, 100, 300, 600, 900};
constexpr double kMeasuring = 0.9;  ///< share of the time; the rest is drawing

/// Numbers of queries, and seconds.
struct Amounts {
  std::size_t simulation, edges, steps;  ///< candidates a scene and kind; how large and long the scenes are
  std::size_t random, near, scale;
  Effort effort, scale_effort;
};

Amounts amounts(bool quick) {
  if (quick) return {300, 1000, 4, 200, 300, 60, {0.01, 3, 0.0002, 2}, {0.003, 3, 0.0002, 2}};
  return {6000, 4000, 20, 4000, 4000, 1000, {0.3, 7, 0.01, 3}, {0.1, 5, 0.01, 3}};
}

std::vector<QuerySet> scale_sets(std::uint64_t seed, std::size_t count) {
  // Half ordinary and half near ones, in turns.
  QuerySet base = random_sets(seed, count / 2).front();
  const auto near = near_sets(seed, count - count / 2).front().queries;
  base.queries.insert(base.queries.end(), near.begin(), near.end());
  base.name = "scale/" + std::string(kind_name(base.kind));
  base.about = "One set of " + std::to_string(count) +
               " edge-edge queries, half of them like random/edge-edge and half like near/edge-edge, with every "
               "coordinate times a power of two";
  shuffle(base.queries, seeded::seed_of_part(seed, 30));
  std::vector<QuerySet> sets;
  for (const int exponent : kExponents) {
    sets.push_back(base);
    sets.back().queries = scaled(base.queries, exponent);
  }
  return sets;
}

std::vector<Contestant> usual_ones(const std::vector<Contestant>& all) {
  std::vector<Contestant> usual;
  for (const Contestant& contestant : all) {
    if (contestant.is_usual()) usual.push_back(contestant);
  }
  return usual;
}

/// Makes the folder. @throws FileError
void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder)) error = std::make_error_code(std::errc::not_a_directory);
  if (error) io::fail(folder.string(), "no folder can be made here: " + io::system_reason(error.value()));
}

void write_whole(const fs::path& path, const std::string& text) {
  io::OutputFile file(path.string());
  file.write(text);
  file.commit();
}

/// A folder for files that are not complete yet.
class DrawingFolder {
 public:
  explicit DrawingFolder(const fs::path& beside) : path_(beside / (".drawing-" + std::to_string(::getpid()))) {
    make_folder(path_);
  }
  ~DrawingFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  DrawingFolder(const DrawingFolder&) = delete;
  DrawingFolder& operator=(const DrawingFolder&) = delete;
  const fs::path& path() const noexcept { return path_; }

 private:
  fs::path path_;
};

void draw(const std::vector<Plot>& all, const std::string& gnuplot, const fs::path& folder, const Progress& progress) {
  const DrawingFolder drawing(folder);
  double done = 0;
  for (const Plot& plot : all) {
    progress("drawing", kMeasuring + (1 - kMeasuring) * done++ / static_cast<double>(all.size()));
    write_whole(drawing.path() / (plot.name + ".gp"), plot.script);
    run_gnuplot(gnuplot, drawing.path().string(), plot.name + ".gp");
    for (const char* ending : {".svg", ".png"}) {
      std::error_code error;
      fs::rename(drawing.path() / (plot.name + ending), folder / (plot.name + ending), error);
      if (error)
        io::fail((folder / (plot.name + ending)).string(), "gnuplot has not drawn it, or it cannot be replaced");
    }
  }
}

}  // namespace

std::size_t most_given(const Size& size) noexcept { return size.quick ? 400 : 20'000; }

Report make_report(const Size& size, std::vector<QuerySet> given, const Progress& progress) {
  const Amounts amount = amounts(size.quick);
  Report report;
  report.size = size;
  report.contestants = contestants(kTolerances);

  progress("generating", 0);
  std::vector<QuerySet> sets = simulation_sets(size.seed, amount.simulation, amount.edges, amount.steps);
  for (auto* more : {&given}) std::move(more->begin(), more->end(), std::back_inserter(sets));
  for (auto&& made : {random_sets(size.seed, amount.random), near_sets(size.seed, amount.near)}) {
    sets.insert(sets.end(), made.begin(), made.end());
  }
  std::vector<QuerySet> scales = scale_sets(size.seed, amount.scale);

  const double total = static_cast<double>(sets.size()) + 0.3 * static_cast<double>(scales.size());
  double done = 0;
  for (QuerySet& set : sets) {
    if (set.queries.empty()) continue;
    shuffle(set.queries, seeded::seed_of_part(size.seed, 20));
    const std::string name = set.name;
    const auto pulse = [&] { progress(name, kMeasuring * done / total); };
    report.sets.push_back(measure(std::move(set), report.contestants, amount.effort, pulse));
    done += 1;
  }
  const auto usual = usual_ones(report.contestants);
  for (std::size_t i = 0; i < scales.size(); ++i) {
    const auto pulse = [&] { progress("scales", kMeasuring * done / total); };
    report.scales.push_back(measure(std::move(scales[i]), usual, amount.scale_effort, pulse));
    report.scales.back().exponent = kExponents[i];
    done += 0.3;
  }
  return report;
}

std::string write_report(const Report& report, const std::string& folder, const Progress& progress) {
  const fs::path plot_folder = fs::path(folder) / "plots";
  make_folder(plot_folder);
  write_whole(fs::path(folder) / "report.csv", csv_text(report));
  const auto gnuplot = find_gnuplot();
  const auto all = plots(report);
  for (const Plot& plot : all) write_whole(plot_folder / (plot.name + ".gp"), plot.script);
  if (gnuplot) draw(all, *gnuplot, plot_folder, progress);
  write_whole(fs::path(folder) / "report.md", markdown_text(report, gnuplot.has_value()));
  if (gnuplot) return {};
  return "no gnuplot in PATH, so the plots are not drawn: install it (gnuplot-nox on Debian and Ubuntu, gnuplot on "
         "Fedora and Arch) and run `gnuplot *.gp` in " +
         plot_folder.string();
}

}  // namespace touchstone::report
