// Reading for touchstone-check: lines, words, numbers, polynomials, query files, motion files and their pairs.
// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

namespace checker {

struct Rejected : std::runtime_error {  // exit status 1
  using std::runtime_error::runtime_error;
};
struct BadInput : std::runtime_error {  // exit status 2
  using std::runtime_error::runtime_error;
};

constexpr std::size_t kLongestLine = 1U << 20, kMostDigits = 4096, kMostCoefficients = 17;
constexpr long kMostExponent = 20000;
constexpr std::uint32_t kMostVertices = (1U << 30) - 1;

/// The beginning of a word, for a message. Bytes that a terminal may take for a command become question marks.
inline std::string quoted(std::string_view word) {
  std::string text = "\"";
  for (const char c : word.substr(0, 40)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > 40 ? "...\"" : "\"");
}

/// "1 step", "2 steps"
inline std::string counted(std::uint64_t number, const std::string& one, const std::string& several) {
  return std::to_string(number) + " " + (number == 1 ? one : several);
}

// ---- Lines and words ------------------------------------------------------------------------------------------------

using Words = std::vector<std::string_view>;

/// The lines of a file that are neither blank nor comments.
class Lines {
 public:
  explicit Lines(std::string name) : name_(std::move(name)), file_(name_, std::ios::binary), buffer_(kLongestLine + 2) {
    if (!file_) throw BadInput(name_ + ": cannot be opened for reading: " + std::strerror(errno));
  }
  /// Splits the next line into the words between spaces, or the columns between commas. They stay in place until the
  /// next call. @returns false at the end of the file, without words
  bool next(Words& words, char separator = ' ') {
    words.clear();
    std::string_view line;
    std::size_t first = std::string_view::npos;
    while (first == std::string_view::npos || line[first] == '#') {
      if (!next_of_all(line)) return false;
      first = line.find_first_not_of(" \t");
    }
    for (std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = std::min(line.find(separator, begin), line.size());
      if (separator != ' ' || end > begin) words.push_back(line.substr(begin, end - begin));
      begin = end + 1;
    }
    return true;
  }
  /// "FILE:LINE: ", of the line that was read last.
  std::string where() const { return name_ + ":" + std::to_string(number_) + ": "; }
  BadInput bad(const std::string& reason) const { return BadInput(where() + reason); }
  void require(bool good, const char* reason) const {
    if (!good) throw bad(reason);
  }

 private:
  bool next_of_all(std::string_view& line) {
    // The buffer holds the longest line, a carriage return, and the zero that getline puts at the end.
    file_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    if (file_.bad()) throw BadInput(name_ + ": cannot be read to its end: " + std::strerror(errno));
    auto length = static_cast<std::size_t>(file_.gcount());
    if (file_.eof() && length == 0) return false;
    ++number_;
    if (!file_.eof() && !file_.fail()) --length;  // the line feed counts
    line = {buffer_.data(), length};
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (number_ == 1 && line.substr(0, 3) == "\xEF\xBB\xBF") line.remove_prefix(3);  // a byte order mark
    require(line.size() <= kLongestLine && (file_.eof() || !file_.fail()),
            "the line is too long: at most 2^20 bytes are read");
    return true;
  }

