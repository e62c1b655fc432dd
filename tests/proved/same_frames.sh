#!/usr/bin/env bash
# The checker that is proved in Coq says of the files of --frames what touchstone-check says.
#
#   same_frames.sh PROGRAM CHECKER PROVED     all of them are absolute paths
# SPDX-License-Identifier: MIT
set -euo pipefail
command -v python3 >/dev/null || { echo "skipped: no python3"; exit 77; }
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
python3 -B "$here/compare_frames.py" --program "$1" --checker "$2" --proved "$3" --mutants 1000
