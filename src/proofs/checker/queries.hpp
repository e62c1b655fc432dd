// Files of queries with straight motion for touchstone-check, and the proofs of several files. A reader who has no
// other files may stop here: what comes after it is called for curved motion, and for motions of meshes.
// SPDX-License-Identifier: MIT
#pragma once

#include "checker/proofs.hpp"

namespace checker {

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
/// Makes the unit a multiple of the denominators. It stays the least one.
template <class Fractions>
void enlarge(mpz_class& unit, const Fractions& fractions) {
  for (const Fraction& c : fractions) {
    if (!mpz_divisible_p(unit.get_mpz_t(), c.denominator.get_mpz_t())) unit = lcm(unit, c.denominator);
  }
}
/// c times a multiple of its denominator.
inline mpz_class scaled(const Fraction& c, const mpz_class& unit) {
  mpz_class x;
  mpz_divexact(x.get_mpz_t(), unit.get_mpz_t(), c.denominator.get_mpz_t());
  return x * c.numerator;
}

struct Separation {
  Metric metric = Metric::none;
  Number distance;
  std::string text;  ///< for a person
};

/// A file of queries.
class QueryFile {
 public:
  explicit QueryFile(const std::string& name) : lines(name) {
    next_row();
    is_curved = !columns.empty() && columns[0] == "touchstone-curved";
    if (!is_curved) return;
    require(columns.size() == 2 && columns[1] == "1", "the version of a file of curved queries must be 1");
    next_row();
  }
  void require(bool good, const char* reason) const { lines.require(good, reason); }
  void next_row() {
    lines.next(columns, ",");
    for (std::string_view& column : columns) {
      column.remove_prefix(std::min(column.find_first_not_of(" \t"), column.size()));
      column.remove_suffix(column.size() - (column.find_last_not_of(" \t") + 1));
    }
    require(!is_curved || columns.empty() || lines.has_end(), "the line's end is missing: the file may be cut off");
  }

  /// Sets corners, whose kind is set, to those of the next query with straight motion: a row for each corner at the
  /// start of the step, then a row for each at the end. There is a query.
  void read(Corners& corners, const Separation& separation) {
    static std::array<std::array<Point, 4>, 2> points;  // at both ends; they keep their memory
    static std::string truth;
    const Fraction distance = fraction_of(separation.distance);
    mpz_class unit = distance.denominator;
    for (std::size_t row = 0; row < 2 * corners.kind.corners; ++row) {
      require(!columns.empty(), "the file ends within a query: a row for each corner and each end was expected");
      Point& point = points[row / corners.kind.corners][row % corners.kind.corners];
      read_row(point);
      enlarge(unit, point);
      const std::string_view column = columns.size() == 7 ? columns[6] : std::string_view();
      if (row == 0) truth = column;
      require(column == truth, "the last column must be the same in all rows of a query");
      next_row();
    }
    corners.metric = separation.metric;
    corners.separation = scaled(distance, unit);
    for (std::size_t i = 0; i < corners.kind.corners; ++i) {
      corners.motion[i] = 0;
      corners.w[i].assign(1, 1);
      for (std::size_t k = 0; k < 3; ++k) {
        Polynomial& x = corners.x[i][k];
        x.resize(2);
        x[0] = scaled(points[0][i][k], unit);
        x[1] = scaled(points[1][i][k], unit) - x[0];
      }
    }
  }

  Lines lines;
  Words columns;  ///< of the current row; none at the end of the file
  bool is_curved = false;

 private:
  /// Three fractions, and the answer that the file claims if it does, which is not used here.
  void read_row(Point& point) {
    if (columns.size() != 6 && columns.size() != 7) {
      throw lines.bad("a row has 6 or 7 columns, but here are " + std::to_string(columns.size()));
    }
    for (std::size_t i = 0; i < 6; ++i) {
      mpz_class& x = i % 2 == 0 ? point[i / 2].numerator : point[i / 2].denominator;
      if (!read_integer(columns[i], x)) {
        throw lines.bad("here must be a decimal integer of at most 4,096 digits: " + quoted(columns[i]));
      }
      if (i % 2 == 1 && sgn(x) <= 0) throw lines.bad("a denominator must be positive: " + quoted(columns[i]));
    }
    require(columns.size() == 6 || columns[6] == "0" || columns[6] == "1", "the last column must be 0 or 1");
  }
};

/// Checks a file of proofs against the files that it is about.
class Checker : protected Proofs {
 public:
  using Proofs::Proofs;
  virtual ~Checker() = default;

