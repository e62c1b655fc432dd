"""Questions over many processes or machines: parts, plain functions that answer a part, and results put together.

This module has no engine of its own. Each function takes a `client`: a Client of Dask's `distributed`, or anything else
with `map` and perhaps `gather`, such as a concurrent.futures.ProcessPoolExecutor. The functions whose names end in
`_part` are what a worker runs. Hand them to Ray or Spark in the same way: they take arrays, return arrays, and keep no
state.

A part is a tuple of arrays, or a function without arguments that makes one on the worker: for data that no single
machine should read. Results are in the order of the parts, whoever answered them, and a part that is answered again,
because its worker died, has the same answer. So no byte of a result depends on the workers.
"""
from __future__ import annotations

import json
from functools import lru_cache, partial
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _fuzzing, _judging, _meshes, _queries
from ._arrays import unmasked
from ._core import Mesh
from ._judging import Certificate, Verdict
from ._names import Nature
from ._queries import Kind

_FIELDS = np.dtype([("contact", "?"), ("toi", "f8"), ("toi_upper", "f8"), ("nature", "u1"), ("feature_a", "u1"),
                    ("feature_b", "u1"), ("level", "u1"), ("trend", "u1"), ("starts_within", "?"),
                    ("weights_a", "f8", 3), ("weights_b", "f8", 3)])


def partition(*arrays: NDArray, rows: int = 100_000) -> List[Tuple[NDArray, ...]]:
    """Arrays of n rows each, cut into parts of at most `rows` rows, without copies.

    Raises ValueError for arrays that do not have equally many rows, or rows < 1.

    >>> [part[0].tolist() for part in partition(np.arange(5), rows=2)]
    [[0, 1], [2, 3], [4]]
    """
    if rows < 1:
        raise ValueError(f"rows is {rows}; it must be at least 1")
    counts = {len(array) for array in arrays}
    if len(counts) != 1:
        raise ValueError(f"the arrays have {sorted(counts)} rows; they must have the same")
    return [tuple(array[i:i + rows] for array in arrays) for i in range(0, counts.pop(), rows)]


def _ask(function, part, number):
    try:
        return function(*(part() if callable(part) else part))
    except (TypeError, ValueError) as error:
        raise type(error)(f"part {number}: {error}") from None


def _run(client, function, parts):
    """The results of function(*part), in the order of the parts."""
    parts = list(parts)
    own = {"pure": False} if hasattr(client, "gather") else {}  # Dask must not look for the arrays' digests
    answers = client.map(_ask, [function] * len(parts), parts, range(len(parts)), **own)
    return client.gather(answers) if hasattr(client, "gather") else list(answers)


def _joined(rows):
    return np.concatenate(rows).view(np.recarray) if rows else np.empty(0, _FIELDS).view(np.recarray)


def _rows(answers):
    rows = np.zeros(len(answers), _FIELDS)
    for name in _FIELDS.names:
        rows[name] = getattr(answers, name)
    rows["weights_a"][~rows["contact"]] = rows["weights_b"][~rows["contact"]] = 0  # they have no meaning there
    return rows


def solve_part(kind: Kind, start: NDArray, end: NDArray, **options: Any) -> NDArray:
    """`touchstone.solve` of n queries as a structured array, which can be sent from process to process.

    Arguments and errors are those of `touchstone.solve`.

    >>> solve_part('point-point', np.zeros((1, 2, 3)), np.ones((1, 2, 3)))['toi'].tolist()
    [0.0]
    """
    return _rows(_queries.solve(kind, start, end, **options))


def solve(client: Any, kind: Kind, parts: Sequence, **options: Any) -> np.recarray:
    """`touchstone.solve` over parts (start, end). The attributes of the result are those of Answers.

    options  those of `touchstone.solve`

    Raises what `touchstone.solve` raises, with the number of the part before the row.

    >>> from concurrent.futures import ThreadPoolExecutor
    >>> parts = partition(np.zeros((5, 2, 3)), np.ones((5, 2, 3)), rows=2)
    >>> solve(ThreadPoolExecutor(), 'point-point', parts).contact.sum()
    5
    """
    return _joined(_run(client, partial(solve_part, kind, **options), parts))


def certify_part(kind: Kind, start: NDArray, end: NDArray, contact: NDArray, toi: Optional[NDArray] = None,
                 **options: Any) -> Tuple[NDArray, NDArray, NDArray, NDArray, NDArray]:
    """`touchstone.certify` of n claims: (verdict, truth as of `solve_part`, claimed, claimed_toi, not_counted). Errors
    are those of it."""
    found = _judging.certify(kind, start, end, contact, toi, **options)
    return found.verdict, _rows(found.truth), found.claimed, found.claimed_toi, found.not_counted