  std::string name_;
  std::ifstream file_;
  std::vector<char> buffer_;
  std::uint64_t number_ = 0;
};

// ---- Numbers --------------------------------------------------------------------------------------------------------

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_hexadecimal(char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

/// Decimal digits after an optional minus sign. @returns false for any other text, or one of too many digits
inline bool read_integer(std::string_view text, mpz_class& value) {
  const bool negative = text.substr(0, 1) == "-";
  if (negative) text.remove_prefix(1);
  if (text.empty() || text.size() > kMostDigits) return false;
  value = 0;
  while (!text.empty()) {  // as many digits at once as an unsigned long has for sure
    const std::string_view digits = text.substr(0, std::numeric_limits<unsigned long>::digits10);
    unsigned long number = 0, unit = 1;
    for (const char c : digits) {
      if (!is_digit(c)) return false;
      number = 10 * number + static_cast<unsigned long>(c - '0');
      unit *= 10;
    }
    value *= unit;
    value += number;
    text.remove_prefix(digits.size());
  }
  if (negative) mpz_neg(value.get_mpz_t(), value.get_mpz_t());
  return true;
}
/// Digits without a sign or leading zeros. @returns false for any other text, or a number above `most`
inline bool read_count(std::string_view text, std::uint32_t most, std::uint32_t& value) {
  mpz_class number;
  if (!read_integer(text, number) || number > most || std::to_string(number.get_ui()) != text) return false;
  value = static_cast<std::uint32_t>(number.get_ui());
  return true;
}

/// m 2^e
struct Number {
  mpz_class m;
  long e = 0;
};
inline int sign(const Number& x) { return sgn(x.m); }
inline Number operator+(const Number& a, const Number& b) {
  const long low = std::min(a.e, b.e);
  return {(a.m << static_cast<unsigned long>(a.e - low)) + (b.m << static_cast<unsigned long>(b.e - low)), low};
}
/// The sign of a - b.
inline int compare(const Number& a, const Number& b) {
  static mpz_class x, y;  // they keep their memory
  const long low = std::min(a.e, b.e);
  x = a.m << static_cast<unsigned long>(a.e - low);
  y = b.m << static_cast<unsigned long>(b.e - low);
  return cmp(x, y);
}

/// Whether x is a double: m 2^e with 0 <= m < 2^53 and e >= -1074. The next double is x + 2^e, with the least such e
/// for which m >= 2^52, or e = -1074.
inline bool next_double(Number x, Number& next) {
  next = {1, -1074};
  if (sign(x) <= 0) return sign(x) == 0;
  const unsigned long zeros = mpz_scan1(x.m.get_mpz_t(), 0);
  x.m >>= zeros;
  x.e += static_cast<long>(zeros);
  const long shift = std::min(53 - static_cast<long>(mpz_sizeinbase(x.m.get_mpz_t(), 2)), x.e + 1074);
  if (shift < 0) return false;
  next = {(x.m << static_cast<unsigned long>(shift)) + 1, x.e - shift};
  return true;
}

/// "-12", or a C hexfloat with any number of digits: "0x1.8p-3".
inline void read_number(std::string_view word, Number& x, const Lines& lines) {
  const auto require = [&](bool is_number) {
    if (is_number) return;
    throw lines.bad(quoted(word) +
                    " is no number: an integer or a hexfloat such as 0x1.8p-3 was expected, of at most 4,096 digits");
  };
  const bool negative = word.substr(0, 1) == "-";
  const std::string_view text = word.substr(negative ? 1 : 0);
  x.e = 0;
  if (text.substr(0, 2) != "0x") return require(read_integer(word, x.m));
  const std::size_t p = text.find('p');
  require(p != std::string_view::npos);
  std::string_view power = text.substr(p + 1);
  if (power.substr(0, 1) == "+" && power.substr(1, 1) != "-") power.remove_prefix(1);
  static mpz_class exponent;
  require(read_integer(power, exponent));
  if (abs(exponent) > kMostExponent) {
    throw lines.bad(quoted(word) + " has an exponent beyond the limit, which is 20,000");
  }
  std::string digits(text.substr(2, p - 2));
  const std::size_t point = digits.find('.');
  if (point != std::string::npos) digits.erase(point, 1);
  require(!digits.empty() && digits.size() <= kMostDigits && std::all_of(digits.begin(), digits.end(), is_hexadecimal));
  x.m.set_str((negative ? "-" : "") + digits, 16);
  if (sign(x) == 0) return;
  x.e = exponent.get_si();
  if (point != std::string::npos) x.e -= 4 * static_cast<long>(digits.size() - point);
}

// ---- Polynomials: coefficient i belongs to t^i ----------------------------------------------------------------------

/// It keeps the memory of its coefficients when it is cleared.
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
                "a polynomial has too many coefficients: at most 17 are read");
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

// ---- Queries --------------------------------------------------------------------------------------------------------

struct Kind {
  std::string_view name;
  std::size_t corners, first;  ///< of both elements, of the first one
};
constexpr std::array<Kind, 4> kKinds = {Kind{"edge-edge", 4, 2}, Kind{"vertex-face", 4, 1}, Kind{"point-edge", 3, 1},
                                        Kind{"point-point", 2, 1}};

struct Fraction {
  mpz_class numerator, denominator = 1;
};
inline Fraction fraction_of(const Number& x) {
  Fraction fraction;
  fraction.numerator = x.m << static_cast<unsigned long>(std::max(x.e, 0L));
  fraction.denominator <<= static_cast<unsigned long>(std::max(-x.e, 0L));
  return fraction;
}
/// The corners of two elements: a row for each at the start of the step, then a row for each at the end.
struct Query {
  Kind kind;
  std::array<std::array<Fraction, 3>, 8> rows;
};

/// Reads a row of a CSV file: three fractions, and the answer that the file claims, which is not used here.
inline void read_row(const Lines& lines, Words& columns, std::array<Fraction, 3>& corner) {
  if (columns.size() != 7) throw lines.bad("a row has 7 columns, but here are " + std::to_string(columns.size()));
  for (std::string_view& column : columns) {
    column.remove_prefix(std::min(column.find_first_not_of(" \t"), column.size()));
    column.remove_suffix(column.size() - (column.find_last_not_of(" \t") + 1));
  }
  for (std::size_t i = 0; i < 6; ++i) {
    mpz_class& x = i % 2 == 0 ? corner[i / 2].numerator : corner[i / 2].denominator;
    if (!read_integer(columns[i], x)) {
      throw lines.bad("here must be a decimal integer of at most 4,096 digits: " + quoted(columns[i]));
    }
    if (i % 2 == 1 && sgn(x) <= 0) throw lines.bad("a denominator must be positive: " + quoted(columns[i]));
  }
  lines.require(columns[6] == "0" || columns[6] == "1", "the last column must be 0 or 1");
}
/// Reads the next query of a CSV file, whose kind is set. @returns false at the end of the file
inline bool read_query(Lines& lines, Query& query) {
  static Words columns;
  char truth = 0;
  for (std::size_t row = 0; row < 2 * query.kind.corners; ++row) {
    if (!lines.next(columns, ',')) {
      lines.require(row == 0, "the file ends within a query: a row for each corner and each end was expected");
      return false;
    }
    read_row(lines, columns, query.rows[row]);
    lines.require(row == 0 || columns[6][0] == truth, "the last column must be the same in all rows of a query");
    truth = columns[6][0];
  }
  return true;
}

// ---- Motion files ---------------------------------------------------------------------------------------------------

/// A point, an edge or a face, and its box during a step. Along each axis, the coordinates of all vertices at both ends
/// of the step are sorted. `low` is the place of the box's least coordinate, and `reach` the number of the coordinates
/// that are at most D above its greatest one. Boxes a and b are at most D apart if a.low < b.reach and b.low < a.reach.
struct Element {
  std::array<std::uint32_t, 3> vertices{}, low{}, reach{};
  std::size_t size = 0;
  std::size_t number = 0;  ///< among those of its sort
};

/// A mesh, and the two frames of a step.
class MotionFile {
 public:
  static constexpr std::array<std::string_view, 4> kSorts = {"point", "edge", "face", "fixed"};
  static constexpr std::array<std::size_t, 4> kSizes = {1, 2, 3, 1};

