// SPDX-License-Identifier: MIT
#include "view/pages/findings_page.hpp"

#include <cstddef>

#include "view/pages/query_page.hpp"
#include "view/picture.hpp"

namespace touchstone::view {
namespace {

std::string card(std::size_t number, const FindingToShow& finding, const std::string& id,
                 const nlohmann::json& picture) {
  std::string text = "<article class=\"card\">\n<h2>" + std::to_string(number) + ". " + escaped(finding.heading) +
                     "</h2>\n<p class=\"degeneracy\">" + escaped(finding.degeneracy) + "</p>\n" +
                     viewer_html(id, picture) + "<dl>\n<dt>claim</dt><dd class=\"claim\">" + escaped(finding.claim) +
                     "</dd>\n<dt>exact</dt><dd class=\"truth\">" + escaped(finding.truth) + "</dd>\n</dl>\n";
  if (!finding.detail.empty()) text += "<p>" + escaped(finding.detail) + "</p>\n";
  text += "<pre>" + escaped(finding.corners) + "</pre>\n";
  for (const std::string& command : finding.commands) text += command_html(command);
  return text + "</article>\n";
}

}  // namespace

Page findings_page(const std::string& title, const std::string& summary, const std::vector<FindingToShow>& findings) {
  Page page;
  page.title = title;
  page.subtitle = findings.empty() ? "No claim was found to be wrong."
                                   : "Each card is a query about which a claim is wrong: its picture, the claim, and "
                                     "the exact answer. In a picture the elements are where they meet or come "
                                     "closest; pale are the start and the end, and dotted the paths of the corners.";
  page.sort = "findings";
  page.styles = {"still.css"};
  const std::string first_line = summary.substr(0, summary.find('\n'));
  page.body = "<details class=\"summary\"><summary>" + escaped(first_line) + "</summary>\n<pre>" + escaped(summary) +
              "</pre></details>\n<main class=\"cards\">\n";
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const FindingToShow& finding = findings[i];
    const nlohmann::json picture = picture_of(finding.query, finding.answer, finding.t_max, finding.separation);
    const std::string id = "picture-" + std::to_string(i + 1);
    page.body += card(i + 1, finding, id, picture);
    page.data.emplace_back(id, json_for_script(picture));
  }
  page.body += "</main>\n";
  page.scripts = viewer_scripts();
  page.scripts.emplace_back("findings.js");
  return page;
}

}  // namespace touchstone::view
