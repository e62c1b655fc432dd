// Proofs of one small query, written by hand, and what the checker must say about them.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

namespace touchstone::tests {

using Lines = std::vector<std::string>;
using Corner = std::array<const char*, 3>;

Lines operator+(Lines first, const Lines& second);

/// A query file of one query: integer coordinates at t = 0, and those at t = 1.
std::string rows(const std::vector<Corner>& starts, const std::vector<Corner>& ends);
/// A point that rests at 0, and one that moves on the x axis.
std::string on_axis(const char* start, const char* end);

/// The proofs for one query file of one query, with the line of its separation.
std::string proofs_of(const std::string& kind, const Lines& lines, const std::string& separation = "");

void accept(const std::string& kind, const std::string& query, const Lines& lines, const std::string& separation = "");
/// Expects this exit status, and this text in what the checker writes.
void refuse_with(int status, const std::string& message, const std::string& proofs,
                 const std::vector<std::string>& files);
/// The proofs are wrong.
void reject(const std::string& message, const std::string& kind, const std::string& query, const Lines& lines,
            const std::string& separation = "");
/// The files cannot be read.
void call_bad(const std::string& message, const std::string& kind, const std::string& query, const Lines& lines,
              const std::string& separation = "");

inline const std::string kPoints = "point-point";
inline const Lines kWeights = {"w 0 1", "w 1 1"};
inline const std::string kTwoThirds = "0 contact 0x1.5555555555555p-1 0x1.5555555555556p-1";

inline const std::string kApart = on_axis("2", "3");
inline const std::string kMeeting = on_axis("-1", "1");  // at 1/2
inline const std::string kPassing = on_axis("-2", "1");  // at 2/3

}  // namespace touchstone::tests
