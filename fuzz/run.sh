#!/usr/bin/env bash
# Builds the libFuzzer programs and runs each for a while, from seeds that the project's generators make and from what
# fuzz/corpus keeps. Exit status 0 when nothing was found; 1 when something was: then the input lies in
# build/fuzz/findings, and once it is mended it belongs into fuzz/corpus/TARGET, where the tests replay it.
#
#   fuzz/run.sh [SECONDS [TARGET...]]      60 seconds each and all of them, if not told otherwise
# SPDX-License-Identifier: MIT
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../src/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../src/setup.sh"

seconds=${1:-60}
[[ $seconds =~ ^[1-9][0-9]{0,5}$ ]] || die "usage: fuzz/run.sh [SECONDS [TARGET...]], not '$seconds' seconds"
shift || true
targets=("$@")
((${#targets[@]})) || targets=(query query_file answers_file pipe_lines scene_file mesh_file)

install_missing fuzz
clang=$(fuzzing_clang) || die "no clang with libFuzzer"
build_preset fuzz all "-DCMAKE_CXX_COMPILER=$clang"

build=$touchstone_root/build/fuzz
for target in "${targets[@]}"; do
  [[ -x $build/fuzz/fuzz_$target ]] || die "there is no target '$target'"
done
# What an earlier run has learned stays, which is why the corpus is not made anew.
mkdir -p -- "$build/findings"
"$build/fuzz/make_seeds" "$build/corpus" >&2

fuzz_one() {
  local target=$1 log=$build/findings/$1.log kept=()
  [[ ! -d $touchstone_root/fuzz/corpus/$target ]] || kept=("$touchstone_root/fuzz/corpus/$target")
  ASAN_OPTIONS=halt_on_error=1:detect_leaks=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 \
    "$build/fuzz/fuzz_$target" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=3000 -print_final_stats=1 \
    -artifact_prefix="$build/findings/$target-" "$build/corpus/$target" "${kept[@]}" >"$log" 2>&1
}

declare -A processes
failed=0
finish() {
  local target=$1
  if wait "${processes[$target]}"; then
    say "$target: nothing found in $seconds seconds; $(sed -n 's/^stat::number_of_executed_units: *//p' \
      "$build/findings/$target.log") inputs"
  else
    failed=1
    say "$target: FOUND SOMETHING; $build/findings/$target.log ends with"
    tail -n 40 -- "$build/findings/$target.log" >&2
  fi
}
finish_running() {
  local target
  for target in "${running[@]}"; do finish "$target"; done
}

running=()
cores=$(core_count)
for target in "${targets[@]}"; do
  fuzz_one "$target" &
  processes[$target]=$!
  running+=("$target")
  if ((${#running[@]} >= cores)); then
    finish_running
    running=()
  fi
done
finish_running
exit "$failed"
