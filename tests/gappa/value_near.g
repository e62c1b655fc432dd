# kConstantBound and kDegreeBound of real_root.cpp: Horner's rule in doubles for polynomials of degree n, at most
# kMostDegree, in units of the sum of the coefficients' absolute values.
# SPDX-License-Identifier: MIT
# constant kConstantBound src/core/numbers/roots/real_root.cpp
# constant kDegreeBound src/core/numbers/roots/real_root.cpp
# constant kLeast src/core/numbers/roots/real_root.cpp
# between kMostDegree src/core/numbers/roots/coefficients.hpp |constexpr int kMostDegree = |;|
# not with kConstantBound: 3.9 * 0x1p-53
# not with kDegreeBound: 2.9 * 0x1p-53
# not with kLeast: 0x1p-1022
# not with kMostDegree: 1e14

e = 0x1p-53;
tiny = 0x1p-1073 / @kLeast@;
# One step, from a value v that is off by e E and a coefficient c that is off by e C, |v| + |c| <= 1. x is in [0, 1]. It
# adds 2 roundings of values of at most 1 and C.
next = (v * x * (1 + e * d_product) + tiny * h_product + c) * (1 + e * d_next);
true_next = (v - e * E) * x + (c - e * C);
carried = next - true_next - (e * (E * x) + e * C);
sum = v * x + c;
# All steps, for all coefficients: 4 e times their sum in all. Then the change up to the next double, at most e away:
# e n. The sum of absolute values is rounded n times, and the bound 3 times.
all = 4.0000001 * e + n * (2.0000001 * e + e);
bound = (@kConstantBound@ + @kDegreeBound@ * n) * (1 - 64 * e);
{
  |v| <= 1 /\ |c| <= 1 /\ x in [0, 1] /\ |sum| <= 1 /\ n in [1, 60] /\ every d_ <= 1 /\ every h_ <= 1
  -> |carried| - 2.0000001 * e <= 0 /\ all - bound <= 0 /\ @kMostDegree@ <= 60
}
carried -> e * (v * x * d_product) + e * (sum * d_next) + e * e * (v * x * d_product * d_next)
  + tiny * h_product * (1 + e * d_next);
all - bound -> (4.0000001 * e - @kConstantBound@ * (1 - 64 * e)) + n * (3.0000001 * e - @kDegreeBound@ * (1 - 64 * e));
