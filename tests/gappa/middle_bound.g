# kMiddleBound: the error of 3 b1 = (u0 x w1 + u1 x w0) . r0 + (u0 x w0) . r1, and of 3 b2 likewise, as
# coplanarity_form.hpp computes them. Names: ends 0 and 1 of the step are written a and b, so ua = u0.
# SPDX-License-Identifier: MIT
# constant kUnit src/core/filters/coplanarity_form.hpp
# constant kLeastProduct src/core/filters/coplanarity_form.hpp
# constant kGreatestProduct src/core/filters/coplanarity_form.hpp
# constant kMiddleBound src/core/filters/coplanarity_form.hpp
# not with kMiddleBound: 122 * kUnit
# not with kLeastProduct: 0x1p-1024
# not with kGreatestProduct: 0x1p1022

# Each det_ is a hypothesis by the lemma that ends_bound.g states and proves on paper.

e = @kUnit@;
tiny = 0x1p-1075 * (1 + 0x1p-50) / @kLeastProduct@;
# As computed, in units of U W and U W R: the cross products A = ua x wb, B = ub x wa, C = ua x wa.
xyz: A_i = ((ua_j * wb_k * (1 + e * d_pA_i) + tiny * h_pA_i) - (ua_k * wb_j * (1 + e * d_qA_i)
  + tiny * h_qA_i)) * (1 + e * d_A_i);
xyz: B_i = ((ub_j * wa_k * (1 + e * d_pB_i) + tiny * h_pB_i) - (ub_k * wa_j * (1 + e * d_qB_i)
  + tiny * h_qB_i)) * (1 + e * d_B_i);
xyz: C_i = ((ua_j * wa_k * (1 + e * d_pC_i) + tiny * h_pC_i) - (ua_k * wa_j * (1 + e * d_qC_i)
  + tiny * h_qC_i)) * (1 + e * d_C_i);
xyz: n_i = (A_i + B_i) * (1 + e * d_n_i);
xyz: m_i = n_i * ra_i * (1 + e * d_m_i) + tiny * h_m_i;
xyz: l_i = C_i * rb_i * (1 + e * d_l_i) + tiny * h_l_i;
first = ((m_x + m_y) * (1 + e * d_sm) + m_z) * (1 + e * d_first);
second = ((l_x + l_y) * (1 + e * d_sl) + l_z) * (1 + e * d_second);
b = (first + second) * (1 + e * d_b);
bound = @kMiddleBound@ * (1 + e * d_uw) * (1 + e * d_uwr) * (1 + e * d_bound) + tiny * h_bound;
# The true value: the true differences are ua + e o_ua and so on.
xyz: TA_i = (ua_j + e * o_ua_j) * (wb_k + e * o_wb_k) - (ua_k + e * o_ua_k) * (wb_j + e * o_wb_j);
xyz: TB_i = (ub_j + e * o_ub_j) * (wa_k + e * o_wa_k) - (ub_k + e * o_ub_k) * (wa_j + e * o_wa_j);
xyz: TC_i = (ua_j + e * o_ua_j) * (wa_k + e * o_wa_k) - (ua_k + e * o_ua_k) * (wa_j + e * o_wa_j);
VA = TA_x * (ra_x + e * o_ra_x) + TA_y * (ra_y + e * o_ra_y) + TA_z * (ra_z + e * o_ra_z);
VB = TB_x * (ra_x + e * o_ra_x) + TB_y * (ra_y + e * o_ra_y) + TB_z * (ra_z + e * o_ra_z);
VC = TC_x * (rb_x + e * o_rb_x) + TC_y * (rb_y + e * o_rb_y) + TC_z * (rb_z + e * o_rb_z);

# The lemma bounds these: determinants of rows with entries of at most 1.
xyz: cA_i = ua_j * wb_k - ua_k * wb_j;
xyz: cB_i = ub_j * wa_k - ub_k * wa_j;
xyz: cC_i = ua_j * wa_k - ua_k * wa_j;
xyz: vA_i = ua_j * o_wb_k - ua_k * o_wb_j;
xyz: vB_i = ub_j * o_wa_k - ub_k * o_wa_j;
xyz: vC_i = ua_j * o_wa_k - ua_k * o_wa_j;
xyz: tA_i = o_ua_j * wb_k - o_ua_k * wb_j;
xyz: tB_i = o_ub_j * wa_k - o_ub_k * wa_j;
xyz: tC_i = o_ua_j * wa_k - o_ua_k * wa_j;
det_A = cA_x * ra_x + cA_y * ra_y + cA_z * ra_z;
det_B = cB_x * ra_x + cB_y * ra_y + cB_z * ra_z;
det_C = cC_x * rb_x + cC_y * rb_y + cC_z * rb_z;
det_Ao = cA_x * o_ra_x + cA_y * o_ra_y + cA_z * o_ra_z;
det_Bo = cB_x * o_ra_x + cB_y * o_ra_y + cB_z * o_ra_z;
det_Co = cC_x * o_rb_x + cC_y * o_rb_y + cC_z * o_rb_z;
det_vA = vA_x * ra_x + vA_y * ra_y + vA_z * ra_z;
det_vB = vB_x * ra_x + vB_y * ra_y + vB_z * ra_z;
det_vC = vC_x * rb_x + vC_y * rb_y + vC_z * rb_z;
det_tA = tA_x * ra_x + tA_y * ra_y + tA_z * ra_z;
det_tB = tB_x * ra_x + tB_y * ra_y + tB_z * ra_z;
det_tC = tC_x * rb_x + tC_y * rb_y + tC_z * rb_z;
det_dA = cA_x * (d_A_x * ra_x) + cA_y * (d_A_y * ra_y) + cA_z * (d_A_z * ra_z);
det_dB = cB_x * (d_B_x * ra_x) + cB_y * (d_B_y * ra_y) + cB_z * (d_B_z * ra_z);
det_dC = cC_x * (d_C_x * rb_x) + cC_y * (d_C_y * rb_y) + cC_z * (d_C_z * rb_z);
det_nA = cA_x * (d_n_x * ra_x) + cA_y * (d_n_y * ra_y) + cA_z * (d_n_z * ra_z);
det_nB = cB_x * (d_n_x * ra_x) + cB_y * (d_n_y * ra_y) + cB_z * (d_n_z * ra_z);
det_mA = cA_x * (d_m_x * ra_x) + cA_y * (d_m_y * ra_y) + cA_z * (d_m_z * ra_z);
det_mB = cB_x * (d_m_x * ra_x) + cB_y * (d_m_y * ra_y) + cB_z * (d_m_z * ra_z);
det_l = cC_x * (d_l_x * rb_x) + cC_y * (d_l_y * rb_y) + cC_z * (d_l_z * rb_z);

