# kComponentError of contact_values.hpp: components of n, f1 and f2 at a time, and their differences, in double-doubles.
# SPDX-License-Identifier: MIT
# constant kUnit src/core/filters/coplanarity_form.hpp
# constant kUnitSquared src/core/filters/contact_values.hpp
# constant kComponentError src/core/filters/contact_values.hpp
# constant kMargin src/core/filters/step_cubic.hpp
# constant kLeastMagnitude src/core/filters/root_sides.hpp
# not with kUnitSquared: 0x1p-107
# not with kComponentError: 101.9 * kUnitSquared
# not with kMargin: 0x1p-6
# not with kLeastMagnitude: 0x1p-480

# Sums, differences and products of two doubles are exact pairs whose low part is at most e times the high part (Dekker,
# Knuth). So a double-double is high + e low here, and the low parts' roundings are what counts. Differences of corners
# are exact: high + e low with |low| <= 1, in units of the vector's bound.
e = @kUnit@;
# Two products of low parts underflow, and a product's low part may.
tiny = 0x1p-1072 / (@kLeastMagnitude@ * @kLeastMagnitude@ * e * e);
span = 1 + 2 * @kMargin@;

# s times a pair: the product's low part s a_high y_a; s times the low part; the sum of these. The mixes are sums
# weighted by s and t, s + t = 1, of numbers of at most 1, divided by span.
low_s = s * (a * y_a + a_low * (1 + e * d_s)) * (1 + e * d_sum_s);
low_t = t * (b * y_b + b_low * (1 + e * d_t)) * (1 + e * d_sum_t);
# The sum of both products: that of the high parts, of at most span, is exact, with a low part of at most 1.00001.
low = (y_high + (low_s + low_t) * (1 + e * d_lows)) * (1 + e * d_low) + tiny * h_low;
true_low = y_high + s * (a * y_a + a_low) + t * (b * y_b + b_low);
part_s = a_low * d_s * (1 + e * d_sum_s) + (a * y_a + a_low) * d_sum_s;
part_t = b_low * d_t * (1 + e * d_sum_t) + (b * y_b + b_low) * d_sum_t;
mix_part = (s * (part_s / 3.000001) + t * (part_t / 3.000001)) / span;
lows_s = a * y_a + a_low;
lows_t = b * y_b + b_low;
mix_lows = (s * (lows_s / 2) + t * (lows_t / 2)) / span;
lows = 2 * (mix_lows * span) + e * (3.000001 * (mix_part * span));
low_off = 3.000001 * (mix_part * span) + lows * d_lows + (y_high + lows * (1 + e * d_lows)) * d_low;

# A product of two such coordinates, normalised: (p + e p_low) (q + e q_low), each off by 8.0001 e e.
product_low = (p * q * y_product + (p * q_low * (1 + e * d_pq) + p_low * q * (1 + e * d_qp)) * (1
  + e * d_cross)) * (1 + e * d_product) + tiny * h_product;
true_product = (p + e * p_low + e * e * (8.0001 * o_p)) * (q + e * q_low + e * e * (8.0001 * o_q));
# The high parts' product is exact, a high part and the low part e p q y_product.
product = p * q + e * (product_low - p * q * y_product);
cross = p * q_low * (1 + e * d_pq) + p_low * q * (1 + e * d_qp);
product_off = (p * q_low * d_pq + p_low * q * d_qp) + cross * d_cross + (p * q * y_product + cross * (1
  + e * d_cross)) * d_product
            - p_low * q_low - 8.0001 * (p * o_q + q * o_p) - e * (8.0001 * (p_low * o_q + q_low * o_p))
              - e * e * (8.0001 * o_p * (8.0001 * o_q));

# The difference of two products: high parts of at most 1.00001, low parts of at most 3.0001, each off by 24.001.
difference_low = (2.0001 * y_d + (l_1 - l_2) * (1 + e * d_d1)) * (1 + e * d_d2);
difference_off = difference_low - (2.0001 * y_d + l_1 - l_2);
# n - f1, over M = M1 + M2: low parts of at most 8.001 M1 and 8.001 M2; the high parts' difference, of at most 2.0001 M.
second_low = (2.0001 * y_e + l_3 * (1 + e * d_e1)) * (1 + e * d_e2);
second_off = second_low - (2.0001 * y_e + l_3);
third_low = (2.0001 * y_f + l_4 * (1 + e * d_f1)) * (1 + e * d_f2);
third_off = third_low - (2.0001 * y_f + l_4);
{
  |a| <= 1 /\ |b| <= 1 /\ |a_low| <= 1 /\ |b_low| <= 1 /\ every d_ <= 1 /\ every h_ <= 1 /\ every o_ <= 1 /\
  every mix_ <= 1 /\ |y_a| <= 1 /\ |y_b| <= 1 /\ |y_high| <= 1.000003 /\
  |p| <= 1.00001 /\ |q| <= 1.00001 /\ |p_low| <= 1.00001 /\ |q_low| <= 1.00001 /\ |y_product| <= 1 /\
  |y_d| <= 1 /\ |l_1| <= 3.0001 /\ |l_2| <= 3.0001 /\
  |y_e| <= 1 /\ |l_3| <= 8.001 /\ |y_f| <= 1 /\ |l_4| <= 10.002
  -> |low - true_low| - 8.0001 * e <= 0 /\
     |product_low| <= 3.0001 /\
     |product - true_product| - 24.001 * (e * e) <= 0 /\
     |difference_low| <= 8.001 /\ |difference_off| - 14.002 * e <= 0 /\
     |second_low| <= 10.002 /\ |second_off| - 18.003 * e <= 0 /\
     |third_low| <= 12.003 /\ |third_off| - 22.005 * e <= 0 /\
     (2 * 24.001 + 14.002 + 18.003 + 22.005) * (e * e) - @kComponentError@ * (1 - 4 * e) <= 0 /\
     e * e - @kUnitSquared@ <= 0 /\ span <= 1.00001
}
low - true_low -> e * low_off + tiny * h_low;
product - true_product -> e * e * product_off + e * (tiny * h_product);
difference_off -> e * ((l_1 - l_2) * d_d1 + (2.0001 * y_d + (l_1 - l_2) * (1 + e * d_d1)) * d_d2);
second_off -> e * (l_3 * d_e1 + (2.0001 * y_e + l_3 * (1 + e * d_e1)) * d_e2);
third_off -> e * (l_4 * d_f1 + (2.0001 * y_f + l_4 * (1 + e * d_f1)) * d_f2);
