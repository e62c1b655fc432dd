#!/usr/bin/env bash
# Runs every test on a fresh machine: installs missing packages, builds everything with warnings as errors, and runs
# ctest. Its last lines and its exit status are ctest's. Arguments are passed on to ctest, such as -R NAME. A test that
# cannot run here is "Skipped": the missing optional tools are named before the tests start, and every reason is in
# build/ci/Testing/Temporary/LastTest.log.
# TOUCHSTONE_QUERY_DATA, when set, is the folder of the public benchmark's queries.
# SPDX-License-Identifier: MIT
set -euo pipefail
if [[ -n ${TOUCHSTONE_QUERY_DATA:-} ]]; then
  TOUCHSTONE_QUERY_DATA=$(cd -- "$TOUCHSTONE_QUERY_DATA" && pwd -P) # the tests run elsewhere
  export TOUCHSTONE_QUERY_DATA
fi
# shellcheck source-path=SCRIPTDIR source=../src/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../src/setup.sh"

install_missing tests
build_preset ci all "-DTOUCHSTONE_QUERY_DATA=${TOUCHSTONE_QUERY_DATA:-}"
exec ctest --preset ci --parallel "$(core_count)" "$@"
