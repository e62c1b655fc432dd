# component_spread and kWeightError of refined_root_steps.hpp: a component of n, f1 or f2 at the root, from its value and
# slope at t and the root's offset; and a weight, which is promised to 2^-50.
# SPDX-License-Identifier: MIT
# constant kUnit src/core/filters/coplanarity_form.hpp
# constant kUnitSquared src/core/filters/contact_values.hpp
# constant kComponentError src/core/filters/contact_values.hpp
# constant kMargin src/core/filters/step_cubic.hpp
# constant kWeightError src/core/filters/refined_root_steps.hpp
# between kFactor src/core/filters/refined_root_steps.hpp |return (|) * (kComponentError * (1|
# between kWeight src/core/filters/refined_root_steps.hpp |(1 + (1 / kUnit) * away) + | * (reach * reach|
# not with kComponentError: 79 * kUnitSquared
# not with kWeightError: 3.1 * kUnit
# not with kMargin: 0x1p-4
# not with kFactor: 1
# not with kWeight: 7.9

e = @kUnit@;
span = 1 + 2 * @kMargin@;
# The slope of a component: four products of a coordinate's slope, at most 2 and off by 4 e, and a coordinate, at most
# span and off by e. In units of the product of the bounds.
product = slope * at * (1 + e * d_product);
true_product = (slope + e * (4 * o_slope)) * (at + e * o_at);
product_off = slope * at * d_product - slope * o_at - 4 * (o_slope * at) - e * (4 * (o_slope * o_at));
cross = (P_1 - P_2) * (1 + e * d_cross);
both = (C_1 + C_2) * (1 + e * d_both);
# A difference of slopes over M, at most 8.001; there are two at most.
first = (8.001 * s_1) * (1 + e * d_first);
slope_error = 4 * 8.001 + 2 * 4.001 + 8.001 + 8.002 + 8.002;
# Then the product of slope and offset, and the rounding of the value, which the result's own rounding does not cover.
per_offset = slope_error + 8.001 + 8.001;
# Beside the value's error, kComponentError, the code adds kComponentError / e times the offset.
rounding = per_offset * e * (1 + 16 * e) - @kComponentError@ / e;
# The offset's error weighs a slope of 8 span, the second derivative of 16 half the squared reach.
weigh = 8 * span * (1 + 16 * e) - @kWeight@ * @kFactor@;
# A weight is off by (A + N) / |n| and the roundings of both components, two each; of the quotient and of 1 minus it.
weight = @kWeightError@ * (1 + 8 * e) + 4.0001 * e + e / 2 + e / 2;
{
  |slope| <= 2.0001 /\ |at| <= 1.000003 /\ every d_ <= 1 /\ every o_ <= 1 /\ every s_ <= 1 /\
  |P_1| <= 2.0002 /\ |P_2| <= 2.0002 /\ |C_1| <= 4.0004 /\ |C_2| <= 4.0004
  -> |product| <= 2.0002 /\ |product - true_product| - 8.001 * e <= 0 /\
     |cross - (P_1 - P_2)| - 4.001 * e <= 0 /\
     |both - (C_1 + C_2)| - 8.001 * e <= 0 /\
     |first - 8.001 * s_1| - 8.002 * e <= 0 /\
     rounding <= 0 /\ weigh <= 0 /\ weight - 0x1p-50 <= 0
}
product - true_product -> e * product_off;
cross - (P_1 - P_2) -> e * ((P_1 - P_2) * d_cross);
both - (C_1 + C_2) -> e * ((C_1 + C_2) * d_both);
first - 8.001 * s_1 -> e * (8.001 * s_1 * d_first);
