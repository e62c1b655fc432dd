#!/usr/bin/env python3
# Does anybody notice when a filter lies? On a copy of the sources, makes each error bound of the filters, and of the
# signs in doubles in src/core/numbers, 16 times too small and drops each guard, one at a time; builds what depends on
# it; and runs the searches of the layer's tests and then `touchstone fuzz` against the cascade, for a minute at most.
# Prints who found what. Exit status 0 when every fault was found, 1 when one survived, 2 when this script no longer
# fits the sources.
#
# With --proofs no test is run: the faulty program proves its answers to hard queries, and touchstone-check, which knows
# nothing of filters, must reject some proof. A fault for whose answers the prover has no proof is found, too, and is
# told apart. Only a fault that changes an answer or a proof can be found so, and nobody steers these queries towards a
# bound: so the bounds are 4,096 times too small instead.
#
#   fuzz/weaken-constants.py [--only PART_OF_A_NAME] [--layer filters|numbers|exact|separation|mesh|curved] [--seconds 60]
#                            [--jobs N] [--quick] [--proofs] [--part 3/10] [--list]
# SPDX-License-Identifier: MIT
import argparse
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent

# Without a line below, as no query is likely to show them missing:
# - the rounding that `minus` of root_sides.hpp adds: at a border, where it would matter, it is at most the slack of 1 e
#   in `spread` and some e^2, so that a wrong side needs every rounding of a component at its worst at once;
# - the tests of `within_radius` in refined_root.cpp: a step from a root that BernsteinCubic certified ends within its
#   radius, but perhaps after a second step, by a few e where V is steep; they are there for what SimpleRoot promises;
# - in near_root.cpp the steadiness of the slope, the gap beside a root, which root two polynomials share, the root that
#   a divisor leaves, the uncertain signs of a part and the reach of Newton iteration: the search and the interval that
#   it starts from make them hold; nor the error of the time that this iteration ends with, or of the middle of two close
#   roots: it is far below a double's; nor the reach of a remainder's root, which is where the root of p is whenever it
#   is near.

