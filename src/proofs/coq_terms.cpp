// SPDX-License-Identifier: MIT
#include "proofs/coq_terms.hpp"

#include <charconv>
#include <cmath>

#include "numbers/integers/common_denominator.hpp"
#include "proofs/proof_text.hpp"

namespace touchstone::proofs {
namespace {

/// The shortest decimal that rounds to the double.
std::string decimal_of(double x) {
  if (!std::isfinite(x)) return x > 0 ? "over 1e308" : "below -1e308";
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, x + 0.0).ptr};
}

Exact integer_of(const std::string& digits) { return numbers::over_common_denominator({{digits, "1"}})[0]; }

}  // namespace

NumberText number_text(const Exact& x) {
  constexpr long kWritten = 10;  // powers of two below 2^10 are written as numbers
  NumberText number{decimal_of(numbers::to_double(x)), numbers::to_string(x), "1"};
  std::string& term = number.term;
  const std::size_t times = term.find(" * 2^");
  if (times != std::string::npos) {
    if (term[times + 5] == '-') {
      const long power = std::stol(term.substr(times + 6));
      number.denominator = power < kWritten ? std::to_string(1L << power) : "2^" + std::to_string(power);
      term.resize(times);
    }
    if (term.rfind("1 * ", 0) == 0) term.erase(0, 4);
    term += " # " + number.denominator;
  }
  if (times != std::string::npos || x.sign() < 0) term = '(' + term + ')';
  return number;
}

NumberText number_text(double x) { return number_text(Exact(x)); }

NumberText number_text(const Fraction& x) {
  std::string above = x.numerator, below = x.denominator;
  if (below[0] == '-') {
    below.erase(0, 1);
    above = above[0] == '-' ? above.substr(1) : '-' + above;
  }
  const Exact numerator = integer_of(above), denominator = integer_of(below);
  if (numerator.is_zero()) return number_text(numerator);
  const std::string decimal = decimal_of(numbers::approximate_quotient(numerator, denominator));
  if (denominator == Exact(1)) return {decimal, numerator.sign() < 0 ? '(' + above + ')' : above, "1"};
  return {decimal, '(' + above + " # " + below + ')', below};
}

NumberTexts number_texts(const Vec3& x) { return {number_text(x.x), number_text(x.y), number_text(x.z)}; }
NumberTexts number_texts(const std::array<Fraction, 3>& x) {
  return {number_text(x[0]), number_text(x[1]), number_text(x[2])};
}

std::string decimals_of(const NumberTexts& numbers) {
  std::string text;
  for (const NumberText& number : numbers) text += (text.empty() ? "(" : ", ") + number.decimal;
  return text + ')';
}

std::string rational_point(const NumberTexts& coordinates) {
  std::string text = "Rational";
  for (const NumberText& number : coordinates) text += ' ' + number.term;
  return text;
}

std::string integer_term(const Exact& x) {
  std::string text;
  append_number(text, x);
  const std::size_t power = text.find('p');
  return power == std::string::npos ? text : text.replace(power, 1, " * 2^");
}

std::string list_term(const std::vector<std::string>& terms, std::string_view between) {
  std::string text;
  for (const std::string& term : terms) text.append(text.empty() ? "" : between).append(term);
  return '[' + text + ']';
}

std::string polynomial_term(const Dense& p) {
  std::vector<std::string> terms;
  for (const Exact& c : p) terms.push_back(integer_term(c));
  return list_term(terms);
}

}  // namespace touchstone::proofs
