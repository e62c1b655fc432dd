// The proof of one query, for touchstone-check: the plane of each piece, and the points that meet. docs/proofs.md,
// "Checking a proof", defines each step, and says after that why they imply the answer.
// SPDX-License-Identifier: MIT
#pragma once

#include "checker/polynomials.hpp"

namespace checker {

struct Kind {
  std::string_view name;
  std::uint32_t corners, first;  ///< of both elements, of the first one
};
constexpr std::array<Kind, 4> kKinds = {Kind{"edge-edge", 4, 2}, Kind{"vertex-face", 4, 1}, Kind{"point-edge", 3, 1},
                                        Kind{"point-point", 2, 1}};

enum class Metric { none, euclidean, max };

/// A query: corner i is at x[i] / w[i], where w[i] is positive at all times. With straight motion x[i] has two
/// coefficients, and w[i] is 1. All coordinates and the separation are multiplied by one positive number that makes
/// them integers.
struct Corners {
  Kind kind;
  std::array<Vector, 4> x;
  std::array<Polynomial, 4> w;
  std::array<std::size_t, 4> motion{};  ///< corners with the same one have the same w
  Metric metric = Metric::none;
  mpz_class separation;

  /// x[i] / w[i] - x[j] / w[j], times the weight that is both of them, or times both.
  Vector difference_of(std::size_t i, std::size_t j) const {
    Vector r;
    for (std::size_t k = 0; k < 3; ++k) {
      r[k] = motion[i] == motion[j] ? difference(x[i][k], x[j][k])
                                    : difference(product(x[i][k], w[j]), product(x[j][k], w[i]));
    }
    return r;
  }
  /// The separation, times what the difference of the corners is multiplied by.
  Polynomial separation_of(std::size_t i, std::size_t j) const {
    const Polynomial scaled = product(w[i], {separation});
    return motion[i] == motion[j] ? scaled : product(scaled, w[j]);
  }
};

/// A file of proofs.
class Proofs {
 public:
  explicit Proofs(const std::string& name) : lines_(name) {}

 protected:
  bool next() { return lines_.next(words_); }
  Rejected rejected(const std::string& reason) const { return Rejected(lines_.where() + reason); }
  Rejected expected(const std::string& what) const { return rejected("here must be " + what); }
  void require(bool holds, const char* reason) const {
    if (!holds) throw rejected(reason);
  }

  /// Checks the proof that comes next, which is that of the query `corners_`.
  void check_proof(std::uint64_t number) {
    const bool is_none = words_.size() == 2 && words_[1] == "none";
    if ((!is_none && (words_.size() != 4 || words_[1] != "contact")) || words_[0] != std::to_string(number)) {
      throw expected("\"" + std::to_string(number) + " none\" or \"" + std::to_string(number) + " contact T U\"");
    }
    if (is_none) {
      next();
      return check_pieces({1, 0}, false);
    }
    ++contacts_;
    Number toi, upper, neighbour;
    read_time(words_[2], toi, lines_);
    read_time(words_[3], upper, lines_);
    const bool is_double = compare(toi, upper) == 0;
    const bool are_neighbours = next_double(toi, neighbour) && (is_double || compare(upper, neighbour) == 0);
    require(are_neighbours && compare(upper, {1, 0}) <= 0,
            "the times must be one double, or two neighbouring ones, in [0, 1]");
    next();
    if (!is_double || sign(toi) > 0) check_pieces(toi, is_double);
    check_meeting(toi, upper);
  }

  Lines lines_;
  Words words_;
  Corners corners_;
  unsigned long long contacts_ = 0;

 private:
  /// A list of pieces that cover [0, end]; if `open`, the elements may meet at the end.
  void check_pieces(const Number& end, bool open) {
    Number from;
    for (bool last = false; !last; next()) {
      last = words_.size() < 3 || words_[words_.size() - 2] != "to";
      Number to = end;
      if (!last) {
        read_time(words_.back(), to, lines_);
        words_.resize(words_.size() - 2);
        require(compare(from, to) < 0 && compare(to, end) < 0,
                "the number after \"to\" must be between the start of its piece and the end of the last one");
      }
      check_piece({from, to}, open && last ? 1 : kNoZeros);
      from = to;
    }
  }

