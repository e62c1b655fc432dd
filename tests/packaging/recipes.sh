#!/usr/bin/env bash
# recipes.sh [ROOT]: the recipes in src/bindings/packaging have the project's version, name each library that the CMake
# files look for, set options that exist, name files that exist, and can be read by their languages.
# SPDX-License-Identifier: MIT
set -euo pipefail
root=${1:-$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)}
cd -- "$root/src/bindings/packaging"
failures=0 checks=0
check() { # WHAT COMMAND...: the command succeeds
  local what=$1
  shift
  checks=$((checks + 1))
  "$@" >/dev/null || {
    printf 'WRONG: %s\n' "$what"
    failures=$((failures + 1))
  }
}
not_checked() { printf 'not checked: %s\n' "$*"; }

# recipe | its line of the version | its line of a dependency
recipes=(
  'debian/control|^Package: libtouchstone@MINOR@$|^ @NAME@( \(.*\))?,$'
  'vcpkg/touchstone/vcpkg.json|"version": "@VERSION@"|"@NAME@"'
  'conan/conanfile.py|^    version = "@VERSION@"$|requires\("@NAME@/'
  'conda/recipe.yaml|^  version: "@VERSION@"$|^    - @NAME@( .*)?$'
  'spack/spack_repo/touchstone/packages/touchstone/package.py|^    version\("@VERSION@"\)$|depends_on\("@NAME@["@~]'
  'homebrew/touchstone.rb|^  version "@VERSION@"$|^  (depends_on|uses_from_macos) "@NAME@"'
)
# What CMake looks for | its name in each recipe, in that order.
libraries=(
  'CGAL|libcgal-dev|cgal|cgal|cgal-cpp|cgal|cgal'
  'CLI11|libcli11-dev|cli11|cli11|cli11|cli11|cli11'
  'EXPAT|libexpat1-dev|expat|expat|expat|expat|expat'
  'Eigen3|libeigen3-dev|eigen3|eigen|eigen|eigen|eigen'
  'TBB|libtbb-dev|tbb|onetbb|tbb-devel|tbb|tbb'
  'ZLIB|zlib1g-dev|zlib|zlib|zlib|zlib-api|zlib'
  'fmt|libfmt-dev|fmt|fmt|fmt|fmt|fmt'
  'gmp|libgmp-dev|gmp|gmp|gmp|gmp|gmp'
  'hdf5|libhdf5-dev|hdf5|hdf5|hdf5|hdf5|hdf5'
  'mpfr|libmpfr-dev|mpfr|mpfr|mpfr|mpfr|mpfr'
  'nlohmann_json|nlohmann-json3-dev|nlohmann-json|nlohmann_json|nlohmann_json|nlohmann-json|nlohmann-json'
  'Threads' # comes with the C library
  'pybind11' # of the Python module, which no recipe builds
)

version=$(sed -n 's/^ *VERSION \([0-9.]*\)$/\1/p' "$root/CMakeLists.txt")
of_project() { sed "s/@VERSION@/${version//./[.]}/; s/@MINOR@/${version%.*}/" <<<"$1"; }
check "CITATION.cff has not the version $version" grep -qx "version: $version" "$root/CITATION.cff"
check "debian/changelog does not begin with $version" \
  grep -qE "^touchstone \(${version//./[.]}-" <(head -n 1 debian/changelog)
for text in "libtouchstone${version%.*}" "touchstone@$version"; do
  check "docs/packaging.md has no $text" grep -qF "$text" "$root/docs/packaging.md"
done
check "there is no debian/libtouchstone${version%.*}.install" test -e "debian/libtouchstone${version%.*}.install"
mapfile -t wanted < <(grep -rhoE --include=CMakeLists.txt --include='*.cmake' --exclude-dir=packaging \
  '(find_package\(|find_library\(touchstone_|set\(touchstone_number_libraries )[A-Za-z0-9_ ]+' \
  "$root/CMakeLists.txt" "$root/src" |
  sed -E 's/find_package\((\w+).*/\1/; s/find_library\(touchstone_(.*)_LIBRARY.*/\1/; s/set\(\w+ //' |
  tr ' ' '\n' | LC_ALL=C sort -u)
