// Proofs of the answers to some queries of one kind.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <touchstone/curved.hpp>
#include <touchstone/solve.hpp>

#include "io/queries/curved_rows.hpp"
#include "io/queries/query_writer.hpp"
#include "proofs/proof_text.hpp"

namespace touchstone::tests {

/// A file of queries, and the proofs of their answers.
struct Proved {
  Separation separation;
  std::string queries;
  std::vector<std::string> proofs;
  std::size_t contacts = 0;

  template <class Q>
  void add(const Q& query, const Answer& answer) {
    io::append_query(queries, query, answer.contact);
    std::string text;
    proofs::append_proof(text, proofs.size(), answer, proofs::prove(query, answer, separation));
    proofs.push_back(text);
    contacts += answer.contact ? 1 : 0;
  }
  template <class Q>
  void add(const Q& query) {
    add(query, solve(query, {.separation = separation}));
  }

  std::string text(Kind kind) const {
    std::string all = proofs::kFirstLine;
    proofs::append_separation(all, separation);
    all += "file " + std::string(name_of(kind)) + " - queries.csv\n";
    for (const std::string& proof : proofs) all += proof;
    return all + "end " + std::to_string(proofs.size()) + " " + std::to_string(contacts) + "\n";
  }
};

/// The answer with its times moved on to the next doubles in the direction of `towards`, or nothing where one does not
/// move.
inline std::optional<Answer> shifted(const Answer& answer, double towards) {
  Answer off = answer;
  off.toi = std::nextafter(answer.toi, towards);
  off.toi_upper = std::nextafter(answer.toi_upper, towards);
  if (off.toi == answer.toi || off.toi_upper == answer.toi_upper) return std::nullopt;
  return off;
}

}  // namespace touchstone::tests
