"""Questions about two elements. SPDX-License-Identifier: MIT"""
from __future__ import annotations

from typing import List, Literal, Optional, Sequence, Tuple, Union, overload

from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import Answer, Answers, Distance, Distances, ExactTime
from ._hints import hinting

Kind = Literal["edge-edge", "vertex-face", "point-edge", "point-point"]
Metric = Literal["euclidean", "max"]
Method = Literal["fast", "exact", "oracle", "fast-cgal"]
Wanted = Literal["all", "features", "time", "contact"]
Times = List[Tuple[ExactTime, ExactTime]]
_Corners = Sequence[Sequence[float]]


@overload
def solve(kind: Kind, start: _Corners, end: _Corners, t_max: float = ..., separation: ArrayLike = ...,
          metric: Metric = ..., threads: int = ..., method: Method = ..., wanted: Wanted = ...) -> Answer: ...
@overload
def solve(kind: Kind, start: Sequence[_Corners], end: Sequence[_Corners], t_max: float = ...,
          separation: ArrayLike = ..., metric: Metric = ..., threads: int = ..., method: Method = ...,
          wanted: Wanted = ...) -> Answers: ...
@overload
def solve(kind: Kind, start: ArrayLike, end: ArrayLike, t_max: float = ..., separation: ArrayLike = ...,
          metric: Metric = ..., threads: int = ..., method: Method = ...,
          wanted: Wanted = ...) -> Union[Answers, Answer]: ...
@hinting
def solve(kind: Kind, start: ArrayLike, end: ArrayLike, t_max: float = 1.0, separation: ArrayLike = 0.0,
          metric: Metric = "euclidean", threads: int = 1, method: Method = "fast",
          wanted: Wanted = "all") -> Union[Answers, Answer]:
    """The first contact of the two elements of each query for t in [0, t_max], decided exactly.

    kind        'edge-edge', 'vertex-face', 'point-edge' or 'point-point'
    start, end  the corners at t = 0 and at t = 1: arrays of shape (n, corners, 3) or (n, corners, 2) with 4, 4, 3 or 2
                corners, or without n for a single query
    t_max       the end of the time range, 0 <= t_max <= 1
    separation  the elements are in contact while their distance is at most this: a number >= 0, or n of them
    metric      how a distance is measured: 'euclidean', or 'max' for the largest difference of a coordinate
    threads     1 (default) to 1024, or 0 for as many as the machine has; it changes no answer
    method      'fast'; 'exact', 'oracle' and 'fast-cgal' give the same answers by other code
    wanted      'all'; 'features' leaves out the weights of a contact, 'time' its nature, trend and features, too, and
                'contact' also its times: then they are NaN, and the rest is as without contact; less takes less time

    Returns Answers, whose attributes are arrays, or an Answer for a single query. Their attributes are contact, toi,
    toi_upper, nature, feature_a, feature_b, weights_a, weights_b, level, starts_within and trend. Arrays in which the
    index of the query runs fastest, such as numpy.asfortranarray(x), are read where they are; the rows of others are
    copied a few hundred at a time.

    Raises TypeError for an argument of another type, and ValueError for a value without meaning, naming the row.

    >>> import numpy as np, touchstone
    >>> start = np.zeros((3, 2, 3))
    >>> start[:, 1, 0] = [1, 2, 5]                   # q is 1, 2 and 5 to the right of p
    >>> end = start.copy()
    >>> end[:, 0, 0] = 4                             # p flies to x = 4
    >>> answers = touchstone.solve('point-point', start, end)
    >>> answers.contact.tolist(), answers.toi.tolist()
    ([True, True, False], [0.25, 0.5, inf])
    >>> touchstone.Nature.names(answers.nature).tolist()
    ['isolated', 'isolated', 'none']
    >>> touchstone.solve('point-point', start, end, separation=[.5, 1, 1]).toi.tolist()
    [0.125, 0.25, 1.0]
    >>> touchstone.solve('point-point', start, end, wanted='time').feature_a.tolist()
    [0, 0, 0]
    """
    return _core.solve(kind, start, end, t_max, separation, metric, threads, method, wanted)


