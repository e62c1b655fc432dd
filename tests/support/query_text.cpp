// Queries as hexfloats and answers as text.
// SPDX-License-Identifier: MIT
#include "support/query_text.hpp"

#include <array>
#include <cstdio>

namespace touchstone::tests {
namespace {

// Three numbers between brackets.
std::string listed(char open, const std::array<double, 3>& numbers, char close) {
  std::string text(1, open);
  text += hexfloat(numbers[0]);
  for (const double number : {numbers[1], numbers[2]}) {
    text += ", ";
    text += hexfloat(number);
  }
  text += close;
  return text;
}

std::string rows(const std::array<Vec3, 4>& corners, std::size_t count) {
  std::string text("{{");
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) text += ", ";
    text += listed('{', {corners[i].x, corners[i].y, corners[i].z}, '}');
  }
  text += "}}";
  return text;
}

std::string weights_text(const std::array<double, 3>& weights) { return listed('(', weights, ')'); }

}  // namespace

std::string hexfloat(double value) {
  std::array<char, 40> buffer;
  const int length = std::snprintf(buffer.data(), buffer.size(), "%a", value);
  return std::string(buffer.data(), static_cast<std::size_t>(length));
}

std::string cpp_initializer(const Query& query) {
  static constexpr std::array<const char*, 4> types{"EdgeEdge", "VertexFace", "PointEdge", "PointPoint"};
  const std::size_t count = corner_count(query.kind);
  return std::string(types[static_cast<std::size_t>(query.kind)]) + "{" + rows(query.start, count) + ",\n    " +
         rows(query.end, count) + "}";
}

std::string curved_text(const CurvedQuery& query) {
  const auto point = [](const Vec3& x) { return std::string(" ").append(listed('{', {x.x, x.y, x.z}, '}')); };
  const auto quaternion = [](const std::array<double, 4>& q) {
    std::string text(" {");
    for (std::size_t i = 0; i < 4; ++i) text.append(i > 0 ? ", " : "").append(hexfloat(q[i]));
    return text.append("}");
  };
  std::string text(name_of(query.kind));
  std::array<bool, 4> used{};
  for (std::size_t i = 0; i < corner_count(query.kind); ++i) {
    const CurvedCorner& corner = query.corners[i];
    text.append("\n  ").append(corner_name(query.kind, i));
    if (corner.motion != CurvedCorner::kOnCurve) {
      used[static_cast<std::size_t>(corner.motion)] = true;
      text.append("  body ").append(std::to_string(corner.motion)).append(point(corner.points[0]));
      continue;
    }
    text.append("  curve");
    for (int k = 0; k < corner.control_points; ++k) text += point(corner.points[static_cast<std::size_t>(k)]);
  }
  for (std::size_t m = 0; m < used.size(); ++m) {
    if (!used[m]) continue;
    const RigidMotion& motion = query.motions[m];
    text.append("\n  motion ").append(std::to_string(m)).append("  q0").append(quaternion(motion.q0));
    text.append(" q1").append(quaternion(motion.q1));
    text.append(" p0").append(point(motion.p0)).append(" p1").append(point(motion.p1));
  }
  return text;
}

std::string describe(const Answer& answer) {
  const std::string by = " by " + std::string(name_of(answer.level));
  if (!answer.contact) return "no contact" + by;
  return "contact at [" + hexfloat(answer.toi) + ", " + hexfloat(answer.toi_upper) + "] " +
         std::string(name_of(answer.nature)) + " " + std::string(name_of(answer.feature_a)) + " " +
         std::string(name_of(answer.feature_b)) + " weights " + weights_text(answer.weights_a) + " " +
         weights_text(answer.weights_b) + by;
}

}  // namespace touchstone::tests
