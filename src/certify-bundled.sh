#!/usr/bin/env bash
# From a fresh machine to a certified answer: installs what is missing, builds what `cmake --install` copies, and runs
# `touchstone certify` on the bundled queries. Its exit status is certify's: 0 when every claim holds. Arguments are
# passed on to certify.
# SPDX-License-Identifier: MIT
set -euo pipefail
called_from=$PWD
# shellcheck source-path=SCRIPTDIR source=setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/setup.sh"

install_missing
# The program alone would not be enough: `cmake --install build/release` is the next command of the README.
build_preset release touchstone_installed
cd -- "$called_from"
exec "$touchstone_root/build/release/touchstone" certify "$@"
