// SPDX-License-Identifier: MIT
#include "bundled/expected_query.hpp"

#include <array>
#include <cstdlib>
#include <set>
#include <sstream>
#include <stdexcept>

#include "numbers/fraction.hpp"

namespace touchstone::tests {
namespace {

constexpr std::string_view kExpect = "# expect ";
constexpr std::string_view kSeparation = "# separation ";
const std::set<std::string> kFields = {"contact",   "toi",       "toi_upper", "nature",
                                       "feature_a", "feature_b", "trend",     "starts_within"};

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

Kind kind_of_name(const std::string& name) {
  const auto parts = split(name, '/');
  if (parts.size() == 3 && parts[0] == "bundled") {
    for (const Kind kind : {Kind::edge_edge, Kind::vertex_face, Kind::point_edge, Kind::point_point}) {
      if (parts[1] == name_of(kind)) return kind;
    }
  }
  throw std::runtime_error(name + ": not bundled/KIND/FAMILY.csv");
}

/// Reads one file line by line.
class Parser {
 public:
  explicit Parser(const cli::BundledFile& file) : name_(file.name), kind_(kind_of_name(name_)), text_(file.content) {}

  std::vector<ExpectedQuery> queries() {
    std::istringstream lines(text_);
    for (std::string line; std::getline(lines, line);) {
      ++line_;
      if (line.substr(0, kExpect.size()) == kExpect) {
        read_expectation(line.substr(kExpect.size()));
      } else if (line.substr(0, kSeparation.size()) == kSeparation) {
        read_separation(line.substr(kSeparation.size()));
      } else if (line == "touchstone-curved,1") {
        if (curved_ || !queries_.empty()) fail("a first row that is not the first");
        curved_ = true;
      } else if (curved_ && line.empty()) {
        continue;
      } else if (line.empty() || line.front() != '#') {
        curved_ ? read_curved_row(line) : read_row(line);
      }
    }
    if (row_ != 0) fail("the file ends within a query");
    if (!expect_.empty()) fail("an expectation without a query");
    return std::move(queries_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw std::runtime_error(name_ + ":" + std::to_string(line_) + ": " + reason);
  }

  void read_expectation(const std::string& text) {
    if (row_ != 0 || !expect_.empty()) fail("an expectation that does not stand alone above its query");
    for (const auto& item : split(text, ' ')) {
      const std::size_t equals = item.find('=');
      const std::string field = item.substr(0, equals);
      if (equals == std::string::npos || kFields.count(field) == 0) fail("not a field: " + item);
      if (!expect_.emplace(field, item.substr(equals + 1)).second) fail("twice: " + field);
    }
    if (expect_.count("contact") == 0) fail("an expectation without contact");
  }

  void read_separation(const std::string& text) {
    if (!queries_.empty() || separation_.distance > 0) fail("a separation that is not the file's");
    const auto words = split(text, ' ');
    char* end = nullptr;
    if (words.size() == 2) separation_.distance = std::strtod(words[0].c_str(), &end);
    if (end == nullptr || *end != '\0' || !(separation_.distance > 0)) fail("not a separation above 0: " + text);
    if (words[1] != "euclidean" && words[1] != "max") fail("not a metric: " + words[1]);
    separation_.metric = words[1] == "max" ? Metric::max : Metric::euclidean;
  }

  void read_row(const std::string& line) {
    const auto columns = split(line, ',');
    if (columns.size() != 7) fail("not a row of 7 columns");
    if (columns[6] != "0" && columns[6] != "1") fail("truth is neither 0 nor 1");
    const std::size_t corners = corner_count(kind_);
    if (row_ == 0) add_query(columns[6] == "1");
    ExpectedQuery& query = queries_.back();
    if (query.truth != (columns[6] == "1")) fail("truth differs within the query");
    auto& corner = row_ < corners ? query.query.start[row_] : query.query.end[row_ - corners];
    for (std::size_t axis = 0; axis < 3; ++axis) corner[axis] = {columns[2 * axis], columns[2 * axis + 1]};
    row_ = (row_ + 1) % (2 * corners);
  }

  double number_of(const std::string& text) const {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0') fail("not a number: " + text);
    return number;
  }

  ExpectedQuery& add_query(bool truth) {
    if (expect_.empty()) fail("a query without an expectation");
    ExpectedQuery& query = queries_.emplace_back();
    query.file = name_;
    query.number = queries_.size() - 1;
    query.query.kind = kind_;
    query.separation = separation_;
    query.truth = truth;
    query.expect = std::move(expect_);
    expect_.clear();
    return query;
  }

  void read_curved_row(const std::string& line) {
    const auto columns = split(line, ',');
    if (row_ == 0) {
      if (columns != std::vector<std::string>{"query", "0"} && columns != std::vector<std::string>{"query", "1"}) {
        fail("not the first row of a query");
      }
      add_query(columns[1] == "1").curved.emplace().kind = kind_;
      row_ = 1;
      return;
    }
    CurvedQuery& query = *queries_.back().curved;
    std::vector<double> x;
    for (std::size_t i = 1; i < columns.size(); ++i) x.push_back(number_of(columns[i]));
    if (columns[0] == "motion") {
      if (x.size() != 15 || !(x[0] >= 0 && x[0] < 4)) fail("not a motion");
      query.motions[static_cast<std::size_t>(x[0])] = {
          {x[1], x[2], x[3], x[4]}, {x[5], x[6], x[7], x[8]}, {x[9], x[10], x[11]}, {x[12], x[13], x[14]}};
      return;
    }
    CurvedCorner& corner = query.corners[row_ - 1];
    if (columns[0] == "body" && x.size() == 4) {
      corner = CurvedCorner::on_body(static_cast<int>(x[0]), {x[1], x[2], x[3]});
    } else if (columns[0] == "curve" && x.size() % 3 == 0 && x.size() >= 3 && x.size() <= 12) {
      corner.control_points = static_cast<int>(x.size() / 3);
      for (std::size_t i = 0; i < x.size() / 3; ++i) corner.points[i] = {x[3 * i], x[3 * i + 1], x[3 * i + 2]};
    } else {
      fail("not a corner");
    }
    row_ = row_ == corner_count(kind_) ? 0 : row_ + 1;
  }

  std::string name_;
  bool curved_ = false;
  Kind kind_;
  std::string text_;
  std::size_t line_ = 0;
  std::size_t row_ = 0;  ///< within the query
  Separation separation_;
  std::map<std::string, std::string> expect_;
  std::vector<ExpectedQuery> queries_;
};

}  // namespace

std::string ExpectedQuery::name() const {
  return file + ", query " + std::to_string(number) + " (touchstone explain --query " + std::to_string(number) + " " +
         file + ")";
}

std::vector<ExpectedQuery> parse_bundled_file(const cli::BundledFile& file) { return Parser(file).queries(); }

const std::vector<ExpectedQuery>& expected_queries() {
  static const std::vector<ExpectedQuery> all = [] {
    std::vector<ExpectedQuery> queries;
    for (const auto& file : cli::bundled_files()) {
      for (auto& query : parse_bundled_file(file)) queries.push_back(std::move(query));
    }
    return queries;
  }();
  return all;
}

std::optional<Query> in_doubles(const RationalQuery& query) {
  Query result;
  result.kind = query.kind;
  const auto convert = [](const std::array<Fraction, 3>& from, Vec3& to) {
    std::array<std::optional<double>, 3> values;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      values[axis] = numbers::exact_double(from[axis].numerator, from[axis].denominator);
      if (!values[axis]) return false;
    }
    to = {*values[0], *values[1], *values[2]};
    return true;
  };
  for (std::size_t corner = 0; corner < corner_count(query.kind); ++corner) {
    if (!convert(query.start[corner], result.start[corner]) || !convert(query.end[corner], result.end[corner])) {
      return std::nullopt;
    }
  }
  return result;
}

}  // namespace touchstone::tests
