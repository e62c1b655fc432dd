// Exact times: real algebraic numbers of CGAL's algebraic kernel, and the oracle's questions about them. The kernel's
// headers stay behind this one.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "oracle/algebra.hpp"

namespace touchstone::oracle {

/// A time in [-1, 3/2]. Reading it may sharpen its isolating interval, so one Moment belongs to one thread.
class Moment {
 public:
  struct Impl;
  explicit Moment(std::shared_ptr<const Impl> impl);

  /// The exact sign of a polynomial at this time.
  CGAL::Sign sign(const Polynomial& polynomial) const;

  /// numerator / denominator at this time, within 2^-52 of the true value and in [0, 1].
  /// The denominator must not vanish there and the true value must be in [0, 1].
  double ratio(const Polynomial& numerator, const Polynomial& denominator) const;

  /// The largest double <= this time and the smallest >= it. The time must be in [0, 1].
  std::pair<double, double> enclosing_doubles() const;

  const Impl& impl() const { return *impl_; }

 private:
  std::shared_ptr<const Impl> impl_;
};

struct Root {
  Moment time;
  int multiplicity;
};

/// The roots of a polynomial, not the zero polynomial, in [0, t_max]: each once, ascending.
std::vector<Root> roots_within(const Polynomial& polynomial, double t_max);

/// 0, t_max and every root of the polynomials in [0, t_max]: each once, ascending. Zero polynomials are passed over.
std::vector<Moment> times_dividing(double t_max, const std::vector<Polynomial>& polynomials);

/// The same for any range: `low`, `high` and every root between them. -1 <= low <= high <= 3/2.
std::vector<Moment> times_dividing(const Rational& low, const Rational& high,
                                   const std::vector<Polynomial>& polynomials);

/// A rational time strictly between two different moments, the earlier first.
Rational rational_between(const Moment& earlier, const Moment& later);
Moment between(const Moment& earlier, const Moment& later);

}  // namespace touchstone::oracle