# name, file below src/core, text there (exactly once), what it becomes
FAULTS = [
    ("kEndsBound", "filters/coplanarity_form.hpp", "kEndsBound = 35 *", "kEndsBound = 35 / 16.0 *"),
    ("kMiddleBound", "filters/coplanarity_form.hpp", "kMiddleBound = 123 *", "kMiddleBound = 123 / 16.0 *"),
    ("underflow guard of U W", "filters/coplanarity_form.hpp", "(uw >= kLeastProduct) & ", ""),
    ("overflow guard of U W", "filters/coplanarity_form.hpp", " & (uw <= kGreatestProduct)", ""),
    ("underflow guard of U W R", "filters/coplanarity_form.hpp", "(uwr >= kLeastProduct) & ", ""),
    ("overflow guard of U W R", "filters/coplanarity_form.hpp", " & (uwr <= kGreatestProduct)", ""),
    ("kProjectionBound", "filters/apart/separating_direction.cpp", "kProjectionBound = 13 *",
     "kProjectionBound = 13 / 16.0 *"),
    ("underflow guard of projections", "filters/apart/separating_direction.cpp", "if (!(product >= kLeastProduct))",
     "if (false)"),
    ("overflow guard of projections", "filters/apart/separating_direction.cpp",
     "if (!(std::fabs(projection) < inf))", "if (false)"),
    ("a plane above at the start, too", "filters/apart/separating_direction.cpp",
     "above = std::min(above, least[1] - greatest[0])",
     "above = least[1] - greatest[0]"),
    ("a plane below at the start, too", "filters/apart/separating_direction.cpp",
     "below = std::min(below, least[0] - greatest[1])",
     "below = least[0] - greatest[1]"),
    ("margin of a gap", "filters/apart/separating_direction.cpp", "3 * bound}", "3 / 16.0 * bound}"),
    ("kRestrictionBound", "filters/bernstein_cubic.cpp", "kRestrictionBound = 70 *",
     "kRestrictionBound = 70 / 16.0 *"),
    ("kValueBound", "filters/step_cubic.hpp", "kValueBound = 60 *", "kValueBound = 60 / 16.0 *"),
    ("kSlopeBound", "filters/step_cubic.hpp", "kSlopeBound = 366 *", "kSlopeBound = 366 / 16.0 *"),
    ("curvature", "filters/step_cubic.hpp", "(2 + 0x1p-17) *", "(2 + 0x1p-17) / 16 *"),
    ("radius of a root", "filters/step_cubic.hpp", "radius = 2.0625 *", "radius = 2.0625 / 16 *"),
    ("greatest radius of a root", "filters/step_cubic.hpp", "where & (radius <= kGreatestRadius)", "where"),
    ("kGreatestRadius", "filters/step_cubic.hpp", "kGreatestRadius = 0x1p-10", "kGreatestRadius = 0x1p-6"),
    ("steadiness of the slope at a root", "filters/step_cubic.hpp", "<= 0.484375 * steepness", "<= 7.75 * steepness"),
    ("root after its part's start", "filters/step_cubic.hpp", "(t - radius > p)", "where"),
    ("root before its part's end", "filters/step_cubic.hpp", "(t + radius < q);", "where;"),
    ("root exact to one", "filters/step_cubic.hpp", "s = chosen(active, 1 - next, s);\n    t = 1 - s;",
     "s = chosen(active, 1 - next, s);\n    t = chosen(active, next, t);"),
    ("rounding of side conditions", "filters/root_sides.hpp", "17 * kUnit +", "17 / 16.0 * kUnit +"),
    ("reach of side conditions", "filters/root_sides.hpp", "(8 + 0x1p-10) * h", "(8 + 0x1p-10) / 16 * h"),
    ("guard of a vanishing n", "filters/root_sides.hpp", "known = normal.value > normal.error;",
     "known = normal.value >= 0.0;"),
    ("underflow guard of the bracket level", "filters/root_sides.hpp",
     "(least >= kLeastMagnitude) & ", "(least > 0) & "),
    ("overflow guard of the bracket level", "filters/root_sides.hpp",
     " & (greatest <= kGreatestMagnitude)", " & (greatest > 0)"),
    ("kCoplanarityError", "filters/contact_values.hpp", "kCoplanarityError = 281 *",
     "kCoplanarityError = 281 / 16.0 *"),
    ("kComponentError", "filters/contact_values.hpp", "kComponentError = 103 *", "kComponentError = 103 / 16.0 *"),
    ("slope of a component at a root", "filters/refined_root_steps.hpp", "(1 / kUnit) * away",
     "(1 / 16.0 / kUnit) * away"),
    ("curvature of a component at a root", "filters/refined_root_steps.hpp", "8 * (reach * reach +",
     "8 * ((1 / 16.0) * reach * reach +"),
    ("offset's error in a component", "filters/refined_root_steps.hpp", "* reach + offset.error)",
     "* reach + (1 / 16.0) * offset.error)"),
    ("error of the offset", "filters/refined_root_steps.hpp", "* missing * per_slope",
     "* (1 / 16.0) * missing * per_slope"),
    ("value's error in the offset", "filters/refined_root_steps.hpp", "(value_error + q *",
     "((1 / 16.0) * value_error + q *"),
    ("slope's error in the offset", "filters/refined_root_steps.hpp", "(value_error + q *",
     "(value_error + (1 / 16.0) * q *"),
    ("steepness in the offset's error", "filters/refined_root_steps.hpp", "(1 + 2 * q) * (value_error",
     "(1 + (1 / 8.0) * q) * (value_error"),
    ("rounding of the offset", "filters/refined_root_steps.hpp", "+ 2 * kUnit * magnitude(value);",
     "+ kUnit / 8 * magnitude(value);"),
    ("distance along which the slope changes", "filters/refined_root_steps.hpp",
     "distance = magnitude(time - root.t) +",
     "distance = (1 / 16.0) * magnitude(time - root.t) +"),
    ("length of the offset", "filters/refined_root_steps.hpp", "(magnitude(value) + value_error) * per_slope",
     "(1 / 16.0) * (magnitude(value) + value_error) * per_slope"),
    ("error of an exact value", "filters/refined_root.cpp", "return 8 * kUnit *", "return 0.5 * kUnit *"),
    ("underflow guard of an exact value", "filters/refined_root.cpp", "std::fabs(value) + 0x1p-1072",
     "std::fabs(value)"),
    ("doubt beyond the step's start", "filters/refined_root.cpp", "beyond < -offset_.error", "beyond < 0"),
    ("doubt beyond the step's end", "filters/refined_root.cpp", "beyond > offset_.error)", "beyond > 0)"),
    ("doubt of the nearest double", "filters/refined_root_steps.hpp",
     " & (magnitude(rest) + offset.error < nearest - before(nearest))", ""),
    ("doubt of a double's side, in lanes", "filters/columns/refined_kernel.hpp",
     "at.near & (at.earlier | at.later);", "at.near;"),
    ("doubt of a border, in lanes", "filters/columns/refined_kernel.hpp",
     "touches = touches & (root.inside | sides.inside);", ""),
    ("doubt of a weight, in lanes", "filters/columns/refined_kernel.hpp",
     "touches = touches & (late | found.certain);", ""),
    ("kWeightError", "filters/refined_root_steps.hpp", "kWeightError = 2.75 *", "kWeightError = 44 *"),
    ("kBound of shared corners", "filters/apart/shared_corner.cpp", "kBound = 9 *", "kBound = 9 / 16.0 *"),
    ("underflow guard of shared corners", "filters/apart/shared_corner.cpp", "uw >= 0x1p-1000 && ", ""),
    ("kConstantBound of signs at a root", "numbers/roots/real_root.cpp", "kConstantBound = 5 *",
     "kConstantBound = -8.125 *"),
    ("kDegreeBound of signs at a root", "numbers/roots/real_root.cpp", "kDegreeBound = 3 *",
     "kDegreeBound = 3 / 16.0 *"),
    ("underflow guard of signs at a root", "numbers/roots/real_root.cpp",
     "sum >= kLeast ? bound * sum : std::numeric_limits<double>::quiet_NaN()", "bound * sum"),
    ("coordinates that rescaling would round", "filters/rescaled.cpp", "if (!exact) result.reset();", ""),
    ("factor of a cubic beside a double", "numbers/roots/near_root_isolation.cpp", "if (!divides) return false;",
     "if (false && !divides) return false;"),
    ("division by a rational root's factor", "numbers/roots/rational_roots.hpp",
     "if (carried * root.d != sum) return std::nullopt;", ""),
    ("remainder of a rational root", "numbers/roots/rational_roots.hpp",
     "if (p[0].value() + root.n * carried != 0) return std::nullopt;", ""),
    ("a square that is a root's discriminant", "numbers/roots/rational_roots.hpp",
     "if (!(root * root - square).is_zero()) return std::nullopt;", ""),
    ("coordinates in whole units", "exact/common_scale.hpp", "static_cast<double>(integer) * unit == x;",
     "static_cast<double>(integer) * unit == x * per_unit * unit;"),
    ("bits of V in doubles", "exact/coplanarity_at.cpp", "+ 3 <= 53 &&", "+ 3 <= 61 &&"),
    ("bits of a time of V in doubles", "exact/coplanarity_at.cpp", "span.bits() - time.low)", "span.bits())"),
    ("range of V in doubles", "exact/coplanarity_at.cpp", " && span.low > -kFar", ""),
    ("greatest V in doubles", "exact/coplanarity_at.cpp", " && span.high < kFar", ""),
    ("carry of a product of limbs", "numbers/integers/fixed_int.hpp", "signed_limb(a.limb(1)) + (total >> 64);",
     "signed_limb(a.limb(1));"),
    ("three real roots that almost coincide", "numbers/roots/near_root_isolation.cpp",
     "if (discriminant > 0) return doubt_.raise();", "if (discriminant > 0) return;"),
    ("error of close roots", "numbers/roots/near_root_isolation.cpp", "root.near_.error += 0x1p-49 * apart;",
     "root.near_.error = 0;"),
    ("distance of a remainder's root", "numbers/roots/near_root.cpp", "if (way - error > distance) return",
     "if (way + error > distance / 16) return"),
    ("error of a near root", "numbers/roots/located_root.cpp",
     "kSlack * ((1 + 2 * q) * (v.error + q * std::fabs(v.value)) / steep",
     "kSlack / 256 * ((1 + 2 * q) * (v.error + q * std::fabs(v.value)) / steep"),
    ("a near root that is a double", "numbers/roots/near_root.cpp", "if (side == 0) side = sign_of_rest(nearest);", ""),
    ("doubt of a sign at a near root", "numbers/roots/near_root.cpp",
     "return sign != 0 ? sign : raise_doubt();\n}\n\ntemplate <int Limbs>\nvoid NearRoot<Limbs>::settle()",
     "return sign != 0 ? sign : 1;\n}\n\ntemplate <int Limbs>\nvoid NearRoot<Limbs>::settle()"),
    ("error of a sign at a fine time", "numbers/roots/near_root.cpp", "value.error += kSlack * slope",
     "value.error += 0x1p-130 * slope"),
    ("error of a near quotient", "numbers/roots/near_root.cpp", "kGreatestError = 0x1p-52", "kGreatestError = 0x1p-38"),
    ("greatest integers of a fraction in doubles", "numbers/roots/near_root_isolation.cpp",
     "kExactlyDoubles = std::int64_t{1} << 53", "kExactlyDoubles = std::int64_t{1} << 57"),
    ("greatest denominator of a small quotient", "numbers/roots/near_root.hpp",
     "kLittle = std::int64_t{1} << 8", "kLittle = std::int64_t{1} << 10"),
    ("a root at the end of a range without one", "numbers/roots/near_root.hpp",
     "(first + slope + coefficient(2) * exact(limit) * exact(limit)).sign() == sign", "true"),
    ("multiples of a root's quadratic", "numbers/roots/near_root.cpp",
     "(q[2] * p[1] - p[2] * q[1]).is_zero() && ", ""),
]


