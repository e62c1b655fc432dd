// Touchstone: the names of enumerators, in files, on the command line, in C and in Python.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include <touchstone/version.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// The names of an enumeration's values, in the order of their numbers. The value `none`, where there is one, has the
/// empty name.
class Names {
 public:
  /// The names of a static array.
  template <std::size_t N>
  constexpr Names(const std::string_view (&names)[N]) noexcept : first_(names), size_(N) {}

  constexpr const std::string_view* begin() const noexcept { return first_; }        ///< the name of the value 0
  constexpr const std::string_view* end() const noexcept { return first_ + size_; }  ///< past the last name
  constexpr std::size_t size() const noexcept { return size_; }                      ///< the number of values

 private:
  const std::string_view* first_;
  std::size_t size_;
};

/// The names of E, which is Kind, Metric, Method, Wanted, Nature, Feature, Trend, Level, Verdict, ScrewVerdict,
/// MeshElement, IntersectionSort, StepOutcome or FuzzFailure.
template <class E>
Names names_of() noexcept = delete;

/// The name of `value`: "edge-edge", "max", "fast-cgal", "f01". Empty for a value that is none of the enumerators.
template <class E, class = decltype(names_of<E>())>
std::string_view name_of(E value) noexcept {
  const Names names = names_of<E>();
  const auto index = static_cast<std::size_t>(value);
  return index < names.size() ? names.begin()[index] : std::string_view{};
}

/// The value of E with this name. Nothing for any other text, and for the empty one.
template <class E>
std::optional<E> from_name(std::string_view name) noexcept {
  const Names names = names_of<E>();
  for (std::size_t i = 0; i < names.size() && !name.empty(); ++i) {
    if (names.begin()[i] == name) return static_cast<E>(i);
  }
  return std::nullopt;
}

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
