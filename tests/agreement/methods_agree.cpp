// The cascade, the exact level and the oracle against each other, in every part of the answer.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdio>

#include <touchstone/solve.hpp>

#include "support/answer_check.hpp"
#include "support/report.hpp"

namespace touchstone::tests {
namespace {

constexpr std::uint64_t kSeed = 1;

std::string against(const char* names, const Answer& one, const Answer& other, const std::string& difference) {
  if (difference.empty()) return "";
  return std::string(names) + ": " + difference + "\n    " + describe(one) + "\n    " + describe(other);
}

std::string fast_against_exact(const Answer& fast, const Answer& exact) {
  std::string found = against("fast and exact", fast, exact, decision_difference(fast, exact));
  if (!found.empty()) return found;
  return against("fast and exact", fast, exact, weight_difference(fast, exact));
}

// Empty when the three methods agree and their answers are well formed.
std::string disagreement(const Query& query, double t_max, Answer& fast) {
  fast = solve(query, {.t_max = t_max, .method = Method::fast});
  const Answer exact = solve(query, {.t_max = t_max, .method = Method::exact});
  const Answer oracle = solve(query, {.t_max = t_max, .method = Method::oracle});
  if (exact.level != Level::exact) return "Method::exact does not answer by Level::exact";
  if (oracle.level != Level::oracle) return "Method::oracle does not answer by Level::oracle";
  if (fast.level == Level::oracle) return "Method::fast answers by Level::oracle";
  std::string found = fast_against_exact(fast, exact);
  if (found.empty() && solve(query, {.t_max = t_max, .wanted = Wanted::contact}).contact != exact.contact)
    found = "the contact alone and exact: contact differs";
  if (found.empty()) found = against("exact and oracle", exact, oracle, decision_difference(exact, oracle));
  if (found.empty()) found = against("exact and oracle", exact, oracle, weight_difference(exact, oracle));
  if (found.empty()) found = malformation(query.kind, fast, t_max);
  if (found.empty()) found = malformation(query.kind, oracle, t_max);
  if (found.empty() || t_max == 1) return found;
  return "t_max = " + hexfloat(t_max) + ": " + found;
}

// An end of the time range that matters to this answer.
double interesting_t_max(const Answer& whole, Rng& rng) {
  const double at = whole.contact ? whole.toi : 0.5;
  switch (rng.between(0, 5)) {
    case 0: return 0;
    case 1: return at;
    case 2: return whole.contact ? whole.toi_upper : 0x1p-1074;
    case 3: return at > 0 ? std::nextafter(at, 0.0) : 0x1p-1074;
    case 4: return at < 1 ? std::nextafter(at, 1.0) : 1;
    default: return rng.unit();
  }
}

// Every case with t_max = 1, and every fourth again with a t_max of its own.
void methods_agree(Kind kind, Group group, std::size_t count) {
  Report report;
  std::size_t queries = 0;
  const auto wanted = [&](const FamilyInfo& family, Kind k) { return family.group == group && k == kind; };
  for_each_case(kSeed, count, wanted, [&](const CaseId& id) {
    Rng rng = rng_of(id);
    const Sample sample = make_sample(id.family, kind, rng);
    Answer answer;
    std::string wrong = disagreement(sample.query, 1, answer);
    if (wrong.empty() && sample.touches_at && !(answer.contact && answer.toi <= *sample.touches_at)) {
      wrong = "misses the contact that is there by construction at " + hexfloat(*sample.touches_at);
    }
    ++queries;
    if (wrong.empty() && id.index % 4 == 0) {
      Answer cut;
      wrong = disagreement(sample.query, interesting_t_max(answer, rng), cut);
      ++queries;
    }
    report.add(id, sample.query, wrong);
  });
  std::printf("seed %llu, %s: %zu queries by fast, exact and oracle\n", static_cast<unsigned long long>(kSeed),
              name_of(kind).data(), queries);
  report.finish();
}

// The cheap pair on many more queries, where the levels before the exact one have work to do.
void fast_and_exact_agree(Kind kind, std::size_t count) {
  Report report;
  std::size_t before_exact = 0;
  const auto wanted = [&](const FamilyInfo& family, Kind k) {
    const bool scaled = family.group == Group::scale && family.family != Family::uniform_scale;
    return k == kind && family.group != Group::coplanar && !scaled;
  };
  for_each_case(kSeed + 1, count, wanted, [&](const CaseId& id) {
    const Query query = make(id);
    const Answer fast = solve(query, {.method = Method::fast});
    before_exact += fast.level != Level::exact;
    const Answer exact = solve(query, {.method = Method::exact});
    std::string wrong = fast_against_exact(fast, exact);
    if (wrong.empty() && solve(query, {.wanted = Wanted::contact}).contact != exact.contact)
      wrong = "the contact alone and exact: contact differs";
    report.add(id, query, wrong);
  });
  std::printf("seed %llu, %s: %zu queries by fast and exact, %zu of them decided before the exact level\n",
              static_cast<unsigned long long>(kSeed + 1), name_of(kind).data(), report.checked(), before_exact);
  report.finish();
}

TEST_CASE("methods agree: fast and exact on many edge-edge") { fast_and_exact_agree(Kind::edge_edge, 20000); }
TEST_CASE("methods agree: fast and exact on many vertex-face") { fast_and_exact_agree(Kind::vertex_face, 20000); }
TEST_CASE("methods agree: fast and exact on many point-edge") { fast_and_exact_agree(Kind::point_edge, 10000); }
TEST_CASE("methods agree: fast and exact on many point-point") { fast_and_exact_agree(Kind::point_point, 10000); }

TEST_CASE("methods agree: lattice edge-edge") { methods_agree(Kind::edge_edge, Group::lattice, 6000); }
TEST_CASE("methods agree: coplanar edge-edge", "[slow]") { methods_agree(Kind::edge_edge, Group::coplanar, 6000); }
TEST_CASE("methods agree: contact edge-edge") { methods_agree(Kind::edge_edge, Group::contact, 6000); }
TEST_CASE("methods agree: perturbed edge-edge") { methods_agree(Kind::edge_edge, Group::perturbed, 6000); }
TEST_CASE("methods agree: scale edge-edge") { methods_agree(Kind::edge_edge, Group::scale, 2000); }

TEST_CASE("methods agree: lattice vertex-face") { methods_agree(Kind::vertex_face, Group::lattice, 6000); }
TEST_CASE("methods agree: coplanar vertex-face", "[slow]") { methods_agree(Kind::vertex_face, Group::coplanar, 6000); }
TEST_CASE("methods agree: contact vertex-face") { methods_agree(Kind::vertex_face, Group::contact, 6000); }
TEST_CASE("methods agree: perturbed vertex-face") { methods_agree(Kind::vertex_face, Group::perturbed, 6000); }
TEST_CASE("methods agree: scale vertex-face") { methods_agree(Kind::vertex_face, Group::scale, 2000); }

TEST_CASE("methods agree: lattice point-edge") { methods_agree(Kind::point_edge, Group::lattice, 6000); }
TEST_CASE("methods agree: coplanar point-edge") { methods_agree(Kind::point_edge, Group::coplanar, 6000); }
TEST_CASE("methods agree: contact point-edge") { methods_agree(Kind::point_edge, Group::contact, 6000); }
TEST_CASE("methods agree: perturbed point-edge") { methods_agree(Kind::point_edge, Group::perturbed, 6000); }
TEST_CASE("methods agree: scale point-edge") { methods_agree(Kind::point_edge, Group::scale, 2000); }

TEST_CASE("methods agree: lattice point-point") { methods_agree(Kind::point_point, Group::lattice, 6000); }
TEST_CASE("methods agree: coplanar point-point") { methods_agree(Kind::point_point, Group::coplanar, 6000); }
TEST_CASE("methods agree: contact point-point") { methods_agree(Kind::point_point, Group::contact, 6000); }
TEST_CASE("methods agree: perturbed point-point") { methods_agree(Kind::point_point, Group::perturbed, 6000); }
TEST_CASE("methods agree: scale point-point") { methods_agree(Kind::point_point, Group::scale, 2000); }

}  // namespace
}  // namespace touchstone::tests
