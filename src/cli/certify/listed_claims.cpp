// SPDX-License-Identifier: MIT
#include "cli/certify/listed_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>

#include <touchstone/error.hpp>

#include "cli/certify/json_records.hpp"
#include "io/answers/npz.hpp"
#include "io/characters.hpp"
#include "io/fail.hpp"
#include "io/foreign_bytes.hpp"
#include "io/times.hpp"
#include "io/whole_file.hpp"
#include "json/json_node.hpp"

namespace touchstone::cli {
namespace {

using io::ClaimColumn;
using json::JsonNode;

constexpr const char* kTimeIsRight = "; of a contact it must be finite, or missing";

// ---- JSON

/// JSON has no words for NaN and infinity, but Python's json.dumps writes them. They become texts.
std::string with_quotes_around_nan(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') in_string = !in_string;
    if (in_string && text[i] == '\\' && i + 1 < text.size()) out += text[i++];
    std::size_t length = 0;
    for (const std::string_view word : {"-Infinity", "Infinity", "NaN"}) {
      if (!in_string && length == 0 && text.substr(i).starts_with(word)) length = word.size();
    }
    if (length == 0) {
      out += text[i];
    } else {
      out.append("\"").append(text.substr(i, length)).append("\"");
      i += length - 1;
    }
  }
  return out;
}

bool contact_of(const JsonNode& node) {
  if (!node.is_number()) return node.boolean();
  const double number = node.number();
  if (number != 0 && number != 1) node.fail("must be 0 or 1, or false or true");
  return number == 1;
}

std::optional<double> time_of(const JsonNode& node) {
  if (node.is_null()) return std::nullopt;
  if (!node.is_text()) return node.number();
  const std::string text = node.text();
  const std::optional<double> time = io::parse_finite_double(text);
  if (!time) node.fail("is " + io::in_quotes(text) + kTimeIsRight);
  return time;
}

/// Of a claim without `contact`.
bool contact_by_toi(const JsonNode& toi) {
  if (toi.is_null()) return false;
  const auto contact = io::contact_of_toi(toi.is_text() ? toi.text() : fmt::format("{}", toi.number()));
  if (!contact) toi.fail(io::kToiIsRight);
  return *contact;
}

Separation separation_of(const JsonNode& distance, const std::optional<JsonNode>& metric) {
  Separation separation;
  separation.distance = distance.number();
  if (!(separation.distance >= 0)) distance.fail("must be 0 or greater");
  if (!metric) return separation;
  const auto named = from_name<Metric>(metric->text());
  if (!named) metric->fail("must be euclidean or max");
  separation.metric = *named;
  return separation;
}

/// Reads the claims of one document, item by item.
class JsonClaims {
 public:
  explicit JsonClaims(io::MissingClaim missing) : missing_(missing) {}

  void add(const JsonNode& node) {
    if (!node.is_object()) {
      all_.claims.push_back({{}, {}, contact_of(node), {}, {}});
      return;
    }
    std::array<std::optional<JsonNode>, io::kClaimColumns> found;
    for (const std::string& key : node.keys()) {
      const auto column = io::claim_column(key);
      if (!column) {
        if (!io::is_description(key) && unread_.insert(key).second) all_.unread.push_back(key);
        continue;
      }
      auto& node_of_column = found[static_cast<std::size_t>(*column)];
      if (node_of_column) node.fail("has two keys that are a " + io::in_quotes(io::claim_column_name(*column)));
      node_of_column = node.at(key);
    }
    const auto at = [&](ClaimColumn column) -> const std::optional<JsonNode>& {
      return found[static_cast<std::size_t>(column)];
    };
    ListedClaim claim;
    claim.contact = true;
    if (at(ClaimColumn::contact)) {
      claim.contact = contact_of(*at(ClaimColumn::contact));
    } else if (at(ClaimColumn::toi)) {
      claim.contact = contact_by_toi(*at(ClaimColumn::toi));
      all_.implied_contacts = true;
    } else {
      const std::string fault = io::fault_without_contact("key", at(ClaimColumn::query).has_value(), missing_);
      if (!fault.empty()) node.fail(fault);
      all_.implied_contacts = true;
    }
    if (at(ClaimColumn::file)) claim.file = at(ClaimColumn::file)->text();
    if (at(ClaimColumn::metric) && !at(ClaimColumn::separation)) node.fail("has a 'metric' and no 'separation'");
    if (at(ClaimColumn::separation)) {
      claim.separation = separation_of(*at(ClaimColumn::separation), at(ClaimColumn::metric));
    }
    if (!all_.claims.empty() && all_.claims.front().query.has_value() != at(ClaimColumn::query).has_value()) {
      node.fail(at(ClaimColumn::query) ? "has a 'query', and the first claim has none"
                                       : "has no 'query', and the first claim has one");
    }
    if (at(ClaimColumn::query)) claim.query = at(ClaimColumn::query)->whole_number(0, std::uint64_t{1} << 53);
    if (claim.contact && at(ClaimColumn::toi)) claim.toi = time_of(*at(ClaimColumn::toi));
    all_.claims.push_back(claim);
  }