def certify(client: Any, kind: Kind, parts: Sequence, **options: Any) -> Certificate:
    """`touchstone.certify` over parts (start, end, contact) or (start, end, contact, toi).

    options  those of `touchstone.certify`

    Returns a Certificate of all claims, in the order of the parts. Raises what `touchstone.certify` raises.

    >>> from concurrent.futures import ThreadPoolExecutor
    >>> parts = partition(np.zeros((5, 2, 3)), np.ones((5, 2, 3)), np.arange(5) > 0, rows=2)
    >>> certify(ThreadPoolExecutor(), 'point-point', parts)
    <Certificate: 4 holds, 1 missed, 0 phantom, 0 late>
    """
    found = _run(client, partial(certify_part, kind, **options), parts)
    verdict, truth, claimed, times, not_counted = zip(*found) if found else ([], [], [], [], [])
    return Certificate(np.concatenate([np.empty(0, np.uint8), *verdict]), _joined(truth),
                       np.concatenate([np.empty(0, bool), *claimed]), np.concatenate([np.empty(0), *times]),
                       np.concatenate([np.empty(0, bool), *not_counted]))


def _tally(certificate):
    """The counts of verdicts, how many wrong claims do not count, and the refuted ones."""
    refuted = []
    for i in certificate.refuted:
        truth = certificate.truth[int(i)]
        exact = {"contact": int(truth.contact)}
        if truth.contact:
            exact.update(toi=float(truth.toi).hex(), toi_upper=float(truth.toi_upper).hex(),
                         nature=str(Nature(truth.nature)))
        refuted.append({"query": int(i), "verdict": str(Verdict(certificate.verdict[i])), "exact": exact})
    return [*map(certificate.count, Verdict), int(certificate.not_counted.sum())], refuted


def _text(counts, refuted):
    claims = json.dumps({str(verdict): count for verdict, count in zip(Verdict, counts)})
    left_out = f" \"not_counted\": {counts[-1]},\n" if counts[-1] else ""
    lines = ",".join("\n  " + json.dumps(one) for one in refuted)
    return "{\n \"claims\": " + claims + ",\n" + left_out + " \"refuted\": [" + lines + "]\n}\n"


def report(certificate: Certificate) -> str:
    """The certificate as JSON, with hexfloats: the counts of verdicts, how many wrong claims do not count if some do
    not, and each refuted claim with the exact answer.

    Raises nothing for a Certificate of `certify` here or of `touchstone.certify`.

    >>> import touchstone
    >>> print(report(touchstone.certify('point-point', np.zeros((1, 2, 3)), np.ones((1, 2, 3)), [True])).splitlines()[1])
     "claims": {"holds": 1, "missed": 0, "phantom": 0, "late": 0},
    """
    return _text(*_tally(certificate))


def report_part(kind: Kind, start: NDArray, end: NDArray, contact: NDArray, toi: Optional[NDArray] = None,
                **options: Any) -> Tuple[List[int], List[Dict]]:
    """The counts of `touchstone.certify`, whose errors it has, and the refuted claims, with numbers from 0."""
    return _tally(_judging.certify(kind, start, end, contact, toi, **options))


def certify_report(client: Any, kind: Kind, parts: Sequence, **options: Any) -> str:
    """report(certify(client, kind, parts)), without the answers to claims that hold: for many workers.

    Arguments and errors are those of `certify`.

    >>> from concurrent.futures import ThreadPoolExecutor
    >>> parts = partition(np.zeros((5, 2, 3)), np.ones((5, 2, 3)), np.arange(5) != 3, rows=2)
    >>> print(certify_report(ThreadPoolExecutor(), 'point-point', parts).splitlines()[3][:35])
      {"query": 3, "verdict": "missed",
    """
    counts, refuted, before = [0] * (len(Verdict) + 1), [], 0
    for part_counts, part_refuted in _run(client, partial(report_part, kind, **options), parts):
        refuted += [{**one, "query": before + one["query"]} for one in part_refuted]
        counts = [a + b for a, b in zip(counts, part_counts)]
        before += sum(part_counts[:-1])
    return _text(counts, refuted)


_WORST_FIRST = ("crash", "malformed", "missed", "late", "nan", "phantom", "early")


def _hex(x):
    return None if x is None else float(x).hex()


def fuzz_part(solver: Callable, cases: int, seed: int, **options: Any) -> Dict:
    """`touchstone.fuzz` with one seed, as `fuzz` describes it. Arguments and errors are those of `touchstone.fuzz`."""
    report_ = _fuzzing.fuzz(solver, cases, seed=seed, **options)
    findings = [{"failure": found.failure, "kind": found.kind, "degeneracy": found.degeneracy, "count": found.count,
                 "start": [list(map(_hex, corner)) for corner in found.start.tolist()],
                 "end": [list(map(_hex, corner)) for corner in found.end.tolist()],
                 "claim": {"contact": found.contact, "toi": _hex(found.toi)},
                 "exact": {"contact": found.truth.contact, "toi": _hex(found.truth.toi)},
                 "detail": found.detail, "case": found.case_name, "separation": found.separation,
                 "metric": found.metric} for found in report_.findings]
    return {"queries": report_.queries, "failures": report_.failures, "findings": findings}


