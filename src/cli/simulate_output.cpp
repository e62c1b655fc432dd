// SPDX-License-Identifier: MIT
#include "cli/simulate_output.hpp"

#include <fmt/format.h>

#include "cli/interrupt.hpp"
#include "io/query_writer.hpp"
#include "report/gnuplot.hpp"
#include "sim/checkpoint.hpp"

namespace touchstone::cli {
namespace {

namespace fs = std::filesystem;

/// Energies and contacts over time, from the table beside it.
constexpr const char* kPlotScript =
    "set datafile separator ','\n"
    "set xlabel 'time [s]'\n"
    "set grid lc rgb '#E4E4E4' lt 1\n"
    "set key outside right center\n"
    "set lmargin 12\n"
    "set rmargin 20\n"
    "do for [ending in 'svg png'] {\n"
    "  if (ending eq 'svg') { set terminal svg size 1000,700 background 'white' } else { set terminal pngcairo size "
    "1000,700 }\n"
    "  set output 'energies.'.ending\n"
    "  set multiplot layout 2,1\n"
    "  set ylabel 'energy [J]'\n"
    "  plot 'energies.csv' skip 1 using 2:8 with lines lw 2 lc rgb '#000000' title 'total', \\\n"
    "       '' skip 1 using 2:3 with lines lw 1.5 lc rgb '#0072B2' title 'kinetic', \\\n"
    "       '' skip 1 using 2:4 with lines lw 1.5 lc rgb '#E69F00' title 'stretch', \\\n"
    "       '' skip 1 using 2:5 with lines lw 1.5 lc rgb '#009E73' title 'bend', \\\n"
    "       '' skip 1 using 2:6 with lines lw 1.5 lc rgb '#CC79A7' title 'twist', \\\n"
    "       '' skip 1 using 2:7 with lines lw 1.5 lc rgb '#999999' title 'load'\n"
    "  set ylabel 'pairs a step'\n"
    "  plot 'energies.csv' skip 1 using 2:10 with lines lw 1.5 lc rgb '#56B4E9' title 'close', \\\n"
    "       '' skip 1 using 2:11 with impulses lc rgb '#D55E00' title 'contacts'\n"
    "  unset multiplot\n"
    "  set output\n"
    "}\n";

}  // namespace

void write_whole(const std::string& path, std::string_view text) {
  io::OutputFile file(path);
  file.write(text);
  file.commit();
}

SimulateOutput::SimulateOutput(const SimulateOptions& options, sim::Simulation& simulation)
    : options_(&options), simulation_(&simulation) {
  const auto open = [&](const std::string& path, std::optional<io::OutputFile>& file, const std::string& header) {
    if (path.empty()) return;
    file.emplace(path);
    file->write(header);
  };
  open(options.proof, proof_, sim::proof_header());
  std::string energies = options.energies;
  if (!options.out.empty()) {
    frames_ = fs::path(options.out) / "frames";
    folders_.make(frames_);
    if (energies.empty()) energies = (fs::path(options.out) / "energies.csv").string();
    // What cannot be written is found out before the run, not after.
    frame_index_.emplace((frames_ / "frames.vtk.series").string());
  }
  open(energies, energies_, sim::energy_header());
  open(options.checkpoint, checkpoint_, "");
  if (energies_) energies_->write(sim::energy_row(simulation, {}));
  if (!options.queries.empty()) {
    folders_.make(options.queries);
    simulation.watch([this](const Query& query, const Answer& answer) { write_query(query, answer); });
  }
  if (!options.out.empty()) write_frame();
}

void SimulateOutput::write_query(const Query& query, const Answer& answer) {
  auto& file = queries_[static_cast<std::size_t>(query.kind)];
  if (!file) {
    const fs::path folder = fs::path(options_->queries) / kind_name(query.kind);
    folders_.make(folder);
    file.emplace((folder / "candidates.csv").string());
  }
  std::string text;
  io::append_query(text, query, answer.contact);
  file->write(text);
}

void SimulateOutput::write_frame() {
  const std::string name = fmt::format("frame-{:06}.vtk", simulation_->steps());
  write_whole((frames_ / name).string(), sim::vtk_frame(*simulation_));
  written_.push_back({name, simulation_->state().time});
  since_frame_ = 0;
}

void SimulateOutput::step(const std::vector<sim::StepRecord>& records) {
  if (proof_) {
    for (const auto& record : records) proof_->write(sim::proof_row(record));
  }
  if (energies_) energies_->write(sim::energy_row(*simulation_, records));
  if (!options_->out.empty() && ++since_frame_ >= options_->frame_every) write_frame();
}

void SimulateOutput::write_tables() {
  if (proof_) proof_->commit();
  if (energies_) energies_->commit();
  for (auto& file : queries_) {
    if (file) file->commit();
  }
  if (checkpoint_) {
    checkpoint_->write(sim::checkpoint_to_json(*simulation_));
    checkpoint_->commit();
  }
  folders_.keep();
  if (!frame_index_) return;
  frame_index_->write(sim::vtk_series(written_));
  frame_index_->commit();
}

void SimulateOutput::finish_early() {
  if (frame_index_ && since_frame_ > 0) write_frame();
  write_tables();
}

std::string SimulateOutput::finish() {
  write_tables();
  if (options_->out.empty()) return {};
  if (!options_->energies.empty()) return {};
  write_whole((fs::path(options_->out) / "energies.gp").string(), kPlotScript);
  const auto gnuplot = report::find_gnuplot();
  if (!gnuplot)
    return "no gnuplot in PATH, so energies are not drawn; `gnuplot energies.gp` in " + options_->out + " does it";
  report::run_gnuplot(*gnuplot, options_->out, "energies.gp");
  return {};
}

}  // namespace touchstone::cli
