// The names of enumerators: one table, in which each name leads back to its value.
// SPDX-License-Identifier: MIT
#include <set>
#include <string>

#include <touchstone/certify.hpp>
#include <touchstone/mesh.hpp>
#include <touchstone/screw.hpp>
#include <touchstone/solve.hpp>

#include "support/catch.hpp"

namespace touchstone::tests {
namespace {

/// @param last  the last enumerator
template <class E>
void check_names(E last) {
  const Names names = names_of<E>();
  REQUIRE(names.size() == static_cast<std::size_t>(last) + 1);
  CHECK(std::set<std::string_view>(names.begin(), names.end()).size() == names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string_view name = name_of(static_cast<E>(i));
    CAPTURE(i, name);
    CHECK(name == names.begin()[i]);
    if (i > 0) CHECK_FALSE(name.empty());
    if (!name.empty()) CHECK(from_name<E>(name) == static_cast<E>(i));
    CHECK_FALSE(from_name<E>(std::string(name) + " "));
  }
  CHECK_FALSE(from_name<E>(""));
  CHECK(name_of(static_cast<E>(names.size())).empty());
  CHECK(name_of(static_cast<E>(255)).empty());
}

}  // namespace

TEST_CASE("each name of an enumerator leads back to its value, and no other text does") {
  check_names(Kind::point_point);
  check_names(Metric::max);
  check_names(Method::fast_cgal);
  check_names(Wanted::contact);
  check_names(Nature::entering);
  check_names(Feature::overlap);
  check_names(Trend::leaving);
  check_names(Level::oracle);
  check_names(Verdict::late);
  check_names(ScrewVerdict::within_bound);
  check_names(MeshElement::face);
  check_names(IntersectionSort::inside);
  check_names(StepOutcome::intersects_at_start);
  CHECK(name_of(Kind::vertex_face) == "vertex-face");
  CHECK(name_of(Method::fast_cgal) == "fast-cgal");
  CHECK(name_of(Feature::f12) == "f12");
  CHECK(name_of(Nature::none).empty());
}

}  // namespace touchstone::tests