  explicit MotionFile(const std::string& name) : lines_(name) {
    lines_.next(words_);
    if (words_ != Words{"touchstone-motion", "1"}) throw expected("\"touchstone-motion 1\"");
    lines_.next(words_);
    if (words_.size() != 2 || words_[0] != "vertices" || !read_count(words_[1], kMostVertices, count_)) {
      throw expected("\"vertices N\" with N below 2^30");
    }
    while (lines_.next(words_) && words_[0] != "frame") read_element();
    if (!next_step()) throw expected("the line \"frame\" of frame 0");
    // There are as many lines as vertices, so memory for each vertex is in proportion to the file.
    is_fixed_.assign(count_, false);
    for (const Element& vertex : elements_[3]) is_fixed_[vertex.vertices[0]] = true;
    std::vector<bool> on_edge(count_, false);
    for (const Element& edge : elements_[1]) on_edge[edge.vertices[0]] = on_edge[edge.vertices[1]] = true;
    for (const Element& point : elements_[0]) {
      if (!on_edge[point.vertices[0]]) elements_[4].push_back(point);
    }
    if (!next_step()) throw expected("the line \"frame\" of frame 1: a motion has at least two frames");
  }

  static std::string name(const Element& element) {
    return std::string(kSorts[element.size - 1]) + " " + std::to_string(element.number);
  }

