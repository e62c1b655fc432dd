// Self-contained pages: one file, no request to anywhere, and text that is only text.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace touchstone::view {

/// `text` as the text of an element or of a quoted attribute: & < > " ' are escaped, control characters
/// (io::is_control) but for line ends and tabs become U+FFFD, and so do bytes that are no UTF-8.
std::string escaped(std::string_view text);

/// JSON for a script element of the type application/json: every < > & of a string is written as \u003c and so on, so
/// that no text ends the element. Bytes that are no UTF-8 become U+FFFD.
std::string json_for_script(const nlohmann::json& data);

/// A file of src/view/pages/assets. @throws std::logic_error  when there is none
const std::string& page_file(std::string_view name);

/// A command as a user would copy it.
std::string command_html(const std::string& command);

/// Takes the next bytes of a page.
using Sink = std::function<void(std::string_view)>;

/// One page. The scripts are names of files in src/view/pages/assets, in the order in which they run.
struct Page {
  std::string title;                                      ///< text
  std::string subtitle;                                   ///< text: a sentence that says what one sees
  std::string command;                                    ///< text: what a shell takes to make it again, or empty
  std::string sort;                                       ///< the class of the body
  std::string body;                                       ///< HTML
  std::vector<std::pair<std::string, std::string>> data;  ///< script elements: id, and what json_for_script made
  std::vector<std::string> scripts;
  std::vector<std::string> styles;  ///< names of files, after style.css
};

/// Writes a page, piece by piece.
/// @param more_data  called between the data and the scripts, for script elements that are too large for `data`; may be
///                   empty
void write_page(const Page& page, const Sink& sink, const std::function<void(const Sink&)>& more_data = {});
std::string page_text(const Page& page);

}  // namespace touchstone::view
