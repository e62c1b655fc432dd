// touchstone-check: checks proofs of collision answers. It believes nobody: it reads the queries and the proofs itself,
// and computes with integers only. docs/proofs.md defines the format, and says why a checked proof implies its answer.
//
//   g++ -O2 -std=c++17 checker.cpp -lgmpxx -lgmp -o touchstone-check
//   touchstone-check PROOFS QUERY_FILE...
//
// Exit status: 0 every proof holds, 1 some proof does not, 2 bad usage or a file that cannot be read.
// Limits: lines of 2^20 bytes, integers of 20,000 digits, exponents of two up to 100,000, polynomials of degree 16.
// SPDX-License-Identifier: MIT
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct Rejected : std::runtime_error {  // exit status 1
  using std::runtime_error::runtime_error;
};
struct BadInput : std::runtime_error {  // exit status 2
  using std::runtime_error::runtime_error;
};

constexpr std::size_t kLongestLine = 1U << 20, kMostDigits = 20000, kMostDegree = 16;
constexpr long kMostExponent = 100000;

// ---- Exact numbers: m 2^e -------------------------------------------------------------------------------------------

struct Number {
  mpz_class m;
  long e = 0;
  Number(long value = 0) : m(value) {}
  Number(mpz_class mantissa, long exponent) : m(std::move(mantissa)), e(exponent) {}
};
int sign(const Number& x) { return sgn(x.m); }
Number operator*(const Number& a, const Number& b) { return {mpz_class(a.m * b.m), a.e + b.e}; }
Number operator-(const Number& a) { return {mpz_class(-a.m), a.e}; }
Number operator+(const Number& a, const Number& b) {
  if (a.e == b.e) return {mpz_class(a.m + b.m), a.e};
  if (sign(a) == 0) return b;
  if (sign(b) == 0) return a;
  const Number& high = a.e > b.e ? a : b;
  const Number& low = a.e > b.e ? b : a;
  return {mpz_class((high.m << static_cast<unsigned long>(high.e - low.e)) + low.m), low.e};
}
Number operator-(const Number& a, const Number& b) { return a + (-b); }
bool operator<(const Number& a, const Number& b) { return sign(b - a) > 0; }
bool operator==(const Number& a, const Number& b) { return sign(b - a) == 0; }

// ---- Polynomials: coefficient i belongs to t^i ----------------------------------------------------------------------

using Polynomial = std::vector<Number>;
Polynomial operator+(const Polynomial& p, const Polynomial& q) {
  Polynomial sum = p.size() < q.size() ? q : p;
  const Polynomial& shorter = p.size() < q.size() ? p : q;
  for (std::size_t i = 0; i < shorter.size(); ++i) sum[i] = sum[i] + shorter[i];
  return sum;
}
Polynomial operator-(const Polynomial& p) {
  Polynomial negative;
  for (const Number& c : p) negative.push_back(-c);
  return negative;
}
Polynomial operator-(const Polynomial& p, const Polynomial& q) { return p + (-q); }
Polynomial operator*(const Polynomial& p, const Polynomial& q) {
  if (p.empty() || q.empty()) return {};
  Polynomial product(p.size() + q.size() - 1);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) product[i + j] = product[i + j] + p[i] * q[j];
  }
  return product;
}
Number value(const Polynomial& p, const Number& t) {
  Number sum;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * t + p[i];
  return sum;
}
/// q(x) = p(from + x (to - from)), by Horner's rule.
Polynomial on_piece(const Polynomial& p, const Number& from, const Number& to) {
  if (sign(from) == 0 && to == Number(1)) return p;
  const Polynomial line = {from, to - from};
  Polynomial q;
  for (std::size_t i = p.size(); i-- > 0;) q = q * line + Polynomial{p[i]};
  return q;
}
/// The Bernstein coefficients of p over [0, 1], all multiplied by the factorial of the degree, which is positive:
/// b_i = sum over j <= i of C(i, j) / C(d, j) c_j, and d! C(i, j) / C(d, j) = i! (d - j)! / (i - j)!.
Polynomial bernstein(const Polynomial& p) {
  static const auto factorial = [] {
    std::array<long, kMostDegree + 4> f{};  // 19! is below 2^63
    f[0] = 1;
    for (std::size_t i = 1; i < f.size(); ++i) f[i] = f[i - 1] * static_cast<long>(i);
    return f;
  }();
  const std::size_t d = p.empty() ? 0 : p.size() - 1;
  Polynomial b(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      b[i] = b[i] + Number(mpz_class(p[j].m * (factorial[i] / factorial[i - j]) * factorial[d - j]), p[j].e);
    }
  }
  return b;
}
/// Whether g divides p, over the rational numbers. g's leading coefficient is not zero.
bool divides(const Polynomial& g, Polynomial p) {
  while (p.size() >= g.size()) {
    const Number lead = p.back();
    const std::size_t shift = p.size() - g.size();
    for (Number& c : p) c = c * g.back();
    for (std::size_t i = 0; i < g.size(); ++i) p[shift + i] = p[shift + i] - lead * g[i];
    p.pop_back();  // it is zero now
  }
  return std::all_of(p.begin(), p.end(), [](const Number& c) { return sign(c) == 0; });
}
using Vector = std::array<Polynomial, 3>;
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Polynomial dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// ---- Text -----------------------------------------------------------------------------------------------------------