  ListedClaims all() && { return std::move(all_); }

 private:
  io::MissingClaim missing_;
  ListedClaims all_;
  std::unordered_set<std::string> unread_;
};

ListedClaims claims_of_json(std::string_view content, io::MissingClaim missing) {
  const json::JsonDocument document = as_records(json::parse_json(with_quotes_around_nan(content)));
  JsonClaims claims(missing);
  for (const JsonNode& node : JsonNode(document.value(), "the list").items()) claims.add(node);
  return std::move(claims).all();
}

/// The text without what programs write before JSON.
std::string_view start_of_json(std::string_view content) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (content.starts_with(kByteOrderMark)) content.remove_prefix(kByteOrderMark.size());
  content.remove_prefix(std::min(content.find_first_not_of(" \t\r\n"), content.size()));
  return content;
}

/// Whether the text is a line of JSON for each claim: its first line is all of an object, and others follow.
bool is_json_lines(std::string_view content, std::string_view path) {
  content = start_of_json(content);
  if (content.starts_with('[')) return false;
  if (!content.starts_with('{')) return !path.ends_with(".json");
  const std::size_t end = std::min(content.find('\n'), content.size());
  const bool has_more = content.find_first_not_of(" \t\r\n", end) != std::string_view::npos;
  return has_more && nlohmann::json::accept(with_quotes_around_nan(content.substr(0, end)));
}

ListedClaims claims_of_json_lines(std::string_view content, io::MissingClaim missing) {
  JsonClaims claims(missing);
  std::size_t number = 0;
  for (std::size_t at = 0; at < content.size();) {
    const std::size_t end = std::min(content.find('\n', at), content.size());
    const std::string_view line = io::without_blanks(content.substr(at, end - at));
    at = end + 1;
    ++number;
    if (line.empty() || line == "\r") continue;
    const std::string name = "line " + std::to_string(number);
    try {
      const json::JsonDocument document = json::parse_json(with_quotes_around_nan(line));
      claims.add(JsonNode(document.value(), "the object"));
    } catch (const Error& error) {
      throw Error(name + ": " + error.what());
    }
  }
  return std::move(claims).all();
}

// ---- NumPy

/// An array of one or two dimensions, whose values are asked for by row and column.
class Array {
 public:
  Array(const std::string& name, std::string_view content) : content_(content) {
    io::InputFile memory = io::InputFile::from_memory(name, content);
    header_ = io::read_npy_header(memory, content.size(), "(100,)");
    if (header_.extents.empty() || header_.extents.size() > 2) {
      io::fail(name, "an array of shape " + io::shape_text(header_.extents) +
                         "; claims have one row each: (queries,) or (queries, columns)");
    }
  }

  std::uint64_t rows() const { return header_.extents[0]; }
  std::uint64_t columns() const { return header_.extents.size() == 1 ? 1 : header_.extents[1]; }

  double at(std::uint64_t row, std::uint64_t column) const {
    const std::uint64_t i = header_.fortran ? row + column * rows() : row * columns() + column;
    return io::number_at(content_.data() + header_.header_size + i * header_.size, header_);
  }

 private:
  std::string_view content_;
  io::NpyHeader header_;
};

/// The arrays of the columns, row by row.
ListedClaims claims_of_columns(const std::string& name, const std::array<const Array*, io::kClaimColumns>& arrays,
                               const std::array<std::uint64_t, io::kClaimColumns>& columns, std::string_view thing,
                               io::MissingClaim missing) {
  const auto index = [](ClaimColumn column) { return static_cast<std::size_t>(column); };
  const auto value = [&](ClaimColumn column, std::uint64_t row) {
    return arrays[index(column)]->at(row, columns[index(column)]);
  };
  for (const ClaimColumn column : {ClaimColumn::file, ClaimColumn::separation, ClaimColumn::metric}) {
    if (arrays[index(column)] == nullptr) continue;
    io::fail(name, "has a " + io::in_quotes(io::claim_column_name(column)) +
                       ", which is read from CSV and JSON alone; for the separation, --separation says it");
  }
  ListedClaims all;
  const auto has = [&](ClaimColumn column) { return arrays[index(column)] != nullptr; };
  all.implied_contacts = !has(ClaimColumn::contact);
  if (all.implied_contacts && !has(ClaimColumn::toi)) {
    const std::string fault = io::fault_without_contact(thing, has(ClaimColumn::query), missing);
    if (!fault.empty()) io::fail(name, fault);
  }
  const bool have_times = has(ClaimColumn::toi);
  const ClaimColumn any = !all.implied_contacts ? ClaimColumn::contact
                          : have_times          ? ClaimColumn::toi
                                                : ClaimColumn::query;
  const std::uint64_t rows = arrays[index(any)]->rows();
  all.claims.reserve(rows);
  for (std::uint64_t row = 0; row < rows; ++row) {
    const auto fail = [&](const char* what, double is, const std::string& right) {
      io::fail(name, fmt::format("{} of row {} is {}{}", what, row, is, right));
    };
    ListedClaim claim;
    claim.contact = true;
    if (!all.implied_contacts) {
      const double contact = value(ClaimColumn::contact, row);
      if (contact != 0 && contact != 1) fail("contact", contact, "; it must be 0 or 1, or False or True");
      claim.contact = contact == 1;
    } else if (have_times) {
      const double toi = value(ClaimColumn::toi, row);
      claim.contact = std::isfinite(toi);
      if (claim.contact && !(toi >= 0 && toi <= 1)) fail("toi", toi, "; " + std::string(io::kToiIsRight));
    }
    if (has(ClaimColumn::query)) {
      const double query = value(ClaimColumn::query, row);
      if (!(query >= 0 && query <= 0x1p53 && query == std::floor(query))) {
        fail("query", query, "; it must be a number counted from 0");
      }
      claim.query = static_cast<std::uint64_t>(query);
    }
    if (claim.contact && have_times) {
      claim.toi = value(ClaimColumn::toi, row);
      if (!std::isfinite(*claim.toi)) fail("toi", *claim.toi, "; of a contact it must be finite");
    }
    all.claims.push_back(claim);
  }
  return all;
}

