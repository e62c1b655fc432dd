"""pip installs the package from the sources, with the module of this build. SPDX-License-Identifier: MIT"""
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
BUILD = Path(os.environ["PYTHONPATH"]).parent


def sources():
    """All files of the project but those of builds."""
    folders = [path for path in ROOT.iterdir() if path.name != ".git" and not path.name.startswith("build")]
    return {path for folder in folders for path in [folder, *folder.rglob("*")]}


def test_pip_installs_the_package(tmp_path):
    if subprocess.run([sys.executable, "-c", "import setuptools, wheel, pip"], capture_output=True).returncode != 0:
        pytest.skip("pip, setuptools or wheel is missing (Debian: python3-pip, python3-setuptools, python3-wheel)")
    before = sources()
    target = tmp_path / "site"
    environment = dict(os.environ, TOUCHSTONE_BUILD_DIR=str(BUILD))
    done = subprocess.run([sys.executable, "-m", "pip", "install", "--no-build-isolation", "--no-deps", "--no-index",
                           "--target", target, ROOT], env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    script = """
import pathlib, touchstone as ts
assert pathlib.Path(ts.__file__).parent.parent == pathlib.Path({!r}), ts.__file__
print(ts.__version__, ts.solve("point-point", [[0, 0, 0], [1, 0, 0]], [[4, 0, 0], [1, 0, 0]]).toi == 0.25)
""".format(str(target))
    ran = subprocess.run([sys.executable, "-c", script], env=dict(os.environ, PYTHONPATH=str(target)),
                         capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    information, = target.glob("touchstone-*.dist-info")
    version = information.name[len("touchstone-"):-len(".dist-info")]
    assert ran.stdout == f"{version} True\n"
    wheel = information / "WHEEL"
    assert "Root-Is-Purelib: false" in wheel.read_text() and "py3-none-any" not in wheel.read_text()
    assert (target / "touchstone/py.typed").exists() and (target / "touchstone/_core.pyi").exists()
    after = sources()
    assert after == before, "the installation writes into the sources"
