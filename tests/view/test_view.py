"""Pages in a real browser: they are scrubbed, clicked and read, and pixels near the contact are compared.
SPDX-License-Identifier: MIT

  test_view.py TOUCHSTONE
"""
import json
import os
import time
import unittest

import browser
import pages

CANVAS = "document.querySelector('.stage canvas')"


def rows_of(corners, truth):
    """Rows of a query file, of corners whose coordinates are doubles or integers."""
    lines = []
    for corner in corners:
        words = []
        for x in corner:
            words += ["%d" % n for n in float(x).as_integer_ratio()]
        lines.append(",".join(words) + ",%d" % truth)
    return "\n".join(lines) + "\n"


def falling(end):
    """Edge b, at x = 1, falls along z onto edge a, from x = -1 to `end`."""
    a = [(-1, 0, 0), (end, 0, 0)]
    return a + [(1, -1, 1), (1, 1, 1)] + a + [(1, -1, -1), (1, 1, -1)]


ONE_ULP_SHORT = 1 - 2.0 ** -53


class Queries(pages.Pages):
    def page_of(self, name, corners, truth, *arguments):
        file = self.write(name, rows_of(corners, truth))
        out = self.path("page.html")
        self.run_program("view", "--query", "0", "--kind", "edge-edge", "--out", out, *arguments, file)
        self.page.requests.clear()
        return self.page.open(out)

    def readout(self):
        return self.page.evaluate("document.querySelector('.readout').textContent")

    def chip(self, start):
        self.page.click_on("[...document.querySelectorAll('.chip')].find((c) => c.textContent.startsWith(%s))" %
                           json.dumps(start))

    def test_scrubbing_moves_the_elements_and_the_words(self):
        url = self.page_of("a.csv", falling(2), 1)
        self.assertIn("t = 0.5, at the contact; the marked points meet.", self.readout())
        seen = {"".join(self.page.pixels(CANVAS))}
        self.chip("start")
        self.assertIn("t = 0, 0.5 before the contact; the marked points are 1 apart.", self.readout())
        seen.add("".join(self.page.pixels(CANVAS)))
        slider = "document.querySelector('.timeline input')"
        box = self.page.evaluate("(() => { const b = %s.getBoundingClientRect(); return [b.left, b.top, b.width, "
                                 "b.height]; })()" % slider)
        self.page.click(box[0] + box[2] * 0.75, box[1] + box[3] / 2)
        self.assertRegex(self.readout(), r"^t = 0\.7\d+, 0\.2\d+ after the contact")
        seen.add("".join(self.page.pixels(CANVAS)))
        self.assertEqual(len(seen), 3)  # each time has a picture of its own
        self.page.evaluate("%s.focus()" % CANVAS)
        self.page.key("[")
        self.assertIn("at the contact", self.readout())
        self.page.key("ArrowRight")
        self.assertRegex(self.readout(), r"^t = 0\.51, 0\.01 after")
        self.check_quiet(url)

    def test_the_story_stands_beside_the_picture(self):
        url = self.page_of("a.csv", falling(2), 1)
        text = self.page.evaluate("document.querySelector('aside').innerText")
        for part in ("Contact, crossing, first at", "0x1p-1", "The coplanarity cubic V(t)", "they touch", "+ positive"):
            self.assertIn(part, text)
        marks = self.page.evaluate("[...document.querySelectorAll('.chip')].map((c) => c.title)")
        self.assertEqual(marks, ["start: t = 0", "root 1 of V: t = 0x1p-1", "first contact: t = 0x1p-1", "t_max: t = 1"])
        ticks = self.page.evaluate("[...document.querySelectorAll('.tick')].map((c) => parseFloat(c.style.left))")
        self.assertEqual(ticks, [0, 50, 50, 100])
        self.check_quiet(url)

    def distance_at_meeting(self, end, truth):
        """The zoom of the button, and the least distance in pixels of the two elements there."""
        url = self.page_of("a.csv", falling(end), truth)
        self.page.click_on("[...document.querySelectorAll('button')].find((b) => b.textContent === 'Meeting')")
        zoom = self.page.evaluate("window.touchstoneViewer.zoom")
        rows = self.page.pixels(CANVAS)
        self.check_quiet(url)
        text = "".join(rows)
        self.assertGreater(text.count("a"), 300)
        self.assertGreater(text.count("b"), 300)
        # The pixels of a that are nearest to one of b.
        near = [[(x, y) for y in range(0, len(rows), 2) for x in range(0, len(rows[y]), 2) if rows[y][x] == c]
                for c in "ab"]
        distance = min((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2 for p in near[0][::3] for q in near[1][::3]) ** 0.5
        return zoom, distance

    def test_a_miss_of_one_ulp_is_seen(self):
        zoom, miss = self.distance_at_meeting(ONE_ULP_SHORT, 0)
        self.assertGreaterEqual(zoom, 48)
        self.assertGreater(miss, 12)
        zoom, touch = self.distance_at_meeting(1, 1)
        self.assertGreaterEqual(zoom, 48)
        self.assertLess(touch, 12)

    def test_the_miss_says_how_far(self):
        self.page_of("a.csv", falling(ONE_ULP_SHORT), 0)
        self.assertIn("at the closest approach; the marked points are 1.1e-16 apart", self.readout())

    def test_elements_that_coincide_are_both_seen(self):
        self.page_of("a.csv", 4 * [(-1, 0, 0), (1, 0, 0)], 1)
        text = "".join(self.page.pixels(CANVAS))
        self.assertGreater(text.count("a"), 100)
        self.assertGreater(text.count("b"), 100)

    def test_names_are_text(self):
        name = "<script>window.hacked=1<!--<img src=x onerror=hacked=1>&amp;'\".csv"
        url = self.page_of(name, falling(2), 1)
        self.assertIsNone(self.page.evaluate("window.hacked || null"))
        self.assertIn(name, self.page.evaluate("document.querySelector('h1').textContent"))
        self.assertIn(name, self.page.evaluate("document.title"))
        self.assertEqual(self.page.evaluate("document.querySelectorAll('img').length"), 0)
        self.check_quiet(url)

    def test_the_command_of_the_page_repeats_it_whatever_the_name(self):
        os.makedirs(self.path("<"), exist_ok=True)
        for name in ("a.csv", "</script><b>'\"$(touch x)`&\\.csv", "-two\nlines\t.csv"):
            file = self.write(name, rows_of(falling(2), 1))
            out = self.path("page's.html")
            self.run_program("view", "--query", "0", "--kind", "edge-edge", "--out=" + out, file)
            self.page.requests.clear()
            url = self.page.open(out)
            self.assertEqual(self.page.evaluate("document.querySelectorAll('header b').length"), 0)
            self.assertEqual(self.text("header p"), "Edge a and edge b touch first at t = 0.5.")
            self.check_quiet(url)
            self.repeat_command(out)
        self.assertFalse(os.path.exists("x"))

    def test_it_plays_to_the_contact_and_rests_there(self):
        self.page.window(1280, 720, moves=True)
        url = self.page_of("a.csv", falling(2), 1)
        self.page.evaluate("""window.seen = new Set(), setInterval(() => seen.add(touchstoneViewer.s), 10)""")
        self.page.wait("!touchstoneViewer.timeline.playing")
        self.assertIn("t = 0.5, at the contact", self.readout())
        self.assertGreater(self.page.evaluate("seen.size"), 1)
        self.page.evaluate("%s.focus()" % CANVAS)
        self.page.key(" ")  # and from there to the end
        self.page.wait("!touchstoneViewer.timeline.playing")
        self.assertIn("t = 1, ", self.readout())
        self.check_quiet(url)

    def test_the_address_keeps_the_view(self):
        url = self.page_of("a.csv", falling(ONE_ULP_SHORT), 0)
        self.page.click_on("[...document.querySelectorAll('button')].find((b) => b.textContent === 'Meeting')")
        self.page.evaluate("touchstoneViewer.camera.turn(0.3, 0.2)")
        self.page.evaluate("touchstoneViewer.timeline.step(3)")
        state = "[touchstoneViewer.s, touchstoneViewer.zoom, ...touchstoneViewer.camera.basis.flat()]"
        before = self.page.evaluate(state)
        self.assertGreater(before[0], 0)
        self.page.wait("location.hash.includes('t=' + touchstoneViewer.s)")
        address = self.page.evaluate("location.href")
        self.page.command("Page.navigate", url="about:blank")
        self.page.window(1280, 720, moves=True)
        self.page.open_address(address)
        after = self.page.evaluate(state)
        self.assertEqual(after[:2], before[:2])  # to the last bit, and at rest
        for a, b in zip(before, after):
            self.assertAlmostEqual(a, b, places=6)
        self.page.command("Page.navigate", url="about:blank")
        self.page.window(1280, 720)
        self.page.open_address(url + "#t=x&zoom=NaN&from=1,2,3")
        self.assertIn("at the closest approach", self.readout())

    def test_the_picture_is_saved_with_its_words(self):
        url = self.page_of("a.csv", falling(2), 1)
        name, size, start, words = self.saved_picture()
        self.assertRegex(name, r"^query-0-of-.*a\.csv.*\.png$")
        self.assertEqual(size, self.page.evaluate("[%s.width, %s.height]" % (CANVAS, CANVAS)))
        self.assertEqual(start, "data:image/png;base64,iVBOR")
        self.assertGreater(words, 500)
        self.assertLess(words, size[0] * size[1] / 20)
        self.check_quiet(url)

    def test_a_moving_picture_alone(self):
        file, out = self.write("a.csv", rows_of(falling(2), 1)), self.path("a.svg")
        self.run_program("view", "--query", "0", "--kind", "edge-edge", "--svg", out, file)
        seen = set()
        shown = "[...document.querySelectorAll('.f')].filter((f) => getComputedStyle(f).visibility === 'visible')"
        for dark in (False, True):
            self.page.window(640, 400, dark=dark)
            self.page.open(out)
            # Where nothing moves by itself, the contact alone is shown.
            self.assertEqual(self.page.evaluate(shown + ".map((f) => f.getAttribute('class'))"), ["f s"])
            colours = ("[...document.querySelectorAll('.paper, .s .a')].map((e) => getComputedStyle(e).fill).join()")
            seen.add(self.page.evaluate(colours))
        self.assertEqual(len(seen), 2)
        self.assertEqual(self.page.evaluate("[...document.querySelectorAll('.s text')].map((t) => t.textContent)"),
                         ["a0", "a1", "b0", "b1"])
        self.page.window(640, 400, moves=True)
        self.page.open(out)
        seen = set()
        end = time.monotonic() + 60
        while len(seen) < 3 and time.monotonic() < end:
            frames = self.page.evaluate(shown + ".map((f) => [...f.parentNode.children].indexOf(f))")
            self.assertLessEqual(len(frames), 1)
            seen.update(frames)
        self.assertGreaterEqual(len(seen), 3)

    def test_dragging_turns_and_the_wheel_zooms(self):
        url = self.page_of("a.csv", falling(2), 1)
        before = self.page.pixels(CANVAS)
        self.page.drag((400, 300), (520, 340))
        self.assertNotEqual(before, self.page.pixels(CANVAS))
        self.page.command("Input.dispatchMouseEvent", type="mouseWheel", x=400, y=300, deltaX=0, deltaY=-400)
        self.page.wait("window.touchstoneViewer.zoom > 0")
        self.check_quiet(url)

    def test_a_telephone_and_the_dark(self):
        self.page.window(390, 844, dark=True, touch=True)
        url = self.page_of("a.csv", falling(2), 1)
        self.assertLessEqual(self.page.evaluate("document.documentElement.scrollWidth"), 390)
        background = self.page.evaluate("getComputedStyle(document.body).backgroundColor")
        self.assertEqual(background, "rgb(20, 23, 27)")
        text = "".join(self.page.pixels(CANVAS))
        self.assertGreater(text.count("a"), 100)
        self.assertGreater(text.count("b"), 100)
        self.check_quiet(url)

    def test_fingers_turn_and_zoom(self):
        self.page.window(390, 844, touch=True)
        url = self.page_of("a.csv", falling(2), 1)
        basis = "JSON.stringify(window.touchstoneViewer.camera.basis)"
        before = self.page.evaluate(basis)
        self.page.touch([(200, 300)], [(230, 310)], [(260, 320)])
        turned = self.page.evaluate(basis)
        self.assertNotEqual(before, turned)
        self.assertEqual(self.page.evaluate("window.touchstoneViewer.zoom"), 0)
        self.page.touch([(180, 300), (210, 300)], [(120, 300), (270, 300)], [(80, 300), (320, 300)])
        zoom = self.page.evaluate("window.touchstoneViewer.zoom")
        self.assertAlmostEqual(zoom, 3, delta=0.01)  # the fingers are 8 times as far apart
        self.assertEqual(self.page.evaluate(basis), turned)
        self.assertEqual(self.page.evaluate("[window.scrollY, window.visualViewport.scale]"), [0, 1])
        self.check_quiet(url)

    def test_without_webgl_the_still_picture_stays(self):
        self.page_of("a.csv", falling(2), 1)
        with browser.Browser("--disable-3d-apis") as plain:
            plain.window(1280, 720)
            plain.open(self.path("page.html"))
            self.assertGreater(plain.evaluate("document.querySelector('svg.still').getBoundingClientRect().width"), 300)
            self.assertIn("no WebGL 2", plain.evaluate("document.querySelector('.note:last-child').textContent"))
            self.assertIn("Contact, crossing", plain.evaluate("document.querySelector('aside').innerText"))

    def test_every_kind_and_curves_are_drawn(self):
        bundled = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../src/cli/queries")
        for kind in ("vertex-face", "point-edge", "point-point"):
            with self.subTest(kind):
                file = os.path.join(bundled, kind, sorted(os.listdir(os.path.join(bundled, kind)))[0])
                self.run_program("view", "--query", "1", "--out", self.path("page.html"), file)
                self.page.requests.clear()
                url = self.page.open(self.path("page.html"))
                text = "".join(self.page.pixels(CANVAS))
                self.assertGreater(text.count("b"), 30)
                self.check_quiet(url)


    def test_findings_are_cards_that_move(self):
        out = self.path("findings.html")
        text = self.run_program("fuzz", "--solver", "paper", "--cases", "2000", "--findings", "4", "--threads", "1",
                                "--html", out)
        url = self.page.open(out)
        cards = self.page.evaluate("""[...document.querySelectorAll('.card')].map((c) => [c.querySelector('h2').textContent,
            c.querySelector('.claim').textContent, c.querySelector('.truth').textContent,
            c.querySelector('.command').textContent])""")
        self.assertEqual(len(cards), 4)
        for heading, claim, truth, command in cards:
            self.assertIn("\n" + heading.split(",")[0], text)
            self.assertIn("claim: " + claim, text)
            self.assertIn("exact: " + truth, text)
            self.assertIn(command, text)
        self.assertEqual(self.page.evaluate("document.querySelectorAll('canvas').length"), 0)
        for card in (0, 1):  # the second takes the place of the first
            self.page.click_on("document.querySelectorAll('.mover')[%d]" % card)
            self.assertEqual(self.page.evaluate("document.querySelectorAll('canvas').length"), 1)
            self.assertIn("b", "".join(self.page.pixels(CANVAS)))
        self.check_quiet(url)


if __name__ == "__main__":
    unittest.main(verbosity=1)