/// The lines of a file, and its SHA-256 digest.
class Lines {
 public:
  explicit Lines(const std::string& name) : name_(name), file_(name, std::ios::binary) {
    if (!file_) throw BadInput(name + ": cannot be opened");
  }
  /// The next line that is neither blank nor a comment. @returns false at the end
  bool next(std::string& line) {
    for (;;) {
      line.clear();
      int c = file_.get();
      if (c == EOF) {
        if (file_.bad()) throw BadInput(name_ + ": cannot be read");
        return false;
      }
      ++number_;
      for (; c != EOF && c != '\n'; c = file_.get()) {
        if (line.size() >= kLongestLine) throw BadInput(where() + "the line is longer than 2^20 bytes");
        line += static_cast<char>(c);
      }
      if (!line.empty() && line.back() == '\r') line.pop_back();
      const std::size_t first = line.find_first_not_of(" \t");
      if (first != std::string::npos && line[first] != '#') return true;
    }
  }
  std::string where() const { return name_ + ":" + std::to_string(number_) + ": "; }

 private:
  std::string name_;
  std::ifstream file_;
  std::uint64_t number_ = 0;
};

std::vector<std::string> words_of(const std::string& line, char separator) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : line + separator) {
    if (c != separator && !(separator == ',' && (c == ' ' || c == '\t'))) {
      word += c;
    } else if (c == separator && (separator == ',' || !word.empty())) {
      words.push_back(std::move(word));
      word.clear();
    }
  }
  return words;
}
mpz_class integer(const std::string& text, int base, const std::string& where) {
  const std::size_t first = !text.empty() && text[0] == '-' ? 1 : 0;
  const bool plain = text.size() > first && text.size() <= kMostDigits &&
                     std::all_of(text.begin() + static_cast<long>(first), text.end(), [base](unsigned char c) {
                       return base == 10 ? std::isdigit(c) != 0 : std::isxdigit(c) != 0;
                     });
  if (!plain) throw BadInput(where + "no integer of at most 20,000 digits: " + text.substr(0, 40));
  return mpz_class(text, base);
}
/// "-12", or a C hexfloat with any number of digits: "0x1.8p-3".
Number number(std::string text, const std::string& where) {
  const bool negative = !text.empty() && text[0] == '-';
  const std::size_t start = negative ? 1 : 0;
  if (text.compare(start, 2, "0x") != 0) return {integer(text, 10, where), 0};
  const std::size_t p = text.find('p');
  if (p == std::string::npos) throw BadInput(where + "a hexadecimal number without an exponent: " + text.substr(0, 40));
  const bool plus = p + 1 < text.size() && text[p + 1] == '+';
  const mpz_class exponent = integer(text.substr(p + (plus ? 2 : 1)), 10, where);
  if (abs(exponent) > kMostExponent) throw BadInput(where + "the exponent is beyond 100,000");
  std::string digits = text.substr(start + 2, p - start - 2);
  const std::size_t point = digits.find('.');
  long e = exponent.get_si();
  if (point != std::string::npos) {
    e -= 4 * static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  if (!digits.empty() && digits[0] == '-') throw BadInput(where + "a sign within a number");
  const mpz_class m = integer(digits, 16, where);
  return {negative ? mpz_class(-m) : m, e};
}
Polynomial polynomial(const std::vector<std::string>& words, std::size_t first, const std::string& where) {
  if (first >= words.size() || words.size() - first > kMostDegree + 1) {
    throw BadInput(where + "a polynomial has 1 to 17 coefficients");
  }
  Polynomial p;
  for (std::size_t i = first; i < words.size(); ++i) p.push_back(number(words[i], where));
  return p;
}

// ---- Queries --------------------------------------------------------------------------------------------------------

struct KindOf {
  std::size_t corners, first;  ///< of both elements, of the first one
};
const std::map<std::string, KindOf> kKinds = {
    {"edge-edge", {4, 2}}, {"vertex-face", {4, 1}}, {"point-edge", {3, 1}}, {"point-point", {2, 1}}};

/// The corners as polynomials of t of degree 1, all multiplied by one positive integer, so that they are integers.
using Corners = std::vector<Vector>;
bool read_query(Lines& lines, const KindOf& kind, Corners& corners) {
  std::vector<std::array<mpz_class, 6>> rows;  // three fractions each
  mpz_class common = 1;
  for (std::size_t i = 0; i < 2 * kind.corners; ++i) {
    std::string line;
    if (!lines.next(line)) {
      if (i == 0) return false;
      throw BadInput(lines.where() + "the file ends within a query");
    }
    const std::vector<std::string> words = words_of(line, ',');
    if (words.size() != 7) throw BadInput(lines.where() + "a row has 7 columns");
    auto& row = rows.emplace_back();
    for (std::size_t k = 0; k < 6; ++k) row[k] = integer(words[k], 10, lines.where());
    for (std::size_t k = 1; k < 6; k += 2) {
      if (row[k] <= 0) throw BadInput(lines.where() + "a denominator is not positive");
      common = lcm(common, row[k]);
    }
  }
  corners.assign(kind.corners, Vector());
  for (std::size_t i = 0; i < kind.corners; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto scaled = [&](std::size_t row) {
        return mpz_class(rows[row][2 * k] * (common / rows[row][2 * k + 1]));
      };
      const mpz_class start = scaled(i), end = scaled(kind.corners + i);
      corners[i][k] = {Number(start, 0), Number(mpz_class(end - start), 0)};
    }
  }
  return true;
}

