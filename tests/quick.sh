#!/usr/bin/env bash
# Did I break it? Builds build/release and runs the laws and searches of the tests on a twentieth of their random cases.
# It leaves out the labels `heavy`, `slow` and `optional-tools`, the pages, packages, the Python module and Gappa's
# proofs, and says so; tests/run-all.sh runs all. Arguments are passed on to ctest, such as -R NAME.
# SPDX-License-Identifier: MIT
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../src/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../src/setup.sh"

install_missing tests
build_preset release all
export TOUCHSTONE_EFFORT=${TOUCHSTONE_EFFORT:-0.05}
say "left out: the labels heavy, slow and optional-tools, pages, packages, the Python module, Gappa's proofs"
exec ctest --preset release --parallel "$(core_count)" -LE 'heavy|slow|optional-tools' \
  -E '^(pages|packaging)\.|^gappa_proves' "$@"
