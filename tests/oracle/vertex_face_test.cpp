// A vertex and a face: every part of the face, flat faces, sliding.
// SPDX-License-Identifier: MIT
#include "oracle/expected.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

/// The vertex comes down along z through (x, y, 0) at t = 1/2 while the face stands still.
Query falling_on(const std::array<Vec3, 3>& face, double x, double y) {
  return VertexFace{{{{x, y, 1}, face[0], face[1], face[2]}}, {{{x, y, -1}, face[0], face[1], face[2]}}};
}

const std::array<Vec3, 3> kFace = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};

void check_fall(const std::array<Vec3, 3>& face, double x, double y, Nature nature, Feature feature, Weights weights) {
  check_contact(falling_on(face, x, y), {at(0.5), nature, Feature::v, feature, kFirst, weights});
}

}  // namespace

TEST_CASE("a vertex falls on every part of a face") {
  for (const bool mirrored : {false, true}) {
    const double s = mirrored ? -1 : 1;
    const std::array<Vec3, 3> face = {{{0, 0, 0}, {4 * s, 0, 0}, {0, 4, 0}}};
    check_fall(face, 1 * s, 1, Nature::crossing, Feature::f, {0.5, 0.25, 0.25});
    check_fall(face, 0 * s, 0, Nature::crossing, Feature::f0, kFirst);
    check_fall(face, 4 * s, 0, Nature::crossing, Feature::f1, kSecond);
    check_fall(face, 0 * s, 4, Nature::crossing, Feature::f2, kThird);
    check_fall(face, 1 * s, 0, Nature::crossing, Feature::f01, {0.75, 0.25, 0});
    check_fall(face, 1 * s, 3, Nature::crossing, Feature::f12, {0, 0.25, 0.75});
    check_fall(face, 0 * s, 3, Nature::crossing, Feature::f20, {0.25, 0, 0.75});
  }
}

TEST_CASE("a vertex falls beside a face") {
  check_no_contact(falling_on(kFace, 1, -0x1p-1074));
  check_no_contact(falling_on(kFace, -0x1p-1074, 1));
  check_no_contact(falling_on(kFace, 1, std::nextafter(3, 4)));
  check_no_contact(falling_on(kFace, -1, 5));
}

TEST_CASE("an irrational time on a face") {
  // The face is the ruled strip over the segment from (-1, t) to (2t, -1), seen along y, that reaches the origin at
  // sqrt(1/2): F0 and F1 are at its first end, F2 at the second.
  const Query query = VertexFace{{{{0, 0, 0}, {-1, -1, 0}, {-1, 1, 0}, {0, 0, -1}}},
                                 {{{0, 0, 0}, {-1, -1, 1}, {-1, 1, 1}, {2, 0, -1}}}};
  const double first = 0.5 * (1 - kSqrtTwoMinusOne);
  check_contact(query, {kSqrtHalf, Nature::crossing, Feature::v, Feature::f, kFirst, {first, first, kSqrtTwoMinusOne}});
}

TEST_CASE("a vertex grazes a face: a double root of V") {
  // The same over the segment from (-1, 2 - 2t) to (2t, -1): V is a multiple of (1 - 2t)^2.
  Query query = VertexFace{{{{0, 0, 0}, {-1, -1, 2}, {-1, 1, 2}, {0, 0, -1}}},
                           {{{0, 0, 0}, {-1, -1, 0}, {-1, 1, 0}, {2, 0, -1}}}};
  check_contact(query, {at(0.5), Nature::grazing, Feature::v, Feature::f, kFirst, {0.25, 0.25, 0.5}});
  query.end[1].z = query.end[2].z = -0x1p-60;
  check_no_contact(query);
}

