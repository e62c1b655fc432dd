#!/usr/bin/env bash
# run.sh TEST PROGRAM...: runs one file of tests in a browser. 77, "skipped", when something is missing.
# SPDX-License-Identifier: MIT
set -euo pipefail
test=$1
shift
why=''
if ! command -v python3 >/dev/null; then
  why='there is no python3 in PATH'
elif ! command -v chromium >/dev/null && ! command -v chromium-browser >/dev/null; then
  why="there is no browser in PATH (Debian's package is chromium)"
fi
if [[ -n $why ]]; then
  echo "skipped: $why"
  exit 77
fi
PYTHONDONTWRITEBYTECODE=1 exec python3 "$test" "$@"
