# The bound on side conditions in root_sides.hpp: components of n, f1, f2 at a time t, and their change over a time h.
# In units of the vectors' bounds.
# SPDX-License-Identifier: MIT
# constant kUnit src/core/filters/coplanarity_form.hpp
# constant kMargin src/core/filters/step_cubic.hpp
# constant kLeastMagnitude src/core/filters/root_sides.hpp
# between kRounding src/core/filters/root_sides.hpp |const N spread = | + (|
# between kReach src/core/filters/root_sides.hpp |* kUnit + (|) * h;|
# not with kRounding: 15.9 * kUnit
# not with kReach: 8
# not with kMargin: 0x1p-5
# not with kLeastMagnitude: 0x1p-600

e = @kUnit@;
tiny = 0x1p-1074 / (@kLeastMagnitude@ * @kLeastMagnitude@);
span = 1 + 2 * @kMargin@;
# A coordinate at t, of a computed difference a and b at the ends. The mixes are sums weighted by s and t of numbers of
# at most 1, divided by span.
x = ((s * a * (1 + e * d_a) + tiny * h_a) + (t * b * (1 + e * d_b) + tiny * h_b)) * (1 + e * d_x);
true_x = s * (a + e * o_a) + t * (b + e * o_b);
mix_ab = (s * a + t * b) / span;
mix_d = (s * (a * d_a) + t * (b * d_b)) / span;
mix_o = (s * o_a + t * o_b) / span;
x_rest = (tiny * h_a + tiny * h_b) * (1 + e * d_x);
# A component of a cross product of such coordinates u and w, each off by 3.01 e.
n = ((u1 * w2 * (1 + e * d_1) + tiny * h_1) - (u2 * w1 * (1 + e * d_2) + tiny * h_2)) * (1 + e * d_n);
n_raw = (u1 * w2 * (1 + e * d_1) + tiny * h_1) - (u2 * w1 * (1 + e * d_2) + tiny * h_2);
f = 3.0001 * e;
true_n = (u1 + f * k_u1) * (w2 + f * k_w2) - (u2 + f * k_u2) * (w1 + f * k_w1);
n_error = u1 * w2 * d_1 - u2 * w1 * d_2 + n_raw * d_n;
n_moved = u1 * k_w2 + k_u1 * w2 - u2 * k_w1 - k_u2 * w1;
n_rest = tiny * (h_1 - h_2) - f * f * (k_u1 * k_w2 - k_u2 * k_w1);
# Of the sum, of its products, and of the bound, without the time.
rounds = (1 - e) * (1 - e) * (1 - e) * (1 - e);
# The rate of a component: two monomials, each of a rate of at most 2 and a coordinate of at most span, twice.
rate = 2 * (2 * span + span * 2);
{
  every d_ <= 1 /\ every h_ <= 1 /\ every o_ <= 1.0000000001 /\ every k_ <= 1 /\ every mix_ <= 1.0000000001 /\
  |u1| <= 1.00001 /\ |u2| <= 1.00001 /\ |w1| <= 1.00001 /\ |w2| <= 1.00001
  -> span <= 1.000005 /\
     |x - true_x| - f <= 0 /\
     |n - true_n| - @kRounding@ * rounds <= 0 /\
     rate - @kReach@ * rounds <= 0
}
x - true_x -> e * (mix_d * span - mix_o * span) + e * ((mix_ab * span + e * (mix_d * span)) * d_x) + x_rest;
n - true_n -> e * n_error - f * n_moved + n_rest;
