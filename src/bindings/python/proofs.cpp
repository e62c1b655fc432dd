// Proofs of answers, as the files that touchstone-check reads.
// SPDX-License-Identifier: MIT
#include <touchstone/curved.hpp>
#include <touchstone/solve.hpp>

#include <string>
#include <utility>
#include <vector>

#include "io/queries/curved_rows.hpp"
#include "io/queries/query_writer.hpp"
#include "io/sha256.hpp"
#include "proofs/proof_text.hpp"
#include "python/answers.hpp"
#include "python/arguments.hpp"
#include "python/curved/curved_queries.hpp"
#include "python/define.hpp"
#include "python/query_arrays.hpp"
#include "python/rows.hpp"

namespace touchstone::python {
namespace {

/// A query file, the proofs of its answers, and these.
struct ProvedFile {
  using BoundToPython = void;

  std::string queries, proofs;
  Answers answers{{}};
};

constexpr char kQueryFile[] = "queries.csv";

/// @param head      the first rows of the query file
/// @param query_at  (q) gives query q
template <class QueryAt>
ProvedFile prove_all(Kind kind, std::size_t count, std::string head, const Separation& separation, int threads,
                     const QueryAt& query_at) {
  constexpr std::size_t kAtATime = 16;
  solve(Query(), {.separation = separation});  // whether it has a meaning, also for no query
  if (count == 0) throw py::value_error("there is no query, so there is nothing to prove");
  std::string queries = std::move(head), proofs;
  std::vector<Answer> answers(count);
  std::size_t contacts = 0;
  in_chunks(count, kFirst, [&](std::size_t first, std::size_t last) {
    std::vector<std::string> rows(last - first), lines(last - first);
    const auto prove = [&](std::size_t q) {
      const auto query = query_at(q);
      answers[q] = solve(query, {.separation = separation});
      io::append_query(rows[q - first], query, answers[q].contact);
      proofs::append_proof_of(lines[q - first], q, query, answers[q], separation);
    };
    const auto work = [&] {
      threads::for_each_range(last - first, kAtATime, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t q = first + begin; q < first + end; ++q) prove(q);
      });
    };
    naming_the_row(first, last, work, [&](std::size_t q) { solve(query_at(q), {.separation = separation}); });
    for (const std::string& text : rows) queries += text;
    for (const std::string& text : lines) proofs += text;
    for (std::size_t q = first; q < last; ++q) contacts += answers[q].contact ? 1 : 0;
  });
  std::string text = proofs::kFirstLine;
  proofs::append_separation(text, separation);
  text.append("file ").append(name_of(kind)).append(" ").append(io::sha256(queries)).append(" ").append(kQueryFile);
  text += '\n' + proofs;
  text.append("end ").append(std::to_string(count)).append(" ").append(std::to_string(contacts)).append("\n");
  return {std::move(queries), std::move(text), Answers(std::move(answers))};
}

/// One separation: a file of proofs has no more.
Separation one_separation(py::handle distance, py::handle metric) {
  return separation_of(distance, metric, 0, true).separation;
}

ProvedFile prove_arrays(py::handle kind, py::handle start, py::handle end, py::handle distance, py::handle metric,
                        py::handle threads) {
  const QueryArrays queries(kind, start, end);
  return prove_all(queries.kind, queries.count(), {}, one_separation(distance, metric), threads_of(threads),
                   [&](std::size_t q) { return queries.at(q); });
}

ProvedFile prove_curved(const CurvedQueries& queries, py::handle distance, py::handle metric, py::handle threads) {
  return prove_all(queries.kind, queries.all.size(), std::string(io::kCurvedHeader) + "\n",
                   one_separation(distance, metric), threads_of(threads),
                   [&](std::size_t q) { return queries.all[q]; });
}

}  // namespace

void define_proofs(py::module_& module) {
  define_class<ProvedFile>(module, "ProvedFile", "The texts of a query file and of the proofs of its answers.")
      .def_property_readonly("queries", [](const ProvedFile& file) { return py::bytes(file.queries); })
      .def_property_readonly("proofs", [](const ProvedFile& file) { return py::bytes(file.proofs); })
      .def_readonly("answers", &ProvedFile::answers);
  module.def("prove", &prove_arrays);
  module.def("prove_curved", &prove_curved);
}

}  // namespace touchstone::python
