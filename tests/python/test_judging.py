"""certify. SPDX-License-Identifier: MIT"""
import io
import json
import math

import numpy as np
import pytest
import queries
import touchstone as ts


@pytest.mark.parametrize("kind", queries.KINDS)
def test_verdicts(kind):
    start, end = queries.both(kind, 600)
    truth = ts.solve(kind, start, end)
    right = ts.certify(kind, start, end, truth.contact, np.where(truth.contact, truth.toi, np.nan))
    assert right and right.holds and len(right.refuted) == 0 and queries.same(right.truth, truth)
    assert (right.early[truth.contact] == 0).all() and np.isnan(right.early[~truth.contact]).all()
    assert ts.certify(kind, start, end, truth.contact).holds
    assert not ts.certify(kind, start[:0], end[:0], truth.contact[:0])  # without a claim nothing holds
    opposite = ts.certify(kind, start, end, ~truth.contact, np.full(600, 0.5, np.float32))
    assert not opposite
    assert opposite.count(ts.Verdict.missed) == truth.contact.sum()
    assert opposite.count(ts.Verdict.phantom) == (~truth.contact).sum() and len(opposite.refuted) == 600
    after = np.nextafter(truth.toi, 2, where=truth.contact, out=np.zeros(600))
    next_double = ts.certify(kind, start, end, truth.contact, after)
    assert next_double.count(ts.Verdict.late) == truth.contact.sum() == len(next_double.refuted)
    early = ts.certify(kind, start, end, truth.contact, np.where(truth.contact, truth.toi / 2, 7))
    assert early.holds and np.array_equal(early.early[truth.contact], truth.toi[truth.contact] / 2)
    assert "holds" in repr(early)


def test_wrong_claims_are_refused():
    start, end = queries.random("edge-edge", 5)
    yes = [True] * 5
    reply = "it must be a time as a float, None for no contact, a bool, or a tuple"
    for contact, toi, error, words in (
            (yes[1:], None, ValueError, r"contact has the shape \(4,\)"),
            (yes, [1, 2], ValueError, r"toi has the shape \(2,\)"),
            ([1, 0, 2, 0, 0], None, TypeError, "contact has elements of type int64; they must be bools, or 0 and 1$"),
            (np.full(5, 0.5), None, TypeError, r"bools, or 0 and 1. Of times .*~numpy.isnan\(times\) is contact"),
            ([0.0, 1.0, 0.0, 0.0, 1.0], None, TypeError, "0.0 and 1.0, which may be times or not"),
            ([None, 0.5, 0, 0.5, 0.5], None, TypeError, r"contact\[2\] is 0, and is no reply; " + reply),
            ([None, "yes", None, None, None], None, TypeError, r"contact\[1\] is 'yes', and is no reply; " + reply),
            ([(1, 0.5)] * 5, None, TypeError, r"contact\[0\] is of type tuple"),
            ([None, math.nan, None, None, None], None, ValueError, r"contact\[1\] is NaN; .*None for no contact"),
            ([None, 0.5, None, None, None], [0] * 5, TypeError, "contact has times of its own, so toi must be None"),
            ([None, math.inf, None, None, None], None, ValueError, "row 1: the claimed toi is inf"),
            (yes, ["a"] * 5, TypeError, "toi has strings, such as 'a'"),
            (yes, [None, "a", 0, 0, 0], TypeError, "toi has an element that is 'a'"),
            (yes, [0, 0, math.inf, 0, 0], ValueError, "it must be finite, or NaN for none")):
        with pytest.raises(error, match=words):
            ts.certify("edge-edge", start, end, contact, toi)
    with pytest.raises(ValueError, match="row 2"):
        ts.certify("edge-edge", start, end, yes, [0, 0, math.inf, 0, 0])
    with pytest.raises(ValueError, match="single query"):
        ts.certify("edge-edge", start[0], end[0], True)


def test_claims_are_taken_as_solvers_give_them():
    start, end = queries.both("edge-edge", 400)
    truth = ts.solve("edge-edge", start, end)
    times = np.where(truth.contact, truth.toi, np.nan)
    times[np.flatnonzero(truth.contact)[:9]] = 0.75  # some of these are late, and some early

    def judged(*claims):
        found = ts.certify("edge-edge", start, end, *claims)
        return found.verdict.tolist(), found.claimed.tolist(), [repr(toi) for toi in found.claimed_toi.tolist()]

    without, expected = judged(truth.contact), judged(truth.contact, times)
    assert len(set(expected[0])) > 1
    none = [float(toi) if contact else None for contact, toi in zip(truth.contact, times)]
    for claims in [(truth.contact.astype(int), times), (truth.contact.tolist(), none), (none,),
                   (np.array(none, object),), ([(toi is not None, toi) for toi in none],)]:
        assert judged(*claims) == expected
    for claims in [(truth.contact.astype(np.uint8).tolist(),), (truth.contact, [None] * 400),
                   ([contact or None for contact in truth.contact.tolist()],)]:
        assert judged(*claims) == without
    assert not ts.certify("edge-edge", start[:0], end[:0], [])


