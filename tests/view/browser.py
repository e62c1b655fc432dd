"""A headless chromium that is driven through the DevTools protocol over a pipe, with Python's standard library alone.
SPDX-License-Identifier: MIT
"""
import base64
import json
import os
import select
import shutil
import subprocess
import tempfile
import time


def find():
    """The browser's program, or None."""
    for name in ("chromium", "chromium-browser", "google-chrome"):
        path = shutil.which(name)
        if path:
            return path
    return None


class Failure(Exception):
    """The browser ended, or does not answer."""


class Browser:
    """One browser with one page. What the page prints, throws and requests is kept."""

    def __init__(self, *arguments):
        self.folder = tempfile.mkdtemp(prefix="touchstone-browser-")
        to_browser, self.to = os.pipe()
        self.back, from_browser = os.pipe()
        switches = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--remote-debugging-pipe",
                    "--user-data-dir=" + self.folder, "--no-first-run", "--disable-background-networking",
                    "--disable-component-update", "--disable-sync", "--use-angle=swiftshader",
                    "--enable-unsafe-swiftshader", "--hide-scrollbars", *arguments, "about:blank"]
        # The protocol's pipes are the descriptors 3 and 4.
        script = 'exec "$0" "$@" 3<&%d 4>&%d' % (to_browser, from_browser)
        self.process = subprocess.Popen(["bash", "-c", script, find(), *switches], pass_fds=(to_browser, from_browser),
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.pending = b""
        self.number = 0
        self.messages, self.requests = [], []
        self.session = None
        target = [t for t in self.command("Target.getTargets")["targetInfos"] if t["type"] == "page"][0]["targetId"]
        self.session = self.command("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.command(domain + ".enable")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        os.close(self.to)
        os.close(self.back)
        shutil.rmtree(self.folder, ignore_errors=True)

    def _receive(self, seconds):
        end = time.monotonic() + seconds
        while b"\0" not in self.pending:
            ready, _, _ = select.select([self.back], [], [], max(0, end - time.monotonic()))
            if not ready:
                raise Failure("no answer of the browser within %g s" % seconds)
            piece = os.read(self.back, 1 << 20)
            if not piece:
                raise Failure("the browser has ended")
            self.pending += piece
        text, self.pending = self.pending.split(b"\0", 1)
        return json.loads(text)

    def _note(self, message):
        method, params = message.get("method"), message.get("params", {})
        if method == "Runtime.consoleAPICalled" and params["type"] in ("error", "warning", "assert"):
            self.messages.append(json.dumps(params["args"]))
        elif method == "Runtime.exceptionThrown":
            self.messages.append(json.dumps(params["exceptionDetails"]))
        elif method == "Log.entryAdded" and params["entry"]["level"] in ("error", "warning"):
            if "GPU stall due to ReadPixels" not in params["entry"]["text"]:  # of the driver in software
                self.messages.append(params["entry"]["text"])
        elif method == "Network.requestWillBeSent":
            self.requests.append(params["request"]["url"])

    def command(self, method, seconds=120, **params):
        """Sends one command. Returns its result."""
        self.number += 1
        message = {"id": self.number, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.to, data):]
        while True:
            answer = self._receive(seconds)
            if answer.get("id") != self.number:
                self._note(answer)
            elif "error" in answer:
                raise Failure("%s: %s" % (method, answer["error"]["message"]))
            else:
                return answer["result"]

    def window(self, width, height, dark=False, touch=False, moves=False):
        """The size of the page, its colours, whether it is touched by fingers, and whether pages may play by
        themselves."""
        self.command("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=touch)
        self.command("Emulation.setTouchEmulationEnabled", enabled=touch)
        self.command("Emulation.setEmulatedMedia",
                     features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"},
                               {"name": "prefers-reduced-motion", "value": "no-preference" if moves else "reduce"}])

    def open(self, path):
        """Opens a file and waits until its scripts have run."""
        from urllib.parse import quote
        return self.open_address("file://" + quote(os.path.abspath(path)))

    def open_address(self, url):
        self.command("Page.navigate", url=url)
        self.wait("document.readyState === 'complete' && location.href !== 'about:blank'")
        return url

    def evaluate(self, expression):
        """The value of an expression of the page, as JSON."""
        result = self.command("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise Failure("%s: %s" % (expression, json.dumps(result["exceptionDetails"])[:600]))
        return result["result"].get("value")

    def wait(self, expression, seconds=60):
        """Waits until an expression is true."""
        end = time.monotonic() + seconds
        while not self.evaluate(expression):
            if time.monotonic() > end:
                raise Failure("not true within %g s: %s" % (seconds, expression))
            time.sleep(0.05)

    def click(self, x, y):
        for kind in ("mousePressed", "mouseReleased"):
            self.command("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def click_on(self, expression):
        """Clicks in the middle of the element of an expression."""
        self.evaluate("(%s).scrollIntoView({block: 'nearest'})" % expression)
        box = self.evaluate("(() => { const b = (%s).getBoundingClientRect(); return [b.x + b.width / 2, "
                            "b.y + b.height / 2]; })()" % expression)
        self.click(*box)

    def drag(self, start, end):
        self.command("Input.dispatchMouseEvent", type="mousePressed", x=start[0], y=start[1], button="left",
                     buttons=1, clickCount=1)
        for i in range(1, 6):
            self.command("Input.dispatchMouseEvent", type="mouseMoved", x=start[0] + (end[0] - start[0]) * i / 5,
                         y=start[1] + (end[1] - start[1]) * i / 5, button="left", buttons=1)
        self.command("Input.dispatchMouseEvent", type="mouseReleased", x=end[0], y=end[1], button="left", clickCount=1)

    def touch(self, *steps):
        """Fingers on the page: each step has the place of every finger, and each finger stays until the last step."""
        points = [[{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(step)] for step in steps]
        self.command("Input.dispatchTouchEvent", type="touchStart", touchPoints=points[0])
        for step in points[1:]:
            self.command("Input.dispatchTouchEvent", type="touchMove", touchPoints=step)
        self.command("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def key(self, key, text=""):
        self.command("Input.dispatchKeyEvent", type="keyDown", key=key, text=text)
        self.command("Input.dispatchKeyEvent", type="keyUp", key=key)

    def screenshot(self, path):
        data = self.command("Page.captureScreenshot", format="png")["data"]
        with open(path, "wb") as file:
            file.write(base64.b64decode(data))

    def pixels(self, canvas):
        """The canvas of an expression as rows of '.', 'a', 'b' and 'x': nothing, near the colours of the elements, and
        anything else."""
        return self.evaluate("""(() => {
          const from = %s, to = document.createElement('canvas');
          to.width = from.width; to.height = from.height;
          const context = to.getContext('2d');
          context.drawImage(from, 0, 0);
          const data = context.getImageData(0, 0, to.width, to.height).data;
          const colours = ['--a', '--b'].map((name) => colourOf(name).map((x) => x * 255));
          const near = (i, c) => Math.abs(data[i] - c[0]) + Math.abs(data[i + 1] - c[1]) + Math.abs(data[i + 2] - c[2]) < 90;
          const rows = [];
          for (let y = 0; y < to.height; ++y) {
            let row = '';
            for (let x = 0; x < to.width; ++x) {
              const i = 4 * (y * to.width + x);
              row += data[i + 3] < 100 ? '.' : near(i, colours[0]) ? 'a' : near(i, colours[1]) ? 'b' : 'x';
            }
            rows.push(row);
          }
          return rows;
        })()""" % canvas)
