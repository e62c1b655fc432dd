"""What answers, judged claims and mesh results look like in a notebook: plain tables. SPDX-License-Identifier: MIT"""
from __future__ import annotations

from dataclasses import dataclass
from html import escape
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core, _meshes, _queries
from ._core import (Answer, Answers, Finding, FirstContact, FreeStep, FuzzReport, Intersections, Mesh, Pairs,
                    StepFinding, StepReport)
from ._judging import Certificate, Verdict
from ._mesh_files import AnyMesh, as_argument
from ._names import Feature, Level, Nature
from ._pages import there
from ._queries import Kind, Metric

_CORNERS = {"edge-edge": ("a0", "a1", "b0", "b1"), "vertex-face": ("v", "f0", "f1", "f2"),
            "point-edge": ("p", "e0", "e1"), "point-point": ("p", "q")}
_MOST_ROWS = 20


def _number(x):
    x = float(x)
    short = abs(x) < 2**30 and x * 2**20 == round(x * 2**20)  # a person sees which number it is
    return f"{x!r}" if short else f"{x!r} ({x.hex()})"


def _table(heading, names, rows, more=0):
    """Every cell is text and escaped: names of files and texts of exceptions are shown, never interpreted."""
    head = "".join(f"<th>{escape(str(name))}</th>" for name in names)
    body = "".join("<tr>" + "".join(f"<td>{escape(str(cell))}</td>" for cell in row) + "</tr>" for row in rows)
    rest = f"<p>{more} more</p>" if more > 0 else ""
    return (f"<div><strong>{escape(heading)}</strong><table><thead><tr>{head}</tr></thead>"
            f"<tbody>{body}</tbody></table>{rest}</div>")


def _facts(heading, pairs):
    return _table(heading, ("", ""), pairs)


def _answer_facts(answer):
    if not answer.contact:
        return [("contact", "none"), ("decided by", Level(answer.level))]
    return [("first time", f"[{_number(answer.toi)}, {_number(answer.toi_upper)}]"), ("nature", Nature(answer.nature)),
            ("touched", f"{Feature(answer.feature_a)} and {Feature(answer.feature_b)}"),
            ("decided by", Level(answer.level))]


def _frame(page):
    """A page in a frame of its own, which can reach nothing of the notebook; nothing in a build without pages."""
    if page is None:
        return ""
    return (f'<iframe srcdoc="{escape(page, quote=True)}" sandbox="allow-scripts" width="100%" height="720" '
            'style="border: 0"></iframe>')


def _page(kind, start, end, t_max, separation, metric, title):
    if _core.page is None:
        return None
    return _core.page(kind, start, end, t_max, separation, metric, title)


def _corner_rows(kind, start, end):
    rows = []
    for name, a, b in zip(_CORNERS[kind], np.asarray(start), np.asarray(end)):
        rows.append((name, ", ".join(map(_number, a)), ", ".join(map(_number, b))))
    return rows


@dataclass(frozen=True)
class Shown:
    """One query with its answer: a moving picture in a notebook, and text elsewhere.

    kind, start, end             the query
    answer                       its Answer
    t_max, separation, metric    what was asked
    """

    kind: str
    start: NDArray
    end: NDArray
    answer: Answer
    t_max: float = 1.0
    separation: float = 0.0
    metric: str = "euclidean"

    def page(self) -> str:
        """The text of an HTML file: the page that `touchstone view` writes. Raises RuntimeError in a build without."""
        return there(_page(self.kind, self.start, self.end, self.t_max, self.separation, self.metric,
                           f"{self.kind} query"))

    def _repr_html_(self):
        return (_table(f"{self.kind} query", ("corner", "at t = 0", "at t = 1"),
                       _corner_rows(self.kind, self.start, self.end)) + _facts("answer", _answer_facts(self.answer)) +
                _frame(_page(self.kind, self.start, self.end, self.t_max, self.separation, self.metric, self.kind)))

    def __repr__(self):
        rows = "\n".join(f"  {name:<3} ({a}) to ({b})" for name, a, b in _corner_rows(self.kind, self.start, self.end))
        return f"{self.kind} query\n{rows}\n  {self.answer!r}"


