// The page of a fuzzer's findings.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/separation.hpp>

#include "io/queries/query_parser.hpp"
#include "view/pages/html.hpp"

namespace touchstone::view {

/// One finding. All strings are text.
struct FindingToShow {
  std::string heading;     ///< "missed 12 times, edge-edge"
  std::string degeneracy;  ///< in words
  std::string claim, truth;
  std::string detail;                 ///< may be empty
  std::string corners;                ///< whole lines
  std::vector<std::string> commands;  ///< that repeat and explain it
  io::FileQuery query;
  Answer answer;  ///< the exact one
  double t_max = 1;
  Separation separation;
};

/// A card for each finding, with its picture.
/// @param summary  text of several lines about the whole search
Page findings_page(const std::string& title, const std::string& summary, const std::vector<FindingToShow>& findings);

}  // namespace touchstone::view
