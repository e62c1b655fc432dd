# kNormFactor and kNormBound of coplanarity_form.hpp: a test for clearance compares V with more than the distance times
# the norm of n. In units of U W and U W R.
# SPDX-License-Identifier: MIT
# constant kUnit src/core/filters/coplanarity_form.hpp
# constant kLeastNormProduct src/core/filters/coplanarity_form.hpp
# constant kGreatestNormProduct src/core/filters/coplanarity_form.hpp
# constant kGreatestProduct src/core/filters/coplanarity_form.hpp
# constant kGreatestVolume src/core/filters/coplanarity_form.hpp
# constant kLeastVolume src/core/filters/coplanarity_form.hpp
# constant kEndsBound src/core/filters/coplanarity_form.hpp
# constant kMiddleBound src/core/filters/coplanarity_form.hpp
# constant kNormFactor src/core/filters/coplanarity_form.hpp
# constant kNormBound src/core/filters/coplanarity_form.hpp
# not with kNormFactor: 1 + 4 * kUnit
# not with kNormBound: 29 * kUnit
# not with kLeastNormProduct: 0x1p-470
# not with kGreatestNormProduct: 0x1p512
# not with kLeastVolume: 0x1p-1022
# not with kEndsBound: 34 * kUnit
# not with kMiddleBound: 122 * kUnit

e = @kUnit@;
tiny = 0x1p-1075 * (1 + 0x1p-50) / @kLeastNormProduct@;
tiny_v = 0x1p-1075 * (1 + 0x1p-50) / @kLeastVolume@;

# Components of n0 (or n2) and of 2 n1, which is halved exactly. The true differences are u + e o_u and so on.
n = ((u1 * w2 * (1 + e * d_1) + tiny * h_1) - (u2 * w1 * (1 + e * d_2) + tiny * h_2)) * (1 + e * d_n);
true_n = (u1 + e * o_u1) * (w2 + e * o_w2) - (u2 + e * o_u2) * (w1 + e * o_w1);
m = ((v1 * x2 * (1 + e * d_3) + tiny * h_3) - (v2 * x1 * (1 + e * d_4) + tiny * h_4)) * (1 + e * d_m);
true_m = (v1 + e * o_v1) * (x2 + e * o_x2) - (v2 + e * o_v2) * (x1 + e * o_x1);
n_m = (n + m) * (1 + e * d_nm);
n_error = u1 * w2 * d_1 - u2 * w1 * d_2 - u1 * o_w2 - o_u1 * w2 + u2 * o_w1 + o_u2 * w1;
n_rest = tiny * (h_1 - h_2) - e * e * (o_u1 * o_w2 - o_u2 * o_w1);
n_raw = (u1 * w2 * (1 + e * d_1) + tiny * h_1) - (u2 * w1 * (1 + e * d_2) + tiny * h_2);
m_error = v1 * x2 * d_3 - v2 * x1 * d_4 - v1 * o_x2 - o_v1 * x2 + v2 * o_x1 + o_v2 * x1;
m_rest = tiny * (h_3 - h_4) - e * e * (o_v1 * o_x2 - o_v2 * o_x1);
m_raw = (v1 * x2 * (1 + e * d_3) + tiny * h_3) - (v2 * x1 * (1 + e * d_4) + tiny * h_4);

# So the sum of the true absolute coordinates exceeds that of the computed ones by 30.03 e at most, and the Euclidean
# norm by 3^(1/2) 10.01 e. All that follows are sums of products of numbers that are not negative. Such a sum is at
# least the exact one with the factor 1 - e for each rounding that a term passes through, less the underflows.
#   Largest axis: a coordinate passes through 2 additions; then the product with kNormFactor and the sum with
#   kNormBound.
#   Euclidean: a square passes through its product and 2 additions, and the root halves these in the exponent; the
#   root
#   itself; then as above. The root of the sum of 4 underflows of 2^-1075 is lost at most.
#   kNormBound: the product U W, the product with it, the sum.
sum_factor = @kNormFactor@ * (1 - e) * (1 - e) * (1 - e) * (1 - e);
root_factor = @kNormFactor@ * sqrt((1 - e) * (1 - e) * (1 - e)) * (1 - e) * (1 - e) * (1 - e);
norm_reserve = @kNormBound@ * (1 - e) * (1 - e) * (1 - e);
root_lost = sqrt(0x1p-1073) * 2 / @kLeastNormProduct@;
#   The product with the distance, that with 3 (or none), that with kNormFactor, and the sum with the bound on V's
#   error:
#   sum_factor again.
#   That bound: U W and U W R, the product with the constant, the sum; and all that underflows meanwhile.
ends = @kEndsBound@ * (1 - e) * (1 - e) * (1 - e) * (1 - e) - 8 * tiny_v;
middle = @kMiddleBound@ * (1 - e) * (1 - e) * (1 - e) * (1 - e) - 8 * tiny_v;
{
  |u1| <= 1 /\ |u2| <= 1 /\ |w1| <= 1 /\ |w2| <= 1 /\ |v1| <= 1 /\ |v2| <= 1 /\ |x1| <= 1 /\ |x2| <= 1 /\
  every d_ <= 1 /\ every h_ <= 1 /\ every o_ <= 1.0000000001
  -> |n - true_n| - 8.01 * e <= 0 /\
     |n_m - (true_n + true_m)| - 2 * (10.01 * e) <= 0 /\
     sum_factor >= 1 /\ root_factor >= 1 /\
     norm_reserve - 30.03 * e >= 0 /\
     norm_reserve - (sqrt(3) * 10.01 * e + root_lost) >= 0 /\
     root_lost - e * 0x1p-20 <= 0 /\
     ends - 34.001 * e >= 0 /\ middle - 122.001 * e >= 0 /\
     # Nothing overflows: squares of coordinates of at most 4.001 U W, three of them, and V.
     @kGreatestNormProduct@ * @kGreatestNormProduct@ * 64 <= 0x1p1023 /\ @kGreatestVolume@ * 20 <= 0x1p1023
}
n - true_n -> e * n_error + n_rest + e * (n_raw * d_n);
m - true_m -> e * m_error + m_rest + e * (m_raw * d_m);
n_m - (true_n + true_m) -> (n - true_n) + (m - true_m) + e * ((n + m) * d_nm);
