// SPDX-License-Identifier: MIT
#include "view/pages/query_page.hpp"

#include <utility>
#include <variant>

#include "view/pages/story_html.hpp"
#include "view/picture.hpp"
#include "view/still.hpp"

namespace touchstone::view {

std::vector<std::string> viewer_scripts() {
  return {"numbers.js", "canvas.js",   "camera.js", "page_state.js",
          "shapes.js",  "timeline.js", "motion.js", "viewer.js"};
}

std::string viewer_html(const std::string& id, const nlohmann::json& picture) {
  return "<div class=\"viewer\" data-picture=\"" + escaped(id) + "\"><div class=\"stage\">\n" + still_of(picture) +
         "</div></div>\n";
}

Page query_page(const QueryToShow& shown) {
  const Kind kind = std::visit([](const auto& query) { return query.kind; }, shown.query);
  const bool curved = std::holds_alternative<CurvedQuery>(shown.query);
  const nlohmann::json picture = picture_of(shown.query, shown.story.answer, shown.t_max, shown.separation);
  Page page;
  page.title = shown.title;
  page.subtitle = answer_sentence(kind, shown.story.answer, shown.t_max, shown.separation);
  page.command = shown.command;
  page.sort = "query beside";
  page.styles = {"still.css"};
  page.body = "<main>\n" + viewer_html("picture", picture) + "<aside>\n" +
              story_html(kind, curved, shown.story, shown.t_max, shown.separation) +
              "<section>\n<h2>Corners</h2>\n<pre>" + escaped(shown.corners) + "</pre>\n</section>\n</aside>\n</main>\n";
  page.data.emplace_back("picture", json_for_script(picture));
  page.scripts = viewer_scripts();
  page.scripts.emplace_back("query.js");
  return page;
}

}  // namespace touchstone::view
