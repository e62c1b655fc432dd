# kClosestError of precise_closest.hpp: sums and products of double-doubles near an entry. As in contact_components.g, a
# double-double is high + e low; high parts' sums and products are exact pairs.
# SPDX-License-Identifier: MIT
# constant kUnit src/core/filters/coplanarity_form.hpp
# between kEuclidean src/core/filters/separation/precise_closest.hpp |constexpr double kClosestError = |;|
# constant kLeastFraction src/core/filters/separation/entry_step.hpp
# constant kLeastSize src/core/filters/separation/entry_step.hpp
# not with kEuclidean: 700 * 0x1p-106
# not with kLeastSize: 0x1p-480

e = @kUnit@;
# The smallest product is one of |c| and S.
tiny = 0x1p-1071 / (@kLeastFraction@ * @kLeastSize@ * @kLeastSize@ * e * e);

# A difference u at t in [0, 1]: from + t (to - from), in units of its bound U. Differences of corners are exact.
change_low = (2 * y_1 + (to_low - from_low) * (1 + e * d_1)) * (1 + e * d_2);
change_off = change_low - (2 * y_1 + to_low - from_low);
part_low = (2 * y_2 + t * (4.001 * l_change) * (1 + e * d_3)) * (1 + e * d_4) + tiny * h_part;
part_off = part_low - (2 * y_2 + t * (4.001 * l_change));
at_low = (3.001 * y_3 + (from_low + 6.002 * l_part) * (1 + e * d_5)) * (1 + e * d_6);
at_off = at_low - (3.001 * y_3 + from_low + 6.002 * l_part);
at = 6.001 + 10.004 + 17.012;

# One of the differences v - factor d in c, for vectors of at most 1.001 S; the factor is in [0, 1].
taken_low = (y_4 + x * (1.002 * l_d) * (1 + e * d_7)) * (1 + e * d_8) + tiny * h_taken;
taken_off = taken_low - (y_4 + x * (1.002 * l_d));
minus_low = (2.01 * y_5 + (1.002 * l_v - 2.003 * l_taken) * (1 + e * d_9)) * (1 + e * d_10);
minus_off = minus_low - (2.01 * y_5 + 1.002 * l_v - 2.003 * l_taken);
# r, u and w at t are off by `at` times R, U, W, which sum to S. There are four differences: two of them are
# corrections.
c = at * 1.001 + 4 * (3.01 + 8.03);

# A product of two coordinates of at most 1: without the operands' errors (see contact_components.g).
product = 8.0001;
# A dot product: two sums of high parts of at most 2.01 and 3.02, low parts of at most 3.0001 each.
first_low = (2.01 * y_6 + 6.001 * l_first * (1 + e * d_11)) * (1 + e * d_12);
first_off = first_low - (2.01 * y_6 + 6.001 * l_first);
second_low = (3.02 * y_7 + 11.02 * l_second * (1 + e * d_13)) * (1 + e * d_14);
second_off = second_low - (3.02 * y_7 + 11.02 * l_second);
dot = 3 * product + 14.02 + 25.07;
# c . u, in units of C U, and c . c - d d, in units of C S: the difference's high part is the excess, for which the code
# has a term of its own; the low parts are at most 14.05 and one of d d, which is about |c|^2, at most 3.02.
cu = dot + 3 * at * 1.001;
cc = dot + 2 * 3 * c * 1.001 + 18;
euclidean = (cc + cu) * (e * e);
{
  every d_ <= 1 /\ every h_ <= 1 /\ every y_ <= 1 /\ every l_ <= 1 /\ |to_low| <= 1 /\ |from_low| <= 1
    /\ t in [0, 1] /\ x in [0, 1]
  -> |change_low| <= 4.001 /\ |change_off| - 6.001 * e <= 0 /\
     |part_low| <= 6.002 /\ |part_off| - 10.004 * e <= 0 /\
     |at_off| - 17.012 * e <= 0 /\
     |taken_low| <= 2.003 /\ |taken_off| - 3.01 * e <= 0 /\
     |minus_off| - 8.03 * e <= 0 /\
     |first_off| - 14.02 * e <= 0 /\ |second_off| - 25.07 * e <= 0 /\
     # What the comments there say.
     at <= 40 /\ c <= 80 /\ cu <= 300 /\
     euclidean - @kEuclidean@ * (1 - 8 * e) <= 0
}
change_off -> e * ((to_low - from_low) * d_1 + (2 * y_1 + (to_low - from_low) * (1 + e * d_1)) * d_2);
part_off -> e * (t * (4.001 * l_change) * d_3 + (2 * y_2 + t * (4.001 * l_change) * (1 + e * d_3)) * d_4)
  + tiny * h_part;
at_off -> e * ((from_low + 6.002 * l_part) * d_5 + (3.001 * y_3 + (from_low + 6.002 * l_part) * (1 + e * d_5)) * d_6);
taken_off -> e * (x * (1.002 * l_d) * d_7 + (y_4 + x * (1.002 * l_d) * (1 + e * d_7)) * d_8) + tiny * h_taken;
minus_off -> e * ((1.002 * l_v - 2.003 * l_taken) * d_9 + (2.01 * y_5 + (1.002 * l_v - 2.003 * l_taken) * (1
  + e * d_9)) * d_10);
first_off -> e * (6.001 * l_first * d_11 + (2.01 * y_6 + 6.001 * l_first * (1 + e * d_11)) * d_12);
second_off -> e * (11.02 * l_second * d_13 + (3.02 * y_7 + 11.02 * l_second * (1 + e * d_13)) * d_14);
