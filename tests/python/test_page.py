"""The programs of docs/python.md, with the output that the page shows. SPDX-License-Identifier: MIT"""
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

PAGE = Path(__file__).parents[2] / "docs/python.md"


def test_the_programs_print_what_the_page_shows(tmp_path):
    program = os.environ.get("TOUCHSTONE_PROGRAM")
    if not program:
        pytest.skip("the program is not built, and touchstone-check with it")
    environment = dict(os.environ, TOUCHSTONE_CHECK=str(Path(program).with_name("touchstone-check")))
    text = PAGE.read_text()
    programs = re.findall(r"^```py ~/python/(\w+\.py)\n(.*?)^```$", text, re.M | re.S)
    runs = re.findall(r"^```sh\n((?:python3 ~/python/\w+\.py\n)+)```\n\n```text\n(.*?)^```$", text, re.M | re.S)
    assert len(programs) == 10
    ran = []
    for commands, shown in runs:
        printed = ""
        for name in re.findall(r"~/python/(\w+\.py)", commands):
            path = tmp_path / name
            path.write_text(dict(programs)[name])
            done = subprocess.run([sys.executable, path], capture_output=True, text=True, env=environment, cwd=tmp_path)
            assert done.returncode == 0, done.stderr
            printed += done.stdout
            ran.append(name)
        assert printed == shown
    assert (tmp_path / "refuted.html").read_text(encoding="utf-8").count('<article class="card">') == 32
    assert sorted(ran) == sorted(name for name, _ in programs)


def test_the_line_search_has_about_twenty_lines():
    program = re.search(r"^```py ~/python/line_search.py\n(.*?)^```$", PAGE.read_text(), re.M | re.S).group(1)
    assert len(program.splitlines()) <= 22