# The same for questions with a separation. Where a bound is a sum, one of its parts can be hidden behind the others:
# then the part becomes negative here, or is taken off by more than it adds.
#
# Without a line below, as no search comes near them: they leave more room than a sixteenth of them takes up.
# - kLeastFraction: the squares of c's errors would count from 2^-100 on; the factor of `lowest`: for 2^-32 of a number
#   that is itself about the error;
# - roundings of the vectors in closest_near.hpp, and what the corrections change: a few e, or much less, among many;
#   kMostError there: corrections are far better known than it asks for;
# - kSmall of a facet's normal: normals are far better than it asks for;
# - that an entry certainly comes before the next double: few are so near to one, and it takes minutes to meet them;
# - kGreatestSize: what overflows leaves no comparison true; kLeastNormal of a direction's gap: kLeastProduct has room.
SEPARATION_FAULTS = [
    ("greatest norm of n's middle coefficient", "filters/coplanarity_form.hpp", "(Euclidean ? 0.25 : 0.5) * norm(n[1])",
     "(Euclidean ? 0.25 / 16 : 0.5 / 16) * norm(n[1])"),
    ("kNormBound", "filters/coplanarity_form.hpp", "kNormBound = 32 *", "kNormBound = 32 / 16.0 *"),
    ("kNormFactor", "filters/coplanarity_form.hpp", "kNormFactor = 1 + 8 *", "kNormFactor = 1 - 120 *"),
    ("underflow guard of n's norm", "filters/coplanarity_form.hpp", "(uw >= kLeastNormProduct) & ", ""),
    ("underflow guard of V with a separation", "filters/coplanarity_form.hpp", "(uwr >= kLeastVolume) & ", ""),
    ("error of a gap with a separation", "filters/apart/separating_direction.cpp",
     "(gap.error + separation.distance * norm)",
     "(gap.error / 16 + separation.distance * norm)"),
    ("kDirectionFactor", "filters/apart/separating_direction.cpp", "kDirectionFactor = 1 + 8 *",
     "kDirectionFactor = 1 - 120 *"),
    ("kWalkError", "filters/separation/entry_walk.hpp", "kWalkError = 32 *", "kWalkError = 2 *"),
    ("kTurnError", "filters/separation/entry_walk.hpp", "kTurnError = 48 *", "kTurnError = 3 *"),
    ("kError of a distance", "filters/separation/distance_bound.cpp", "kError = 16 *", "kError = 1 *"),
    ("kLargestGap of a distance", "filters/separation/distance_bound.cpp", "kLargestGap = 0x1p-22",
     "kLargestGap = 0x1p-16"),
    ("kLargestError of a distance", "filters/separation/distance_bound.cpp", "kLargestError = 0x1p-24",
     "kLargestError = 0x1p-18"),
    ("features of a distance in double-doubles", "filters/separation/precise_distance.cpp",
     "is_certain_ = certainly_closest(", "is_certain_ = true || certainly_closest("),
    ("the root of 3 in the metric max", "filters/separation/distance_bound.cpp", "kAboveRoot3 : 1", "1 : 1"),
    ("both ends of a least distance", "filters/separation/distance_bound.cpp", "std::min(start.along(n), end.along(n))",
     "start.along(n)"),
    ("kNormIncrease", "filters/separation/entry_walk.hpp", "kNormIncrease = 1 + 8 *", "kNormIncrease = 1 - 120 *"),
    ("change of a difference near a time", "filters/separation/straight_differences.hpp", "value.error += radius *",
     "value.error += radius / 16 *"),
    ("rounding of a difference's ends", "filters/separation/straight_differences.hpp",
     "to = {end, numbers::kRounding *", "to = {end, numbers::kRounding / 16 *"),
    ("change of the closest points' vectors", "filters/separation/closest_near.hpp", "h * (std::fabs(slope[k].value)",
     "h / 16 * (std::fabs(slope[k].value)"),
    # Its roundings are many, and at their worst for no input that is known: the errors found are a 140th of it.
    ("kClosestError", "filters/separation/precise_closest.hpp", "kClosestError = 2048 *", "kClosestError = -16 *"),
    ("the least product at the corners", "filters/separation/precise_closest.hpp", "at_t.lowest = lowest_at_corners",
     "at_t.lowest = 0 * lowest_at_corners"),
    ("least size for closest points", "filters/separation/entry_step.hpp", "kLeastSize = 0x1p-150",
     "kLeastSize = 0x1p-500"),
    ("underflow guard of a direction's norm", "filters/separation/entry_walk.hpp",
     " || largest_of(n) >= 0.5 * kLeastFraction * step.size;", " || true;"),
    ("other points", "filters/separation/closest_near.hpp", "&& others_are_farther(whole, a, b)", ""),
    ("other points in the metric max", "filters/separation/entry.cpp",
     "if (!certainly_closest(feet)) return Outcome::uncertain;", ""),
    ("other points in the metric max at the start", "filters/separation/closest_feet.hpp",
     "if (!certainly_closest(closest)) return Outcome::uncertain;", ""),
    ("the distance's sign before an entry", "filters/separation/entry.cpp",
     "if (excess.sign() <= 0) return Outcome::uncertain;", ""),
    ("underflow guard of a direction's square", "filters/apart/separating_direction.cpp",
     "if (!(square >= kLeastSquare)) return false;", ""),
]

