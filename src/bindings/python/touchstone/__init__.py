"""Exact continuous collision detection: do two moving elements ever touch, and when first?

An element is a point, an edge or a triangle whose corners move on straight lines for t in [0, 1]. `solve` answers
queries about two elements, one or millions at a time. `Mesh` and `first_contact` answer questions about whole meshes,
and `Bodies` about rigid bodies that turn.
Answers have no tolerance: `toi` and `toi_upper` are the two neighbouring doubles that enclose the exact first time.

The kinds of query, and the order of their corners:

    'edge-edge'    a0 a1 b0 b1        'vertex-face'  v f0 f1 f2
    'point-edge'   p e0 e1            'point-point'  p q

A point that falls through a triangle:

>>> import touchstone
>>> triangle = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
>>> answer = touchstone.solve('vertex-face', [[.25, .25, 1]] + triangle, [[.25, .25, -2]] + triangle)
>>> answer.contact, answer.toi, answer.toi_upper
(True, 0.3333333333333333, 0.33333333333333337)
>>> str(answer.nature)
'crossing'

Arrays. Positions are arrays or lists of real numbers: float64, float32, float16 and whole numbers, each taken with its
exact value. A number that no double equals is an error. Arrays of any memory layout are read where they are. All
lengths are in one unit of your choice, and times are fractions of the step.

Errors. TypeError for an argument of another type. ValueError for a value without meaning: a NaN or infinite coordinate,
a shape or name that does not fit. The message names the argument, and the row where there are rows.

Calls run without Python's global lock, and Ctrl-C ends them with KeyboardInterrupt. Do not write to an array while a
call reads it.
"""
from ._core import (Answer, Answers, Bodies, Body, BodyDistance, BodyIntersections, BodyPairs, BodyScrewAnswer,
                    ClosestApproach, Distance, Distances, ExactTime, Finding, FirstBodyContact, FirstContact,
                    FreeBodyStep, FreeStep, FuzzReport, Intersections, Mesh, MeshSteps, Pairs, StepFinding, StepReport,
                    __version__)
from ._names import Feature, Level, Nature, Trend
from ._queries import contact_normal, contact_times, distance, solve, toi_gradient
from ._curved import CurvedQueries, OnBody, OnCurves
from ._fuzzing import fuzz, fuzz_steps
from ._judging import Certificate, Verdict, certify
from ._mesh_files import Frames, MeshFile, as_mesh, read_frames, read_mesh
from ._meshes import (all_contacts, candidates, closest_approach, first_contact, free_step, intersections,
                      intersects)
from ._proofs import Checked, Proofs, check, prove
from . import _tables
from ._display import Shown, ShownMesh, show, show_mesh
from ._pages import save_page

__all__ = [
    "Answer", "Answers", "Bodies", "Body", "BodyDistance", "BodyIntersections", "BodyPairs", "BodyScrewAnswer",
    "Certificate", "Checked", "ClosestApproach", "CurvedQueries", "Distance", "Distances", "ExactTime", "Feature",
    "Finding", "FirstBodyContact", "FirstContact", "Frames", "FreeBodyStep", "FreeStep", "FuzzReport", "Intersections",
    "Level", "Mesh",
    "MeshFile", "MeshSteps", "Nature", "OnBody", "OnCurves", "Pairs", "Proofs", "Shown", "ShownMesh",
    "StepFinding", "StepReport", "Trend", "Verdict",
    "all_contacts", "as_mesh", "candidates", "certify", "check", "closest_approach", "contact_normal",
    "contact_times", "distance", "first_contact", "free_step", "fuzz", "fuzz_steps", "intersections", "intersects",
    "prove", "read_frames", "read_mesh", "save_page", "show", "show_mesh", "solve", "toi_gradient"
]
