# kTimesError of box_tree.cpp: two times a = -f0 / (f1 - f0) and 1 - b, b = g1 / (g1 - g0), of rounded differences f
# and g of different signs, and their comparison. Where a <= 1 - b, the computed times compare so, too.
# SPDX-License-Identifier: MIT
# constant kTimesError src/core/broad_phase/box_tree.cpp
# not with kTimesError: 9 * 0x1p-53

e = 0x1p-53;
# The computed f0 and f1 have a relative error of e each. Their signs differ, so that of the difference is between
# theirs, beside its own rounding; then the quotient's rounding, and an underflow.
most = (1 + e) * (1 + e) / ((1 - e) * (1 - e)) - 1 - 4.01 * e;
least = 1 - (1 - e) * (1 - e) / ((1 + e) * (1 + e)) - 4.01 * e;
from = a * (1 + e * (4.01 * k_a)) + 0x1p-1075 * h_a;
quotient = b * (1 + e * (4.01 * k_b)) + 0x1p-1075 * h_b;
to = (1 - quotient) * (1 + e * d_to);
right = (to + @kTimesError@) * (1 + e * d_right);
from_error = e * (4.01 * (a * k_a)) + 0x1p-1075 * h_a;
quotient_error = e * (4.01 * (b * k_b)) + 0x1p-1075 * h_b;
excess = from_error + quotient_error - e * ((1 - quotient) * d_to) - @kTimesError@ - e * ((to
  + @kTimesError@) * d_right);
{
  a in [0, 1] /\ b in [0, 1] /\ a + b - 1 <= 0 /\ every d_ <= 1 /\ every h_ <= 1 /\ every k_ <= 1
  -> most <= 0 /\ least <= 0 /\ excess <= 0 /\ (from - right) - ((a + b - 1) + excess) in [0, 0]
}
(from - right) - ((a + b - 1) + excess) -> 0;
