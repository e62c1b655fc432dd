"""What is said of wrong arguments, and what names of other programs are called here. SPDX-License-Identifier: MIT"""
from __future__ import annotations

import functools
import inspect
import numbers
import re
from typing import Any, Callable, Dict, Iterable, Tuple, TypeVar

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


# What an argument must be, by the name that pybind11 has for its type.
_RIGHT: Dict[str, Tuple[Any, str]] = {
    "bool": (bool, "a bool"), "int": (numbers.Integral, "a whole number"), "float": (numbers.Real, "a number"),
    "str": (str, "a string"), "Iterable": (Iterable, "a list"),
}


def shown(value: Any) -> str:
    """A value in a message: itself where it is short, or else its type."""
    if value is None or isinstance(value, (str, bytes, bool, int, float)) and len(repr(value)) <= 60:
        return f"is {value!r}"
    return f"is of type {type(value).__name__}"


def _right_type(type_name: str) -> Tuple[Any, str]:
    from . import _core
    name = type_name.rpartition(".")[2]
    return _RIGHT.get(type_name, (getattr(_core, name, object), f"a touchstone.{name}"))


def _signature(text: str) -> inspect.Signature:
    """What pybind11 writes as 'name(a: int, *, b: bool = True) -> object'."""
    kind: Any = inspect.Parameter.POSITIONAL_OR_KEYWORD
    parameters = []
    for one in filter(None, text[text.index("(") + 1:text.rindex(")")].split(", ")):
        if one == "*":
            kind = inspect.Parameter.KEYWORD_ONLY
            continue
        head, has_default, default = one.partition(" = ")
        name, _, type_name = head.partition(": ")
        parameters.append(inspect.Parameter(name, kind, annotation=type_name,
                                            default=default if has_default else inspect.Parameter.empty))
    return inspect.Signature(parameters)


def one_line(message: str, arguments: Tuple[Any, ...], named: Dict[str, Any]) -> str:
    """What pybind11 says of arguments that fit no signature, in a line that names the argument and what is right."""
    function = message.partition("()")[0]
    text = re.findall(r"^    \d+\. (.*)$", message.partition("\nInvoked with: ")[0], re.M)[-1]
    if function == "__init__":  # its signature is without self
        function, arguments = text.partition("(")[0].rpartition(".")[2], arguments[1:]
    names = _signature(text.partition(" -> ")[0]).parameters
    for name in named.keys() - names.keys():
        here = _HERE.get(name)
        return f"{function}() has no argument '{name}'" + (f"; here it is '{here}'" if here in names else "")
    free = [name for name, one in names.items() if one.kind is inspect.Parameter.POSITIONAL_OR_KEYWORD]
    if len(arguments) > len(free):
        by_name, extra = [name for name in names if name not in free], arguments[len(free)]
        example = f", as in {by_name[0]}={extra!r}" if by_name and isinstance(extra, str) else ""
        without = ", ".join(name for name in free if name != "self")
        return (f"{function}() takes no more arguments without their names than {without}" +
                (f"; name the others{example}" if by_name else ""))
    given = {**dict(zip(free, arguments)), **named}
    for name, one in names.items():
        if name not in given and one.default is inspect.Parameter.empty:
            return f"{function}() needs the argument '{name}'"
        right, words = _right_type(one.annotation)
        if name in given and not isinstance(given[name], right):
            return f"{function}(): {name} {shown(given[name])}; it must be {words}"
    return f"{function}() does not take arguments of the types {', '.join(type(one).__name__ for one in arguments)}"


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
