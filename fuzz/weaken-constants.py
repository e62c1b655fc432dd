#!/usr/bin/env python3
# Does anybody notice when a filter lies? On a copy of the sources, makes each error bound of the filters 16 times too
# small and drops each guard, one at a time; builds what depends on it; and runs the searches of tests/filters and then
# `touchstone fuzz` against the cascade, for a minute at most. Prints who found what. Exit status 0 when every fault was
# found, 1 when one survived, 2 when this script no longer fits the sources.
#
#   fuzz/weaken-constants.py [--only PART_OF_A_NAME] [--seconds 60] [--jobs N] [--quick] [--list]
# SPDX-License-Identifier: MIT
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent

# name, file below src/filters, text there (exactly once), what it becomes
FAULTS = [
    ("kEndsBound", "coplanarity_form.hpp", "kEndsBound = 49 *", "kEndsBound = 49 / 16.0 *"),
    ("kMiddleBound", "coplanarity_form.hpp", "kMiddleBound = 175 *", "kMiddleBound = 175 / 16.0 *"),
    ("underflow guard of U W", "coplanarity_form.hpp", "(uw >= kLeastProduct) & ", ""),
    ("underflow guard of U W R", "coplanarity_form.hpp", "(uwr >= kLeastProduct) & ", ""),
    ("overflow guards of U W and U W R", "coplanarity_form.hpp", "kGreatestProduct = 0x1p1000",
     "kGreatestProduct = 0x1.fffffffffffffp1023"),
    ("kProjectionBound", "separating_direction.cpp", "kProjectionBound = 13 *", "kProjectionBound = 13 / 16.0 *"),
    ("underflow guard of projections", "separating_direction.cpp", "product >= kLeastProduct && ", ""),
    ("kPartBound", "bernstein_cubic.cpp", "kPartBound = 120 *", "kPartBound = 120 / 16.0 *"),
    ("kValueBound", "bernstein_cubic.cpp", "kValueBound = 106 *", "kValueBound = 106 / 16.0 *"),
    ("kSlopeBound", "bernstein_cubic.cpp", "kSlopeBound = 606 *", "kSlopeBound = 606 / 16.0 *"),
    ("kCurvatureBound", "bernstein_cubic.cpp", "kCurvatureBound = 1700 *", "kCurvatureBound = 1700 / 16.0 *"),
    ("radius of a root", "bernstein_cubic.cpp", "radius = 2.0625 *", "radius = 2.0625 / 16 *"),
    ("steadiness of the slope at a root", "bernstein_cubic.cpp", "slope_error()) <= 0.5 * steepness",
     "slope_error()) <= 8 * steepness"),
    ("rounding of side conditions", "bracket.cpp", "21 * kUnit + 8.01 * h", "21 / 16.0 * kUnit + 8.01 * h"),
    ("reach of side conditions", "bracket.cpp", "21 * kUnit + 8.01 * h", "21 * kUnit + 8.01 / 16 * h"),
    ("underflow guard of the bracket level", "bracket.cpp", "std::min({m.u, m.w, m.r}) >= kLeast && ", ""),
    ("kCoplanarityError", "contact_values.hpp", "kCoplanarityError = 4500 *", "kCoplanarityError = 4500 / 16.0 *"),
    ("kComponentError", "contact_values.hpp", "kComponentError = 540 *", "kComponentError = 540 / 16.0 *"),
    ("value of a component at a root", "refined_root.cpp", "(800 * kUnitSquared", "(800 / 16.0 * kUnitSquared"),
    ("slope of a component at a root", "refined_root.cpp", "140 * kUnit * std", "140 / 16.0 * kUnit * std"),
    ("curvature of a component at a root", "refined_root.cpp", "8.25 * offset.reach * offset.reach",
     "8.25 / 16 * offset.reach * offset.reach"),
    ("offset's error in a component", "refined_root.cpp", "8.25 * offset.error)", "8.25 / 16 * offset.error)"),
    ("error of the offset", "refined_root.cpp", "1.0625 * (2 * value_error", "1.0625 / 16 * (2 * value_error"),
    ("steadiness of the slope along the offset", "refined_root.cpp", "spread < 0.5 * steepness",
     "spread < 8 * steepness"),
    ("steadiness of the weights", "refined_root.cpp", "offset->error <= 0x1p-56", "offset->error <= 0x1p-52"),
    ("kBound of shared corners", "shared_corner.cpp", "kBound = 9 *", "kBound = 9 / 16.0 *"),
    ("underflow guard of shared corners", "shared_corner.cpp", "uw >= 0x1p-1000 && ", ""),
]


