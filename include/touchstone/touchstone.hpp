// Touchstone: robust, exact continuous collision detection.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/answer.hpp>
#include <touchstone/bodies.hpp>
#include <touchstone/certify.hpp>
#include <touchstone/closest_approach.hpp>
#include <touchstone/contact_normal.hpp>
#include <touchstone/contact_times.hpp>
#include <touchstone/curved.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/distance.hpp>
#include <touchstone/error.hpp>
#include <touchstone/mesh.hpp>
#include <touchstone/mesh_steps.hpp>
#include <touchstone/query.hpp>
#include <touchstone/screw.hpp>
#include <touchstone/separation.hpp>
#include <touchstone/solve.hpp>
#include <touchstone/toi_gradient.hpp>
#include <touchstone/vector_width.hpp>
#include <touchstone/version.hpp>

/// Robust, exact continuous collision detection: do two moving elements touch, and when first?
///
/// `solve` answers one query, and `solve_batch` answers many. Each of them also takes a Separation that the elements
/// are to keep. `solve` also takes a CurvedQuery, whose corners turn or move on curves. `contact_times` gives all times
/// of contact, and `contact_normal` the normal at the first, whose time's derivatives `toi_gradient` gives. `distance`
/// measures at one instant. `judge` judges the claim of another solver. `Mesh` and `first_contact` ask about whole
/// meshes, and `closest_approach` how near their elements come. `Body` and `Bodies` ask the same about whole meshes
/// that turn. The header touchstone/touchstone.hpp brings all of these. More headers stand beside it:
/// touchstone/eigen.hpp makes queries and positions from Eigen's types, touchstone/fuzz.hpp searches for failures of
/// another solver, touchstone/ipc_toolkit.hpp is a narrow phase for ipc-toolkit, and touchstone/c.h is the library for
/// C.
namespace touchstone {}
