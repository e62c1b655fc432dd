// Travelling waves without libm: sums, products, quotients, floor and square roots, the same bits on every machine.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <vector>

#include "generators/vectors.hpp"
#include "seeded/rng.hpp"

namespace touchstone::generators {

/// sin(2 pi x) within 2^-23, odd about 0: Taylor's polynomial of degree 11 on a quarter of a turn. As motion it is as
/// good as the sine, and unlike std::sin it is the same everywhere.
inline double sine(double turns) noexcept {
  double x = turns - std::floor(turns + 0.5);
  if (x > 0.25) x = 0.5 - x;
  if (x < -0.25) x = -0.5 - x;
  const double y = 6.283185307179586 * x;
  const double s = y * y;
  return y * (1 - s / 6 * (1 - s / 20 * (1 - s / 42 * (1 - s / 72 * (1 - s / 110)))));
}

inline double cosine(double turns) noexcept { return sine(turns + 0.25); }

/// From -1 to 1 and back in straight lines, once a turn: the sharp folds of crumpled material.
inline double crease(double turns) noexcept { return 4 * std::fabs(turns - std::floor(turns + 0.5)) - 1; }

/// A sum of waves that travel in random directions; between -1 and 1.
class Waves {
 public:
  struct Shape {
    int count;            ///< of waves
    double least_length;  ///< of a wave
    double greatest_length;
    double folded = 0;  ///< how much of the sum is creases; the rest is sines
  };

  Waves(const Shape& shape, seeded::Rng& random) : folded_(shape.folded), scale_(1 / static_cast<double>(shape.count)) {
    for (int i = 0; i < shape.count; ++i) {
      const double inverse_length = 1 / random.uniform(shape.least_length, shape.greatest_length);
      const Vec3 direction = random_direction(random);
      waves_.push_back({inverse_length * direction, random.unit(), random.uniform(0.5, 1)});
    }
  }

  double operator()(const Vec3& at, double time) const noexcept {
    double sum = 0;
    for (const Wave& wave : waves_) {
      const double turns = dot(wave.number, at) + wave.phase + wave.frequency * time;
      sum += (1 - folded_) * sine(turns);
      if (folded_ > 0) sum += folded_ * crease(turns);
    }
    return scale_ * sum;
  }

 private:
  struct Wave {
    Vec3 number;  ///< turns a unit of length
    double phase;
    double frequency;  ///< turns a unit of time
  };
  std::vector<Wave> waves_;
  double folded_;
  double scale_;
};

}  // namespace touchstone::generators