def stop(reason):
    print(f"weaken-constants: {reason}", file=sys.stderr)
    sys.exit(2)


def faulty(text, fault):
    name, file, old, new = fault
    if text.count(old) != 1:
        stop(f"'{name}': src/filters/{file} holds {text.count(old)} times, not once: {old}")
    return text.replace(old, new)


def copy_sources(to):
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z"], capture_output=True, check=True).stdout
    for name in listed.decode().split("\0"):
        if name and (ROOT / name).is_file():
            (to / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, to / name)


def configure(source, build):
    command = ["cmake", "-S", source, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"]
    if shutil.which("ccache"):
        command.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
        os.environ.update(CCACHE_BASEDIR=str(source), CCACHE_NOHASHDIR="1")
    if subprocess.run(command, stdout=subprocess.DEVNULL).returncode:
        stop("cmake failed")


def build_target(build, target, jobs):
    command = ["cmake", "--build", build, "-j", str(jobs), "--target", target]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:  # which proves nothing about a fault
        stop(f"{target} does not compile:\n{done.stdout[-3000:]}")


def finds(command, seconds):
    """Whether it fails, or ends by a signal, within so many seconds; and a line that tells why."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=max(seconds, 1))
    except subprocess.TimeoutExpired:
        return False, ""
    words = [line for line in (done.stdout + done.stderr).splitlines() if "FAILED" in line or line.startswith("1. ")]
    return done.returncode != 0, (words or [""])[0].strip()


def attacks(build, seconds, jobs, quick):
    """The search that found the fault, how long it took, and its words; or nothing. Building takes no time."""
    fuzz = [build / "touchstone", "fuzz", "--solver", "touchstone"]
    spent = 0.0
    for name, target, command in [
        ("tests/filters", "test_filters", [build / "tests/filters/test_filters", "--abort"]),
        ("touchstone fuzz", "touchstone_program", fuzz + ["--seconds", str(max(1, round(seconds / 4)))]),
        ("touchstone fuzz --climb", "touchstone_program",
         fuzz + ["--climb", "100", "--seconds", str(max(1, round(seconds / 3)))]),
    ][: 1 if quick else 3]:
        build_target(build, target, jobs)
        begin = time.monotonic()
        found, words = finds([str(word) for word in command], seconds - spent)
        spent += time.monotonic() - begin
        if found:
            return name, spent, words
        if spent >= seconds - 1:
            break
    return None


def main():
    parser = argparse.ArgumentParser(description="Weakens the filters' bounds one by one and sees who notices.")
    parser.add_argument("--only", default="", help="only faults whose name holds this")
    parser.add_argument("--seconds", type=float, default=60, help="for the searches, of each fault (default: 60)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--quick", action="store_true", help="the searches of tests/filters only")
    parser.add_argument("--list", action="store_true", help="the faults, and no more")
    options = parser.parse_args()
    chosen = [fault for fault in FAULTS if options.only in fault[0]]
    if not chosen:
        stop(f"no fault is called '{options.only}'")
    for fault in FAULTS:  # before minutes are spent
        faulty((ROOT / "src/filters" / fault[1]).read_text(), fault)
    if options.list:
        print("\n".join(fault[0] for fault in chosen))
        return 0

    with tempfile.TemporaryDirectory(prefix="touchstone-weaken-") as folder:
        source, build = pathlib.Path(folder) / "source", pathlib.Path(folder) / "build"
        copy_sources(source)
        configure(source, build)
        unharmed = attacks(build, options.seconds, options.jobs, options.quick)
        if unharmed:
            stop(f"the sources as they are fail: {unharmed[0]}: {unharmed[2]}")
        survivors = []
        for fault in chosen:
            file = source / "src/filters" / fault[1]
            text = file.read_text()
            file.write_text(faulty(text, fault))
            result = attacks(build, options.seconds, options.jobs, options.quick)
            file.write_text(text)
            if result:
                print(f"found     {fault[0]}: by {result[0]} in {result[1]:.1f} s  {result[2]}", flush=True)
            else:
                survivors.append(fault[0])
                print(f"SURVIVED  {fault[0]}", flush=True)
        print(f"{len(chosen) - len(survivors)} of {len(chosen)} faults found")
        return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
