"""What pyproject.toml needs beyond setuptools: the compiled half of the package, made by CMake.

The environment variable CMAKE_ARGS has further arguments for CMake. TOUCHSTONE_BUILD_DIR names a build folder that has
the module already. SPDX-License-Identifier: MIT
"""
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from setuptools.command.build_py import build_py

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:  # before setuptools 70.1
    from wheel.bdist_wheel import bdist_wheel

ROOT = Path(__file__).resolve().parents[3]
VERSION = re.search(r"VERSION (\d+\.\d+\.\d+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


(ROOT / "build").mkdir(exist_ok=True)  # pyproject.toml puts all that setuptools writes there


class BuildWithCMake(build_py):
    """Copies the package, and adds what `cmake --install` puts into it."""

    def run(self):
        super().run()
        ready = os.environ.get("TOUCHSTONE_BUILD_DIR")
        build = Path(ready) if ready else ROOT / "build" / "python"
        if not ready:
            self.build(build)
        with tempfile.TemporaryDirectory() as prefix:
            self.cmake("--install", build, "--component", "python", "--prefix", prefix)
            core, = Path(prefix).glob("**/touchstone/_core*.so")
            shutil.copytree(core.parent, Path(self.build_lib) / "touchstone", dirs_exist_ok=True)

    def build(self, folder):
        options = {
            "CMAKE_BUILD_TYPE": "Release", "TOUCHSTONE_PYTHON": sys.executable, "TOUCHSTONE_BUILD_PYTHON": "ON",
            "TOUCHSTONE_BUILD_PROGRAM": "OFF", "TOUCHSTONE_BUILD_TESTS": "OFF", "TOUCHSTONE_BUILD_FUZZ": "OFF",
            "TOUCHSTONE_BUILD_TIGHT_INCLUSION": "OFF", "BUILD_SHARED_LIBS": "OFF"
        }
        self.cmake("-S", ROOT, "-B", folder, *self.generator(folder),
                   *(f"-D{name}={value}" for name, value in options.items()),
                   *shlex.split(os.environ.get("CMAKE_ARGS", "")))
        self.cmake("--build", folder, "--target", "touchstone_python", "--parallel", str(os.cpu_count() or 1))

    def generator(self, folder):
        """Ninja where it is there: CMake's own choice is make, which need not be. The user's choice goes first."""
        chosen = "CMAKE_GENERATOR" in os.environ or re.search(r"(^|\s)-G", os.environ.get("CMAKE_ARGS", ""))
        if chosen or (folder / "CMakeCache.txt").exists() or not (shutil.which("ninja") or shutil.which("ninja-build")):
            return []
        return ["-G", "Ninja"]

    def cmake(self, *arguments):
        subprocess.run(["cmake", *map(str, arguments)], check=True)


class PlatformWheel(bdist_wheel):
    """A wheel for this Python and this machine: setuptools sees no extension in the package."""

    def finalize_options(self):
        super().finalize_options()
        self.root_is_pure = False
