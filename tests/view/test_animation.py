"""The page of an animation in a real browser: it is scrubbed, clicked and read, and its pixels are compared.
SPDX-License-Identifier: MIT

  test_animation.py TOUCHSTONE
"""
import array
import json
import math
import sys
import unittest

import browser
import pages

CANVAS = "document.querySelector('.stage canvas')"
VIEWER = "window.touchstoneAnimation"
NAME = "<script>window.hacked=1</script><img src=x onerror=hacked=1>&amp;"


def scene(name, **more):
    """A triangle that does not move, and an edge that falls on it from 1 m."""
    particles = [{"position": p, "pinned": True} for p in ((-1, -1, 0), (1, -1, 0), (0, 1, 0))]
    particles += [{"position": p, "mass": 1} for p in ((-0.2, 0, 1), (0.2, 0, 1))]
    return json.dumps({
        "touchstone_scene": 1, "name": name, "particles": particles, "faces": [[0, 1, 2]],
        "springs": [{"particles": [3, 4], "stiffness": 1000}],
        "settings": {"time_step": 0.01, "duration": 0.6, "contact": {"restitution": 0.5}}, **more})


def body_scene():
    """A tetrahedron that falls and turns."""
    return json.dumps({
        "touchstone_scene": 1, "name": "bodies", "particles": [],
        "bodies": [{"vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
                    "faces": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], "density": 1000, "position": [0, 0, 1],
                    "angular_velocity": [2, 1, 0]}],
        "settings": {"time_step": 0.01, "duration": 0.3}})


def obj(height, tip=0.25, group="floor"):
    """A triangle on the floor, and one whose tip is at a height above it."""
    return ("v -1 -1 0\nv 1 -1 0\nv 0 1 0\nv 0 0 %r\nv 0.1 0.5 %r\nv -0.1 0.5 %r\ng %s\nf 1 2 3\ng tent\nf 4 5 6\n" %
            (tip + height, height + 1, height + 1, group))


def npy(code, shape, numbers):
    """A file of NumPy's format with an array of 'd', doubles, or 'i', integers of 32 bits."""
    kind = {"d": "<f8", "i": "<i4"}[code]
    header = "{'descr': '%s', 'fortran_order': False, 'shape': (%s,), }" % (kind, ", ".join(map(str, shape)))
    header += " " * (63 - (len(header) + 10) % 64) + "\n"
    values = array.array(code, numbers)
    if sys.byteorder == "big":
        values.byteswap()
    return b"\x93NUMPY\x01\x00" + len(header).to_bytes(2, "little") + header.encode() + values.tobytes()


