// Polynomials in t of any formal degree up to the largest. SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "numbers/coefficients.hpp"
#include "numbers/exact_number.hpp"

namespace touchstone::exact {

using numbers::Exact;

/// A polynomial with exact coefficients. A product's formal degree is the sum of its factors'; it is at most
/// numbers::kMostDegree.
class Form {
 public:
  Form() = default;  ///< the constant 0
  explicit Form(const Exact& constant) { c_[0] = constant; }
  Form(const Exact& constant, const Exact& slope) : size_(2) {
    c_[0] = constant;
    c_[1] = slope;
  }

  int size() const { return static_cast<int>(size_); }
  const Exact& operator[](int i) const { return c_[static_cast<std::size_t>(i)]; }
  operator numbers::Coefficients() const { return {c_.data(), size()}; }

  bool is_zero() const {
    return std::all_of(c_.begin(), c_.begin() + static_cast<std::ptrdiff_t>(size_),
                       [](const Exact& c) { return numbers::is_zero(c); });
  }

  friend Form operator+(const Form& p, const Form& q) {
    Form sum = p.size_ < q.size_ ? q : p;
    const Form& shorter = p.size_ < q.size_ ? p : q;
    for (std::size_t i = 0; i < shorter.size_; ++i) sum.c_[i] = sum.c_[i] + shorter.c_[i];
    return sum;
  }
  friend Form operator-(const Form& p) {
    Form negative = p;
    for (std::size_t i = 0; i < p.size_; ++i) negative.c_[i] = -p.c_[i];
    return negative;
  }
  friend Form operator-(const Form& p, const Form& q) {
    Form difference = p;
    difference.size_ = std::max(p.size_, q.size_);
    for (std::size_t i = 0; i < q.size_; ++i) difference.c_[i] = difference.c_[i] - q.c_[i];
    return difference;
  }
  friend Form operator*(const Form& p, const Form& q) {
    Form product;
    product.size_ = p.size_ + q.size_ - 1;
    for (std::size_t i = 0; i < p.size_; ++i) {
      for (std::size_t j = 0; j < q.size_; ++j) product.c_[i + j] = product.c_[i + j] + p.c_[i] * q.c_[j];
    }
    return product;
  }
  friend Form operator*(const Form& p, const Exact& factor) { return p * Form(factor); }

 private:
  std::size_t size_ = 1;
  std::array<Exact, numbers::kMostDegree + 1> c_;
};

}  // namespace touchstone::exact
