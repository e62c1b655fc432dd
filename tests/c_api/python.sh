#!/usr/bin/env bash
# python.sh LIBRARY: Python's ctypes calls the shared library through touchstone/c.h. 77, "skipped", when the library is
# a static one, is built with a sanitizer, or Python is missing.
# SPDX-License-Identifier: MIT
set -euo pipefail

library=$1
case $library in
  *.a | *.lib)
    echo "skipped: the library is static; configure with -DBUILD_SHARED_LIBS=ON"
    exit 77
    ;;
esac
if ! command -v python3 > /dev/null; then
  echo "skipped: python3 is not installed"
  exit 77
fi
if nm -D "$library" 2> /dev/null | grep -q '__[at]san_'; then
  echo "skipped: Python is not built with the library's sanitizer"
  exit 77
fi
exec python3 "$(dirname "$0")/call_from_python.py" "$library"
