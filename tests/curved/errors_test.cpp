// Wrong input is named: what, where, and what would be right.
// SPDX-License-Identifier: MIT
#include <functional>
#include <limits>
#include <string>

#include "curved/expected.hpp"

namespace touchstone::tests {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

CurvedQuery valid() {
  return curved(Kind::edge_edge, {body(2, {0, 0, 0}), body(2, {1, 0, 0}), rest({2, 0, 0}), rest({3, 0, 0})},
                {RigidMotion(), RigidMotion(), RigidMotion{{1, 0, 0, 0}, {1, 0, 0, 1}, {0, 0, 0}, {0, 0, 0}}});
}

std::string message_of(const CurvedQuery& query, double t_max = 1) {
  std::string message = "no error";
  try {
    solve(query, t_max);
  } catch (const InvalidQuery& error) {
    message = error.what();
  }
  const auto same = [&](const std::function<void()>& call) {
    try {
      call();
    } catch (const InvalidQuery& error) {
      return message == error.what();
    }
    return message == "no error";
  };
  CHECK(same([&] { solve(query, {.t_max = t_max, .method = Method::oracle}); }));
  CHECK(same([&] { contact_times(query, {}, t_max); }));
  return message;
}

std::string message_with(const std::function<void(CurvedQuery&)>& change) {
  CurvedQuery query = valid();
  change(query);
  return message_of(query);
}

TEST_CASE("wrong curved queries are named") {
  CHECK(message_of(valid()) == "no error");
  CHECK(message_with([](CurvedQuery& q) { q.corners[0].points[0].y = kNan; }) ==
        "edge-edge query: corner a0: the body point has y = nan; coordinates must be finite");
  CHECK(message_with([](CurvedQuery& q) {
          q.corners[3] = CurvedCorner::on_curve({{0, 0, 0}, {1, 1, -kInfinity}, {2, 2, 2}});
        }) == "edge-edge query: corner b1: control point 1 has z = -inf; coordinates must be finite");
  CHECK(message_with([](CurvedQuery& q) { q.corners[1].motion = 4; }) ==
        "edge-edge query: corner a1 has motion = 4; it must be 0 to 3, or -1 for a corner on a curve");
  CHECK(message_with([](CurvedQuery& q) { q.corners[1].motion = -2; }) ==
        "edge-edge query: corner a1 has motion = -2; it must be 0 to 3, or -1 for a corner on a curve");
  CHECK(message_with([](CurvedQuery& q) { q.corners[2].control_points = 0; }) ==
        "edge-edge query: corner b0 has 0 control points; a curve has 1 to 4 of them");
  CHECK(message_with([](CurvedQuery& q) { q.corners[2].control_points = 5; }) ==
        "edge-edge query: corner b0 has 5 control points; a curve has 1 to 4 of them");
  CHECK(message_with([](CurvedQuery& q) { q.motions[2].q1[2] = kInfinity; }) ==
        "motion 2: the quaternion q1 has y = inf; its components must be finite");
  CHECK(message_with([](CurvedQuery& q) { q.motions[2].q0[0] = 0; }) ==
        "motion 2: the quaternion q0 is zero; an orientation needs a component that is not 0");
  CHECK(message_with([](CurvedQuery& q) { q.motions[2].p1.x = kNan; }) ==
        "motion 2: the position p1 has x = nan; coordinates must be finite");
  CHECK(message_with([](CurvedQuery& q) { q.kind = static_cast<Kind>(9); }).find("the kind is 9") == 0);
  CHECK(message_of(valid(), 1.5) == "t_max is 1.5; it must be in [0, 1]");
  CHECK_THROWS_AS(solve(valid(), {.method = static_cast<Method>(7)}), InvalidQuery);
  CHECK_THROWS_AS(CurvedCorner::on_curve({}), InvalidQuery);
  CHECK_THROWS_AS(CurvedCorner::on_curve({{}, {}, {}, {}, {}}), InvalidQuery);
}

TEST_CASE("a quaternion that vanishes between its ends is an error, exactly") {
  const auto with = [](std::array<double, 4> q0, std::array<double, 4> q1) {
    return message_with([&](CurvedQuery& q) {
      q.motions[2].q0 = q0;
      q.motions[2].q1 = q1;
    });
  };
  CHECK(with({3, 0, -1.5, 0}, {-1, 0, 0.5, 0}) ==
        "motion 2: q1 is q0 times a negative number, so that (1 - t) q0 + t q1 is zero near t = 0.75; change the sign "
        "of all components of q1: the orientation at t = 1 stays the same");
  CHECK(with({3, 0, -1.5, 0}, {1, 0, -0.5, 0}) == "no error");
  CHECK(with({3, 0, -1.5, 0}, {-1, 0, std::nextafter(0.5, 1), 0}) == "no error");
  CHECK(with({3, 0, -1.5, 0}, {-1, 0x1p-1074, 0.5, 0}) == "no error");
  CHECK(with({0x1p1023, 0, 0, 0x1p-1074}, {-0x1p1023, 0, 0, -0x1p-1074}).find("motion 2: q1 is q0 times") == 0);
  CHECK(with({0x1p-1074, 0, 0, 0}, {-0x1p-1074, 0, 0, 0}).find("near t = 0.5;") != std::string::npos);
  CHECK(with({1, 0, 0, 0}, {-1, 0, 0, 0}).find("near t = 0.5;") != std::string::npos);
}

TEST_CASE("what no corner names is never read") {
  CurvedQuery query = valid();
  query.motions[0].q0 = {0, 0, 0, 0};
  query.motions[3].p0.x = kNan;
  query.corners[0].points[1].x = kNan;
  query.corners[2].points[1].x = kNan;
  CHECK(message_of(query) == "no error");
  query.kind = Kind::point_point;
  query.corners[2].control_points = 77;
  CHECK(message_of(query) == "no error");
}

}  // namespace
}  // namespace touchstone::tests
