#!/usr/bin/env bash
# The theorems of the proved checker rest on the axioms of Coq's real numbers and on nothing else, and docs/proved.md
# shows what they say: the text of Statement.v and the theorems.
#
#   assumptions.sh SOURCE [THEORIES COQC]     THEORIES: the folder of the compiled theories; without it Coq is missing
# SPDX-License-Identifier: MIT
set -euo pipefail
source=$1 theories=${2:-} coqc=${3:-coqc}
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT

# The text between ```coq and ``` on the page, each block after the other.
awk '/^```coq$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$source/docs/proved.md" >"$folder/page"
{
  awk 'found || /^From Coq/ { found = 1; print }' "$source/src/proofs/proved/Statement.v"
  grep -h '^Theorem \(check_sound\|step_sound\)' "$source"/src/proofs/proved/{Checker,Motions}.v
} >"$folder/sources"
diff "$folder/page" "$folder/sources" || { echo 'docs/proved.md shows another text than the theories'; exit 1; }
[[ $(grep -c . "$folder/page") -le 100 ]] || { echo "the statement is longer than 100 lines"; exit 1; }
! grep -nE '\b(Admitted|Axiom|Parameter|Conjecture|admit|Abort)\b' "$source"/src/proofs/proved/*.v
echo 'the page shows the statement'

if [[ -z $theories ]] || ! command -v "$coqc" >/dev/null; then
  echo 'skipped: coqc is not installed (Debian and Ubuntu: the package coq)'
  exit 77
fi
axioms_of() { # NAME FILE: the names of the axioms behind NAME after the lines of FILE
  { cat "$2"; printf 'Print Assumptions %s.\n' "$1"; } >"$folder/asked.v"
  (cd "$folder" && "$coqc" -q -Q "$theories" Touchstone asked.v) | grep -oE '^[A-Za-z_.]+' | grep -vx Axioms | sort
}
cat >"$folder/expected" <<'END'
ClassicalDedekindReals.sig_forall_dec
ClassicalDedekindReals.sig_not_dec
FunctionalExtensionality.functional_extensionality_dep
END
echo 'From Touchstone Require Import Checker Motions.' >"$folder/theorem.v"
for theorem in check_sound step_sound; do
  axioms_of "$theorem" "$folder/theorem.v" >"$folder/axioms"
  diff "$folder/axioms" "$folder/expected" || { echo "$theorem has other assumptions"; exit 1; }
done
cat "$folder/axioms"

# An axiom more shows.
{
  cat "$folder/theorem.v"
  echo 'Axiom everything_holds : forall q a, Statement.holds q a.'
  echo 'Theorem planted : forall q a p, check q a p = true -> Statement.holds q a.'
  echo 'Proof. intros; apply everything_holds. Qed.'
} >"$folder/planted.v"
[[ $(axioms_of planted "$folder/planted.v") == *everything_holds* ]] || { echo 'a planted axiom is not found'; exit 1; }
