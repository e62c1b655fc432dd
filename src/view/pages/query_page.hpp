// The page of one query.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

#include <touchstone/separation.hpp>

#include "exact/exact.hpp"
#include "io/queries/query_parser.hpp"
#include "view/pages/html.hpp"

namespace touchstone::view {

/// A query, its story, and words around them.
struct QueryToShow {
  std::string title;    ///< text: "query 3 of edge-edge/a.csv"
  std::string command;  ///< text: as a Page has it
  std::string corners;  ///< text of several lines: the exact input
  io::FileQuery query;
  exact::Story story;
  double t_max = 1;
  Separation separation;
};

Page query_page(const QueryToShow& shown);

/// The scripts that viewer_html needs.
std::vector<std::string> viewer_scripts();

/// The element that shows a picture: a stage with the still picture, in which the script draws and adds its controls.
/// @param id  of the script element with the picture
std::string viewer_html(const std::string& id, const nlohmann::json& picture);

}  // namespace touchstone::view
