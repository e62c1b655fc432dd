"""Proofs, and their check by the program touchstone-check. SPDX-License-Identifier: MIT"""
import os
from pathlib import Path

import numpy as np
import pytest
import queries
import touchstone as ts
from touchstone import CurvedQueries, OnBody

PROGRAM = os.environ.get("TOUCHSTONE_PROGRAM")
CHECKER = Path(PROGRAM).with_name("touchstone-check") if PROGRAM else None
needs_checker = pytest.mark.skipif(not CHECKER or not CHECKER.exists(), reason="touchstone-check is not built")


@needs_checker
@pytest.mark.parametrize("kind", queries.KINDS)
@pytest.mark.parametrize("about", [{}, {"separation": 0.25}, {"separation": 0.25, "metric": "max"}])
def test_every_answer_has_a_proof(kind, about):
    start, end = queries.both(kind, 200)
    proved = ts.prove(kind, start, end, **about)
    assert len(proved) == 200 and queries.same(proved.answers, ts.solve(kind, start, end, **about))
    checked = proved.check(CHECKER)
    assert checked and f"{int(proved.answers.contact.sum())} contacts" in checked.message
    assert ts.prove(kind, start, end, threads=3, **about)._core.proofs == proved._core.proofs


@needs_checker
def test_a_changed_verdict_is_rejected(tmp_path):
    start, end = queries.both("edge-edge", 50)
    proved = ts.prove("edge-edge", start, end)
    q = int(np.flatnonzero(proved.answers.contact)[0])
    place = proved.write(tmp_path / "new" / "folder")
    assert ts.check(place / "proofs.txt", place / "queries.csv", checker=CHECKER).accepted
    text = (place / "proofs.txt").read_text()
    line = next(line for line in text.splitlines() if line.startswith(f"{q} contact"))
    forged = tmp_path / "forged.txt"
    forged.write_text(text.replace(line + "\n", f"{q} none\n"))
    checked = ts.check(forged, place / "queries.csv", checker=CHECKER)
    assert not checked and f"query {q}" in checked.message


@needs_checker
def test_curved_queries():
    tips = np.array([[[1., 0, 0]], [[2, 0, 0]], [[.2, 0, 0]]])
    curved = CurvedQueries("point-edge", OnBody(tips, q1=[1, 0, 0, 1]), OnBody([[.25, -4, 0], [.25, 4, 0]]))
    for separation in (0, 0.01):
        proved = curved.prove(separation=separation)
        assert proved.check(CHECKER) and queries.same(proved.answers, curved.solve(separation=separation))


def test_files_are_not_overwritten(tmp_path):
    proved = ts.prove("point-point", [[[0, 0], [1, 0]]], [[[0, 0], [1, 0]]])
    (tmp_path / "proofs.txt").write_text("mine")
    with pytest.raises(FileExistsError, match="proofs.txt"):
        proved.write(tmp_path)
    assert os.listdir(tmp_path) == ["proofs.txt"] and (tmp_path / "proofs.txt").read_text() == "mine"


def test_what_is_wrong_is_named(tmp_path, monkeypatch):
    start, end = queries.random("point-edge", 5)
    end[3, 0, 0] = np.inf
    with pytest.raises(ValueError, match="row 3"):
        ts.prove("point-edge", start, end)
    with pytest.raises(ValueError, match="separation"):
        ts.prove("point-edge", start, start, separation=[1] * 5)
    with pytest.raises(ValueError, match="separation"):
        ts.prove("point-edge", start[:0], start[:0], separation=-1)
    with pytest.raises(ValueError, match="there is no query, so there is nothing to prove"):
        ts.prove("point-edge", start[:0], start[:0])
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("TOUCHSTONE_CHECK", raising=False)
    with pytest.raises(FileNotFoundError, match="touchstone-check is not in PATH"):
        ts.check(tmp_path / "a", tmp_path / "b")


@needs_checker
def test_bad_input_of_the_checker_is_an_error(tmp_path, monkeypatch):
    monkeypatch.setenv("TOUCHSTONE_CHECK", str(CHECKER))
    with pytest.raises(ValueError, match="none-such"):
        ts.check(tmp_path / "none-such", tmp_path / "b")


@needs_checker
def test_a_name_like_an_option_is_a_file_and_another_program_checks_nothing(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("--help", "-h"):
        with pytest.raises(ValueError, match="cannot be opened"):
            ts.check(name, "a.csv", checker=CHECKER)
    proved = ts.prove("point-point", [[[0, 0], [1, 0]]], [[[1, 0], [1, 0]]])
    with pytest.raises(ValueError, match="checked anything"):
        proved.check("/bin/true")
    os.symlink("nowhere", "proofs.txt")
    with pytest.raises(FileExistsError):
        proved.write(".")
    assert os.listdir() == ["proofs.txt"]
