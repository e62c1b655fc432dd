// Answers do not depend on the caller's floating-point environment, and solve leaves it unchanged.
// The build that defines TOUCHSTONE_FAST_MATH_CALLER stands for a caller with -ffast-math.
// SPDX-License-Identifier: MIT
#include <cstring>
#include <string>
#include <vector>

#include <touchstone/contact_times.hpp>
#include <touchstone/curved.hpp>
#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "environment/float_mode.hpp"
#include "support/answer_check.hpp"
#include "support/report.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 21;

// Everything the library says of one query, and whether it left the environment alone.
struct Outcome {
  std::array<Answer, 4> answers;
  bool any = false;
  std::vector<std::array<double, 4>> times;
  std::string times_text;
  int comparisons = 0;
  bool restored = true;
};

// No floating-point operation of its own, so that it may run in any mode.
Outcome ask(const Query& query, const ControlBits& expected) {
  Outcome outcome;
  outcome.answers[0] = solve(query, {.method = Method::fast});
  outcome.restored = outcome.restored && control_bits() == expected;
  outcome.any = solve(query, {.wanted = Wanted::contact}).contact;
  outcome.restored = outcome.restored && control_bits() == expected;
  outcome.answers[1] = solve(query, {.method = Method::exact});
  outcome.restored = outcome.restored && control_bits() == expected;
  outcome.answers[2] = solve(query, {.method = Method::oracle});
  outcome.restored = outcome.restored && control_bits() == expected;
  outcome.answers[3] = solve(query, {.method = Method::fast_cgal});
  outcome.restored = outcome.restored && control_bits() == expected;
  for (const ContactInterval& interval : contact_times(query)) {
    const ExactTime reversed = interval.first.reversed();
    outcome.times.push_back({interval.first.lower(), interval.first.upper(), reversed.lower(), reversed.upper()});
    outcome.times_text += interval.first.to_string() + interval.last.to_string();
    outcome.comparisons = 3 * outcome.comparisons + interval.first.compare(interval.last);
    outcome.comparisons = 3 * outcome.comparisons + interval.first.compare(0x1p-1060);
  }
  outcome.restored = outcome.restored && control_bits() == expected;
  return outcome;
}

// Compares bits alone; NaN and infinity mean nothing to a fast-math caller.
std::string outcome_difference(const Outcome& expected, const Outcome& found) {
  if (!found.restored) return "the environment is not restored";
  static constexpr std::array<const char*, 4> methods{"fast", "exact", "oracle", "fast-cgal"};
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const std::string wrong = bit_difference(expected.answers[i], found.answers[i], true);
    if (!wrong.empty()) return labelled(methods[i], wrong);
  }
  const bool same_times =
      expected.times.size() == found.times.size() &&
      (expected.times.empty() ||
       std::memcmp(expected.times.data(), found.times.data(), expected.times.size() * sizeof expected.times[0]) == 0);
  if (!same_times || expected.times_text != found.times_text) return "contact_times differ";
  if (expected.any != found.any) return "the contact alone differs";
  if (expected.comparisons != found.comparisons) return "comparisons of times differ";
  return "";
}

struct Asked {
  CaseId id;
  Query query;
};

// Made in the default environment: a fast-math program does not start in it.
std::vector<Asked> asked_queries(std::size_t count) {
  const WithFloatMode ordinary{FloatMode{}};
  std::vector<Asked> asked;
  for_each_case(
      kSeed, count, [](const FamilyInfo&, Kind) { return true; },
      [&](const CaseId& id) {
        asked.push_back({id, make(id)});
      });
  return asked;
}

std::vector<Outcome> outcomes_in(const FloatMode& mode, const std::vector<Asked>& asked) {
  std::vector<Outcome> outcomes;
  outcomes.reserve(asked.size());
  const WithFloatMode with(mode);
  const ControlBits bits = control_bits();
  for (const Asked& one : asked) outcomes.push_back(ask(one.query, bits));
  return outcomes;
}