ListedClaims claims_of_npy(const std::string& path, std::string_view content, io::ClaimColumns names,
                           io::MissingClaim missing) {
  const Array array(path, content);
  if (names.empty() && array.columns() == 1) names = {ClaimColumn::contact};
  if (names.empty() && array.columns() == 3) names = {ClaimColumn::query, ClaimColumn::contact, ClaimColumn::toi};
  if (!names.empty() && names.size() != array.columns()) {
    io::fail(path, "has " + io::fault_of_column_count(array.columns(), names));
  }
  if (names.empty()) {
    io::fail(path, fmt::format("has {} columns; --columns says what they are, for example --columns contact,toi",
                               array.columns()));
  }
  std::array<const Array*, io::kClaimColumns> arrays{};
  std::array<std::uint64_t, io::kClaimColumns> columns{};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == ClaimColumn::unread) continue;
    arrays[static_cast<std::size_t>(names[i])] = &array;
    columns[static_cast<std::size_t>(names[i])] = i;
  }
  return claims_of_columns(path, arrays, columns, "column", missing);
}

ListedClaims claims_of_npz(const std::string& path, std::string_view content, io::MissingClaim missing) {
  std::vector<Array> read;
  std::vector<ClaimColumn> of;
  std::vector<std::string> unread;
  for (const io::NpzArray& one : io::npz_arrays(path, content)) {
    const auto column = io::claim_column(one.name);
    if (!column) {
      unread.push_back(one.name);
      continue;
    }
    if (std::count(of.begin(), of.end(), *column) != 0) {
      io::fail(path, "has two arrays that are a " + io::in_quotes(io::claim_column_name(*column)));
    }
    read.emplace_back(path + ": " + one.name, one.content);
    of.push_back(*column);
    if (read.back().columns() != 1)
      io::fail(path, "the array " + io::in_quotes(one.name) + " has more than one column");
    if (read.back().rows() != read.front().rows()) {
      io::fail(path, fmt::format("the array {} has {} rows, and {} has {}", io::in_quotes(one.name), read.back().rows(),
                                 io::in_quotes(io::claim_column_name(of.front())), read.front().rows()));
    }
  }
  std::array<const Array*, io::kClaimColumns> arrays{};
  for (std::size_t i = 0; i < of.size(); ++i) arrays[static_cast<std::size_t>(of[i])] = &read[i];
  ListedClaims all = claims_of_columns(path, arrays, {}, "array", missing);
  all.unread = std::move(unread);
  return all;
}

}  // namespace

bool is_list_of_claims(io::InputFile& file) {
  for (const std::string_view ending : {".json", ".jsonl", ".ndjson", ".npy", ".npz"}) {
    if (file.name().ends_with(ending)) return true;
  }
  constexpr std::size_t kBeforeJson = 64;  // a mark and blanks
  const std::string_view start = start_of_json(file.peek(kBeforeJson));
  return start.starts_with('[') || start.starts_with('{');
}

ListedClaims read_listed_claims(io::InputFile file, const io::ClaimColumns& columns, io::MissingClaim missing) {
  const std::string path = file.name();
  const auto content = io::WholeFile::read(std::move(file), io::kJsonLimits);
  if (path.ends_with(".npy")) return claims_of_npy(path, content.bytes(), columns, missing);
  if (!columns.empty()) io::fail(path, "names its columns itself; --columns is for CSV and .npy");
  if (path.ends_with(".npz")) return claims_of_npz(path, content.bytes(), missing);
  io::refuse_foreign_bytes(path, content.bytes());
  try {
    return is_json_lines(content.bytes(), path) ? claims_of_json_lines(content.bytes(), missing)
                                                : claims_of_json(content.bytes(), missing);
  } catch (const Error& error) {
    io::fail(path, error.what());
  }
}

}  // namespace touchstone::cli