TEST_CASE("a flat face is its three segments") {
  const auto flat = [](double x0, double x1, double x2) {
    return std::array<Vec3, 3>{{{x0, 0, 0}, {x1, 0, 0}, {x2, 0, 0}}};
  };
  const auto isolated = Nature::isolated;
  check_fall(flat(0, 4, 2), 1, 0, isolated, Feature::f01, {0.75, 0.25, 0});
  check_fall(flat(0, 4, 2), 2, 0, isolated, Feature::f2, kThird);  // a corner before the inside of f01
  check_fall(flat(0, 4, 2), 3, 0, isolated, Feature::f01, {0.25, 0.75, 0});
  check_fall(flat(0, 4, 8), 5, 0, isolated, Feature::f12, {0, 0.75, 0.25});
  check_fall(flat(0, 0, 4), 1, 0, isolated, Feature::f12, {0, 0.75, 0.25});
  check_fall(flat(0, 0, 4), 0, 0, isolated, Feature::f0, kFirst);
  check_fall(flat(0, 4, 4), 4, 0, isolated, Feature::f1, kSecond);
  check_fall(flat(4, 0, 4), 4, 0, isolated, Feature::f0, kFirst);
  check_fall(flat(2, 2, 2), 2, 0, isolated, Feature::f0, kFirst);
  check_no_contact(falling_on(flat(0, 4, 2), 4 + 0x1p-50, 0));
  check_no_contact(falling_on(flat(0, 4, 2), 1, 0x1p-1074));
  check_no_contact(falling_on(flat(2, 2, 2), 1, 0));
}

TEST_CASE("a face that is flat only at the contact") {
  // F2 comes down to F0 at t = 1/2, when the vertex arrives: V is a multiple of (1 - 2t)^2.
  const Query query =
      VertexFace{{{{1, 0, 1}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, {{{1, 0, -1}, {0, 0, 0}, {4, 0, 0}, {0, -4, 0}}}};
  check_contact(query, {at(0.5), Nature::grazing, Feature::v, Feature::f01, kFirst, {0.75, 0.25, 0}});
}

TEST_CASE("a vertex slides in the plane of a face") {
  // From (-1, 1, 0) to (3, 1, 0): through the side x = 0 at t = 1/4, out at x = 3 when t = 1.
  const auto sliding = [](double last_x) {
    return Query(
        VertexFace{{{{-1, 1, 0}, kFace[0], kFace[1], kFace[2]}}, {{{last_x, 1, 0}, kFace[0], kFace[1], kFace[2]}}});
  };
  check_contact(sliding(3), {at(0.25), Nature::sustained, Feature::v, Feature::f20, kFirst, {0.75, 0, 0.25}});
  check_contact(sliding(3), {at(0.25), Nature::isolated, Feature::v, Feature::f20, kFirst, {0.75, 0, 0.25}}, 0.25);
  check_contact(sliding(2), {kOneThird, Nature::sustained, Feature::v, Feature::f20, kFirst, {0.75, 0, 0.25}});
  check_no_contact(sliding(-0x1p-1074));
}

TEST_CASE("a vertex slides past a corner of a face, touching once") {
  // Along x + y = 0, in the plane of the face: (0, 0) at t = 1/2.
  const Query query =
      VertexFace{{{{-1, 1, 0}, kFace[0], kFace[1], kFace[2]}}, {{{1, -1, 0}, kFace[0], kFace[1], kFace[2]}}};
  check_contact(query, {at(0.5), Nature::isolated, Feature::v, Feature::f0, kFirst, kFirst});
}

TEST_CASE("a vertex that is inside from the start") {
  const Query query =
      VertexFace{{{{1, 1, 0}, kFace[0], kFace[1], kFace[2]}}, {{{9, 9, 0}, kFace[0], kFace[1], kFace[2]}}};
  check_contact(query, {at(0), Nature::sustained, Feature::v, Feature::f, kFirst, {0.5, 0.25, 0.25}});
  check_contact(query, {at(0), Nature::isolated, Feature::v, Feature::f, kFirst, {0.5, 0.25, 0.25}}, 0);
}
