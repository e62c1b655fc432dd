// SPDX-License-Identifier: MIT
#include "fuzz/judging/finding_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>

#include "io/fail.hpp"

namespace touchstone::fuzz {
namespace {

std::string corner_text(const Vec3& corner) {
  std::string text = "(";
  text.append(decimal_text(corner.x)).append(", ").append(decimal_text(corner.y)).append(", ");
  return text.append(decimal_text(corner.z)).append(")");
}

bool same(double a, double b) { return a == b && std::signbit(a) == std::signbit(b); }
bool same(const Vec3& a, const Vec3& b) { return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z); }

std::string text_of(const Query& query, const std::string& indent) {
  std::string text;
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const std::string_view name = corner_name(query.kind, i);
    text.append(indent).append(name).append(4 - name.size(), ' ').append(corner_text(query.start[i]));
    if (same(query.start[i], query.end[i])) {
      text.append(" stands still\n");
    } else {
      text.append(" -> ").append(corner_text(query.end[i])).append("\n");
    }
  }
  return text;
}

std::string text_of(const CurvedQuery& query, const std::string& indent) {
  const auto quaternion_text = [](const std::array<double, 4>& q) {
    std::string text = " (";
    for (std::size_t i = 0; i < 4; ++i) text.append(i > 0 ? ", " : "").append(decimal_text(q[i]));
    return text.append(")");
  };
  std::string text;
  std::array<bool, 4> used{};
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const CurvedCorner& corner = query.corners[i];
    const std::string_view name = corner_name(query.kind, i);
    text.append(indent).append(name).append(4 - name.size(), ' ');
    if (corner.motion != CurvedCorner::kOnCurve) {
      used[static_cast<std::size_t>(corner.motion)] = true;
      text.append("body ").append(std::to_string(corner.motion)).append(" ").append(corner_text(corner.points[0]));
    } else {
      text.append(corner.control_points == 1 ? "at rest" : "curve");
      for (int k = 0; k < corner.control_points; ++k) {
        text.append(" ").append(corner_text(corner.points[static_cast<std::size_t>(k)]));
      }
    }
    text.append("\n");
  }
  for (std::size_t m = 0; m < used.size(); ++m) {
    if (!used[m]) continue;
    const RigidMotion& motion = query.motions[m];
    text.append(indent).append("body ").append(std::to_string(m)).append(": q").append(quaternion_text(motion.q0));
    if (motion.q0 == motion.q1) {
      text.append(" does not turn");
    } else {
      text.append(" ->").append(quaternion_text(motion.q1));
    }
    text.append(", p ").append(corner_text(motion.p0));
    if (!same(motion.p0, motion.p1)) text.append(" -> ").append(corner_text(motion.p1));
    text.append("\n");
  }
  return text;
}

}  // namespace

std::string decimal_text(double value) {
  std::array<char, 40> buffer;  // the longest is 24 characters
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return std::string(buffer.data(), result.ptr);
}

std::string corners_text(const AnyQuery& query, const std::string& indent) {
  return std::visit([&](const auto& q) { return text_of(q, indent); }, query);
}

std::string claim_text(const Reply& reply) {
  switch (reply.state) {
    case Reply::State::crashed: return "none: it crashed";
    case Reply::State::hung: return "none: it did not return in time";
    case Reply::State::malformed: return "none that can be understood";
    case Reply::State::answered: break;
  }
  if (!reply.contact) return "no contact";
  if (!reply.toi_as_written.empty()) return "contact at " + io::shortened(reply.toi_as_written);
  return reply.toi ? "contact at " + decimal_text(*reply.toi) : "contact";
}

std::string truth_text(const Answer& truth) {
  if (!truth.contact) return "no contact";
  if (truth.toi == truth.toi_upper) return "contact at " + decimal_text(truth.toi);
  return "contact between " + decimal_text(truth.toi) + " and the next double";
}

}  // namespace touchstone::fuzz
