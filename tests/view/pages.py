"""What the tests of pages in a browser share. SPDX-License-Identifier: MIT"""
import os
import subprocess
import sys
import tempfile
import unittest

import browser

PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 else "touchstone"


class Pages(unittest.TestCase):
    """A folder and a browser. Each test begins with a window of 1280 x 720, and nothing heard yet."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.browser = browser.Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.folder.cleanup()

    def setUp(self):
        self.page = self.browser
        self.page.messages.clear()
        self.page.requests.clear()
        self.page.window(1280, 720)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def run_program(self, *arguments):
        done = subprocess.run([PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return done.stdout.decode()

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def check_quiet(self, url):
        """No error was printed, and the only request was for the page itself."""
        self.assertEqual(self.page.messages, [])
        self.assertEqual(self.page.requests, [url])

    def text(self, selector):
        return self.page.evaluate("document.querySelector(%r).innerText" % selector)

    def box(self, selector):
        return self.page.evaluate("(() => { const b = document.querySelector(%r).getBoundingClientRect(); return "
                                  "[b.left, b.top, b.width, b.height]; })()" % selector)
