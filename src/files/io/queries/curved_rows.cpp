// SPDX-License-Identifier: MIT
#include "io/queries/curved_rows.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <span>

#include "io/fail.hpp"
#include "io/queries/query_chunks.hpp"
#include "io/times.hpp"
#include "numbers/roots/vanishing.hpp"

namespace touchstone::io {
namespace {

constexpr std::string_view kFormatName = "touchstone-curved";
constexpr std::string_view kQueryRow = "query,truth";
constexpr std::string_view kMotionRow =
    "motion,index,q0_w,q0_x,q0_y,q0_z,q1_w,q1_x,q1_y,q1_z,p0_x,p0_y,p0_z,p1_x,p1_y,p1_z";
constexpr std::string_view kBodyRow = "body,index,x,y,z";
constexpr std::string_view kCurveRow = "curve,x,y,z and three columns more for each further control point";

constexpr std::size_t kMotionNumbers = 14;
constexpr std::size_t kMostPoints = 4;
constexpr std::size_t kMotions = 4;
constexpr std::size_t kLongestNumber = 4096;
constexpr std::size_t kMostColumns = 2 + kMotionNumbers;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string_view first_column(std::string_view row) { return trimmed(row.substr(0, row.find(','))); }

std::string at_column(std::size_t column, std::string_view name) {
  return "column " + std::to_string(column + 1) + " (" + std::string(name) + ") ";
}

/// Column `column` of the row whose columns `layout` names.
std::string_view column_name(std::string_view layout, std::size_t column) {
  for (; column > 0; --column) layout.remove_prefix(layout.find(',') + 1);
  return layout.substr(0, layout.find(','));
}

std::string text_of(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

std::string corner_names(Kind kind) {
  std::string names;
  for (std::size_t i = 0; i < corner_count(kind); ++i) names.append(" ").append(corner_name(kind, i));
  return names;
}

std::string expected_corners(Kind kind) {
  const std::string name(name_of(kind));
  return (kind == Kind::edge_edge ? "an " : "a ") + name + " query has " + std::to_string(corner_count(kind)) + ":" +
         corner_names(kind);
}

}  // namespace

struct CurvedRows::Columns {
  explicit Columns(std::string_view row) {
    for (std::size_t start = 0; start != std::string_view::npos; ++count) {
      const std::size_t comma = row.find(',', start);
      if (count < text.size()) text[count] = trimmed(row.substr(start, comma - start));
      start = comma == std::string_view::npos ? comma : comma + 1;
    }
  }

  /// Reads the numbers from column `first` on. @returns why one of them is refused, or an empty text
  template <class Name>
  std::string read_numbers(std::size_t first, std::span<double> numbers, Name name) const {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const std::string_view number = text[first + i];
      if (number.size() > kLongestNumber) {
        return at_column(first + i, name(first + i)) + "has " + std::to_string(number.size()) +
               " characters; at most " + std::to_string(kLongestNumber) + " are read";
      }
      const auto value = parse_finite_double(number);
      if (!value) {
        return at_column(first + i, name(first + i)) + "is " + in_quotes(number) + ", which " +
               std::string(fault_of_double(number)) + "; it must be a decimal or a hexfloat, such as 0.25 or 0x1p-2";
      }
      numbers[i] = *value;
    }
    return {};
  }

  /// The index of a motion. @returns why it is refused, or an empty text
  std::string read_index(std::size_t& index) const {
    if (text[1].size() == 1 && text[1].front() >= '0' && text[1].front() < static_cast<char>('0' + kMotions)) {
      index = static_cast<std::size_t>(text[1].front() - '0');
      return {};
    }
    return at_column(1, "index") + "is " + in_quotes(text[1]) + "; the motions of a query are numbered 0 to " +
           std::to_string(kMotions - 1);
  }

  std::string fault_of_count(std::string_view layout) const {
    const auto expected = static_cast<std::size_t>(std::count(layout.begin(), layout.end(), ',')) + 1;
    if (count == expected) return {};
    return counted() + "; this row has " + std::to_string(expected) + ": " + std::string(layout);
  }

  std::string counted() const { return std::to_string(count) + (count == 1 ? " column" : " columns"); }

