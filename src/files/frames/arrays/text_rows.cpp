// Text with a row of numbers for each vertex, as spreadsheets and numpy.savetxt write it.
// SPDX-License-Identifier: MIT
#include <string>
#include <string_view>

#include "frames/arrays/array.hpp"
#include "frames/content.hpp"
#include "io/fail.hpp"
#include "io/foreign_bytes.hpp"
#include "io/queries/query_chunks.hpp"
#include "io/separators.hpp"
#include "io/times.hpp"

namespace touchstone::frames {

ArrayFrame read_text_rows(const std::string& file, const ReadOptions& options) {
  const io::WholeFile content = io::WholeFile::read(file, kMeshLimits, options.checkpoint);
  std::string_view rest = content.bytes();
  io::refuse_foreign_bytes(file, rest);
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
  ArrayFrame frame{{1, 0, 0}, {}};
  char separator = ',';
  std::string names;
  std::uint64_t names_line = 0;
  for (std::uint64_t line = 1; !rest.empty(); ++line) {
    std::string row(rest.substr(0, rest.find('\n')));
    const bool has_end = row.size() < rest.size();
    rest.remove_prefix(std::min(row.size() + 1, rest.size()));
    if (!io::is_row(row)) continue;
    if (!has_end) io::fail(file, line, "the last row does not end with an end of line: the file may be cut off here");
    if (row.find('\0') != std::string::npos) io::fail(file, line, "a zero byte; this is no text file");
    const bool is_first = frame.shape.vertices == 0;
    if (is_first) separator = io::separator_of(row);
    if (const std::string fault = io::put_commas(row, separator); !fault.empty()) io::fail(file, line, fault);
    if (is_first && names.empty() && io::names_columns(row)) {
      names = row;
      names_line = line;
      continue;
    }
    const auto fields = io::fields_of(row);
    if (is_first) {
      frame.shape.dimension = fields.size();
      const std::string fault = names.empty() ? "" : io::fault_of_names(names, row, Kind::point_point);
      if (!fault.empty()) io::fail(file, names_line, fault);
    }
    if (fields.size() != frame.shape.dimension || fields.size() < 2 || fields.size() > 3) {
      io::fail(file, line,
               std::to_string(fields.size()) + (fields.size() == 1 ? " column" : " columns") +
                   "; each row is x,y,z of a vertex, or x,y in the plane");
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const auto value = io::parse_finite_double(fields[i]);
      if (!value) {
        io::fail(file, line,
                 std::string(1, "xyz"[i]) + " is " + io::in_quotes(fields[i]) + ", which " +
                     std::string(io::fault_of_double(fields[i])));
      }
      frame.positions.push_back(*value);
    }
    ++frame.shape.vertices;
  }
  if (frame.shape.vertices == 0) io::fail(file, "holds no row x,y,z");
  return frame;
}

}  // namespace touchstone::frames
