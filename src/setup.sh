# Sourced by src/certify-bundled.sh and the scripts of tests/: installs what is missing, configures and builds.
# shellcheck shell=bash
# SPDX-License-Identifier: MIT

touchstone_root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)

say() { printf '==> %s\n' "$*" >&2; }
die() {
  printf 'error: %s\n' "$*" >&2
  exit 3
}

# What the build needs: name | how to tell that it is there | package for apt-get | dnf | pacman.
# A name with a '.' is a header, given by the alternatives that hold it; the others are commands.
readonly -a touchstone_needs=(
  'compiler|c++ g++ clang++|g++|gcc-c++|gcc'
  'cmake|cmake|cmake|cmake|cmake'
  'ninja|ninja ninja-build|ninja-build|ninja-build|ninja'
  'cgal.h|CGAL/version.h|libcgal-dev|CGAL-devel|cgal'
  'gmp.h|gmp.h|libgmp-dev|gmp-devel|gmp'
  'mpfr.h|mpfr.h|libmpfr-dev|mpfr-devel|mpfr'
  'eigen.h|eigen3/Eigen/Core Eigen/Core|libeigen3-dev|eigen3-devel|eigen'
  'tbb.h|tbb/version.h oneapi/tbb/version.h|libtbb-dev|tbb-devel|onetbb'
  'fmt.h|fmt/core.h|libfmt-dev|fmt-devel|fmt'
  'json.h|nlohmann/json.hpp|nlohmann-json3-dev|json-devel|nlohmann-json'
  'cli11.h|CLI/CLI.hpp|libcli11-dev|cli11-devel|cli11'
  'catch.h|catch2/catch.hpp catch2/catch_all.hpp|catch2|catch-devel|catch2'
)

# Optional libraries and tools: the set-up installs them where it can, and goes on where it cannot. Without them the
# program reads no HDF5 files and no XML files of VTK, and there is no Python module.
readonly -a touchstone_tools=(
  'python3|python3|python3|python3|python'
  'hdf5.h|hdf5.h hdf5/serial/hdf5.h|libhdf5-dev|hdf5-devel|hdf5'
  'expat.h|expat.h|libexpat1-dev|expat-devel|expat'
  'zlib.h|zlib.h|zlib1g-dev|zlib-devel|zlib'
  'python.h|python3.9/Python.h python3.10/Python.h python3.11/Python.h python3.12/Python.h python3.13/Python.h python3.14/Python.h|python3-dev|python3-devel|python'
  'pybind11.h|pybind11/pybind11.h|pybind11-dev|pybind11-devel|pybind11'
  'f2py|f2py3 f2py|python3-numpy|python3-numpy-f2py|python-numpy'  # it comes with NumPy
)

# Optional tools of the tests: without them the tests that need them are skipped. The set-up of the tests alone
# installs them.
readonly -a touchstone_test_tools=(
  'valgrind|valgrind|valgrind|valgrind|valgrind'
  'gappa|gappa|gappa|gappa| '  # Arch Linux has no package of it
  'pytest|pytest-3 pytest py.test-3|python3-pytest|python3-pytest|python-pytest'
  'pip|pip3 pip|python3-pip python3-setuptools python3-wheel|python3-pip python3-setuptools python3-wheel|python-pip python-setuptools python-wheel'
  'meshio|meshio|python3-meshio|python3-meshio| '  # Arch Linux has it in the AUR alone
  'dask|dask-scheduler|python3-distributed|python3-distributed|python-distributed'
  'dpkg-dev|dpkg-shlibdeps|dpkg-dev|dpkg-dev|dpkg'
  'file|file|file|file|file'
  'parallel|parallel|parallel|parallel|parallel'
  'groff|groff|groff-base|groff|groff'
  'zsh|zsh|zsh|zsh|zsh'
)

compiler() {
  local name
  for name in ${CXX:+"$CXX"} c++ g++ clang++; do
    if command -v "$name" >/dev/null; then
      printf '%s\n' "$name"
      return
    fi
  done
  return 1
}

