// An engine for the tests of `touchstone audit`: right, or wrong in one way.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdlib>

#include <touchstone/solve.hpp>

#include "engine.hpp"

namespace {

using engine::Answer;

touchstone::Query read(const engine::Query& q) {
  touchstone::Query query;
  query.kind = q.kind == "edge-edge" ? touchstone::Kind::edge_edge : touchstone::Kind::vertex_face;
  for (std::size_t i = 0; i < q.start.size(); ++i) {
    query.start[i] = {q.start[i][0], q.start[i][1], q.start[i][2]};
    query.end[i] = {q.end[i][0], q.end[i][1], q.end[i][2]};
  }
  return query;
}

Answer solved(const touchstone::Query& query) {
  const touchstone::Answer answer = touchstone::solve(query);
  return answer.contact ? engine::contact_at(answer.toi) : engine::no_contact();
}

Answer right(const engine::Query& q) { return solved(read(q)); }

/// The answer for a first element that is moved by 1e-6.
Answer moved(const engine::Query& q) {
  touchstone::Query query = read(q);
  for (std::size_t i = 0; i < q.first(); ++i) query.start[i].x += 1e-6, query.end[i].x += 1e-6;
  return solved(query);
}

/// Denies every contact late in the step.
Answer drops(const engine::Query& q) {
  const Answer answer = right(q);
  return answer.contact && *answer.time > 0.75 ? engine::no_contact() : answer;
}

Answer fails(const engine::Query& q) { return right(q).contact ? engine::failed() : engine::no_contact(); }

Answer crashes(const engine::Query& q) {
  if (right(q).contact) std::abort();
  return engine::no_contact();
}

const std::string kToy =
    "engine toy 1\n"
    "asks solve\n"
    "kinds edge-edge vertex-face\n";

}  // namespace

int main(int argc, char** argv) {
  const std::string straight = kToy + "motion straight\n";
  return engine::serve(argc, argv,
                       {{"right", straight, right},
                        {"moved", straight + "sizes 0.5 8\ntolerance-length 1e-5\n", moved},
                        {"strict", straight + "sizes 0.5 8\ntolerance-length 1e-9\n", moved},
                        {"drops", straight, drops},
                        {"casts", kToy + "motion cast\nnumbers float\nsizes 0.5 8\nelements 0.001\n", drops},
                        {"fails", straight, fails},
                        {"crashes", straight, crashes}});
}