// ---- Proofs ---------------------------------------------------------------------------------------------------------

/// The direction u x w, on which every corner of one element is the same distance from every corner of the other.
Vector normal(const Corners& x, const KindOf& kind, const std::string& where) {
  if (kind.corners != 4) throw Rejected(where + "two elements of fewer than four corners have no normal");
  return kind.first == 2 ? cross(x[1] - x[0], x[3] - x[2]) : cross(x[2] - x[1], x[3] - x[1]);
}
/// One piece: the elements are on different sides of a plane at all times of [from, to], or of [from, to) if `open`.
void check_piece(const Corners& x, const KindOf& kind, const Vector& direction, const Number& from, const Number& to,
                 bool open, const std::string& where) {
  int side = 0;
  for (std::size_t i = 0; i < kind.first; ++i) {
    for (std::size_t j = kind.first; j < kind.corners; ++j) {
      const Polynomial b = bernstein(on_piece(dot(direction, x[j] - x[i]), from, to));
      for (std::size_t k = 0; k < b.size(); ++k) {
        const int s = sign(b[k]);
        if (side == 0) side = s;  // of the very first coefficient, which must not be zero
        const bool may_be_zero = open && k > 0;
        if (side == 0 || s == -side || (s == 0 && !may_be_zero)) {
          throw Rejected(where + "corner " + std::to_string(i) + " and corner " + std::to_string(j) +
                         " are not proved to be on different sides of the plane");
        }
      }
    }
  }
}
/// Whether x is a double: m 2^e with |m| < 2^53 and e >= -1074. The next double is then x + 2^e with the least such e
/// for which |m| >= 2^52, or e = -1074.
bool next_double(Number x, Number& next) {
  if (sign(x) < 0) return false;
  while (sign(x) != 0 && (mpz_even_p(x.m.get_mpz_t()) != 0)) x.m /= 2, ++x.e;
  if (sign(x) == 0) x.e = -1074;
  if (mpz_sizeinbase(x.m.get_mpz_t(), 2) > 53 || x.e < -1074) return false;
  while (x.e > -1074 && mpz_sizeinbase(x.m.get_mpz_t(), 2) < 53) x.m *= 2, --x.e;
  next = Number(mpz_class(x.m + 1), x.e);
  return true;
}

