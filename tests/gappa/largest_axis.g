# kError of max_entry.cpp: a product in doubles of a facet's direction and a position, in units of N S.
# SPDX-License-Identifier: MIT
# constant kUnit src/core/filters/coplanarity_form.hpp
# constant kError src/core/filters/separation/max_entry.cpp
# not with kError: 80 * kUnit

e = @kUnit@;
# Three products of coordinates off by 16 e N and 8 e S, and two sums.
xyz: m_i = n_i * x_i * (1 + e * d_m_i);
p = ((m_x + m_y) * (1 + e * d_s) + m_z) * (1 + e * d_p);
true_p = (n_x + e * (16 * o_n_x)) * (x_x + e * (8 * o_x_x)) + (n_y + e * (16 * o_n_y)) * (x_y + e * (8 * o_x_y))
  + (n_z + e * (16 * o_n_z)) * (x_z + e * (8 * o_x_z));
xyz: z_i = n_i * x_i * d_m_i - 8 * (n_i * o_x_i) - 16 * (o_n_i * x_i) - e * (128 * (o_n_i * o_x_i));
p_off = (m_x + m_y + m_z) * d_p + (m_x + m_y) * d_s * (1 + e * d_p);
{
  xyz: |n_i| <= 1 /\ |x_i| <= 1 /\
  every d_ <= 1 /\ every o_ <= 1
  -> |p - true_p| - @kError@ * (1 - 8 * e) <= 0
}
p - true_p -> e * (z_x + z_y + z_z) + e * p_off;
