# kBound of shared_corner.cpp: the error of a component of the cross product of two computed differences. In units of
# U W.
# SPDX-License-Identifier: MIT
# constant kBound src/core/filters/apart/shared_corner.cpp
# between kLeast src/core/filters/apart/shared_corner.cpp |return uw >= | && largest|
# not with kBound: 8 * 0x1p-53
# not with kLeast: 0x1p-1022

e = 0x1p-53;
tiny = 0x1p-1075 * (1 + 0x1p-50) / @kLeast@;
n = ((u1 * w2 * (1 + e * d_1) + tiny * h_1) - (u2 * w1 * (1 + e * d_2) + tiny * h_2)) * (1 + e * d_n);
n_raw = (u1 * w2 * (1 + e * d_1) + tiny * h_1) - (u2 * w1 * (1 + e * d_2) + tiny * h_2);
true_n = (u1 + e * o_u1) * (w2 + e * o_w2) - (u2 + e * o_u2) * (w1 + e * o_w1);
n_error = u1 * w2 * d_1 - u2 * w1 * d_2 - u1 * o_w2 - o_u1 * w2 + u2 * o_w1 + o_u2 * w1;
n_rest = tiny * (h_1 - h_2) - e * e * (o_u1 * o_w2 - o_u2 * o_w1);
bound = @kBound@ * (1 + e * d_uw) * (1 + e * d_bound) + tiny * h_bound;
{
  |u1| <= 1 /\ |u2| <= 1 /\ |w1| <= 1 /\ |w2| <= 1 /\
  every d_ <= 1 /\ every h_ <= 1 /\ every o_ <= 1.0000000001
  -> |n - true_n| - bound <= 0
}
n - true_n -> e * n_error + n_rest + e * (n_raw * d_n);