@hinting
def contact_times(kind: Kind, start: ArrayLike, end: ArrayLike, t_max: float = 1.0, separation: ArrayLike = 0.0,
                  metric: Metric = "euclidean", threads: int = 1) -> Union[Times, List[Times]]:
    """All times in [0, t_max] at which the elements touch, exactly: disjoint closed intervals in ascending order.

    Arguments and errors are those of `solve`. Returns a list of pairs (first, last) of ExactTime for a single query,
    and a list of such lists for n queries. An interval that is a single instant has equal ends.

    >>> import touchstone
    >>> edge = [[0, 0, 0], [1, 0, 0]]
    >>> (first, last), = touchstone.contact_times('point-edge', [[-1, 0, 0]] + edge, [[2, 0, 0]] + edge)
    >>> str(first), str(last), first < last
    ('1/3', '2/3', True)
    """
    return _core.contact_times(kind, start, end, t_max, separation, metric, threads)


@hinting
def distance(kind: Kind, start: ArrayLike, end: Optional[ArrayLike] = None, t: float = 0.0, metric: Metric = "euclidean",
             threads: int = 1) -> Union[Distances, Distance]:
    """The distance of the elements at the time t, 0 <= t <= 1, by exact arithmetic.

    kind, start, end  as in `solve`; without end the elements are at rest

    Returns Distances, whose attributes value, feature_a, feature_b, weights_a and weights_b are arrays, or a Distance
    for a single query. `value` is the double that is nearest to the exact distance, in the unit of the coordinates.
    Raises what `solve` raises.

    >>> import touchstone
    >>> touchstone.distance('point-edge', [[0, 3, 0], [-1, 0, 0], [1, 0, 0]]).value
    3.0
    """
    return _core.distance(kind, start, start if end is None else end, t, metric, threads)


@hinting
def contact_normal(kind: Kind, start: ArrayLike, end: ArrayLike, t_max: float = 1.0, separation: ArrayLike = 0.0,
                   threads: int = 1) -> NDArray:
    """The unit normal at the first contact for t in [0, t_max], within 2^-49 of the true one.

    With a separation it points from the closest point of the first element to that of the second. Without one it is
    along the normal of the face, or that of both edges, and points from the first element to the second as they lie
    just before the time. Arguments and errors are those of `solve`; the metric is the Euclidean one.

    Returns an array of shape (n, 3), or (3,) for a single query; NaN without contact and where there is no normal.

    >>> import touchstone
    >>> triangle = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    >>> touchstone.contact_normal('vertex-face', [[.25, .25, 1]] + triangle, [[.25, .25, -1]] + triangle).tolist()
    [0.0, 0.0, -1.0]
    """
    return _core.contact_normal(kind, start, end, t_max, separation, threads)


@hinting
def toi_gradient(kind: Kind, start: ArrayLike, end: ArrayLike, t_max: float = 1.0, separation: ArrayLike = 0.0,
                 threads: int = 1) -> NDArray:
    """The derivatives of the first contact's exact time by all coordinates, each the true one or a double beside it.

    Arguments and errors are those of `solve`; the metric is the Euclidean one. Returns an array of shape
    (n, 2, corners, 3), or (2, corners, 3) for a single query: by the corners in `start`, and by those in `end`. NaN
    where there is no gradient: without a contact, in contact at the start, where elements only touch and leave again,
    without a separation unless the contact is inside both edges or inside the face, and with one where an edge has no
    length or a face no area.

    >>> import touchstone
    >>> triangle = [[0, 0, 0], [4, 0, 0], [0, 4, 0]]
    >>> gradient = touchstone.toi_gradient('vertex-face', [[1, 1, 3]] + triangle, [[1, 1, -1]] + triangle)
    >>> gradient[0, 0].tolist(), gradient[1, 0].tolist()        # by the point at t = 0, and at t = 1
    ([0.0, 0.0, 0.0625], [0.0, 0.0, 0.1875])
    """
    return _core.toi_gradient(kind, start, end, t_max, separation, threads)
