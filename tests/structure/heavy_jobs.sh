#!/usr/bin/env bash
# heavy_jobs.sh FOLDER: every job of tests/heavy.sh, in a copy of the scripts in FOLDER, where cmake, ctest and the
# other programs only write down how they were called. Each job must build its preset and start its tests.
# SPDX-License-Identifier: MIT
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
copy=${1:?usage: heavy_jobs.sh FOLDER}
rm -rf -- "$copy"
mkdir -p -- "$copy"/{tests/{browser,a,b,c,d,e},src/bindings/browser,fuzz,bin,build/fuzz/fuzz}
copy=$(cd -- "$copy" && pwd -P)
calls=$copy/calls
cp -- "$root"/tests/{heavy,run-all}.sh "$copy/tests"
touch -- "$copy"/tests/{a,b,c,d,e}/CMakeLists.txt
cp -- "$root/fuzz/run.sh" "$copy/fuzz"
{
  cat -- "$root/src/setup.sh"
  # Nothing is installed, and no compiler is asked for.
  printf '%s\n' 'install_missing() { printf "install %s\n" "$*" >>"'"$calls"'"; }' 'fuzzing_clang() { echo clang++; }'
} >"$copy/src/setup.sh"

write_down() { # FILE ANSWER: a program that writes its name and arguments down, and prints the answer
  printf '#!/bin/sh\nprintf "%%s" "${0##*/}" >>"%s"\nprintf " %%s" "$@" >>"%s"\necho >>"%s"\nprintf "%%s\\n" "%s"\n' \
    "$calls" "$calls" "$calls" "$2" >"$1"
  chmod +x -- "$1"
}
for name in cmake ctest aarch64-linux-gnu-g++ qemu-aarch64 python3 emcc node chromium; do
  write_down "$copy/bin/$name" '/answer 3.25.0'
done
write_down "$copy/fuzz/weaken-constants.py" ''
write_down "$copy/tests/release.sh" '/archive 1 bytes'
write_down "$copy/src/bindings/browser/build.sh" ''
write_down "$copy/tests/browser/run.sh" ''
for target in query query_file answers_file pipe_lines scene_file mesh_file; do
  write_down "$copy/build/fuzz/fuzz/fuzz_$target" ''
done
write_down "$copy/build/fuzz/fuzz/make_seeds" ''

failures=0
expect() { # JOB LINE...: the job's calls have these lines, in this order
  local job=$1 line at=0 found
  shift
  for line in "$@"; do
    found=$(tail -n "+$((at + 1))" -- "$calls" | grep -n -m 1 -e "^$line" | cut -d: -f1) || true
    if [[ -z $found ]]; then
      printf 'the job %s did not call: %s\nit called:\n%s\n' "$job" "$line" "$(cat -- "$calls")"
      failures=$((failures + 1))
      return
    fi
    at=$((at + found))
  done
}

asked=0
while read -r job _; do
  : >"$calls"
  if ! PATH=$copy/bin:$PATH TOUCHSTONE_GMP=$copy "$copy/tests/heavy.sh" "$job" 2/3 >"$copy/log" 2>&1 </dev/null; then
    printf 'the job %s failed:\n%s\n' "$job" "$(cat -- "$copy/log")"
    failures=$((failures + 1))
    continue
  fi
  case $job in
    sanitizers)
      expect "$job" 'cmake --preset debug .*-DTOUCHSTONE_TEST_GROUPS=b;e$' 'cmake --build --preset debug' \
        'ctest --preset debug .* -LE heavy$'
      ;;
    threads) expect "$job" 'cmake --preset tsan' 'cmake --build --preset tsan' 'ctest --preset tsan' ;;
    clang)
      expect "$job" 'cmake --preset clang .*-DTOUCHSTONE_TEST_GROUPS=b;e$' 'cmake --build --preset clang' \
        'ctest --preset clang '
      ;;
    arm64) expect "$job" 'cmake --preset arm64' 'cmake --build --preset arm64' 'ctest --preset arm64 .*-I 2,,3$' ;;
    faults) expect "$job" 'weaken-constants.py --quick --part 2/3' ;;
    fuzzing) expect "$job" 'cmake --build --preset fuzz' 'make_seeds' 'fuzz_.* -max_total_time=' ;;
    plain) expect "$job" 'cmake --preset plain' 'cmake --build --preset plain .*--target touchstone_installed' ;;
    browser) expect "$job" 'cmake --build --preset release .*--target touchstone_program' 'build.sh ' 'run.sh ' ;;
    release) expect "$job" 'install tests' 'release.sh' ;;
    tests) expect "$job" 'cmake --build --preset release' 'ctest --preset release --parallel [0-9]*$' ;;
    *)
      printf 'no calls are expected of the job %s: add them to heavy_jobs.sh\n' "$job"
      failures=$((failures + 1))
      ;;
  esac
  asked=$((asked + 1))
done < <("$copy/tests/heavy.sh" --list)
((asked > 0)) || { echo 'heavy.sh names no job'; exit 1; }
printf '%s jobs asked, %s failures\n' "$asked" "$failures"
((failures == 0))
