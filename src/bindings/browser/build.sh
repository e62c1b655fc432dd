#!/bin/bash
# Builds the program as WebAssembly: one page that needs no network, and a package for npm.
# SPDX-License-Identifier: MIT
#
#   src/bindings/browser/build.sh OUT [GMP]
#
# OUT is a folder, which may be there from an earlier run: OUT/touchstone.html and OUT/npm are made. GMP is the unpacked
# source of GMP; where it is not given, `apt-get source gmp` fetches it. Debian's packages emscripten, nodejs, cmake,
# ninja-build, make, m4, libfmt-dev, libcli11-dev, nlohmann-json3-dev and libeigen3-dev are needed.
set -euo pipefail
(($# == 1 || $# == 2)) || {
  sed -n '5,10s/^# \{0,1\}//p' "$0" >&2
  exit 2
}
sources=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../../.." && pwd -P)
gmp=${2:+$(cd -- "$2" && pwd -P)}
mkdir -p -- "$1"
out=$(cd -- "$1" && pwd -P)
# Debian's emscripten 3.1.6 with its nodejs of 18 or later needs both.
export NODE_PATH=${NODE_PATH-/usr/share/nodejs} NODE_OPTIONS=${NODE_OPTIONS---no-experimental-fetch}

# GMP, with limbs of 64 bits.
if [[ ! -e $out/gmp/lib/libgmpxx.a ]]; then
  rm -rf -- "$out/gmp-build"
  mkdir -- "$out/gmp-build"
  cd -- "$out/gmp-build"
  if [[ -n $gmp ]]; then
    cp -r -- "$gmp" source
  else
    apt-get source -qq gmp
    mv -- gmp-*/ source
  fi
  cd source
  mkdir -p doc
  printf 'all install:\n' >doc/Makefile.in # Debian's source lacks the manual
  export limb_chosen=longlong limb_standard=longlong limb=longlong
  emconfigure ./configure --host=none --build="$(uname -m)-pc-linux-gnu" --disable-assembly --enable-cxx \
    --disable-shared --prefix="$out/gmp" CFLAGS=-O3 CXXFLAGS='-O3 -fexceptions'
  emmake make -j"$(nproc)" install
fi

# Headers alone: the libraries beside them are this machine's.
mkdir -p "$out/headers"
for name in fmt CLI nlohmann eigen3/Eigen; do ln -sfn "/usr/include/$name" "$out/headers/$(basename $name)"; done
while read -r package target definitions; do
  mkdir -p "$out/packages/$package"
  cat > "$out/packages/$package/${package}Config.cmake" <<END
if(NOT TARGET $target)
  add_library($target INTERFACE IMPORTED)
  target_compile_definitions($target INTERFACE $definitions)
endif()
END
  printf 'set(PACKAGE_VERSION_COMPATIBLE TRUE)\n' > "$out/packages/$package/${package}ConfigVersion.cmake"
done <<END
fmt fmt::fmt FMT_HEADER_ONLY
CLI11 CLI11::CLI11
nlohmann_json nlohmann_json::nlohmann_json
Eigen3 Eigen3::Eigen
END

emcmake cmake -G Ninja -S "$sources" -B "$out/build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON \
  -DCMAKE_UNITY_BUILD_BATCH_SIZE=24 -DCMAKE_CXX_FLAGS="-isystem $out/gmp/include -isystem $out/headers" \
  -DCMAKE_FIND_ROOT_PATH="$out/gmp;$out/packages" -DTOUCHSTONE_QUERIES_ONLY=ON \
  -DTOUCHSTONE_WITH_CGAL=OFF -DTOUCHSTONE_WITH_TBB=OFF \
  -DTOUCHSTONE_WITH_HDF5=OFF -DTOUCHSTONE_BUILD_PYTHON=OFF -DTOUCHSTONE_BUILD_ENGINES=OFF \
  -DTOUCHSTONE_BUILD_TIGHT_INCLUSION=OFF -DTOUCHSTONE_INSTALL=OFF
cmake --build "$out/build" --target touchstone_program
version=$(sed -n 's/^  VERSION \([0-9.]*\)$/\1/p' "$sources/CMakeLists.txt" | head -n 1)
node "$sources/src/bindings/browser/pack.mjs" "$version" "$out/build/touchstone.js" "$out/build/touchstone.wasm" \
  "$sources" "$out/touchstone.html" "$out/npm"
