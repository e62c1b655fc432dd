# Cross-builds for 64-bit ARM with Debian's g++-aarch64-linux-gnu, and runs the tests by qemu-user. The libraries are
# Debian's :arm64 packages, which lie beside the machine's own (docs/contributing.md names them).
# SPDX-License-Identifier: MIT
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_C_FLAGS_INIT -Wno-psabi)  # GCC's notes on how older versions passed some classes
set(CMAKE_CXX_FLAGS_INIT -Wno-psabi)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64)
