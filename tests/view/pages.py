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

    def saved_picture(self):
        """Presses the key that saves a picture. Returns the file's name, the size of the picture, the start of the
        file, and how many pixels differ from the canvas, which has no words."""
        return self.page.evaluate("""(() => {
          const canvas = document.querySelector('.stage canvas'), {prototype} = HTMLCanvasElement;
          const toDataURL = prototype.toDataURL;
          let link = null, paper = null;
          HTMLAnchorElement.prototype.click = function() { link = this; };
          prototype.toDataURL = function(type) { paper = this; return toDataURL.call(this, type); };
          canvas.dispatchEvent(new KeyboardEvent('keydown', {key: 's'}));
          prototype.toDataURL = toDataURL;
          const plain = element('canvas', {width: canvas.width, height: canvas.height});
          const context = plain.getContext('2d');
          context.fillStyle = getComputedStyle(document.body).backgroundColor;
          context.fillRect(0, 0, plain.width, plain.height);
          context.drawImage(canvas, 0, 0);
          const of = (c) => c.getContext('2d').getImageData(0, 0, plain.width, plain.height).data;
          const a = of(plain), b = of(paper);
          const differ = a.filter((x, i) => x !== b[i]).length;
          return [link.download, [paper.width, paper.height], link.href.slice(0, 27), differ];
        })()""")

    def repeat_command(self, *outputs):
        """Runs the command that the page names in a shell, as a reader would, and checks that it makes these files
        again."""
        before = [self.read(path) for path in outputs]
        for path in outputs:
            os.remove(path)
        command = self.page.evaluate("document.querySelector('header .command').textContent")
        tools = self.path("tools")
        os.makedirs(tools, exist_ok=True)
        if not os.path.exists(os.path.join(tools, "touchstone")):
            os.symlink(os.path.abspath(PROGRAM), os.path.join(tools, "touchstone"))
        environment = dict(os.environ, PATH=tools + os.pathsep + os.environ["PATH"])
        done = subprocess.run(["bash", "-c", command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False,
                              env=environment)
        self.assertIn(done.returncode, (0, 1), (command, done.stderr))
        self.assertEqual([self.read(path) for path in outputs], before)

    def read(self, path):
        with open(path, "rb") as file:
            return file.read()

    def check_quiet(self, url):
        """No error was printed, and the only request was for the page itself."""
        self.assertEqual(self.page.messages, [])
        self.assertEqual(self.page.requests, [url])

    def text(self, selector):
        return self.page.evaluate("document.querySelector(%r).innerText" % selector)

    def box(self, selector):
        return self.page.evaluate("(() => { const b = document.querySelector(%r).getBoundingClientRect(); return "
                                  "[b.left, b.top, b.width, b.height]; })()" % selector)
