#!/usr/bin/env bash
# check_faults.sh SOURCE: each fault that fuzz/weaken-constants.py plants fits the sources, and one that does not is
# found. 77, "skipped", without Python.
# SPDX-License-Identifier: MIT
set -euo pipefail

source=$1
if ! command -v python3 > /dev/null; then
  echo "skipped: python3 is not installed (Debian and Ubuntu: the package python3)"
  exit 77
fi
count=$(python3 "$source/fuzz/weaken-constants.py" --list | wc -l)
if [ "$count" -lt 100 ]; then
  echo "only $count faults are listed"
  exit 1
fi

folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
mkdir "$folder/fuzz"
cp -- "$source/fuzz/weaken-constants.py" "$folder/fuzz"
cp -r -- "$source/src" "$folder"
sed -i 's/kEndsBound = 35/kEndsBound = 36/' "$folder/src/core/filters/coplanarity_form.hpp"
status=0
python3 "$folder/fuzz/weaken-constants.py" --list > /dev/null 2>&1 || status=$?
if [ "$status" -ne 2 ]; then
  echo "a fault that does not fit the sources is not found: exit status $status in place of 2"
  exit 1
fi
echo "$count faults fit the sources, and one that does not is found"
