"""What names of other programs are called here. SPDX-License-Identifier: MIT"""
from __future__ import annotations

import functools
import inspect
from typing import Any, Callable, TypeVar

_Function = TypeVar("_Function", bound=Callable[..., Any])

# The names of ipc-toolkit, Tight-Inclusion, FCL, trimesh and others, for what means the same: no rescaling, which is 1
# less what is kept.
_HERE = {
    "min_distance": "separation", "minimum_separation": "separation", "min_sep": "separation", "ms": "separation",
    "thickness": "separation", "offset": "separation", "tmax": "t_max", "max_t": "t_max",
    "n_threads": "threads", "num_threads": "threads", "workers": "threads", "n_jobs": "threads", "nthreads": "threads",
    "norm": "metric", "x_start": "start", "x_end": "end", "vertices_t0": "x0", "vertices_t1": "x1", "V0": "x0",
    "V1": "x1", "query_type": "kind", "late": "late_ulps",
}


def hinting(function: _Function) -> _Function:
    """The function, whose TypeError for another program's name of an argument says the name here."""
    names = inspect.signature(function).parameters

    @functools.wraps(function)
    def call(*arguments, **named):
        for name in named.keys() - names.keys():
            here = _HERE.get(name)
            if here in names:
                raise TypeError(f"{function.__name__}() has no argument '{name}'; here it is '{here}'")
        return function(*arguments, **named)

    return call  # type: ignore[return-value]