  /// One piece: the elements are on different sides of a plane.
  void check_piece(const Interval& on, std::size_t zeros_from) {
    const bool is_normal = words_.size() == 1 && words_[0] == "n" && corners_.kind.corners == 4;
    const Vector n = is_normal ? normal() : read_direction();
    int side = 0;
    for (std::size_t i = 0; i < corners_.kind.first; ++i) {
      for (std::size_t j = corners_.kind.first; j < corners_.kind.corners; ++j) {
        if (!is_separated(n, i, j, on, zeros_from, side)) {
          throw rejected("corner " + std::to_string(i) + " and corner " + std::to_string(j) +
                         " are not proved to be on different sides of the plane, with the separation between them");
        }
        // n is perpendicular to the edges of both elements: its products with all x_j - x_i have one sign at each time.
        if (is_normal) return;
      }
    }
  }

  /// u x w
  Vector normal() const {
    const bool is_edge = corners_.kind.first == 2;
    const Vector u = corners_.difference_of(is_edge ? 1 : 2, is_edge ? 0 : 1);
    const Vector w = corners_.difference_of(3, is_edge ? 2 : 1);
    Vector n;
    for (std::size_t k = 0; k < 3; ++k) {
      n[k] = difference(product(u[(k + 1) % 3], w[(k + 2) % 3]), product(u[(k + 2) % 3], w[(k + 1) % 3]));
    }
    return n;
  }
  Vector read_direction() const {
    const std::size_t size = words_.empty() ? 0 : (words_.size() - 1) / 3;
    require(size >= 1 && words_[0] == "d" && words_.size() == 1 + 3 * size,
            "here must be a piece: \"n\" for four corners, or \"d\" and three numbers for each coefficient");
    std::array<std::vector<Number>, 3> numbers;
    for (std::size_t k = 0; k < 3; ++k) numbers[k] = read_coefficients(words_, 1 + k, 3, lines_);
    return polynomials_of(numbers);
  }

  /// Whether n . (x_j - x_i) has the sign `side` during the piece, which is set if it is 0. With a separation the
  /// polynomials of docs/proofs.md that take its place are checked, and its sign at the start.
  bool is_separated(const Vector& n, std::size_t i, std::size_t j, const Interval& on, std::size_t zeros_from,
                    int& side) const {
    const Polynomial p = dot(n, corners_.difference_of(j, i)), b = bernstein(p, on);
    if (side == 0) side = sgn(b[0]);
    if (side == 0 || sgn(b[0]) != side) return false;
    if (corners_.metric == Metric::none) return have_sign(b, side, zeros_from);
    const Polynomial bound = corners_.separation_of(i, j);
    if (corners_.metric == Metric::euclidean) {
      const Polynomial squares = product(product(bound, bound), dot(n, n));
      return have_sign(bernstein(difference(product(p, p), squares), on), 1, zeros_from);
    }
    for (unsigned signs = 0; signs < 8; ++signs) {
      Polynomial sum;
      for (unsigned k = 0; k < 3; ++k) add(sum, n[k], (signs >> k) % 2 == 0 ? 1 : -1);
      if (!have_sign(bernstein(difference(p, product(bound, sum)), on), side, zeros_from)) return false;
    }
    return true;
  }