# Of elements that share a vertex, and of what is inside closed surfaces: only tests/mesh knows these.
MESH_FAULTS = [
    ("determinant of neighbours", "mesh/folds.cpp", "16 * 0x1p-53 * size", "0x1p-53 * size"),
    ("neighbours on the other side", "mesh/folds.cpp", "if (!certainly_above({{-n",
     "if (false && !certainly_above({{-n"),
    ("neighbours on this side", "mesh/folds.cpp", "if (!certainly_above(n, along)) return false;", ""),
    ("faces behind a ray's start", "mesh/inside_surfaces/ray_passes.cpp", "== -side ? side : 0;",
     "== -side ? side : side;"),
    ("a ray from a common vertex", "mesh/inside_surfaces/pieces.cpp",
     "if (same_position(motion[a].start, motion[b].start)) piece.middle",
     "if (false) piece.middle"),
    ("margin of candidates that are kept", "mesh/candidate_search.cpp", "with_room(reach.same + wider)",
     "with_room(reach.same)"),
    ("room of kept pairs", "mesh/candidate_search.cpp", "room_(2 * (1 +", "room_(1 * (1 +"),
    ("used part of the margin", "mesh/candidate_search.cpp", "kUsedMargin = 0.75", "kUsedMargin = 1.5"),
    ("margin of a kept fraction", "mesh/candidate_search.cpp", "(1 + 4 * kept_fraction_ / (1 - kept_fraction_))", "1"),
    ("reach of a kept fraction", "mesh/candidates.cpp", "grow(box, reach + more);", "grow(box, reach);"),
    ("greatest radius and greatest way of an element", "mesh/candidates.cpp",
     "more = std::max(more, reach_.of_ways[corner]);",
     "reach = std::max(reach, reach_.of_ways[corner] + (reach_.of_vertices.empty() ? 0 :"
     " reach_.of_vertices[corner]));"),
    ("a way until a time", "mesh/candidates.cpp", "ratio * one * until", "ratio * one * until * until"),
    ("time of a contact that is known", "mesh/contacts.cpp", "std::min(search.t_max, search.known_by)",
     "std::min(search.t_max, search.known_by / 2)"),
    ("ways of a pair that keeps its distance", "mesh/narrow.cpp", "std::sqrt(greatest[0]) + std::sqrt(greatest[1]) +",
     "std::sqrt(greatest[0]) +"),
    ("ways beside the usual one", "mesh/moving_vertices.cpp", "way.x - beside.x, way.y - beside.y,",
     "way.x - beside.x, 0.0,"),
    ("boxes of what a face stands for", "mesh/candidates.cpp", "!meet(a.box, b.box, until_)", "false"),
    ("vertices that a face stands for", "mesh/mesh.cpp", "corners[i]], 1) == 0)", "corners[i]], 1) == 0 && i > 0)"),
    ("swelling of boxes", "mesh/closest_approach.cpp", "0.5 * distance / swelling_", "0.25 * distance / swelling_"),
    ("least distance in the metric max", "mesh/closest_approach.cpp", "0.57735 : 1;", "1 : 1;"),
    ("ways in boxes that swell", "mesh/candidates.cpp",
     "box.low[k] = At{std::min(box.low[k][0], box.low[k][1]), std::min(grown.low[k][0], grown.low[k][1])};",
     "box.low[k] = At{box.low[k][0], grown.low[k][0]};"),
    ("wires that only fold, and their distance", "mesh/closest_approach.cpp",
     "if (only_folds && !pair.comes_within(0)) continue;", ""),
    ("pieces that meet", "mesh/inside_surfaces/inside.cpp", "if (a != b) pairs.insert({{a, b}, {b, a}});", ""),
]

