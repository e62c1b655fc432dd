// Polynomials in t of any formal degree up to the largest.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>

#include "numbers/integers/exact_list.hpp"
#include "numbers/integers/exact_number.hpp"
#include "numbers/roots/coefficients.hpp"

namespace touchstone::exact {

using numbers::Exact;

/// A polynomial with exact coefficients. A product's formal degree is the sum of its factors'; it is at most
/// numbers::kMostDegree where roots or signs are asked for.
class Form {
 public:
  Form() : c_(1) {}  ///< the constant 0
  explicit Form(const Exact& constant) : c_(&constant, 1) {}
  Form(const Exact& constant, const Exact& slope) : c_(2) {
    c_[0] = constant;
    c_[1] = slope;
  }
  /// The coefficients, constant first; at least one.
  explicit Form(numbers::ExactList coefficients) : c_(std::move(coefficients)) {}

  int size() const { return c_.size(); }
  const Exact& operator[](int i) const { return c_[static_cast<std::size_t>(i)]; }
  operator numbers::Coefficients() const { return {c_.begin(), size()}; }

  bool is_zero() const {
    return std::all_of(c_.begin(), c_.end(), [](const Exact& c) { return numbers::is_zero(c); });
  }
  friend bool is_zero(const Form& p) { return p.is_zero(); }

  /// The same polynomial without the leading zeros of sizes above `least`.
  Form trimmed(int least) && {
    int size = c_.size();
    while (size > least && numbers::is_zero(c_[static_cast<std::size_t>(size - 1)])) --size;
    c_.shorten(size);
    return std::move(*this);
  }

  friend bool operator==(const Form& p, const Form& q) { return (p - q).is_zero(); }
  friend Form operator+(const Form& p, const Form& q) {
    Form sum = p.size() < q.size() ? q : p;
    const Form& shorter = p.size() < q.size() ? p : q;
    for (std::size_t i = 0; i < shorter.count(); ++i) sum.c_[i] = sum.c_[i] + shorter.c_[i];
    return sum;
  }
  friend Form operator-(const Form& p) {
    Form negative = p;
    for (Exact& c : negative.c_) c = -c;
    return negative;
  }
  friend Form operator-(const Form& p, const Form& q) {
    if (p.size() < q.size()) return -q + p;
    Form difference = p;
    for (std::size_t i = 0; i < q.count(); ++i) difference.c_[i] = difference.c_[i] - q.c_[i];
    return difference;
  }
  friend Form operator*(const Form& p, const Form& q) {
    numbers::ExactList product(p.size() + q.size() - 1);
    for (std::size_t i = 0; i < p.count(); ++i) {
      if (numbers::is_zero(p.c_[i])) continue;
      for (std::size_t j = 0; j < q.count(); ++j) {
        Exact& sum = product[i + j];
        sum = numbers::is_zero(sum) ? p.c_[i] * q.c_[j] : sum + p.c_[i] * q.c_[j];
      }
    }
    return Form(std::move(product));
  }
  friend Form operator*(const Form& p, const Exact& factor) { return p * Form(factor); }

 private:
  std::size_t count() const { return static_cast<std::size_t>(c_.size()); }

  numbers::ExactList c_;
};

}  // namespace touchstone::exact
