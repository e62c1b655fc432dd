#!/usr/bin/env bash
# The checks that take too long for every change. Each commit gets one of them, by its number, so that all come round.
#   heavy.sh JOB [PART/PARTS]   one job; of a job that is a list of tests or faults, the PART-th of so many parts.
#                               A part of `sanitizers` or `clang` is some folders of tests; the others are not built.
#   heavy.sh --of COMMIT        the job of this commit, and its part
#   heavy.sh --list             the jobs
# Exit status 0 when nothing failed. A job whose tools cannot be installed is skipped with a reason.
# SPDX-License-Identifier: MIT
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../src/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../src/setup.sh"

# name | parts that a commit gets one of | what it does
readonly -a heavy_jobs=(
  'sanitizers|8|the preset debug: address and undefined-behaviour sanitizers'
  'threads|1|the preset tsan: the thread sanitizer, by clang'
  'clang|4|the preset clang: warnings are errors, and the tests'
  'arm64|2|the preset arm64: a cross-build, and the tests of the library under qemu-user'
  'faults|10|planted faults: each weakened bound must be noticed'
  'fuzzing|1|the libFuzzer targets, for five minutes in all'
  'release|1|the archive and the wheel of a release: made, built from nothing and tried'
  'browser|1|the program as WebAssembly: built, and compared with the native one, in Node and in a browser'
  'plain|1|the preset plain: all that is installed, each source compiled by itself'
  'tests|1|every test on all of its random cases, with those of the label heavy'
)

is_job() {
  local one
  for one in "${heavy_jobs[@]}"; do
    [[ ${one%%|*} != "$1" ]] || return 0
  done
  return 1
}

# of_commit COMMIT: leaves the commit's job in `job`, and its part in `part` and `parts`.
of_commit() {
  local number
  [[ $1 =~ ^[0-9a-f]{8} ]] || die "'$1' is no number of a commit: 8 hexadecimal digits or more"
  number=$((16#${1:0:8}))
  IFS='|' read -r job parts _ <<<"${heavy_jobs[number % ${#heavy_jobs[@]}]}"
  part=$((number / ${#heavy_jobs[@]} % parts + 1))
}

# The tests of a preset that are of this part: every parts-th of them.
ctest_part() {
  local preset=$1
  shift
  (cd -- "$touchstone_root" && ctest --preset "$preset" --parallel "$(core_count)" -I "$part,,$parts" "$@")
}

# The folders of tests that are of this part: every parts-th of them.
test_groups() {
  local all=("$touchstone_root"/tests/*/CMakeLists.txt) list='' i
  for ((i = part - 1; i < ${#all[@]}; i += parts)); do
    list+=";$(basename -- "${all[i]%/CMakeLists.txt}")"
  done
  [[ -n $list ]] || die "there are ${#all[@]} folders of tests, and so no part $part of $parts"
  printf '%s\n' "${list#;}"
}

# build_and_test_groups PRESET CTEST-ARGUMENT...: all that a preset builds, with the tests of those folders.
build_and_test_groups() {
  local preset=$1 groups
  shift
  groups=$(test_groups)
  build_preset "$preset" all "-DTOUCHSTONE_TEST_GROUPS=$groups"
  (cd -- "$touchstone_root" && ctest --preset "$preset" --parallel "$(core_count)" "$@")
}

skip() {
  say "skipped: $job needs $1; docs/contributing.md lists its packages"
  exit 0
}

needs_or_skip() {
  local name
  for name in "$@"; do
    command -v "$name" >/dev/null || skip "$name"
  done
}

run_sanitizers() {
  install_missing tests
  build_and_test_groups debug -LE heavy
}
run_threads() {
  install_missing fuzz
  build_preset tsan '' # the targets of the preset
  ctest_part tsan
}
run_clang() {
  install_missing fuzz
  build_and_test_groups clang -LE heavy -E '^(pages|packaging|python)\.'
}
run_arm64() {
  needs_or_skip aarch64-linux-gnu-g++ qemu-aarch64
  [[ $(aarch64-linux-gnu-g++ -print-file-name=libgmp.so) == */* ]] || skip 'the libraries of the architecture arm64'
  build_preset arm64 ''
  ctest_part arm64
}
run_faults() {
  install_missing tests
  needs_or_skip python3
  "$touchstone_root/fuzz/weaken-constants.py" --quick --part "$part/$parts"
}
run_fuzzing() { "$touchstone_root/fuzz/run.sh" 100; }
run_plain() {
  install_missing
  build_preset plain touchstone_installed
}
run_release() {
  local status=0
  install_missing tests
  "$touchstone_root/tests/release.sh" || status=$?
  ((status != 77)) || exit 0 # it has said why it is skipped
  return "$status"
}
run_browser() {
  local out=$touchstone_root/build/browser status=0
  needs_or_skip emcc node chromium
  install_missing
  [[ -d $out/gmp || -n ${TOUCHSTONE_GMP:-} ]] || apt-get source --print-uris gmp >/dev/null 2>&1 ||
    skip 'the source of GMP: a line deb-src for apt-get, or its folder in TOUCHSTONE_GMP'
  build_preset release touchstone_program
  "$touchstone_root/src/bindings/browser/build.sh" "$out" ${TOUCHSTONE_GMP:+"$TOUCHSTONE_GMP"}
  "$touchstone_root/tests/browser/run.sh" "$out" "$touchstone_root/build/release/touchstone" \
    "$touchstone_root/src/cli/queries" || status=$?
  ((status != 77)) || exit 0 # it has said why it is skipped
  return "$status"
}
run_tests() { TOUCHSTONE_EFFORT=1 "$touchstone_root/tests/run-all.sh"; }

part=1 parts=1
case ${1:-} in
  --list)
    for one in "${heavy_jobs[@]}"; do
      IFS='|' read -r name _ about <<<"$one"
      printf '%-10s  %s\n' "$name" "$about"
    done
    exit 0
    ;;
  --of) of_commit "${2:-}" ;;
  *)
    job=${1:-}
    is_job "$job" || die "usage: tests/heavy.sh JOB [PART/PARTS] | --of COMMIT | --list; there is no job '$job'"
    if (($# > 1)); then
      [[ $2 =~ ^([1-9][0-9]{0,3})/([1-9][0-9]{0,3})$ ]] && ((BASH_REMATCH[1] <= BASH_REMATCH[2])) ||
        die "'$2' is no part: write 3/10 for the third of ten"
      part=${BASH_REMATCH[1]} parts=${BASH_REMATCH[2]}
    fi
    ;;
esac
say "the heavy job '$job', part $part of $parts"
"run_$job" </dev/null
