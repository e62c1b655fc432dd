// Numbers, points and lists as terms of Coq, and as decimals for a person.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <touchstone/query.hpp>

#include "proofs/dense.hpp"

namespace touchstone::proofs {

/// A rational number.
struct NumberText {
  std::string decimal;      ///< rounded: "0.1"
  std::string term;         ///< "0", "(-3)", "(5 # 8)", "(5 # 2^54)", "(5 * 2^70 # 1)": what Coq takes for an argument
  std::string denominator;  ///< "1", "8", "2^54"
};
NumberText number_text(const Exact& x);
NumberText number_text(double x);
NumberText number_text(const Fraction& x);  ///< as given: it need not be in lowest terms

/// Coordinates, or a quaternion.
using NumberTexts = std::vector<NumberText>;
NumberTexts number_texts(const Vec3& x);
NumberTexts number_texts(const std::array<Fraction, 3>& x);

/// "(0.1, 0, -3)"
std::string decimals_of(const NumberTexts& numbers);

/// "Rational (1 # 8) 0 (-3)", of three coordinates.
std::string rational_point(const NumberTexts& coordinates);

/// An integer that nobody reads: "-3", "0x5 * 2^70". Coq reads long numbers faster in hexadecimal digits.
std::string integer_term(const Exact& x);

/// "[a; b]", with this text between.
std::string list_term(const std::vector<std::string>& terms, std::string_view between = "; ");

/// The coefficients, which are integers.
std::string polynomial_term(const Dense& p);

}  // namespace touchstone::proofs
