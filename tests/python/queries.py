"""Seeded queries for the tests. SPDX-License-Identifier: MIT"""
import numpy as np

KINDS = {"edge-edge": 4, "vertex-face": 4, "point-edge": 3, "point-point": 2}


def random(kind, n, seed=1):
    """Corners at random positions, log-uniform in scale from query to query."""
    rng = np.random.default_rng(seed)
    scale = 10.0 ** rng.uniform(-6, 6, (n, 1, 1))
    shape = (n, KINDS[kind], 3)
    return rng.standard_normal(shape) * scale, rng.standard_normal(shape) * scale


def lattice(kind, n, seed=1):
    """Corners on a small lattice: most of these queries are degenerate in some way, and many touch."""
    rng = np.random.default_rng(seed)
    shape = (n, KINDS[kind], 3)
    return rng.integers(-1, 2, shape).astype(float), rng.integers(-1, 2, shape).astype(float)


def both(kind, n, seed=1):
    parts = zip(random(kind, n // 2, seed), lattice(kind, n - n // 2, seed))
    return tuple(np.concatenate(part) for part in parts)


COLUMNS = ("contact", "toi", "toi_upper", "nature", "feature_a", "feature_b", "level", "trend", "starts_within",
           "weights_a", "weights_b")


def same(a, b):
    """Whether two Answers are the same, bit for bit, but for weights without contact, which have no meaning."""
    return all(np.array_equal(getattr(a, name), getattr(b, name)) for name in COLUMNS)
