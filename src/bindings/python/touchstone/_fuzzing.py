"""Breaking a solver that is a Python function. SPDX-License-Identifier: MIT"""
from __future__ import annotations

import operator
from typing import Any, Callable, Iterable, Optional

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._core import FuzzReport, Mesh, StepReport
from ._hints import hinting
from ._names import _Named
from ._queries import Kind, Metric

_MOST = 2**64 - 1


def _whole(number, name, least=0):
    try:
        value = operator.index(number)
    except TypeError:
        raise TypeError(f"{name} is of type {type(number).__name__}; it must be a whole number") from None
    if not least <= value <= _MOST:
        raise ValueError(f"{name} is {value}; it must be in [{least}, 2^64 - 1]")
    return value


def _words(words, name):
    """None, or a list of strings: one at least."""
    if words is None:
        return None
    if not isinstance(words, Iterable):
        raise TypeError(f"{name} is of type {type(words).__name__}; it must be a list of strings")
    given = [words] if isinstance(words, str) else [str(word) if isinstance(word, _Named) else word for word in words]
    for word in given:
        if not isinstance(word, str):
            raise TypeError(f"{name} has an element of type {type(word).__name__}; they must be strings")
    if not given:
        raise ValueError(f"{name} is empty; None stands for all")
    return given


@hinting
def fuzz(solver: Callable[[str, NDArray[np.float64], NDArray[np.float64]], Any], cases: int = 10_000, *,
         kinds: Optional[Iterable[Kind]] = None, families: Optional[Iterable[str]] = None, seed: int = 1,
         climb: int = 0, separation: float = 0.0, metric: Metric = "euclidean",
         early_ulps: Optional[int] = None, early_fraction: Optional[float] = None,
         late_ulps: Optional[int] = None, late_fraction: Optional[float] = None, near: float = 0.0,
         failures: Optional[Iterable[str]] = None, findings: int = 32) -> FuzzReport:
    """Asks a solver degenerate and extreme queries, judges its replies exactly, and shrinks the queries that it fails.

    solver       a function of (kind, start, end): a word and two float64 arrays of shape (corners, 3). It returns
                 whether there is contact for t in [0, 1], a bool; or the time of contact, a float; or None for no
                 contact; or a tuple (contact, toi), where toi may be None. An Exception that it raises is a finding;
                 KeyboardInterrupt, SystemExit and the like end the run, and reach the caller, and so does the
                 Exception that each of the first 20 calls raises
    cases        how many queries to make, in equal parts for all families and kinds
    kinds        the kinds of query, or one; all by default
    families     the families of queries, as `touchstone fuzz --help` lists them; all by default
    seed         the queries are the same for the same seed
    climb        steps of hill-climbing from each query towards harder ones
    separation   what the solver is asked: the first time within this distance. The solver is not told; metric as in
                 `solve`
    early_ulps   the greatest distance of a claimed time before the exact one, in doubles; by default any
    early_fraction  the same as a fraction of the step
    late_ulps    the greatest distance of a claimed time after the exact one that is no failure, in doubles from the
                 largest one <= the exact time on; by default none
    late_fraction  the same as a fraction of the step
    near         a contact that does not exist is no failure where the elements come within this part of the query's
                 greatest coordinate of being in contact
    failures     the failures to look for, such as ['missed', 'late']; all by default
    findings     how many findings to shrink and return

    Returns a FuzzReport with the attributes queries, failures, allowed (wrong replies that late_ulps and the
    options after it let pass), kinds_of_failure and findings. A Finding has failure,
    degeneracy, count, kind, start, end, contact, toi, truth, detail, case_name, separation and metric; it prints
    itself, and shows itself in a notebook. The function runs on another thread than the caller's. Raises ValueError for
    options without meaning, and KeyboardInterrupt at Ctrl-C, when the function's call that runs then has ended.

    >>> import numpy as np, touchstone
    >>> def samples(kind, start, end):               # the distance of two points at 100 times
    ...     t = np.linspace(0, 1, 100)[:, None, None]
    ...     with np.errstate(over='ignore'):
    ...         p, q = np.moveaxis((1 - t) * start + t * end, 1, 0)
    ...         return bool((np.abs(p - q).max(axis=1) < 1e-6).any())
    >>> report = touchstone.fuzz(samples, 300, kinds=['point-point'])
    >>> report.failures > 0, sorted({finding.failure for finding in report.findings})
    (True, ['missed', 'phantom'])
    """
    def ulps(value, name):
        return None if value is None else _whole(value, name)

    return _core.fuzz(solver, _words(kinds, "kinds"), _words(families, "families"), _whole(cases, "cases", 1),
                      _whole(seed, "seed"), _whole(climb, "climb"), separation, metric,
                      ulps(early_ulps, "early_ulps"), early_fraction, ulps(late_ulps, "late_ulps"), late_fraction,
                      near, _words(failures, "failures"), _whole(findings, "findings"))


