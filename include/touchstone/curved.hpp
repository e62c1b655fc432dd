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

/// The first contact of the two elements for t in [0, t_max], decided exactly: no tolerance, no false answer. The same
/// guarantees hold as for straight motion: `toi` and `toi_upper` are the neighbouring doubles of the exact time, and
/// nature, features and weights are those at the exact time. V(t) is then the coplanarity of the corners times a
/// positive function of t that makes it a polynomial; its degree is up to 9 for two bodies.
/// @param query  the two elements and their motion
/// @param t_max  the end of the time range, 0 <= t_max <= 1
/// @return the answer
/// @throws InvalidQuery  naming what and where: a NaN or infinite number, a quaternion that is zero at an end or
///                       between (then with the change that helps), a motion or number of control points out of range,
///                       an unknown kind, or a t_max outside [0, 1]
Answer solve(const CurvedQuery& query, double t_max = 1.0);

/// The same by the method of your choice. Method::oracle is an independent decider over CGAL's algebraic kernel.
/// @throws InvalidQuery  also for a value that is none of Method's
Answer solve(const CurvedQuery& query, Method method, double t_max = 1.0);

/// The first time in [0, t_max] at which the two elements are within a separation of each other, decided exactly. With
/// distance 0 it is solve(query, t_max).
/// @param query       the two elements and their motion
/// @param separation  the distance that they are to keep, and its metric
/// @param t_max       the end of the time range, 0 <= t_max <= 1
/// @return the answer
/// @throws InvalidQuery  as solve(query, t_max), and for a distance that is negative or not finite, or an unknown
/// metric
Answer solve(const CurvedQuery& query, const Separation& separation, double t_max = 1.0);

/// The same by the method of your choice.
Answer solve(const CurvedQuery& query, const Separation& separation, Method method, double t_max = 1.0);

/// The same as solve(query, t_max), without what is not wanted of a contact: see solve(Query, Wanted, double).
/// @throws InvalidQuery  also for a value that is none of Wanted's
Answer solve(const CurvedQuery& query, Wanted wanted, double t_max = 1.0);

/// The same as solve(query, separation, t_max), without what is not wanted of a contact.
Answer solve(const CurvedQuery& query, const Separation& separation, Wanted wanted, double t_max = 1.0);

/// Whether the two elements touch at any t in [0, t_max]: the `contact` of solve(query, t_max).
/// @throws InvalidQuery  as solve(query, t_max)
bool solve_any(const CurvedQuery& query, double t_max = 1.0);

/// Whether they come within a separation of each other: the `contact` of solve(query, separation, t_max).
/// @throws InvalidQuery  as solve(query, separation, t_max)
bool solve_any(const CurvedQuery& query, const Separation& separation, double t_max = 1.0);

/// The answers to many curved queries, in input order. They are the same for any number of threads.
/// @param queries  the queries, of one kind or of several
/// @param options  how they are answered; the vectors' width has no effect
/// @return answers[i] for queries[i]
/// @throws InvalidQuery  for options without meaning, or naming the index of the first query without meaning
std::vector<Answer> solve_batch(const std::vector<CurvedQuery>& queries, const BatchOptions& options = {});

/// The same into the caller's memory. When it throws, no answer is valid.
/// @param queries  the first of `count` queries
/// @param count    the number of queries
/// @param answers  room for `count` answers; answers[i] becomes the answer to queries[i]
/// @param options  how they are answered; the vectors' width has no effect
/// @throws InvalidQuery  for options without meaning, or naming the index of the first query without meaning
void solve_batch(const CurvedQuery* queries, std::size_t count, Answer* answers, const BatchOptions& options = {});

/// Whether a body takes the longer of the two turns between its orientations: q0 . q1 < 0, decided exactly. q1 and -q1
/// are the same orientation, and recorded poses often have the other sign by chance. The body then turns nearly once
/// around, and a contact on that way is one of another motion than was meant.
bool takes_longer_turn(const RigidMotion& motion);

/// The same poses at both ends with the shorter turn between them: q1 has the other sign where the body takes the
/// longer one.
RigidMotion with_shorter_turn(const RigidMotion& motion);

/// The unit normal at the first contact, as contact_normal(Query) defines it. Its distance from the true unit vector is
/// less than 2^-49.
/// @return the normal; nothing without a contact, and where contact_normal(Query) gives nothing
/// @throws InvalidQuery  as solve(query, separation, t_max), and for a distance > 0 in a metric that is not Euclidean
std::optional<std::array<double, 3>> contact_normal(const CurvedQuery& query, const Separation& separation = {},
                                                    double t_max = 1.0);

/// All times in [0, t_max] at which the two elements touch: ascending and disjoint closed intervals, exactly.
/// @throws InvalidQuery  as solve(query, t_max)
std::vector<ContactInterval> contact_times(const CurvedQuery& query, double t_max = 1.0);

/// All times in [0, t_max] at which they are within a separation of each other.
/// @throws InvalidQuery  as solve(query, separation, t_max)
std::vector<ContactInterval> contact_times(const CurvedQuery& query, const Separation& separation, double t_max = 1.0);

}  // namespace touchstone
