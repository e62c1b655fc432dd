#!/usr/bin/env bash
# Both checkers accept the proofs of the bundled queries, and neither accepts a changed proof of another answer.
#
#   second_checker.sh PROGRAM CHECKER QUERIES      QUERIES is the folder of the bundled queries
# SPDX-License-Identifier: MIT
set -euo pipefail
program=$1 checker=$2 queries=$3
command -v python3 >/dev/null || { echo "skipped: no python3"; exit 77; }
here=$(dirname -- "${BASH_SOURCE[0]}")
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT

files=("$queries"/{edge-edge,vertex-face,point-edge,point-point}/*.csv)
"$program" prove --out "$folder/proofs.txt" "${files[@]}"
by_us=$("$checker" "$folder/proofs.txt" "${files[@]}")
by_page=$(python3 -B "$here/check_proofs.py" "$folder/proofs.txt" "${files[@]}")
by_us=$(tail -n 1 <<<"$by_us")
echo "$by_us"
[[ $by_us == "$by_page" ]] || { echo "the second checker says: $by_page"; exit 1; }
python3 -B "$here/mutate_proofs.py" "$folder/proofs.txt" "${files[@]}"
# A changed proof costs the first checker a process of its own.
some=("$queries"/edge-edge/{irrational_times,not_doubles}.csv "$queries"/point-edge/{misses,rational_times}.csv)
for file in "${some[@]}"; do [[ -e $file ]] || { echo "no $file"; exit 1; }; done
"$program" prove --out "$folder/some.txt" "${some[@]}"
python3 -B "$here/mutate_proofs.py" --checker "$checker" "$folder/some.txt" "${some[@]}"
