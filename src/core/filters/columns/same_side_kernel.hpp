// The kernel's text. Each file that includes it is compiled for vectors of another width, so no compiled function may
// be shared between these files: the functions here are local to the file, the templates of coplanarity_form.hpp are
// instantiated for types that only that file has, and nothing of the standard library is called.
// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "filters/columns/same_side_columns.hpp"
#include "filters/coplanarity_form.hpp"
#include "numbers/doubles/pack.hpp"

namespace touchstone::filters {
namespace {

using numbers::Pack;

template <int Width, Kind K>
TOUCHSTONE_INLINE StepFrame<Pack<Width>> frame_of_columns(const Columns& columns, std::size_t first) {
  using Lanes = numbers::Lanes<Pack<Width>>;
  const auto corner = [&columns, first](int side, std::size_t i) {
    const auto& x = (side == 0 ? columns.start : columns.end)[i];
    return geometry::Vector<Pack<Width>>{
        {Lanes::loaded(x[0] + first), Lanes::loaded(x[1] + first), Lanes::loaded(x[2] + first)}};
  };
  return step_frame<Pack<Width>>(K, corner);
}

template <int Width, Kind K>
void same_side_pack(const Columns& columns, std::size_t first, std::int64_t* proved) {
  const StepFrame<Pack<Width>> frame = frame_of_columns<Width, K>(columns, first);
  numbers::Lanes<Pack<Width>>::store(certain_same_side(frame, coplanarity_coefficients(frame)), proved);
}

/// Whole packs; the rest one by one.
template <int Width, Kind K>
void same_side(const Columns& columns, std::size_t first, std::size_t count, std::int64_t* proved) {
  std::size_t i = 0;
  for (; i + Width <= count; i += Width) same_side_pack<Width, K>(columns, first + i, proved + i);
  for (; i < count; ++i) same_side_pack<1, K>(columns, first + i, proved + i);
}

template <int Width, Kind K, bool Euclidean>
void clearance(const Columns& columns, const double* distances, std::size_t first, std::size_t count,
               std::int64_t* proved) {
  const auto prove = [&](auto width, std::size_t i) {
    constexpr int kWidth = decltype(width)::value;
    using Lanes = numbers::Lanes<Pack<kWidth>>;
    const StepFrame<Pack<kWidth>> frame = frame_of_columns<kWidth, K>(columns, first + i);
    Lanes::store(certain_clearance<Euclidean>(frame, Lanes::loaded(distances + i)), proved + i);
  };
  std::size_t i = 0;
  for (; i + Width <= count; i += Width) prove(std::integral_constant<int, Width>(), i);
  for (; i < count; ++i) prove(std::integral_constant<int, 1>(), i);
}

template <int Width>
SameSideKernel kernel_for(Kind kind) {
  return kind == Kind::edge_edge ? same_side<Width, Kind::edge_edge> : same_side<Width, Kind::vertex_face>;
}

template <int Width>
ClearanceKernel clearance_kernel_for(Kind kind, Metric metric) {
  if (metric == Metric::euclidean) {
    return kind == Kind::edge_edge ? clearance<Width, Kind::edge_edge, true>
                                   : clearance<Width, Kind::vertex_face, true>;
  }
  return kind == Kind::edge_edge ? clearance<Width, Kind::edge_edge, false>
                                 : clearance<Width, Kind::vertex_face, false>;
}

}  // namespace
}  // namespace touchstone::filters
