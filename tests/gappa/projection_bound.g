# kProjectionBound: the error of a projection d . (x - origin) as separating_direction.cpp computes it, and three times
# the bound for the difference of two projections.
# SPDX-License-Identifier: MIT
# constant kUnit src/core/filters/coplanarity_form.hpp
# constant kLeastProduct src/core/filters/coplanarity_form.hpp
# constant kProjectionBound src/core/filters/apart/separating_direction.cpp
# between kBounds src/core/filters/apart/separating_direction.cpp |return {std::max(above, below), | * bound};|
# not with kProjectionBound: 9.9 * kUnit
# not with kBounds: 1.9
# not with kLeastProduct: 0x1p-1022

e = @kUnit@;
tiny = 0x1p-1075 * (1 + 0x1p-50) / @kLeastProduct@;
# In units of D M; n is the direction, x and y are the computed differences of two corners.
xyz: m_i = n_i * x_i * (1 + e * d_m_i) + tiny * h_m_i;
xyz: l_i = n_i * y_i * (1 + e * d_l_i) + tiny * h_l_i;
p = ((m_x + m_y) * (1 + e * d_s) + m_z) * (1 + e * d_p);
q = ((l_x + l_y) * (1 + e * d_t) + l_z) * (1 + e * d_q);
bound = @kProjectionBound@ * (1 + e * d_product) * (1 + e * d_bound) + tiny * h_bound;
gap = (p - q) * (1 + e * d_gap);
error = @kBounds@ * bound * (1 + e * d_error) + tiny * h_error;
true_p = n_x * (x_x + e * o_x_x) + n_y * (x_y + e * o_x_y) + n_z * (x_z + e * o_x_z);
true_q = n_x * (y_x + e * o_y_x) + n_y * (y_y + e * o_y_y) + n_z * (y_z + e * o_y_z);

m_sum = m_x + m_y + m_z;
l_sum = l_x + l_y + l_z;
off_p = m_sum * d_p + (m_x + m_y) * d_s * (1 + e * d_p);
off_q = l_sum * d_q + (l_x + l_y) * d_t * (1 + e * d_q);
xyz: r_i = n_i * (x_i * d_m_i - o_x_i);
xyz: s_i = n_i * (y_i * d_l_i - o_y_i);
{
  xyz: |n_i| <= 1 /\ |x_i| <= 1 /\ |y_i| <= 1 /\
  every d_ <= 1 /\ every h_ <= 1 /\ every o_ <= 1.0000000001
  -> |p - true_p| - bound <= 0 /\ |q - true_q| - bound <= 0 /\ |gap - (true_p - true_q)| - error <= 0
}
p - true_p -> e * (r_x + r_y + r_z + off_p) + tiny * (h_m_x + h_m_y + h_m_z);
q - true_q -> e * (s_x + s_y + s_z + off_q) + tiny * (h_l_x + h_l_y + h_l_z);
gap - (true_p - true_q) -> (p - true_p) - (q - true_q) + e * ((p - q) * d_gap);
