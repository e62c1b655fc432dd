// The report of `touchstone certify` as JSON.
//
//   {
//     "touchstone": "0.2.0",                   version of the program
//     "method": "fast",                        which code answered: "fast", "exact", "oracle" or "fast-cgal"
//     "claims_from": "truth column",           or the name of the file of claims
//     "left_out": "no times",                  what that file does not say, and which of its columns are not read; left
//                                              out when that is nothing
//     "separation": "0x1p-3",                  the separation that all claims are about; left out for touching, and
//     "metric": "euclidean",                   when the claims are about different ones
//     "claims": {"judged", "holds", "missed", "phantom", "late"},            counts
//     "not_counted": {                         wrong claims that do not count; only with --late or --class
//       "late": {"claims", "ulps" or "time"},  those that are late by at most that
//       "other_classes": {"claims", "than": ["missed"]}
//     },
//     "decided_by": {"filter", "bracket", "exact", "oracle"},                counts
//     "natures": {"none", "crossing", "grazing", "sustained", "isolated"},   counts, of the exact answers; with a
//                                              separation "entering" too
//     "early": {                               of the claims that hold and have a toi: how early it is
//       "claims": 3,                           how many there are; when 0 the rest is left out
//       "ulps": {"least", "most",              the number of doubles from the claimed toi to the exact answer's
//                "median": {"from", "below"},  the range of the lower median: from <= median < below
//                "histogram": [{"from", "below", "claims"}]},    "below" is null when there is no greater one
//       "time": {...}                          the same for their difference, as hexfloats
//     },
//     "late": {...},                           the same of the late ones: from the exact toi to the claimed one
//     "files": [{"file", "kind", "claims": {as above}}],
//     "refuted": [{                            every claim that does not hold and counts, in input order
//       "file", "kind", "query",               its number counted from 0 within the file
//       "rows": [97, 104],                     first and last line, counted from 1
//       "verdict": "missed",                   "missed", "phantom" or "late"
//       "claim": {"contact": 0, "toi": null},
//       "answer": {"contact": 1, "toi", "toi_upper", "nature", "feature_a", "feature_b", "level"},   as in answers.csv,
//                                              null without contact; with a separation "starts_within" (0 or 1) and
//                                              "trend" too
//       "separation", "metric",                of this claim, when it is not touching
//       "corners": {"a0": {"start": ["1/3", "0/1", "1/1"], "end": [...]}, ...}   x, y, z as the file writes them
//                                              of a query with curved motion, all numbers being hexfloats:
//       "motions": {"0": {"q0": [w, x, y, z], "q1", "p0": [x, y, z], "p1"}, ...},   those that a corner is on
//       "corners": {"a0": {"motion": 0, "point": [x, y, z]} or {"curve": [[x, y, z], ...]}, ...}
//     }]
//   }
//
// Times are hexfloats in strings; a claimed time that is no double is the text that the claim has. File names that are
// no valid UTF-8 have the bad bytes replaced by U+FFFD. The report depends on nothing but the input: no clock, no
// number of threads.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <touchstone/separation.hpp>

#include "certify/tally.hpp"

namespace touchstone::cli {

struct ReportHeading {
  std::string method;                    ///< "fast", "exact", "oracle" or "fast-cgal"
  std::string claims_from;               ///< "truth column" or the name of a file of claims
  std::string left_out;                  ///< as ClaimStream::left_out
  std::optional<Separation> separation;  ///< nothing: the claims are about different ones
  certify::Counting<Verdict> counting = {};
  certify::NotCounted not_counted = {};
};

/// One element of "refuted". There may be more of them than fit into memory, so that the caller strings them together:
/// report_begin, the claims separated by kClaimSeparator, kReportEnd.
std::string refuted_claim_json(const certify::RefutedClaim& refuted);

std::string report_begin(const ReportHeading& heading, const certify::Tally& tally,
                         const std::vector<certify::FileTally>& files);
inline constexpr const char* kClaimSeparator = ",\n";
inline constexpr const char* kReportEnd = "\n]}\n";

}  // namespace touchstone::cli
