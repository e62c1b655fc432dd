"""certify. SPDX-License-Identifier: MIT"""
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
    for contact, toi, error in ((yes[1:], None, ValueError), ([1] * 5, None, TypeError), (yes, [1, 2], ValueError),
                                (yes, ["a"] * 5, TypeError), (yes, [0, 0, math.inf, 0, 0], ValueError)):
        with pytest.raises(error):
            ts.certify("edge-edge", start, end, contact, toi)
    with pytest.raises(ValueError, match="row 2"):
        ts.certify("edge-edge", start, end, yes, [0, 0, math.inf, 0, 0])
    with pytest.raises(ValueError, match="single query"):
        ts.certify("edge-edge", start[0], end[0], True)


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
