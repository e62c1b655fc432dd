// touchstone-check: checks proofs of collision answers. It believes nobody: it reads the queries and the proofs itself,
// and computes with integers only. docs/proofs.md defines the format, and says why a checked proof implies its answer.
//
//   g++ -O2 -std=c++17 -I. checker/checker.cpp -lgmpxx -lgmp -o touchstone-check      (in the folder src/proofs)
//
// The checks are signs and divisibility. So the coordinates of a query, the coefficients of a direction, and those of a
// polynomial are integers here: each group is multiplied by a positive number, which changes no sign.
// SPDX-License-Identifier: MIT
#include "checker/motion.hpp"

namespace checker {

enum class Metric { none, euclidean, max };
struct Separation {
  Metric metric = Metric::none;
  Number distance;
  std::string text;
};

class Checker {
 public:
  /// @param frames  the files of the frames of a motion; empty: they are not compared
  Checker(const std::string& proofs, std::vector<std::string> frames) : lines_(proofs), frames_(std::move(frames)) {}

  /// Whether proofs of which none is needed are accepted.
  enum class Empty : bool { refused, allowed };

  void run(const std::vector<std::string>& files, Empty empty) {
    next();
    if (words_ != Words{"touchstone-proofs", "1"}) throw lines_.bad("the first line must be \"touchstone-proofs 1\"");
    next();
    for (const std::string& file : files) check_file(file);
    if (words_ != Words{"end", std::to_string(queries_), std::to_string(contacts_)}) {
      throw expected("\"end\" and the numbers of queries and contacts, " + std::to_string(queries_) + " and " +
                     std::to_string(contacts_) + ", after the proofs of the last query file");
    }
    if (next()) throw expected("the end of the file, after the line \"end\"");
    if (!frames_.empty() && (motions_ != 1 || files.size() != 1))
      throw BadInput("--frames goes with one motion file and nothing else");
    if (queries_ == 0 && empty == Empty::refused) {
      throw Rejected("no query was checked: " + std::string(kNoneNear) +
                     "; --allow-empty accepts this, and the digest of each file must show that it is the right one");
    }
    const std::string answers =
        counted(contacts_, "contact", "contacts") + ", " + std::to_string(queries_ - contacts_) + " without contact";
    report_ += counted(queries_, "query", "queries") + " checked: " + (queries_ > 0 ? answers : kNoneNear) +
               (motions_ > 0 ? kStarts : "") + "\n";
    std::fwrite(report_.data(), 1, report_.size(), stdout);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) throw BadInput("standard output cannot be written");
  }

 private:
  static constexpr char kNoneNear[] = "no two elements that move against each other come near enough to need a proof";
  static constexpr char kStarts[] = "; whether a first frame intersects itself was not asked";

  bool next() { return lines_.next(words_); }
  Rejected rejected(const std::string& reason) const { return Rejected(lines_.where() + reason); }
  Rejected expected(const std::string& what) const { return rejected("here must be " + what); }
  void require(bool holds, const char* reason) const {
    if (!holds) throw rejected(reason);
  }

  void check_file(const std::string& name) {
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
    const unsigned long long before = queries_;
    next();
    std::string text;
    if (kind == kKinds.end()) {
      ++motions_;
      MotionFile motion(name);
      std::size_t steps = 0;
      check_bound(motion, name, digest, [&] { steps = check_motion(motion, name); });
      text = " in " + counted(steps, "step", "steps") + separation_.text + ": " + motion.contents();
      // Without a pair nothing is proved: the elements may be missing, or what the file says of them may leave none.
      if (queries_ == before && !motion.has_pair()) {
        throw BadInput(name + ": there is nothing to check: " + motion.contents() +
                       ", but no two elements that share no vertex and are neither all fixed nor all on one body; a "
                       "motion of at least two such elements was expected");
      }
      if (!frames_.empty()) text += ", whose frames are those of the " + counted(frames_.size(), "file", "files");
      if (queries_ == before) text += std::string("; ") + kNoneNear;
    } else {
      QueryFile queries(name);
      if (queries.is_curved()) text = " with curved motion";
      query_.kind = *kind;
      check_bound(queries, name, digest, [&] {
        for (std::uint64_t i = 0; queries.next(query_); ++i) {
          check_query(i, [&] { return name + ": query " + std::to_string(i); });
        }
      });
      if (queries_ == before) {
        throw BadInput(name + ": there is nothing to check: the file has no query, and at least one was expected");
      }
      text += separation_.text;
    }
    // The proofs say which kind the queries are, and which separation they have, so a person must see both.
    const std::string count = counted(queries_ - before, kind_name + " query", kind_name + " queries");
    report_ += printable(name) + ": " + count + text + "\n";
  }

