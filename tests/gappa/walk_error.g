# kWalkError and kTurnError of entry_walk.hpp: products of a direction and the differences r, u, w at a time in [0, 1].
# Claims about one vector are in units of N and of the vector's bound; claims about c = r - s u - q w in units of N S.
# constant kUnit src/filters/coplanarity_form.hpp
# constant kLeastShare src/filters/entry_step.hpp
# constant kLeastSize src/filters/entry_step.hpp
# constant kWalkError src/filters/entry_walk.hpp
# constant kTurnError src/filters/entry_walk.hpp
# constant kNormIncrease src/filters/entry_walk.hpp
# not with kWalkError: 29 * kUnit
# not with kTurnError: 32 * kUnit
# not with kNormIncrease: 1 + 6 * kUnit
# not with kLeastSize: 0x1p-480

e = @kUnit@;
# The direction's largest coordinate is at least kLeastShare S / 2 in the Euclidean metric; in the other, directions that
# are shorter than a difference of a query are scaled to 1, and nothing smaller than a difference counts.
tiny = 0x1p-1073 / (@kLeastShare@ * @kLeastSize@ * @kLeastSize@ / 2);
# A product of the direction n, whose own coordinates may be off by e, with a computed difference x.
xyz: m_i = n_i * x_i * (1 + e * d_m_i) + tiny * h_m_i;
p = ((m_x + m_y) * (1 + e * d_s) + m_z) * (1 + e * d_p);
xyz: t_i = (n_i + e * o_n_i) * (x_i + e * o_x_i);
true_p = t_x + t_y + t_z;
xyz: z_i = n_i * x_i * d_m_i - n_i * o_x_i - o_n_i * x_i - e * (o_n_i * o_x_i);
p_off = z_x + z_y + z_z + (m_x + m_y + m_z) * d_p + (m_x + m_y) * d_s * (1 + e * d_p);

# Between the ends: s g + t j with s = 1 - t rounded, from products of at most 3.001. The mixes are sums weighted by s and
# t in [0, 1], s + t = 1, of numbers of at most 1.
g_t = ((s * (1 + e * d_one) * (3.001 * g) * (1 + e * d_g) + tiny * h_g) + (t * (3.001 * j) * (1 + e * d_j) + tiny * h_j)) * (1 + e * d_t);
g_true = s * (3.001 * g) + t * (3.001 * j);
mix_g = s * (g * (d_one + d_g + e * (d_one * d_g)) / 2.0001) + t * (j * d_j);
mix_s = s * g + t * j;
g_rest = (tiny * h_g + tiny * h_j) * (1 + e * d_t);
twice = s * (g * (d_one + d_g + e * (d_one * d_g))) + t * (j * d_j);

# At a corner, r - (s u + q w): of values g_r, g_u, g_w in units of their vectors' R, U, W, which sum to 1.
value = (v_r - (v_u + v_w) * (1 + e * d_uw)) * (1 + e * d_value);
value_off = v_r - v_u - v_w;
# S is a sum of two roundings; the bounds are products of it.
rounds = (1 - e) * (1 - e) * (1 - e) * (1 - e);

# A turn: the position b = s r0 + t r1 is off by 4.0001 e. A product of it with a direction; two of these are added.
xyz: b_i = n_i * (x_i + f * k_x_i);
f = 4.0001 * e;
position = ((s * (1 + e * d_one) * y0 * (1 + e * d_y0)) + (t * y1 * (1 + e * d_y1))) * (1 + e * d_y);
true_position = s * (y0 + e * o_y0) + t * (y1 + e * o_y1);
mix_y = s * (y0 * (d_one + d_y0 + e * (d_one * d_y0)) / 2.0001) + t * (y1 * d_y1);
mix_o = s * o_y0 + t * o_y1;
mix_ys = s * y0 + t * y1;
pair_rounds = 3.001 * e;

# The distance times a norm: 3 / 2 for the squares, the root, the sum of two norms, the product, the sum, the product.
norm = @kNormIncrease@ * sqrt((1 - e) * (1 - e) * (1 - e)) * (1 - e) * (1 - e) * (1 - e) * (1 - e) * (1 - e);
{ |y0| <= 1 -> |y0| <= 1 }
