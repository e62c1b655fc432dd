"""Queries about bodies that turn and corners on curves. SPDX-License-Identifier: MIT"""
from __future__ import annotations

import copy
import warnings
from dataclasses import dataclass
from typing import List, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import Answer, Answers, Distance, Distances
from ._proofs import Proofs
from ._queries import Kind, Method, Metric, Times, Wanted


@dataclass(frozen=True, eq=False)
class OnBody:
    """Elements that are parts of rigid bodies: one for all queries, or n of them.

    corners  each in the frame of its body: of shape (c, 3) or (n, c, 3), where c is 1 for points, 2 for edges and 3 for
             faces
    q0, q1   the orientations at t = 0 and t = 1: quaternions (w, x, y, z) of any length but 0, of shape (4,) or (n, 4).
             Without q1 the body does not turn
    p0, p1   where the body's origin is at t = 0 and t = 1, of shape (3,) or (n, 3). Without p1 it stays where it is

    Over the step the quaternion is (1 - t) q0 + t q1, and the position (1 - t) p0 + t p1. Both ends are met exactly.
    The body turns about one axis, at a pace that differs a little from that of slerp. With q0 . q1 >= 0 it takes the
    shorter turn, otherwise the longer one, of which CurvedQueries warns: q1 and -q1 are the same orientation, and
    recorded poses often have the other sign. q1 must not be q0 times a negative number.
    """

    corners: ArrayLike
    q0: ArrayLike = (1, 0, 0, 0)
    q1: Optional[ArrayLike] = None
    p0: ArrayLike = (0, 0, 0)
    p1: Optional[ArrayLike] = None

    def _parts(self):
        return (self.corners, self.q0, self.q0 if self.q1 is None else self.q1, self.p0,
                self.p0 if self.p1 is None else self.p1)


@dataclass(frozen=True, eq=False)
class OnCurves:
    """Elements whose corners are on Bezier curves: one for all queries, or n of them.

    control_points  of shape (c, m, 3) or (n, c, m, 3), where c is 1 for points, 2 for edges and 3 for faces, and m is 1
                    for corners at rest, 2 for straight motions, 3 for ballistic arcs and 4 for cubics
    """

    control_points: ArrayLike

    def _parts(self):
        return (self.control_points,)


def _again(kind, first, second, shorter_turn):
    """A pickle's queries, about whose turns the warning was given."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return CurvedQueries(kind, first, second, shorter_turn=shorter_turn)


class CurvedQueries:
    """Queries about elements of bodies that turn, and elements on curves.

    kind           as in `solve`
    first, second  the elements, in the kind's order: each an OnBody or OnCurves. Single elements and n of them may be
                   mixed; where both are single there is one query
    shorter_turn   True: where q0 . q1 < 0, a body takes the shorter of the two turns to the same orientation, by -q1.
                   False: it takes the longer one, and a UserWarning says so, once for all queries

    The methods solve, contact_times, distance, contact_normal and prove are the functions of these names. Raises
    TypeError for another element, and ValueError for shapes that do not fit.

    The tip of a rod turns by 90 degrees about z, and meets a point:

    >>> import touchstone
    >>> from touchstone import CurvedQueries, OnBody, OnCurves
    >>> CurvedQueries('point-point', OnBody([[1, 0, 0]], q1=[1, 0, 0, 1]), OnBody([[0, 1, 0]])).solve().toi
    1.0

    A stone is thrown over an edge:

    >>> stone = OnCurves([[[0, 0, 0], [1, 0, 1], [2, 0, 0]]])
    >>> edge = OnCurves([[[1, -1, .5]], [[1, 1, .5]]])
    >>> answer = CurvedQueries('point-edge', stone, edge).solve()
    >>> answer.toi, str(answer.nature)
    (0.5, 'isolated')
    """

    def __init__(self, kind: Kind, first: Union[OnBody, OnCurves], second: Union[OnBody, OnCurves], *,
                 shorter_turn: bool = False):
        for name, element in (("first", first), ("second", second)):
            if not isinstance(element, (OnBody, OnCurves)):
                found = type(element).__name__
                raise TypeError(f"{name} is of type {found}; it must be touchstone.OnBody or touchstone.OnCurves")
        if not isinstance(shorter_turn, (bool, np.bool_)):
            raise TypeError(f"shorter_turn is of type {type(shorter_turn).__name__}; it must be a bool")
        self._made_of = copy.deepcopy((kind, first, second, bool(shorter_turn)))  # the caller's arrays may change
        self._core = _core.curved_queries(kind, first._parts(), second._parts(), bool(shorter_turn))
        longer = self._core.longer_turns
        if longer and not shorter_turn:
            first_row = "" if self._core.single else f", the first in row {self._core.first_longer_turn}"
            warnings.warn(
                f"{longer} of {len(self)} queries {'has' if longer == 1 else 'have'} a body that takes the longer of "
                f"two turns{first_row}: q0 . q1 < 0. q1 and -q1 are the same orientation, and recorded poses often "
                "have the other sign; shorter_turn=True takes the shorter turn", stacklevel=2)

    @property
    def kind(self) -> str:
        """'edge-edge', 'vertex-face', 'point-edge' or 'point-point'."""
        return self._core.kind

    def __len__(self) -> int:
        return len(self._core)

    def __reduce__(self):
        return _again, self._made_of

    def __repr__(self):
        return f"<CurvedQueries: {len(self)} {self.kind}>"

    def solve(self, t_max: float = 1.0, separation: ArrayLike = 0.0, metric: Metric = "euclidean", threads: int = 1,
              method: Method = "fast", wanted: Wanted = "all") -> Union[Answers, Answer]:
        """The first contact of each query; arguments, result and errors are those of `touchstone.solve`."""
        return self._core.solve(t_max, separation, metric, threads, method, wanted)

    def contact_times(self, t_max: float = 1.0, separation: ArrayLike = 0.0, metric: Metric = "euclidean",
                      threads: int = 1) -> Union[Times, List[Times]]:
        """All times of contact, as `touchstone.contact_times`."""
        return self._core.contact_times(t_max, separation, metric, threads)

    def distance(self, t: float = 0.0, metric: Metric = "euclidean", threads: int = 1) -> Union[Distances, Distance]:
        """The distances of the elements at the time t, as `touchstone.distance`."""
        return self._core.distance(t, metric, threads)

    def contact_normal(self, t_max: float = 1.0, separation: ArrayLike = 0.0, threads: int = 1) -> NDArray:
        """The unit normals at the first contacts, as `touchstone.contact_normal`."""
        return self._core.contact_normal(t_max, separation, threads)

    def prove(self, separation: float = 0.0, metric: Metric = "euclidean", threads: int = 1) -> Proofs:
        """The answers with their proofs, as `touchstone.prove`."""
        return Proofs(_core.prove_curved(self._core, separation, metric, threads))
