// Queries with curved motion for touchstone-check: corners on curves and on bodies, and their rows.
// SPDX-License-Identifier: MIT
#pragma once

#include "checker/queries.hpp"

namespace checker {

/// The greatest m 2^e that is at most numerator / denominator, with integers |m| < 2^53 and e >= -1074. The denominator
/// is positive. `rest` is positive where the quotient is nearer to (m + 1) 2^e, and zero in the middle.
inline Number rounded_down(const mpz_class& numerator, const mpz_class& denominator, mpz_class& rest) {
  const auto bits = [](const mpz_class& x) { return static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)); };
  Number x;
  x.e = std::max(bits(numerator) - bits(denominator) - 54, -1075L);
  do {
    ++x.e;
    const mpz_class above = numerator << static_cast<unsigned long>(std::max(-x.e, 0L));
    const mpz_class below = denominator << static_cast<unsigned long>(std::max(x.e, 0L));
    mpz_fdiv_qr(x.m.get_mpz_t(), rest.get_mpz_t(), above.get_mpz_t(), below.get_mpz_t());
    rest = 2 * rest - below;
  } while (bits(x.m) > 53);
  return x;
}

/// The least m 2^e that is at least x, likewise.
inline Number rounded_up(const Number& x) {
  mpz_class rest;
  const auto shift = [&](long e) { return static_cast<unsigned long>(std::max(e, 0L)); };
  Number up = rounded_down(-(x.m << shift(x.e)), mpz_class(1) << shift(-x.e), rest);
  up.m = -up.m;
  return up;
}

/// The double that is nearest to a decimal or a hexfloat; of two, the one with an even significand.
inline Number read_double(std::string_view word, const Lines& lines) {
  std::string_view text = word;
  const bool negative = text.substr(0, 1) == "-";
  if (negative) text.remove_prefix(1);
  const bool is_hex = text.substr(0, 2) == "0x" || text.substr(0, 2) == "0X";
  if (is_hex) text.remove_prefix(2);
  Number x;
  bool is_finite = read_digits(text, is_hex, is_hex ? "pP" : "eE", kMostDigits, x);
  if (is_finite && sign(x) != 0) {
    mpz_class unit = 1, rest;
    const auto size = static_cast<unsigned long>(std::abs(x.e));
    is_hex ? mpz_mul_2exp(unit.get_mpz_t(), unit.get_mpz_t(), size) : mpz_ui_pow_ui(unit.get_mpz_t(), 10, size);
    x = x.e > 0 ? rounded_down(x.m * unit, 1, rest) : rounded_down(x.m, unit, rest);
    if (rest > 0 || (rest == 0 && mpz_odd_p(x.m.get_mpz_t()))) ++x.m;
    is_finite = x.m != 0 && static_cast<long>(mpz_sizeinbase(x.m.get_mpz_t(), 2)) + x.e <= 1024;
  }
  if (!is_finite) throw lines.bad("here must be a finite double, such as 0.25 or 0x1p-2: " + quoted(word));
  if (negative) mpz_neg(x.m.get_mpz_t(), x.m.get_mpz_t());
  return x;
}

/// On a Bezier curve with these control points, which is straight for two of them; or at the first point of a body.
struct Corner {
  static constexpr std::size_t kOnCurve = 4;
  std::size_t motion = kOnCurve, size = 2;  ///< the body's motion, or none; the number of points
  std::array<Point, 4> points;
};
/// The orientation and the position of a body at the start, and at the end.
struct Motion {
  std::array<std::array<Fraction, 4>, 2> q;
  std::array<Point, 2> p;
  bool is_given = false, is_used = false;
};
/// Whether (1 - t) q0 + t q1 is not zero at any t in [0, 1]: docs/proofs.md has the reason.
inline bool turns(const Motion& motion) {
  std::array<mpq_class, 3> sums;  // q0 . q0, q0 . q1 and q1 . q1
  for (std::size_t i = 0; i < 12; ++i) {
    const Fraction &x = motion.q[i / 8][i % 4], &y = motion.q[(i / 4 + 1) / 2][i % 4];
    mpq_class product(x.numerator * y.numerator, x.denominator * y.denominator);
    product.canonicalize();
    sums[i / 4] += product;
  }
  return sgn(sums[1]) > 0 || sums[1] * sums[1] != sums[0] * sums[2];
}

struct Query {
  Kind kind;
  std::array<Corner, 4> corners;
  std::array<Motion, 4> motions;
};

/// Coefficient c is the difference of order c, times the binomial coefficient of the degree and c.
template <class Points>
Polynomial bezier(const Points& points, std::size_t size, std::size_t k, const mpz_class& unit) {
  Polynomial p;
  for (std::size_t c = 0; c < size; ++c) p.push_back(scaled(points[c][k], unit));
  for (std::size_t order = 1; order < size; ++order) {
    for (std::size_t c = size - 1; c >= order; --c) p[c] -= p[c - 1];
  }
  for (std::size_t c = 1; c + 1 < size; ++c) p[c] *= static_cast<unsigned>(size - 1);  // for degrees up to 3
  return p;
}

