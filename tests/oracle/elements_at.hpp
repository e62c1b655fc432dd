// The elements of a query at one time, and how far apart they are.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "oracle/plain_distance.hpp"

namespace touchstone::tests {

template <class N>
struct Elements {
  plain::Element<N> a;
  plain::Element<N> b;
};

template <class N>
Elements<N> elements_at(const Query& query, const N& t) {
  const auto coordinate = [&](double from, double to) { return N(N(from) + t * (N(to) - N(from))); };
  Elements<N> elements;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const Vec3& x0 = query.start[i];
    const Vec3& x1 = query.end[i];
    auto& element = i == 0 || (i == 1 && query.kind == Kind::edge_edge) ? elements.a : elements.b;
    element.push_back({coordinate(x0.x, x1.x), coordinate(x0.y, x1.y), coordinate(x0.z, x1.z)});
  }
  return elements;
}

/// The distance, squared for the Euclidean metric.
template <class N>
N measure(const Elements<N>& elements, Metric metric) {
  return metric == Metric::euclidean ? plain::squared_distance(elements.a, elements.b)
                                     : plain::max_distance(elements.a, elements.b);
}

}  // namespace touchstone::tests
