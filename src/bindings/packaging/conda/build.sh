#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -euo pipefail
# The compiler packages set CMAKE_ARGS: the prefix, the build type, and the toolchain where it crosses.
# shellcheck disable=SC2086
cmake -S . -B build/conda -G Ninja ${CMAKE_ARGS:-} -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_LIBDIR=lib \
  -DCMAKE_INSTALL_PREFIX="$PREFIX" -DCMAKE_PREFIX_PATH="$PREFIX" -DBUILD_SHARED_LIBS=ON \
  -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=24 \
  -DTOUCHSTONE_BUILD_TESTS=OFF -DTOUCHSTONE_BUILD_ENGINES=OFF -DTOUCHSTONE_BUILD_PYTHON=OFF
cmake --build build/conda --target touchstone_installed --parallel "${CPU_COUNT:-1}"
cmake --install build/conda
