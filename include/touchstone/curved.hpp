// Touchstone: do two elements that turn or move on curves ever touch, and when first? No tolerance, no false answer.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <touchstone/answer.hpp>
#include <touchstone/contact_times.hpp>
#include <touchstone/curved_query.hpp>
#include <touchstone/separation.hpp>
#include <touchstone/solve.hpp>

namespace touchstone {
inline namespace TOUCHSTONE_ABI {

/// The first contact of the two elements for t in [0, t_max], decided exactly: no tolerance, no false answer. The same
/// guarantees hold as for straight motion: `toi` and `toi_upper` are the neighbouring doubles of the exact time, and
/// nature, features and weights are those at the exact time. V(t) is then the coplanarity of the corners times a
/// positive function of t that makes it a polynomial; its degree is up to 9 for two bodies.
/// @param query    the two elements and their motion
/// @param options  what is asked, and how it is answered
/// @return the answer
/// @throws InvalidQuery  for a NaN or infinite number, a quaternion that is zero at an end or between them, a motion or
///                       number of control points out of range, an unknown kind, or options without meaning. The
///                       message names the value and its place, and for a zero quaternion the change that helps
Answer solve(const CurvedQuery& query, const SolveOptions& options);

/// The same about touching in [0, 1], by Method::fast.
Answer solve(const CurvedQuery& query);

/// The answers to many curved queries, in input order. They are the same for any number of threads.
/// @param queries  the queries, of one kind or of several
/// @param options  how they are answered; the vectors' width has no effect
/// @return answers[i] for queries[i]
/// @throws InvalidQuery  for options without meaning, or naming the index of the first query without meaning
std::vector<Answer> solve_batch(const std::vector<CurvedQuery>& queries, const BatchOptions& options = {});

/// The same into the caller's memory. When it throws, no answer is valid.
/// @param queries  a pointer to the first of `count` queries
/// @param count    the number of queries
/// @param answers  room for `count` answers; answers[i] becomes the answer to queries[i]
/// @param options  how they are answered; the vectors' width has no effect
/// @throws InvalidQuery  for options without meaning, or naming the index of the first query without meaning
void solve_batch(const CurvedQuery* queries, std::size_t count, Answer* answers, const BatchOptions& options = {});

/// Whether a body takes the longer of the two turns between its orientations: q0 . q1 < 0, decided exactly. q1 and -q1
/// are the same orientation, and recorded poses often have the other sign by chance. The body then turns nearly once
/// around, and may have contacts that the intended motion does not have.
bool takes_longer_turn(const RigidMotion& motion);

/// Whether both turns have 180 degrees: q0 . q1 = 0, decided exactly. Neither is the shorter one, so
/// `with_shorter_turn` leaves the signs as they are, and they say which way the body turns.
bool takes_half_turn(const RigidMotion& motion);

/// The same poses at both ends with the shorter turn between them: q1 has the other sign where the body takes the
/// longer one.
RigidMotion with_shorter_turn(const RigidMotion& motion);

/// The unit normal at the first contact, as contact_normal(Query) defines it. Its distance from the true unit vector is
/// less than 2^-49.
/// @return the normal; nothing without a contact, and where contact_normal(Query) gives nothing
/// @throws InvalidQuery  as solve, and for a distance > 0 in a metric that is not Euclidean
std::optional<std::array<double, 3>> contact_normal(const CurvedQuery& query, const Separation& separation = {},
                                                    double t_max = 1.0);

/// All times in [0, t_max] at which the two elements are within a separation of each other: ascending and disjoint
/// closed intervals, exactly.
/// @throws InvalidQuery  as solve
std::vector<ContactInterval> contact_times(const CurvedQuery& query, const Separation& separation = {},
                                           double t_max = 1.0);

}  // namespace TOUCHSTONE_ABI
}  // namespace touchstone