/// With q = (s, v): w = s^2 + v . v, and x = (s^2 - v . v) y + 2 (v . y) v + 2 s (v x y) + w p.
inline void set_on_body(Vector& x, Polynomial& w, const Point& point, const Motion& body, const mpz_class& unit,
                        const mpz_class& turn_unit) {
  std::array<Polynomial, 4> q;
  std::array<mpz_class, 3> y;
  Polynomial along, difference_of_squares;
  w.clear();
  for (std::size_t c = 0; c < 4; ++c) {
    q[c] = bezier(body.q, 2, c, turn_unit);
    const Polynomial square = product(q[c], q[c]);
    add(w, square, 1);
    add(difference_of_squares, square, c == 0 ? 1 : -1);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    y[k] = scaled(point[k], unit);
    add(along, q[k + 1], 2 * y[k]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] = product(w, bezier(body.p, 2, k, unit));
    add(x[k], difference_of_squares, y[k]);
    add_product(x[k], along, q[k + 1]);
    Polynomial turned;
    add(turned, q[(k + 1) % 3 + 1], 2 * y[(k + 2) % 3]);
    add(turned, q[(k + 2) % 3 + 1], -2 * y[(k + 1) % 3]);
    add_product(x[k], turned, q[0]);
  }
}

/// The coordinates and the separation are multiplied by the least number that makes them integers, and the components
/// of all q by another one, whose square all x[i] and w[i] are multiplied by: also those of curves, because a proof's
/// weights are those of x[i]. @returns the first number
inline mpz_class set_corners(Corners& corners, const Query& query, const Separation& separation) {
  const Fraction distance = fraction_of(separation.distance);
  mpz_class unit = distance.denominator, turn_unit = 1;
  for (std::size_t i = 0; i < query.kind.corners; ++i) {
    const Corner& corner = query.corners[i];
    for (std::size_t c = 0; c < corner.size; ++c) enlarge(unit, corner.points[c]);
    if (corner.motion == Corner::kOnCurve) continue;
    const Motion& body = query.motions[corner.motion];
    for (const auto& p : body.p) enlarge(unit, p);
    for (const auto& q : body.q) enlarge(turn_unit, q);
  }
  corners.kind = query.kind;
  corners.metric = separation.metric;
  corners.separation = scaled(distance, unit);
  for (std::size_t i = 0; i < query.kind.corners; ++i) {
    const Corner& corner = query.corners[i];
    corners.motion[i] = corner.motion;
    if (corner.motion != Corner::kOnCurve) {
      set_on_body(corners.x[i], corners.w[i], corner.points[0], query.motions[corner.motion], unit, turn_unit);
      continue;
    }
    corners.w[i] = {turn_unit * turn_unit};
    for (std::size_t k = 0; k < 3; ++k) {
      corners.x[i][k] = product(bezier(corner.points, corner.size, k, unit), corners.w[i]);
    }
  }
  return unit;
}

/// Reads queries with curved motion.
class CurvedRows {
 public:
  explicit CurvedRows(QueryFile& file) : file_(file), columns_(file.columns) {}

  /// The row "query", and then the corners, and each motion before the first corner on it.
  void read(Query& query) {
    require(columns_.size() == 2 && columns_[0] == "query" && (columns_[1] == "0" || columns_[1] == "1"),
            "a query starts with a row query,0 or query,1");
    for (Motion& motion : query.motions) motion.is_given = motion.is_used = false;
    std::size_t corners = 0;
    for (file_.next_row(); !columns_.empty() && columns_[0] != "query"; file_.next_row()) {
      if (columns_[0] == "motion") {
        read_motion(query);
      } else {
        require(corners < query.kind.corners, "the query has a corner too many for its kind");
        read_corner(query, query.corners[corners++]);
      }
    }
    require(corners == query.kind.corners, "the query before this line has too few corners for its kind");
    for (const Motion& motion : query.motions) {
      require(motion.is_given == motion.is_used, "the query before this line has a motion without a corner");
    }
  }

 private:
  void require(bool good, const char* reason) const { file_.lines.require(good, reason); }

  /// The motion that the second column names.
  std::size_t motion_number() const {
    require(columns_.size() > 1 && columns_[1].size() == 1 && columns_[1][0] >= '0' && columns_[1][0] <= '3',
            "the number of a motion must be 0, 1, 2 or 3");
    return static_cast<std::size_t>(columns_[1][0] - '0');
  }
  void read_motion(Query& query) {
    Motion& motion = query.motions[motion_number()];
    require(columns_.size() == 16 && !motion.is_given, "here must be the 14 numbers of a motion that has no row yet");
    motion.is_given = true;
    const auto number = [&](std::size_t i) { return fraction_of(read_double(columns_[2 + i], file_.lines)); };
    for (std::size_t i = 0; i < 8; ++i) motion.q[i / 4][i % 4] = number(i);
    for (std::size_t i = 0; i < 6; ++i) motion.p[i / 3][i % 3] = number(8 + i);
    require(turns(motion), "the quaternion must not be zero at a time in [0, 1]");
  }
  void read_corner(Query& query, Corner& corner) {
    const bool on_body = columns_[0] == "body";
    const std::size_t first = on_body ? 2 : 1;
    require(on_body || columns_[0] == "curve", "here must be a row that starts with query, motion, body or curve");
    corner.motion = on_body ? motion_number() : Corner::kOnCurve;
    if (on_body) {
      require(query.motions[corner.motion].is_given, "the motion must have a row before the corners on it");
      query.motions[corner.motion].is_used = true;
    }
    corner.size = (columns_.size() - 1) / 3;
    require(corner.size >= 1 && corner.size <= (on_body ? 1 : 4) && columns_.size() == first + 3 * corner.size,
            "here must be the three coordinates of a point of a body, or of 1 to 4 control points");
    for (std::size_t i = 0; i < 3 * corner.size; ++i) {
      corner.points[i / 3][i % 3] = fraction_of(read_double(columns_[first + i], file_.lines));
    }
  }

  QueryFile& file_;
  const Words& columns_;
};

}  // namespace checker