check "only ${#wanted[@]} libraries are found in the CMake files" test "${#wanted[@]}" -ge 13
for number in "${!recipes[@]}"; do
  IFS='|' read -r recipe line dependency <<<"${recipes[number]}"
  check "$recipe has not the version $version" grep -qE "$(of_project "$line")" "$recipe"
  for library in "${wanted[@]}"; do
    row=$(printf '%s\n' "${libraries[@]}" | grep -E "^$library(\||$)") || {
      check "this test has no line for the library $library, which CMake looks for" false
      continue
    }
    name=$(cut -d '|' -f $((number + 2)) -s <<<"$row")
    [[ -z $name ]] || check "$recipe does not name $name" grep -qE -- "${dependency/@NAME@/$name}" "$recipe"
  done
done

while read -r option; do
  check "the recipes set $option, which CMakeLists.txt has not" grep -qE "(option|set)\($option " "$root/CMakeLists.txt"
done < <(grep -rhoE '\bD?TOUCHSTONE_[A-Z0-9_]+' . | sed 's/^D//' | LC_ALL=C sort -u)

# The way from a recipe to the sources, and what it names there.
up() { sed -nE "s#$1#\1#p" "$2" | tr -d '" ' | tr , /; }
for way in "vcpkg/touchstone/$(up '.*\{CURRENT_PORT_DIR\}/([./]+)".*' vcpkg/touchstone/portfile.cmake)" \
  "conan/$(up '.*recipe_folder, ([".,  ]+)\)' conan/conanfile.py)" "conda/$(up '^  path: (.*)' conda/recipe.yaml)"; do
  check "$way is not the project's folder" test "$way/CMakeLists.txt" -ef "$root/CMakeLists.txt"
done
for file in $(sed -nE 's,.*for pattern in \((.*)\):,\1,p' conan/conanfile.py | tr -d '",*') \
  $(sed -n 's/^  license_file: //p' conda/recipe.yaml); do
  check "a recipe names $file, which is not there" test -e "$root/$file"
done
check 'the README has not the program of conan/test_package' grep -qx '```cpp ~/first_touch/main.cpp' "$root/README.md"

if command -v python3 >/dev/null; then
  while read -r file; do
    check "$file is no Python" python3 -c 'import sys; compile(open(sys.argv[1]).read(), sys.argv[1], "exec")' "$file"
  done < <(find . -name '*.py')
  check 'vcpkg.json is no JSON' python3 -m json.tool vcpkg/touchstone/vcpkg.json
  if python3 -c 'import yaml' 2>/dev/null; then
    for file in conda/recipe.yaml spack/spack_repo/touchstone/repo.yaml; do
      check "$file is no YAML" python3 -c 'import sys, yaml; yaml.safe_load(open(sys.argv[1]))' "$file"
    done
  else
    not_checked 'YAML, because python3 has no yaml (Debian: python3-yaml)'
  fi
else
  not_checked 'Python, JSON and YAML, because there is no python3 (Debian: python3)'
fi
if command -v ruby >/dev/null; then
  check 'touchstone.rb is no Ruby' ruby -c homebrew/touchstone.rb
else
  not_checked 'Ruby, because there is no ruby (Debian: ruby)'
fi
if command -v dpkg-parsechangelog >/dev/null; then
  check 'debian/changelog is none' bash -c '[[ -z $(dpkg-parsechangelog -l debian/changelog 2>&1 >/dev/null) ]]'
else
  not_checked 'the changelog, because there is no dpkg-parsechangelog (Debian: dpkg-dev)'
fi
check 'conda/build.sh is no script of bash' bash -n conda/build.sh
printf '%d checks of %d recipes, %d wrong\n' "$checks" "${#recipes[@]}" "$failures"
((failures == 0))
