// SPDX-License-Identifier: MIT
#include "view/pages/html.hpp"

#include <cstddef>
#include <stdexcept>

#include "io/characters.hpp"
#include "view/pages/page_files.hpp"

namespace touchstone::view {
const std::string& page_file(std::string_view name) {
  for (const PageFile& file : page_files()) {
    if (file.name == name) return file.content;
  }
  throw std::logic_error("the program has no page file " + std::string(name));
}

std::string escaped(std::string_view text) {
  constexpr std::string_view kReplacement = "\xef\xbf\xbd";
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const auto [length, code] = io::character_at(text, at);
    const char c = text[at];
    if (length == 0 || (io::is_control(code) && c != '\n' && c != '\t')) {
      result += kReplacement;
    } else if (length > 1) {
      result += text.substr(at, length);
    } else if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '"') {
      result += "&quot;";
    } else if (c == '\'') {
      result += "&#39;";
    } else {
      result += c;
    }
    at += length == 0 ? 1 : length;
  }
  return result;
}

std::string json_for_script(const nlohmann::json& data) {
  const std::string text = data.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    // Outside of strings JSON has none of these.
    if (c == '<') {
      result += "\\u003c";
    } else if (c == '>') {
      result += "\\u003e";
    } else if (c == '&') {
      result += "\\u0026";
    } else {
      result += c;
    }
  }
  return result;
}

std::string command_html(const std::string& command) {
  return command.empty() ? "" : "<pre class=\"command\">" + escaped(command) + "</pre>\n";
}

void write_page(const Page& page, const Sink& sink, const std::function<void(const Sink&)>& more_data) {
  // The policy forbids every request: the page needs nothing but itself.
  sink(R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'; )"
       R"(style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>)");
  sink(escaped(page.title));
  sink("</title>\n<style>\n");
  for (const char* name : {"colours.css", "style.css"}) sink(page_file(name));
  for (const std::string& name : page.styles) sink(page_file(name));
  sink("</style>\n</head>\n<body class=\"" + escaped(page.sort) + "\">\n<header>\n<h1>" + escaped(page.title) +
       "</h1>\n");
  if (!page.subtitle.empty()) sink("<p>" + escaped(page.subtitle) + "</p>\n");
  sink(command_html(page.command));
  sink(
      "</header>\n<noscript><p class=\"note\">Scripts are off: the page shows still pictures and the text.</p>"
      "</noscript>\n");
  sink(page.body);
  for (const auto& [id, json] : page.data) {
    sink("<script type=\"application/json\" id=\"" + escaped(id) + "\">");
    sink(json);
    sink("</script>\n");
  }
  if (more_data) more_data(sink);
  sink("<script>\n'use strict';\n");
  for (const std::string& name : page.scripts) sink(page_file(name));
  sink("</script>\n</body>\n</html>\n");
}

std::string page_text(const Page& page) {
  std::string text;
  write_page(page, [&text](std::string_view bytes) { text += bytes; });
  return text;
}

}  // namespace touchstone::view
