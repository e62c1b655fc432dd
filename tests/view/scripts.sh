#!/usr/bin/env bash
# scripts.sh SOURCE: node reads every script of the pages, and finds a planted fault. 77, "skipped", without node.
# SPDX-License-Identifier: MIT
set -euo pipefail
source=$1
if ! command -v node >/dev/null; then
  echo "skipped: there is no node in PATH (Debian's package is nodejs)"
  exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
files=("$source"/src/view/pages/assets/*.js)
for file in "${files[@]}"; do
  node --check "$file"
done
printf 'const x = {;\n' > "$folder/planted.js"
if node --check "$folder/planted.js" 2> /dev/null; then
  echo "a planted fault is not found"
  exit 1
fi
echo "${#files[@]} scripts are well formed, and a planted fault is found"
