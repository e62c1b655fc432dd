// Polynomials, queries and query files for touchstone-check.
// SPDX-License-Identifier: MIT
#pragma once

#include "checker/input.hpp"

namespace checker {

/// Coefficient i belongs to t^i. It keeps the memory of its coefficients when it is cleared.
class Polynomial {
 public:
  std::size_t size() const { return size_; }
  mpz_class& operator[](std::size_t i) { return all_[i]; }
  const mpz_class& operator[](std::size_t i) const { return all_[i]; }
  void clear() { size_ = 0; }
  /// Adds coefficients that are zero.
  void extend(std::size_t size) {
    if (all_.size() < size) all_.resize(size);
    for (; size_ < size; ++size_) all_[size_] = 0;
  }

 private:
  std::vector<mpz_class> all_;
  std::size_t size_ = 0;
};
using Vector = std::array<Polynomial, 3>;

/// Reads the words from `first` on, `step` apart, as the coefficients of a polynomial.
inline void read_coefficients(const Words& words, std::size_t first, std::size_t step, std::vector<Number>& numbers,
                              const Lines& lines) {
  lines.require(words.size() - first <= step * kMostCoefficients,
                "a polynomial has too many coefficients: at most 33 are read");
  numbers.clear();
  for (std::size_t i = first; i < words.size(); i += step) read_number(words[i], numbers.emplace_back(), lines);
}
/// Sets polynomials to their coefficients, all multiplied by one power of two that makes them integers.
template <std::size_t kCount>
void set_polynomials(std::array<Polynomial, kCount>& polynomials, const std::array<std::vector<Number>, 4>& numbers) {
  long low = std::numeric_limits<long>::max();
  for (std::size_t p = 0; p < kCount; ++p) {
    for (const Number& x : numbers[p]) low = std::min(low, x.e);
  }
  for (std::size_t p = 0; p < kCount; ++p) {
    polynomials[p].clear();
    polynomials[p].extend(numbers[p].size());
    for (std::size_t c = 0; c < numbers[p].size(); ++c) {
      polynomials[p][c] = numbers[p][c].m << static_cast<unsigned long>(numbers[p][c].e - low);
    }
  }
}

/// sum += factor p
inline void add(Polynomial& sum, const Polynomial& p, const mpz_class& factor) {
  sum.extend(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) mpz_addmul(sum[i].get_mpz_t(), p[i].get_mpz_t(), factor.get_mpz_t());
}
/// sum += p q
inline void add_product(Polynomial& sum, const Polynomial& p, const Polynomial& q) {
  if (p.size() == 0 || q.size() == 0) return;
  sum.extend(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) {
      mpz_addmul(sum[i + j].get_mpz_t(), p[i].get_mpz_t(), q[j].get_mpz_t());
    }
  }
}
inline void set_product(Polynomial& product, const Polynomial& p, const Polynomial& q) {
  product.clear();
  add_product(product, p, q);
}
inline void set_dot(Polynomial& dot, const Vector& a, const Vector& b) {
  dot.clear();
  for (std::size_t k = 0; k < 3; ++k) add_product(dot, a[k], b[k]);
}
inline void set_difference(Polynomial& difference, const Polynomial& p, const Polynomial& q) {
  difference.clear();
  add(difference, p, 1);
  add(difference, q, -1);
}

/// The times from low / 2^shift on that are (width / 2^shift) s later, for s in [0, 1].
struct Interval {
  mpz_class low, width;
  unsigned long shift = 0;
  void set(const Number& from, const Number& to) {
    const long e = std::min({from.e, to.e, 0L});
    low = from.m << static_cast<unsigned long>(from.e - e);
    width = (to.m << static_cast<unsigned long>(to.e - e)) - low;
    shift = static_cast<unsigned long>(-e);
  }
};

