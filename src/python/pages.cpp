// A query as a page to look at, where the module was built with the view layer.
// SPDX-License-Identifier: MIT
#include <touchstone/solve.hpp>

#include <string>

#include "exact/exact.hpp"
#include "fuzz/finding_text.hpp"
#include "python/arguments.hpp"
#include "python/chunks.hpp"
#include "python/define.hpp"
#include "python/query_arrays.hpp"
#include "view/query_page.hpp"

namespace touchstone::python {
namespace {

std::string page_of(const Query& query, const std::string& title, const std::string& about, double t_max,
                    const Separation& separation) {
  static_cast<void>(solve(query, separation, Method::exact, t_max));  // it refuses what exact::explain does not accept
  view::QueryToShow shown;
  shown.title = title;
  shown.about = about;
  shown.corners = fuzz::corners_text(query, "");
  shown.query = query;
  shown.story = separation.distance == 0 ? exact::explain(query, t_max) : exact::explain(query, t_max, separation);
  shown.t_max = t_max;
  shown.separation = separation;
  return view::page_text(view::query_page(shown));
}

std::string page(py::handle kind, py::handle start, py::handle end, py::handle t_max_number, py::handle distance,
                 py::handle metric, const std::string& title, const std::string& about) {
  const QueryArrays queries(kind, start, end);
  if (!queries.is_single()) throw py::value_error("start has many queries; a page shows one");
  const Query query = queries.at(0);
  const Separation separation = separation_of(distance, metric, 1, true).separation;
  const double t_max = number_of(t_max_number, "t_max");
  return unlocked([&] { return page_of(query, title, about, t_max, separation); });
}

}  // namespace

void define_pages(py::module_& module) { module.def("page", &page); }

}  // namespace touchstone::python
