"""The names in answers, as integers that know their names. SPDX-License-Identifier: MIT"""
from enum import IntEnum

import numpy as np


class _Named(IntEnum):
    def __str__(self):
        return self.name

    @classmethod
    def names(cls, codes):
        """The names of an array of codes, as an array of strings of the same shape.

        >>> Nature.names([1, 0]).tolist()
        ['crossing', 'none']
        """
        return np.array([member.name for member in cls])[np.asarray(codes)]


class Nature(_Named):
    """How the elements meet at the first contact. V is the coplanarity cubic of edge-edge and vertex-face queries.

    none: no contact. crossing: V changes its sign at the time. grazing: V does not. sustained: the contact goes on for
    a while. isolated: a single instant, and V is zero at all times or there is none. entering: with a separation, the
    distance falls below it at the time.
    """

    none = 0
    crossing = 1
    grazing = 2
    sustained = 3
    isolated = 4
    entering = 5


class Trend(_Named):
    """What the distance does just after the time. Only answers with a separation above 0 have one."""

    none = 0
    approaching = 1
    constant = 2
    leaving = 3


class Feature(_Named):
    """The part of an element that is touched: a corner, an edge's interior, a face's interior, or an overlap."""

    none = 0
    a0 = 1
    a1 = 2
    a = 3
    b0 = 4
    b1 = 5
    b = 6
    v = 7
    f0 = 8
    f1 = 9
    f2 = 10
    f01 = 11
    f12 = 12
    f20 = 13
    f = 14
    p = 15
    e0 = 16
    e1 = 17
    e = 18
    q = 19
    overlap = 20


class Level(_Named):
    """The level of the solver that decided: a filter, the bracket level, exact arithmetic, or the oracle."""

    filter = 0
    bracket = 1
    exact = 2
    oracle = 3
