#!/usr/bin/env bash
# check_format.sh SOURCE: every C, C++ and JavaScript file is as clang-format 14 writes it with the project's
# .clang-format, and a file that is not is found. 77, "skipped", without that version: others format some lines in
# another way.
# SPDX-License-Identifier: MIT
set -euo pipefail

source=$1
version=14
format=
for candidate in "clang-format-$version" clang-format; do
  if [[ $("$candidate" --version 2> /dev/null || true) == *"version $version."* ]]; then
    format=$candidate
    break
  fi
done
if [ -z "$format" ]; then
  echo "skipped: clang-format $version is not installed (Debian and Ubuntu: the package clang-format-$version)"
  exit 77
fi

files_below() {
  find "$@" -type f \( -name '*.cpp' -o -name '*.hpp' -o -name '*.c' -o -name '*.h' -o -name '*.inl' \
    -o -name '*.js' \) -print0
}

mapfile -d '' -t files < <(cd -- "$source" && files_below include src tests fuzz)
if [ "${#files[@]}" -lt 100 ]; then
  echo "only ${#files[@]} files were found below $source"
  exit 1
fi
if ! (cd -- "$source" && "$format" --style=file --dry-run --Werror "${files[@]}"); then
  echo "not formatted; run: $format -i FILE..."
  exit 1
fi

# The same settings on a file that breaks them, so that an ineffective check shows.
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cp -- "$source/.clang-format" "$folder"
printf 'int  f( int x ){return x ;}\n' > "$folder/planted.cpp"
if "$format" --style=file --dry-run --Werror "$folder/planted.cpp" 2> /dev/null; then
  echo "a file that is not formatted is not found"
  exit 1
fi
echo "${#files[@]} files are formatted, and a planted fault is found"