def fuzz(client: Any, solver: Callable, cases: int = 10_000, parts: int = 16, seed: int = 1, **options: Any) -> Dict:
    """`touchstone.fuzz` over `parts` parts, each with a seed of its own: seed, seed + 1 and so on.

    solver   the function of `touchstone.fuzz`; it runs on the workers and can be sent there
    cases    how many queries to make in all
    options  those of `touchstone.fuzz`; `findings` is how many each part shrinks

    Returns a dict: queries, failures, and findings, worst first. A finding is a dict: failure, kind, degeneracy, count,
    start, end, claim, exact, detail, case (for `touchstone fuzz --case`), separation and metric; coordinates and times
    are hexfloats. Of failures of one sort on queries that are degenerate in one way, it has the query of the first part
    that lists one, and the count of all that do. Raises what `touchstone.fuzz` raises, with the number of the part.

    >>> from concurrent.futures import ThreadPoolExecutor
    >>> found = fuzz(ThreadPoolExecutor(2), lambda kind, start, end: False, 400, parts=2, kinds=['point-point'])
    >>> found["queries"], sorted({finding["failure"] for finding in found["findings"]})
    (400, ['missed'])
    """
    if cases < 1 or parts < 1:
        raise ValueError(f"cases is {cases} and parts {parts}; they must be at least 1")
    ends = [cases * i // parts for i in range(parts + 1)]
    asked = [(b - a, seed + i) for i, (a, b) in enumerate(zip(ends, ends[1:])) if a < b]
    queries = failures = 0
    findings: Dict[Tuple[str, str, str], Dict] = {}
    for part in _run(client, partial(fuzz_part, solver, **options), asked):
        queries += part["queries"]
        failures += part["failures"]
        for found in part["findings"]:
            first = findings.setdefault((found["failure"], found["kind"], found["degeneracy"]), {**found, "count": 0})
            first["count"] += found["count"]
    ordered = sorted(findings.values(), key=lambda found: (_WORST_FIRST.index(found["failure"]), -found["count"]))
    return {"queries": queries, "failures": failures, "findings": ordered}


@lru_cache(maxsize=4)
def _mesh_of(key):
    return Mesh(**{name: np.frombuffer(value[0], value[1]).reshape(value[2]) if isinstance(value, tuple) else value
                   for name, value in key})


def _key_of(mesh):
    """The arguments of a Mesh as a key: an array as its bytes, type and shape."""
    arrays = {name: value if np.isscalar(value) else unmasked(value, name) for name, value in mesh.items()}
    return tuple((name, (value.tobytes(), value.dtype.str, value.shape) if isinstance(value, np.ndarray) else value)
                 for name, value in sorted(arrays.items()))


def steps_part(mesh: Mapping[str, Any], frame: Callable[[int], NDArray], first: int, last: int,
               **options: Any) -> List[Dict]:
    """The steps first to last - 1 of a sequence, as `steps` describes them. Errors are those of `first_contact`."""
    made = _mesh_of(_key_of(mesh))
    found = []
    if first >= last:
        return []
    before = frame(first)
    for k in range(first, last):
        after = frame(k + 1)
        try:
            contact = _meshes.first_contact(made, before, after, **options)
        except ValueError as error:
            raise ValueError(f"step {k}: {error}") from None
        before = after
        times = [t.hex() if contact.contact else None for t in (contact.toi, contact.toi_upper)]
        found.append({"step": k, "free": contact.free, "toi": times[0], "toi_upper": times[1],
                      "first": [made.describe(pair) for pair in contact.earliest],
                      "at_start": [made.describe(pair) for pair in contact.at_start]})
    return found


def steps(client: Any, mesh: Mapping[str, Any], frame: Callable[[int], NDArray], count: int, parts: int = 16,
          **options: Any) -> List[Dict]:
    """`touchstone.first_contact` for each of the `count` steps of an animation.

    mesh     the arguments of a Mesh, by name; each worker makes it once
    frame    frame(k) has the positions of frame k, 0 <= k <= count; it runs on the worker and can be sent there
    parts    how many contiguous parts the steps are cut into
    options  those of `touchstone.first_contact`

    Returns a list with a dict for each step: step, free, toi and toi_upper as hexfloats or None, first and at_start as
    lists of pairs in words. Raises ValueError as `first_contact` does, naming part, step and vertex.

    >>> from concurrent.futures import ThreadPoolExecutor
    >>> fly = lambda k: [[k, 0, 0], [2.5, 0, 0]]
    >>> [step["free"] for step in steps(ThreadPoolExecutor(), {"vertices": 2}, fly, 3)]
    [True, True, False]
    """
    if count < 0 or parts < 1:
        raise ValueError(f"count is {count} and parts {parts}; they must be at least 0 and 1")
    ends = [count * i // parts for i in range(parts + 1)]
    ranges = [(a, b) for a, b in zip(ends, ends[1:]) if a < b]
    return sum(_run(client, partial(steps_part, mesh, frame, **options), ranges), [])
