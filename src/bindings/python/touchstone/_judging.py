"""Judging a solver's claims. SPDX-License-Identifier: MIT"""
from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any, Iterable, List, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import elements, exact_doubles, unmasked
from ._core import Answer, Answers
from ._fuzzing import _whole, _words
from ._hints import hinting, shown
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


def _doubles_between(low, high):
    """How many doubles `high`, which is not negative, comes after `low`."""
    bits, end = (np.ascontiguousarray(x, np.float64).view(np.int64) for x in (low, high))
    below_zero = np.where(bits < 0, bits & np.int64(2**63 - 1), 0)
    return (end - np.maximum(bits, 0)).astype(np.float64) + below_zero


@dataclass(frozen=True)
class Certificate:
    """The verdicts on n claims. It is true when `holds` is.

    verdict  (n,) uint8: codes of Verdict
    truth    the exact Answers
    claimed  (n,) bool: whether the claim has a contact
    claimed_toi  (n,) float64: its time; NaN without one
    not_counted  (n,) bool: wrong claims that do not count as refuted, by late_ulps, late_fraction and classes
    """

    verdict: NDArray
    truth: Answers
    claimed: NDArray
    claimed_toi: NDArray
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

    def _of(self, verdict, values):
        return np.where(self.claimed & (self.verdict == verdict), values, np.nan)

    def _after(self):
        """How far each claimed time lies after the exact one; NaN where one is missing."""
        return self.claimed_toi - np.where(self.truth.contact, self.truth.toi, np.nan)

    @property
    def early(self) -> NDArray:
        """(n,) float64: for claims that hold and have a toi, how far it lies before truth.toi; NaN for the others."""
        return self._of(Verdict.holds, -self._after())

    @property
    def late(self) -> NDArray:
        """(n,) float64: for claims that are late, how far the toi lies after truth.toi; NaN for the others."""
        return self._of(Verdict.late, self._after())

    def count(self, verdict: Verdict) -> int:
        """The number of claims with this verdict."""
        return int((self.verdict == verdict).sum())

    def counts(self) -> str:
        """The number of each verdict in words, and how many wrong claims do not count."""
        left_out = int(self.not_counted.sum())
        return (", ".join(f"{self.count(verdict)} {verdict}" for verdict in Verdict) +
                (f"; {left_out} wrong but not counted" if left_out else ""))

    def to_pandas(self) -> Any:
        """A pandas.DataFrame with a row for each claim: its verdict, whether it is refuted, its contact and toi as
        claimed and claimed_toi, how far the toi is early or late, as a time and in ulps, the doubles from the one to
        the other, and the columns of `truth.to_pandas()`. Raises ImportError without pandas."""
        refuted = np.zeros(len(self.verdict), bool)
        refuted[self.refuted] = True
        early_ulps = _doubles_between(self.claimed_toi, self.truth.toi)
        late_ulps = _doubles_between(self.truth.toi, self.claimed_toi)
        return frame({"verdict": Verdict.names(self.verdict), "refuted": refuted, "claimed": self.claimed,
                      "claimed_toi": self.claimed_toi, "early": self.early, "late": self.late,
                      "early_ulps": np.where(np.isnan(self.early), np.nan, early_ulps),
                      "late_ulps": np.where(np.isnan(self.late), np.nan, late_ulps), **answer_columns(self.truth)})

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


def _listed(values):
    """The elements of what may have None in it: a list, a tuple, or an array of objects. None of other things."""
    if isinstance(values, (list, tuple)):
        return list(values)
    return list(values) if getattr(values, "dtype", None) == object and np.ndim(values) == 1 else None


_BOOLS, _WHOLE = (bool, np.bool_), (int, np.integer)


def _reply(reply):
    """(contact, toi) of a reply as `fuzz` takes it, NaN without a time; None of what is no reply."""
    flag, time = reply if isinstance(reply, tuple) and len(reply) == 2 else (True, reply)
    if reply is None or isinstance(reply, _BOOLS):
        flag, time = bool(reply), None
    if not isinstance(flag, _BOOLS):
        return None
    if time is None or not flag:
        return flag, np.nan
    return (flag, float(time)) if hasattr(time, "__float__") and not isinstance(time, _WHOLE) else None


