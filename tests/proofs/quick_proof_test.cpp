// Proofs found in doubles and in integers of fixed size.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <touchstone/solve.hpp>

#include "io/queries/query_writer.hpp"
#include "proofs/proof_text.hpp"
#include "proofs/quick_proof.hpp"
#include "proofs/run_checker.hpp"
#include "support/catch.hpp"
#include "support/query_families.hpp"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

/// What a quick proof is.
std::string sort_of(const proofs::Proof& proof, const Answer& answer, double distance) {
  const std::string apart = distance > 0 ? ", apart" : "";
  if (!answer.contact) {
    const bool normal = proof.pieces.front().normal;
    return (proof.pieces.size() > 1 ? "several pieces" : normal ? "normal" : "direction") + apart;
  }
  return (answer.toi_upper == 0 ? "start" : "later") + apart;
}

}  // namespace

TEST_CASE("quick proofs: each sort of them is found, and the checker accepts them", "[slow]") {
  constexpr std::uint64_t kSeed = 31;
  constexpr std::uint64_t kCount = 8;
  std::map<std::string, std::size_t> found;
  for (const Kind kind : kKinds) {
    for (const Separation& separation : {Separation{}, Separation{0.125, Metric::euclidean},
                                         Separation{0x1.3p-9, Metric::euclidean}, Separation{0.5, Metric::max}}) {
      std::string text = proofs::kFirstLine, queries;
      proofs::append_separation(text, separation);
      text += "file " + std::string(name_of(kind)) + " - queries.csv\n";
      std::uint64_t count = 0, contacts = 0;
      for (const FamilyInfo& family : all_families()) {
        for (std::uint64_t i = 0; i < kCount; ++i) {
          const Query query = make(CaseId{family.family, kind, kSeed, i});
          const Answer answer = solve(query, {.separation = separation});
          const auto proof = proofs::quick_proof(query, answer, separation);
          if (!proof) continue;
          ++found[sort_of(*proof, answer, separation.distance)];
          proofs::append_proof(text, count++, answer, *proof);
          contacts += answer.contact;
          io::append_query(queries, query, answer.contact);
        }
      }
      text += "end " + std::to_string(count) + " " + std::to_string(contacts) + "\n";
      const CheckerRun run = check_texts(text, {queries});
      INFO(name_of(kind) << ", " << separation.distance << ": " << run.text);
      CHECK(run.status == 0);
    }
  }
  for (const char* sort : {"normal", "direction", "several pieces", "start", "later", "direction, apart",
                           "several pieces, apart", "start, apart", "later, apart"}) {
    INFO(sort << ": " << found[sort]);
    CHECK(found[sort] >= 20);
  }
}

TEST_CASE("quick proofs: a false answer has none") {
  std::size_t tried = 0;
  for (const Kind kind : kKinds) {
    for (const Separation& separation :
         {Separation{}, Separation{0.125, Metric::euclidean}, Separation{0.5, Metric::max}}) {
      for (const FamilyInfo& family : all_families()) {
        for (std::uint64_t i = 0; i < 4; ++i) {
          const Query query = make(CaseId{family.family, kind, 32, i});
          const Answer answer = solve(query, {.separation = separation});
          INFO(family.name << ' ' << name_of(kind) << ' ' << i);
          std::vector<Answer> others(3, answer);
          others[0].contact = !answer.contact;
          if (!answer.contact) others[0].toi = others[0].toi_upper = 0;
          if (answer.contact) {  // one double earlier or later
            others[1].toi = std::nextafter(answer.toi, -1);
            others[1].toi_upper = answer.toi;
            others[2].toi = answer.toi_upper;
            others[2].toi_upper = std::nextafter(answer.toi_upper, 2);
          }
          for (const Answer& other : others) {
            const bool same =
                other.contact == answer.contact && other.toi == answer.toi && other.toi_upper == answer.toi_upper;
            if (same || other.toi < 0 || other.toi_upper > 1) continue;
            ++tried;
            CHECK_FALSE(proofs::quick_proof(query, other, separation));
          }
        }
      }
    }
  }
  CHECK(tried > 2000);
}
