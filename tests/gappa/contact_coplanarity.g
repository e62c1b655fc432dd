# kCoplanarityError of contact_values.hpp: V at a time in double-doubles. In units of P, coordinates being at most span.
# SPDX-License-Identifier: MIT
# constant kUnit src/core/filters/coplanarity_form.hpp
# constant kUnitSquared src/core/filters/contact_values.hpp
# constant kCoplanarityError src/core/filters/contact_values.hpp
# constant kMargin src/core/filters/step_cubic.hpp
# constant kLeastMagnitude src/core/filters/root_sides.hpp
# not with kCoplanarityError: 280 * kUnitSquared
# not with kMargin: 0x1p-10
# not with kLeastMagnitude: 0x1p-350

# The lemma is that of ends_bound.g.

# As in contact_components.g, a double-double is high + e low, and the high parts' sums and products are exact pairs.
e = @kUnit@;
tiny = 0x1p-1072 / (@kLeastMagnitude@ * @kLeastMagnitude@ * @kLeastMagnitude@ * e * e);
span = 1 + 2 * @kMargin@;

# The coordinates are off by 8.0001 e e (contact_components.g), each weighed by a determinant of at most 4.
coordinates = 3 * 4 * 8.0001;

# A component of n. A product of coordinates, without the operands' own errors:
product_low = (p * q * y_product + (p * q_low * (1 + e * d_pq) + p_low * q * (1 + e * d_qp)) * (1
  + e * d_cross)) * (1 + e * d_product) + tiny * h_product;
product = p * q + e * (product_low - p * q * y_product);
true_product = (p + e * p_low) * (q + e * q_low);
cross = p * q_low * (1 + e * d_pq) + p_low * q * (1 + e * d_qp);
product_off = (p * q_low * d_pq + p_low * q * d_qp) + cross * d_cross + (p * q * y_product + cross * (1
  + e * d_cross)) * d_product - p_low * q_low;
# The difference of two: its high part H is at most 2.0001 and the low part of that H y. The lemma bounds the sum over
# the components of H y d r by 4.0001, since H is a component of n up to 16 e. The rest of the error:
difference_low = (H * y_H + (l_1 - l_2) * (1 + e * d_1)) * (1 + e * d_2);
rest = difference_low - (H * y_H + l_1 - l_2) - e * (H * y_H * d_2);
components = 3 * (2 * 8.0001 + 12.001) + 4.0001;

# The product of a component, normalised to n (1 + e y_n), and of r + e r_low: relative to n. The lemma bounds the sum
# of the |n| by 4.0001.
low = (r * y_r + (r_low * (1 + e * d_3) + y_n * r * (1 + e * d_4)) * (1 + e * d_5)) * (1 + e * d_6) + tiny * h_low;
relative = r + e * (low - r * y_r);
true_relative = (1 + e * y_n) * (r + e * r_low);
mixed = r_low * (1 + e * d_3) + y_n * r * (1 + e * d_4);
relative_off = r_low * d_3 + y_n * r * d_4 + mixed * d_5 + (r * y_r + mixed * (1 + e * d_5)) * d_6 - y_n * r_low;
products = 4.0001 * 8.0001;

# The two sums. High parts of at most 4.0001; low parts of the products of at most 3.0001 |n|, in all 12.0001 s_xy for
# two, and with the first sum's low part 16.002 s_xyz for all.
first_low = (4.0001 * y_1 + 12.001 * s_xy * (1 + e * d_7)) * (1 + e * d_8);
first_off = first_low - (4.0001 * y_1 + 12.001 * s_xy);
second_low = (4.0001 * y_2 + 16.002 * s_xyz * (1 + e * d_9)) * (1 + e * d_10);
second_off = second_low - (4.0001 * y_2 + 16.002 * s_xyz);
sums = 28.004 + 36.006;

all = (coordinates + components + products + sums) * (e * e) * (span * span * span);
{
  every d_ <= 1 /\ every h_ <= 1 /\ every y_ <= 1 /\ every s_ <= 1 /\ |p| <= 1 /\ |q| <= 1 /\ |p_low| <= 1
    /\ |q_low| <= 1 /\
  |r| <= 1 /\ |r_low| <= 1 /\ |H| <= 2.0001 /\ |l_1| <= 3.0001 /\ |l_2| <= 3.0001
  -> |product_low| <= 3.0001 /\
     |product - true_product| - 8.0001 * (e * e) <= 0 /\
     |rest| - 12.001 * e <= 0 /\
     |low| <= 3.0001 /\
     |relative - true_relative| - 8.0001 * (e * e) <= 0 /\
     |first_off| - 28.004 * e <= 0 /\
     |second_off| - 36.006 * e <= 0 /\
     all - @kCoplanarityError@ * (1 - 4 * e) <= 0 /\
     e * e - @kUnitSquared@ <= 0
}
product - true_product -> e * e * product_off + e * (tiny * h_product);
rest -> e * ((l_1 - l_2) * d_1 + (l_1 - l_2) * (1 + e * d_1) * d_2);
relative - true_relative -> e * e * relative_off + e * (tiny * h_low);
first_off -> e * (12.001 * s_xy * d_7 + (4.0001 * y_1 + 12.001 * s_xy * (1 + e * d_7)) * d_8);
second_off -> e * (16.002 * s_xyz * d_9 + (4.0001 * y_2 + 16.002 * s_xyz * (1 + e * d_9)) * d_10);