  std::array<std::string_view, kMostColumns> text;
  std::size_t count = 0;  ///< of all columns, even those past text
};

bool announces_curved_queries(std::string_view row) noexcept { return first_column(row) == kFormatName; }

std::string fault_of_curved_header(std::string_view row) {
  const std::size_t comma = std::min(row.find(','), row.size());
  const std::string_view version = trimmed(row.substr(std::min(comma + 1, row.size())));
  if (version == "1") return {};
  return "the version of this file of curved queries is " + in_quotes(version) + "; version 1 is read, whose row is " +
         std::string(kCurvedHeader);
}

bool holds_curved_queries(std::string_view text) noexcept {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (is_row(text.substr(0, end))) return announces_curved_queries(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
}

bool starts_curved_query(std::string_view row) noexcept { return first_column(row) == "query"; }

std::string CurvedRows::add(std::string_view row, std::uint64_t line) {
  if (row.find('\0') != std::string_view::npos) return "a zero byte; this is no text file";
  const bool first = last_line_ == 0;
  last_line_ = line;
  const Columns columns(row);
  const std::string_view word = columns.text[0];
  if (first && word != "query") {
    return "column 1 is " + in_quotes(word) + "; a query starts with a row " + std::string(kQueryRow);
  }
  if (first) return add_query(columns);
  if (word == "motion") return add_motion(columns, line);
  if (word == "body") return add_body_point(columns);
  if (word == "curve") return add_curve(columns);
  return "column 1 is " + in_quotes(word) + "; it must be query, motion, body or curve";
}

std::string CurvedRows::finish() {
  fault_line_ = last_line_;
  if (corners_ < corner_count(query_.kind)) {
    return "the query ends here with " + std::to_string(corners_) + (corners_ == 1 ? " corner" : " corners") + "; " +
           expected_corners(query_.kind);
  }
  for (std::size_t m = 0; m < kMotions; ++m) {
    if (motion_line_[m] == 0 || used_[m]) continue;
    fault_line_ = motion_line_[m];
    return "no corner of the query is on motion " + std::to_string(m) +
           "; leave this row out, or give a corner as body," + std::to_string(m) + ",x,y,z";
  }
  return {};
}

std::string CurvedRows::add_query(const Columns& columns) {
  if (std::string fault = columns.fault_of_count(kQueryRow); !fault.empty()) return fault;
  if (columns.text[1] != "0" && columns.text[1] != "1") {
    return at_column(1, "truth") + "is " + in_quotes(columns.text[1]) + "; it must be 0 or 1";
  }
  truth_ = columns.text[1] == "1";
  return {};
}

std::string CurvedRows::add_motion(const Columns& columns, std::uint64_t line) {
  if (std::string fault = columns.fault_of_count(kMotionRow); !fault.empty()) return fault;
  std::size_t index = 0;
  if (std::string fault = columns.read_index(index); !fault.empty()) return fault;
  if (motion_line_[index] != 0) {
    return at_column(1, "index") + "is " + std::to_string(index) + " for the second time in this query; row " +
           std::to_string(motion_line_[index]) + " gives motion " + std::to_string(index);
  }
  std::array<double, kMotionNumbers> x{};
  const auto name = [](std::size_t column) { return column_name(kMotionRow, column); };
  if (std::string fault = columns.read_numbers(2, x, name); !fault.empty()) return fault;
  RigidMotion& motion = query_.motions[index];
  motion.q0 = {x[0], x[1], x[2], x[3]};
  motion.q1 = {x[4], x[5], x[6], x[7]};
  motion.p0 = {x[8], x[9], x[10]};
  motion.p1 = {x[11], x[12], x[13]};
  const std::array<double, 4> zero{};
  if (motion.q0 == zero || motion.q1 == zero) {
    const std::size_t column = motion.q0 == zero ? 2 : 6;
    return "the quaternion in columns " + std::to_string(column + 1) + " to " + std::to_string(column + 4) +
           " is zero; an orientation needs a component that is not 0";
  }
  if (numbers::sign_of_dot(motion.q0, motion.q1) < 0) {
    longer_turns_.merge({1, line});
    if (turns_ == Turns::shorter) {
      for (double& component : motion.q1) component = -component;
    }
  }
  if (const auto time = numbers::zero_between(motion.q0, motion.q1)) {
    return "columns 7 to 10 (q1) are columns 3 to 6 (q0) times a negative number, so that (1 - t) q0 + t q1 is zero "
           "near t = " +
           text_of(*time) + "; change the sign of all components of q1: the orientation at t = 1 stays the same";
  }
  motion_line_[index] = line;
  return {};
}

std::string CurvedRows::check_room() const {
  if (corners_ < corner_count(query_.kind)) return {};
  return "one corner too many; " + expected_corners(query_.kind) + ", and the next query starts with a row " +
         std::string(kQueryRow);
}

std::string CurvedRows::add_body_point(const Columns& columns) {
  if (std::string fault = check_room(); !fault.empty()) return fault;
  if (std::string fault = columns.fault_of_count(kBodyRow); !fault.empty()) return fault;
  std::size_t index = 0;
  if (std::string fault = columns.read_index(index); !fault.empty()) return fault;
  if (motion_line_[index] == 0) {
    return at_column(1, "index") + "is " + std::to_string(index) + ", but the query has no motion " +
           std::to_string(index) + "; a row motion," + std::to_string(index) + ",... must come before";
  }
  std::array<double, 3> x{};
  const auto name = [](std::size_t column) { return column_name(kBodyRow, column); };
  if (std::string fault = columns.read_numbers(2, x, name); !fault.empty()) return fault;
  query_.corners[corners_++] = CurvedCorner::on_body(static_cast<int>(index), {x[0], x[1], x[2]});
  used_[index] = true;
  return {};
}

std::string CurvedRows::add_curve(const Columns& columns) {
  if (std::string fault = check_room(); !fault.empty()) return fault;
  const std::size_t points = (columns.count - 1) / 3;
  if (points < 1 || points > kMostPoints || columns.count != 1 + 3 * points) {
    return columns.counted() + "; a curve has 4, 7, 10 or 13, with 1 to " + std::to_string(kMostPoints) +
           " control points: " + std::string(kCurveRow);
  }
  std::array<double, 3 * kMostPoints> x{};
  const auto name = [](std::size_t column) {
    return std::string(1, "xyz"[(column - 1) % 3]) + " of control point " + std::to_string((column - 1) / 3);
  };
  if (std::string fault = columns.read_numbers(1, std::span(x).first(3 * points), name); !fault.empty()) return fault;
  CurvedCorner& corner = query_.corners[corners_++];
  corner = CurvedCorner();
  corner.control_points = static_cast<int>(points);
  for (std::size_t i = 0; i < points; ++i) corner.points[i] = {x[3 * i], x[3 * i + 1], x[3 * i + 2]};
  return {};
}

void append_query(std::string& out, const CurvedQuery& query, bool truth) {
  const auto append = [&out](const Vec3& x) {
    for (const double c : {x.x, x.y, x.z}) out.append(",").append(hexfloat(c));
  };
  std::array<bool, kMotions> used{};
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const int motion = query.corners[i].motion;
    if (motion != CurvedCorner::kOnCurve) used[static_cast<std::size_t>(motion)] = true;
  }
  out += truth ? "query,1\n" : "query,0\n";
  for (std::size_t m = 0; m < kMotions; ++m) {
    if (!used[m]) continue;
    const RigidMotion& motion = query.motions[m];
    out.append("motion,").append(std::to_string(m));
    for (const auto& q : {motion.q0, motion.q1}) {
      for (const double c : q) out.append(",").append(hexfloat(c));
    }
    append(motion.p0);
    append(motion.p1);
    out += '\n';
  }
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const CurvedCorner& corner = query.corners[i];
    if (corner.motion != CurvedCorner::kOnCurve) {
      out.append("body,").append(std::to_string(corner.motion));
      append(corner.points[0]);
    } else {
      out += "curve";
      for (int k = 0; k < corner.control_points; ++k) append(corner.points[static_cast<std::size_t>(k)]);
    }
    out += '\n';
  }
}

}  // namespace touchstone::io