# Of curved queries: the fuzzer and the checker of proofs know none of these, only tests/curved does.
#
# Without a line below: a certain sign at a part's start, in curved_bracket.cpp, as another test is uncertain, too.
CURVED_FAULTS = [
    ("size of a separation along a direction", "filters/curved/curved_paths.cpp", " + reach(direction, separation)",
     ""),
    ("guard of a direction that overflows", "filters/curved/curved_paths.cpp",
     "if (!(sum <= kMostSum)) return false;", ""),
    ("deviation of an arc", "solver/screw_arcs.cpp", "a * a * a / 32", "a * a * a / 512"),
    # Its roundings are many, and at their worst for no input that is known: the errors found are a twentieth of it.
    ("errors of an arc's orientations", "solver/screw_arcs.cpp", "1.2 * error", "1.2 / 64 * error"),
    ("rounding of an arc's positions", "solver/screw_arcs.cpp", "return 4 * ", "return 4 / 16.0 * "),
    ("an arc's chord of a curve", "solver/screw_arcs.cpp", "(degree - 1)) / 8", "(degree - 1)) / 128"),
    ("speed in a range of times", "solver/screw_arcs.cpp", "corner_speed(c) * half", "corner_speed(c) / 16 * half"),
    ("rounding of numbers with bounds", "numbers/doubles/bounded.hpp", "kRounding = 0x1p-53;", "kRounding = 0x1p-57;"),
    ("kPairSum", "numbers/doubles/bounded.hpp", "kPairSum = 4 *", "kPairSum = 4 / 16.0 *"),
    ("kPairProduct", "numbers/doubles/bounded.hpp", "kPairProduct = 9 *", "kPairProduct = 9 / 64.0 *"),
    ("underflow of numbers with bounds", "numbers/doubles/bounded.hpp", "kUnderflow = 0x1p-1000;", "kUnderflow = 0;"),
    ("underflow of double-doubles with bounds", "numbers/doubles/bounded.hpp", "kPairUnderflow = 0x1p-900;",
     "kPairUnderflow = 0;"),
    ("kTurnedRoundings", "filters/curved/curved_frame.cpp", "kTurnedRoundings = 6;", "kTurnedRoundings = 6 / 64.0;"),
    ("kWeightRoundings", "filters/curved/curved_frame.cpp", "kWeightRoundings = 3;", "kWeightRoundings = 3 / 16.0;"),
    ("roundings of a value", "filters/curved/curved_form.cpp", "(3 * p.degree + 3) * kRounding",
     "(3 * p.degree + 3) / 16.0 * kRounding"),
    ("slope of a value", "filters/curved/curved_form.cpp", "+ slope * radius +", "+ slope / 16 * radius +"),
    ("roundings of a derivative", "filters/curved/curved_form.cpp", "4 * kRounding * p.size) + kUnderflow",
     "4 / 16.0 * kRounding * p.size) + kUnderflow"),
    ("bulge of an arc", "geometry/arc_bulge.hpp", "kArcBulge = 0.55;", "kArcBulge = 0.55 / 16;"),
    ("bulge of a chord", "filters/curved/curved_chords.cpp", "geometry::kArcBulge * 1.7321 + 0.017;",
     "(geometry::kArcBulge * 1.7321 + 0.017) / 16;"),
    ("kTurnedError of chords", "filters/curved/curved_chords.cpp", "kTurnedError = 46 *", "kTurnedError = 46 / 16.0 *"),
    ("kPositionError of chords", "filters/curved/curved_chords.cpp", "kPositionError = 4 *",
     "kPositionError = 4 / 16.0 *"),
    ("quaternions of other lengths", "filters/curved/curved_chords.cpp",
     " && std::fabs(n1 - n0) <= kMostStretch * n0", ""),
    ("deviation of chords beside a separation", "filters/curved/curved_chords.cpp",
     "separation.distance + chords.deviation",
     "separation.distance"),
    ("roundings of a product of polynomials", "filters/curved/curved_form.cpp", "(roundings * kRounding)",
     "(roundings / 16 * kRounding)"),
    ("errors of a product's factors", "filters/curved/curved_form.cpp",
     "(a.size * b.error + a.error * (b.size + b.error)",
     "(a.size * b.error / 16 + a.error / 16 * (b.size + b.error)"),
    ("kCutRoundings", "filters/curved/curved_projection.hpp", "kCutRoundings = 3;", "kCutRoundings = 3 / 16.0;"),
    ("kExactCutRoundings", "filters/curved/curved_projection.hpp", "kExactCutRoundings = 2;",
     "kExactCutRoundings = 2 / 16.0;"),
    ("kProjectionErrors", "filters/curved/curved_projection.hpp", "kProjectionErrors = 3;",
     "kProjectionErrors = 3 / 16.0;"),
    ("kProjectionRoundings", "filters/curved/curved_projection.hpp", "kProjectionRoundings = 10;",
     "kProjectionRoundings = 10 / 16.0;"),
    ("kTurningRoundings", "filters/curved/curved_projection.hpp", "kTurningRoundings = kProjectionRoundings + 7;",
     "kTurningRoundings = (kProjectionRoundings + 7) / 16;"),
    ("kBoundSlack", "numbers/doubles/bounded.hpp", "kBoundSlack = 1 + 0x1p-40;", "kBoundSlack = 1 + 0x1p-44;"),
    ("doubt of the double nearest to a curved root", "filters/curved/curved_time.hpp",
     "if (sign == 0) return false;", ""),
    ("error of a curved root beside a double", "filters/curved/curved_time.hpp",
     "rest > root.error ? 1 : rest < -root.error ? -1 : 0", "rest > root.error / 16 ? 1 : rest < -root.error / 16 ? -1 : 0"),
    ("error of a curved root between doubles", "filters/curved/curved_time.hpp",
     "std::fabs(rest) + root.error < nearest",
     "std::fabs(rest) + root.error / 16 < nearest"),
    ("error of a curved quotient", "numbers/doubles/bounded.hpp", "kMostError = 0x1p-52", "kMostError = 0x1p-48"),
    ("size of a quotient's divisor", "numbers/doubles/bounded.hpp", "- 2 * b.error", "+ 2 * b.error"),
    ("error of a quotient's divisor", "numbers/doubles/bounded.hpp", "(a.error + std::fabs(value) * b.error",
     "(a.error + std::fabs(value) * b.error / 16"),
    ("later roots than one", "filters/curved/curved_bracket.cpp", "++changes > 1", "++changes > 3"),
    ("error of a root's offset", "filters/curved/curved_bracket.cpp", "off = (1 + 0x1p-20) * (value_off",
     "off = 0x1p-20 * (value_off"),
    ("size of a separation in a piece", "filters/curved/curved_walk.cpp",
     "kReach * (reach * (std::max(piece.scale[k], 0.0)",
     "0 * (reach * (std::max(piece.scale[k], 0.0)"),
]


