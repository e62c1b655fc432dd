"""pip installs the package from the sources, with the module of this build. SPDX-License-Identifier: MIT"""
import os
import shutil
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


def program(path, text):
    path.write_text("#!/bin/sh\n" + text)
    path.chmod(0o755)


def takes_ninja(tmp_path, tools, **environment):
    """Whether the build asks CMake for Ninja in a new folder, where PATH has these tools alone."""
    pytest.importorskip("setuptools")
    path = tmp_path / "bin"
    shutil.rmtree(path, ignore_errors=True)
    path.mkdir()
    program(path / "cmake", f'echo "$*" >> "{path}/arguments"\n')
    for tool in tools:
        program(path / tool, "exit 1\n")
    script = ("import pathlib, sys; sys.path.insert(0, sys.argv[1]); import cmake_build as c; "
              "c.BuildWithCMake.build(c.BuildWithCMake.__new__(c.BuildWithCMake), pathlib.Path(sys.argv[2]))")
    own = {name: value for name, value in os.environ.items() if name not in ("CMAKE_ARGS", "CMAKE_GENERATOR")}
    subprocess.run([sys.executable, "-c", script, ROOT / "src/bindings/python", tmp_path / "build"], check=True,
                   env={**own, "PATH": str(path), **environment})
    configure, build = (path / "arguments").read_text().splitlines()
    assert configure.startswith("-S ") and build.startswith("--build ")
    return "-G Ninja" in configure


def test_the_build_needs_no_make_where_there_is_ninja(tmp_path):
    assert takes_ninja(tmp_path, ["ninja"]) and takes_ninja(tmp_path, ["ninja-build"])
    assert not takes_ninja(tmp_path, ["make"])
    assert not takes_ninja(tmp_path, ["ninja"], CMAKE_GENERATOR="Unix Makefiles")
    assert not takes_ninja(tmp_path, ["ninja"], CMAKE_ARGS="-DX=1 -G'Unix Makefiles'")
    (tmp_path / "build").mkdir()
    (tmp_path / "build/CMakeCache.txt").write_text("")
    assert not takes_ninja(tmp_path, ["ninja"])


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
