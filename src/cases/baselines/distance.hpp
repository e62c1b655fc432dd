// Distances between elements that stand still, in doubles.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "baselines/scaled_frame.hpp"

namespace touchstone::baselines {

inline double length(const Vector& v) { return std::sqrt(geometry::dot(v, v)); }

/// Of the point r from the segment from the origin to u.
double point_segment_distance(const Vector& r, const Vector& u);

/// Of the segment from the origin to u from the segment from r to r + w.
double segment_distance(const Vector& u, const Vector& w, const Vector& r);

/// Of the point r from the triangle with corners 0, u and w.
double point_triangle_distance(const Vector& u, const Vector& w, const Vector& r);

/// Of the frame's elements at time t, in the frame's unit.
double distance_at(const Frame& frame, double t);

}  // namespace touchstone::baselines