# The tests of tests/curved that search for faults of a file. They come first, so that most faults are found in seconds.
CURVED_SEARCHES = {
    "geometry/arc_bulge.hpp": "the bulge of an arc*",
    "numbers/doubles/bounded.hpp": "curved bounds: *,curved bracket: what numbers*,curved bracket: no sign*",
    "filters/curved/curved_chords.cpp": "the filter's chords*",
    "filters/curved/curved_form.cpp": "curved bounds: *,curved bracket: polynomials*",
    "filters/curved/curved_frame.cpp": "curved bracket: polynomials*,curved bracket: the frame*",
    "filters/curved/curved_projection.hpp": "curved bounds: *",
    "filters/curved/curved_time.hpp": "curved bounds: *",
    "filters/curved/curved_walk.cpp": "curved bracket: separations that*,curved bracket: with a separation*",
    "filters/curved/curved_bracket.cpp": "curved bracket: its answers*",
    "filters/curved/curved_paths.cpp": "the filter*,the control points*,*separations of curved*",
    "solver/screw_arcs.cpp": "no corner is*,a corner is*",
}
ALL_CURVED_SEARCHES = ("curved bounds: *,no corner is*,a corner is*,the control points*,the filter*,curved bracket: *,"
                       "*separations of curved*")


def stop(reason):
    print(f"weaken-constants: {reason}", file=sys.stderr)
    sys.exit(2)


def note(progress):
    """For the person who waits: what comes next takes minutes."""
    print(f"weaken-constants: {progress}", file=sys.stderr, flush=True)


def layer_of(fault):
    if fault in CURVED_FAULTS:
        return "curved"
    return "separation" if fault in SEPARATION_FAULTS else fault[1].split("/")[0]


def faulty(text, fault):
    name, file, old, new = fault
    if text.count(old) != 1:
        stop(f"'{name}': src/core/{file} holds {text.count(old)} times, not once: {old}")
    return text.replace(old, new)