def test_times_that_pandas_reads_as_the_pages_say_hold():
    pandas = pytest.importorskip("pandas", reason="pandas is not installed")
    start, end = queries.random("edge-edge", 4000)
    truth = ts.solve("edge-edge", start, end)
    rows = np.flatnonzero(truth.contact)
    table = truth[rows].to_pandas()
    csv = pandas.read_csv(io.StringIO(table.to_csv()), float_precision="round_trip")
    lines = "\n".join(json.dumps({"contact": True, "toi": toi}) for toi in table.toi)
    for read in (csv, pandas.read_json(io.StringIO(lines), lines=True, precise_float=True)):
        assert ts.certify("edge-edge", start[rows], end[rows], read.contact, read.toi).holds


def test_how_late_and_how_early_claims_are():
    start, end = np.zeros((5, 2, 3)), np.zeros((5, 2, 3))
    start[:, 1, 0] = end[:, 1, 0] = [1, 2, 3, 9, 1]  # q at rest, and p flies to x = 4: contact at 1/4, 1/2, 3/4, never
    end[:, 0, 0] = 4
    times = [np.nextafter(0.25, 1) + 2**-53, 0.25, -0.25, 0.5, None]
    found = ts.certify("point-point", start, end, [True, True, True, True, True], times)
    nan = math.nan
    assert np.array_equal(found.late, [2**-53 + 2**-54, nan, nan, nan, nan], equal_nan=True)
    assert np.array_equal(found.early, [nan, 0.25, 1, nan, nan], equal_nan=True)
    pytest.importorskip("pandas", reason="pandas is not installed")
    table = found.to_pandas()
    assert table.verdict.tolist() == ["late", "holds", "holds", "phantom", "holds"]
    assert table.claimed.all() and np.array_equal(table.claimed_toi, [*times[:4], nan], equal_nan=True)
    assert np.array_equal(table.late, found.late, equal_nan=True)
    assert np.array_equal(table.late_ulps, [3, nan, nan, nan, nan], equal_nan=True)
    below = float((np.float64(0.75).view(np.int64) + np.float64(0.25).view(np.int64)))
    assert np.array_equal(table.early_ulps, [nan, 2**52, below, nan, nan], equal_nan=True)
    assert (table.late_ulps > 2).sum() == len(ts.certify("point-point", start, end, [True] * 5, times, late_ulps=2,
                                                         classes="late").refuted)


def test_wrong_claims_need_not_count():
    start, end = queries.both("edge-edge", 2000)
    truth = ts.solve("edge-edge", start, end)
    claimed, times = truth.contact.copy(), np.where(truth.contact, truth.toi, np.nan)
    late = np.flatnonzero(truth.contact & (truth.toi > 0))[:30]
    for step in range(3):  # the first ten are late by one double, then by two and by three
        times[late[10 * step:]] = np.nextafter(times[late[10 * step:]], 2)
    claimed[np.flatnonzero(~truth.contact)[:7]] = True
    claimed[late[29]] = False

    def ask(**options):
        return ts.certify("edge-edge", start, end, claimed, times, **options)

    def counts(found):
        return [found.count(verdict) for verdict in ts.Verdict]

    assert counts(ask()) == [2000 - 37, 1, 7, 29] and len(ask().refuted) == 37 and not ask().not_counted.any()
    some = ask(late_ulps=2)
    assert counts(some) == counts(ask()) and some.not_counted.nonzero()[0].tolist() == sorted(late[:20])
    assert len(some.refuted) == 17 and not some.holds
    assert repr(some) == "<Certificate: 1963 holds, 1 missed, 7 phantom, 29 late; 20 wrong but not counted>"
    assert np.isnan(some.early[late]).all()
    assert len(ask(late_fraction=0.5).refuted) == 8 and len(ask(late_ulps=2, late_fraction=0).refuted) == 37
    assert len(ask(classes=["phantom"]).refuted) == 7 and len(ask(classes="late").refuted) == 29
    assert len(ask(classes=[ts.Verdict.missed, "late"], late_ulps=3).refuted) == 1
    assert ask(classes=["late"], late_ulps=3).holds
    for options, error, words in ((dict(late_ulps=-1), ValueError, "late_ulps"), (dict(late_ulps=0.5), TypeError, ""),
                                  (dict(late_fraction=2), ValueError, r"must be in \[0, 1\]"),
                                  (dict(late_fraction=math.nan), ValueError, "late_fraction"),
                                  (dict(late_fraction="1"), TypeError, "late_fraction"),
                                  (dict(classes=["early"]), ValueError, "'missed'"),
                                  (dict(classes="holds"), ValueError, "one of 'missed', 'phantom', 'late'$"),
                                  (dict(classes=["foo"]), ValueError, "it must be one of 'missed', 'phantom', 'late'$"),
                                  (dict(classes=5), TypeError, "classes is of type int"),
                                  (dict(classes=[3]), TypeError, "classes has an element of type int"),
                                  (dict(classes=[]), ValueError, "classes is empty; None stands for all"),
                                  (dict(late=1), TypeError, "here it is 'late_ulps'")):
        with pytest.raises(error, match=words):
            ask(**options)
