#!/usr/bin/env bash
# The program as WebAssembly beside the native one, in Node and in a browser.
#
#   run.sh FOLDER touchstone QUERIES   FOLDER is what src/bindings/browser/build.sh made; empty: skipped
#
# Exit status 77, "skipped", when something is missing. SPDX-License-Identifier: MIT
set -euo pipefail
folder=$1 native=$2 queries=$3
here=$(dirname -- "${BASH_SOURCE[0]}")
skip() {
  printf 'skipped: %s\n' "$*"
  exit 77
}
[[ -n $folder ]] || skip 'TOUCHSTONE_BROWSER does not name a folder that src/bindings/browser/build.sh made'
command -v node >/dev/null || skip 'there is no node in PATH (Debian: nodejs)'
size=$(stat -c %s -- "$folder/touchstone.html")
echo "touchstone.html has $size bytes"
((size <= 2000000)) || { echo 'that is more than 2 MB'; exit 1; }
package=$folder/npm
if command -v npm >/dev/null; then
  packed=$(mktemp -d)
  trap 'rm -rf -- "$packed"' EXIT
  (cd -- "$package" && npm pack --silent --pack-destination "$packed")
  tar -xzf "$packed"/*.tgz -C "$packed"
  package=$packed/package
else
  echo 'there is no npm in PATH (Debian: npm): the folder is tested, not its archive'
fi
node "$here/same_bytes.mjs" "$package" "$native" "$queries"
"$here/../view/run.sh" "$here/test_page.py" "$native" "$folder/touchstone.html" "$queries"
