# kWalkError and kTurnError of entry_walk.hpp: products of a direction and the differences r, u, w at a time in [0, 1].
# Claims about one vector are in units of N and of the vector's bound; claims about c = r - s u - q w in units of N S.
# SPDX-License-Identifier: MIT
# constant kUnit src/core/filters/coplanarity_form.hpp
# constant kLeastFraction src/core/filters/separation/entry_step.hpp
# constant kLeastSize src/core/filters/separation/entry_step.hpp
# constant kWalkError src/core/filters/separation/entry_walk.hpp
# constant kTurnError src/core/filters/separation/entry_walk.hpp
# constant kNormIncrease src/core/filters/separation/entry_walk.hpp
# not with kWalkError: 29 * kUnit
# not with kTurnError: 32 * kUnit
# not with kNormIncrease: 1 + 6 * kUnit
# not with kLeastSize: 0x1p-480

e = @kUnit@;
# The direction's largest coordinate is at least kLeastFraction S / 2 in the Euclidean metric; in the other, directions
# that are shorter than a difference of a query are scaled to 1, and nothing smaller than a difference counts.
tiny = 0x1p-1073 / (@kLeastFraction@ * @kLeastSize@ * @kLeastSize@ / 2);
# A product of the direction n, whose own coordinates may be off by e, with a computed difference x; and, for a turn,
# with a position at a time, which is off by f.
f = 4.002 * e;
xyz: m_i = n_i * x_i * (1 + e * d_m_i) + tiny * h_m_i;
p = ((m_x + m_y) * (1 + e * d_s) + m_z) * (1 + e * d_p);
true_p = (n_x + e * o_n_x) * (x_x + e * o_x_x) + (n_y + e * o_n_y) * (x_y + e * o_x_y) + (n_z + e * o_n_z) * (x_z
  + e * o_x_z);
turn_p = (n_x + e * o_n_x) * (x_x + f * o_x_x) + (n_y + e * o_n_y) * (x_y + f * o_x_y) + (n_z + e * o_n_z) * (x_z
  + f * o_x_z);
xyz: z_i = e * (n_i * x_i * d_m_i) - e * (n_i * o_x_i) - e * (o_n_i * x_i) - e * e * (o_n_i * o_x_i) + tiny * h_m_i;
xyz: y_i = e * (n_i * x_i * d_m_i) - f * (n_i * o_x_i) - e * (o_n_i * x_i) - e * f * (o_n_i * o_x_i) + tiny * h_m_i;
p_off = e * ((m_x + m_y + m_z) * d_p) + e * ((m_x + m_y) * d_s * (1 + e * d_p));

# Between the ends: s a + t b of numbers of at most 1, with s = 1 - t rounded. The mixes are sums weighted by s and t in
# [0, 1], s + t = 1, of numbers of at most 1.
between = ((s * (1 + e * d_one) * a * (1 + e * d_a) + tiny * h_a) + (t * b * (1 + e * d_b) + tiny * h_b)) * (1
  + e * d_between);
true_moved = s * (a + e * o_a) + t * (b + e * o_b);
two = d_one + d_a + e * (d_one * d_a);
mix_rounds = s * (a * two / 2.0001) + t * (b * d_b / 2.0001);
mix_ab = s * a + t * b;
mix_o = s * o_a + t * o_b;
between_rest = (tiny * h_a + tiny * h_b) * (1 + e * d_between);

# At a corner, v_r - (v_u + v_w), of values of at most 3.001 times R, U, W, which sum to 1: so is each sum of them.
value = (v_r - v_uw * (1 + e * d_uw)) * (1 + e * d_value);

# All roundings of a product along the walk: its own, between the ends, at the corner. S is a sum of two roundings.
walk = 15.01 * e + 3.001 * (3.001 * e) + 6.01 * e;
# And of one of a turn: its own, the sum of two such products, at the corner.
turn = 24.02 * e + 3.01 * e + 6.01 * e;
rounds = (1 - e) * (1 - e) * (1 - e) * (1 - e) * (1 - e);
# The distance times a norm: a square and two sums of squares, halved in the exponent by the root; the root, the sum of
# two norms, the product with the distance, the sum with the error, the product with the factor.
norm = @kNormIncrease@ * sqrt((1 - e) * (1 - e) * (1 - e)) * (1 - e) * (1 - e) * (1 - e) * (1 - e) * (1 - e);
{
  xyz: |n_i| <= 1 /\ |x_i| <= 1 /\
  |a| <= 1 /\ |b| <= 1 /\ |v_r| <= 3.001 /\ |v_uw| <= 3.001 /\ |v_r - v_uw| <= 3.001 /\
  every d_ <= 1 /\ every h_ <= 1 /\ every o_ <= 1.0000000001 /\ every mix_ <= 1.0000000001
  -> |p| <= 3.001 /\
     |p - true_p| - 15.01 * e <= 0 /\
     |p - turn_p| - 24.02 * e <= 0 /\
     |between - mix_ab| - 3.001 * e <= 0 /\
     |between - true_moved| - f <= 0 /\
     |value - (v_r - v_uw)| - 6.01 * e <= 0 /\
     walk - @kWalkError@ * rounds <= 0 /\
     turn - @kTurnError@ * rounds <= 0 /\
     norm >= 1 /\
     # No square underflows.
     0x1p-1000 - @kLeastFraction@ * @kLeastSize@ * @kLeastFraction@ * @kLeastSize@ / 4 <= 0
}
p - true_p -> (z_x + z_y + z_z) + p_off;
p - turn_p -> (y_x + y_y + y_z) + p_off;
between - mix_ab -> e * (2.0001 * mix_rounds) + e * ((mix_ab + e * (2.0001 * mix_rounds)) * d_between) + between_rest;
between - true_moved -> (between - mix_ab) - e * mix_o;
value - (v_r - v_uw) -> e * ((v_r - v_uw) * d_value) - e * (v_uw * d_uw * (1 + e * d_value));
