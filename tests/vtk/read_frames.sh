#!/usr/bin/env bash
# read_frames.sh PROGRAM: looks for a Python that has VTK and lets it read frames; 77, "skipped", when there is none.
# SPDX-License-Identifier: MIT
set -euo pipefail

here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd -P)
# A python3 of one's own may come first in PATH and not see the system's packages.
for python in ${TOUCHSTONE_PYTHON:+"$TOUCHSTONE_PYTHON"} python3 /usr/bin/python3; do
  if "$python" -c 'import vtkmodules.vtkIOLegacy' 2>/dev/null; then
    exec "$python" "$here/read_frames.py" "$1"
  fi
done
echo "skipped: no Python here imports vtk (python3-vtk9 on Debian and Ubuntu, or name one by TOUCHSTONE_PYTHON)"
exit 77