# What fuzz/run.sh needs beyond that: clang, and its run-time libraries, which Debian has in a package of their own.
readonly -a touchstone_fuzz_needs=(
  'fuzzer|fuzzer|clang libclang-rt-dev|clang compiler-rt|clang compiler-rt'
)

# A clang that links libFuzzer.
fuzzing_clang() {
  local name
  for name in ${CXX:+"$CXX"} clang++; do
    command -v "$name" >/dev/null || continue
    if "$name" -x c++ -fsanitize=fuzzer,address,undefined -o /dev/null - 2>/dev/null \
      <<<'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }'; then
      printf '%s\n' "$name"
      return
    fi
  done
  return 1
}

# The names in `needs` that are not there, one a line. Without a compiler no header can be looked for, so all headers
# count as missing.
missing_needs() {
  local need name places place cxx probe=''
  cxx=$(compiler) || cxx=''
  for need in "${needs[@]}"; do
    IFS='|' read -r name places _ <<<"$need"
    if [[ $name == fuzzer ]]; then
      fuzzing_clang >/dev/null || printf '%s\n' "$name"
    elif [[ $name == compiler ]]; then
      [[ -n $cxx ]] || printf '%s\n' "$name"
    elif [[ $name != *.* ]]; then
      for place in $places; do
        command -v "$place" >/dev/null && continue 2
      done
      printf '%s\n' "$name"
    elif [[ -z $cxx ]]; then
      printf '%s\n' "$name"
    else
      probe+="#if !(0"
      for place in $places; do probe+=" || __has_include(<$place>)"; done
      probe+=$')\n'"missing $name"$'\n#endif\n'
    fi
  done
  [[ -z $probe ]] || "$cxx" -E -P -x c++ - <<<"$probe" | sed -n 's/^missing //p'
}

# Column `which` of `needs` for the names that follow, one package a line.
packages_for() {
  local which=$1 need name fields
  shift
  for name in "$@"; do
    for need in "${needs[@]}"; do
      IFS='|' read -r -a fields <<<"$need"
      [[ ${fields[0]} != "$name" ]] || tr ' ' '\n' <<<"${fields[$which]}"
    done
  done
}

as_root() {
  if ((EUID == 0)); then
    "$@"
  elif [[ -t 0 ]]; then
    sudo "$@"
  else
    sudo -n "$@"
  fi
}

# The packages of the needs that follow, for `manager`.
packages() {
  local column=2
  case $manager in
    dnf) column=3 ;;
    pacman) column=4 ;;
  esac
  packages_for "$column" "$@" | paste -sd ' ' -
}

# try_to_install NAME...: installs the packages of these needs with `manager`, or leaves in `trouble` why it cannot.
try_to_install() {
  local -a wanted
  read -r -a wanted <<<"$(packages "$@")"
  if [[ $manager == none ]]; then
    trouble='no apt-get, dnf or pacman here'
    return 1
  elif ((EUID != 0)) && ! command -v sudo >/dev/null; then
    trouble='not root and no sudo'
    return 1
  elif ! as_root true; then
    trouble='sudo refused'
    return 1
  fi
  say "installing with $manager: ${wanted[*]}"
  trouble="$manager failed (no network?)"
  case $manager in
    apt-get)
      as_root apt-get update -q >&2 || return 1
      as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${wanted[@]}" \
        </dev/null >&2
      ;;
    dnf) as_root dnf install -y "${wanted[@]}" </dev/null >&2 ;;
    pacman) as_root pacman -S --needed --noconfirm "${wanted[@]}" </dev/null >&2 ;;
  esac
}

# Leaves this machine's package manager in `manager`, or none.
find_manager() {
  for manager in apt-get dnf pacman; do
    ! command -v "$manager" >/dev/null || return 0
  done
  manager=none
}

