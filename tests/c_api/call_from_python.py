"""Calls a shared libtouchstone through its C interface: call_from_python.py LIBRARY. Exit status 0 when all is right."""
# SPDX-License-Identifier: MIT
import ctypes
import math
import sys

library = ctypes.CDLL(sys.argv[1])
library.touchstone_last_error.restype = ctypes.c_char_p
library.touchstone_nature_name.restype = ctypes.c_char_p
library.touchstone_contacts_count.restype = ctypes.c_size_t
library.touchstone_contacts_count.argtypes = [ctypes.c_void_p]
library.touchstone_contacts_destroy.argtypes = [ctypes.c_void_p]
library.touchstone_mesh_destroy.argtypes = [ctypes.c_void_p]


class Answer(ctypes.Structure):
    _fields_ = [(name, ctypes.c_uint8) for name in (
        "contact", "level", "nature", "feature_a", "feature_b", "starts_within", "trend", "reserved")] + [
        ("toi", ctypes.c_double), ("toi_upper", ctypes.c_double),
        ("weights_a", ctypes.c_double * 3), ("weights_b", ctypes.c_double * 3)]


def doubles(*values):
    return (ctypes.c_double * len(values))(*values)


def check(truth, what):
    if not truth:
        sys.exit(f"wrong: {what} ({library.touchstone_last_error().decode()})")


VERTEX_FACE = 1
triangle = (0, 0, 0, 1, 0, 0, 0, 1, 0)
start = doubles(0.25, 0.25, 1, *triangle)
end = doubles(0.25, 0.25, -1, *triangle)
answer = Answer()
check(library.touchstone_solve(VERTEX_FACE, start, end, None, ctypes.byref(answer)) == 0, "solve")
check(answer.contact == 1 and answer.toi == 0.5 and answer.toi_upper == 0.5, "the time is 1/2")
check(library.touchstone_nature_name(answer.nature) == b"crossing", "the vertex crosses the face")

answers = (Answer * 2)()
check(library.touchstone_solve_rows(VERTEX_FACE, ctypes.c_size_t(2), doubles(*start, *start), doubles(*end, *start),
                                    None, answers) == 0, "rows")
check(answers[0].toi == 0.5 and answers[1].contact == 0 and math.isinf(answers[1].toi), "the answers of two rows")

check(library.touchstone_solve(9, start, end, None, ctypes.byref(answer)) == 1, "an unknown kind is refused")
check(b"kind is 9" in library.touchstone_last_error(), "the message names the kind")
start[0] = math.nan
check(library.touchstone_solve(VERTEX_FACE, start, end, None, ctypes.byref(answer)) == 2, "a NaN is refused")
print("the shared library answers Python")
