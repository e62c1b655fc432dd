// The protocol between `touchstone fuzz` and a solver program, over pipes: one line a query, one line an answer.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

namespace touchstone::pipes {

// A query:   KIND and then numbers, each after one blank, and a line feed. KIND is edge-edge, vertex-face, point-edge
//            or point-point. The numbers are the coordinates as C hexfloats ("-0x1.8p-2"): x y z of each corner at
//            t = 0, in the order a0 a1 b0 b1, v f0 f1 f2, p e0 e1 or p q, and then x y z of each corner at t = 1: 24,
//            24, 18 or 12 numbers.
// An answer: "0"            no contact for t in [0, 1]
//            "1 TOI"        contact, first at TOI, a number that C's strtod reads: hexfloat, decimal, nan, inf; at most
//                           1024 characters. It counts as it is written, not as the double next to it
//            "1"            contact; this solver reports no time
//            "unknown"      the solver says that it has failed on this query
//            "unsupported"  the solver takes no queries of this kind; only as the first answer to a kind
//            and a line feed. A carriage return and blanks before it do no harm.
// With a separation D > 0 one line comes before all queries: "separation D METRIC", D a hexfloat and METRIC euclidean
// or max. Contact then is a distance of at most D. Its answer is "ok", or "unsupported" when the solver takes none; a
// program that answers anything else does not know the line, and takes none either. With `--separation each` such a
// line also comes before each query whose separation is not that of the query before it.
// The program writes exactly one answer to each query, in the order of the queries, and flushes it. The next query
// comes only after the answer. The program ends when its input ends.

/// The line for a query, line feed included.
std::string query_line(const Query& query);

/// The line for a separation, line feed included.
std::string separation_line(const Separation& separation);

/// Whether a line (without its line feed) says that the program takes the separation.
bool takes_separation(std::string_view answer) noexcept;

struct AnswerLine {
  bool supported = true;
  bool known = true;  ///< false: the solver says that it has no answer
  bool contact = false;
  std::optional<double> toi;   ///< may be NaN or infinite
  std::string toi_as_written;  ///< as in Claim: the time when `toi` is only the nearest double to it
};

/// The answer in a line (without its line feed), or nothing when the line is none of the above.
std::optional<AnswerLine> read_answer_line(std::string_view line);

/// The query in a line (without its line feed), or nothing when the line holds none; query_line's inverse.
std::optional<Query> read_query_line(std::string_view line) noexcept;

}  // namespace touchstone::pipes
