#!/usr/bin/env bash
# coqc accepts the theorems of `touchstone prove --theorem`: of each kind of query and of answer, with straight and with
# curved motion. They rest on the axioms of Coq's real numbers alone. It rejects them when a verdict, a time or a
# coordinate is changed.
#
#   theorems.sh PROGRAM SEPARATION [THEORIES COQC]
#     SEPARATION: "none", or a metric and a distance
#     THEORIES: the folder of the compiled theories; without it Coq is missing
# SPDX-License-Identifier: MIT
set -euo pipefail
program=$1 separation=$2 theories=${3:-} coqc=${4:-coqc}
if [[ -z $theories ]] || ! command -v "$coqc" >/dev/null; then
  echo 'skipped: coqc, ocamlfind or Zarith is not installed (Debian: coq, ocaml-findlib and libzarith-ocaml-dev)'
  exit 77
fi
command -v python3 >/dev/null || { echo 'skipped: no python3'; exit 77; }
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd "$folder"

options=() picked='1p;$p'
if [[ $separation != none ]]; then
  read -r metric distance <<<"$separation"
  options=(--separation "$distance" --metric "$metric") picked=1p
fi
coq() { "$coqc" -q -Q "$theories" Touchstone "$1" 2>&1; }
cat >axioms <<'END'
ClassicalDedekindReals.sig_forall_dec
ClassicalDedekindReals.sig_not_dec
FunctionalExtensionality.functional_extensionality_dep
END

# One theorem: coqc accepts it. Its axioms are those; only for two edges they are asked for, which takes Coq seconds.
expect_theorem() { # LABEL NUMBER FILE
  "$program" prove "${options[@]}" --theorem "$2" --out theorem.v "$3" >/dev/null 2>&1
  [[ $1 == *edge-edge* ]] || sed -i '/^Print Assumptions/d' theorem.v
  local TIMEFORMAT=%U
  if ! { time coq theorem.v >printed; } 2>seconds; then
    cat theorem.v printed
    echo "$1: query $2 of $3: coqc rejects the theorem"
    exit 1
  fi
  if [[ $1 == *edge-edge* ]]; then
    grep -oE '^[A-Za-z_.]+' printed | grep -vx Axioms | sort >found
    diff found axioms || { echo "$1: query $2 of $3: the theorem has other assumptions"; exit 1; }
  fi
  echo "$1 $(<seconds) $2 $3" >>times
}

python3 -B "$here/random_queries.py" random
"$program" generate --curved --count 8 --out curved >/dev/null
for kind in edge-edge vertex-face point-edge point-point; do
  for motion in straight curved; do
    files=("random/$kind/random.csv")
    [[ $motion == straight ]] || files=(curved/*/"$kind"/*.csv)
    # The first query of each answer that some file has, and without a separation the last one. random_queries.py gives
    # each fifth query coordinates of sizes far apart; with a separation, numbers of many thousands of bits would take
    # Coq minutes.
    for file in "${files[@]}"; do
      "$program" prove "${options[@]}" "$file" 2>/dev/null |
        awk -v file="$file" -v all="$separation" 'all != "none" && file ~ /^random/ && $1 % 5 == 3 { next }
          $2 == "none" && NF == 2 { print "none", $1, file }
          $2 == "contact" { print ($3 == $4 ? "at" : "between"), $1, file }'
    done >answers
    for answer in none at between; do
      grep "^$answer " answers >these || continue
      sed -n "$picked" these | sort -u | while read -r _ number file; do
        expect_theorem "$motion $kind $answer" "$number" "$file"
      done
    done
  done
done
sort -n -k 4 times | awk '{ all[NR] = $4; last = $0 }
  END { print NR " theorems are accepted; processor seconds of coqc: median " all[int((NR + 1) / 2)] ", worst: " last }'
[[ $(wc -l <times) -ge 20 ]] || { cat times; echo 'too few theorems'; exit 1; }
for answer in none at between; do
  for motion in straight curved; do
    grep -q "^$motion .* $answer " times || { echo "no theorem with the answer $answer and $motion motion"; exit 1; }
  done
done
[[ $separation == none ]] || exit 0

# Two points meet halfway; two others pass each other at the distance 1/4; and two meet at 1/3.
mkdir point-point
printf '%s\n' 0,1,0,1,0,1 1,1,0,1,0,1 1,1,0,1,0,1 0,1,0,1,0,1 \
  0,1,0,1,0,1 1,1,1,4,0,1 1,1,0,1,0,1 0,1,0,1,0,1 \
  0,1,0,1,0,1 1,1,0,1,0,1 1,1,0,1,0,1 -1,1,0,1,0,1 >point-point/a.csv
# A change of the text makes a false claim, and coqc rejects it.
expect_false() { # NUMBER CHANGE: by sed
  "$program" prove --theorem "$1" point-point/a.csv | sed '/^Print Assumptions/d' >theorem.v
  coq theorem.v >/dev/null || { echo "query $1: coqc rejects the theorem"; exit 1; }
  sed -E "$2" theorem.v >changed.v
  ! cmp -s theorem.v changed.v || { echo "nothing is changed by $2"; exit 1; }
  ! coq changed.v >printed || { cat changed.v; echo "coqc accepts a false theorem"; exit 1; }
  grep -q 'Error' printed || { cat printed; echo "$2: coqc gives no reason"; exit 1; }
}
expect_false 0 's/^  \(Contact_at .*\)/  No_contact/'
expect_false 0 's/^  \(Contact_at .*\)/  (Contact_at (1 # 4))/'
expect_false 0 's/^  \(Contact_at .*\)/  (Contact_at (3 # 4))/'
expect_false 0 '/corner_q/,$s/Rational 1 0 0/Rational 1 0 (1 # 1000000)/'
expect_false 0 '/corner_q/,$s/Rational 1 0 0/Rational 2 0 0/'
expect_false 1 's/^  No_contact/  (Contact_at (1 # 2))/'
expect_false 1 's/apart := Zero/apart := Max (1 # 4)/'
expect_false 1 's/apart := Zero/apart := Euclidean 1/'
expect_false 1 's/\(1 # 4\)/0/'
expect_false 2 's/^  \(Contact_between .*\)/  No_contact/'
expect_false 2 's/^  \(Contact_between .*\)/  (Contact_at (1 # 2))/'
expect_false 2 's/^  \(Contact_between .*\)/  (Contact_between (1 # 2) (4503599627370497 # 2^53))/'
expect_false 2 's/\(Contact_between \(6004799503160661/(Contact_between (6004799503160660/'
echo 'false theorems are rejected'