  /// Reads a frame, whose line "frame" is the current one, and the line after it. @returns false if there is none
  bool next_step() {
    frames_[0].swap(frames_[1]);
    frames_[1].clear();
    if (words_.empty()) return false;
    if (words_ != Words{"frame"}) throw expected("\"frame\" alone, or the end of the file");
    for (std::uint32_t v = 0; v < count_; ++v) {
      lines_.next(words_);
      if (words_.size() != 3) {
        throw expected("the three coordinates of vertex " + std::to_string(v) + " in frame " + std::to_string(frame_));
      }
      for (const std::string_view word : words_) {
        read_number(word, frames_[1].emplace_back(), lines_);
        if (frame_ > 0 && is_fixed_[v] && compare(frames_[0][frames_[1].size() - 1], frames_[1].back()) != 0) {
          throw lines_.bad("vertex " + std::to_string(v) + " is fixed, but has moved in frame " +
                           std::to_string(frame_) + ": the coordinates of the frame before were expected");
        }
      }
    }
    ++frame_;
    lines_.next(words_);
    return true;
  }

  /// Calls function(kind, first element, second element) for each pair of the step, in the order of the proofs.
  template <class Function>
  void for_each_pair(const Number& distance, const Function& function) {
    for (std::size_t k = 0; k < 3; ++k) set_boxes(k, distance);
    const auto& [points, edges, faces, fixed, lone] = elements_;
    for_each_of(kKinds[0], edges, edges, function);
    for_each_of(kKinds[1], points, faces, function);
    for_each_of(kKinds[2], lone, edges, function);
    for_each_of(kKinds[3], lone, lone, function);
  }

  /// Sets the query of a pair: the corners of the first element, then those of the second one.
  void set(Query& query, const Kind& kind, const Element& a, const Element& b) const {
    query.kind = kind;
    for (std::size_t row = 0; row < 2 * kind.corners; ++row) {
      const std::size_t i = row % kind.corners;
      const std::size_t vertex = i < a.size ? a.vertices[i] : b.vertices[i - a.size];
      for (std::size_t k = 0; k < 3; ++k) {
        query.rows[row][k] = fraction_of(frames_[row / kind.corners][3 * vertex + k]);
      }
    }
  }

 private:
  BadInput expected(const std::string& what) const { return lines_.bad("here must be " + what); }

  void read_element() {
    const auto sort = static_cast<std::size_t>(std::find(kSorts.begin(), kSorts.end(), words_[0]) - kSorts.begin());
    if (sort == kSorts.size() || words_.size() != kSizes[sort] + 1) {
      throw expected("\"point V\", \"edge V0 V1\", \"face V0 V1 V2\", \"fixed V\" or \"frame\"");
    }
    Element element;
    element.number = elements_[sort].size();
    for (; element.size < kSizes[sort]; ++element.size) {
      const std::string_view word = words_[element.size + 1];
      std::uint32_t v = 0;
      if (!read_count(word, kMostVertices, v) || v >= count_) {
        throw lines_.bad(quoted(word) + " is no vertex: a number below " + std::to_string(count_) +
                         " was expected, without a sign or leading zeros");
      }
      const auto end = element.vertices.begin() + static_cast<long>(element.size);
      lines_.require(std::find(element.vertices.begin(), end, v) == end,
                     "an element has different vertices, but this one has a vertex twice");
      element.vertices[element.size] = v;
    }
    lines_.require(element.size > 1 || single_[sort].insert(element.vertices[0]).second,
                   sort == 0 ? "the vertex is a point already: one line was expected"
                             : "the vertex is fixed already: one line was expected");
    elements_[sort].push_back(element);
  }