# What a build of the Python module alone lacks, in one line with the packages. CMake itself names what is missing of
# Python.
what_the_module_lacks() {
  local -a needs=() missing
  local need manager
  for need in "${touchstone_needs[@]}"; do
    case ${need%%|*} in
      compiler | cmake | cgal.h | gmp.h | mpfr.h | tbb.h) needs+=("$need") ;;
      ninja) command -v make >/dev/null || needs+=("$need") ;;
    esac
  done
  mapfile -t missing < <(missing_needs)
  ((${#missing[@]})) || return 0
  find_manager
  printf 'missing here: %s; please install by hand: %s\n' "${missing[*]}" "$(packages "${missing[@]}")"
}

# install_missing [fuzz|tests]: what the build needs, what fuzzing needs when asked, and the optional tools, those of
# the tests when asked.
install_missing() {
  local -a needs missing
  local manager trouble='still missing after the install'
  find_manager

  needs=("${touchstone_needs[@]}")
  [[ ${1:-} != fuzz ]] || needs+=("${touchstone_fuzz_needs[@]}")
  mapfile -t missing < <(missing_needs)
  if ((${#missing[@]})); then
    ! try_to_install "${missing[@]}" || trouble='still missing after the install'
    mapfile -t missing < <(missing_needs)
    ((${#missing[@]} == 0)) || die "$trouble: ${missing[*]}; please install by hand: $(packages "${missing[@]}")"
  fi

  needs=("${touchstone_tools[@]}")
  [[ ${1:-} != tests ]] || needs+=("${touchstone_test_tools[@]}")
  mapfile -t missing < <(missing_needs)
  if ((${#missing[@]})); then
    ! try_to_install "${missing[@]}" || trouble='still missing after the install'
    mapfile -t missing < <(missing_needs)
    ((${#missing[@]} == 0)) || say "$trouble; going on without ${missing[*]}, to be installed by hand: $(packages "${missing[@]}")"
  fi
}

core_count() { getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1; }

# One compile job a core, and no more than one for each 2 GiB of memory that is free: CGAL's templates need up to that.
compile_jobs() {
  local jobs memory_kib=0 limit limit_kib
  jobs=$(core_count)
  if [[ -r /proc/meminfo ]]; then
    memory_kib=$(sed -n 's/^MemAvailable: *\([0-9]*\) kB/\1/p' /proc/meminfo)
  fi
  if [[ -r /sys/fs/cgroup/memory.max ]] && read -r limit </sys/fs/cgroup/memory.max && [[ $limit != max ]]; then
    limit_kib=$((limit / 1024))
    ((limit_kib < memory_kib)) && memory_kib=$limit_kib
  fi
  if ((memory_kib > 0 && jobs > memory_kib / (2 * 1024 * 1024))); then
    jobs=$((memory_kib / (2 * 1024 * 1024)))
  fi
  ((jobs >= 1)) || jobs=1
  printf '%s\n' "$jobs"
}

# build_preset PRESET TARGET OPTION...: after install_missing. Configures with the options given and builds into
# $touchstone_root/build/PRESET, by ccache where it is installed. An empty target stands for those of the preset.
build_preset() {
  local preset=$1 target=$2 jobs version launcher=()
  shift 2
  ! command -v ccache >/dev/null || launcher=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  version=$(cmake --version | sed -n '1s/[^0-9]*\([0-9.]*\).*/\1/p')
  [[ $(printf '%s\n' 3.21 "$version" | sort -V | head -n 1) == 3.21 ]] ||
    die "cmake $version is too old: the presets need 3.21 or newer"
  jobs=$(compile_jobs)
  cd -- "$touchstone_root" || exit 3
  say "configuring build/$preset"
  cmake --preset "$preset" "${launcher[@]}" "$@" >&2 || die "cmake failed"
  say "building build/$preset with $jobs jobs at a time"
  cmake --build --preset "$preset" --parallel "$jobs" ${target:+--target "$target"} >&2 || die "the build failed"
}