def copy_sources(to):
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z"], capture_output=True, check=True).stdout
    for name in listed.decode().split("\0"):
        if name and (ROOT / name).is_file():
            (to / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, to / name)


def configure(source, build):
    command = ["cmake", "-S", source, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"]
    if shutil.which("ccache"):
        command.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
        os.environ.update(CCACHE_BASEDIR=str(source), CCACHE_NOHASHDIR="1")
    if subprocess.run(command, stdout=subprocess.DEVNULL).returncode:
        stop("cmake failed")


def build_target(build, target, jobs):
    command = ["cmake", "--build", build, "-j", str(jobs), "--target", target]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:  # which proves nothing about a fault
        stop(f"{target} does not compile:\n{done.stdout[-3000:]}")


def processor_time():
    """Of all commands that have ended so far."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def accuses(name, status):
    """Whether this end of a command is a finding, rather than that it could not do its work."""
    if status < 0:
        return True  # a signal
    if name.startswith("touchstone fuzz"):
        return status == 1  # 2: bad usage, no query, a full disk
    # Catch2's statuses of failed tests differ from version to version; 126 and 127 mean that the program did not run.
    return status not in (0, 126, 127)


def finds(name, command, seconds):
    """Whether it finds the fault within so many seconds; how long it took; and a line that tells why, or why not.

    Seconds are those of the clock, or of the processor where they are fewer: what else a machine does finds no fault."""
    begin, begin_used = time.monotonic(), processor_time()

    def limit_processor_time():  # so that what hangs ends, on a busy machine too
        most = (int(seconds) + 2) * (os.cpu_count() or 1)
        resource.setrlimit(resource.RLIMIT_CPU, (most, most + 1))

    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=10 * max(seconds, 1),
                              preexec_fn=limit_processor_time)
    except subprocess.TimeoutExpired:
        return False, seconds, f"{name} timed out"
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return False, seconds, f"{name} timed out"
    spent = min(time.monotonic() - begin, processor_time() - begin_used)
    output = done.stdout + done.stderr
    if "No tests ran" in output or (done.returncode and not accuses(name, done.returncode)):
        stop(f"{name} ended with status {done.returncode}, which tells nothing:\n{output[-3000:]}")
    words = [line for line in output.splitlines() if "FAILED" in line or line.startswith("1. ")]
    if done.returncode and spent > seconds:
        return False, spent, f"{name} failed, but only after {spent:.1f} s"
    return done.returncode != 0, spent, (words or [""])[0].strip()


def attacks(build, layer, seconds, jobs, quick, file=None):
    """The search that found the fault (or nothing), how long all took, and its words, or those of all that found nothing.

    The fault is in `file`; without one, all searches run.

    Each has its own share of the seconds: a fault that makes one hang leaves the others theirs. Building takes no time."""
    fuzz = [build / "touchstone", "fuzz", "--solver", "touchstone"]

    def tests(folder, share, *names):
        return (f"tests/{folder}", f"test_{folder}", [build / f"tests/{folder}/test_{folder}", *names, "--abort"], share)

    if layer == "separation":
        fuzz += ["--separation", "each"]
        # The long tests of that folder compare what the fuzzer compares.
        searches = [tests("filters", 0.3, "[separation]"),
                    tests("separation", 0.2, "entries at*"),
                    tests("separation", 0.2, "*entries near*,patches*,* distance *,distances *")]
    elif layer == "exact":
        searches = [tests("exact", 0.5, "the near rungs*,the exact level*,V at a time*")]
    elif layer == "mesh":
        searches = [tests("mesh", 1, "neighbours that*,*kept*,steps that keep*,*closest approach*")]
        quick = True
    elif layer == "curved":
        nearest = CURVED_SEARCHES.get(file)
        searches = ([tests("curved", 0.5, nearest)] if nearest else []) + [tests("curved", 1, ALL_CURVED_SEARCHES)]
        quick = True
    else:
        searches = [tests(layer, 0.5)]
    spent, excuses = 0.0, []
    for name, target, command, share in searches + [
        ("touchstone fuzz", "touchstone_program", fuzz + ["--seconds", str(max(1, round(seconds / 5)))], 0.25),
        ("touchstone fuzz --climb", "touchstone_program",
         fuzz + ["--climb", "100", "--seconds", str(max(1, round(seconds / 5)))], 0.25),
    ][: 0 if quick else 2]:
        build_target(build, target, jobs)
        limit = seconds if quick and layer != "curved" else share * seconds
        found, took, words = finds(name, [str(word) for word in command], limit)
        spent += took
        if found:
            return name, spent, words
        excuses += [words] if words else []
    return None, spent, "; ".join(excuses)


def proofs_checked(build, layer, seconds, jobs):
    """What `attacks` returns, for the proofs of the program's own answers to hard queries: seed by seed, until one is
    rejected or the time is over. Nobody tells the checker which answers are wrong."""
    program, checker, maker = build / "touchstone", build / "touchstone-check", build / "fuzz/make_hard_queries"
    for target in ("touchstone_program", "touchstone_check", "make_hard_queries"):
        build_target(build, target, jobs)
    queries, proofs = build / "hard-queries", build / "hard-proofs.txt"
    begin_used, begin, seed = processor_time(), time.monotonic(), 0

    def spent():
        return min(time.monotonic() - begin, processor_time() - begin_used)

    def run(*command):
        return subprocess.run([str(word) for word in command], capture_output=True, text=True, errors="replace",
                              timeout=10 * max(seconds, 1))

    while spent() < seconds:
        seed += 1
        shutil.rmtree(queries, ignore_errors=True)
        metric = [("max", "euclidean")[seed % 2]] if layer == "separation" else []
        made = run(maker, queries, seed, 1, 200, *metric)
        if made.returncode:
            stop(f"make_hard_queries: {made.stderr}")
        files = sorted(queries.glob("*/*.csv"))
        try:
            proved = run(program, "certify", "--threads", jobs, "--proofs", proofs, *files)
        except subprocess.TimeoutExpired:
            # The search for a proof of "no contact" does not end soon where there is one. The exact level tells.
            judged = run(program, "certify", *files)
            if judged.returncode == 1:
                wrong = judged.stdout.partition("refuted:\n")[2].partition(" (rows")[0].strip()
                return "the prover", spent(), f"it found no proof in time; seed {seed}: a false answer to {wrong}"
            return None, spent(), f"seed {seed}: the prover timed out"
        if proved.returncode == 2 and "there is no proof" in proved.stderr:
            return "the prover", spent(), proved.stderr.strip()
        if proved.returncode not in (0, 1):
            stop(f"certify ended with status {proved.returncode}:\n{proved.stderr[-3000:]}")
        checked = run(checker, proofs, *files)
        answers = proved.stdout.splitlines()[0]  # judged by the exact level, which has no filters
        if checked.returncode == 1:
            return "touchstone-check", spent(), f"{checked.stderr.strip()}; seed {seed}: {answers}"
        if checked.returncode:
            stop(f"touchstone-check ended with status {checked.returncode}:\n{checked.stderr[-3000:]}")
        if proved.returncode:
            stop(f"touchstone-check accepts the proof of a false answer; seed {seed}:\n{proved.stdout[-3000:]}")
    return None, spent(), ""


def coarser(fault):
    """The fault for --proofs."""
    return (*fault[:3], fault[3].replace("/ 16", "/ 4096"))


def main():
    parser = argparse.ArgumentParser(description="Weakens the filters' bounds one by one and sees who notices.")
    parser.add_argument("--only", default="", help="only faults whose name holds this")
    parser.add_argument("--layer", choices=("filters", "numbers", "exact", "separation", "mesh", "curved"), help="only faults of this one")
    parser.add_argument("--seconds", type=float, default=60, help="for the searches, of each fault (default: 60)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--quick", action="store_true", help="the searches of the tests only")
    parser.add_argument("--proofs", action="store_true", help="no tests: the checker of proofs judges")
    parser.add_argument("--part", default="1/1", help="3/10: the third of ten parts of the faults")
    parser.add_argument("--list", action="store_true", help="the faults, and no more")
    options = parser.parse_args()
    if not re.fullmatch(r"[1-9]\d{0,3}/[1-9]\d{0,3}", options.part):
        parser.error(f"--part {options.part}: must be like 3/10")
    known = FAULTS + SEPARATION_FAULTS + ([] if options.proofs else MESH_FAULTS + CURVED_FAULTS)
    chosen = [fault for fault in known
              if options.only in fault[0] and (options.layer is None or layer_of(fault) == options.layer)]
    part, parts = (int(number) for number in options.part.split("/"))
    chosen = chosen[part - 1::parts]
    if options.proofs:
        chosen = [coarser(fault) for fault in chosen]
    if not chosen:
        stop(f"no fault is called '{options.only}'" if options.only else "no such fault")
    for fault in FAULTS + SEPARATION_FAULTS + MESH_FAULTS + CURVED_FAULTS:  # before minutes are spent
        faulty((ROOT / "src/core" / fault[1]).read_text(), fault)
    if options.list:
        print("\n".join(fault[0] for fault in chosen))
        return 0

    def attack(layer, file=None):
        if options.proofs:
            return proofs_checked(build, layer, options.seconds, options.jobs)
        return attacks(build, layer, options.seconds, options.jobs, options.quick, file)

    with tempfile.TemporaryDirectory(prefix="touchstone-weaken-") as folder:
        source, build = pathlib.Path(folder) / "source", pathlib.Path(folder) / "build"
        copy_sources(source)
        configure(source, build)
        for layer in sorted({layer_of(fault) for fault in chosen}):
            note(f"building the sources as they are, and the searches of '{layer}' on them")
            unharmed = attack(layer)
            if unharmed[0] or unharmed[2]:
                stop(f"the sources as they are fail: {unharmed[0] or 'too slow'}: {unharmed[2]}")
            note(f"they find nothing in {unharmed[1]:.1f} s")
        survivors = []
        for fault in chosen:
            file = source / "src/core" / fault[1]
            text = file.read_text()
            file.write_text(faulty(text, fault))
            result = attack(layer_of(fault), fault[1])
            file.write_text(text)
            if result[0]:
                print(f"found     {fault[0]}: by {result[0]} in {result[1]:.1f} s  {result[2]}", flush=True)
            else:
                survivors.append(fault[0])
                print(f"SURVIVED  {fault[0]}  {result[2]}".rstrip(), flush=True)
        print(f"{len(chosen) - len(survivors)} of {len(chosen)} faults found")
        return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
