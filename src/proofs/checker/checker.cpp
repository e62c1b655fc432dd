// touchstone-check: checks proofs of collision answers. It believes nobody: it reads the queries and the proofs itself,
// and computes with integers only. docs/proofs.md defines the format, and says why a checked proof implies its answer.
//
//   g++ -O2 -std=c++17 -I. checker/checker.cpp -lgmpxx -lgmp -o touchstone-check      (in the folder src/proofs)
//
// The checks are signs and divisibility. So the coordinates of a query, the coefficients of a direction, and those of a
// polynomial are integers here: each group is multiplied by a positive number, which changes no sign. For queries with
// straight motion, read input.hpp, polynomials.hpp, proofs.hpp and queries.hpp, in this order.
// SPDX-License-Identifier: MIT
#include "checker/frame_files.hpp"
#include "checker/pairs.hpp"

namespace checker {

class FullChecker : public Checker {
 public:
  /// @param frames  the files of the frames of a motion; empty: they are not compared
  FullChecker(const std::string& proofs, FrameFiles frames) : Checker(proofs), frames_(std::move(frames)) {}

  std::string run_all(const std::vector<std::string>& files, bool may_be_empty) {
    const std::string report = run(files, may_be_empty);
    if (!frames_.empty() && (motions_ != 1 || files.size() != 1))
      throw BadInput("--frames goes with one motion file and nothing else");
    const char* const left_out = "; not asked: whether a first frame intersects itself, and what lines above leave out";
    return report + (motions_ > 0 ? left_out : "") + "\n";
  }

 private:
  void read_curved(QueryFile& queries) override {
    query_.kind = corners_.kind;
    CurvedRows(queries).read(query_);
    set_corners(corners_, query_, separation_);
  }

  std::string check_motion(const std::string& name, const std::string& digest) override {
    ++motions_;
    const unsigned long long before = queries_;
    MotionPairs motion(name);
    require(!motion.has_radii() || separation_.metric == Metric::none,
            "before this line: a motion with radii has the separations of its own, but here is another one");
    if (motion.has_radii()) separation_.text = " with separation euclidean, the sum of two radii";
    std::size_t steps = 0;
    check_bound(motion.lines(), name, digest, [&] { steps = check_steps(motion, name); });
    const unsigned long long count = queries_ - before;
    // Without a pair nothing is proved: the elements may be missing, or what the file says of them may leave none.
    if (count == 0 && !motion.has_pair()) {
      throw BadInput(
          name + ": there is nothing to check: " + motion.contents() +
          ", but no two elements that share no vertex, whose groups are not ignored, and that are neither all fixed "
          "nor all on one body; a motion of at least two such elements was expected");
    }
    std::string text = counted(count, "mesh query", "mesh queries") + " in " + counted(steps, "step", "steps") +
                       separation_.text + ": " + motion.contents();
    text += frames_.summary();
    if (count == 0) text += std::string("; ") + kNoneNear;
    return text;
  }

  /// @returns the number of steps
  std::size_t check_steps(MotionPairs& motion, const std::string& name) {
    std::size_t step = 0;
    frames_.check_frame(motion, 0);
    do {
      frames_.check_frame(motion, 1);
      const std::string step_name = "step " + std::to_string(step);
      if (words_ != Words{"step", std::to_string(step)}) throw expected("\"" + step_name + "\" of " + name);
      next();
      std::uint64_t number = 0;
      motion.for_each_pair(separation_,
                           [&](const Kind& kind, const Element& a, const Element& b, const auto& separation) {
                             motion.set(query_, kind, a, b);
                             set_corners(corners_, query_, separation);
                             check_query(number, [&] {
                               return name + ": " + step_name + ": pair " + std::to_string(number) + " (" +
                                      MotionFile::name(a) + " and " + MotionFile::name(b) + ")";
                             });
                             ++number;
                           });
      require(words_.empty() || !is_digit(words_[0][0]),
              "a proof too many: the step has no more pairs whose boxes are at most the separation apart");
      ++step;
    } while (motion.next_step());
    frames_.check_count(motion.frame_count());
    return step;
  }

  FrameFiles frames_;
  unsigned long long motions_ = 0;
  Query query_;
};

}  // namespace checker

namespace {

constexpr char kUsage[] =
    "usage: touchstone-check [OPTION]... PROOFS FILE...\n"
    "Checks the proofs of `touchstone prove` against their query files or motion files, in their order. Each file\n"
    "must have the digest that the proofs name.\n"
    "  --allow-empty      accept a motion whose elements never come near enough to need a proof\n"
    "  --frames PATTERN   the frames of the motion must be these files, OBJ or binary PLY, bit by bit, and "
    "its\n"
    "                     elements their triangles, lines and points; in quotes, such as 'cloth-*.obj'. Once for each\n"
    "                     part of a scene, in the order of the parts; one file is a part at rest then\n"
    "Exit status: 0 every proof holds, 1 some proof does not, is about other files, or none was needed, 2 bad usage, "
    "a\n"
    "file that cannot be read, or nothing to check: no query, or a motion in which no two elements could meet.\n";

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  checker::FrameFiles frames;
  const bool help = !words.empty() && (words[0] == "--help" || words[0] == "-h");
  bool may_be_empty = false;
  try {
    while (!help && !words.empty() && (words[0] == "--allow-empty" || words[0] == "--frames")) {
      const std::size_t taken = words[0] == "--frames" ? 2 : 1;
      if (taken == 1) may_be_empty = true;
      if (taken == 2 && words.size() > 1) frames.add(words[1]);
      words.erase(words.begin(), words.begin() + static_cast<long>(std::min(taken, words.size())));
    }
    if (help || words.size() < 2) {
      if (!help) {
        std::fprintf(stderr, "touchstone-check: %s\n",
                     words.empty() ? "the file of proofs is missing, and behind it the files that they are about"
                                   : "behind the proofs, the query files or the motion file that they are about are "
                                     "missing");
      }
      std::fputs(kUsage, help ? stdout : stderr);
      return help ? 0 : 2;
    }
    // It is printed when every file holds.
    const std::string report =
        checker::FullChecker(words[0], frames).run_all({words.begin() + 1, words.end()}, may_be_empty);
    std::fwrite(report.data(), 1, report.size(), stdout);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      throw checker::BadInput("standard output cannot be written");
    return 0;
  } catch (const checker::Rejected& reason) {
    std::fprintf(stderr, "rejected: %s\n", checker::printable(reason.what()).c_str());
    return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "touchstone-check: %s\n", checker::printable(error.what()).c_str());
    return 2;
  }
}