def show(kind: Kind, start: ArrayLike, end: ArrayLike, t_max: float = 1.0, separation: float = 0.0,
         metric: Metric = "euclidean") -> Shown:
    """One query with its answer, to look at in a notebook. Arguments and errors are those of `solve`.

    >>> import touchstone
    >>> touchstone.show('point-point', [[0, 0], [2, 0]], [[4, 0], [2, 0]])
    point-point query
      p   (0.0, 0.0) to (4.0, 0.0)
      q   (2.0, 0.0) to (2.0, 0.0)
      Answer(contact=True, toi=0.5, toi_upper=0.5, nature=isolated, feature_a=p, feature_b=q, level=exact)
    """
    answer = _queries.solve(kind, start, end, t_max, separation, metric, 1)
    if not isinstance(answer, Answer):
        raise ValueError("start has many queries; show takes one, of shape (corners, 3) or (corners, 2)")
    return Shown(kind.replace("_", "-"), np.array(start, float), np.array(end, float), answer, float(t_max),
                 float(separation), metric)


@dataclass(frozen=True)
class ShownMesh:
    """A step of a mesh with its first contact: a moving picture in a notebook, and text elsewhere.

    mesh, x0, x1      the mesh, and its positions at t = 0 and at t = 1
    first_contact     the FirstContact of the step
    t_max             what was asked
    """

    mesh: Mesh
    x0: NDArray
    x1: NDArray
    first_contact: FirstContact
    t_max: float = 1.0

    def _page(self):
        return None if _core.mesh_page is None else _core.mesh_page(self.mesh, self.x0, self.x1, self.t_max, 0)

    def page(self) -> str:
        """The text of an HTML file: the animation of the step, with its first contact and the intersections at both
        ends marked. Raises RuntimeError in a build without pages."""
        return there(self._page())

    def _repr_html_(self):
        return _show_contact(self.first_contact) + _frame(self._page())

    def __repr__(self):
        return f"{self.mesh!r} {self.first_contact!r}"


def show_mesh(mesh: AnyMesh, x0: ArrayLike, x1: ArrayLike, t_max: float = 1.0, threads: int = 1) -> ShownMesh:
    """A step of a mesh with its first contact, to look at in a notebook.

    Arguments and errors are those of `first_contact`.

    >>> import touchstone
    >>> touchstone.show_mesh(touchstone.Mesh(2), [[0, 0, 0], [2, 0, 0]], [[4, 0, 0], [2, 0, 0]])
    <Mesh: 2 vertices, 0 faces, 0 edges, 2 loose points> <FirstContact: toi 0.5, 1 earliest, 0 at the start>
    """
    own = as_argument(mesh)
    found = _meshes.first_contact(own, x0, x1, t_max, threads)
    return ShownMesh(own, np.array(x0), np.array(x1), found, float(t_max))


def _show_answers(answers: Any):
    rows = [(i, "yes" if a.contact else "no", _number(a.toi) if a.contact else "", Nature(a.nature), Level(a.level))
            for i, a in zip(range(_MOST_ROWS), answers)]
    return _table(f"{len(answers)} answers, {int(answers.contact.sum())} with contact",
                  ("query", "contact", "toi", "nature", "decided by"), rows, len(answers) - len(rows))


def _show_pairs(pairs):
    rows = list(zip(range(_MOST_ROWS), pairs.kind, pairs.first.tolist(), pairs.second.tolist()))
    return _table(f"{len(pairs)} pairs", ("", "kind", "first", "second"), rows, len(pairs) - len(rows))


def _show_contact(found):
    if found.free:
        return _facts("the step is free of contact", [("start", "checked" if found.start_checked else "not checked")])
    facts = [("first time", f"[{_number(found.toi)}, {_number(found.toi_upper)}]")] if found.contact else []
    facts += [("pairs at that time", len(found.earliest)), ("in contact at the start", len(found.at_start))]
    if found.start_checked:
        facts.append(("intersections at the start", len(found.start_intersections)))
    return _facts("contact", facts) + (_show_pairs(found.earliest) if len(found.earliest) else "")


def _show_step(step):
    return _facts("free step", [("outcome", step.outcome), ("length", _number(step.length)), ("proofs", step.proofs)])


