// SPDX-License-Identifier: MIT
#include "cli/bodies/pose_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <unordered_map>

#include "cli/shared/nearest_name.hpp"
#include "cli/shared/progress/interrupt.hpp"
#include "cli/shared/words.hpp"
#include "io/answers/answer_writer.hpp"
#include "io/answers/claim_columns.hpp"
#include "io/csv_records.hpp"
#include "io/fail.hpp"
#include "io/times.hpp"

namespace touchstone::cli {
namespace {

enum PoseColumn : std::size_t { kTime, kBody, kX, kY, kZ, kQw, kQx, kQy, kQz, kColumns };

constexpr std::array<std::string_view, kColumns> kColumnNames = {"time", "body", "x", "y", "z", "qw", "qx", "qy", "qz"};
constexpr std::string_view kExampleRow = "time,body,x,y,z,qw,qx,qy,qz";

template <std::size_t N>
bool is_one_of(const std::array<std::string_view, N>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

constexpr std::array<std::string_view, 4> kTimes = {"time", "t", "timestamp", "stamp"};
constexpr std::array<std::string_view, 5> kBodies = {"body", "name", "object", "link", "id"};
constexpr std::array<std::string_view, 7> kPositions = {"p", "t", "p_", "t_", "pos_", "position_", "translation_"};
constexpr std::array<std::string_view, 6> kQuaternions = {"q",           "q_",           "quat_",
                                                          "quaternion_", "orientation_", "rotation_"};

/// "time, t, timestamp, stamp": what the column may be called.
std::string names_of(PoseColumn column) {
  std::string text;
  const auto add = [&](std::string_view prefix, std::string_view name = {}) {
    text.append(text.empty() ? "" : ", ").append(prefix).append(name);
  };
  const std::string_view name = kColumnNames[column];
  if (column == kTime) {
    for (const auto known : kTimes) add(known);
  } else if (column == kBody) {
    for (const auto known : kBodies) add(known);
  } else if (column < kQw) {
    add(name);
    for (const auto prefix : kPositions) add(prefix, name);
  } else {
    for (const auto prefix : kQuaternions) add(prefix, name.substr(1));
  }
  return text;
}

/// The column of a name in lower case. A name without a prefix, such as x, gives `bare`.
std::optional<PoseColumn> column_named(std::string_view name, PoseColumn bare) {
  if (is_one_of(kTimes, name)) return kTime;
  if (is_one_of(kBodies, name)) return kBody;
  if (name.starts_with("pose_")) name.remove_prefix(5);
  const std::size_t letter = name.empty() ? std::string_view::npos : std::string_view("wxyz").find(name.back());
  if (letter == std::string_view::npos) return std::nullopt;
  const std::string_view prefix = name.substr(0, name.size() - 1);
  const auto of_position = static_cast<PoseColumn>(kX + letter - 1),
             of_quaternion = static_cast<PoseColumn>(kQw + letter);
  if (is_one_of(kQuaternions, prefix) || (prefix.empty() && letter == 0)) return of_quaternion;
  if (letter == 0) return std::nullopt;
  if (is_one_of(kPositions, prefix)) return of_position;
  return !prefix.empty() ? std::nullopt : std::optional(bare == kX ? of_position : of_quaternion);
}

/// Reads rows into poses.
class PoseReader {
 public:
  PoseReader(const std::string& file, const std::vector<std::string>& bodies)
      : records_(io::InputFile::open(without_dash(file), throw_if_interrupted)), bodies_(bodies), rows_(bodies.size()) {
    for (std::size_t i = 0; i < bodies.size(); ++i) numbers_.emplace(bodies[i], i);
  }

  RecordedPoses read(std::optional<QuaternionOrder> order) {
    if (!records_.next()) {
      io::fail(records_.name(), fmt::format("is empty; its first line names the columns: {}", kExampleRow));
    }
    column_count_ = records_.fields().size();
    const auto is_number = [](std::string_view field) { return io::parse_rounded_double(field).has_value(); };
    if (std::none_of(records_.fields().begin(), records_.fields().end(), is_number)) {
      take_names(order);
    } else {
      take_order(order);
      take_row();
    }
    while (records_.next()) take_row();
    return by_times();
  }

 private:
  struct PoseRow {
    double time = 0;
    std::uint64_t row = 0;
    Pose pose;
  };

  void take_names(std::optional<QuaternionOrder> order) {
    std::vector<std::string> names;
    bool has_positions = false;
    for (const std::string_view field : records_.fields()) {
      std::string name = io::in_lower_case(field);
      for (char& c : name) c = c == ' ' || c == '-' || c == '.' || c == '/' ? '_' : c;
      has_positions = has_positions || (name.size() > 1 && column_named(name, kX) == kX);
      names.push_back(std::move(name));
    }
    index_.fill(column_count_);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string_view field = records_.fields()[i];
      // Beside px, py and pz, a lone x is that of the quaternion w, x, y, z.
      const auto column = column_named(names[i], has_positions ? kQx : kX);
      if (!column) {
        result_.unread.push_back(io::in_quotes(field));
        continue;
      }
      if (index_[*column] != column_count_) {
        records_.refuse(fmt::format("the columns {} and {} both say {}; rename or remove one",
                                    io::in_quotes(records_.fields()[index_[*column]]), io::in_quotes(field),
                                    kColumnNames[*column]));
      }
      index_[*column] = i;
    }
    for (std::size_t i = 0; i < kColumns; ++i) {
      if (index_[i] != column_count_) continue;
      records_.refuse(
          fmt::format("no column is {}: the first line names the columns with commas between them, in any "
                      "order, such as {}; names of {} are {}",
                      kColumnNames[i], kExampleRow, kColumnNames[i], names_of(static_cast<PoseColumn>(i))));
    }
    if (order) records_.refuse("this line names the columns, and --quaternion is for files without such a line");
  }

  void take_order(std::optional<QuaternionOrder> order) {
    if (column_count_ != kColumns) {
      records_.refuse(
          fmt::format("{}; where no first line names the columns, a row is time,body,x,y,z and the four "
                      "numbers of a quaternion",
                      counted(column_count_, "column")));
    }
    if (!order) {
      records_.refuse(
          fmt::format("the first line names no columns, so the order of the quaternion is not known: write "
                      "{} above it, or give --quaternion wxyz or --quaternion xyzw",
                      kExampleRow));
    }
    index_ = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    if (*order == QuaternionOrder::xyzw) index_ = {0, 1, 2, 3, 4, 8, 5, 6, 7};
  }

  double number(PoseColumn column) const {
    const std::string_view field = records_.fields()[index_[column]];
    const auto value = io::parse_finite_double(field);
    if (!value)
      records_.refuse(fmt::format("{} is {}; it must be a finite number", kColumnNames[column], io::in_quotes(field)));
    return *value;
  }

  void take_row() {
    if (records_.fields().size() != column_count_) {
      records_.refuse(
          fmt::format("{} where the first line has {}", counted(records_.fields().size(), "column"), column_count_));
    }
    const std::string name(io::text_of_field(records_.fields()[index_[kBody]]));
    const auto found = numbers_.find(name);
    if (found == numbers_.end()) refuse_name(name);
    PoseRow row{number(kTime) + 0.0, records_.row(), {}};  // -0 becomes 0
    for (std::size_t i = 0; i < 4; ++i) row.pose.orientation[i] = number(static_cast<PoseColumn>(kQw + i));
    row.pose.position = {number(kX), number(kY), number(kZ)};
    const auto& [w, x, y, z] = row.pose.orientation;
    if (w == 0 && x == 0 && y == 0 && z == 0) {
      records_.refuse("the quaternion is zero, which is no orientation; no turn is qw,qx,qy,qz = 1,0,0,0");
    }
    if (!(std::abs(std::hypot(std::hypot(w, x), std::hypot(y, z)) - 1) <= 1e-3) && result_.not_unit++ == 0) {
      result_.not_unit_row = row.row;
    }
    const std::string spacing = spacing_text(row.time);
    if (!spacing.empty() && std::abs(row.time) >= farthest_) {
      farthest_ = std::abs(row.time);
      result_.time_spacing = spacing;
    }
    std::vector<PoseRow>& rows = rows_[found->second];
    if (!rows.empty() && rows.back().time == row.time) {
      records_.refuse(fmt::format("body {} is at time {} twice, here and in row {}; it has one pose at each time{}",
                                  io::in_quotes(name), row.time, rows.back().row,
                                  spacing.empty() ? spacing : ", and " + spacing));
    }
    if (!rows.empty() && !(rows.back().time < row.time)) {
      records_.refuse(
          fmt::format("time {} of body {} comes after its time {} in row {}; the times of each body must "
                      "ascend",
                      row.time, io::in_quotes(name), rows.back().time, rows.back().row));
    }
    rows.push_back(row);
  }

  [[noreturn]] void refuse_name(const std::string& name) const {
    std::vector<std::string> shown;
    for (const std::string& body : bodies_) shown.push_back(io::printable(body));
    std::string meant = did_you_mean(io::printable(name), shown);
    if (meant.empty()) {
      constexpr std::size_t kShown = 10;
      for (std::size_t i = 0; i < std::min(shown.size(), kShown); ++i) {
        meant += (i == 0 ? "; the bodies are " : ", ") + io::shortened(shown[i]);
      }
      if (shown.size() > kShown) meant += fmt::format(" and {} more", shown.size() - kShown);
    }
    records_.refuse(fmt::format("no file is the body {}{}", io::in_quotes(name), meant));
  }

  /// Every body that moves has a pose at each time.
  RecordedPoses by_times() {
    for (const auto& rows : rows_) {
      for (const PoseRow& row : rows) result_.times.push_back(row.time);
    }
    std::vector<double>& times = result_.times;
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    if (times.size() < 2) {
      io::fail(records_.name(), fmt::format("has poses at {}; a step needs two", counted(times.size(), "time")));
    }
    for (std::size_t body = 0; body < rows_.size(); ++body) {
      std::vector<PoseRow>& rows = rows_[body];
      for (std::size_t i = 0; i < times.size() && !rows.empty(); ++i) {
        if (i < rows.size() && rows[i].time == times[i]) continue;
        io::fail(records_.name(), fmt::format("body {} has no pose at time {}, which other bodies have; a body that "
                                              "moves has one at each time, and a body at rest has none at all",
                                              io::in_quotes(bodies_[body]), times[i]));
      }
      std::vector<Pose>& poses = result_.bodies.emplace_back();
      poses.reserve(rows.size());
      for (const PoseRow& row : rows) poses.push_back(row.pose);
      rows = {};
    }
    return std::move(result_);
  }

  io::CsvRecords records_;
  const std::vector<std::string>& bodies_;
  std::unordered_map<std::string, std::size_t> numbers_;  ///< of the bodies
  std::size_t column_count_ = 0;
  std::array<std::size_t, kColumns> index_{};  ///< the place of each column in a row
  std::vector<std::vector<PoseRow>> rows_;     ///< of each body
  double farthest_ = 0;                        ///< the magnitude of the time of which `time_spacing` is told
  RecordedPoses result_;
};

}  // namespace

std::size_t RecordedPoses::at_rest() const noexcept {
  return static_cast<std::size_t>(
      std::count_if(bodies.begin(), bodies.end(), [](const auto& one) { return one.empty(); }));
}

std::string spacing_text(double time) {
  const double size = std::abs(time), spacing = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
  return spacing > 1e-6 ? fmt::format("times are doubles, which are {:g} apart there", spacing) : "";
}

double RecordedPoses::time_in(std::size_t step, double fraction) const noexcept {
  return std::lerp(times[step], times[step + 1], fraction);
}

Pose RecordedPoses::at(std::size_t body, std::size_t time) const {
  return bodies[body].empty() ? Pose() : bodies[body][time];
}

RecordedPoses read_poses(const std::string& file, const std::vector<std::string>& bodies,
                         std::optional<QuaternionOrder> order) {
  return PoseReader(file, bodies).read(order);
}

}  // namespace touchstone::cli
