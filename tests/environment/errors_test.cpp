// Queries without meaning are refused. The message is one line that names the fault and its place.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <touchstone/contact_times.hpp>
#include <touchstone/error.hpp>
#include <touchstone/solve.hpp>

#include "support/answer_check.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"

namespace touchstone::tests {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array<Method, 4> kMethods{Method::fast, Method::exact, Method::oracle, Method::fast_cgal};

// The message of the InvalidQuery that the call throws; empty when it throws none.
template <typename Call>
std::string refusal(Call&& call) {
  try {
    call();
  } catch (const InvalidQuery& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// One line that holds every part.
void check_message(const std::string& message, const std::vector<std::string>& parts) {
  INFO("message: \"" << message << "\"");
  CHECK_FALSE(message.empty());
  CHECK_FALSE(contains(message, "\n"));
  for (const std::string& part : parts) {
    INFO("must say: \"" << part << "\"");
    CHECK(contains(message, part));
  }
}

TEST_CASE("every coordinate that is not finite is refused by name") {
  for (const Kind kind : kKinds) {
    const Query good = make(CaseId{Family::lattice4, kind, 22, 0});
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
      const std::string value = std::isnan(bad) ? "nan" : bad > 0 ? "inf" : "-inf";
      for (const int end : {0, 1}) {
        for (std::size_t corner = 0; corner < corner_count(kind); ++corner) {
          for (std::size_t axis = 0; axis < 3; ++axis) {
            Query query = good;
            coordinate((end == 0 ? query.start : query.end)[corner], axis) = bad;
            const std::string where = std::string(name_of(kind)) + " query: corner " +
                                      std::string(corner_name(kind, corner)) + " at t = " + std::to_string(end) +
                                      " has " + "xyz"[axis] + " = " + value;
            for (const Method method : kMethods)
              check_message(refusal([&] { solve(query, {.method = method}); }), {where});
            check_message(refusal([&] { solve(query); }), {where});
            check_message(refusal([&] { solve(query, {.wanted = Wanted::contact}); }), {where});
            check_message(refusal([&] { contact_times(query); }), {where});
            check_message(refusal([&] { solve_batch({good, query, good}); }), {"query 1", where});
          }
        }
      }
    }
  }
}

TEST_CASE("the typed overloads refuse by name too") {
  EdgeEdge edges{};
  edges.end[3].y = kNan;
  check_message(refusal([&] { solve(edges); }), {"edge-edge query: corner b1 at t = 1 has y = nan"});
  VertexFace face{};
  face.start[2].z = kInfinity;
  check_message(refusal([&] { solve(face); }), {"vertex-face query: corner f1 at t = 0 has z = inf"});
  PointEdge point_edge{};
  point_edge.start[0].x = -kInfinity;
  check_message(refusal([&] { solve(point_edge); }), {"point-edge query: corner p at t = 0 has x = -inf"});
  PointPoint points{};
  points.end[1].x = kNan;
  check_message(refusal([&] { solve(points); }), {"point-point query: corner q at t = 1 has x = nan"});
}

TEST_CASE("a t_max outside [0, 1] is refused") {
  for (const Kind kind : kKinds) {
    const Query query = make(CaseId{Family::lattice4, kind, 22, 0});
    for (const double t_max : {kNan, kInfinity, -kInfinity, -1.0, -0x1p-1074, std::nextafter(1.0, 2.0), 2.0}) {
      for (const Method method : kMethods)
        check_message(refusal([&] { solve(query, {.t_max = t_max, .method = method}); }), {"t_max"});
      check_message(refusal([&] { solve(query, t_max); }), {"t_max"});
      check_message(refusal([&] { solve(query, {.t_max = t_max, .wanted = Wanted::contact}); }), {"t_max"});
      check_message(refusal([&] { contact_times(query, {}, t_max); }), {"t_max"});
      check_message(refusal([&] { solve(RationalQuery{}, {.t_max = t_max, .method = Method::fast}); }), {"t_max"});
      check_message(refusal([&] { contact_times(RationalQuery{}, {}, t_max); }), {"t_max"});
      for (const int threads : {1, 2}) {
        const BatchOptions options{{.t_max = t_max}, threads};
        check_message(refusal([&] { solve_batch({query}, options); }), {"t_max"});
        check_message(refusal([&] { solve_batch(std::vector<Query>{}, options); }), {"t_max"});
      }
    }
  }
}

TEST_CASE("a t_max of -0.0 is 0") {
  for (const FamilyInfo& family : all_families()) {
    for (const Kind kind : kKinds) {
      const Query query = make(CaseId{family.family, kind, 22, 1});
      for (const Method method : kMethods) {
        const Answer minus = solve(query, {.t_max = -0.0, .method = method});
        CHECK(bit_difference(solve(query, {.t_max = 0.0, .method = method}), minus, true) == "");
        if (minus.contact) CHECK_FALSE(std::signbit(minus.toi));
      }
      CHECK(contact_times(query, {}, -0.0).size() == contact_times(query, {}, 0.0).size());
    }
  }
}

TEST_CASE("a kind that is none of the four is refused by its number") {
  const std::string says = "the kind is 77; it must be one of 0 to 3";
  Query query;
  query.kind = Kind(77);
  RationalQuery fractions;
  fractions.kind = Kind(77);
  for (const Method method : kMethods) {
    check_message(refusal([&] { solve(query, {.method = method}); }), {says});
    check_message(refusal([&] { solve(fractions, {.method = method}); }), {says});
  }
  check_message(refusal([&] { solve(query); }), {says});
  check_message(refusal([&] { solve(query, 0.5); }), {says});
  check_message(refusal([&] { solve(query, {.wanted = Wanted::contact}); }), {says});
  check_message(refusal([&] { contact_times(query); }), {says});
  check_message(refusal([&] { contact_times(fractions); }), {says});
  check_message(refusal([&] { solve_batch({Query(), query}); }), {"query 1", says});
  Answer answer;
  check_message(refusal([&] { solve_batch(&query, 1, &answer); }), {"query 0", says});
  QueryColumns columns;  // of no queries, and of the wrong kind all the same
  columns.kind = Kind(77);
  check_message(refusal([&] { solve_batch(columns); }), {says});
  check_message(refusal([&] { solve_batch(columns, &answer); }), {says});
  query.kind = Kind(4);
  check_message(refusal([&] { solve(query); }), {"the kind is 4;"});
  CHECK(name_of(Kind(77)).empty());
  CHECK(corner_name(Kind(77), 0).empty());
  CHECK(name_of(Feature(77)).empty());
}

TEST_CASE("a method that is none of the four is refused by its number") {
  const std::string says = "the method is 9; it must be one of 0 to 3";
  const Method method = Method(9);
  check_message(refusal([&] { solve(Query(), {.method = method}); }), {says});
  check_message(refusal([&] { solve(RationalQuery(), {.method = method}); }), {says});
  BatchOptions options;
  options.method = method;
  check_message(refusal([&] { solve_batch({Query()}, options); }), {says});
  check_message(refusal([&] { solve_batch(std::vector<Query>{}, options); }), {says});
  check_message(refusal([&] { solve_batch(QueryColumns(), options); }), {says});
  check_message(refusal([&] { solve(Query(), {.method = Method(4)}); }), {"the method is 4;"});
}

TEST_CASE("a SIMD width that is none of the five is refused by its number") {
  const std::string says = "the SIMD width is 77; it must be one of 0 to 4";
  CHECK_FALSE(has_vectors(VectorWidth(77)));
  BatchOptions options;
  options.vectors = VectorWidth(77);
  check_message(refusal([&] { solve_batch({Query()}, options); }), {says});
  check_message(refusal([&] { solve_batch(QueryColumns(), options); }), {says});
  options.vectors = VectorWidth(5);
  check_message(refusal([&] { solve_batch(QueryColumns(), options); }), {"the SIMD width is 5;"});
}

TEST_CASE("a batch names the first query that is wrong") {
  std::vector<Query> queries(2000, make(CaseId{Family::lattice4, Kind::vertex_face, 22, 0}));
  queries[1234].start[3].x = kNan;
  queries[1999].start[0].x = kNan;
  for (const int threads : {1, 2, 0}) {
    const BatchOptions options{{}, threads};
    const std::vector<std::string> parts{"query 1234", "vertex-face query: corner f2 at t = 0 has x = nan"};
    check_message(refusal([&] { solve_batch(queries, options); }), parts);
    std::vector<Answer> answers(queries.size());
    check_message(refusal([&] { solve_batch(queries.data(), queries.size(), answers.data(), options); }), parts);
  }
}

TEST_CASE("a number of threads that has no meaning is refused") {
  for (const int threads : {-1, -100, 1025, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
    const BatchOptions options{{}, threads};
    check_message(refusal([&] { solve_batch(std::vector<Query>(3), options); }), {"threads", std::to_string(threads)});
  }
}

TEST_CASE("a fraction that is not two decimal integers is refused by name") {
  static const std::vector<Fraction> bad{{"", "1"},    {"-", "1"},        {"1.5", "1"},
                                         {"0x1", "1"}, {"+1", "1"},       {" 1", "1"},
                                         {"1 ", "1"},  {"1e3", "1"},      {"--1", "1"},
                                         {"nan", "1"}, {"inf", "1"},      {"1/2", "1"},
                                         {"1,5", "1"}, {"1", ""},         {"1", "-"},
                                         {"1", "2.0"}, {"1", "0"},        {"1", "-0"},
                                         {"1", "000"}, {"0", "0"},        {"1", "0x2"},
                                         {"1", " 2"},  {"1", "+2"},       {"1\n", "1"},
                                         {"1", "1_0"}, {"\xD9\xA1", "1"}, {std::string("1\0", 2), "1"}};
  for (const Kind kind : kKinds) {
    for (const Fraction& fraction : bad) {
      for (const int end : {0, 1}) {
        const std::size_t corner = corner_count(kind) - 1;
        RationalQuery query;
        query.kind = kind;
        (end == 0 ? query.start : query.end)[corner][1] = fraction;
        INFO("\"" << fraction.numerator << "\" / \"" << fraction.denominator << "\"");
        const std::string where = std::string(name_of(kind)) + " query: corner " +
                                  std::string(corner_name(kind, corner)) + " at t = " + std::to_string(end) + " has y";
        for (const Method method : kMethods) CHECK(contains(refusal([&] { solve(query, {.method = method}); }), where));
        CHECK(contains(refusal([&] { contact_times(query); }), where));
      }
    }
  }
}

TEST_CASE("signs, leading zeros and any number of digits are good in a fraction") {
  const std::string million(1000, '9');
  for (const Fraction& fraction : {Fraction{"-0", "1"}, Fraction{"007", "-3"}, Fraction{"-5", "-0010"},
                                   Fraction{million, "1"}, Fraction{"1", million}}) {
    RationalQuery query;
    query.kind = Kind::point_point;
    query.start[0][0] = query.end[1][0] = fraction;  // both points at this fraction or at 0, at either end
    for (const Method method : kMethods) {
      const Answer answer = solve(query, {.method = method});
      CHECK(answer.contact);
      const bool zero = fraction.numerator == "-0";
      CHECK(answer.toi == (zero ? 0 : 0.5));  // p goes from x to 0 and q from 0 to x
      CHECK(answer.nature == (zero ? Nature::sustained : Nature::isolated));
    }
    CHECK(contact_times(query).size() == 1);
  }
}

TEST_CASE("corners that a kind does not have may hold anything in rational queries too") {
  RationalQuery query;
  query.kind = Kind::point_point;
  query.start[2][0] = query.end[3][2] = Fraction{"no number", "0"};
  for (const Method method : kMethods) CHECK(solve(query, {.method = method}).contact);
}

}  // namespace
}  // namespace touchstone::tests
