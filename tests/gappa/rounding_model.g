# The model of rounding that the other scripts use, for doubles with subnormal numbers, below overflow:
#   a product, a quotient or a root z is rounded to z (1 + e d) + 2^-1075 h, with |d|, |h| <= 1 and e = 2^-53, and one
#   of
#   d and h is 0;
#   a sum or a difference of doubles is rounded to z (1 + e d): where it is subnormal it is exact. The last claim is
#   that a rounded difference D and the true one differ by at most e (1 + 2 e) |D|.
# SPDX-License-Identifier: MIT
# constant kUnit src/core/filters/coplanarity_form.hpp
# not with kUnit: 0x1p-54

@rnd = float<ieee_64, ne>;
x = rnd(x_);
y = rnd(y_);
{
  |z| in [0x1p-1021, 0x1p1023] /\ |v| <= 0x1p-1021 /\ @FIX(x + y, -1074) /\ |d| <= 1b-53
  -> rnd(z) -/ z in [-1b-53, 1b-53] /\
     |rnd(v) - v| <= 0x1p-1075 /\
     rnd(x + y) -/ (x + y) in [-1b-53, 1b-53] /\
     |d / (1 + d)| - 1b-53 * (1 + 2 * 1b-53) <= 0 /\
     1b-53 - @kUnit@ <= 0
}
