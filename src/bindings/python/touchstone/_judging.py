"""Judging a solver's claims. SPDX-License-Identifier: MIT"""
from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any, Iterable, List, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import unmasked
from ._core import Answer, Answers
from ._fuzzing import _whole, _words
from ._hints import hinting
from ._names import _Named
from ._pages import there
from ._queries import Kind, Metric, solve
from ._tables import answer_columns, frame


class Verdict(_Named):
    """The judgement of a claim.

    holds: it is true. missed: it denies a contact that exists. phantom: it has a contact that does not exist. late: its
    toi lies after the exact time, and a step of that length passes through.
    """

    holds = 0
    missed = 1
    phantom = 2
    late = 3


_MOST_SHOWN = 32


@dataclass(frozen=True)
class Certificate:
    """The verdicts on n claims. It is true when `holds` is.

    verdict  (n,) uint8: codes of Verdict
    truth    the exact Answers
    early    (n,) float64: for claims that hold and have a toi, how far it lies before truth.toi; NaN for the others
    not_counted  (n,) bool: wrong claims that do not count as refuted, by late_ulps, late_fraction and classes
    """

    verdict: NDArray
    truth: Answers
    early: NDArray
    not_counted: NDArray
    _shown: Optional[List[Tuple]] = field(default=None, repr=False, compare=False)  # the cards of page()

    @property
    def holds(self) -> bool:
        """Whether there are claims, and none of them is refuted."""
        return len(self.verdict) > 0 and not len(self.refuted)

    def __bool__(self) -> bool:
        return self.holds

    @property
    def refuted(self) -> NDArray:
        """The indices of the wrong claims that count, in ascending order."""
        return np.flatnonzero((self.verdict != Verdict.holds) & ~self.not_counted)

    def count(self, verdict: Verdict) -> int:
        """The number of claims with this verdict."""
        return int((self.verdict == verdict).sum())

    def counts(self) -> str:
        """The number of each verdict in words, and how many wrong claims do not count."""
        left_out = int(self.not_counted.sum())
        return (", ".join(f"{self.count(verdict)} {verdict}" for verdict in Verdict) +
                (f"; {left_out} wrong but not counted" if left_out else ""))

    def to_pandas(self) -> Any:
        """A pandas.DataFrame with a row for each claim: its verdict, whether it is refuted, early, and the columns of
        `truth.to_pandas()`. Raises ImportError without pandas."""
        refuted = np.zeros(len(self.verdict), bool)
        refuted[self.refuted] = True
        return frame({"verdict": Verdict.names(self.verdict), "refuted": refuted, "early": self.early,
                      **answer_columns(self.truth)})

    def page(self) -> str:
        """The text of an HTML file: the first 32 refuted claims, each with its moving picture and the exact answer.

        Raises RuntimeError in a build without pages, and ValueError for a Certificate of `touchstone.cluster`, which
        has no queries.
        """
        if self._shown is None:
            raise ValueError("this certificate was put together from parts, and has no queries to show; certify the "
                             "refuted ones by touchstone.certify")
        return there(_core.claims_page)(
            f"{len(self.refuted)} of {len(self.verdict)} claims are refuted",
            f"{self.counts()}; shown: {len(self._shown)} of {len(self.refuted)}", self._shown)

    def __repr__(self):
        return f"<Certificate: {self.counts()}>"


def _cards(kind, asked, claimed, times, verdict, refuted):
    """The first refuted claims, as claims_page takes them. Copies: the caller may change its arrays."""
    rows = refuted[:_MOST_SHOWN]
    if not rows.size:
        return []
    start, end, t_max, separation, metric = asked
    start, end = (np.array(np.asarray(corners)[rows], float) for corners in (start, end))
    return [(kind, start[k], end[k], float(t_max), float(separation[i]), metric, bool(claimed[i]),
             None if np.isnan(times[i]) else float(times[i]),
             f"query {i}: {Verdict(verdict[i])}, {kind.replace('_', '-')}", "", "") for k, i in enumerate(rows)]


@hinting
def certify(kind: Kind, start: ArrayLike, end: ArrayLike, contact: ArrayLike, toi: Optional[ArrayLike] = None,
            t_max: float = 1.0, separation: ArrayLike = 0.0, metric: Metric = "euclidean",
            threads: int = 1, *, late_ulps: Optional[int] = None, late_fraction: Optional[float] = None,
            classes: Optional[Iterable[Union[str, Verdict]]] = None) -> Certificate:
    """Judges a solver's claims about n queries by their exact answers.

    contact  (n,) bool: whether the solver claims a contact
    toi      (n,) numbers: the claimed times of impact; None where the solver gives none. NaN is a claim without a time.
             Times of claims without contact are not read
    late_ulps, late_fraction  as in `fuzz`: how far after the exact time a claimed one may be and not count as refuted,
             in doubles and as a fraction of the step; without them each late claim counts
    classes  the verdicts that count as refuted, such as ['missed', 'late']; all by default
    The other arguments are those of `solve`, with n queries.

    Returns a Certificate with the attributes verdict, truth, early, not_counted, holds and refuted; `save_page` makes a
    page of the refuted claims. Raises what `solve` raises, and ValueError for claims that are not n, or a claimed time
    that is infinite.

    >>> import numpy as np, touchstone
    >>> start, end = np.zeros((3, 2, 3)), np.zeros((3, 2, 3))
    >>> start[:, 1, 0] = end[:, 1, 0] = [1, 2, 5]    # q at rest, 1, 2 and 5 to the right of p
    >>> end[:, 0, 0] = 4                             # p flies to x = 4
    >>> found = touchstone.certify('point-point', start, end, [True, False, False], [.3, 0, 0])
    >>> touchstone.Verdict.names(found.verdict).tolist(), found.refuted.tolist()
    (['late', 'missed', 'holds'], [0, 1])
    """
    truth = solve(kind, start, end, t_max, separation, metric, threads)
    if isinstance(truth, Answer):
        raise ValueError("start has a single query; certify takes arrays of shape (n, corners, 3), and n claims")
    claimed = unmasked(contact, "contact")
    if claimed.dtype.kind != "b":
        raise TypeError(f"contact has elements of type {claimed.dtype}; they must be bool")
    if claimed.shape != (len(truth),):
        raise ValueError(f"contact has the shape {claimed.shape}; it must be ({len(truth)},), a claim for each query")
    times = np.full(len(truth), np.nan)
    if toi is not None:
        given = unmasked(toi, "toi")
        if given.dtype.kind not in "fiu" or given.dtype.itemsize > 8:
            raise TypeError(f"toi has elements of type {given.dtype}; they must be doubles")
        if given.shape != times.shape:
            raise ValueError(f"toi has the shape {given.shape}; it must be {times.shape}, a time for each query")
        times[claimed] = given[claimed]
        infinite = np.flatnonzero(np.isinf(times))
        if infinite.size:
            row = infinite[0]
            raise ValueError(f"row {row}: the claimed toi is {times[row]}; it must be finite, or NaN for none")
    ulps = None if late_ulps is None else _whole(late_ulps, "late_ulps")
    verdict, not_counted = _core.judge(truth, claimed, times, ulps, late_fraction, _words(classes, "classes"))
    early = np.where(claimed & (verdict == Verdict.holds), truth.toi - times, np.nan)
    asked = (start, end, t_max, np.broadcast_to(np.asarray(separation, float), verdict.shape), metric)
    found = Certificate(verdict, truth, early, not_counted)
    return replace(found, _shown=_cards(kind, asked, claimed, times, verdict, found.refuted))
