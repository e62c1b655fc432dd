// SPDX-License-Identifier: MIT
#include "query_bytes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace touchstone::fuzzing {
namespace {

// Operations on a coordinate: one byte, and the bytes of its operands.
constexpr unsigned kSmall = 0x80;  // below it: a small integer, halved up to seven times
enum CoordinateOp : unsigned { kRaw, kEarlier, kNext, kMinus, kScaled, kSum, kUlps, kSpecial };
// Operations on a corner.
enum StartOp : unsigned { kFresh, kFreshToo, kCopy, kMiddle, kOneChanged, kReflected };
enum EndOp : unsigned { kMoves, kStatic, kTogether, kCopyEnd, kMovesOne, kSwapped };

constexpr std::array<double, 8> kSpecials{0.0,       -0.0,      0x1p-1074, 0x1p-1022, 0x1.fffffffffffffp+1023,
                                          0x1p+1000, 0x1p-1000, 1e8};

class Reader {
 public:
  explicit Reader(Bytes input) : rest_(input) {}
  unsigned byte() {
    if (rest_.empty()) return 0;
    const unsigned value = rest_.front();
    rest_ = rest_.subspan(1);
    return value;
  }
  std::uint64_t word() {
    std::uint64_t value = 0;
    for (int i = 0; i < 8; ++i) value |= std::uint64_t{byte()} << (8 * i);
    return value;
  }

 private:
  Bytes rest_;
};

double finite(double value) {
  if (std::isfinite(value)) return value;
  if (std::isnan(value)) return 0;
  return std::copysign(std::numeric_limits<double>::max(), value);
}

double raw_double(std::uint64_t bits) {
  constexpr std::uint64_t kExponent = std::uint64_t{0x7ff} << 52;
  if ((bits & kExponent) == kExponent) bits ^= std::uint64_t{1} << 62;
  return std::bit_cast<double>(bits);
}

/// `value` moved by a number of doubles.
double moved(double value, int doubles) {
  const double towards = std::copysign(std::numeric_limits<double>::infinity(), doubles);
  for (int i = std::abs(doubles); i > 0; --i) value = std::nextafter(value, towards);
  return finite(value);
}

class Builder {
 public:
  explicit Builder(Bytes input) : in_(input) {}

  Question build() {
    Question question;
    Query& query = question.query;
    const unsigned first = in_.byte();
    query.kind = static_cast<Kind>(first & 3);
    question.t_max = t_max(first >> 2 & 7);
    const int scale = first >= 0x80 ? (static_cast<int>(in_.byte()) - 128) * 8 : 0;
    const std::size_t corners = corner_count(query.kind);
    for (std::size_t i = 0; i < corners; ++i) query.start[i] = start(query, i);
    const Vec3 common = in_.byte() % 2 == 0 ? Vec3{} : fresh();
    for (std::size_t i = 0; i < corners; ++i) query.end[i] = end(query, i, common);
    if (scale == 0) return question;
    for (auto* side : {&query.start, &query.end}) {
      for (Vec3& corner : *side) {
        for (double* x : {&corner.x, &corner.y, &corner.z}) *x = finite(std::ldexp(*x, scale));
      }
    }
    return question;
  }

 private:
  double t_max(unsigned mode) {
    switch (mode) {
      case 4: return 0;
      case 5: return in_.byte() / 256.0;
      case 6: return std::clamp(std::fabs(raw_double(in_.word())), 0.0, 1.0);
      case 7: return moved(in_.byte() / 256.0, 1);
      default: return 1;
    }
  }

  double earlier() { return seen_.empty() ? 0 : seen_[in_.byte() % seen_.size()]; }

  double coordinate() {
    const unsigned op = in_.byte();
    double value = 0;
    if (op < kSmall) {
      value = std::ldexp(static_cast<int>(op % 16) - 8, -static_cast<int>(op / 16));
    } else {
      switch (op & 7) {
        case kRaw: value = raw_double(in_.word()); break;
        case kEarlier: value = earlier(); break;
        case kNext: value = moved(earlier(), (op & 8) == 0 ? 1 : -1); break;
        case kMinus: value = -earlier(); break;
        case kScaled: {
          const int exponent = (static_cast<int>(in_.byte()) - 128) * ((op & 8) == 0 ? 1 : 8);
          value = finite(std::ldexp(static_cast<int>(in_.byte()) - 128, exponent));
          break;
        }
        case kSum: {
          const double one = earlier();
          value = finite(one + earlier());
          break;
        }
        case kUlps: {
          const double one = earlier();
          value = moved(one, static_cast<int>(in_.byte()) - 128);
          break;
        }
        case kSpecial: value = kSpecials[in_.byte() % kSpecials.size()]; break;
      }
    }
    seen_.push_back(value);
    return value;
  }