/// The Bernstein coefficients b_i of p over the interval, times C(d, i) 2^(shift d), for p with d + 1 coefficients.
/// These factors are positive, so the signs are right. With p(low + s width) = sum c_j s^j and 1 = (1 - s) + s, p is
/// the sum of the c_j s^j ((1 - s) + s)^(d - j). This is a polynomial of s and 1 - s: s^i (1 - s)^(d - i) has the
/// coefficient sum over j <= i of C(d - j, i - j) c_j, which is C(d, i) b_i.
inline void set_bernstein(Polynomial& b, const Polynomial& p, const Interval& on) {
  static mpz_class term;
  const std::size_t size = p.size();
  b.clear();
  b.extend(size);
  for (std::size_t k = 0; k < size; ++k) {  // by Horner's scheme: b times low + width s, and the next coefficient
    for (std::size_t i = k; i > 0; --i) {
      b[i] *= on.low;
      mpz_addmul(b[i].get_mpz_t(), b[i - 1].get_mpz_t(), on.width.get_mpz_t());
    }
    b[0] *= on.low;
    term = p[size - 1 - k] << (on.shift * k);
    b[0] += term;
  }
  // Also by Horner's scheme: the first k coefficients are those of a polynomial of 1 - s and s, times (1 - s) + s.
  for (std::size_t k = 1; k < size; ++k) {
    for (std::size_t i = k; i > 0; --i) b[i] += b[i - 1];
  }
}

/// Whether all of the Bernstein coefficients have this sign. From the index `zeros_from` on they may also be zero.
inline bool have_sign(const Polynomial& bernstein, int sign, std::size_t zeros_from) {
  for (std::size_t i = 0; i < bernstein.size(); ++i) {
    const int s = sgn(bernstein[i]);
    if (s != sign && (s != 0 || i < zeros_from)) return false;
  }
  return bernstein.size() > 0;
}
constexpr std::size_t kNoZeros = std::numeric_limits<std::size_t>::max();

/// Divides the coefficients, which are not all zero, by their greatest common factor.
inline void remove_factor(Polynomial& p) {
  mpz_class factor;
  for (std::size_t i = 0; i < p.size(); ++i) factor = gcd(factor, p[i]);
  for (std::size_t i = 0; i < p.size(); ++i) mpz_divexact(p[i].get_mpz_t(), p[i].get_mpz_t(), factor.get_mpz_t());
}
/// Whether g divides p, over the rational numbers. g has no common factor, and its leading coefficient is not zero. So
/// the quotient has integer coefficients, by Gauss's lemma.
inline bool divides(const Polynomial& g, const Polynomial& p) {
  static Polynomial rest;
  rest.clear();
  add(rest, p, 1);
  const mpz_class& lead = g[g.size() - 1];
  for (std::size_t size = rest.size(); size >= g.size(); --size) {
    mpz_class& top = rest[size - 1];
    if (!mpz_divisible_p(top.get_mpz_t(), lead.get_mpz_t())) return false;
    mpz_divexact(top.get_mpz_t(), top.get_mpz_t(), lead.get_mpz_t());
    for (std::size_t i = 0; i + 1 < g.size(); ++i) rest[size - g.size() + i] -= top * g[i];
  }
  for (std::size_t i = 0; i < std::min(rest.size(), g.size() - 1); ++i) {
    if (rest[i] != 0) return false;
  }
  return true;
}

struct Kind {
  std::string_view name;
  std::uint32_t corners, first;  ///< of both elements, of the first one
  bool touches_only = false;     ///< whether the separation of the file is zero for it
};
constexpr std::array<Kind, 4> kKinds = {Kind{"edge-edge", 4, 2}, Kind{"vertex-face", 4, 1}, Kind{"point-edge", 3, 1},
                                        Kind{"point-point", 2, 1}};

