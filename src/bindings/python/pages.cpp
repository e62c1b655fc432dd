// Queries, and claims about them, as pages to look at, where the module was built with the view layer.
// SPDX-License-Identifier: MIT
#include <touchstone/solve.hpp>

#include <string>
#include <variant>
#include <vector>

#include "exact/exact.hpp"
#include "fuzz/judging/finding_text.hpp"
#include "python/arguments.hpp"
#include "python/background.hpp"
#include "python/define.hpp"
#include "python/query_arrays.hpp"
#include "view/pages/findings_page.hpp"
#include "view/pages/query_page.hpp"

namespace touchstone::python {
namespace {

std::string page_of(const Query& query, const std::string& title, double t_max, const Separation& separation) {
  // It refuses what exact::explain does not accept.
  static_cast<void>(solve(query, {.t_max = t_max, .separation = separation, .method = Method::exact}));
  view::QueryToShow shown;
  shown.title = title;
  shown.corners = fuzz::corners_text(query, "");
  shown.query = query;
  shown.story = separation.distance == 0 ? exact::explain(query, t_max) : exact::explain(query, t_max, separation);
  shown.t_max = t_max;
  shown.separation = separation;
  return view::page_text(view::query_page(shown));
}

std::string page(py::handle kind, py::handle start, py::handle end, py::handle t_max_number, py::handle distance,
                 py::handle metric, const std::string& title) {
  const QueryArrays queries(kind, start, end);
  if (!queries.is_single()) throw py::value_error("start has many queries; a page shows one");
  const Query query = queries.at(0);
  const Separation separation = separation_of(distance, metric, 1, true).separation;
  const double t_max = number_of(t_max_number, "t_max");
  return unlocked([&] { return page_of(query, title, t_max, separation); });
}

/// @param card  (kind, start, end, t_max, separation, metric, contact, toi, heading, about, detail). `contact` is None
/// where the solver gave no answer, and `toi` where it gave no time.
view::FindingToShow card_of(const py::tuple& card) {
  const QueryArrays queries(card[0], card[1], card[2]);
  if (!queries.is_single()) throw py::value_error("start has many queries; a card shows one");
  const Query query = queries.at(0);
  fuzz::Reply reply;
  if (card[6].is_none()) {
    reply.state = fuzz::Reply::State::crashed;
  } else {
    reply.contact = card[6].cast<bool>();
    if (!card[7].is_none()) reply.toi = number_of(card[7], "toi");
  }
  view::FindingToShow shown;
  shown.t_max = number_of(card[3], "t_max");
  shown.separation = separation_of(card[4], card[5], 1, true).separation;
  shown.heading = card[8].cast<std::string>();
  shown.degeneracy = card[9].cast<std::string>();
  shown.detail = card[10].cast<std::string>();
  shown.claim = fuzz::claim_text(reply);
  shown.corners = fuzz::corners_text(query, "");
  shown.query = query;
  return shown;
}

std::string claims_page(const std::string& title, const std::string& summary, const py::list& given) {
  std::vector<view::FindingToShow> cards;
  for (const py::handle card : given) cards.push_back(card_of(card.cast<py::tuple>()));
  return unlocked([&] {
    for (view::FindingToShow& card : cards) {
      card.answer = solve(std::get<Query>(card.query),
                          {.t_max = card.t_max, .separation = card.separation, .method = Method::exact});
      card.truth = fuzz::truth_text(card.answer);
    }
    return view::page_text(view::findings_page(title, summary, cards));
  });
}

}  // namespace

void define_pages(py::module_& module) {
  module.def("page", &page);
  module.def("claims_page", &claims_page);
}

}  // namespace touchstone::python
