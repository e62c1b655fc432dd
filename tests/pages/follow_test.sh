#!/usr/bin/env bash
# follow.sh and figures.sh find a planted mistake on a page, and accept a page that is right.
#   follow_test.sh ROOT SCRATCH CMAKE
# SPDX-License-Identifier: MIT
set -euo pipefail
project=$1 scratch=$2 cmake=$3
follow=$project/tests/pages/follow.sh
rm -rf -- "$scratch"
mkdir -p -- "$scratch/tree"
failures=0

# expect STATUS NAME: the page on standard input is right (0) or wrong (1), and its log has the words that follow.
expect() {
  local status=0 wanted=$1 name=$2 word
  shift 2
  cat >"$scratch/tree/page.md"
  "$follow" page.md "$scratch/tree" "$scratch/home" "$cmake" >"$scratch/log" 2>&1 || status=$?
  if ((status != wanted)); then
    printf '%s: exit status %s, not %s\n' "$name" "$status" "$wanted"
    cat "$scratch/log"
    failures=$((failures + 1))
  fi
  for word in "$@"; do
    grep -qF -- "$word" "$scratch/log" && continue
    printf '%s: its log does not say: %s\n' "$name" "$word"
    cat "$scratch/log"
    failures=$((failures + 1))
  done
}

expect 0 'a right page' '3 of them commands' 'not run here: it runs every test' <<'END'
```text ~/new/file
seven
```
```sh
cd ~/new   # one shell for all commands
export WORD=here
```
```sh
cat file; echo "$WORD"; \
  echo "it took 0.3 s"
false            # exit status 1
```
```text
seven
here
it took ... s
```
```sh
tests/run-all.sh
```
```text
whatever it prints
```
END
expect 0 'lines left out' <<'END'
```sh
printf 'a\nb\nc\nd*\n'
```
```text
a
...
d*
```
END
expect 1 'another output' 'shows another output' <<'END'
```sh
echo eight
```
```text
seven
```
END
expect 1 'a line too few' 'shows another output' <<'END'
```sh
printf 'a\nb\n'
```
```text
a
```
END
expect 1 'a dot is a dot' <<'END'
```sh
echo a5b
```
```text
a.b
```
END
expect 1 'a command that fails' 'exit status 3, not 0' <<'END'
```sh
(exit 3)
```
END
expect 1 'a command that succeeds though the page says that it fails' 'exit status 0, not 1' <<'END'
```sh
true   # exit status 1
```
END
expect 1 'a block without end' 'has no end' <<'END'
```sh
true
END

# A figure that changes in a CSV file or on the page is found.
figures=$project/tests/pages/figures.sh
mkdir -p -- "$scratch/copy"
for changed in nothing bench.csv ../accuracy-and-speed.md; do
  rm -rf -- "$scratch/copy/docs"
  cp -r -- "$project/docs" "$scratch/copy/docs"
  wanted=0
  if [[ $changed != nothing ]]; then
    wanted=1
    awk -F, -v OFS=, '/point-point.all,oracle/ { $6 = 1 } / wrong on 0 of / { sub(/on 0/, "on 1") } { print }' \
      "$project/docs/accuracy-and-speed/$changed" >"$scratch/copy/docs/accuracy-and-speed/$changed"
  fi
  status=0
  "$figures" "$scratch/copy" >"$scratch/log" 2>&1 || status=$?
  if ((status != wanted)); then
    printf 'figures.sh with a change in %s: exit status %s, not %s\n' "$changed" "$status" "$wanted"
    cat "$scratch/log"
    failures=$((failures + 1))
  fi
done
exit $((failures > 0))