  /// Checks the proofs about a file, and that it is the file that they name. They may not name one.
  /// @param check  checks the proofs
  template <class File, class Check>
  void check_bound(File& file, const std::string& name, const std::string& digest, const Check& check) {
    const auto differs = [&] { return digest != "-" && file.digest() != digest; };
    const std::string another = name + ": the proofs are about another file: they name the digest " + digest;
    try {
      check();
    } catch (const Rejected&) {
      if (differs()) throw Rejected(another);  // which is the reason
      throw;
    }
    if (differs()) throw Rejected(another);
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

  /// Compares a frame with its file, if there are some.
  void compare_frame(const MotionFile& motion, std::size_t end) const {
    if (frames_.empty()) return;
    const std::size_t frame = motion.frame_count() - 2 + end;
    if (frame >= frames_.size()) throw Rejected("the motion has more frames than --frames names files");
    motion.compare_frame(frames_[frame], end);
  }

  /// @returns the number of steps
  std::size_t check_motion(MotionFile& motion, const std::string& name) {
    std::size_t step = 0;
    compare_frame(motion, 0);
    do {
      compare_frame(motion, 1);
      const std::string step_name = "step " + std::to_string(step);
      if (words_ != Words{"step", std::to_string(step)}) throw expected("\"" + step_name + "\" of " + name);
      next();
      std::uint64_t number = 0;
      bool touches_only = false;
      const Separation of_file = separation_;
      motion.for_each_pair(of_file.distance, [&](const Kind& kind, const Element& a, const Element& b) {
        motion.set(query_, kind, a, b);
        if (kind.touches_only != touches_only) {
          touches_only = kind.touches_only;
          separation_ = touches_only ? Separation() : of_file;
        }
        check_query(number, [&] {
          return name + ": " + step_name + ": pair " + std::to_string(number) + " (" + MotionFile::name(a) + " and " +
                 MotionFile::name(b) + ")";
        });
        ++number;
      });
      separation_ = of_file;
      require(words_.empty() || !is_digit(words_[0][0]),
              "a proof too many: the step has no more pairs whose boxes are at most the separation apart");
      ++step;
    } while (motion.next_step());
    require(frames_.empty() || frames_.size() == motion.frame_count(),
            "--frames names more files than the motion has frames");
    return step;
  }

  template <class Name>
  void check_query(std::uint64_t number, const Name& name) {
    ++queries_;
    try {
      check_proof(number);
    } catch (const Rejected& reason) {
      throw Rejected(name() + ": " + reason.what());
    }
  }

  void check_proof(std::uint64_t number) {
    const bool is_none = words_.size() == 2 && words_[1] == "none";
    if ((!is_none && (words_.size() != 4 || words_[1] != "contact")) || words_[0] != std::to_string(number)) {
      throw expected("\"" + std::to_string(number) + " none\" or \"" + std::to_string(number) + " contact T U\"");
    }
    corners_.set(query_, separation_.distance);
    if (is_none) {
      next();
      toi_ = {1, 0};
      return check_pieces(false);
    }
    ++contacts_;
    read_time(words_[2], toi_, lines_);
    read_time(words_[3], upper_, lines_);
    const bool is_double = compare(toi_, upper_) == 0;
    const bool are_neighbours = next_double(toi_, neighbour_) && (is_double || compare(upper_, neighbour_) == 0);
    require(are_neighbours && compare(upper_, {1, 0}) <= 0,
            "the times must be one double, or two neighbouring ones, in [0, 1]");
    next();
    if (!is_double || sign(toi_) > 0) check_pieces(is_double);
    check_meeting(is_double);
  }

  /// A list of pieces that cover [0, toi_]; if `open`, the elements may meet at the end.
  void check_pieces(bool open) {
    from_ = {0, 0};
    for (bool last = false; !last; next()) {
      last = words_.size() < 3 || words_[words_.size() - 2] != "to";
      to_ = toi_;
      if (!last) {
        read_time(words_.back(), to_, lines_);
        words_.resize(words_.size() - 2);
        require(compare(from_, to_) < 0 && compare(to_, toi_) < 0,
                "the number after \"to\" must be between the start of its piece and the end of the last one");
      }
      check_piece(open && last);
      std::swap(from_, to_);
    }
  }

  /// One piece: the elements are on different sides of a plane from from_ to to_, or before to_ if `open`.
  void check_piece(bool open) {
    const bool is_normal = words_.size() == 1 && words_[0] == "n" && query_.kind.corners == 4;
    is_normal ? set_normal() : read_direction();
    interval_.set(from_, to_);
    int side = 0;
    for (std::size_t i = 0; i < query_.kind.first; ++i) {
      for (std::size_t j = query_.kind.first; j < query_.kind.corners; ++j) {
        corners_.set_difference_of(r_, j, i);
        set_dot(product_, n_, r_);
        if (!is_separated(i, j, open, side)) {
          throw rejected("corner " + std::to_string(i) + " and corner " + std::to_string(j) +
                         " are not proved to be on different sides of the plane, with the separation between them");
        }
        // n is perpendicular to the edges of both elements: its products with all x_j - x_i have one sign at each time.
        if (is_normal) return;
      }
    }
  }

  /// n = u x w
  void set_normal() {
    const bool is_edge = query_.kind.first == 2;
    corners_.set_difference_of(u_, is_edge ? 1 : 2, is_edge ? 0 : 1);
    corners_.set_difference_of(w_, 3, is_edge ? 2 : 1);
    for (std::size_t k = 0; k < 3; ++k) {
      set_product(product_, u_[(k + 1) % 3], w_[(k + 2) % 3]);
      set_product(square_, u_[(k + 2) % 3], w_[(k + 1) % 3]);
      set_difference(n_[k], product_, square_);
    }
  }
  void read_direction() {
    const std::size_t size = words_.empty() ? 0 : (words_.size() - 1) / 3;
    require(size >= 1 && words_[0] == "d" && words_.size() == 1 + 3 * size,
            "here must be a piece: \"n\" for four corners, or \"d\" and three numbers for each coefficient");
    for (std::size_t k = 0; k < 3; ++k) read_coefficients(words_, 1 + k, 3, numbers_[k], lines_);
    set_polynomials(n_, numbers_);
  }

  /// Whether product_, of two corners, has the sign `side` during the piece, which is set if it is 0. With a separation
  /// the polynomials of docs/proofs.md that take its place are checked, and its sign at the start.
  bool is_separated(std::size_t i, std::size_t j, bool open, int& side) {
    const std::size_t zeros_from = open ? 1 : kNoZeros;
    set_bernstein(bernstein_, product_, interval_);
    if (side == 0) side = sgn(bernstein_[0]);
    if (side == 0 || sgn(bernstein_[0]) != side) return false;
    if (separation_.metric == Metric::none) return have_sign(bernstein_, side, zeros_from);
    // The separation, times what x_j - x_i is multiplied by.
    bound_.clear();
    add(bound_, corners_.w[i], corners_.separation);
    if (corners_.motion[i] != corners_.motion[j]) {
      set_product(square_, bound_, corners_.w[j]);
      std::swap(bound_, square_);
    }
    if (separation_.metric == Metric::euclidean) {
      set_dot(sum_, n_, n_);
      set_product(square_, bound_, bound_);
      set_product(bound_, square_, sum_);
      set_product(square_, product_, product_);
      add(square_, bound_, -1);
      return has_sign(square_, 1, zeros_from);
    }
    for (unsigned signs = 0; signs < 8; ++signs) {
      square_.clear();
      for (unsigned k = 0; k < 3; ++k) add(square_, n_[k], (signs >> k) % 2 == 0 ? -1 : 1);
      set_product(sum_, bound_, square_);
      add(sum_, product_, 1);
      if (!has_sign(sum_, side, zeros_from)) return false;
    }
    return true;
  }
  bool has_sign(const Polynomial& p, int sign, std::size_t zeros_from) {
    set_bernstein(bernstein_, p, interval_);
    return have_sign(bernstein_, sign, zeros_from);
  }

  /// At a time between toi_ and upper_, a weighted point of one element is within the separation of one of the other.
  void check_meeting(bool is_double) {
    if (is_double) {
      interval_.set(toi_, toi_);
      numbers_[0] = {Number{-toi_.m, toi_.e}, Number{1, 0}};
      set_polynomials(root_, numbers_);
    } else {
      read_root();
    }
    remove_factor(root_[0]);
    read_weights();
    for (std::size_t e = 0; e < 2; ++e) {
      sums_[e].clear();
      for (Polynomial& p : points_[e]) p.clear();
    }
    for (std::size_t i = 0; i < query_.kind.corners; ++i) {
      const Polynomial& weight = weights_[i];
      if (weight.size() == 0) continue;
      if (!has_sign(weight, 1, kNoZeros) && !divides(root_[0], weight)) {
        throw rejected("before this line: the weight of corner " + std::to_string(i) + " may be negative");
      }
      const std::size_t e = i < query_.kind.first ? 0 : 1;
      add_product(sums_[e], weight, corners_.w[i]);
      for (std::size_t k = 0; k < 3; ++k) add_product(points_[e][k], weight, corners_.x[i][k]);
    }
    for (const Polynomial& sum : sums_) {
      require(has_sign(sum, 1, kNoZeros), "before this line: the weights of an element may all be zero");
    }
    for (std::size_t k = 0; k < 3; ++k) {
      set_product(product_, sums_[1], points_[0][k]);
      set_product(square_, sums_[0], points_[1][k]);
      set_difference(r_[k], product_, square_);
    }
    require(is_near(), separation_.metric == Metric::none
                           ? "before this line: the weighted points are not proved to be equal"
                           : "before this line: the weighted points are not proved to be within the separation");
  }

  void read_root() {
    require(words_.size() >= 2 && words_[0] == "root", "here must be \"root\" and the coefficients of a polynomial");
    Number low = toi_, high = upper_;
    const std::size_t size = words_.size();
    if (size > 4 && words_[size - 3] == "between") {
      read_time(words_[size - 2], low, lines_);
      read_time(words_[size - 1], high, lines_);
      words_.resize(size - 3);
    }
    require(compare(low, toi_) >= 0 && compare(low, high) < 0 && compare(high, upper_) <= 0,
            "the numbers after \"between\" must be T <= LOW < HIGH <= U");
    read_coefficients(words_, 1, 1, numbers_[0], lines_);
    set_polynomials(root_, numbers_);
    const Polynomial& g = root_[0];
    require(g.size() >= 2 && g[g.size() - 1] != 0,
            "the polynomial must have a degree of at least 1 and a leading coefficient that is not zero");
    interval_.set(low, high);
    set_bernstein(bernstein_, g, interval_);  // the first and the last one have the signs of the values at LOW and HIGH
    require(sgn(bernstein_[0]) * sgn(bernstein_[g.size() - 1]) < 0,
            "the polynomial must change its sign between LOW and HIGH");
    next();
  }

  void read_weights() {
    for (std::vector<Number>& numbers : numbers_) numbers.clear();
    for (; !words_.empty() && words_[0] == "w"; next()) {
      std::uint32_t i = 0;
      require(words_.size() >= 3 && read_count(words_[1], query_.kind.corners - 1, i) && numbers_[i].empty(),
              "here must be \"w\", a corner that has no weight yet, and the coefficients of a polynomial");
      read_coefficients(words_, 2, 1, numbers_[i], lines_);
    }
    set_polynomials(weights_, numbers_);
  }

  /// Whether r_, the difference of the weighted points times A B, is at most D A B long at the root.
  bool is_near() {
    if (separation_.metric == Metric::none) {
      return divides(root_[0], r_[0]) && divides(root_[0], r_[1]) && divides(root_[0], r_[2]);
    }
    set_product(product_, sums_[0], sums_[1]);
    if (separation_.metric == Metric::euclidean) {
      set_product(square_, product_, product_);
      set_dot(sum_, r_, r_);
      add(sum_, square_, -(corners_.separation * corners_.separation));
      return has_sign(sum_, -1, 0) || divides(root_[0], sum_);
    }
    for (const Polynomial& c : r_) {
      for (const int s : {1, -1}) {
        sum_.clear();
        add(sum_, product_, corners_.separation);
        add(sum_, c, s);
        if (!has_sign(sum_, 1, 0) && !divides(root_[0], sum_)) return false;
      }
    }
    return true;
  }

  Lines lines_;
  Words words_;
  unsigned long long queries_ = 0, contacts_ = 0, motions_ = 0;
  std::vector<std::string> frames_;
  std::string report_;  ///< of files that hold; printed when all do
  Separation separation_;

  // Of the query. The numbers keep their memory from one query to the next.
  Query query_;
  Number toi_, upper_, neighbour_, from_, to_;
  Corners corners_;
  Interval interval_;
  std::array<std::vector<Number>, 4> numbers_;
  std::array<Polynomial, 4> weights_;
  Vector u_, w_, r_, n_;
  Polynomial product_, square_, sum_, bound_, bernstein_;
  std::array<Polynomial, 1> root_;
  std::array<Polynomial, 2> sums_;
  std::array<Vector, 2> points_;
};

}  // namespace checker

