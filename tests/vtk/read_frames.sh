#!/usr/bin/env bash
# read_frames.sh PROGRAM: looks for a Python that has VTK and lets it read frames; 77, "skipped", when there is none.
# SPDX-License-Identifier: MIT
set -euo pipefail

here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd -P)
# The first python3 in PATH may be the user's own and not see the system's packages, so each of them is tried.
mapfile -t pythons < <(type -ap python3)
for python in ${TOUCHSTONE_PYTHON:+"$TOUCHSTONE_PYTHON"} "${pythons[@]}"; do
  if "$python" -c 'import vtkmodules.vtkIOLegacy' 2>/dev/null; then
    exec "$python" "$here/read_frames.py" "$1"
  fi
done
echo "skipped: no python3 in PATH imports VTK (Debian's package is python3-vtk9; TOUCHSTONE_PYTHON names another Python)"
exit 77
