#!/usr/bin/env bash
# release_refuses.sh FOLDER: tests/release.sh says what is missing or wrong, and leaves nothing behind. It runs in a
# copy in FOLDER, with a Python that can do nothing.
# SPDX-License-Identifier: MIT
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
copy=${1:?usage: release_refuses.sh FOLDER}
command -v git >/dev/null || { echo 'skipped: there is no git (Debian: git)'; exit 0; }
rm -rf -- "$copy"
mkdir -p -- "$copy"/{tests,src,tmp}
copy=$(cd -- "$copy" && pwd -P)
cp -- "$root/tests/release.sh" "$copy/tests"
cp -- "$root/src/setup.sh" "$copy/src"
cp -- "$root/CMakeLists.txt" "$copy"
printf '#!/bin/sh\n[ "$1" = -c ] || { echo "no wheels today"; exit 9; }\n' >"$copy/tests/python"
chmod +x -- "$copy/tests/python"

failures=0
expect() { # STATUS WORDS ARGUMENT...: release.sh with these arguments ends so and says these words
  local wanted=$1 words=$2 status=0
  shift 2
  TMPDIR=$copy/tmp "$copy/tests/release.sh" "$@" >"$copy/tests/log" 2>&1 || status=$?
  if ((status != wanted)) || ! grep -qF -- "$words" "$copy/tests/log"; then
    printf 'exit status %s, not %s, or it does not say "%s":\n%s\n' "$status" "$wanted" "$words" "$(<"$copy/tests/log")"
    failures=$((failures + 1))
  fi
  if [[ -n $(ls -A -- "$copy/tmp") || -e $copy/build ]]; then
    printf 'it leaves files behind\n'
    failures=$((failures + 1))
  fi
}
export TOUCHSTONE_PYTHON=$copy/tests/python
expect 77 'run it in a clone'
git -C "$copy" init -q
git -C "$copy" add CMakeLists.txt src tests/release.sh
git -C "$copy" -c user.name=test -c user.email=test@example.org -c commit.gpgSign=false commit -q -m test
expect 3 'it has none' --archive
TOUCHSTONE_PYTHON=$copy/no-python expect 77 'python3-pip'
expect 3 'it failed, and says why above'
grep -q 'no wheels today' "$copy/tests/log" || failures=$((failures + 1))
# An attribute that keeps a file out of the archive.
echo 'src export-ignore' >"$copy/.gitattributes"
git -C "$copy" add .gitattributes
git -C "$copy" -c user.name=test -c user.email=test@example.org -c commit.gpgSign=false commit -q -m attribute
expect 3 'has not the files that git knows'
printf '%s failures\n' "$failures"
((failures == 0))
