"""The fuzzer, for solvers that are Python functions. SPDX-License-Identifier: MIT"""
import math
import pickle

import numpy as np
import pytest
import touchstone as ts


def exact(kind, start, end):
    answer = ts.solve(kind, start, end)
    return answer.contact, answer.toi


def test_an_exact_solver_is_never_wrong():
    seen = set()

    def solver(kind, start, end):
        seen.add(kind)
        assert start.dtype == end.dtype == np.float64 and start.shape == end.shape
        return exact(kind, start, end)

    report = ts.fuzz(solver, 2000, early_ulps=0)
    assert report.queries == 2000 and report.failures == 0 and report.findings == []
    assert seen == {"edge-edge", "vertex-face", "point-edge", "point-point"}
    only = ts.fuzz(solver, 100, kinds=["point_edge"], families=["planar_axis"], seed=3)
    assert only.queries == 100 and only.failures == 0


def half(kind, start, end):
    """Misses every contact in the second half of the step."""
    answer = ts.solve(kind, start, end, t_max=0.5)
    return answer.contact


def test_findings_are_shrunk_and_true():
    report = ts.fuzz(half, 1500)
    assert report.failures > 10 and len(report.findings) == 32 < report.kinds_of_failure
    assert {found.failure for found in report.findings} == {"missed"}
    for found in report.findings:
        truth = ts.solve(found.kind, found.start, found.end)
        assert truth.contact and truth.toi == found.truth.toi and not found.contact and found.toi is None
        assert not half(found.kind, found.start, found.end) and found.count >= 1
        assert found.failure in repr(found) and "exact" in repr(found)
    assert [repr(found) for found in ts.fuzz(half, 1500).findings] == [repr(found) for found in report.findings]
    assert len(ts.fuzz(half, 1500, findings=2).findings) == 2
    assert "<td>missed</td>" in report._repr_html_() and "at t = 1" in report.findings[0]._repr_html_()


