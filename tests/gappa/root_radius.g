# The radius of a root in step_cubic.hpp: where the change of the slope and its error are at most kShare of the
# computed steepness, V changes by more than its bound within the radius, and the slope is at least half of the steepness.
# SPDX-License-Identifier: MIT
# constant kUnit src/core/filters/coplanarity_form.hpp
# between kRadius src/core/filters/step_cubic.hpp |const N radius = | * error / steepness;|
# between kShare src/core/filters/step_cubic.hpp |slope_error() <= | * steepness|
# not with kRadius: 1.9
# not with kShare: 0.501

e = @kUnit@;
# The sum and the product before the comparison, and the product with the share.
least_slope = 1 - @kShare@ * (1 + 4 * e);
# The error is a rounded sum; then a product and a quotient.
reach = least_slope * @kRadius@ * (1 - 4 * e);
{ z in [0, 1] -> least_slope >= 0.5 /\ reach >= 1 }
