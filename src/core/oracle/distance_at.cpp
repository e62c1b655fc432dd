// Either distance is the least value of a function on the difference polygon. Every face offers the points at which its
// least value can be, and the smallest value of all these is the answer. Each value belongs to a point of the polygon,
// so a superfluous point does no harm.
// SPDX-License-Identifier: MIT
#include "oracle/distance_at.hpp"

#include <algorithm>
#include <optional>

namespace touchstone::oracle {
namespace {

using Position = std::array<Rational, 3>;

/// A face at one time: its points are base + s first + t second.
struct FaceAt {
  Kind kind;
  std::size_t dimension;
  Position base;
  Position first;
  Position second;

  /// The face's point with these parameters, unless it lies outside or on a lower face.
  std::optional<Position> point(const Rational& s, const Rational& t) const {
    for (const Rational& margin : margins(kind, dimension, Rational(1), s, t)) {
      if (margin <= Rational(0)) return std::nullopt;
    }
    return base + s * first + t * second;
  }
};

std::vector<FaceAt> faces_at(const DifferencePolygon& polygon, const Rational& time) {
  const auto position = [&](std::size_t corner) {
    const Corner& c = polygon.corners[corner].position;
    return Position{c[0].evaluate(time), c[1].evaluate(time), c[2].evaluate(time)};
  };
  std::vector<FaceAt> faces;
  for (const auto& face : polygon.faces) {
    FaceAt at = {polygon.kind, face.dimension(), position(face.corners[0]), {}, {}};
    if (face.dimension() >= 1) at.first = position(face.corners[1]) - at.base;
    if (face.dimension() >= 2) at.second = position(face.corners[2]) - at.base;
    faces.push_back(at);
  }
  return faces;
}

/// The parameters at which two linear functions c + a s + b t of the parameters vanish, when that is one point.
struct Line {
  Rational c;
  Rational a;
  Rational b;
};

std::optional<std::array<Rational, 2>> intersection(const Line& one, const Line& other) {
  const Rational determinant = one.a * other.b - one.b * other.a;
  if (determinant == Rational(0)) return std::nullopt;
  return std::array<Rational, 2>{Rational((one.b * other.c - one.c * other.b) / determinant),
                                 Rational((one.c * other.a - one.a * other.c) / determinant)};
}

/// Keeps the smallest value.
void lower(std::optional<Rational>& least, const Rational& value) {
  if (!least || value < *least) least = value;
}

/// The foot of the perpendicular from the origin to the face's line or plane. A face without one because it is flat
/// has its least value on a lower face too.
std::optional<Position> foot(const FaceAt& face) {
  const Rational zero(0);
  if (face.dimension == 0) return face.base;
  if (face.dimension == 1) {
    const Rational square = dot(face.first, face.first);
    if (square == zero) return std::nullopt;
    return face.point(-dot(face.base, face.first) / square, zero);
  }
  const auto parameters =
      intersection({dot(face.base, face.first), dot(face.first, face.first), dot(face.second, face.first)},
                   {dot(face.base, face.second), dot(face.first, face.second), dot(face.second, face.second)});
  if (!parameters) return std::nullopt;
  return face.point((*parameters)[0], (*parameters)[1]);
}

Rational largest_coordinate(const Position& x) {
  return std::max({Rational(CGAL::abs(x[0])), Rational(CGAL::abs(x[1])), Rational(CGAL::abs(x[2]))});
}

/// The parameters at which one coordinate vanishes or two are equal or opposite. They divide the face into cells on
/// which the largest absolute coordinate is one linear function, so its least value is at a cell's corner.
std::vector<Line> creases(const FaceAt& face) {
  std::vector<Line> lines;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3;
    lines.push_back({face.base[k], face.first[k], face.second[k]});
    lines.push_back({Rational(face.base[k] - face.base[l]), Rational(face.first[k] - face.first[l]),
                     Rational(face.second[k] - face.second[l])});
    lines.push_back({Rational(face.base[k] + face.base[l]), Rational(face.first[k] + face.first[l]),
                     Rational(face.second[k] + face.second[l])});
  }
  return lines;
}

void lower_at_corners_of_cells(std::optional<Rational>& least, const FaceAt& face) {
  const Rational zero(0);
  if (face.dimension == 0) {
    lower(least, largest_coordinate(face.base));
    return;
  }
  const auto offer = [&](const Rational& s, const Rational& t) {
    const auto point = face.point(s, t);
    if (point) lower(least, largest_coordinate(*point));
  };
  const auto lines = creases(face);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (face.dimension == 1) {
      if (lines[i].a != zero) offer(-lines[i].c / lines[i].a, zero);
      continue;
    }
    for (std::size_t j = 0; j < i; ++j) {
      const auto parameters = intersection(lines[i], lines[j]);
      if (parameters) offer((*parameters)[0], (*parameters)[1]);
    }
  }
}

}  // namespace

Rational squared_distance_at(const DifferencePolygon& polygon, const Rational& time) {
  std::optional<Rational> least;
  for (const auto& face : faces_at(polygon, time)) {
    const auto nearest = foot(face);
    if (nearest) lower(least, dot(*nearest, *nearest));
  }
  return *least;
}

Rational max_distance_at(const DifferencePolygon& polygon, const Rational& time) {
  std::optional<Rational> least;
  for (const auto& face : faces_at(polygon, time)) lower_at_corners_of_cells(least, face);
  return *least;
}

}  // namespace touchstone::oracle
