// The self-test of the numerical environment. Each function checks one thing and returns what is wrong with it.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include <touchstone/answer.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>
#include <touchstone/solve.hpp>

#include "cli/doctor/arithmetic.hpp"

namespace touchstone::cli {

// "" when all is well, or the first fault with its numbers as hexfloats.

/// The environment of this thread as it is: rounding to nearest, subnormals kept, exceptions masked.
std::string fault_of_environment(const Arithmetic& arithmetic);

/// Sums, products, quotients and roots, each rounded correctly in each of the four rounding modes, with subnormals.
std::string fault_of_rounding(const Arithmetic& arithmetic);

/// Operands and results below 2^-1022 are not flushed to zero.
std::string fault_of_subnormals(const Arithmetic& arithmetic);

/// A product and a sum are two operations, and sums are taken in the order in which they are written.
std::string fault_of_contraction(const Arithmetic& arithmetic);

/// std::fma rounds once. The bracket level uses it where the processor has it.
std::string fault_of_fused(const Arithmetic& arithmetic);

/// Answers in columns.
using BatchSolver = std::function<void(const QueryColumns& queries, VectorWidth width, Answer* answers)>;

/// With vectors of each width that this processor has, the answers are those of one query at a time.
/// @param widths  becomes the widths that were tried, in bits: "none, 128, 256"
std::string fault_of_vectors(const BatchSolver& solver, std::string& widths);

/// Answers to one query.
using QuerySolver = std::function<Answer(const Query& query)>;

/// The answers to a few queries whose exact first time is known by hand, in each rounding mode, with subnormals flushed
/// and without.
std::string fault_of_known_answers(const QuerySolver& solver);

/// The truth column of the queries that are bundled with the program, and the answers of exact arithmetic to them.
/// @param count  becomes the number of queries
std::string fault_of_bundled(const QuerySolver& solver, std::size_t& count);

}  // namespace touchstone::cli
