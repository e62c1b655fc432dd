// CGAL's kernels: whether two elements that stand still have a point in common.
// SPDX-License-Identifier: MIT
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>

#include "engine.hpp"

namespace {

using engine::Answer;
using engine::Query;

template <class Kernel>
Answer still(const Query& q) {
  using Point = typename Kernel::Point_3;
  using Segment = typename Kernel::Segment_3;
  std::vector<Point> p;
  for (const engine::Point& c : q.start) p.emplace_back(c[0], c[1], c[2]);
  bool contact = false;
  if (q.kind == "edge-edge") contact = CGAL::do_intersect(Segment(p[0], p[1]), Segment(p[2], p[3]));
  if (q.kind == "vertex-face") contact = typename Kernel::Triangle_3(p[1], p[2], p[3]).has_on(p[0]);
  if (q.kind == "point-edge") contact = Segment(p[1], p[2]).has_on(p[0]);
  return contact ? engine::contact_at(0) : engine::no_contact();
}

std::string description(const std::string& kernel) {
  return "engine CGAL " CGAL_VERSION_STR
         "\n"
         "asks do_intersect and has_on of segments and triangles, " +
         kernel +
         "\n"
         "kinds edge-edge vertex-face point-edge\n"
         "motion still\n"
         "elements 0.001\n";
}

}  // namespace

int main(int argc, char** argv) {
  return engine::serve(argc, argv,
                       {{"exact",
                         description("Exact_predicates_inexact_constructions_kernel") +
                             "tolerance-relative 0\n"
                             "note its documentation says that predicates are exact\n",
                         still<CGAL::Exact_predicates_inexact_constructions_kernel>},
                        {"doubles",
                         description("Simple_cartesian<double>") +
                             "note its documentation says that predicates of this kernel may be wrong by rounding\n",
                         still<CGAL::Simple_cartesian<double>>}});
}
