"""Proofs of answers, and their check by another program. SPDX-License-Identifier: MIT"""
from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Optional, Union

from numpy.typing import ArrayLike

from . import _core
from ._core import Answers
from ._queries import Kind, Metric


@dataclass(frozen=True)
class Checked:
    """What touchstone-check says of proofs.

    accepted  whether every proof holds
    message   its words: the files and counts, or which query is rejected and why
    """

    accepted: bool
    message: str

    def __bool__(self):
        return self.accepted


class Proofs:
    """The answers to n queries, each with a proof that needs no trust in this module. Made by `prove`.

    answers  the Answers
    """

    def __init__(self, core: _core.ProvedFile):
        self._core = core

    @property
    def answers(self) -> Answers:
        """The Answers, in the order of the queries."""
        return self._core.answers

    def __len__(self) -> int:
        return len(self._core.answers)

    def __repr__(self):
        return f"<Proofs: {len(self)}, {int(self.answers.contact.sum())} with contact>"

    def write(self, folder: Union[str, os.PathLike]) -> Path:
        """Writes queries.csv and proofs.txt into a folder, which is made if it is missing, and returns the folder.

        docs/proofs.md defines both files. Raises FileExistsError, and writes nothing, if one of them is there.
        """
        place = Path(folder)
        place.mkdir(parents=True, exist_ok=True)
        names = ("queries.csv", "proofs.txt")
        for name in names:
            if os.path.lexists(place / name):
                raise FileExistsError(f"{place / name} exists; give a folder without it")
        made = []
        try:
            for name, content in zip(names, (self._core.queries, self._core.proofs)):
                with open(place / name, "xb") as file:
                    made.append(place / name)
                    file.write(content)
        except BaseException:  # Ctrl-C too: a query file without its proofs is of no use
            for path in made:
                path.unlink()
            raise
        return place

    def check(self, checker: Optional[Union[str, os.PathLike]] = None) -> Checked:
        """Lets touchstone-check read the proofs, from a temporary folder. Arguments and errors are those of `check`."""
        with tempfile.TemporaryDirectory() as folder:
            place = self.write(folder)
            return check(place / "proofs.txt", place / "queries.csv", checker=checker)


def prove(kind: Kind, start: ArrayLike, end: ArrayLike, separation: float = 0.0, metric: Metric = "euclidean",
          threads: int = 1) -> Proofs:
    """The first contact of each query for t in [0, 1], with a proof of each answer.

    The arguments are those of `solve`; there is one separation for all queries, because a file of proofs has one.
    Returns Proofs, whose `write` makes files that touchstone-check or a checker of your own reads. Raises what `solve`
    raises, and ValueError for no query: touchstone-check refuses proofs of nothing.

    >>> import touchstone
    >>> proved = touchstone.prove('point-point', [[[0, 0], [2, 0]]], [[[1, 0], [1, 0]]])
    >>> proved, proved.answers.toi.tolist()
    (<Proofs: 1, 1 with contact>, [1.0])
    """
    return Proofs(_core.prove(kind, start, end, separation, metric, threads))


def _checker(given):
    if given is not None:
        return os.fspath(given)
    found = os.environ.get("TOUCHSTONE_CHECK") or shutil.which("touchstone-check")
    if not found:
        raise FileNotFoundError("touchstone-check is not in PATH. It comes with the program touchstone, and one call "
                                "of a compiler makes it from src/proofs/checker; name it by `checker` or by "
                                "TOUCHSTONE_CHECK")
    return found


def check(proofs: Union[str, os.PathLike], *files: Union[str, os.PathLike],
          checker: Optional[Union[str, os.PathLike]] = None, allow_empty: bool = False) -> Checked:
    """Lets the program touchstone-check judge a file of proofs. It shares no code with this module but GMP.

    proofs       the file of proofs
    files        the query files, or the motion file, that it is about, in its order
    checker      the program; by default that of the variable TOUCHSTONE_CHECK, or touchstone-check in PATH
    allow_empty  accept a motion of which no two elements come near enough to need a proof

    Returns Checked, which is true when every proof holds. Raises FileNotFoundError without the program, and ValueError,
    with its message, for files that it cannot read.

    >>> import touchstone
    >>> touchstone.check('no-such-file', checker='no-such-program')
    Traceback (most recent call last):
    FileNotFoundError: [Errno 2] No such file or directory: 'no-such-program'
    """
    program = _checker(checker)
    names = [os.path.join(os.curdir, name) if name.startswith("-") else name
             for name in [os.fspath(file) for file in (proofs, *files)]]
    options = ["--allow-empty"] if allow_empty else []
    result = subprocess.run([program, *options, *names], capture_output=True, text=True, errors="replace", check=False)
    words = (result.stdout + result.stderr).strip()
    if result.returncode not in (0, 1):
        raise ValueError(words or f"{program} ended with the status {result.returncode}")
    if result.returncode == 0 and " checked: " not in result.stdout:
        raise ValueError(f"{program} does not say that it checked anything: {words!r}")
    return Checked(result.returncode == 0, words)
