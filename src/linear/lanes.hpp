// Four numbers that Eigen's sparse matrices take for one: what it computes of one matrix it then computes of four side
// by side. A single chain of a cable's unknowns leaves the processor waiting for each of them; four do not.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace touchstone::linear {

struct Lanes {
  static constexpr int kCount = 4;
  Lanes() = default;
  Lanes(double all) : each(Array::Constant(all)) {}  // implicit, as Eigen writes Scalar(0) and 1 alike

  Lanes& operator+=(const Lanes& b) { return *this = *this + b; }
  Lanes& operator-=(const Lanes& b) { return *this = *this - b; }
  Lanes& operator*=(const Lanes& b) { return *this = *this * b; }
  Lanes& operator/=(const Lanes& b) { return *this = *this / b; }
  friend Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.each + b.each); }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.each - b.each); }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.each * b.each); }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.each / b.each); }
  friend bool operator==(const Lanes& a, const Lanes& b) { return (a.each == b.each).all(); }
  friend bool operator!=(const Lanes& a, const Lanes& b) { return !(a == b); }
  // Eigen compiles L L^T along with L D L^T.
  friend bool operator<=(const Lanes& a, const Lanes& b) { return (a.each <= b.each).any(); }
  friend Lanes sqrt(const Lanes& a) { return Lanes(a.each.sqrt()); }

  using Array = Eigen::Array<double, kCount, 1>;
  Array each;

 private:
  template <class Expression>
  explicit Lanes(const Eigen::ArrayBase<Expression>& all) : each(all) {}
};

}  // namespace touchstone::linear

template <>
struct Eigen::NumTraits<touchstone::linear::Lanes> : Eigen::GenericNumTraits<touchstone::linear::Lanes> {};
