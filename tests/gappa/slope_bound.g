# kSlopeBound of step_cubic.hpp: the slope of the cubic, with the share of the curvature's error.
# SPDX-License-Identifier: MIT
# constant kUnit src/core/filters/coplanarity_form.hpp
# constant kSlopeBound src/core/filters/step_cubic.hpp
# constant kMargin src/core/filters/step_cubic.hpp
# constant kGreatestRadius src/core/filters/step_cubic.hpp
# between kCurvature src/core/filters/step_cubic.hpp |curvature_ = (|) * larger(|
# constant kLeastMagnitude src/core/filters/root_sides.hpp
# not with kSlopeBound: 365 * kUnit
# not with kMargin: 0x1p-7
# not with kGreatestRadius: 0x1p-6
# not with kCurvature: 2
# not with kLeastMagnitude: 0x1p-350

e = @kUnit@;
tiny = 0x1p-1074 / (@kLeastMagnitude@ * @kLeastMagnitude@ * @kLeastMagnitude@);
span = 1 + 2 * @kMargin@;
size = (1 - e) * (1 - e) * (1 - e);

# In units of P. The Bernstein coefficients of the derivative, from computed coefficients of at most 4.001 and 12.003.
D_0 = (c_1 - 3 * c_0 * (1 + e * d_0)) * (1 + e * d_1);
true_D_0 = (c_1 - e * (122.001 * o_1)) - 3 * (c_0 - e * (34.001 * o_0));
D_1 = (c_2 - c_1) * (1 + e * d_2);
true_D_1 = (c_2 - e * (122.001 * o_2)) - (c_1 - e * (122.001 * o_1));

# The slope g_0 s^2 + 2 g_1 s t + g_2 t^2 of computed coefficients g, which are off by 268.01 e. Each monomial passes
# through at most 4 roundings.
rounds = (1 + e * d_0) * (1 + e * d_1) * (1 + e * d_2) * (1 + e * d_3) - 1;
f = 4.001 * e;
round_0 = d_0 + d_1 + e * (d_0 * d_1);
round_2 = d_2 + d_3 + e * (d_2 * d_3);
slope = g_0 * (s * s) * (1 + f * k_0) + 2 * g_1 * (s * t) * (1 + f * k_1) + g_2 * (t * t) * (1 + f * k_2)
      + tiny * (64 * h_slope);
true_slope = (g_0 - 268.01 * e * o_0) * (s * s) + 2 * (g_1 - 268.01 * e * o_1) * (s * t)
           + (g_2 - 268.01 * e * o_2) * (t * t);
# Sums weighted by s^2, 2 s t, t^2 of numbers of at most 1, divided by span^2: at most 1.
mix_o = (o_0 * (s * s) + 2 * o_1 * (s * t) + o_2 * (t * t)) / (span * span);
mix_k = ((g_0 / 24.01) * k_0 * (s * s) + 2 * (g_1 / 24.01) * k_1 * (s * t)
  + (g_2 / 24.01) * k_2 * (t * t)) / (span * span);

# The curvature: the difference of two coefficients, and twice that.
bend = (g_1 - g_0) * (1 + e * d_bend);
true_bend = (g_1 - 268.01 * e * o_1) - (g_0 - 268.01 * e * o_0);
{
  |c_0| <= 4.001 /\ |c_1| <= 12.003 /\ |c_2| <= 12.003 /\ |g_0| <= 24.01 /\ |g_1| <= 24.01 /\
  every d_ <= 1 /\ every o_ <= 1 /\ every h_ <= 1 /\ every mix_ <= 1
  -> |D_0 - true_D_0| - 268.01 * e <= 0 /\
     |D_1 - true_D_1| - 268.01 * e <= 0 /\
     |rounds| - f <= 0 /\
     |slope - true_slope| - 364.2 * e <= 0 /\
     |bend - true_bend| - 584.1 * e <= 0 /\
     # The curvature's factor has room for the times outside of [0, 1], and for its roundings.
     2 * span * (1 + 8 * e) - @kCurvature@ <= 0 /\
     364.2 * e + @kGreatestRadius@ * (2 * span * 584.1 * e) - @kSlopeBound@ * size * (1 - 4 * e) <= 0
}
rounds -> e * (round_0 + round_2 + e * (round_0 * round_2));
D_0 - true_D_0 -> e * (122.001 * o_1 - 3 * (34.001 * o_0) - 3 * (c_0 * d_0) + (c_1 - 3 * c_0 * (1 + e * d_0)) * d_1);
D_1 - true_D_1 -> e * (122.001 * o_2 - 122.001 * o_1 + (c_2 - c_1) * d_2);
slope - true_slope -> 268.01 * e * (mix_o * (span * span)) + f * (24.01 * (mix_k * (span * span)))
  + tiny * (64 * h_slope);
bend - true_bend -> e * (268.01 * o_1 - 268.01 * o_0 + (g_1 - g_0) * d_bend);
