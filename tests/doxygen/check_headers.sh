#!/usr/bin/env bash
# check_headers.sh DOXYFILE: the settings of the target `docs` give no warning on the public headers, and they do warn
# where a public name has no comment or a wrong one. 77, "skipped", without Doxygen.
# SPDX-License-Identifier: MIT
set -euo pipefail

doxyfile=$1
if ! command -v doxygen > /dev/null; then
  echo "skipped: doxygen is not installed (Debian, Ubuntu, Fedora and Arch: the package doxygen)"
  exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT

# run INPUT: Doxygen with the settings of the target, on other input if one is given, into a folder of the test's own.
run() {
  { cat -- "$doxyfile"; printf 'OUTPUT_DIRECTORY = "%s"\n' "$folder"; [ $# -eq 0 ] || printf 'INPUT = "%s"\n' "$1"; } |
    doxygen - 2>&1
}

if ! output=$(run) || [ -n "$output" ]; then
  printf 'Doxygen warns of the public headers:\n%s\n' "$output"
  exit 1
fi
# An empty reference would have no warnings either.
page=$folder/html/namespacetouchstone.html
for name in solve solve_batch contact_times judge fuzz_solver to_vec3 first_contact free_step; do
  grep -q ">$name<" "$page" || { echo "the reference does not have $name"; exit 1; }
done

# must_warn NAME TEXT: a header with this text in the namespace is warned of.
must_warn() {
  mkdir -p "$folder/planted"
  printf '/// A namespace.\nnamespace touchstone {\n%s\n}\n' "$2" > "$folder/planted/planted.hpp"
  if output=$(run "$folder/planted"); then
    echo "no warning of $1"
    exit 1
  fi
  case $output in
    *planted.hpp*) ;;
    *) printf 'no warning names the header of %s:\n%s\n' "$1" "$output"; exit 1 ;;
  esac
}
documented=$'/// Gives x.\n/// @param x  any\n/// @return x\nint f(int x);'
must_warn "a function without a comment" "$documented"$'\nint g(int x);'
must_warn "a member without a comment" $'/// A pair.\nstruct Pair {\n  int a;\n};'
must_warn "a parameter that is not there" $'/// Gives x.\n/// @param y  any\n/// @return x\nint f(int x);'
mkdir -p "$folder/planted"
printf '/// A namespace.\nnamespace touchstone {\n%s\n}\n' "$documented" > "$folder/planted/planted.hpp"
run "$folder/planted" > /dev/null || { echo "a documented header is warned of"; exit 1; }
echo "no warning of the public headers, and each planted fault is found"
