"""The page that answers queries without a network, in a real browser: its bytes are those of the native program.
SPDX-License-Identifier: MIT

  test_page.py TOUCHSTONE PAGE.html QUERIES
"""
import glob
import json
import os
import sys
import unittest

PAGE, QUERIES = sys.argv.pop(2), sys.argv.pop(2)
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "view"))
import pages  # noqa: E402


class AnsweringPage(pages.Pages):
    def rows(self):
        return self.page.evaluate("[...document.querySelectorAll('#answers tbody tr')].map((r) => [...r.cells].map((c) => "
                                  "c.textContent).join())")

    def native(self, path, *arguments):
        """The answers without the column of the file."""
        lines = self.run_program("solve", *arguments, path).splitlines()[1:]
        return [line[len(path) + 1:] for line in lines]

    def ask(self, kind, text):
        self.page.evaluate("document.querySelector('#kind').value = %s, document.querySelector('#text').value = %s, "
                           "solve().then(() => 0)" % (json.dumps(kind), json.dumps(text)))

    def test_it_begins_with_an_answered_example_and_its_picture(self):
        url = self.page.open(PAGE)
        self.page.wait("document.querySelector('#picture').srcdoc !== ''")
        given = self.write("given.csv", self.page.evaluate("document.querySelector('#text').value"))
        self.assertEqual(self.rows(), self.native(given, "--kind", "edge-edge"))
        self.assertEqual(len(self.rows()), 1)
        self.assertIn("1 query: 1 with contact.", self.text("#said"))
        self.assertEqual(self.text("#command"), "touchstone solve edge-edge/queries.csv\n"
                         "touchstone view --query 0 --out page.html edge-edge/queries.csv")
        requests = [each for each in self.page.requests if each != url and not each.startswith("about:srcdoc")]
        self.assertEqual((self.page.messages, requests), ([], []))

    def test_every_bundled_query_has_the_native_answer(self):
        self.page.open(PAGE)
        self.page.wait("document.querySelector('#picture').srcdoc !== ''")
        compared = 0
        for path in sorted(glob.glob(os.path.join(QUERIES, "*", "*.csv"))):
            kind = os.path.basename(os.path.dirname(path))
            with open(path, encoding="utf-8") as file:
                self.ask(kind, file.read())
            self.assertEqual(self.rows(), self.native(path), path)
            compared += len(self.rows())
        self.assertGreater(compared, 800)
        self.assertEqual(self.page.messages, [])

    def test_the_proofs_are_those_of_the_program(self):
        self.page.open(PAGE)
        path = os.path.join(QUERIES, "vertex-face", "grazing.csv")
        with open(path, encoding="utf-8") as file:
            self.ask("vertex-face", file.read())
        proofs = self.page.evaluate("run(form(), 'prove').then((result) => text(result.out))")
        self.assertEqual(proofs.replace("queries.csv", "grazing.csv"),
                         self.run_program("prove", path).replace(path, "vertex-face/grazing.csv"))

    def test_a_mistake_is_named_and_the_next_question_is_answered(self):
        self.page.open(PAGE)
        self.ask("point-point", "0,0\n")
        self.assertIn("queries.csv", self.text("#said"))
        self.assertEqual(self.rows(), [])
        self.ask("point-point", "0,0,0\n1,0,0\n1,0,0\n1,0,0\n")
        self.assertEqual(len(self.rows()), 1)
        self.assertEqual(self.rows()[0].split(",")[1:4], ["1", "1", "1"])

    def test_a_picture_is_of_the_answers_beside_it_and_clears_an_error(self):
        self.page.open(PAGE)
        self.ask("point-point", "0,0,0\n1,0,0\n1,0,0\n1,0,0\n")
        self.page.evaluate("document.querySelector('#text').value = 'edited since', say('an error', true), show(0)"
                           ".then(() => 0)")
        self.assertIn("1 query: 1 with contact.", self.text("#said"))
        self.assertIn("point-point", self.page.evaluate("document.querySelector('#picture').srcdoc"))
        self.assertFalse(self.page.evaluate("document.querySelector('#picture').hidden"))

    def test_a_file_that_is_no_text_is_asked_as_it_is(self):
        self.page.open(PAGE)
        path = self.write("given.csv", "0,0,0\n1,0,0\n1,0,0\n1,0,0\n")
        binary = os.path.join(os.path.dirname(path), "given.tsq")
        self.run_program("convert", path, binary, "--claims", "drop", "--kind", "point-point")
        with open(binary, "rb") as file:
            data = list(file.read())
        self.page.evaluate("document.querySelector('#kind').value = 'point-point', "
                           "give(new Uint8Array(%s), 'given.tsq'), solve().then(() => 0)" % json.dumps(data))
        self.assertEqual(self.rows(), self.native(path, "--kind", "point-point"))
        self.assertIn("given.tsq: %d bytes" % len(data), self.page.evaluate("document.querySelector('#text').value"))

    def test_it_fits_a_narrow_window(self):
        self.page.window(500, 800, dark=True)
        self.page.open(PAGE)
        self.page.wait("document.querySelector('#picture').srcdoc !== ''")
        self.assertLessEqual(self.page.evaluate("document.documentElement.scrollWidth"), 500)


if __name__ == "__main__":
    unittest.main()