namespace {

constexpr char kUsage[] =
    "usage: touchstone-check [OPTION]... PROOFS FILE...\n"
    "Checks the proofs of `touchstone prove` against their query files or motion files, in their order. Each file\n"
    "must have the digest that the proofs name.\n"
    "  --allow-empty      accept a motion whose elements never come near enough to need a proof\n"
    "  --frames PATTERN   the frames of the motion must be these files, OBJ or binary PLY, bit by bit, and all of "
    "their\n"
    "                     triangles, lines and points its elements; in quotes, such as 'cloth-*.obj'\n"
    "Exit status: 0 every proof holds, 1 some proof does not, is about other files, or none was needed, 2 bad usage, "
    "a\n"
    "file that cannot be read, or nothing to check: no query, or a motion in which no two elements could meet.\n";

}  // namespace

int main(int argc, char** argv) {
  using checker::Checker;
  std::vector<std::string> words(argv + 1, argv + argc), frames;
  const bool help = !words.empty() && (words[0] == "--help" || words[0] == "-h");
  auto empty = Checker::Empty::refused;
  try {
    while (!help && !words.empty() && (words[0] == "--allow-empty" || words[0] == "--frames")) {
      const std::size_t taken = words[0] == "--frames" ? 2 : 1;
      if (taken == 1) empty = Checker::Empty::allowed;
      if (taken == 2 && words.size() > 1) frames = checker::files_of(words[1]);
      words.erase(words.begin(), words.begin() + static_cast<long>(std::min(taken, words.size())));
    }
    if (help || words.size() < 2) {
      std::fputs(kUsage, help ? stdout : stderr);
      return help ? 0 : 2;
    }
    Checker(words[0], frames).run({words.begin() + 1, words.end()}, empty);
    return 0;
  } catch (const checker::Rejected& reason) {
    std::fprintf(stderr, "rejected: %s\n", checker::printable(reason.what()).c_str());
    return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "touchstone-check: %s\n", checker::printable(error.what()).c_str());
    return 2;
  }
}
