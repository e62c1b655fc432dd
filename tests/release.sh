#!/usr/bin/env bash
# Makes what a release hands out, from the last commit of this clone, and tries it as people use it, far from here:
#   touchstone-VERSION.tar.gz       the files that git knows, the same bytes on every run; a program fetches it by
#                                   FetchContent, as docs/guide.md says
#   touchstone-VERSION-....whl      the wheel, built from that archive; Python installs it and asks a question
# Both are in build/release-artefacts when all was right; their sizes and SHA-256 are the last lines. TOUCHSTONE_PYTHON
# is the Python of the wheel, /usr/bin/python3 where it is not set. Exit status 77, "skipped", where a tool is missing.
# SPDX-License-Identifier: MIT
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=../src/setup.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../src/setup.sh"
python=${TOUCHSTONE_PYTHON:-/usr/bin/python3}

skip() {
  printf 'skipped: %s\n' "$*"
  exit 77
}
(($# == 0)) || die "'$1' is no argument of tests/release.sh: it has none"
command -v git >/dev/null || skip 'the archive has the files that git knows, and there is no git (Debian: git)'
top=$(git -C "$touchstone_root" rev-parse --show-toplevel 2>&1) || true
[[ $top == "$touchstone_root" ]] ||
  skip "the archive has the files that git knows; run it in a clone: $touchstone_root has no .git of its own: $top"
command -v cmake >/dev/null || skip 'there is no cmake (Debian: cmake)'
"$python" -c 'import setuptools, wheel, pip, numpy' 2>/dev/null ||
  skip "$python has not all of these: python3-numpy python3-pip python3-setuptools python3-wheel (Debian's names)"

scratch=$(mktemp -d "${TMPDIR:-/tmp}/touchstone-release.XXXXXX")
trap 'rm -rf -- "$scratch"' EXIT
if command -v ccache >/dev/null; then # what it remembers is of folders with other names
  export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER-ccache} CCACHE_BASEDIR=$scratch
fi

# run COMMAND...: quietly, far from the sources; a failure shows its last words.
run() {
  (cd -- "$scratch" && "$@") >"$scratch/log" 2>&1 || {
    tail -n 60 -- "$scratch/log" >&2
    die "it failed, and says why above: $*"
  }
}

# block PAGE LINE: the first block of a page of the archive that begins with this line.
block() { awk -v line="\`\`\`$2" '!on && $0 == line { on = 1; next } on && $0 == "```" { exit } on' "$tree/$1"; }

# expect WHAT TEXT: the log is this text.
expect() { [[ $(<"$scratch/log") == "$2" ]] || die "$1 says '$(<"$scratch/log")', not '$2'"; }

commit() { git -C "$touchstone_root" -c core.autocrlf=false -c core.quotePath=false -c tar.umask=0022 "$@"; }
version=$(commit show HEAD:CMakeLists.txt | sed -n 's/^ *VERSION \([0-9.]*\)$/\1/p')
name=touchstone-$version
made=$scratch/made
archive=$made/$name.tar.gz
mkdir -- "$made"
say "the archive of $name, commit $(commit describe --tags --always)"
[[ -z $(commit status --porcelain) ]] || say 'left out: changes that are not committed (git status lists them)'
pack() { commit archive --format=tar --prefix="$name/" HEAD | gzip -9n; }
pack >"$archive"
cmp <(umask 077 && TZ=Asia/Tokyo pack) "$archive" || die 'a second archive of the same commit has other bytes'
diff <(commit ls-tree -r --name-only HEAD | LC_ALL=C sort) \
  <(tar -tzf "$archive" | sed -n "s,^$name/\(.*[^/]\)$,\1,p" | LC_ALL=C sort) >&2 ||
  die 'the archive has not the files that git knows: < is missing, > is too much'

say 'the wheel, built from the archive: minutes, where ccache does not remember it'
mkdir -- "$scratch/unpacked"
tar -xzf "$archive" -C "$scratch/unpacked"
tree=$scratch/unpacked/$name
pip=("$python" -m pip --disable-pip-version-check)
run env CMAKE_ARGS="${CMAKE_ARGS:-} -DTOUCHSTONE_WARNINGS_AS_ERRORS=ON" \
  "${pip[@]}" wheel --no-build-isolation --no-deps --no-index --wheel-dir "$made" "$tree"
wheel=$(echo "$made"/*.whl)
run "${pip[@]}" install --no-deps --no-index --target "$scratch/site" "$wheel"
run env PYTHONPATH="$scratch/site" "$python" -c '
import importlib.metadata, pathlib, sys, touchstone
assert pathlib.Path(touchstone.__file__).parents[1] == pathlib.Path(sys.argv[1]), touchstone.__file__
toi = touchstone.solve("point-point", [[0, 0, 0], [1, 0, 0]], [[4, 0, 0], [1, 0, 0]]).toi
print(importlib.metadata.version("touchstone"), touchstone.__version__, toi)' "$scratch/site"
expect 'the installed wheel' "$version $version 0.25"

say 'the program of the README, with the archive by FetchContent as on docs/guide.md'
home=$scratch/home
mkdir -p -- "$home"/{first_touch,by_archive}
block README.md 'cpp ~/first_touch/main.cpp' >"$home/first_touch/main.cpp"
block docs/guide.md 'cmake ~/by_archive/CMakeLists.txt' >"$home/by_archive/CMakeLists.txt"
generator=()
! command -v ninja >/dev/null || generator=(-G Ninja)
run cmake -S "$home/by_archive" -B "$home/build" "${generator[@]}" -Werror=dev -Werror=deprecated \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DTOUCHSTONE_WARNINGS_AS_ERRORS=ON \
  -DURL="file://$archive" -DSHA256="$(sha256sum -- "$archive" | cut -d ' ' -f 1)"
! grep -n 'CMake.*Warning' -- "$scratch/log" >&2 || die 'the configuration of the archive warns'
run cmake --build "$home/build" --parallel "$(compile_jobs)"
run "$home/build/by_archive"
expect 'the fetched archive' "$(block README.md text)"

out=$touchstone_root/build/release-artefacts
mkdir -p -- "$out"
for file in "$archive" "$wheel"; do
  mv -f -- "$file" "$out"
  file=$out/${file##*/}
  printf '%s  %s bytes  sha256 %s\n' "$file" "$(stat -c %s -- "$file")" "$(sha256sum -- "$file" | cut -d ' ' -f 1)"
done
