#!/usr/bin/env bash
# The checker that is proved in Coq accepts the proofs of the bundled queries, of simulated ones, of degenerate ones and
# of curved ones, and prints what touchstone-check prints. It rejects flipped verdicts, and says what touchstone-check
# says of changed proofs.
#
#   same_answers.sh PROGRAM CHECKER PROVED CHECKS PROVED_CHECKS QUERIES SEPARATION
#
# CHECKS and PROVED_CHECKS are the programs of ../proofs/checks.cpp and checks.ml. SEPARATION: "none", or a metric and a
# distance.
# SPDX-License-Identifier: MIT
set -euo pipefail
program=$1 checker=$2 proved=$3 checks=$4 proved_checks=$5 queries=$6 separation=$7
command -v python3 >/dev/null || { echo "skipped: no python3"; exit 77; }
here=$(dirname -- "${BASH_SOURCE[0]}")
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT

options=()
if [[ $separation != none ]]; then
  read -r metric distance <<<"$separation"
  options=(--separation "$distance" --metric "$metric")
fi
both_accept() { # PROOFS FILE...: the files are proved, and both checkers print the same
  "$program" prove "${options[@]}" --out "$1" "${@:2}" >/dev/null 2>"$folder/warnings.txt"
  "$checker" "$@" >"$folder/checker.txt"
  "$proved" "$@" >"$folder/proved.txt"
  diff "$folder/checker.txt" "$folder/proved.txt"
  tail -n 1 "$folder/proved.txt"
}

bundled=("$queries"/{edge-edge,vertex-face,point-edge,point-point}/*.csv)
both_accept "$folder/bundled.txt" "${bundled[@]}"
python3 -B "$here/random_queries.py" "$folder/random"
random=("$folder"/random/*/random.csv)
both_accept "$folder/random.txt" "${random[@]}"

# The simulated queries are small, and so is their separation.
[[ $separation == none ]] || options[1]=0.001
"$program" generate --count 1000 "${options[@]}" --out "$folder/simulated" >/dev/null
both_accept "$folder/simulated.txt" "$folder"/simulated/*/*/*.csv

[[ $separation == none ]] || options[1]=$distance
"$program" generate --curved --count 8 --out "$folder/curved" >/dev/null
curved=("$folder"/curved/*/*/*.csv)
both_accept "$folder/curved.txt" "${curved[@]}"

compare() { # MUTANTS PROVED OPTION_OR_FILE...: the three checkers say the same
  python3 -B "$here/compare_checkers.py" --mutants "$1" --checker "$checker" --many "$checks" --proved "${@:2}"
}
# A checker that accepts all is found out.
if compare 60 "$(command -v true)" "$folder/random.txt" "${random[@]}" >/dev/null 2>&1; then
  echo 'compare_checkers.py finds no difference to a program that accepts all'
  exit 1
fi
compare 2000 "$proved" --many-proved "$proved_checks" "$folder/bundled.txt" "${bundled[@]}"
compare 2000 "$proved" --many-proved "$proved_checks" "$folder/random.txt" "${random[@]}"
compare 300 "$proved" --many-proved "$proved_checks" "$folder/curved.txt" "${curved[@]}"
