#!/usr/bin/env bash
# run.sh WHY_NOT PYTHON TEST_FILE PACKAGE_FOLDER PROGRAM: runs one file of tests by pytest. 77, "skipped", when there is
# a reason not to, or when pytest is missing.
# SPDX-License-Identifier: MIT
set -euo pipefail
why=$1 python=$2 file=$3 package=$4 program=$5
if [[ -z $why ]] && ! command -v python3 >/dev/null; then
  why='there is no python3 in PATH'
elif [[ -z $why ]] && ! "$python" -c 'import pytest' 2>/dev/null; then
  why="$python cannot import pytest (Debian's package is python3-pytest)"
fi
if [[ -n $why ]]; then
  echo "skipped: $why"
  exit 77
fi
log=$(mktemp)
trap 'rm -f -- "$log"' EXIT
export PYTHONPATH=$package PYTHONDONTWRITEBYTECODE=1 TOUCHSTONE_PROGRAM=$program
status=0
"$python" -m pytest -q -rs -p no:cacheprovider "$file" 2>&1 | tee "$log" || status=$?
# 5: no test was left to run, as a file is skipped as a whole.
if ((status == 0 || status == 5)) && tail -n 1 "$log" | grep -q '^[0-9]* skipped in'; then
  echo "skipped: every test of ${file##*/}; the reasons are above"
  exit 77
fi
exit "$status"
