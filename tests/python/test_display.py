"""What a notebook shows. SPDX-License-Identifier: MIT"""
import re
from html import unescape
from html.parser import HTMLParser

import numpy as np
import pytest
import queries
import touchstone as ts


class Page(HTMLParser):
    """Tags must nest, and the text is collected."""

    def __init__(self, text):
        super().__init__()
        self.open, self.seen, self.text = [], set(), ""
        self.feed(text)
        assert self.open == []

    def handle_starttag(self, tag, attributes):
        self.open.append(tag)
        self.seen.add(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_startendtag(self, tag, attributes):
        self.seen.add(tag)

    def handle_data(self, data):
        self.text += data + "\n"


def page(thing):
    return Page(thing._repr_html_())


def test_queries_and_answers():
    start, end = queries.both("vertex-face", 100)
    answers = ts.solve("vertex-face", start, end)
    many = page(answers)
    assert f"100 answers, {answers.contact.sum()} with contact" in many.text and "80 more" in many.text
    assert many.seen <= {"div", "strong", "table", "thead", "tbody", "tr", "th", "td", "p"}
    q = int(np.flatnonzero(answers.contact)[0])
    shown = page(ts.show("vertex-face", start[q], end[q]))
    for word in ("vertex-face query", "f2", float(answers.toi[q]).hex(), str(ts.Nature(answers.nature[q]))):
        assert word in shown.text or float(answers.toi[q]) * 2**20 % 1 == 0
    assert "none" in page(answers[int(np.flatnonzero(~answers.contact)[0])]).text
    assert "(0.0, 0.0)" in repr(ts.show("point-point", [[0, 0], [1, 1]], [[0, 0], [1e300, -5e-324]]))
    assert (-5e-324).hex() in page(ts.show("point-point", [[0, 0], [1, 1]], [[0, 0], [1e300, -5e-324]])).text


def test_claims():
    start, end = queries.both("edge-edge", 50)
    truth = ts.solve("edge-edge", start, end)
    found = page(ts.certify("edge-edge", start, end, ~truth.contact))
    assert f"{truth.contact.sum()} missed" in found.text and "30 more" in found.text


def test_refuted_claims_are_a_page(tmp_path):
    start, end = queries.both("vertex-face", 200)
    truth = ts.solve("vertex-face", start, end)
    claim, toi = truth.contact.copy(), np.where(truth.contact, truth.toi, np.nan)
    hit, miss = np.flatnonzero(truth.contact)[:2], np.flatnonzero(~truth.contact)[:1]
    claim[hit[0]], toi[hit[1]], claim[miss[0]], toi[miss[0]] = False, 1.5, True, 0.25
    found = ts.certify("vertex-face", start, end, claim, toi)
    before = found.page()
    start[:] = 7  # what is shown is what was judged
    assert found.page() == before and before.startswith("<!doctype html>")
    assert before.count('<article class="card">') == 3 and "3 of 200 claims are refuted" in before
    for row, verdict in ((hit[0], "missed"), (hit[1], "late"), (miss[0], "phantom")):
        assert f"query {row}: {verdict}, vertex-face" in before
    assert "contact at 0.25" in before and "contact at 1.5" in before
    file = tmp_path / "a <script> name.html"
    file.write_text("what was there")
    assert ts.save_page(found, file) == file and file.read_text(encoding="utf-8") == before
    assert [path.name for path in tmp_path.iterdir()] == [file.name]
    start, end = queries.both("edge-edge", 300)
    many = ts.certify("edge_edge", start, end, ~ts.solve("edge-edge", start, end).contact, separation=[0] * 300)
    assert many.page().count('<article class="card">') == 32 and "shown: 32 of 300" in many.page()
    right = ts.certify("edge-edge", start, end, ts.solve("edge-edge", start, end).contact)
    assert "0 of 300 claims are refuted" in right.page()
    flat = ts.certify("point-point", [[[0, 0], [2, 0]]], [[[4, 0], [2, 0]]], [False], t_max=0.75, separation=0.25)
    assert "contact at 0.4375" in flat.page()


def test_pages_of_findings_and_what_has_none(tmp_path):
    report = ts.fuzz(lambda *query: 1 // 0 if query[0] == "point-edge" else False, 400, findings=5)
    whole = report.page()
    assert whole.count('<article class="card">') == len(report.findings) == 5
    assert "none: it crashed" in whole and "ZeroDivisionError" in whole
    name = ts.save_page(report.findings[0], str(tmp_path / "one.html"))
    assert name.read_text(encoding="utf-8").startswith("<!doctype html>")
    with pytest.raises(TypeError, match="thing is 3, which has no page"):
        ts.save_page(3, tmp_path / "none.html")
    with pytest.raises(OSError):
        ts.save_page(report, tmp_path / "no-folder" / "page.html")
    for file in ("page.png", "page.CSV", "page.html.gz"):
        with pytest.raises(ValueError, match=f"{file} has the ending of another format.*name it .*html"):
            ts.save_page(report, tmp_path / file)
        assert not (tmp_path / file).exists()
    for file in ("page", "page.v2", "page.htm"):
        ts.save_page(report, tmp_path / file).unlink()
    with pytest.raises(OSError):
        ts.save_page(report, tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["one.html"]
    with pytest.raises(ValueError, match="put together from parts"):
        ts.Certificate(np.zeros(1, np.uint8), None, np.zeros(1, bool), np.zeros(1), np.zeros(1, bool)).page()


def test_mesh_results():
    mesh = ts.Mesh(4, [[0, 1, 2]])
    x0 = np.array([[-9., -9, 0], [9, -9, 0], [0, 9, 0], [0, 0, 1]])
    x1 = x0.copy()
    x1[3, 2] = -1
    found = ts.first_contact(mesh, x0, x1)
    assert "0.5" in page(found).text and "vertex-face" in page(found).text
    assert "free of contact" in page(ts.first_contact(mesh, x0, x0)).text
    assert "shortened" in page(ts.free_step(mesh, x0, x1)).text
    assert "1 pairs" in page(ts.all_contacts(mesh, x0, x1)).text
    edges = ts.Mesh(5, faces=[[0, 1, 2]], edges=[[3, 4]])
    pierced = ts.intersections(edges, [[0, 0, 0], [1, 0, 0], [0, 1, 0], [.25, .25, -1], [.25, .25, 1]])
    assert "edge 0" in page(pierced).text and "pierces" in page(pierced).text


def test_a_step_of_a_mesh_is_a_page_with_its_contacts_and_intersections():
    mesh = ts.Mesh(4, [[0, 1, 2]])
    x0 = np.array([[-9., -9, 0], [9, -9, 0], [0, 9, 0], [0, 0, 1]])
    x1 = x0.copy()
    x1[3, 2] = -1
    shown = ts.show_mesh(mesh, x0, x1)
    x1[3, 2] = 5  # what is shown is what was asked
    assert shown.first_contact.toi == 0.5 and shown.x1[3, 2] == -1
    whole = shown.page()
    assert whole.startswith("<!doctype html>") and "http://" not in whole.replace("http://www.w3.org", "")
    assert "the contact of 1 begins first" in whole and "vertex 3 and face 0 (0-1-2)" in whole
    assert "0.5" in page(shown).text and "<iframe" in shown._repr_html_()
    assert "The step is free of contact." in ts.show_mesh(mesh, x0, x0).page()
    flat = ts.show_mesh(ts.Mesh(3, edges=[[0, 1]], dimension=2), [[0, 0], [2, 0], [1, 1]], [[0, 0], [2, 0], [1, -1]])
    assert "the contact of 1 begins first" in flat.page()
    edges = ts.Mesh(5, faces=[[0, 1, 2]], edges=[[3, 4]])
    x = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [.25, .25, -1], [.25, .25, 1]]
    pierced = ts.show_mesh(edges, x, x).page()
    assert "1 intersections at t = 0, and 1 at t = 1" in pierced and "pierces" in pierced
    late = ts.show_mesh(mesh, x0, shown.x1, t_max=0.25)
    assert late.first_contact.free and "The step is free of contact." in late.page()
    with pytest.raises(ValueError, match="x1 has the shape"):
        ts.show_mesh(mesh, x0, x0[:3])


def test_a_query_is_a_page_that_reaches_nothing():
    shown = ts.show("point-edge", [[0, 1, 0], [-1, 0, 0], [1, 0, 0]], [[0, -1, 0], [-1, 0, 0], [1, 0, 0]])
    whole = shown.page()
    assert whole.startswith("<!doctype html>") and "http://" not in whole.replace("http://www.w3.org", "")
    assert "0x1p-1" in whole
    html = shown._repr_html_()
    frame = re.search('<iframe srcdoc="([^"]*)" sandbox="allow-scripts"', html).group(1)
    assert unescape(frame).startswith("<!doctype html>") and "<script" not in frame
    near = ts.show("point-point", [[0, 0], [2, 0]], [[1, 0], [2, 0]], separation=1.5)
    assert near.answer.toi == 0.5 and near.separation == 1.5 and near.page() != whole
    report = ts.fuzz(lambda *query: False, 200, kinds=["point-point"], separation=0.5)
    found = report.findings[0]
    assert found.separation == 0.5 and found.metric == "euclidean" and "<iframe" in found._repr_html_()
