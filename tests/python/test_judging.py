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
