"""What pyproject.toml needs beyond setuptools: the compiled half of the package, made by CMake.

The environment variable CMAKE_ARGS has further arguments for CMake. TOUCHSTONE_BUILD_DIR names a build folder that has
the module already. pip shows what CMake and Ninja say where it is asked to by -v, or when the build fails.
SPDX-License-Identifier: MIT
"""
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from setuptools.command.build_py import build_py
from setuptools.errors import ExecError

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
            **self.quick_build(), "CMAKE_BUILD_TYPE": "Release", "TOUCHSTONE_PYTHON": sys.executable,
            "TOUCHSTONE_BUILD_PYTHON": "ON", "TOUCHSTONE_BUILD_PROGRAM": "OFF", "TOUCHSTONE_BUILD_TESTS": "OFF",
            "TOUCHSTONE_BUILD_FUZZ": "OFF", "TOUCHSTONE_BUILD_TIGHT_INCLUSION": "OFF", "BUILD_SHARED_LIBS": "OFF"
        }
        self.cmake("-S", ROOT, "-B", folder, *self.generator(folder),
                   *(f"-D{name}={value}" for name, value in options.items()),
                   *shlex.split(os.environ.get("CMAKE_ARGS", "")))
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or self.set_up("compile_jobs") or os.cpu_count() or 1
        print(f"touchstone: compiling in {folder}, {jobs} jobs at a time", flush=True)
        self.cmake("--build", folder, "--target", "touchstone_python", "--parallel", str(jobs))

    def quick_build(self):
        """What src/setup.sh does, too: the presets' unity build, in two thirds of the time, by ccache where it is
        installed. The presets themselves need CMake 3.21."""
        base, = (preset for preset in json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]
                 if preset["name"] == "base")
        ccache = shutil.which("ccache") and "CMAKE_CXX_COMPILER_LAUNCHER" not in os.environ
        return {**base["cacheVariables"], **({"CMAKE_CXX_COMPILER_LAUNCHER": "ccache"} if ccache else {})}

    def generator(self, folder):
        """Ninja where it is there: CMake's own choice is make, which need not be. The user's choice goes first."""
        chosen = "CMAKE_GENERATOR" in os.environ or re.search(r"(^|\s)-G", os.environ.get("CMAKE_ARGS", ""))
        if chosen or (folder / "CMakeCache.txt").exists() or not (shutil.which("ninja") or shutil.which("ninja-build")):
            return []
        return ["-G", "Ninja"]

    def cmake(self, *arguments):
        """Runs CMake. A failure names what is missing here, with the packages that have it."""
        sys.stdout.flush()
        try:
            subprocess.run(["cmake", *map(str, arguments)], check=True)
        except (OSError, subprocess.CalledProcessError) as error:
            why = (f"cmake ended with the exit status {error.returncode}, and says why above"
                   if isinstance(error, subprocess.CalledProcessError) else f"cmake does not start ({error.strerror})")
            missing = self.set_up("what_the_module_lacks")
            raise ExecError(f"{why}; {missing}" if missing else why) from None

    def set_up(self, function):
        """What a function of src/setup.sh prints; nothing where there is no bash."""
        command = ["bash", "-c", f'source "$1" && {function}', "bash", ROOT / "src/setup.sh"]
        try:
            return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True).stdout.strip()
        except OSError:
            return ""


class PlatformWheel(bdist_wheel):
    """A wheel for this Python and this machine: setuptools sees no extension in the package."""

    def finalize_options(self):
        super().finalize_options()
        self.root_is_pure = False