@hinting
def fuzz_steps(solver: Callable[[Mesh, NDArray[np.float64], NDArray[np.float64]], Any], cases: Optional[int] = None, *,
               seconds: Optional[float] = None, families: Optional[Iterable[str]] = None, seed: int = 1,
               separations: bool = True, groups: bool = True, may_end_in_contact: bool = False, stall: float = 1e-3,
               early_fraction: Optional[float] = None, late_fraction: float = 0.0, twice: bool = True,
               findings: int = 32) -> StepReport:
    """Asks a simulator's collision detection about whole steps of small meshes that are hard, judges its replies by
    the exact answers to all pairs of elements, and shrinks the steps that it fails.

    solver       a function of (mesh, x0, x1): a Mesh with all of its edges, and the positions of its vertices at both
                 ends of the step, float64 arrays of shape (vertices, 3). It returns the part of the step, in [0, 1],
                 that is free of contact; or a dict with one or more of 'free', that number; 'first_contact', the time
                 of the first contact, or None for no contact; and 'candidates', the pairs of its broad phase as tuples
                 (kind, first, second). Exceptions are as for `fuzz`
    cases        how many steps to make, from all families in turn; 10,000 by default
    seconds      in place of cases: the search ends after this time
    families     the families of steps, as `touchstone fuzz-steps --help` lists them; all by default
    seed         the steps are the same for the same seed
    separations  whether meshes may have a separation
    groups       whether meshes may have groups of vertices that do not collide
    may_end_in_contact  whether a free step may end in its first contact
    stall        a free step shorter than this part of the way to the first contact is a failure
    early_fraction  the greatest part of the step between a reply's time and a later first contact; by default any
    late_fraction   the greatest part of the step by which 'first_contact' may lie after the exact time
    twice        whether the function is asked twice, and must say the same
    findings     how many findings to shrink and return

    Returns a StepReport with the attributes steps, failures, kinds_of_failure, left_out (what no mesh had) and
    findings. A StepFinding has failure, question, detail, count, mesh, x0, x1 and case_name; it prints itself, and its
    `page()` shows the step. The function runs on another thread than the caller's. Raises what `fuzz` raises, and
    ValueError where the time was too short for a step.

    >>> import touchstone
    >>> def stale(mesh, x0, x1):                         # a tree that is not refitted: its pairs are those of the start
    ...     return {'candidates': touchstone.candidates(mesh, x0, x0)}
    >>> report = touchstone.fuzz_steps(stale, 60)
    >>> report.findings[0].failure, report.findings[0].question
    ('missed', 'candidates')
    """
    if cases is not None and seconds is not None:
        raise ValueError("cases and seconds both end the search: give one of them")
    if cases is None:
        cases = 10_000 if seconds is None else _MOST
    return _core.fuzz_steps(solver, _whole(cases, "cases", 1), seconds, _words(families, "families"),
                            _whole(seed, "seed"), bool(separations), bool(groups), bool(may_end_in_contact), stall,
                            early_fraction, late_fraction, bool(twice), _whole(findings, "findings"))
