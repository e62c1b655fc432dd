# kValueBound of step_cubic.hpp and kRestrictionBound of bernstein_cubic.cpp: the value of the cubic, and its
# coefficients over a part. The coefficients c are off by what ends_bound.g and middle_bound.g prove without their
# reserve.
# SPDX-License-Identifier: MIT
# constant kUnit src/core/filters/coplanarity_form.hpp
# constant kValueBound src/core/filters/step_cubic.hpp
# constant kRestrictionBound src/core/filters/bernstein_cubic.cpp
# constant kMargin src/core/filters/step_cubic.hpp
# constant kLeastMagnitude src/core/filters/root_sides.hpp
# not with kValueBound: 59 * kUnit
# not with kRestrictionBound: 68 * kUnit
# not with kMargin: 0x1p-6
# not with kLeastMagnitude: 0x1p-350

e = @kUnit@;
tiny = 0x1p-1074 / (@kLeastMagnitude@ * @kLeastMagnitude@ * @kLeastMagnitude@);

# In units of P. Weights are products of s and t with s + t = 1, whose absolute values sum to at most span^n. A "mix" is
# such a sum of numbers of at most 1, divided by span^n: at most 1.
span = 1 + 2 * @kMargin@;
size = (1 - e) * (1 - e) * (1 - e);

# The value. Each monomial passes through 5 roundings; (1 + e d)^5 is 1 + 5.001 e k with |k| <= 1.
rounds = (1 + e * d_1) * (1 + e * d_2) * (1 + e * d_3) * (1 + e * d_4) * (1 + e * d_5) - 1;
f = 5.001 * e;
round_1 = d_1 + d_2 + e * (d_1 * d_2);
round_3 = d_3 + d_4 + e * (d_3 * d_4);
round_4 = round_1 + round_3 + e * (round_1 * round_3);
s3 = s * s * s;
s2t = s * s * t;
st2 = s * t * t;
t3 = t * t * t;
# b are the true coefficients, c the computed ones.
c_0 = b_0 + e * (34.001 * o_0);
c_1 = b_1 + e * (122.001 * o_1);
c_2 = b_2 + e * (122.001 * o_2);
c_3 = b_3 + e * (34.001 * o_3);
value = c_0 * s3 * (1 + f * k_0) + c_1 * s2t * (1 + f * k_1) + c_2 * st2 * (1 + f * k_2) + c_3 * t3 * (1 + f * k_3)
      + tiny * (64 * h_value);
V = b_0 * s3 + b_1 * s2t + b_2 * st2 + b_3 * t3;
mix_k = ((c_0 / 4.001) * k_0 * s3 + 3 * (c_1 / 12.003) * k_1 * s2t + 3 * (c_2 / 12.003) * k_2 * st2
      + (c_3 / 4.001) * k_3 * t3) / (span * span * span);
# At most 34.001 (|s|^3 + |t|^3) + 122.001 (s^2 |t| + |s| t^2), which cubic_weights.g bounds.
weighted = 34.001 * o_0 * s3 + 122.001 * o_1 * s2t + 122.001 * o_2 * st2 + 34.001 * o_3 * t3;

# A part: an interpolation g = s a + t b, of computed numbers that are off by e E. The first operands are b0 and
# 3 b1 / 3, which is rounded.
g = ((s * a * (1 + e * d_a) + tiny * h_a) + (t * b * (1 + e * d_b) + tiny * h_b)) * (1 + e * d_g);
true_g = s * (a - e * (80 * o_a)) + t * (b - e * (80 * o_b));
mix_ab = (s * (a / 4.001) + t * (b / 4.001)) / span;
mix_d = (s * (a / 4.001) * d_a + t * (b / 4.001) * d_b) / span;
mix_o = (s * o_a + t * o_b) / span;
tiny_g = (tiny * h_a + tiny * h_b) * (1 + e * d_g);
E_0 = 122.001 / 3 + 4.001;
E_1 = E_0 * span + 8.01;
E_2 = E_1 * span + 8.01;
E_3 = E_2 * span + 8.01;
{
  every k_ <= 1 /\ every o_ <= 1 /\ every d_ <= 1 /\ every h_ <= 1 /\ every mix_ <= 1 /\
  |weighted| <= 39.05
  -> |rounds| - f <= 0 /\
     |value - V| - @kValueBound@ * size <= 0 /\
     # The operands' errors, and 8.01 e more.
     |g - true_g - e * (80 * mix_o * span)| - 8.01 * e <= 0 /\
     E_3 * e - @kRestrictionBound@ * size <= 0
}
rounds -> e * (round_4 + d_5 + e * (round_4 * d_5));
value - V -> e * weighted + f * (4.001 * mix_k * (span * span * span)) + tiny * (64 * h_value);
g - true_g - e * (80 * mix_o * span) -> e * (4.001 * mix_d * span) + e * (4.001 * (mix_ab
  + e * mix_d) * span * d_g) + tiny_g;