  /// Sets the boxes along one axis.
  void set_boxes(std::size_t k, const Number& distance) {
    const auto at = [&](std::size_t i) -> const Number& {  // of a vertex at the start, or at the end
      return frames_[i / count_][3 * (i % count_) + k];
    };
    std::vector<std::uint32_t> order(2 * std::size_t{count_}), place(order.size()), reach(order.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return compare(at(a), at(b)) < 0; });
    std::uint32_t end = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Number farthest = at(order[i]) + distance;
      while (end < order.size() && compare(at(order[end]), farthest) <= 0) ++end;
      place[order[i]] = static_cast<std::uint32_t>(i);
      reach[order[i]] = end;
    }
    for (std::vector<Element>& elements : elements_) {
      for (Element& element : elements) {
        element.low[k] = std::numeric_limits<std::uint32_t>::max();
        element.reach[k] = 0;
        for (std::size_t i = 0; i < 2 * element.size; ++i) {
          const std::size_t v = element.vertices[i / 2] + (i % 2) * std::size_t{count_};
          element.low[k] = std::min(element.low[k], place[v]);
          element.reach[k] = std::max(element.reach[k], reach[v]);
        }
      }
    }
  }

  /// It holds the partners of one element at a time, not all pairs.
  template <class Function>
  void for_each_of(const Kind& kind, const std::vector<Element>& first, const std::vector<Element>& second,
                   const Function& function) {
    // The boxes in the order of their low ends, along the axis on which they are narrowest.
    std::array<std::uint64_t, 3> width{};
    for (const Element& b : second) {
      for (std::size_t k = 0; k < 3; ++k) width[k] += b.reach[k] - b.low[k];
    }
    const auto axis = static_cast<std::size_t>(std::min_element(width.begin(), width.end()) - width.begin());
    std::vector<Element> row = second;
    std::sort(row.begin(), row.end(), [&](const Element& a, const Element& b) { return a.low[axis] < b.low[axis]; });
    std::vector<std::uint32_t> farthest;  // the greatest reach of a box and those before it
    for (const Element& b : row) farthest.push_back(std::max(b.reach[axis], farthest.empty() ? 0 : farthest.back()));
    std::vector<const Element*> partners;
    for (const Element& a : first) {
      partners.clear();
      // The boxes before this one end below a, and those behind the last one of the loop begin above it.
      const auto begin = std::upper_bound(farthest.begin(), farthest.end(), a.low[axis]) - farthest.begin();
      for (auto i = static_cast<std::size_t>(begin); i < row.size() && row[i].low[axis] < a.reach[axis]; ++i) {
        if (is_pair(a, row[i]) && (&first != &second || a.number < row[i].number)) partners.push_back(&row[i]);
      }
      std::sort(partners.begin(), partners.end(), [](const auto* x, const auto* y) { return x->number < y->number; });
      for (const Element* b : partners) function(kind, a, *b);
    }
  }

  bool is_pair(const Element& a, const Element& b) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (a.low[k] >= b.reach[k] || b.low[k] >= a.reach[k]) return false;
    }
    bool all_fixed = true;
    for (std::size_t i = 0; i < a.size; ++i) {
      for (std::size_t j = 0; j < b.size; ++j) {
        if (a.vertices[i] == b.vertices[j]) return false;
        all_fixed = all_fixed && is_fixed_[a.vertices[i]] && is_fixed_[b.vertices[j]];
      }
    }
    return !all_fixed;
  }

  Lines lines_;
  Words words_;
  std::uint32_t count_ = 0;
  std::size_t frame_ = 0;
  std::array<std::vector<Number>, 2> frames_;  ///< three coordinates for each vertex, at the start and at the end
  std::vector<bool> is_fixed_;                 ///< of each vertex
  /// Points, edges, faces, vertices that are fixed, and points that are corners of no edge.
  std::array<std::vector<Element>, 5> elements_;
  std::array<std::unordered_set<std::uint32_t>, 4> single_;  ///< the vertices that are points, and that are fixed
};

}  // namespace checker
