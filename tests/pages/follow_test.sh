#!/usr/bin/env bash
# A planted mistake on a page is found by follow.sh, and a page that is right is found right.
#   follow_test.sh FOLLOW_SH SCRATCH CMAKE
# SPDX-License-Identifier: MIT
set -euo pipefail
follow=$1 scratch=$2 cmake=$3
rm -rf -- "$scratch"
mkdir -p -- "$scratch/root"
failures=0

# expect STATUS NAME: the page on standard input is right (0) or wrong (1), and its log has the words that follow.
expect() {
  local status=0 wanted=$1 name=$2 word
  shift 2
  cat >"$scratch/root/page.md"
  "$follow" page.md "$scratch/root" "$scratch/home" "$cmake" >"$scratch/log" 2>&1 || status=$?
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
exit $((failures > 0))