# The rest: roundings of the products in the cross products, and terms of second order.
xyz: gA_i = e * (ua_j * wb_k * d_pA_i - ua_k * wb_j * d_qA_i) + tiny * (h_pA_i - h_qA_i);
xyz: gB_i = e * (ub_j * wa_k * d_pB_i - ub_k * wa_j * d_qB_i) + tiny * (h_pB_i - h_qB_i);
xyz: gC_i = e * (ua_j * wa_k * d_pC_i - ua_k * wa_j * d_qC_i) + tiny * (h_pC_i - h_qC_i);
xyz: more_i = cA_i * (d_A_i * d_n_i + d_A_i * d_m_i + d_n_i * d_m_i + e * (d_A_i * d_n_i * d_m_i))
  + cB_i * (d_B_i * d_n_i + d_B_i * d_m_i + d_n_i * d_m_i + e * (d_B_i * d_n_i * d_m_i));
xyz: zm_i = (gA_i * (1 + e * d_A_i) + gB_i * (1 + e * d_B_i)) * (1 + e * d_n_i) * (1 + e * d_m_i) * ra_i
  + e * e * (more_i * ra_i) + tiny * h_m_i;
xyz: zl_i = gC_i * (1 + e * d_C_i) * (1 + e * d_l_i) * rb_i + e * e * (cC_i * rb_i * d_C_i * d_l_i) + tiny * h_l_i;
xyz: yA_i = e * e * ((o_ua_j * o_wb_k - o_ua_k * o_wb_j) * (ra_i + e * o_ra_i) + (tA_i + vA_i) * o_ra_i);
xyz: yB_i = e * e * ((o_ub_j * o_wa_k - o_ub_k * o_wa_j) * (ra_i + e * o_ra_i) + (tB_i + vB_i) * o_ra_i);
xyz: yC_i = e * e * ((o_ua_j * o_wa_k - o_ua_k * o_wa_j) * (rb_i + e * o_rb_i) + (tC_i + vC_i) * o_rb_i);
m_sum = m_x + m_y + m_z;
l_sum = l_x + l_y + l_z;
m_off = e * (det_dA + det_dB) + e * (det_nA + det_nB) + e * (det_mA + det_mB) + (zm_x + zm_y + zm_z);
l_off = e * det_dC + e * det_l + (zl_x + zl_y + zl_z);
A_moved = e * (det_tA + det_vA + det_Ao) + (yA_x + yA_y + yA_z);
B_moved = e * (det_tB + det_vB + det_Bo) + (yB_x + yB_y + yB_z);
C_moved = e * (det_tC + det_vC + det_Co) + (yC_x + yC_y + yC_z);
first_off = m_off + e * (m_sum * d_first) + e * ((m_x + m_y) * d_sm * (1 + e * d_first));
second_off = l_off + e * (l_sum * d_second) + e * ((l_x + l_y) * d_sl * (1 + e * d_second));
{
  xyz: |ua_i| <= 1 /\ |wa_i| <= 1 /\ |ra_i| <= 1 /\ |ub_i| <= 1 /\ |wb_i| <= 1 /\ |rb_i| <= 1 /\
  every d_ <= 1 /\ every h_ <= 1 /\ every o_ <= 1.0000000001 /\ every det_ <= 4.000000001
  -> |b - (VA + VB + VC)| - bound <= 0 /\ |b - (VA + VB + VC)| - 122.001 * e <= 0 /\
     # No partial result overflows.
     xyz: @kGreatestProduct@ * (|A_i| + |B_i| + |C_i| + |n_i| + |m_i| + |l_i|) <= 0x1p1023 /\
     @kGreatestProduct@ * (|first| + |second| + |b| + |bound|) <= 0x1p1023
}
m_sum -> (det_A + det_B) + m_off;
l_sum -> det_C + l_off;
first -> (det_A + det_B) + first_off;
second -> det_C + second_off;
VA -> det_A + A_moved;
VB -> det_B + B_moved;
VC -> det_C + C_moved;
first + second -> (det_A + det_B) + det_C + first_off + second_off;
b - (VA + VB + VC) -> (first_off + second_off) - (A_moved + B_moved + C_moved) + e * ((first + second) * d_b);
