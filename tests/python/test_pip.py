"""pip installs the package from the sources, with the module of this build. SPDX-License-Identifier: MIT"""
import os
import shutil
import subprocess
import sys
import sysconfig
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
    assert configure.startswith("-S ") and "-DCMAKE_UNITY_BUILD=ON" in configure and build.startswith("--build ")
    return "-G Ninja" in configure


def test_the_build_needs_no_make_where_there_is_ninja(tmp_path):
    assert takes_ninja(tmp_path, ["ninja"]) and takes_ninja(tmp_path, ["ninja-build"])
    assert not takes_ninja(tmp_path, ["make"])
    assert not takes_ninja(tmp_path, ["ninja"], CMAKE_GENERATOR="Unix Makefiles")
    assert not takes_ninja(tmp_path, ["ninja"], CMAKE_ARGS="-DX=1 -G'Unix Makefiles'")
    (tmp_path / "build").mkdir()
    (tmp_path / "build/CMakeCache.txt").write_text("")
    assert not takes_ninja(tmp_path, ["ninja"])


def error_of_a_build(tmp_path, **programs):
    """The last line of a build in which PATH has these shell scripts, and the tools of src/setup.sh."""
    path = tmp_path / "bin"
    shutil.rmtree(path, ignore_errors=True)
    path.mkdir()
    for tool in ("bash", "dirname", "paste", "sed", "tr"):
        (path / tool).symlink_to(shutil.which(tool))
    for tool, text in programs.items():
        program(path / tool.replace("_", "-"), text)
    script = ("import sys; sys.path.insert(0, sys.argv[1]); import cmake_build as c, pathlib, setuptools; "
              "d = setuptools.dist.Distribution({'packages': [], 'script_name': 'x', 'script_args': ['build_py'], "
              "'cmdclass': {'build_py': c.BuildWithCMake}}); d.parse_command_line(); d.run_commands()")
    not_own = ("CMAKE_ARGS", "TOUCHSTONE_BUILD_DIR", "CXX")
    own = {name: value for name, value in os.environ.items() if name not in not_own}
    ran = subprocess.run([sys.executable, "-c", script, ROOT / "src/bindings/python"], cwd=tmp_path,
                         env={**own, "PATH": str(path)}, capture_output=True, text=True)
    assert ran.returncode != 0
    return ran.stderr.splitlines()[-1]


def test_a_build_that_fails_names_what_is_missing(tmp_path):
    pytest.importorskip("setuptools")
    has_all = "exit 0\n"
    # The compiler is asked which headers it has not.
    lacks = 'echo "missing cgal.h"; echo "missing mpfr.h"\n'
    error = error_of_a_build(tmp_path, apt_get=has_all)
    assert "cmake does not start (No such file or directory); missing here: compiler cmake ninja " in error
    assert "; please install by hand: g++ cmake ninja-build " in error
    error = error_of_a_build(tmp_path, cmake="exit 7\n", **{"g++": lacks}, make=has_all, apt_get=has_all)
    assert error.endswith("cmake ended with the exit status 7, and says why above; missing here: cgal.h mpfr.h; "
                          "please install by hand: libcgal-dev libmpfr-dev")
    error = error_of_a_build(tmp_path, cmake="exit 7\n", **{"g++": lacks}, make=has_all, dnf=has_all)
    assert error.endswith("please install by hand: CGAL-devel mpfr-devel")
    error = error_of_a_build(tmp_path, cmake="exit 7\n", **{"g++": has_all}, make=has_all)
    assert error.endswith("cmake ended with the exit status 7, and says why above")


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
    wheel = (information / "WHEEL").read_text().splitlines()
    python = "cp" + sysconfig.get_config_var("py_version_nodot")
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    assert "Root-Is-Purelib: false" in wheel and f"Tag: {python}-{python}-{platform}" in wheel
    assert next(information.rglob("LICENSE")).read_bytes() == (ROOT / "LICENSE").read_bytes()
    assert (target / "touchstone/py.typed").exists() and (target / "touchstone/_core.pyi").exists()
    after = sources()
    assert after == before, "the installation writes into the sources"