@pytest.mark.parametrize("reply, failure", [
    (lambda truth: truth.toi if truth.contact else None, None),
    (lambda truth: (truth.contact, None), None),
    (lambda truth: np.bool_(truth.contact), None),
    (lambda truth: (truth.contact, np.float64(truth.toi)), None),
    (lambda truth: (truth.contact, math.nan), "nan"),
    (lambda truth: not truth.contact, "phantom"),
    (lambda truth: truth.contact and "yes", "crash"),
    (lambda truth: truth.contact and (1, 0.5), "crash"),
    (lambda truth: truth.contact and np.array([True]), "crash"),
    (lambda truth: truth.contact and 1 // 0, "crash"),
])
def test_replies(reply, failure):
    report = ts.fuzz(lambda *query: reply(ts.solve(*query)), 200, kinds=["point-point", "edge-edge"])
    kinds = {found.failure for found in report.findings}
    assert (failure in kinds) if failure else not kinds
    if failure == "crash":
        assert report.findings[0].detail


def test_a_tolerance_is_allowed_and_counted():
    def late(*query):
        answer = ts.solve(*query)
        return (answer.contact, np.nextafter(answer.toi_upper, 2)) if answer.contact else False

    assert ts.fuzz(late, 500).failures > 50
    report = ts.fuzz(late, 500, late_ulps=2)
    assert report.failures == 0 and report.allowed > 50
    assert ts.fuzz(late, 500, late_fraction=1e-9, failures=["missed"]).failures == 0

    def wide(kind, start, end):
        close = ts.distance(kind, start, end, 1).value <= 1e-3 * max(abs(start).max(), abs(end).max())
        return close or ts.solve(kind, start, end).contact

    assert ts.fuzz(wide, 500, kinds=["point-point"]).failures > 0
    assert ts.fuzz(wide, 500, kinds=["point-point"], near=0.002).failures == 0


def test_a_function_that_cannot_be_meant_so_raises():
    calls = []
    with pytest.raises(TypeError, match="positional argument"):
        ts.fuzz(lambda start, end: False)

    def broken(kind, start, end):
        calls.append(kind)
        raise LookupError("no table")

    with pytest.raises(LookupError, match="no table"):
        ts.fuzz(broken, 100_000)
    assert len(calls) == 20


def test_what_is_raised_is_told():
    def broken(kind, start, end):
        if kind == "point-point":
            raise LookupError("the <b>seventh</b> table is missing")
        return exact(kind, start, end)

    found = ts.fuzz(broken, 200).findings[0]
    assert found.failure == "crash" and "LookupError" in found.detail and "seventh" in found.detail
    assert "&lt;b&gt;" in found._repr_html_() and "<b>" not in found._repr_html_()


def test_a_separation_is_what_the_solver_was_asked():
    near = ts.fuzz(lambda *query: ts.solve(*query, separation=0.5, wanted="contact").contact, 500, separation=0.5)
    assert near.failures == 0
    assert ts.fuzz(lambda *query: ts.solve(*query, wanted="contact").contact, 500, separation=0.5).failures > 0


@pytest.mark.parametrize("arguments, error, words", [
    ({"solver": 3}, TypeError, "solver is of type int"), ({"cases": 0}, ValueError, "cases is 0"),
    ({"cases": -1}, ValueError, "cases is -1"), ({"cases": 1.5}, TypeError, "cases is of type float"),
    ({"seed": 2**64}, ValueError, "seed"), ({"kinds": ["edge"]}, ValueError, "kind is 'edge'"),
    ({"families": ["none-such"]}, ValueError, "none-such"), ({"families": [3]}, TypeError, "families has"),
    ({"kinds": []}, ValueError, "kinds is empty"), ({"separation": -1}, ValueError, "separation"),
    ({"early_fraction": 2}, ValueError, "early_fraction"), ({"near": -1}, ValueError, "near is -1"),
    ({"failures": ["slow"]}, ValueError, "it must be of crash, hang"), ({"late_ulps": -1}, ValueError, "late_ulps"),
    ({"climb": 2**63}, ValueError, "climb"),
])
def test_options_without_meaning(arguments, error, words):
    with pytest.raises(error, match=words):
        ts.fuzz(**{"solver": half, **arguments})


@pytest.mark.parametrize("error", [KeyboardInterrupt, SystemExit, GeneratorExit])
def test_what_is_no_exception_ends_the_run_and_reaches_the_caller(error):
    calls = []

    def interrupted(kind, start, end):
        calls.append(kind)
        if len(calls) == 50:
            raise error("no further")
        return exact(kind, start, end)

    with pytest.raises(error, match="no further"):
        ts.fuzz(interrupted, 100_000)
    assert len(calls) == 50
    # While a query is shrunk, too.
    calls.clear()

    def failing(kind, start, end):
        calls.append(kind)
        if len(calls) == 400:
            raise error("no further")
        return not exact(kind, start, end)[0]

    with pytest.raises(error, match="no further"):
        ts.fuzz(failing, 300)
    assert len(calls) == 400


def exact_step(mesh, x0, x1):
    assert x0.shape == x1.shape == (mesh.vertex_count, 3) and x0.dtype == np.float64
    found = ts.first_contact(mesh, x0, x1)
    return {"free": ts.free_step(mesh, x0, x1).length,
            "first_contact": 0.0 if len(found.at_start) else found.toi if found.contact else None,
            "candidates": ts.candidates(mesh, x0, x1)}


def test_exact_steps_are_never_wrong():
    report = ts.fuzz_steps(exact_step, 130)
    assert report.steps == 130 and report.failures == 0 and report.findings == []
    assert repr(report) == "<StepReport: 130 steps, 0 failures of 0 kinds>"


def no_pair(mesh, x0, x1):
    return {"candidates": []}


def test_findings_of_steps_are_shrunk_and_true():
    report = ts.fuzz_steps(no_pair, 130)
    assert report.failures > 10 and {found.failure for found in report.findings} == {"missed"}
    for found in report.findings:
        assert found.question == "candidates" and found.count >= 1 and found.case_name
        assert found.x0.shape == found.x1.shape == (found.mesh.vertex_count, 3) and found.mesh.vertex_count <= 8
        contact = ts.first_contact(found.mesh, found.x0, found.x1)
        assert not contact.free and "missed" in repr(found)
        assert "<!doctype html>" in found.page() and "vertex" in found._repr_html_()
    again = ts.fuzz_steps(no_pair, 130)
    assert [repr(found) for found in again.findings] == [repr(found) for found in report.findings]
    copied = pickle.loads(pickle.dumps(report))
    assert [repr(found) for found in copied.findings] == [repr(found) for found in report.findings]
    assert (copied.findings[0].x0 == report.findings[0].x0).all() and "wrong reply" in report._repr_html_()


@pytest.mark.parametrize("reply, failure", [
    (0.0, "early"),                               # a stall
    (1, "missed"),
    (0.999999, "late"),
    (math.nan, "malformed"),
    ({"first_contact": None}, "missed"),
    ({"candidates": [("edge-edge", 0)]}, "crash"),
    ({"candidates": 3}, "crash"),
    ({"length": 1.0}, "crash"),
    ({}, "crash"),
    (True, "crash"),
    (np.True_, "crash"),
    ({"first_contact": np.False_}, "crash"),
    ({"candidates": [("edge-edge", 10**7, 3)]}, "malformed"),
    ("free", "crash"),
])
def test_replies_about_steps(reply, failure):
    answered = []

    def solver(mesh, x0, x1):
        answered.append(mesh)
        # The first call is right: it does not fail as all others do.
        return ts.free_step(mesh, x0, x1).length if len(answered) == 1 else reply

    report = ts.fuzz_steps(solver, 40, twice=False, findings=3)
    assert failure in {found.failure for found in report.findings}


def test_step_fuzzing_says_what_is_wrong():
    for options, part in (({"families": ["nonsense"]}, "nonsense"), ({"cases": 0}, "cases is 0"),
                          ({"stall": 2.0}, "stall"), ({"late_fraction": -1.0}, "late")):
        with pytest.raises(ValueError, match=part):
            ts.fuzz_steps(no_pair, **options)
    with pytest.raises(TypeError, match=r"a function of \(mesh, x0, x1\)"):
        ts.fuzz_steps(3)
    with pytest.raises(ZeroDivisionError):
        ts.fuzz_steps(lambda mesh, x0, x1: 1 // 0, 100)
    # What is wrong with every reply is told at once, whoever finds it.
    with pytest.raises(ValueError, match="a pair is a tuple"):
        ts.fuzz_steps(lambda mesh, x0, x1: {"candidates": [["edge-edge", 0, 1]]}, 100)
    with pytest.raises(ValueError, match="cases and seconds both"):
        ts.fuzz_steps(no_pair, 13, seconds=1.0)
    with pytest.raises(ValueError, match="no step was asked"):
        ts.fuzz_steps(no_pair, seconds=1e-9)


def test_a_report_says_what_was_left_out():
    report = ts.fuzz_steps(exact_step, 13, groups=False, separations=False)
    assert report.left_out == pickle.loads(pickle.dumps(report)).left_out == ["separations", "groups"]
    assert repr(report).endswith("0 kinds; separations were left out; groups were left out>")


def test_a_damaged_pickle_of_a_step_is_refused():
    """Positions that do not fit to the mesh would be read behind their ends."""
    found = ts.fuzz_steps(no_pair, 130, findings=1).findings[0]
    count = found.x0.size
    whole = found.__reduce_ex__(4)
    damaged = 0

    def without(value):
        nonlocal damaged
        if isinstance(value, bytes):
            one = np.ascontiguousarray(found.x0).tobytes()
            at = value.find(count.to_bytes(8, "little") + one)
            if at >= 0:
                damaged += 1
                return value[:at] + bytes(8) + value[at + 8 + len(one):]
        return tuple(map(without, value)) if isinstance(value, tuple) else value

    changed = without(whole)
    assert damaged == 1
    with pytest.raises(ValueError, match="the pickle is damaged"):
        made = changed[0](*changed[1])
        made.__setstate__(changed[2])
