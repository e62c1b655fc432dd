// V at one time, for filters that ask CGAL where doubles cannot tell its sign.
// SPDX-License-Identifier: MIT
#include <CGAL/Gmpzf.h>
#include <CGAL/determinant.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "oracle/oracle.hpp"

namespace touchstone::oracle {
namespace {

using Number = CGAL::Gmpzf;  // an integer times a power of two, as sums and products of doubles are
using NumberVector = std::array<Number, 3>;

/// (1 - t) start + t end, exactly.
NumberVector position_at(const Vec3& start, const Vec3& end, const Number& earlier, const Number& later) {
  return {earlier * Number(start.x) + later * Number(end.x), earlier * Number(start.y) + later * Number(end.y),
          earlier * Number(start.z) + later * Number(end.z)};
}

/// The determinant of the rows to[0] - from[0], to[1] - from[1], to[2] - from[2].
Number determinant_of_differences(const std::array<const NumberVector*, 3>& from,
                                  const std::array<const NumberVector*, 3>& to) {
  const auto row = [&](std::size_t i, std::size_t axis) -> Number { return (*to[i])[axis] - (*from[i])[axis]; };
  return CGAL::determinant<Number>(row(0, 0), row(0, 1), row(0, 2),  //
                                   row(1, 0), row(1, 1), row(1, 2),  //
                                   row(2, 0), row(2, 1), row(2, 2));
}

/// The double near `number`, in the range that `coplanarity_at` promises. CGAL truncates the mantissa to 53 bits, a
/// relative error of 2^-52; only the rounding of a subnormal result adds to it.
double nearby_double(const Number& number) {
  const auto [mantissa, exponent] = number.to_double_exp();
  const double result = std::ldexp(mantissa, static_cast<int>(exponent));
  if (mantissa == 0 || result != 0) return result;
  return std::copysign(std::bit_cast<double>(std::uint64_t{1}), mantissa);  // the least double above zero
}

}  // namespace

double coplanarity_at(const Query& query, double t) {
  const Number later(t);
  const Number earlier = Number(1) - later;
  std::array<NumberVector, 4> x;
  for (std::size_t i = 0; i < 4; ++i) x[i] = position_at(query.start[i], query.end[i], earlier, later);
  // The rows u, w and r of the two kinds: (u x w) . r = det(u, w, r).
  return nearby_double(query.kind == Kind::edge_edge
                           ? determinant_of_differences({&x[0], &x[2], &x[0]}, {&x[1], &x[3], &x[2]})
                           : determinant_of_differences({&x[1], &x[1], &x[1]}, {&x[2], &x[3], &x[0]}));
}

}  // namespace touchstone::oracle