struct Fraction {
  mpz_class numerator, denominator = 1;
};
using Point = std::array<Fraction, 3>;
inline Fraction fraction_of(const Number& x) {
  Fraction fraction;
  fraction.numerator = x.m << static_cast<unsigned long>(std::max(x.e, 0L));
  fraction.denominator <<= static_cast<unsigned long>(std::max(-x.e, 0L));
  return fraction;
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

/// The corners of a query as polynomials: corner i is at x[i] / w[i]. The coordinates and the separation are multiplied
/// by the least number that makes them integers, and the components of all q by another one, whose square all x[i] and
/// w[i] are multiplied by: also those of curves, because a proof's weights are those of x[i].
struct Corners {
  std::array<Vector, 4> x;
  std::array<Polynomial, 4> w;
  std::array<std::size_t, 4> motion;  ///< corners with the same one have the same w
  mpz_class scale, turn_scale, separation;

  void set(const Query& query, const Number& distance) {
    const Fraction d = fraction_of(distance);
    scale = d.denominator;
    turn_scale = 1;
    for (std::size_t i = 0; i < query.kind.corners; ++i) {
      const Corner& corner = query.corners[i];
      for (std::size_t c = 0; c < corner.size; ++c) enlarge(scale, corner.points[c]);
      if (corner.motion == Corner::kOnCurve) continue;
      const Motion& body = query.motions[corner.motion];
      for (const auto& p : body.p) enlarge(scale, p);
      for (const auto& q : body.q) enlarge(turn_scale, q);
    }
    set_scaled(separation, d, scale);
    for (std::size_t i = 0; i < query.kind.corners; ++i) {
      const Corner& corner = query.corners[i];
      motion[i] = corner.motion;
      w[i].clear();
      if (corner.motion != Corner::kOnCurve) {
        set_body(i, corner, query.motions[corner.motion]);
        continue;
      }
      w[i].extend(1);
      w[i][0] = turn_scale * turn_scale;
      for (std::size_t k = 0; k < 3; ++k) {
        set_bezier(x[i][k], corner.points, corner.size, k, scale);
        for (std::size_t c = 0; turn_scale != 1 && c < corner.size; ++c) x[i][k][c] *= w[i][0];
      }
    }
  }

  /// x[i] / w[i] - x[j] / w[j], times the weight that is both of them, or times both.
  void set_difference_of(Vector& difference, std::size_t i, std::size_t j) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (motion[i] == motion[j]) {
        set_difference(difference[k], x[i][k], x[j][k]);
      } else {
        set_product(left_, x[i][k], w[j]);
        set_product(right_, x[j][k], w[i]);
        set_difference(difference[k], left_, right_);
      }
    }
  }

 private:
  template <class Fractions>
  static void enlarge(mpz_class& unit, const Fractions& fractions) {
    for (const Fraction& c : fractions) {
      if (!mpz_divisible_p(unit.get_mpz_t(), c.denominator.get_mpz_t())) unit = lcm(unit, c.denominator);
    }
  }
  static void set_scaled(mpz_class& to, const Fraction& c, const mpz_class& unit) {
    mpz_divexact(to.get_mpz_t(), unit.get_mpz_t(), c.denominator.get_mpz_t());
    to *= c.numerator;
  }
  /// Coefficient c is the difference of order c, times the binomial coefficient of the degree and c.
  template <class Points>
  static void set_bezier(Polynomial& to, const Points& points, std::size_t size, std::size_t k, const mpz_class& unit) {
    to.clear();
    to.extend(size);
    for (std::size_t c = 0; c < size; ++c) set_scaled(to[c], points[c][k], unit);
    for (std::size_t order = 1; order < size; ++order) {
      for (std::size_t c = size - 1; c >= order; --c) to[c] -= to[c - 1];
    }
    for (std::size_t c = 1; c + 1 < size; ++c) to[c] *= static_cast<unsigned>(size - 1);  // for degrees up to 3
  }
  /// With q = (s, v): w = s^2 + v . v, and x = (s^2 - v . v) y + 2 (v . y) v + 2 s (v x y) + w p.
  void set_body(std::size_t i, const Corner& corner, const Motion& body) {
    for (std::size_t c = 0; c < 4; ++c) set_bezier(q_[c], body.q, 2, c, turn_scale);
    along_.clear();
    for (std::size_t k = 0; k < 3; ++k) {
      set_scaled(y_[k], corner.points[0][k], scale);
      add(along_, q_[k + 1], 2 * y_[k]);
    }
    square_.clear();
    for (std::size_t c = 0; c < 4; ++c) {
      set_product(left_, q_[c], q_[c]);
      add(w[i], left_, 1);
      add(square_, left_, c == 0 ? 1 : -1);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      set_bezier(right_, body.p, 2, k, scale);
      set_product(x[i][k], w[i], right_);
      add(x[i][k], square_, y_[k]);
      add_product(x[i][k], along_, q_[k + 1]);
      left_.clear();
      add(left_, q_[(k + 1) % 3 + 1], 2 * y_[(k + 2) % 3]);
      add(left_, q_[(k + 2) % 3 + 1], -2 * y_[(k + 1) % 3]);
      add_product(x[i][k], left_, q_[0]);
    }
  }

  std::array<Polynomial, 4> q_;
  std::array<mpz_class, 3> y_;
  Polynomial along_, square_, left_, right_;
};