class Animations(pages.Pages):
    def page_of(self, text, *arguments):
        """The page of a scene."""
        out = self.path("page.html")
        self.summary = self.run_program("simulate", self.write("scene.json", text), "--html", out, *arguments)
        self.page.requests.clear()
        return self.page.open(out)

    def page_of_frames(self, texts, *arguments, name="frame"):
        out = self.path("page.html")
        files = [self.write("%s-%d.obj" % (name, i), text) for i, text in enumerate(texts)]
        self.summary = self.run_program("mesh", "--html", out, *arguments, *files)
        self.page.requests.clear()
        return self.page.open(out)

    def readout(self):
        return self.page.evaluate("document.querySelector('.readout').textContent")

    def pixels(self):
        """The picture, one character a pixel: '.' for nothing."""
        return "".join(self.page.pixels(CANVAS))

    def place(self, vertex):
        """Where a vertex is on the screen."""
        return self.page.evaluate("""(() => {
          const v = %s, view = v.view(), box = v.node.getBoundingClientRect();
          const at = v.frames.place(%d, v.frames.around(v.s));
          const p = v.camera.seen(at.map((x, k) => (x - view.centre[k]) * view.pixels));
          return [box.left + box.width / 2 + p[0] + view.pan[0], box.top + box.height / 2 - p[1] - view.pan[1]];
        })()""" % (VIEWER, vertex))

    def test_scrubbing_moves_the_picture_the_plots_and_the_words(self):
        url = self.page_of(scene("fall"))
        # It opens at the first contact. An edge falls 1 m in 0.45 s.
        self.assertRegex(self.readout(), r"^step 4\d, 0\.4\d+ s\. Marks near this time: .*contact \d+")
        self.page.evaluate("%s.focus()" % CANVAS)
        self.page.key("Home")
        self.assertTrue(self.readout().startswith("step 0, 0 s. Marks: none."))
        seen = {self.pixels()}
        left, top, width, height = self.box(".timeline input")
        self.page.click(left + width / 2, top + height / 2)
        self.assertRegex(self.readout(), r"^step (30|31), 0\.30?\d* s\.")
        seen.add(self.pixels())
        cursor = float(self.page.evaluate("document.querySelector('.cursor').getAttribute('x1')"))
        self.assertAlmostEqual(cursor, 500, delta=20)
        left, top, width, height = self.box(".plot")
        self.page.click(left + width * 0.75, top + height / 2)
        self.assertRegex(self.readout(), r"^step 4[56], 0\.4[45]\d* s\.")
        seen.add(self.pixels())
        self.assertEqual(len(seen), 3)
        self.page.evaluate("%s.focus()" % CANVAS)
        self.page.key("Home")
        self.page.key("ArrowRight")
        self.assertTrue(self.readout().startswith("step 1, 0.01 s."))
        self.page.key("End")
        self.assertTrue(self.readout().startswith("step 60, 0.6 s."))
        energies = self.page.evaluate("[...document.querySelectorAll('.key')].slice(0, 2).map((k) => k.innerText)")
        self.assertRegex(energies[0], r"^total [\d.\u2212e-]+$")
        self.check_quiet(url)

    def test_the_contact_is_marked_listed_and_told(self):
        url = self.page_of(scene("fall"))
        self.assertIn("0 crossings", self.text("aside"))
        stories = self.page.evaluate("document.querySelectorAll('.events li').length")
        self.assertGreater(stories, 0)
        self.assertGreater(self.page.evaluate("document.querySelectorAll('.tick.contact').length"), 1)
        self.page.click_on("document.querySelector('.events button')")
        # An edge falls 1 m in 0.45 s.
        self.assertRegex(self.readout(), r"^step 4\d, 0\.4\d+ s\. Marks near this time: .*contact \d+")
        told = self.text(".picked")
        for part in ("Exact coordinates", "0x1p+0", "Marks of this pair", "would have touched"):
            self.assertIn(part, told)
        # The mark is in the middle of the view, and has its colour.
        middle = self.page.evaluate("""(() => {
          const from = %s, to = document.createElement('canvas');
          to.width = from.width; to.height = from.height;
          const context = to.getContext('2d');
          context.drawImage(from, 0, 0);
          const p = context.getImageData(from.width / 2, from.height / 2, 1, 1).data;
          return [p, colourOf('--mark').map((x) => Math.round(255 * x))].map((c) => Array.from(c).slice(0, 3));
        })()""" % CANVAS)
        self.assertLess(sum(abs(a - b) for a, b in zip(*middle)), 60)
        self.check_quiet(url)

    def test_a_click_tells_the_number_and_the_exact_coordinates(self):
        url = self.page_of(scene("fall"))
        self.page.evaluate("%s.timeline.go(0)" % VIEWER)
        self.page.evaluate("%s.zoomTo(-1)" % VIEWER)
        corners = [self.place(v) for v in range(3)]
        middle = [sum(c[k] for c in corners) / 3 for k in (0, 1)]
        blue = self.pixels().count("a")
        self.page.click(*middle)
        told = self.text(".picked")
        self.assertIn("face 0", told)
        self.assertIn("-0x1p+0 -0x1p+0 0x0p+0", told)
        self.assertIn("Exact coordinates at step 0", told)
        self.assertGreater(self.pixels().count("a"), blue + 500)  # it is highlighted
        ends = [self.place(v) for v in (3, 4)]
        self.page.click(ends[0][0] * 0.3 + ends[1][0] * 0.7, ends[0][1] * 0.3 + ends[1][1] * 0.7)
        self.assertTrue(self.text(".picked").startswith("edge "), self.text(".picked"))
        self.assertIn("0x1p+0", self.text(".picked"))
        self.page.evaluate("%s.timeline.go(%s.data.times[20])" % (VIEWER, VIEWER))
        self.assertIn("Exact coordinates at step 20", self.text(".picked"))
        self.page.evaluate("%s.focus()" % CANVAS)
        self.page.key("Escape")
        self.assertTrue(self.page.evaluate("document.querySelector('.picked').hidden"))
        self.check_quiet(url)

    def mark_pixels(self):
        """How many pixels of the picture have the colour of marks."""
        self.page.evaluate("%s.draw()" % VIEWER)
        return self.page.evaluate("""(() => {
          const from = %s, to = document.createElement('canvas');
          to.width = from.width; to.height = from.height;
          const context = to.getContext('2d');
          context.drawImage(from, 0, 0);
          const data = context.getImageData(0, 0, to.width, to.height).data, c = colourOf('--mark').map((x) => 255 * x);
          let found = 0;
          for (let i = 0; i < data.length; i += 4) {
            found += Math.abs(data[i] - c[0]) + Math.abs(data[i + 1] - c[1]) + Math.abs(data[i + 2] - c[2]) < 30;
          }
          return found;
        })()""" % CANVAS)

    def test_marks_are_shown_near_their_time_and_can_be_hidden(self):
        url = self.page_of_frames([obj(1), obj(-1), obj(-2)])  # the tip is on the floor at t = 0.625
        mark = "%s.marks.near(%s.frames, %s.s).length" % (VIEWER, VIEWER, VIEWER)
        for time, count in ((0.5, 0), (0.55, 1), (0.625, 1), (0.7, 1), (0.75, 0), (1.5, 0)):
            self.page.evaluate("%s.timeline.go(%r)" % (VIEWER, time))
            self.assertEqual(self.page.evaluate(mark), count, time)
        self.page.evaluate("%s.timeline.go(0.625)" % VIEWER)
        self.page.evaluate("%s.camera.turn(0, 0.8)" % VIEWER)
        shown = self.mark_pixels()
        self.assertGreater(shown, 10)
        self.page.evaluate("%s.focus()" % CANVAS)
        self.page.key("x")
        self.assertEqual(self.mark_pixels(), 0)
        self.page.key("x")
        self.assertEqual(self.mark_pixels(), shown)
        self.check_quiet(url)

    def test_a_mark_behind_a_face_is_hidden(self):
        self.page_of_frames([obj(1), obj(-1)])
        self.page.evaluate("%s.camera.turn(0, 0.8)" % VIEWER)
        self.assertGreater(self.mark_pixels(), 10)  # seen from above
        self.page.evaluate("%s.whole()" % VIEWER)
        self.page.evaluate("%s.marks.points[2] -= 0.5" % VIEWER)  # below the floor
        self.page.evaluate("%s.camera.turn(0, 0.8)" % VIEWER)
        self.assertEqual(self.mark_pixels(), 0)

    def test_the_address_keeps_the_view(self):
        url = self.page_of_frames([obj(1), obj(-1)])
        self.page.evaluate("%s.timeline.go(0.25)" % VIEWER)
        self.page.evaluate("%s.zoomTo(1.5)" % VIEWER)
        self.page.evaluate("%s.camera.turn(0.7, -0.4)" % VIEWER)
        self.page.evaluate("%s.camera.turn(0.3, 0)" % VIEWER)
        self.page.evaluate("%s.draw()" % VIEWER)
        state = "[%s.s, %s.zoom, ...%s.camera.basis.flat()]" % (VIEWER, VIEWER, VIEWER)
        self.page.wait("location.hash.includes('t=0.25&zoom=1.5')")
        before, address = self.page.evaluate(state), self.page.evaluate("location.href")
        self.page.command("Page.navigate", url="about:blank")
        self.page.open_address(address)
        for a, b in zip(before, self.page.evaluate(state)):
            self.assertAlmostEqual(a, b, places=6)
        self.page.command("Page.navigate", url="about:blank")
        self.page.open_address(address.split("#")[0] + "#t=NaN&zoom=x&from=1,2,3")
        self.assertRegex(self.readout(), r"^frame 1 .*t = 0\.625\. Marks near this time: contact 1")

    def test_it_plays_to_the_first_contact_and_rests_there(self):
        self.page.window(1280, 720, moves=True)
        url = self.page_of_frames([obj(1), obj(-1)])
        self.page.evaluate("window.seen = new Set(), setInterval(() => seen.add(%s.s), 10)" % VIEWER)
        self.page.wait("!%s.timeline.playing" % VIEWER)
        self.assertRegex(self.readout(), r"^frame 1 .*t = 0\.625\. Marks near this time: contact 1")
        self.assertGreater(self.page.evaluate("seen.size"), 1)
        # Without a contact it plays to the end.
        self.page_of_frames([obj(2), obj(1)])
        self.page.wait("!%s.timeline.playing" % VIEWER)
        self.assertRegex(self.readout(), r"^frame 1 .*t = 1\. ")
        self.page.requests.clear()

    def test_the_command_of_the_page_repeats_it(self):
        url = self.page_of_frames([obj(1), obj(-1)], name="it's $HOME")
        self.assertTrue(self.text("header p").startswith("Is each step between neighbouring frames free of contact?"))
        self.check_quiet(url)
        self.repeat_command(self.path("page.html"))

    def test_the_picture_is_saved(self):
        url = self.page_of_frames([obj(1), obj(-1)])
        name, size, start, words = self.saved_picture()
        self.assertRegex(name, r"frame-0\.obj-to-.*frame-1\.obj\.png$")
        self.assertEqual(size, self.page.evaluate("[%s.width, %s.height]" % (CANVAS, CANVAS)))
        self.assertEqual(start, "data:image/png;base64,iVBOR")
        self.assertEqual(words, 0)
        self.check_quiet(url)

    def test_a_cable_is_as_thick_as_its_radius(self):
        counts = []
        for radius in (0.001, 0.05, 0.1):
            particles = [{"position": [x, 0, 0.001 * x]} for x in (-1, 0, 1)]
            cable = {"particles": [0, 1, 2], "radius": radius, "density": 1000, "stretch": 1000}
            url = self.page_of(json.dumps({"touchstone_scene": 1, "name": "cable", "particles": particles,
                                           "cables": [cable], "settings": {"time_step": 0.001, "duration": 0.002}}))
            view = self.page.evaluate("%s.view().pixels" % VIEWER)
            rows = self.page.pixels(CANVAS)
            width = len(rows[0])
            thickness = sum(row[width // 2 + width // 8] != "." for row in rows)
            counts.append(thickness)
            self.assertAlmostEqual(thickness, max(3, 2 * radius * view), delta=3 + 0.05 * thickness)
            self.check_quiet(url)
        self.assertGreater(counts[2], 1.8 * counts[1])
        self.assertGreater(counts[1], 3 * counts[0])

    def test_a_floor_at_rest_is_pale_in_the_light_and_in_the_dark(self):
        colours = []
        for dark in (False, True):
            self.page.window(1280, 720, dark=dark)
            self.page_of(scene("fall"))
            # The colour that most pixels have.
            colours.append(self.page.evaluate("""(() => {
              const from = %s, to = document.createElement('canvas'), counts = new Map();
              to.width = from.width; to.height = from.height;
              const context = to.getContext('2d');
              context.drawImage(from, 0, 0);
              const data = context.getImageData(0, 0, to.width, to.height).data;
              for (let i = 0; i < data.length; i += 4) {
                if (data[i + 3] < 255) continue;
                const colour = data.slice(i, i + 3).join();
                counts.set(colour, (counts.get(colour) || 0) + 1);
              }
              return [...counts].sort((a, b) => b[1] - a[1])[0][0].split(',').map(Number);
            })()""" % CANVAS))
        self.assertTrue(all(190 < c < 250 for c in colours[0]), colours)
        self.assertTrue(all(30 < c < 110 for c in colours[1]), colours)

    def test_names_are_text(self):
        url = self.page_of(scene(NAME))
        self.assertIsNone(self.page.evaluate("window.hacked || null"))
        self.assertIn(NAME, self.text("header"))
        self.assertEqual(self.page.evaluate("document.querySelectorAll('img').length"), 0)
        self.check_quiet(url)

    def test_bodies_turn(self):
        url = self.page_of(body_scene())
        places = [self.place(1)]
        seen = {self.pixels()}
        self.page.evaluate("%s.focus()" % CANVAS)
        self.page.key("End")
        places.append(self.place(1))
        seen.add(self.pixels())
        self.assertEqual(len(seen), 2)
        self.assertGreater(abs(places[0][1] - places[1][1]), 20)
        self.page.click(*[sum(p[k] for p in map(self.place, (0, 1, 2, 3))) / 4 for k in (0, 1)])
        self.assertRegex(self.text(".picked"), r"^(face|edge) \d of body 0")
        self.check_quiet(url)

    def test_a_crossing_has_its_exact_story(self):
        out = self.path("page.html")
        self.run_program("simulate", "hoop", "--steps", "30", "--narrow-phase", "paper", "--html", out)
        self.page.requests.clear()
        url = self.page.open(out)
        first = "document.querySelector('.events li.crossing button')"
        self.assertTrue(self.page.evaluate(first + ".textContent").startswith("crossing: step "))
        self.page.click_on(first)
        self.assertIn("crossing", self.readout())
        self.assertIn("The coplanarity cubic V(t)", self.text(".picked"))
        self.assertIn("b", self.pixels())  # the cross
        self.check_quiet(url)

    def test_frames_of_a_mesh_their_contact_and_their_intersections(self):
        url = self.page_of_frames([obj(1), obj(0.5), obj(-0.5), obj(-0.25)])
        self.assertIn("animation in ", self.summary)
        self.assertIn("frame-0.obj to frame-3.obj", self.text("h1"))
        self.assertIn("3 steps: 1 free, 2 not free", self.text("aside"))
        headings = self.page.evaluate("[...document.querySelectorAll('.events button')].map((b) => b.textContent)")
        self.assertTrue(headings[0].startswith("step 1 to 2, t = 0.75: vertex 4 of tent and face 1 (1-2-3) of floor"))
        self.assertTrue(any("pierces" in h for h in headings), headings)
        self.page.click_on("document.querySelector('.events button')")
        self.assertRegex(self.readout(), r"^frame 2 \(frame-2\.obj\), t = 1\.75\. Marks near this time: contact 1\.$")
        told = self.text(".picked")
        for part in ("vertex 4 and face 1", "0x1.8p-1", "The coplanarity cubic V(t)",
                     "start v: 0x0p+0 0x0p+0 0x1.8p-1"):
            self.assertIn(part, told)
        # At the first contact the tip is drawn on the floor.
        tip, corners = self.place(3), [self.place(v) for v in range(3)]
        self.assertAlmostEqual(tip[0], sum(c[0] for c in corners[:2]) / 4 + corners[2][0] / 2, delta=1)
        self.assertAlmostEqual(tip[1], sum(c[1] for c in corners[:2]) / 4 + corners[2][1] / 2, delta=1)
        pierced = "[...document.querySelectorAll('.events button')].find((b) => b.textContent.includes('pierces'))"
        self.page.click_on(pierced)
        self.assertTrue(self.readout().startswith("frame 2 (frame-2.obj), t = 2."), self.readout())
        self.assertIn("b", self.pixels())  # the cross
        self.check_quiet(url)

    def test_it_opens_from_a_side_that_shows_the_first_contact(self):
        turned = "%s.camera.basis[2].some((x, k) => Math.abs(x - %s.data.basis[2][k]) > 0.1)" % (VIEWER, VIEWER)
        frames = [obj(0.25), obj(-0.75)]
        self.page_of_frames(frames)
        self.page.wait("!%s.timeline.playing" % VIEWER)
        self.assertFalse(self.page.evaluate(turned))
        # A wall between the reader and the tent.
        wall = "v -2 -1.2 -1\nv 2 -1.2 -1\nv 2 -1.2 2\nv -2 -1.2 2\ng wall\nf 7 8 9\nf 7 9 10\n"
        self.page_of_frames([text + wall for text in frames])
        self.page.wait("!%s.timeline.playing" % VIEWER)
        self.assertTrue(self.page.evaluate(turned))
        self.assertGreater(self.mark_pixels(), 10)
        # The first words of the result stand out, and all of its words are there.
        result = self.page.evaluate("document.querySelector('pre.wrapped').textContent")
        first = self.page.evaluate("document.querySelector('pre.wrapped strong').textContent")
        self.assertEqual(first, "1 step: 0 free, 1 not free")
        self.assertIn("10 vertices", result)

    def test_the_first_view_holds_the_whole_scene(self):
        frames = [obj(0.25), obj(-0.75)]
        for width, height in ((1280, 720), (390, 844), (700, 500)):
            self.page.window(width, height)
            self.page_of_frames(frames)
            left, top, box_width, box_height = self.box(".stage canvas")
            self.page.evaluate("%s.focus()" % CANVAS)
            places = []
            for key in ("Home", "End"):
                self.page.key(key)
                places += [self.place(vertex) for vertex in range(6)]
            for x, y in places:
                self.assertTrue(left < x < left + box_width and top < y < top + box_height, (x, y, width, height))
            size = [(max(axis) - min(axis)) / of for axis, of in zip(zip(*places), (box_width, box_height))]
            self.assertGreater(max(size), 0.6)  # and at large
        self.page.window(1280, 720)
        # A floor that is a hundred times larger than what moves is cut off.
        self.page_of_frames([text.replace("v -1 -1 0", "v -100 -100 0").replace("v 1 -1 0", "v 100 -100 0")
                             for text in frames])
        box = self.box(".stage canvas")
        self.assertLess(self.place(0)[0], box[0])
        self.assertTrue(all(box[1] < self.place(vertex)[1] < box[1] + box[3] for vertex in (3, 4, 5)))

    def test_frames_at_rest_and_in_the_plane(self):
        flat = "v 0 0\nv 1 0\nv 0 1\nv %r 0.2\nv 3 1\nv 3 2\nf 1 2 3\nf 4 5 6\n"
        flat = flat.replace("v 0 0\n", "v 0 0 0\n").replace("v 1 0\n", "v 1 0 0\n").replace("v 0 1\n", "v 0 1 0\n")
        flat = flat.replace(" 0.2\n", " 0.2 0\n").replace("v 3 1\n", "v 3 1 0\n").replace("v 3 2\n", "v 3 2 0\n")
        url = self.page_of_frames([flat % 2, flat % 1.5, flat % 0.5], "--check")
        self.assertIn("Is each frame free of intersections?", self.text("header"))
        self.page.evaluate("%s.focus()" % CANVAS)
        self.page.key("End")
        self.assertRegex(self.readout(), r"^frame 2 \(frame-2\.obj\), t = 2\. Marks: intersection \d+\.$")
        before = self.page.evaluate("%s.camera.basis.flat()" % VIEWER)
        self.page.drag((400, 250), (460, 280))  # in the plane it moves, and does not turn
        self.assertEqual(self.page.evaluate("%s.camera.basis.flat()" % VIEWER), before)
        self.check_quiet(url)

    def page_of_arrays(self, elements, columns, frames, vertices, coordinates, dimension):
        """The page of arrays. coordinates: a list of all coordinates of all frames."""
        for name, content in (("elements.npy", npy("i", (len(elements) // columns, columns), elements)),
                              ("frames.npy", npy("d", (frames, vertices, dimension), coordinates))):
            with open(self.path(name), "wb") as file:
                file.write(content)
        out = self.path("page.html")
        self.run_program("mesh", "--topology", self.path("elements.npy"), "--html", out, self.path("frames.npy"))
        self.page.requests.clear()
        return self.page.open(out)

    def test_frames_with_two_coordinates(self):
        # Two segments cross as one moves to the right.
        before, after = ([0, 0, 0, 2, x, 1, x - 0.5, 1.5] for x in (-1, 1))
        url = self.page_of_arrays([0, 1, 2, 3], 2, 2, 4, before + after, 2)
        self.page.click_on("document.querySelector('.events button')")
        self.assertRegex(self.readout(), r"^frame 1 \(frames\.npy\[1\]\), t = 0\.5\. Marks near this time: contact 1")
        self.assertIn("edge 0-1", self.text(".picked"))
        self.check_quiet(url)

    def test_a_hundred_thousand_triangles_do_not_stall(self):
        n, frames = 225, 12
        faces = []
        for i in range(n - 1):
            for j in range(n - 1):
                v = n * i + j
                faces += [v, v + 1, v + n, v + 1, v + n + 1, v + n]
        self.assertEqual(len(faces) // 3, 100352)
        coordinates = []
        for frame in range(frames):
            for i in range(n):
                wave = math.sin(0.05 * i + 0.2 * frame)
                for j in range(n):
                    coordinates += (i / n, j / n, 0.1 * wave * math.cos(0.03 * j))
        url = self.page_of_arrays(faces, 3, frames, n * n, coordinates, 3)
        times = self.page.evaluate("""[...Array(30).keys()].map((i) => {
          const start = performance.now();
          %s.timeline.go(5 * i %% %d + 0.5);
          return performance.now() - start;
        })""" % (VIEWER, frames - 1))
        # It takes 3 ms, without the drawing itself, which the graphics card does, or here the processor.
        self.assertLess(sorted(times)[len(times) // 2], 100)
        self.page.click_on(CANVAS)
        self.assertRegex(self.text(".picked"), r"^(edge|face) \d+")
        self.assertIn("Rounded coordinates" if frames * n * n * 24 > 1 << 24 else "Exact coordinates",
                      self.text(".picked"))
        self.check_quiet(url)

    def test_names_of_files_and_groups_are_text(self):
        name = "<img src=x onerror=hacked=1>&lt;"
        url = self.page_of_frames([obj(1, group="<b>floor</b>"), obj(-0.5, group="<b>floor</b>")], name=name)
        self.assertIsNone(self.page.evaluate("window.hacked || null"))
        self.assertEqual(self.page.evaluate("document.querySelectorAll('img, aside b').length"), 0)
        self.assertIn(name, self.text("h1"))
        self.assertIn(name, self.readout())
        self.assertIn("<b>floor</b>", self.text(".events"))
        self.check_quiet(url)

    def test_a_telephone_and_the_dark(self):
        self.page.window(390, 844, dark=True, touch=True)
        url = self.page_of(scene("fall"))
        self.assertLessEqual(self.page.evaluate("document.documentElement.scrollWidth"), 390)
        self.assertEqual(self.page.evaluate("getComputedStyle(document.body).backgroundColor"), "rgb(20, 23, 27)")
        self.assertGreater(len(self.pixels().replace(".", "")), 3000)
        self.page.evaluate("document.querySelector('.timeline input').scrollIntoView()")
        left, top, width, height = self.box(".timeline input")
        touch = [{"x": left + width / 2, "y": top + height / 2}]
        self.page.command("Input.dispatchTouchEvent", type="touchStart", touchPoints=touch)
        self.page.command("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
        self.page.wait("!document.querySelector('.readout').textContent.startsWith('step 0,')")
        self.check_quiet(url)

    def test_without_webgl_the_still_picture_the_plots_and_the_text_stay(self):
        self.page_of(scene("fall"))
        with browser.Browser("--disable-3d-apis") as plain:
            plain.window(1280, 720)
            plain.open(self.path("page.html"))
            self.assertGreater(plain.evaluate("document.querySelector('svg.still').getBoundingClientRect().width"), 300)
            self.assertGreater(plain.evaluate("document.querySelector('.line').getBoundingClientRect().width"), 300)
            self.assertIn("no WebGL 2", plain.evaluate("document.querySelector('.note:last-child').textContent"))
            self.assertIn("would have touched", plain.evaluate("document.querySelector('aside').textContent"))


if __name__ == "__main__":
    unittest.main(verbosity=1)