  /// @returns what was proved, for a person, without the last line's end
  std::string run(const std::vector<std::string>& files, bool may_be_empty) {
    next();
    if (words_ != Words{"touchstone-proofs", "1"}) throw lines_.bad("the first line must be \"touchstone-proofs 1\"");
    next();
    std::string report;
    for (const std::string& file : files) {
      report += printable(file) + ": " + check_file(file);
      report += has_digest_ ? "\n" : "; the proofs name no digest of the file\n";
    }
    if (words_ != Words{"end", std::to_string(queries_), std::to_string(contacts_)}) {
      throw expected("\"end\" and the numbers of queries and contacts, " + std::to_string(queries_) + " and " +
                     std::to_string(contacts_) + ", after the proofs of the last query file");
    }
    if (next()) throw expected("the end of the file, after the line \"end\"");
    if (queries_ == 0 && !may_be_empty) {
      throw Rejected("no query was checked: " + std::string(kNoneNear) +
                     "; --allow-empty accepts this, and the digest of each file must show that it is the right one");
    }
    const std::string answers =
        counted(contacts_, "contact", "contacts") + ", " + std::to_string(queries_ - contacts_) + " without contact";
    return report + counted(queries_, "query", "queries") + " checked: " + (queries_ > 0 ? answers : kNoneNear);
  }

 protected:
  static constexpr char kNoneNear[] = "no two elements that are asked about come near enough to need a proof";

  /// Sets corners_, whose kind is set, to those of the next query of a file with curved motion. There is a query.
  virtual void read_curved(QueryFile& queries) = 0;
  /// Checks the proofs about a motion file, whose digest they name. @returns what is proved, for a person
  virtual std::string check_motion(const std::string& name, const std::string& digest) = 0;

  template <class Name>
  void check_query(std::uint64_t number, const Name& name) {
    ++queries_;
    try {
      check_proof(number);
    } catch (const Rejected& reason) {
      throw Rejected(name() + ": " + reason.what());
    }
  }

  /// Checks proofs by `check`, and that the lines are those of the file whose digest they name. They may not name one.
  template <class Check>
  void check_bound(Lines& lines, const std::string& name, const std::string& digest, const Check& check) {
    has_digest_ = digest != "-";
    const auto differs = [&] { return has_digest_ && lines.digest() != digest; };
    const std::string another = name + ": the proofs are about another file: they name the digest " + digest;
    try {
      check();
    } catch (const Rejected&) {
      if (differs()) throw Rejected(another);  // which is the reason
      throw;
    }
    if (differs()) throw Rejected(another);
  }

  Separation separation_;  ///< of the current file
  unsigned long long queries_ = 0;

 private:
  bool has_digest_ = false;  ///< of the current file

  /// @returns what is proved: the kind of the queries and their separation too, because the proofs say which they are
  std::string check_file(const std::string& name) {
    read_separation();
    const std::string digest(words_.size() < 4 ? "" : words_[2]);
    const bool is_sha256 = digest.size() == 64 && digest.find_first_not_of("0123456789abcdef") == digest.npos;
    if ((!is_sha256 && digest != "-") || words_[0] != "file") {
      throw expected("\"file KIND DIGEST NAME\": the proofs for " + name);
    }
    const std::string kind_name(words_[1]);
    const auto kind = std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& k) { return k.name == kind_name; });
    require(kind != kKinds.end() || kind_name == "mesh",
            "the second word is no kind: edge-edge, vertex-face, point-edge, point-point or mesh was expected");
    next();
    if (kind == kKinds.end()) return check_motion(name, digest);
    QueryFile queries(name);
    std::uint64_t count = 0;
    check_bound(queries.lines, name, digest, [&] {
      for (; !queries.columns.empty(); ++count) {
        corners_.kind = *kind;
        queries.is_curved ? read_curved(queries) : queries.read(corners_, separation_);
        check_query(count, [&] { return name + ": query " + std::to_string(count); });
      }
    });
    if (count == 0) {
      throw BadInput(name + ": there is nothing to check: the file has no query, and at least one was expected");
    }
    return counted(count, kind_name + " query", kind_name + " queries") +
           (queries.is_curved ? " with curved motion" : "") + separation_.text;
  }

  /// The separation of the next file, which is zero without a line of its own.
  void read_separation() {
    separation_ = Separation();
    if (words_.empty() || words_[0] != "separation") return;
    require(words_.size() == 3 && (words_[1] == "euclidean" || words_[1] == "max"),
            "here must be \"separation euclidean D\" or \"separation max D\"");
    separation_.metric = words_[1] == "max" ? Metric::max : Metric::euclidean;
    read_number(words_[2], separation_.distance, lines_);
    require(sign(separation_.distance) > 0, "the separation must be above zero");
    separation_.text = " with separation " + std::string(words_[1]) + " " + std::string(words_[2]);
    next();
  }
};

}  // namespace checker
