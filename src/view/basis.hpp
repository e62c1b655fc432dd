// From where a picture is seen first.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <array>

namespace touchstone::view {

using Double3 = std::array<double, 3>;

/// The value of a polynomial of a picture, and of a vector of them, in doubles.
double polynomial_at(const nlohmann::json& p, double s);
Double3 vector_at(const nlohmann::json& p, double s);

double dot_product(const Double3& a, const Double3& b);

/// Unit vectors to the right, up and towards the reader, as rows: the gap and the contact's normal point up, and both
/// elements are seen at length. In a plane they are the axes.
nlohmann::json first_view(const nlohmann::json& picture);

}  // namespace touchstone::view