std::uint64_t to_bits(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

TEST_CASE("a mode that is set is seen") {  // else the tests below would test nothing
  for (const FloatMode& mode : float_modes()) {
    if (mode.traps) continue;
    INFO(mode.name());
    volatile double one = 1, three = 3, tiny = 0x1p-1070;
    volatile double third = 0, minus_third = 0, twice_tiny = 0;
    {
      const WithFloatMode with(mode);
      third = one / three;
      minus_third = -one / three;
      twice_tiny = tiny + tiny;
      CHECK(control_bits().rounding == mode.rounding);
    }
    const std::uint64_t low = 0x3FD5555555555555u, high = low + 1, sign = std::uint64_t{1} << 63;
    CHECK(to_bits(third) == (mode.rounding == FE_UPWARD ? high : low));
    CHECK(to_bits(minus_third) == (sign | (mode.rounding == FE_DOWNWARD ? high : low)));
    if (kCanFlush) CHECK((to_bits(twice_tiny) == 0) == mode.flush);
  }
}

#if defined(TOUCHSTONE_FAST_MATH_CALLER)
TEST_CASE("a fast-math program starts with subnormals flushed") {
  CHECK((control_bits().control & kFlushBits) == kFlushBits);
}
#endif

TEST_CASE("answers are the same bit for bit in every floating-point mode, and the mode is restored") {
  const std::vector<Asked> asked = asked_queries(6);
  const std::vector<Outcome> expected = outcomes_in(FloatMode{}, asked);
  Report report;
  for (const FloatMode& mode : float_modes()) {
    const std::vector<Outcome> found = outcomes_in(mode, asked);
    for (std::size_t i = 0; i < asked.size(); ++i) {
      const std::string wrong = outcome_difference(expected[i], found[i]);
      report.add(asked[i].id, asked[i].query, labelled(mode.name(), wrong));
    }
  }
  report.finish();
}

// V underflows at a time that doubles cannot distinguish from the root. Its exact value there is the least
// double.
Query underflowing() {
  return VertexFace{
      {{{0x1.4d496fcc9504ap-1, 0x1.fffep-1, -0x1.a4d3f96365194p-2}, {-2, 0x1p-1074, -2}, {-1, 0, 3}, {4, 0, -1}}},
      {{{0x1.4d496fcc9504ap-1, -0x1p-16, -0x1.a4d3f96365194p-2}, {-2, 0, -2}, {-1, 0, 3}, {4, 0, -1}}}};
}

TEST_CASE("no value of the library traps, and the caller's raised flags stay raised") {
  const Query query = underflowing();
  const Outcome expected = outcomes_in(FloatMode{}, {{CaseId{}, query}}).front();
  CHECK(expected.answers[0].contact);
  for (const FloatMode& mode : float_modes()) {
    INFO(mode.name());
    const Outcome found = outcomes_in(mode, {{CaseId{}, query}}).front();
    CHECK(outcome_difference(expected, found) == "");
    int flags = 0;
    {
      const WithFloatMode with(mode);
      const bool is_ordinary = mode.rounding == FE_TONEAREST && !mode.flush && !mode.traps && mode.x87_bits == 64;
      if (is_ordinary && !mode.x87_traps) continue;  // nothing is put aside, and the library's own flags are added
#if TOUCHSTONE_X86
      _mm_setcsr(_mm_getcsr() | FE_DIVBYZERO);  // sets the flag without a trap
      static_cast<void>(ask(query, control_bits()));
      flags = static_cast<int>(_mm_getcsr() & 0x3Fu);
#else
      flags = FE_DIVBYZERO;
#endif
    }
    CHECK((flags & FE_ALL_EXCEPT) == FE_DIVBYZERO);
  }
}

TEST_CASE("answers are the same in the mode that the program starts with") {
  const std::vector<Asked> asked = asked_queries(20);
  const std::vector<Outcome> expected = outcomes_in(FloatMode{}, asked);
  Report report;
  const ControlBits bits = control_bits();
  for (std::size_t i = 0; i < asked.size(); ++i) {
    report.add(asked[i].id, asked[i].query, outcome_difference(expected[i], ask(asked[i].query, bits)));
  }
  report.finish();
}

TEST_CASE("batches are the same bit for bit in every floating-point mode, on one thread and on two") {
  const std::vector<Asked> asked = asked_queries(20);
  std::vector<Query> queries;
  for (const Asked& one : asked) queries.push_back(one.query);
  std::vector<Answer> expected;
  {
    const WithFloatMode ordinary{FloatMode{}};
    expected = solve_batch(queries);
  }
  Report report;
  for (const FloatMode& mode : float_modes()) {
    for (const int threads : {1, 2}) {
      BatchOptions options;
      options.threads = threads;
      std::vector<Answer> found;
      bool restored = false;
      {
        const WithFloatMode with(mode);
        const ControlBits bits = control_bits();
        found = solve_batch(queries, options);
        restored = control_bits() == bits;
      }
      CHECK(restored);
      for (std::size_t i = 0; i < asked.size(); ++i) {
        const std::string wrong = bit_difference(expected[i], found[i], true);
        report.add(asked[i].id, asked[i].query, labelled(mode.name() + (threads == 1 ? "" : ", 2 threads"), wrong));
      }
    }
  }
  report.finish();
}

template <typename Call>
bool refused(Call&& call) {
  try {
    call();
  } catch (const InvalidQuery&) {
    return true;
  }
  return false;
}

TEST_CASE("a batch keeps a subnormal separation in every floating-point mode") {
  Query straight;
  CurvedQuery curved;
  QueryColumns columns;
  std::array<std::array<double, 6>, 2> coordinates{};
  BatchOptions options;
  BatchOptions with_column;
  double distance = 0;
  double negative = 0;
  {
    const WithFloatMode ordinary{FloatMode{}};
    distance = 0x1p-1074;
    negative = -distance;
    straight.kind = curved.kind = columns.kind = Kind::point_point;
    straight.start[0] = {1, 0, 0};
    straight.end[0] = {distance, 0, 0};
    curved.corners[0] = CurvedCorner::on_curve({{1, 0, 0}, {0.5, 0, 0}, {distance, 0, 0}});
    curved.corners[1] = CurvedCorner::on_curve({{0, 0, 0}});
    coordinates[0] = {1, 0, 0, distance, 0, 0};
    columns.count = 1;
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        columns.start[i][k] = &coordinates[i][k];
        columns.end[i][k] = &coordinates[i][3 + k];
      }
    }
    options.separation.distance = distance;
    with_column.separations = &distance;
    with_column.separation_count = 1;
  }
  for (const FloatMode& mode : float_modes()) {
    INFO(mode.name());
    std::array<Answer, 4> answers{};
    int refusals = 0;
    {
      const WithFloatMode with(mode);
      solve_batch(&straight, 1, &answers[0], options);
      solve_batch(&curved, 1, &answers[1], options);
      solve_batch(columns, &answers[2], options);
      solve_batch(&straight, 1, &answers[3], with_column);
      BatchOptions below = options;
      below.separation.distance = negative;
      refusals += refused([&] { solve_batch(&straight, 1, &answers[0], below); });
      below = with_column;
      below.separations = &negative;
      refusals += refused([&] { solve_batch(&straight, 1, &answers[0], below); });
    }
    CHECK(refusals == 2);
    for (const Answer& answer : answers) {
      CHECK(answer.contact);
      CHECK(answer.toi == 1);
    }
  }
}

