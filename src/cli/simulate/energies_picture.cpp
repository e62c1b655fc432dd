// SPDX-License-Identifier: MIT
#include "cli/simulate/energies_picture.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "view/chart.hpp"

namespace touchstone::cli {
namespace {

constexpr std::size_t kMostRows = 1000;

}  // namespace

StepValues step_values(const sim::Simulation& simulation, const std::vector<sim::SubstepRecord>& records) {
  const sim::Energies e = simulation.energies();
  std::uint64_t close = 0, contacts = 0, crossings = 0;
  for (const sim::SubstepRecord& record : records) {
    close += record.response.close + record.bodies.close;
    contacts += record.response.contacts + record.bodies.contacts;
    crossings += record.proof.crossings;
  }
  return {e.total(),
          e.kinetic,
          e.stretch,
          e.bend,
          e.twist,
          e.load,
          static_cast<double>(close),
          static_cast<double>(contacts),
          static_cast<double>(crossings)};
}

void EnergiesPicture::add(double time, const StepValues& values) {
  const auto merge = [](const Row& earlier, Row& later) {
    for (std::size_t i = kEnergyNames.size(); i < later.values.size(); ++i) later.values[i] += earlier.values[i];
  };
  Row row{time, values};
  if (since_ < stride_ && rows_.size() > 1) {
    merge(rows_.back(), row);
    rows_.back() = row;
    ++since_;
    return;
  }
  rows_.push_back(row);
  since_ = 1;
  if (rows_.size() <= kMostRows) return;
  // The first row is the start, which has no counts; the last one may be half full.
  std::vector<Row> kept{rows_.front()};
  for (std::size_t i = 2; i < rows_.size(); i += 2) {
    merge(rows_[i - 1], rows_[i]);
    kept.push_back(rows_[i]);
  }
  since_ += stride_;
  stride_ *= 2;
  rows_ = std::move(kept);
}

std::string EnergiesPicture::svg() const {
  const auto chart = [&](const std::string& title, const char* axis, const auto& names, std::size_t first) {
    view::Chart made{title, {"time [s]"}, {axis}, {}};
    for (std::size_t i = 0; i < names.size(); ++i) {
      view::ChartSeries series;
      series.name = names[i];
      series.colour = static_cast<int>(first == 0 ? i : i + 1);
      series.marks = false;
      for (const Row& row : rows_) series.points.push_back({row.time, row.values[first + i]});
      made.series.push_back(std::move(series));
    }
    return made;
  };
  const std::string since = stride_ == 1 ? "Pairs since the step before"
                                         : fmt::format("Pairs since the point before, in up to {} steps", stride_);
  return view::chart_file(
      "Energies and contacts", "",
      {chart("Energies", "J", kEnergyNames, 0), chart(since, "number", kCountNames, kEnergyNames.size())});
}

}  // namespace touchstone::cli
