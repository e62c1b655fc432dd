// SPDX-License-Identifier: MIT
#include "view/pages/measurements_page.hpp"

#include <fmt/format.h>

#include <cstddef>

#include "view/chart.hpp"

namespace touchstone::view {
namespace {

std::string head_cell(const std::string& name) {
  return fmt::format("<th scope=\"col\"><button type=\"button\">{}</button></th>", escaped(name));
}

std::string table_of(const MeasuredSet& set, const std::vector<std::string>& columns, std::size_t number) {
  std::string html = "<div class=\"wide\"><table class=\"sorts\">\n<thead><tr>" + head_cell("method");
  for (const std::string& column : columns) html += head_cell(column);
  html += "</tr></thead>\n<tbody>\n";
  for (std::size_t m = 0; m < set.methods.size(); ++m) {
    const MeasuredMethod& method = set.methods[m];
    html += fmt::format("<tr id=\"row-{}-{}\" class=\"{}\"><th scope=\"row\">{}</th>", number, m,
                        method.look.own ? "own" : "other", escaped(method.label));
    for (const MeasuredMethod::Cell& cell : method.cells) {
      html += cell.value ? fmt::format("<td data-value=\"{}\">{}</td>", *cell.value, escaped(cell.text))
                         : fmt::format("<td>{}</td>", escaped(cell.text));
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string panel_of(const MeasuredSet& set, const Measurements& all, std::size_t panel, std::size_t number) {
  Chart chart{all.panels[panel].title, {all.time_axis, true}, {all.panels[panel].axis, true}, {}};
  for (std::size_t m = 0; m < set.methods.size(); ++m) {
    const MeasuredMethod& method = set.methods[m];
    if (!method.errors[panel] || !(method.time > 0)) continue;
    const double error = *method.errors[panel];
    if (chart.series.empty() || chart.series.back().name != method.look.name) chart.series.push_back(method.look);
    const std::string label =
        method.subset.empty() ? method.label : fmt::format("{} ({})", method.label, method.subset);
    chart.series.back().points.push_back(
        {method.time, error, label,
         fmt::format("{}: {:.3g} {}, {:.3g} {}", label, method.time, all.time_axis, error, all.panels[panel].axis),
         fmt::format("row-{}-{}", number, m), !method.subset.empty()});
  }
  return chart_svg(chart);
}

}  // namespace

Page measurements_page(const Measurements& measurements) {
  Page page;
  page.title = measurements.title;
  page.subtitle = measurements.subtitle;
  page.command = measurements.command;
  page.sort = "measurements";
  page.styles = {"chart.css", "measurements.css"};
  page.body = "<main>\n<p>" + escaped(measurements.summary) +
              "</p>\n<details><summary>What the words and the methods mean</summary>" + "<p class=\"wrapped\">" +
              escaped(measurements.how_to_read) + "</p></details>\n";
  for (std::size_t i = 0; i < measurements.sets.size(); ++i) {
    const MeasuredSet& set = measurements.sets[i];
    page.body += "<section class=\"set\">\n<h2>" + escaped(set.name) + "</h2>\n<p>" + escaped(set.about) +
                 "</p>\n<p class=\"told\" aria-live=\"polite\"></p>\n<div class=\"panels\">\n";
    for (std::size_t p = 0; p < measurements.panels.size(); ++p) page.body += panel_of(set, measurements, p, i);
    page.body += "</div>\n" + table_of(set, measurements.columns, i) + "</section>\n";
  }
  page.body += "</main>\n";
  page.scripts = {"measurements.js"};
  return page;
}

}  // namespace touchstone::view
