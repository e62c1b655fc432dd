#!/usr/bin/env bash
# Runs every test on a fresh machine: installs missing packages, builds everything in build/release, and runs ctest. Its
# last lines and its exit status are ctest's. Arguments are passed on to ctest, such as -R NAME. A test that cannot run
# here is "Skipped": the missing optional tools are named before the tests start, and every reason is in
# build/release/Testing/Temporary/LastTest.log.
# TOUCHSTONE_QUERY_DATA, when set, is the folder of the public benchmark's queries. TOUCHSTONE_WARNINGS_AS_ERRORS=ON
# makes warnings errors, as the continuous integration does.
# SPDX-License-Identifier: MIT
set -euo pipefail
if [[ -n ${TOUCHSTONE_QUERY_DATA:-} ]]; then
  TOUCHSTONE_QUERY_DATA=$(cd -- "$TOUCHSTONE_QUERY_DATA" && pwd -P) # the tests run elsewhere
  export TOUCHSTONE_QUERY_DATA
fi
# shellcheck source-path=SCRIPTDIR source=../src/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../src/setup.sh"

install_missing tests
build_preset release all "-DTOUCHSTONE_QUERY_DATA=${TOUCHSTONE_QUERY_DATA:-}" \
  "-DTOUCHSTONE_WARNINGS_AS_ERRORS=${TOUCHSTONE_WARNINGS_AS_ERRORS:-OFF}"
exec ctest --preset release --parallel "$(core_count)" "$@"