  /// At a time between toi and upper, a weighted point of one element is within the separation of one of the other.
  void check_meeting(const Number& toi, const Number& upper) {
    Number low = toi, high = upper;
    Polynomial root = compare(toi, upper) < 0 ? read_root(low, high) : polynomial_of({{-toi.m, toi.e}, {1, 0}});
    remove_factor(root);
    const Interval on(low, high);
    const std::array<Polynomial, 4> weights = read_weights();
    std::array<Polynomial, 2> sums;
    std::array<Vector, 2> points;
    for (std::size_t i = 0; i < corners_.kind.corners; ++i) {
      const Polynomial& weight = weights[i];
      if (weight.empty()) continue;
      if (!have_sign(bernstein(weight, on), 1, kNoZeros) && !divides(root, weight)) {
        throw rejected("before this line: the weight of corner " + std::to_string(i) + " may be negative");
      }
      const std::size_t e = i < corners_.kind.first ? 0 : 1;
      add_product(sums[e], weight, corners_.w[i]);
      for (std::size_t k = 0; k < 3; ++k) add_product(points[e][k], weight, corners_.x[i][k]);
    }
    for (const Polynomial& sum : sums) {
      require(have_sign(bernstein(sum, on), 1, kNoZeros),
              "before this line: the weights of an element may all be zero");
    }
    Vector c;
    for (std::size_t k = 0; k < 3; ++k) {
      c[k] = difference(product(sums[1], points[0][k]), product(sums[0], points[1][k]));
    }
    require(is_near(c, product(sums[0], sums[1]), root, on),
            corners_.metric == Metric::none
                ? "before this line: the weighted points are not proved to be equal"
                : "before this line: the weighted points are not proved to be within the separation");
  }

  /// A polynomial that has a root between low and high, which are set if the proof has others.
  Polynomial read_root(Number& low, Number& high) {
    require(words_.size() >= 2 && words_[0] == "root", "here must be \"root\" and the coefficients of a polynomial");
    const Number toi = low, upper = high;
    const std::size_t size = words_.size();
    if (size > 4 && words_[size - 3] == "between") {
      read_time(words_[size - 2], low, lines_);
      read_time(words_[size - 1], high, lines_);
      words_.resize(size - 3);
    }
    require(compare(low, toi) >= 0 && compare(low, high) < 0 && compare(high, upper) <= 0,
            "the numbers after \"between\" must be T <= LOW < HIGH <= U");
    const Polynomial g = polynomial_of(read_coefficients(words_, 1, 1, lines_));
    require(g.size() >= 2 && g.back() != 0,
            "the polynomial must have a degree of at least 1 and a leading coefficient that is not zero");
    const Polynomial b = bernstein(g, {low, high});  // the first and the last one have the signs of the values at both
    require(sgn(b.front()) * sgn(b.back()) < 0, "the polynomial must change its sign between LOW and HIGH");
    next();
    return g;
  }

  std::array<Polynomial, 4> read_weights() {
    std::array<std::vector<Number>, 4> numbers;
    for (; !words_.empty() && words_[0] == "w"; next()) {
      std::uint32_t i = 0;
      require(words_.size() >= 3 && read_count(words_[1], corners_.kind.corners - 1, i) && numbers[i].empty(),
              "here must be \"w\", a corner that has no weight yet, and the coefficients of a polynomial");
      numbers[i] = read_coefficients(words_, 2, 1, lines_);
    }
    return polynomials_of(numbers);
  }

  /// Whether c, the difference of the weighted points times `scale`, is at most the separation times it at the root.
  bool is_near(const Vector& c, const Polynomial& scale, const Polynomial& root, const Interval& on) const {
    const auto is_multiple = [&](const Polynomial& p) { return divides(root, p); };
    if (corners_.metric == Metric::none) return std::all_of(c.begin(), c.end(), is_multiple);
    const Polynomial bound = product(scale, {corners_.separation});
    if (corners_.metric == Metric::euclidean) {
      const Polynomial p = difference(dot(c, c), product(bound, bound));
      return have_sign(bernstein(p, on), -1, 0) || is_multiple(p);
    }
    for (const Polynomial& along : c) {
      for (const int s : {1, -1}) {
        Polynomial p = bound;
        add(p, along, s);
        if (!have_sign(bernstein(p, on), 1, 0) && !is_multiple(p)) return false;
      }
    }
    return true;
  }
};

}  // namespace checker
