#!/usr/bin/env bash
# Both checkers give the verdicts that docs/proofs.md asks for on small proofs written by hand.
#
#   small_cases.sh CHECKER
# SPDX-License-Identifier: MIT
set -euo pipefail
command -v python3 >/dev/null || { echo "skipped: no python3"; exit 77; }
exec python3 -B "$(dirname -- "${BASH_SOURCE[0]}")/small_cases.py" --checker "$1"
