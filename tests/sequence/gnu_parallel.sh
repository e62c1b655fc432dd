#!/usr/bin/env bash
# gnu_parallel.sh TOUCHSTONE: shards of a sequence, run by GNU parallel and then by xargs, give the report of one run.
# SPDX-License-Identifier: MIT
set -euo pipefail
touchstone=$1

if ! parallel --version 2>/dev/null | grep -q '^GNU parallel'; then
  echo 'skipped: GNU parallel is not installed (Debian: parallel)'
  exit 77
fi

folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
export HOME=$folder  # parallel keeps its state there
mkdir -p "$folder/.parallel" && touch "$folder/.parallel/will-cite"
cd "$folder"

# A spike falls through a triangle in step 5 -> 6; there are twelve frames.
for k in 0 1 2 3 4 5 6 7 8 9 10 11; do
  z=$((11 - 2 * k))
  printf 'v %s\n' '-9 -9 0' '9 -9 0' '0 9 0' "0 0 $z" "1 0 $((z + 90))" "0 1 $((z + 90))" >"spike-$k.obj"
  printf 'f %s\n' '1 2 3' '4 5 6' >>"spike-$k.obj"
done

status_of() {
  local status=0
  "$@" >>"$folder/log" 2>&1 || status=$?
  echo "$status"
}
check() {
  if [[ $2 != "$3" ]]; then
    echo "$1: $2, not $3"
    cat "$folder/log"
    exit 1
  fi
}

check 'the status of one run' "$(status_of "$touchstone" mesh --report whole.json spike-*.obj)" 1
crossing='"from":5,"to":6,"free":false,"toi":"0x1p-1"'
check 'the crossings in the report' "$(grep -c "$crossing" whole.json)" 1

# One of four shards ends with status 1, because its steps are not free; parallel counts such jobs.
shard=("$touchstone" mesh --threads 1)
check 'the jobs that are not free' \
  "$(status_of parallel --jobs 2 "${shard[@]}" --shard {}/4 --report part-{}.json 'spike-*.obj' ::: 1 2 3 4)" 1
check 'the status of the merge' "$(status_of "$touchstone" merge --out merged.json part-*.json)" 1
cmp merged.json whole.json

rm part-*.json merged.json
by_xargs() { seq 3 | xargs -P 2 -I{} "${shard[@]}" --shard {}/3 --report part-{}.json 'spike-*.obj'; }
check 'the status of xargs' "$(status_of by_xargs)" 123
check 'the status of the merge' "$(status_of "$touchstone" merge --out merged.json part-*.json)" 1
cmp merged.json whole.json
echo 'shards by parallel and by xargs give the report of one run'
