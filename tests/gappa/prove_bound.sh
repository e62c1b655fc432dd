#!/usr/bin/env bash
# prove_bound.sh SOURCE SCRIPT: lets Gappa prove what the script claims of the constants that the C++ sources use, and
# checks that it proves nothing once a constant is too small. 77, "skipped", where gappa is not installed.
# With TOUCHSTONE_GAPPA_SHOW set it prints the expanded script instead.
# docs/contributing.md lists the scripts.
# SPDX-License-Identifier: MIT
set -euo pipefail
export LC_ALL=C

source=$1
script=$2
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT

fail() {
  printf '%s: %s\n' "${script##*/}" "$*"
  exit 1
}

# Directives, one a line, in comments:
#   # constant NAME FILE             NAME is the value of `constexpr double NAME = ...;` in FILE
#   # between NAME FILE |BEFORE|AFTER|  NAME is the text between BEFORE and AFTER, which stand in one line of FILE
#   # not with NAME: VALUE           with VALUE in its place, Gappa must not prove the claims
declare -A values=()
names=() weaker=()

# The text between $2 and $3 in the one line of the file $1 that has both.
text_between() {
  awk -v before="$2" -v after="$3" '
    {
      at = index($0, before)
      if (!at) next
      rest = substr($0, at + length(before))
      end = index(rest, after)
      if (!end) next
      found++
      text = substr(rest, 1, end - 1)
    }
    END { if (found != 1) exit 1; print text }' "$1"
}

# Replaces names of constants by their values. What is left must be a number that Gappa can compute exactly.
evaluate() {
  local text=$1 name
  text=${text//std::numeric_limits<double>::min()/0x1p-1022}
  for name in "${names[@]}"; do
    text=$(sed -E "s/\\b$name\\b/(${values[$name]//\//\\/})/g" <<<"$text")
  done
  [[ $text =~ ^[-0-9a-fxp.+*/\ \(\)]+$ ]] || fail "cannot read the value '$1' (a name that no directive declares?)"
  printf '%s\n' "$text"
}

while IFS= read -r line; do
  if [[ $line =~ ^'# constant '([A-Za-z]+)' '([a-z0-9_/.]+)$ ]]; then
    name=${BASH_REMATCH[1]} file=${BASH_REMATCH[2]}
    text=$(text_between "$source/$file" "constexpr double $name = " ";") ||
      fail "not once in $file: constexpr double $name"
  elif [[ $line =~ ^'# between '([A-Za-z]+)' '([a-z0-9_/.]+)' |'([^|]+)'|'([^|]+)'|'$ ]]; then
    name=${BASH_REMATCH[1]} file=${BASH_REMATCH[2]}
    text=$(text_between "$source/$file" "${BASH_REMATCH[3]}" "${BASH_REMATCH[4]}") ||
      fail "not once in $file: '${BASH_REMATCH[3]} ... ${BASH_REMATCH[4]}'"
  elif [[ $line =~ ^'# not with '([A-Za-z]+)': '(.+)$ ]]; then
    weaker+=("${BASH_REMATCH[1]}=${BASH_REMATCH[2]}")
    continue
  elif [[ $line =~ ^'# '(constant|between|not\ with)' ' ]]; then
    fail "cannot read the directive '$line'"
  else
    continue
  fi
  values[$name]=$(evaluate "$text") || { printf '%s\n' "${values[$name]:-}"; exit 1; }
  names+=("$name")
done <"$script"
[[ ${#names[@]} -gt 0 ]] || fail 'it takes no constant from the sources'

# Gappa's text of the script. A line that begins with "xyz:" goes on up to a ";" or "\" at a line's end and stands for
# three, in which _i, _j, _k are _x, _y, _z; _y, _z, _x; and _z, _x, _y. "every PREFIX <= NUMBER" bounds the absolute
# value of each variable whose name begins so. @NAME@ is a value.
expand() {
  local text name
  text=$(awk '
    function along(line, i, j, k) {
      sub(/xyz: /, "", line)
      gsub(/_i/, "_" i, line); gsub(/_j/, "_" j, line); gsub(/_k/, "_" k, line)
      print line
    }
    /^ *#/ || /^ *$/ { next }
    /^ *xyz: / {
      line = $0
      while (line !~ /[;\\]$/ && (getline more) > 0) { sub(/^ */, " ", more); line = line more }
      along(line, "x", "y", "z"); along(line, "y", "z", "x"); along(line, "z", "x", "y")
      next
    }
    { print }' "$script")
  for name in "${names[@]}"; do
    text=${text//"@$name@"/"(${values[$name]})"}
  done
  awk '
    { lines[NR] = $0 }
    END {
      for (n = 1; n <= NR; n++) {
        rest = lines[n]
        while (match(rest, /[A-Za-z][A-Za-z0-9_]*/)) {
          word = substr(rest, RSTART, RLENGTH)
          rest = substr(rest, RSTART + RLENGTH)
          if (!(word in seen)) { seen[word] = 1; words[++count] = word }
        }
      }
      for (n = 1; n <= NR; n++) {
        while (match(lines[n], /every [a-z]+_ <= [-0-9.a-z]+/)) {
          split(substr(lines[n], RSTART, RLENGTH), part, " ")
          text = ""
          for (w = 1; w <= count; w++)
            if (index(words[w], part[2]) == 1 && words[w] != part[2])
              text = text (text == "" ? "" : " /\\ ") "|" words[w] "| <= " part[4]
          if (text == "") exit 1
          lines[n] = substr(lines[n], 1, RSTART - 1) text substr(lines[n], RSTART + RLENGTH)
        }
        print lines[n]
      }
    }' <<<"$text"
}

expand >"$folder/script.g" || fail 'no variable has the prefix of an "every"'
! grep -q '@k' "$folder/script.g" || fail "no directive declares $(grep -o '@k[A-Za-z]*@' "$folder/script.g" | head -n 1)"
if [[ ${TOUCHSTONE_GAPPA_SHOW:-} ]]; then
  cat "$folder/script.g"
  exit
fi
if ! command -v gappa >/dev/null; then
  echo 'skipped: gappa is not installed (the package gappa of Debian, Ubuntu and Fedora)'
  exit 77
fi

# Gappa takes a hint whose sides it cannot show to be equal as true, with a warning. So no warning is allowed, but for
# the one of a search that gives up.
strange() { grep -i 'warning\|syntax' "$folder/said" | grep -qv 'maximum number of iterations'; }
proves() {
  gappa -Eprecision=128 -Eno-auto-dichotomy -Edichotomy=12 "$folder/script.g" >"$folder/said" 2>&1 && ! strange
}

if ! proves; then
  cat "$folder/said"
  for name in "${names[@]}"; do echo "$name = ${values[$name]}"; done
  fail 'not proved'
fi
for name in "${names[@]}"; do printf 'proved with %s = %s\n' "$name" "${values[$name]}"; done

[[ ${#weaker[@]} -gt 0 ]] || fail 'it names no value that breaks it'
for entry in "${weaker[@]}"; do
  name=${entry%%=*}
  [[ ${values[$name]:-} ]] || fail "no directive declares $name"
  kept=${values[$name]}
  values[$name]=$(evaluate "${entry#*=}")
  expand >"$folder/script.g"
  ! proves || fail "proved as well with $name = ${values[$name]}"
  if strange; then
    cat "$folder/said"
    fail "no proof was tried with $name = ${values[$name]}"
  fi
  printf 'not proved with %s = %s\n' "$name" "${values[$name]}"
  values[$name]=$kept
done
