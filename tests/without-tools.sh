#!/usr/bin/env bash
# without-tools.sh COMMAND...: runs a command with a PATH in which no optional tool is found: one folder of links to all
# other programs. The tests that need such a tool must then be skipped, and nothing may fail.
# SPDX-License-Identifier: MIT
set -euo pipefail
hidden=(valgrind python clang doxygen parallel gappa chromium node zsh groff pip dask dpkg-shlibdeps coq
  ocaml)

links=$(mktemp -d)
trap 'rm -rf -- "$links"' EXIT
names=()
for name in "${hidden[@]}"; do names+=(! -name "$name*"); done
IFS=: read -r -a folders <<<"$PATH"
for folder in "${folders[@]}"; do
  # The first folder of PATH that has a program wins: ln does not replace its link.
  find "$folder/" -maxdepth 1 ! -type d "${names[@]}" -exec ln -s -t "$links" -- {} + 2>/dev/null || true
done
status=0
PATH=$links "$@" || status=$?
exit "$status"
