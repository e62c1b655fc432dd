// The names of kinds, their elements and corners, natures, trends, metrics, features, levels, and of what is wanted.
// SPDX-License-Identifier: MIT
#include <cstddef>

#include <touchstone/answer.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "geometry/kind_traits.hpp"

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

template <>
Names names_of<MeshElement>() noexcept {
  static constexpr std::string_view kNames[] = {"vertex", "edge", "face"};
  return kNames;
}

template <>
Names names_of<Kind>() noexcept {
  static constexpr std::string_view kNames[] = {"edge-edge", "vertex-face", "point-edge", "point-point"};
  return kNames;
}

std::string_view corner_name(Kind kind, std::size_t index) noexcept {
  if (static_cast<std::size_t>(kind) >= kKinds.size() || index >= corner_count(kind)) return {};
  const auto& [first, second] = geometry::traits_of(kind);
  return name_of(index < first.corners() ? first.corner(index) : second.corner(index - first.corners()));
}

template <>
Names names_of<Nature>() noexcept {
  static constexpr std::string_view kNames[] = {"", "crossing", "grazing", "sustained", "isolated", "entering"};
  return kNames;
}

template <>
Names names_of<Trend>() noexcept {
  static constexpr std::string_view kNames[] = {"", "approaching", "constant", "leaving"};
  return kNames;
}

template <>
Names names_of<Metric>() noexcept {
  static constexpr std::string_view kNames[] = {"euclidean", "max"};
  return kNames;
}

template <>
Names names_of<Feature>() noexcept {
  static constexpr std::string_view kNames[] = {"",    "a0",  "a1",  "a", "b0", "b1", "b",  "v", "f0", "f1",     "f2",
                                                "f01", "f12", "f20", "f", "p",  "e0", "e1", "e", "q",  "overlap"};
  return kNames;
}

template <>
Names names_of<Level>() noexcept {
  static constexpr std::string_view kNames[] = {"filter", "bracket", "exact", "oracle"};
  return kNames;
}

template <>
Names names_of<Wanted>() noexcept {
  static constexpr std::string_view kNames[] = {"all", "features", "time", "contact"};
  return kNames;
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
