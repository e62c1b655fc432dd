// Four doubles as one number for Eigen's sparse matrices, which then factorise four matrices of one pattern at once. In
// the factor of a single cable each unknown waits for the one before it; with four, the processor has work meanwhile.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace touchstone::linear {

struct FourDoubles {
  static constexpr int kCount = 4;
  FourDoubles() = default;
  FourDoubles(double all) : each(Array::Constant(all)) {}  // implicit, as Eigen writes Scalar(0) and 1 alike

  FourDoubles& operator+=(const FourDoubles& b) { return *this = *this + b; }
  FourDoubles& operator-=(const FourDoubles& b) { return *this = *this - b; }
  FourDoubles& operator*=(const FourDoubles& b) { return *this = *this * b; }
  FourDoubles& operator/=(const FourDoubles& b) { return *this = *this / b; }
  friend FourDoubles operator+(const FourDoubles& a, const FourDoubles& b) { return FourDoubles(a.each + b.each); }
  friend FourDoubles operator-(const FourDoubles& a, const FourDoubles& b) { return FourDoubles(a.each - b.each); }
  friend FourDoubles operator-(const FourDoubles& a) { return FourDoubles(-a.each); }  // for Eigen 5
  friend FourDoubles operator*(const FourDoubles& a, const FourDoubles& b) { return FourDoubles(a.each * b.each); }
  friend FourDoubles operator/(const FourDoubles& a, const FourDoubles& b) { return FourDoubles(a.each / b.each); }
  friend bool operator==(const FourDoubles& a, const FourDoubles& b) { return (a.each == b.each).all(); }
  friend bool operator!=(const FourDoubles& a, const FourDoubles& b) { return !(a == b); }
  // Eigen compiles L L^T along with L D L^T.
  friend bool operator<=(const FourDoubles& a, const FourDoubles& b) { return (a.each <= b.each).any(); }
  friend FourDoubles sqrt(const FourDoubles& a) { return FourDoubles(a.each.sqrt()); }

  using Array = Eigen::Array<double, kCount, 1>;
  Array each;

 private:
  template <class Expression>
  explicit FourDoubles(const Eigen::ArrayBase<Expression>& all) : each(all) {}
};

}  // namespace touchstone::linear

template <>
struct Eigen::NumTraits<touchstone::linear::FourDoubles> : Eigen::GenericNumTraits<touchstone::linear::FourDoubles> {};