def _split_replies(contact, toi):
    """(contact, toi) of replies; of bools, or of 0 and 1, as they are."""
    replies = _listed(contact)
    if replies is None or all(isinstance(reply, _BOOLS + _WHOLE) for reply in replies):
        return contact, toi
    if toi is not None:
        raise TypeError("contact has times of its own, so toi must be None")
    if all(isinstance(reply, (float, np.floating)) and reply in (0, 1) for reply in replies):
        raise TypeError("contact is a list of 0.0 and 1.0, which may be times or not; give bools, and times as toi")
    claims = [_reply(reply) for reply in replies]
    for i, claim in enumerate(claims):
        if claim is None:
            raise TypeError(f"contact[{i}] {shown(replies[i])}, and is no reply; it must be a time as a float, None "
                            "for no contact, a bool, or a tuple (contact, toi)")
        if np.isnan(claim[1]) and isinstance(replies[i], (float, np.floating)):
            raise ValueError(f"contact[{i}] is NaN; it must be a time, or None for no contact")
    return np.array([flag for flag, _ in claims]), np.array([time for _, time in claims])


def _claims(contact, toi, count):
    """The claims about `count` queries: bools, and times that are NaN where there is none."""
    contact, toi = _split_replies(contact, toi)
    claimed = unmasked(contact, "contact")
    if claimed.size == 0 or claimed.dtype.kind in "iu" and ((claimed == 0) | (claimed == 1)).all():
        claimed = claimed == 1
    if claimed.dtype.kind != "b":
        raise TypeError(f"contact has {elements(claimed)}; they must be bools, or 0 and 1" +
                        (". Of times that are NaN without contact, ~numpy.isnan(times) is contact, and they are toi"
                         if claimed.dtype.kind == "f" else ""))
    if claimed.shape != (count,):
        raise ValueError(f"contact has the shape {claimed.shape}; it must be ({count},), a claim for each query")
    times = np.full(count, np.nan)
    if toi is not None:
        listed = _listed(toi) or []
        if any(time is None for time in listed):
            toi = np.array([np.nan if time is None else time for time in listed], object)
        given = exact_doubles(toi, "toi")
        if given.shape != times.shape:
            raise ValueError(f"toi has the shape {given.shape}; it must be {times.shape}, a time for each query")
        times[claimed] = given[claimed]
    infinite = np.flatnonzero(np.isinf(times))
    if infinite.size:
        row = infinite[0]
        raise ValueError(f"row {row}: the claimed toi is {times[row]}; it must be finite, or NaN for none")
    return claimed, times


@hinting
def certify(kind: Kind, start: ArrayLike, end: ArrayLike, contact: ArrayLike, toi: Optional[ArrayLike] = None,
            t_max: float = 1.0, separation: ArrayLike = 0.0, metric: Metric = "euclidean",
            threads: int = 1, *, late_ulps: Optional[int] = None, late_fraction: Optional[float] = None,
            classes: Optional[Iterable[Union[str, Verdict]]] = None) -> Certificate:
    """Judges a solver's claims about n queries by their exact answers.

    contact  (n,) bool, or 0 and 1: whether the solver claims a contact. Or a list of replies, as `fuzz` takes them:
             each a time, None for no contact, a bool, or a tuple (contact, toi)
    toi      (n,) numbers: the claimed times of impact; None where the solver gives none. NaN and None are a claim
             without a time. Times of claims without contact are not read
    late_ulps, late_fraction  as in `fuzz`: how far after the exact time a claimed one may be and not count as refuted,
             in doubles and as a fraction of the step; without them each late claim counts
    classes  the verdicts that count as refuted, such as ['missed', 'late']; all by default
    The other arguments are those of `solve`, with n queries.

    Returns a Certificate with the attributes verdict, truth, claimed, claimed_toi, early, late, not_counted, holds and
    refuted; `save_page` makes a page of the refuted claims. Raises what `solve` raises, and ValueError for claims that
    are not n, or a claimed time that is infinite.

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
    claimed, times = _claims(contact, toi, len(truth))
    ulps = None if late_ulps is None else _whole(late_ulps, "late_ulps")
    verdict, not_counted = _core.judge(truth, claimed, times, ulps, late_fraction, _words(classes, "classes"))
    asked = (start, end, t_max, np.broadcast_to(np.asarray(separation, float), verdict.shape), metric)
    found = Certificate(verdict, truth, claimed, times, not_counted)
    return replace(found, _shown=_cards(kind, asked, claimed, times, verdict, found.refuted))
