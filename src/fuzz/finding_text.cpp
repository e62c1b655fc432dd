// SPDX-License-Identifier: MIT
#include "fuzz/finding_text.hpp"

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

}  // namespace

std::string decimal_text(double value) {
  std::array<char, 40> buffer;  // the longest is 24 characters
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return std::string(buffer.data(), result.ptr);
}

std::string corners_text(const Query& query, const std::string& indent) {
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