// A double from its bits: a fast-math compiler may take it that no NaN or infinity exists.
double from_bits(std::uint64_t bits) {
  double x = 0;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}
constexpr std::uint64_t kNan = 0x7FF8000000000000u;
constexpr std::uint64_t kInfinity = 0x7FF0000000000000u;

TEST_CASE("a query without meaning is refused in every mode, and the mode is restored") {
  const EdgeEdge good{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 1}, {0, -1, 1}}},
                      {{{0, 0, 0}, {1, 0, 0}, {0, 1, -1}, {0, -1, -1}}}};
  for (const FloatMode& mode : float_modes()) {
    for (const std::uint64_t bad : {kNan, kInfinity}) {
      Query query = good;
      query.end[3].y = from_bits(bad);
      const double bad_t_max = from_bits(bad);
      RationalQuery fractions;
      fractions.start[0][0] = Fraction{"1", "0"};
      int refusals = 0;
      bool restored = true;
      {
        const WithFloatMode with(mode);
        const ControlBits bits = control_bits();
        const auto count = [&](bool was_refused) {
          refusals += was_refused;
          restored = restored && control_bits() == bits;
        };
        for (const Method method : {Method::fast, Method::exact, Method::oracle, Method::fast_cgal}) {
          count(refused([&] { solve(query, {.method = method}); }));
          count(refused([&] { solve(Query(good), {.t_max = bad_t_max, .method = method}); }));
          count(refused([&] { solve(fractions, {.method = method}); }));
        }
        count(refused([&] { solve(query, {.wanted = Wanted::contact}); }));
        count(refused([&] { solve(Query(good), {.t_max = bad_t_max, .wanted = Wanted::contact}); }));
        count(refused([&] { contact_times(query); }));
        count(refused([&] { contact_times(Query(good), {}, bad_t_max); }));
        count(refused([&] { contact_times(fractions); }));
        for (const int threads : {1, 2}) {
          count(refused([&] { solve_batch({good, query}, BatchOptions{{}, threads}); }));
        }
      }
      INFO(mode.name());
      CHECK(refusals == 19);
      CHECK(restored);
    }
  }
}

}  // namespace
}  // namespace touchstone::tests