class Checker {
 public:
  Checker(const std::string& proofs, const std::vector<std::string>& files) : lines_(proofs), files_(files) {}

  void run() {
    if (!next() || words_ != std::vector<std::string>{"touchstone-proofs", "1"}) {
      throw BadInput(lines_.where() + "the first line must be \"touchstone-proofs 1\"");
    }
    next();
    for (const std::string& file : files_) check_file(file);
    if (words_.empty() || words_[0] != "end") throw Rejected(lines_.where() + "\"end\" is missing: the file was cut");
    const std::vector<std::string> end = {"end", std::to_string(queries_), std::to_string(contacts_)};
    if (words_ != end) throw Rejected(lines_.where() + "the numbers of queries and contacts are not those of the file");
    if (next()) throw Rejected(lines_.where() + "there is more after \"end\"");
    std::printf("%llu queries checked: %llu contacts, %llu without contact\n", queries_, contacts_,
                queries_ - contacts_);
  }

 private:
  bool next() {
    std::string line;
    words_.clear();
    if (!lines_.next(line)) return false;
    words_ = words_of(line, ' ');
    return true;
  }

  void check_file(const std::string& name) {
    if (words_.size() < 4 || words_[0] != "file" || kKinds.count(words_[1]) == 0) {
      throw Rejected(lines_.where() + "here the proofs of " + name + " must begin");
    }
    const std::string kind_name = words_[1];
    const KindOf kind = kKinds.at(kind_name);
    const unsigned long long before = queries_;
    next();
    Lines queries(name);
    Corners corners;
    for (std::uint64_t i = 0; read_query(queries, kind, corners); ++i) {
      ++queries_;
      try {
        check_query(corners, kind, i);
      } catch (const Rejected& reason) {
        throw Rejected(name + ": query " + std::to_string(i) + ": " + reason.what());
      }
    }
    // The proofs say which kind the queries are, so a person must see it.
    std::printf("%s: %llu %s queries\n", name.c_str(), queries_ - before, kind_name.c_str());
  }

  void check_query(const Corners& x, const KindOf& kind, std::uint64_t query) {
    if (words_.size() < 2 || words_[0] != std::to_string(query)) {
      throw Rejected(lines_.where() + "here its proof must begin");
    }
    const bool contact = words_[1] == "contact" && words_.size() == 4;
    if (!contact && (words_[1] != "none" || words_.size() != 2)) {
      throw Rejected(lines_.where() + "the answer is neither none nor contact");
    }
    if (!contact) {
      next();
      return check_pieces(x, kind, Number(1), false);
    }
    ++contacts_;
    const Number toi = number(words_[2], lines_.where()), upper = number(words_[3], lines_.where());
    Number neighbour;
    if (sign(toi) < 0 || Number(1) < upper || !next_double(toi, neighbour) || !(upper == toi || upper == neighbour)) {
      throw Rejected(lines_.where() + "the times are neither one double nor two neighbouring ones in [0, 1]");
    }
    const bool is_double = upper == toi;
    next();
    if (!is_double || sign(toi) > 0) check_pieces(x, kind, toi, is_double);
    check_contact(x, kind, toi, upper);
  }

  /// A list of pieces that cover [0, end], or [0, end) if `open`.
  void check_pieces(const Corners& x, const KindOf& kind, const Number& end, bool open) {
    Number from;
    for (;;) {
      const std::string where = lines_.where();
      if (words_.empty()) throw Rejected("the proof ends too early");
      Number to = end;
      bool last = true;
      const std::size_t size = words_.size();
      if (size > 2 && words_[size - 2] == "to") {
        to = number(words_[size - 1], where);
        last = false;
        words_.resize(size - 2);
        if (!(from < to) || !(to < end)) throw Rejected(where + "the piece ends outside the rest of the time");
      }
      check_piece(x, kind, direction(x, kind), from, to, open && last, where);
      from = to;
      next();
      if (last) return;
    }
  }

