# kDirectionFactor, kLeastSquare and kLeastNormal of separating_direction.cpp: `least` is at least the gap's error and
# the distance times the norm of the direction. All are sums of products of numbers that are not negative. Such a sum
# is at least the exact one with the factor 1 - e for each rounding that a term passes through, less the underflows.
# SPDX-License-Identifier: MIT
# constant kUnit src/core/filters/coplanarity_form.hpp
# constant kDirectionFactor src/core/filters/apart/separating_direction.cpp
# constant kLeastSquare src/core/filters/apart/separating_direction.cpp
# constant kLeastNormal src/core/filters/apart/separating_direction.cpp
# not with kDirectionFactor: 1 + 4 * kUnit
# not with kLeastSquare: 0x1p-1022
# not with kLeastNormal: 0x1p-1074

e = @kUnit@;
# Of the square's terms: the product, 2 additions, and 3 underflows beside a computed square of at least kLeastSquare.
lost = 3 * 0x1p-1075 / (@kLeastSquare@ * (1 - 4 * e));
square = (1 - e) * (1 - e) * (1 - e) * (1 - lost);
# The root, the product with the distance, the sum with the error, the product with the factor, the sum with
# kLeastNormal.
norm = sqrt(square) * @kDirectionFactor@ * (1 - e) * (1 - e) * (1 - e) * (1 - e) * (1 - e);
# The other norm: 2 additions.
sum = @kDirectionFactor@ * (1 - e) * (1 - e) * (1 - e) * (1 - e) * (1 - e) * (1 - e);
# The gap's error: the sum, the factor, the last sum.
error = @kDirectionFactor@ * (1 - e) * (1 - e) * (1 - e);
# The products of the distance and of the factor may underflow.
reserve = @kLeastNormal@ * (1 - e) - 3 * 0x1p-1075;
{ z in [0, 1] -> norm >= 1 /\ sum >= 1 /\ error >= 1 /\ reserve >= 0 /\ lost - e <= 0 }
