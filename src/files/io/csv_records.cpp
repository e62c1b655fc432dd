// SPDX-License-Identifier: MIT
#include "io/csv_records.hpp"

#include <algorithm>
#include <utility>

#include "io/characters.hpp"
#include "io/fail.hpp"
#include "io/foreign_bytes.hpp"
#include "io/separators.hpp"

namespace touchstone::io {

CsvRecords::CsvRecords(InputFile file, std::size_t chunk_bytes, bool (*is_one_field)(std::string_view record))
    : file_(std::move(file)), chunk_bytes_(std::max<std::size_t>(chunk_bytes, 1)), is_one_field_(is_one_field) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  while (!at_end_ && buffer_.size() < kForeignStart) fill();
  refuse_foreign_bytes(name(), buffer_);
  if (buffer_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
}

bool CsvRecords::next() {
  for (;;) {
    row_ = line_;
    std::size_t end = 0;
    while (!find_record_end(end)) fill();
    if (at_ == buffer_.size()) return false;
    const bool at_comment = is_comment();
    std::string_view record(buffer_.data() + at_, end - at_);
    if (record.ends_with('\r')) record.remove_suffix(1);
    line_ += 1 + static_cast<std::uint64_t>(std::count(record.begin(), record.end(), '\n'));
    at_ = std::min(end + 1, buffer_.size());
    if (record.empty()) continue;
    if (record.find('\0') != std::string_view::npos) refuse("a zero byte; this is no text file");
    if (at_comment) {
      const std::size_t text = std::min(record.find_first_not_of("# \t"), record.size());
      comment_ = without_blanks(record.substr(text));
      continue;
    }
    if (!separator_) separator_ = is_one_field_ != nullptr && is_one_field_(record) ? ',' : separator_of(record);
    split_record(record);
    return true;
  }
}

/// Whether the line at at_, which is in the buffer, is a comment before the first record.
bool CsvRecords::is_comment() const {
  const std::size_t first = buffer_.find_first_not_of(" \t", at_);
  return !separator_ && first != std::string::npos && buffer_[first] == '#';
}

/// Finds the line end that closes the record at at_: the first one outside quotes, or the end of the file.
/// @returns false when more of the file must be read first
bool CsvRecords::find_record_end(std::size_t& end) {
  bool quoted = false;
  std::size_t from = at_;
  for (;;) {
    const std::size_t line_end = buffer_.find('\n', from);
    end = std::min(line_end, buffer_.size());
    if (end - at_ > kLongestLine) {
      refuse("the row is longer than " + std::to_string(kLongestLine) + " bytes" +
             (quoted ? "; is a quote not closed?" : ""));
    }
    const auto first = buffer_.begin() + static_cast<std::ptrdiff_t>(from);
    const auto last = buffer_.begin() + static_cast<std::ptrdiff_t>(end);
    if (std::count(first, last, '"') % 2 != 0) quoted = !quoted;  // a doubled quote changes nothing
    if (line_end == std::string::npos) {
      if (!at_end_) return false;
      if (quoted && !is_comment()) refuse("the file ends inside quotes");
      return true;
    }
    if (!quoted || is_comment()) return true;
    from = line_end + 1;
  }
}

void CsvRecords::split_record(std::string_view record) {
  fields_.clear();
  unquoted_.clear();
  unquoted_.reserve(static_cast<std::size_t>(std::count(record.begin(), record.end(), '"')));  // keeps views valid
  const std::string_view padding = padding_beside(*separator_);
  if (separator_ == ' ') record = without_blanks(record);
  for (std::size_t at = 0;; ++at) {
    const std::size_t begin = record.find_first_not_of(padding, at);
    if (begin != std::string_view::npos && record[begin] == '"') {
      at = begin;
      std::string& text = unquoted_.emplace_back();
      for (++at;; ++at) {  // find_record_end has seen the closing quote
        const std::size_t quote = record.find('"', at);
        text.append(record.substr(at, quote - at));
        at = quote + 1;
        if (at == record.size() || record[at] != '"') break;
        text += '"';
      }
      fields_.push_back(text);
      if (separator_ != ' ') at = std::min(record.find_first_not_of(padding, at), record.size());
      if (at < record.size() && record[at] != *separator_) refuse("text after a closing quote");
    } else {
      const std::size_t end = std::min(record.find(*separator_, at), record.size());
      const std::string_view text = without_blanks(record.substr(at, end - at));
      if (text.find('"') != std::string_view::npos) refuse("a quote inside a field that does not start with one");
      fields_.push_back(text);
      at = end;
    }
    if (at == record.size()) return;
    if (separator_ == ' ') at = record.find_first_not_of(' ', at) - 1;  // however many blanks
  }
}

void CsvRecords::fill() {
  buffer_.erase(0, at_);
  at_ = 0;
  const std::size_t old_size = buffer_.size();
  buffer_.resize(old_size + chunk_bytes_);
  const std::size_t count = file_.read(buffer_.data() + old_size, chunk_bytes_);
  if (count == 0) at_end_ = true;
  buffer_.resize(old_size + count);
}

void CsvRecords::refuse(std::string_view reason) const { fail(name(), row_, reason); }

}  // namespace touchstone::io