  Vector direction(const Corners& x, const KindOf& kind) const {
    if (words_ == std::vector<std::string>{"n"}) return normal(x, kind, lines_.where());
    const std::size_t coefficients = (words_.size() - 1) / 3;
    if (words_[0] != "d" || coefficients < 1 || coefficients > kMostDegree + 1 ||
        words_.size() != 1 + 3 * coefficients) {
      throw Rejected(lines_.where() + "here a piece must be: n, or d and three numbers for each coefficient");
    }
    Vector n;
    for (std::size_t i = 0; i < 3 * coefficients; ++i) n[i % 3].push_back(number(words_[1 + i], lines_.where()));
    return n;
  }

  /// At a time in [toi, upper], a weighted point of one element is one of the other.
  void check_contact(const Corners& x, const KindOf& kind, const Number& toi, const Number& upper) {
    const std::string start = lines_.where();
    Polynomial g;
    Number low = toi, high = upper;
    if (toi == upper) {
      g = {-toi, Number(1)};
    } else {
      if (words_.empty() || words_[0] != "root") throw Rejected(start + "here the polynomial of the time must be");
      const std::size_t size = words_.size();
      if (size > 4 && words_[size - 3] == "between") {
        low = number(words_[size - 2], start), high = number(words_[size - 1], start);
        words_.resize(size - 3);
      }
      if (low < toi || upper < high || !(low < high)) throw Rejected(start + "the bracket is outside the times");
      g = polynomial(words_, 1, start);
      if (g.size() < 2 || sign(g.back()) == 0) throw Rejected(start + "the leading coefficient must not be 0");
      if (sign(value(g, low)) * sign(value(g, high)) >= 0) throw Rejected(start + "no change of sign in the bracket");
      next();
    }
    std::vector<Polynomial> weights(kind.corners);
    while (!words_.empty() && words_[0] == "w") {
      const std::string where = lines_.where();
      if (words_.size() < 3) throw Rejected(where + "here a corner and the polynomial of its weight must be");
      const std::size_t corner = words_[1].size() == 1 ? static_cast<std::size_t>(words_[1][0] - '0') : kind.corners;
      if (corner >= kind.corners || !weights[corner].empty()) {
        throw Rejected(where + "no corner, or one that had a weight before");
      }
      weights[corner] = polynomial(words_, 2, where);
      next();
    }
    std::array<Polynomial, 2> sums;
    std::array<Vector, 2> points;
    for (std::size_t i = 0; i < kind.corners; ++i) {
      const std::size_t element = i < kind.first ? 0 : 1;
      if (sign_at_root(g, weights[i], low, high) < 0) throw Rejected(start + "a weight may be negative");
      sums[element] = sums[element] + weights[i];
      for (std::size_t k = 0; k < 3; ++k) points[element][k] = points[element][k] + weights[i] * x[i][k];
    }
    for (const Polynomial& sum : sums) {
      if (sign_at_root(g, sum, low, high) <= 0) throw Rejected(start + "the weights of an element may all be 0");
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (!divides(g, sums[1] * points[0][k] - sums[0] * points[1][k])) {
        throw Rejected(start + "the weighted points are not proved to be equal");
      }
    }
  }

  /// The sign of p at every root of g in [low, high]: 0 for a multiple of g, -1 also where it is not known.
  static int sign_at_root(const Polynomial& g, const Polynomial& p, const Number& low, const Number& high) {
    if (divides(g, p)) return 0;
    const Polynomial b = bernstein(on_piece(p, low, high));
    return std::all_of(b.begin(), b.end(), [](const Number& c) { return sign(c) > 0; }) ? 1 : -1;
  }

  Lines lines_;
  std::vector<std::string> files_, words_;
  unsigned long long queries_ = 0, contacts_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: touchstone-check PROOFS QUERY_FILE...\n");
    return 2;
  }
  try {
    Checker(argv[1], std::vector<std::string>(argv + 2, argv + argc)).run();
    return 0;
  } catch (const Rejected& reason) {
    std::fprintf(stderr, "rejected: %s\n", reason.what());
    return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "touchstone-check: %s\n", error.what());
    return 2;
  }
}
