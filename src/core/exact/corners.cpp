// SPDX-License-Identifier: MIT
#include "exact/corners.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "exact/common_scale.hpp"
#include "numbers/integers/common_denominator.hpp"

namespace touchstone::exact {
namespace {

template <class N>
typename Forms<N>::Point moving(const std::array<N, 3>& start, const std::array<N, 3>& end) {
  typename Forms<N>::Point point;
  for (std::size_t k = 0; k < 3; ++k) point[k] = typename Forms<N>::Linear{{start[k], end[k] - start[k]}};
  return point;
}

template <class Corners, class ToIntegers>
Corners corners_of(const Query& query, const ToIntegers& integers) {
  Corners corners;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    corners[i] = moving(integers(query.start[i]), integers(query.end[i]));
  }
  return corners;
}

template <class N>
typename Forms<N>::Corners integer_corners(const Query& query, const std::array<int, 3>& low) {
  return corners_of<typename Forms<N>::Corners>(query, [&low](const Vec3& x) {
    return std::array<N, 3>{N::scaled(x.x, low[0]), N::scaled(x.y, low[1]), N::scaled(x.z, low[2])};
  });
}

template <class N>
typename Forms<N>::Corners integer_corners(const Query& query) {
  const int low = coordinate_span(query).low;
  return integer_corners<N>(query, {low, low, low});
}

template <class Integer>
typename Forms<Integer>::Corners near_corners(const Query& query, const std::array<BitSpan, 3>& spans) {
  if constexpr (kMostBits<Integer> < 63) {
    // The power of two and the product are exact: the product is an integer of at most kMostBits bits.
    const auto is_ordinary = [](const BitSpan& span) { return span.low > -1000 && span.low < 1000; };
    if (is_ordinary(spans[0]) && is_ordinary(spans[1]) && is_ordinary(spans[2])) {
      const auto power = [](int exponent) {
        return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
      };
      const Vec3 unit = {power(-spans[0].low), power(-spans[1].low), power(-spans[2].low)};
      const auto integer = [](double x) { return Integer::integer(static_cast<std::int64_t>(x)); };
      return corners_of<typename Forms<Integer>::Corners>(query, [&](const Vec3& x) {
        return std::array<Integer, 3>{integer(x.x * unit.x), integer(x.y * unit.y), integer(x.z * unit.z)};
      });
    }
  }
  return integer_corners<Integer>(query, {spans[0].low, spans[1].low, spans[2].low});
}

}  // namespace

template <>
Forms<Short>::Corners moving_corners<Short>(const Query& query) {
  return integer_corners<Short>(query);
}

template <>
Forms<Medium>::Corners moving_corners<Medium>(const Query& query) {
  return integer_corners<Medium>(query);
}

template <>
Forms<Long>::Corners moving_corners<Long>(const Query& query) {
  return integer_corners<Long>(query);
}

template <>
Forms<Near<SmallInt>>::Corners moving_corners<Near<SmallInt>>(const Query& query, const std::array<BitSpan, 3>& spans) {
  return near_corners<SmallInt>(query, spans);
}

template <>
Forms<Near<Short>>::Corners moving_corners<Near<Short>>(const Query& query, const std::array<BitSpan, 3>& spans) {
  return near_corners<Short>(query, spans);
}

template <>
Forms<Near<Medium>>::Corners moving_corners<Near<Medium>>(const Query& query, const std::array<BitSpan, 3>& spans) {
  return near_corners<Medium>(query, spans);
}

ScaledCorners scaled_corners(const Query& query) {
  const std::size_t count = corner_count(query.kind);
  OrdinarySize size;
  for (std::size_t i = 0; i < count; ++i) {
    size.add(query.start[i]);
    size.add(query.end[i]);
  }
  const int power = size.power();
  const Exact factor = numbers::power_of_two(power);
  const auto exact = [&](const Vec3& x) {
    std::array<Exact, 3> c = {Exact(x.x), Exact(x.y), Exact(x.z)};
    if (power != 0) {
      for (Exact& coordinate : c) coordinate = coordinate * factor;
    }
    return c;
  };
  ScaledCorners result = {{}, factor};
  for (std::size_t i = 0; i < count; ++i) result.corners[i] = moving<Exact>(exact(query.start[i]), exact(query.end[i]));
  return result;
}

ScaledCorners scaled_corners(const RationalQuery& query) {
  const std::size_t count = corner_count(query.kind);
  std::vector<std::pair<std::string_view, std::string_view>> fractions;
  for (std::size_t i = 0; i < count; ++i) {
    for (const auto* corners : {&query.start, &query.end}) {
      for (const Fraction& f : (*corners)[i]) fractions.emplace_back(f.numerator, f.denominator);
    }
  }
  fractions.emplace_back("1", "1");  // becomes the common denominator
  std::vector<Exact> integers = numbers::over_common_denominator(fractions);
  Exact denominator = integers.back();
  integers.pop_back();
  long largest = 0;
  for (const Exact& x : integers) largest = std::max(largest, numbers::approximate(x).exponent);
  const Exact factor = numbers::power_of_two(-largest);
  for (Exact& x : integers) x = x * factor;
  ScaledCorners result = {{}, denominator * factor};
  for (std::size_t i = 0; i < count; ++i) {
    const Exact* c = &integers[6 * i];
    result.corners[i] = moving<Exact>({c[0], c[1], c[2]}, {c[3], c[4], c[5]});
  }
  return result;
}

template <>
Forms<Exact>::Corners moving_corners<Exact>(const Query& query) {
  return scaled_corners(query).corners;
}

template <>
Forms<Exact>::Corners moving_corners<Exact>(const RationalQuery& query) {
  return scaled_corners(query).corners;
}

}  // namespace touchstone::exact