def _show_intersections(found):
    columns = zip(range(_MOST_ROWS), found.first_element, found.first.tolist(), found.second_element,
                  found.second.tolist(), found.sort)
    rows = [(f"{a} {i}", f"{b} {j}", sort) for _, a, i, b, j, sort in columns]
    return _table(f"{len(found)} intersections", ("element", "element", "how"), rows, len(found) - len(rows))


def _show_certificate(certificate):
    rows = [(int(i), Verdict(certificate.verdict[i]), "contact at " + _number(certificate.truth.toi[i])
             if certificate.truth.contact[i] else "no contact") for i in certificate.refuted[:_MOST_ROWS]]
    return _table(certificate.counts(), ("claim", "verdict", "exact answer"), rows,
                  len(certificate.refuted) - len(rows))


def _show_finding(found):
    claim = "contact" if found.contact else "no contact"
    if found.contact and found.toi is not None:
        claim += f" at {_number(found.toi)}"
    facts = [("claim", claim), ("exact", repr(found.truth)), ("in all", found.count), ("degeneracy", found.degeneracy),
             ("more", found.detail)]
    return (_table(f"{found.failure}, {found.kind}", ("corner", "at t = 0", "at t = 1"),
                   _corner_rows(found.kind, found.start, found.end)) + _facts("reply", facts) +
            _frame(_page(found.kind, found.start, found.end, 1.0, found.separation, found.metric,
                         f"{found.failure}, {found.kind}")))


def _finding_page(found):
    return there(_page(found.kind, found.start, found.end, 1.0, found.separation, found.metric,
                       f"{found.failure}, {found.kind}"))


def _report_page(report):
    """Cards of all findings, as `touchstone fuzz --html` writes them."""
    cards = []
    for found in report.findings:
        times = f" {found.count} times" if found.count > 1 else ""
        cards.append((found.kind, found.start, found.end, 1.0, found.separation, found.metric,
                      None if found.failure == "crash" else found.contact, found.toi,
                      f"{found.failure}{times}, {found.kind}", found.degeneracy, found.detail))
    return there(_core.claims_page)(
        "findings about a solver", f"{report.failures} of {report.queries} replies are wrong, in "
        f"{report.kinds_of_failure} ways; shown: {len(cards)}", cards)


def _show_report(report):
    rows = [(f.failure, f.kind, f.degeneracy, f.count) for f in report.findings[:_MOST_ROWS]]
    return _table(f"{report.failures} of {report.queries} replies are wrong",
                  ("failure", "kind", "degeneracy", "times"), rows, report.kinds_of_failure - len(rows))


def _step_finding_page(found):
    """The shrunk step as an animation, with its exact first contact."""
    return there(_core.mesh_page)(found.mesh, found.x0, found.x1, 1.0, 0)


def _show_step_finding(found):
    rows = [(v, *map(str, ends)) for v, ends in enumerate(zip(found.x0.tolist(), found.x1.tolist()))]
    return (_table(f"{found.failure}, {found.question}", ("vertex", "at t = 0", "at t = 1"), rows[:_MOST_ROWS],
                   len(rows) - len(rows[:_MOST_ROWS])) +
            _facts("step", [("in all", found.count), ("more", found.detail), ("mesh", repr(found.mesh))]))


def _show_step_report(report):
    rows = [(f.failure, f.question, f.detail, f.count) for f in report.findings[:_MOST_ROWS]]
    return _table(f"{report.failures} of {report.steps} steps have a wrong reply",
                  ("failure", "question", "more", "times"), rows, report.kinds_of_failure - len(rows))


for _class, _shown in ((Answer, lambda answer: _facts("answer", _answer_facts(answer))), (Answers, _show_answers),
                       (Pairs, _show_pairs),
                       (FirstContact, _show_contact), (FreeStep, _show_step), (Intersections, _show_intersections),
                       (Certificate, _show_certificate), (Finding, _show_finding), (FuzzReport, _show_report),
                       (StepFinding, _show_step_finding), (StepReport, _show_step_report)):
    setattr(_class, "_repr_html_", _shown)
setattr(Finding, "page", _finding_page)
setattr(FuzzReport, "page", _report_page)
setattr(StepFinding, "page", _step_finding_page)
