# kEndsBound: the error of b0 = (u x w) . r, and of b3 likewise, as coplanarity_form.hpp computes them.
# SPDX-License-Identifier: MIT
# constant kUnit src/core/filters/coplanarity_form.hpp
# constant kLeastProduct src/core/filters/coplanarity_form.hpp
# constant kGreatestProduct src/core/filters/coplanarity_form.hpp
# constant kEndsBound src/core/filters/coplanarity_form.hpp
# not with kEndsBound: 34 * kUnit
# not with kLeastProduct: 0x1p-1024
# not with kGreatestProduct: 0x1p1022

# The lemma. A determinant of three rows (or columns) with entries of at most A, B and C is at most 4 A B C. Proof: it
# is linear in each entry, so it is greatest for entries of +-A, +-B, +-C; divided by A B C, all are +-1. Adding the
# first row to the others makes their entries even, so the determinant is a multiple of 4. By Hadamard's inequality it
# is at most the product of the rows' lengths, 3^(3/2) < 8. So it is at most 4. In particular the absolute coordinates
# of a x b sum to at most 4 A B: let the third row have entries +-1 with the signs of these coordinates.
# Gappa cannot find this: interval arithmetic gives 6. So each det_ below is a hypothesis, a determinant of rows with
# entries of at most 1. Without the lemma Gappa needs 44 in place of 35, and 160 in place of 123 for kMiddleBound.

e = @kUnit@;
tiny = 0x1p-1075 * (1 + 0x1p-50) / @kLeastProduct@;
# As computed, in units of U W and U W R; u, w, r are the computed differences.
xyz: p_i = u_j * w_k * (1 + e * d_p_i) + tiny * h_p_i;
xyz: q_i = u_k * w_j * (1 + e * d_q_i) + tiny * h_q_i;
xyz: n_i = (p_i - q_i) * (1 + e * d_n_i);
xyz: m_i = n_i * r_i * (1 + e * d_m_i) + tiny * h_m_i;
sum = (m_x + m_y) * (1 + e * d_s);
b = (sum + m_z) * (1 + e * d_b);
uwr = (1 + e * d_uw) * (1 + e * d_uwr);
bound = @kEndsBound@ * uwr * (1 + e * d_bound) + tiny * h_bound;
# The true value: the true differences are u + e o_u and so on.
xyz: true_i = (u_j + e * o_u_j) * (w_k + e * o_w_k) - (u_k + e * o_u_k) * (w_j + e * o_w_j);
V = true_x * (r_x + e * o_r_x) + true_y * (r_y + e * o_r_y) + true_z * (r_z + e * o_r_z);

# The lemma bounds these: determinants of rows with entries of at most 1.
xyz: c_i = u_j * w_k - u_k * w_j;
det_uwr = c_x * r_x + c_y * r_y + c_z * r_z;
det_uwo = c_x * o_r_x + c_y * o_r_y + c_z * o_r_z;
xyz: ow_i = u_j * o_w_k - u_k * o_w_j;
det_uow = ow_x * r_x + ow_y * r_y + ow_z * r_z;
xyz: ou_i = o_u_j * w_k - o_u_k * w_j;
det_ouw = ou_x * r_x + ou_y * r_y + ou_z * r_z;
det_n = c_x * (d_n_x * r_x) + c_y * (d_n_y * r_y) + c_z * (d_n_z * r_z);
det_m = c_x * (d_m_x * r_x) + c_y * (d_m_y * r_y) + c_z * (d_m_z * r_z);

# The rest: roundings of the products in n, and terms of second order.
xyz: g_i = e * (u_j * w_k * d_p_i - u_k * w_j * d_q_i) + tiny * (h_p_i - h_q_i);
xyz: z_i = g_i * (1 + e * d_n_i) * (1 + e * d_m_i) * r_i + e * e * (c_i * r_i * d_n_i * d_m_i) + tiny * h_m_i;
xyz: oo_i = o_u_j * o_w_k - o_u_k * o_w_j;
xyz: y_i = e * e * (oo_i * (r_i + e * o_r_i) + (ou_i + ow_i) * o_r_i);
m_sum = m_x + m_y + m_z;
rounded = e * det_n + e * det_m + z_x + z_y + z_z;
moved = e * det_ouw + e * det_uow + e * det_uwo + y_x + y_y + y_z;
{
  xyz: |u_i| <= 1 /\ |w_i| <= 1 /\ |r_i| <= 1 /\
  every d_ <= 1 /\ every h_ <= 1 /\ every o_ <= 1.0000000001 /\ every det_ <= 4.000000001
  -> |b - V| - bound <= 0 /\ |b - V| - 34.001 * e <= 0 /\
     # No partial result overflows.
     xyz: @kGreatestProduct@ * (|p_i| + |q_i| + |n_i| + |m_i|) <= 0x1p1023 /\
     @kGreatestProduct@ * (|sum| + |b| + |bound|) <= 0x1p1023
}
m_sum -> det_uwr + rounded;
V -> det_uwr + moved;
b - V -> (rounded - moved) + e * (m_sum * d_b) + e * ((m_x + m_y) * d_s * (1 + e * d_b));