  Vec3 fresh() {
    Vec3 corner;
    corner.x = coordinate();
    corner.y = coordinate();
    corner.z = coordinate();
    return corner;
  }

  static double& axis(Vec3& corner, unsigned which) {
    return which % 3 == 0 ? corner.x : which % 3 == 1 ? corner.y : corner.z;
  }

  /// (a + b) / 2, or a + weight (b - a) for a small integer weight: corners on a line, where doubles hold them.
  static double combined(double a, double b, int weight) {
    return finite(weight == 0 ? a / 2 + b / 2 : a + weight * (b - a));
  }

  Vec3 between(const std::array<Vec3, 4>& corners, std::size_t count) {
    const Vec3& a = corners[in_.byte() % count];
    const Vec3& b = corners[in_.byte() % count];
    const int weight = static_cast<int>(in_.byte() % 8) - 3;
    return {combined(a.x, b.x, weight), combined(a.y, b.y, weight), combined(a.z, b.z, weight)};
  }

  Vec3 start(const Query& query, std::size_t i) {
    const unsigned op = i == 0 ? kFresh : in_.byte() % 6;
    if (op == kFresh || op == kFreshToo) return fresh();
    if (op == kMiddle) return between(query.start, i);
    Vec3 corner = query.start[in_.byte() % i];
    if (op == kOneChanged) {
      const unsigned which = in_.byte();
      axis(corner, which) = coordinate();
    }
    if (op == kReflected) {
      double& x = axis(corner, in_.byte());
      x = -x;
    }
    return corner;
  }

  Vec3 end(const Query& query, std::size_t i, const Vec3& common) {
    Vec3 corner = query.start[i];
    switch (in_.byte() % 6) {
      case kMoves: return fresh();
      case kStatic: break;
      case kTogether: return {finite(corner.x + common.x), finite(corner.y + common.y), finite(corner.z + common.z)};
      case kCopyEnd: return i == 0 ? corner : query.end[in_.byte() % i];
      case kMovesOne: {
        const unsigned which = in_.byte();
        axis(corner, which) = coordinate();
        break;
      }
      case kSwapped: return query.start[in_.byte() % corner_count(query.kind)];
    }
    return corner;
  }

  Reader in_;
  std::vector<double> seen_;
};

void append_coordinate(std::string& bytes, double value) {
  for (unsigned halvings = 0; halvings < 8; ++halvings) {
    const double integer = std::ldexp(value, static_cast<int>(halvings));
    if (integer != std::floor(integer) || integer < -8 || integer > 7 || (value == 0 && std::signbit(value))) continue;
    bytes += static_cast<char>(16 * halvings + static_cast<unsigned>(static_cast<int>(integer) + 8));
    return;
  }
  bytes += static_cast<char>(kSmall + kRaw);
  const auto bits = std::bit_cast<std::uint64_t>(value);
  for (int i = 0; i < 8; ++i) bytes += static_cast<char>(bits >> (8 * i) & 0xff);
}

void append_corner(std::string& bytes, const Vec3& corner) {
  for (const double x : {corner.x, corner.y, corner.z}) append_coordinate(bytes, x);
}

bool same_bits(const Vec3& a, const Vec3& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace

Question question_from(Bytes input) { return Builder(input).build(); }

std::string bytes_for(const Query& query) {
  std::string bytes(1, static_cast<char>(query.kind));
  const std::size_t corners = corner_count(query.kind);
  for (std::size_t i = 0; i < corners; ++i) {
    if (i > 0) bytes += static_cast<char>(kFresh);
    append_corner(bytes, query.start[i]);
  }
  bytes += '\0';  // no common translation
  for (std::size_t i = 0; i < corners; ++i) {
    const bool stays = same_bits(query.start[i], query.end[i]);
    bytes += static_cast<char>(stays ? kStatic : kMoves);
    if (!stays) append_corner(bytes, query.end[i]);
  }
  return bytes;
}

}  // namespace touchstone::fuzzing
