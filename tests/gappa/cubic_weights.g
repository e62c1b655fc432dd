# A sum of the coefficients' errors weighted by s^3, s^2 t, s t^2, t^3, for t in [-kMargin, 1 + kMargin]:
# bernstein_cubic.g takes its bound as a hypothesis.
# SPDX-License-Identifier: MIT
# constant kMargin src/core/filters/step_cubic.hpp
# not with kMargin: 0x1p-4

t = (1 + 2 * @kMargin@) * x - @kMargin@;
s = 1 - t;
weights = 34.001 * (|s * s * s| + |t * t * t|) + 122.001 * (|s * s * t| + |s * t * t|);
{ x in [0, 1] -> weights <= 39.05 }
$ x in 3000;