/// A file of queries with straight motion, or with curved motion if its first row says so.
class QueryFile {
 public:
  explicit QueryFile(const std::string& name) : lines_(name) {
    next_row();
    is_curved_ = !columns_.empty() && columns_[0] == "touchstone-curved";
    if (!is_curved_) return;
    require(columns_.size() == 2 && columns_[1] == "1", "the version of a file of curved queries must be 1");
    next_row();
  }
  bool is_curved() const { return is_curved_; }
  std::string digest() { return lines_.digest(); }
  /// Reads the next query, whose kind is set. @returns false at the end of the file
  bool next(Query& query) {
    if (columns_.empty()) return false;
    is_curved_ ? read_curved(query) : read_straight(query);
    return true;
  }

 private:
  void require(bool good, const char* reason) const { lines_.require(good, reason); }
  void next_row() {
    lines_.next(columns_, ",");
    for (std::string_view& column : columns_) {
      column.remove_prefix(std::min(column.find_first_not_of(" \t"), column.size()));
      column.remove_suffix(column.size() - (column.find_last_not_of(" \t") + 1));
    }
    require(!is_curved_ || columns_.empty() || lines_.has_end(), "the line's end is missing: the file may be cut off");
  }

  /// A row for each corner at the start of the step, then a row for each at the end.
  void read_straight(Query& query) {
    static std::string truth;
    for (std::size_t row = 0; row < 2 * query.kind.corners; ++row) {
      require(!columns_.empty(), "the file ends within a query: a row for each corner and each end was expected");
      Corner& corner = query.corners[row % query.kind.corners];
      corner.motion = Corner::kOnCurve;
      corner.size = 2;
      read_row(corner.points[row / query.kind.corners]);
      const std::string_view column = columns_.size() == 7 ? columns_[6] : std::string_view();
      if (row == 0) truth = column;
      require(column == truth, "the last column must be the same in all rows of a query");
      next_row();
    }
  }
  /// Three fractions, and the answer that the file claims if it does, which is not used here.
  void read_row(Point& point) {
    if (columns_.size() != 6 && columns_.size() != 7) {
      throw lines_.bad("a row has 6 or 7 columns, but here are " + std::to_string(columns_.size()));
    }
    for (std::size_t i = 0; i < 6; ++i) {
      mpz_class& x = i % 2 == 0 ? point[i / 2].numerator : point[i / 2].denominator;
      if (!read_integer(columns_[i], x)) {
        throw lines_.bad("here must be a decimal integer of at most 4,096 digits: " + quoted(columns_[i]));
      }
      if (i % 2 == 1 && sgn(x) <= 0) throw lines_.bad("a denominator must be positive: " + quoted(columns_[i]));
    }
    require(columns_.size() == 6 || columns_[6] == "0" || columns_[6] == "1", "the last column must be 0 or 1");
  }

  /// The row "query", and then the corners, and each motion before the first corner on it.
  void read_curved(Query& query) {
    require(columns_.size() == 2 && columns_[0] == "query" && (columns_[1] == "0" || columns_[1] == "1"),
            "a query starts with a row query,0 or query,1");
    for (Motion& motion : query.motions) motion.is_given = motion.is_used = false;
    std::size_t corners = 0;
    for (next_row(); !columns_.empty() && columns_[0] != "query"; next_row()) {
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
    const auto number = [&](std::size_t i) { return fraction_of(read_double(columns_[2 + i], lines_)); };
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
      corner.points[i / 3][i % 3] = fraction_of(read_double(columns_[first + i], lines_));
    }
  }

  Lines lines_;
  Words columns_;
  bool is_curved_ = false;
};

}  // namespace checker
