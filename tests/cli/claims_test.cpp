// touchstone certify --claims: the spellings of claims that solvers write, and what is not read of them.
// SPDX-License-Identifier: MIT
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "cli/run_program.hpp"
#include "support/catch.hpp"

using namespace touchstone::tests;

namespace {

/// Two points that meet at t = 1/2, two that never do, and two that meet at t = 1/4.
const std::string kQueries =
    "0,1,0,1,0,1\n1,1,0,1,0,1\n1,1,0,1,0,1\n0,1,0,1,0,1\n"
    "0,1,0,1,0,1\n1,1,0,1,0,1\n0,1,1,1,0,1\n1,1,0,1,0,1\n"
    "0,1,0,1,0,1\n1,1,0,1,0,1\n1,1,0,1,0,1\n-2,1,0,1,0,1\n";

struct Judging {
  TemporaryFolder folder;
  std::string queries = folder.write("point-point/q.csv", kQueries);

  Run run(const std::string& name, const std::string& claims, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"certify", "--claims", folder.write(name, claims)};
    words.insert(words.end(), more.begin(), more.end());
    words.push_back(queries);
    return run_program(words);
  }
};

std::string bytes_of(std::uint64_t value, std::size_t count) {
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i, value >>= 8) bytes += static_cast<char>(value & 0xFF);
  return bytes;
}

/// A file as numpy.save writes it.
std::string npy(const std::string& type, const std::string& shape, const std::string& values) {
  std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }\n";
  return "\x93NUMPY" + bytes_of(1, 2) + bytes_of(header.size(), 2) + header + values;
}

std::string doubles(const std::vector<double>& values) {
  std::string bytes;
  for (const double value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  return bytes;
}

/// A file as numpy.savez writes it, with an extra field in each local header.
std::string npz(const std::vector<std::pair<std::string, std::string>>& members, std::uint64_t method = 0) {
  std::string all, directory;
  for (const auto& [name, content] : members) {
    const std::string sizes = bytes_of(content.size(), 4) + bytes_of(content.size(), 4) + bytes_of(name.size(), 2);
    directory += "PK\x01\x02" + bytes_of(0, 6) + bytes_of(method, 2) + bytes_of(0, 8) + sizes + bytes_of(0, 12) +
                 bytes_of(all.size(), 4) + name;
    all += "PK\x03\x04" + bytes_of(0, 4) + bytes_of(method, 2) + bytes_of(0, 8) + sizes + bytes_of(4, 2) + name +
           "wide" + content;
  }
  return all + directory + "PK\x05\x06" + bytes_of(0, 4) + bytes_of(members.size(), 2) + bytes_of(members.size(), 2) +
         bytes_of(directory.size(), 4) + bytes_of(all.size(), 4) + bytes_of(0, 2);
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("claims are read as solvers write them") {
  struct Spelling {
    const char* name;
    std::string claims;
    std::vector<std::string> more = {};
  };
  const std::vector<Spelling> spellings = {
      {"ours.csv", "query,contact,toi\n0,1,0x1p-1\n1,0,\n2,1,0.25\n"},
      {"inf.csv", "query,contact,toi\n0,1,0.5\n1,0,inf\n2,1,0.25\n"},
      {"minus.csv", "query,contact,toi\n0,1,0.5\n1,0,-1\n2,1,0.25\n"},
      {"nan.csv", "query,contact,toi\n0,1,0.5\n1,0,nan\n2,1,0.25\n"},
      {"one.csv", "query,contact,toi\n0,1,0.5\n1,0,1\n2,1,0.25\n"},
      {"words.csv", "query,contact,toi\n0,True,0.5\n1,False,\n2,yes,0.25\n"},
      {"blanks.csv", " query , contact , toi\n0, 1, 0.5\n 1 ,\t0, \n2, 1, 0.25\n"},
      {"names.csv", "id,hit,time\n0,1,0.5\n1,0,\n2,1,0.25\n"},
      {"more_names.csv", "Index,Is Colliding,Time-of-Impact\n0,1.0,0.5\n1,0.0,\n2,1.0,0.25\n"},
      {"no_query.csv", "collision,toi\n1,0.5\n0,\n1,0.25\n"},
      {"no_header.csv", "0,1,0.5\n1,0,inf\n2,1,0.25\n"},
      {"told.csv", "1,0.5\n0,nan\n1,0.25\n", {"--columns", "contact,toi"}},
      {"told_past_header.csv", "answer,ms,when\ntrue,7,0.5\nfalse,7,\ntrue,7,0.25\n", {"--columns", "hit,-,toi"}},
      {"quoted.csv", "\"query\", \"contact\" ,\"toi\"\r\n0,\"1\", \"0.5\"\r\n1,0,\r\n2,1,0.25\r\n"},
      {"objects.json", R"([{"query": 0, "contact": true, "toi": 0.5}, {"id": 1, "hit": 0, "time": Infinity},
                           {"index": 2, "contact": 1.0, "toi": "0x1p-2"}])"},
      {"lines.jsonl",
       "{\"contact\": true, \"toi\": 0.5}\n\n{\"contact\": false, \"toi\": NaN}\n{\"contact\": 1, "
       "\"toi\": 0.25}\n"},
      {"array.npy", npy("<f8", "(3, 3)", doubles({0, 1, 0.5, 1, 0, kInfinity, 2, 1, 0.25}))},
      {"pairs.npy", npy("<f8", "(3, 2)", doubles({1, 0.5, 0, -1, 1, 0.25})), {"--columns", "contact,toi"}},
      {"arrays.npz", npz({{"hit.npy", npy("|b1", "(3,)", std::string("\1\0\1", 3))},
                          {"toi.npy", npy("<f8", "(3,)", doubles({0.5, kInfinity, 0.25}))}})},
  };
  for (const Spelling& spelling : spellings) {
    Judging judging;
    const Run right = judging.run(spelling.name, spelling.claims, spelling.more);
    CAPTURE(spelling.name, right.out, right.err);
    CHECK(right.status == 0);
    CHECK(right.err == "");
    CHECK(right.out.starts_with("all 3 claims hold (claims of " + judging.folder.path(spelling.name) + ", 1 file)\n"));
    CHECK(occurrences(right.out, "0 to 0 doubles before the exact time") == 1);  // so they were read
  }
}

TEST_CASE("a comment before the first row may name the columns, as numpy.savetxt writes it") {
  for (const char* const claims : {
           "# toi,contact,query\n0.5,1,0\ninf,0,1\n0.25,1,2\n",
           "# toi contact query\n0.25 1 2\n0.5 1 0\ninf 0 1\n",
           "# toi,contact,query\n0.25 1 2\n0.5 1 0\ninf 0 1\n",
           "# by \"me, it's 5\" long\n#toi;contact;query\r\n0.25;1;2\r\n0.5;1;0\r\ninf;0;1\r\n",
           "# my solver, version 2\n# of Monday\n\ntoi,contact,query\n0.5,1,0\ninf,0,1\n0.25,1,2\n",
           "# my solver, version 2, hits\n0,1,0.5\n1,0,inf\n2,1,0.25\n",
       }) {
    Judging judging;
    const Run run = judging.run("a.csv", claims);
    CAPTURE(claims, run.out, run.err);
    CHECK(run.status == 0);
    CHECK(run.out.starts_with("all 3 claims hold (claims of " + judging.folder.path("a.csv") + ", 1 file)\n"));
    CHECK(occurrences(run.out, "0 to 0 doubles before the exact time") == 1);
  }
  Judging judging;
  CHECK(occurrences(judging.run("b.csv", "# query,contact\n0,1\n1,yes no\n").err, "b.csv:3: contact is 'yes no'") == 1);
  CHECK(occurrences(judging.run("c.csv", "# nothing but this\n").err, "c.csv: is empty") == 1);
}

TEST_CASE("a list of contacts alone needs no column that says so") {
  struct Spelling {
    const char* name;
    std::string claims;
    std::vector<std::string> more = {};
  };
  for (const Spelling& spelling : std::vector<Spelling>{
           {"a.csv", "query,toi\n2,0.25\n0,0.5\n"},
           {"b.csv", "# toi,query\n0.25,2\n0.5,0\n"},
           {"c.csv", "2,0.25\n0,0.5\n", {"--columns", "query,toi"}},
           {"d.csv", "when,at\n0.25,2\n0.5,0\n", {"--columns", "toi,query"}},
           {"e.json", R"([{"id": 2, "t": 0.25}, {"id": 0, "t": 0.5}])"},
           {"f.jsonl", "{\"id\": 2, \"t\": 0.25}\n{\"id\": 0, \"t\": 0.5}\n"},
           {"g.npy", npy("<f8", "(2, 2)", doubles({2, 0.25, 0, 0.5})), {"--columns", "query,toi"}},
           {"h.npz", npz({{"query.npy", npy("<f8", "(2,)", doubles({2, 0}))},
                          {"toi.npy", npy("<f8", "(2,)", doubles({0.25, 0.5}))}})},
       }) {
    Judging judging;
    std::vector<std::string> more = spelling.more;
    more.insert(more.end(), {"--missing", "no-contact"});
    const Run run = judging.run(spelling.name, spelling.claims, more);
    CAPTURE(spelling.name, run.out, run.err);
    CHECK(run.status == 0);
    CHECK(run.out.starts_with("all 3 claims hold (claims of " + judging.folder.path(spelling.name) +
                              " (claims without 'contact' have one unless 'toi' denies it, no contact at 1 query "
                              "without a claim), 1 file)\n"));
    CHECK(occurrences(run.out, "0 to 0 doubles before the exact time") == 1);
    const Run refused = judging.run(spelling.name, spelling.claims, spelling.more);
    CAPTURE(refused.err);
    CHECK(refused.status == 2);
    CHECK(occurrences(refused.err, "--missing no-contact") == 1);
  }
  Judging judging;
  CHECK(judging.run("a.csv", "query\n0\n2\n", {"--missing", "no-contact"}).status == 0);
  CHECK(judging.run("b.csv", "query\n0\n2\n").status == 2);
  CHECK(judging.run("c.csv", "query,toi\n0,inf\n2,0.25\n", {"--missing", "no-contact"}).status == 1);
}

TEST_CASE("claims with a time outside the step are counted apart") {
  Judging judging;
  const Run run =
      judging.run("a.csv", "query,contact,toi\n0,1,-5\n1,1,-1\n2,1,1.5\n", {"--report", judging.folder.path("r.json")});
  CAPTURE(run.out, run.err);
  CHECK(run.status == 1);
  CHECK(occurrences(run.out,
                    "  outside     2 claims with a toi outside [0, 1], counted here alone: 1 below 0, 1 above 1") == 1);
  CHECK(occurrences(run.out, "doubles before the exact time") == 0);
  CHECK(occurrences(run.out, "doubles after the exact time") == 0);
  CHECK(occurrences(run.out, "phantom     1") == 1);
  CHECK(occurrences(judging.folder.read("r.json"), "\"below_0\": 1") == 1);
  CHECK(occurrences(judging.run("b.csv", "query,contact,toi\n0,1,0.5\n1,0,-5\n2,1,0\n").out, "outside") == 0);
}

TEST_CASE("a verdict says that claims have no times, and which columns are not read") {
  struct Spelling {
    const char* name;
    std::string claims;
    std::string left_out;
  };
  const std::vector<Spelling> spellings = {
      {"list.json", "[true, false, true]", "no times"},
      {"numbers.json", "[1, 0, 1]", "no times"},
      {"bits.npy", npy("|b1", "(3,)", std::string("\1\0\1", 3)), "no times"},
      {"column.csv", "1\n0\n1\n", "no times"},
      {"others.csv", "hit,ns,when\n1,7,0.5\n0,7,\n1,7,0.25\n", "no times, not read: 'ns' and 'when'"},
      {"times.csv", "hit,ns,toi\n1,7,0.5\n0,7,\n1,7,0.25\n", "not read: 'ns'"},
      {"keys.json", R"([{"contact": 1, "ns": 7, "toi": 0.5, "level": "x"}, {"contact": 0}, {"contact": 1}])",
       "times for 1 of 2 contacts, not read: 'ns'"},
      {"empty.csv", "contact,toi\n1,\n0,\n1,\n", "no times"},
      {"index.csv", ",hit,toi\n0,1,0.5\n1,0,\n2,1,0.25\n", "not read: ''"},
      {"from_one.csv", "\"\",hit,toi\n1,1,0.5\n2,0,\n3,1,0.25\n", "not read: ''"},
      {"again.csv", "Unnamed: 0,hit,toi\n0,1,0.5\n1,0,\n2,1,0.25\n", "not read: 'Unnamed: 0'"},
      {"words.csv", ",hit,toi\na,1,0.5\nb,0,\nc,1,0.25\n", "not read: ''"},
      {"apart.csv", "contact,toi,min_distance\n1,0.5,0\n0,,1\n1,0.25,0\n", "not read: 'min_distance'"},
      {"more.npz",
       npz({{"ns.npy", npy("<f8", "(1,)", doubles({7}))},
            {"contact.npy", npy("<i4", "(3,)", bytes_of(1, 4) + bytes_of(0, 4) + bytes_of(1, 4))}}),
       "no times, not read: 'ns'"},
  };
  for (const Spelling& spelling : spellings) {
    Judging judging;
    const Run run = judging.run(spelling.name, spelling.claims, {"--report", judging.folder.path("report.json")});
    CAPTURE(spelling.name, run.out, run.err);
    CHECK(run.status == 0);
    CHECK(run.out.starts_with("all 3 claims hold (claims of " + judging.folder.path(spelling.name) + " (" +
                              spelling.left_out + "), 1 file)\n"));
    CHECK(occurrences(judging.folder.read("report.json"), "\"left_out\": \"" + spelling.left_out + "\"") == 1);
  }
}

TEST_CASE("claims that number their queries may have any order") {
  struct Spelling {
    const char* name;
    std::string claims;
    std::vector<std::string> more = {};
  };
  const std::vector<Spelling> spellings = {
      {"a.csv", "id;hit;toi\n2;1;0.25\n0;1;0.5\n1;0;\n"},
      {"b.csv", "id,hit,toi\n0,1,0.5\n2,1,0.25\n1,0,\n"},
      {"c.csv", "2 1 0.25\n1 0 inf\n0 1 0.5\n"},
      {"d.json", R"([{"id": 1, "hit": false}, {"id": 2, "hit": true, "t": 0.25}, {"id": 0, "hit": true, "t": 0.5}])"},
      {"e.npy", npy("<f8", "(3, 3)", doubles({1, 0, kInfinity, 2, 1, 0.25, 0, 1, 0.5}))},
      {"hits.csv", "id,hit,toi\n2,1,0.25\n0,1,0.5\n", {"--missing", "no-contact"}},
      {"hits.npy", npy("<f8", "(2, 3)", doubles({2, 1, 0.25, 0, 1, 0.5})), {"--missing", "no-contact"}},
  };
  for (const Spelling& spelling : spellings) {
    Judging judging;
    const Run run = judging.run(spelling.name, spelling.claims, spelling.more);
    CAPTURE(spelling.name, run.out, run.err);
    CHECK(run.status == 0);
    const std::string without = spelling.more.empty() ? "" : " (no contact at 1 query without a claim)";
    CHECK(run.out.starts_with("all 3 claims hold (claims of " + judging.folder.path(spelling.name) + without +
                              ", 1 file)\n"));
    CHECK(occurrences(run.out, "0 to 0 doubles before the exact time") == 1);  // each time is that of its query
  }
  Judging judging;
  const Run none = judging.run("none.csv", "id,hit\n", {"--missing", "no-contact"});
  CHECK(none.status == 1);
  CHECK(occurrences(none.out, "  missed      2") == 1);
  // Several files, each named by its claims.
  const std::string more = judging.folder.write("point-point/r.csv", kQueries.substr(0, kQueries.size() / 3));
  const std::string first = judging.queries, head = "file,query,contact\n";
  const auto of_two = [&](const std::string& claims, const std::vector<std::string>& options = {}) {
    std::vector<std::string> words = options;
    words.push_back(more);
    return judging.run("two.csv", claims, words);
  };
  const std::string shuffled = first + ",2,1\n" + first + ",0,1\n" + more + ",0,1\n" + first + ",1,0\n";
  CHECK(of_two(head + shuffled).status == 0);
  CHECK(of_two(head + first + ",2,1\n" + more + ",0,1\n" + first + ",0,1\n", {"--missing", "no-contact"}).status == 0);
  CHECK(of_two("query,contact\n0,1\n0,1\n1,0\n2,1\n").status == 0);
  CHECK(occurrences(of_two("query,contact\n0,1\n1,0\n0,1\n2,1\n").err,
                    "two.csv:3: query is 1 where query 0 of " + first +
                        " comes next; claims about several query files have another order than the queries only if a "
                        "column 'file' names the file of each\n") == 1);
  const std::string no_file = ", which is none of the query files; claims name them as the command line does: ";
  CHECK(occurrences(of_two(head + "x.csv,0,1\n").err,
                    "two.csv:2: file is 'x.csv'" + no_file + "'" + more + "', '" + first + "'\n") == 1);
  CHECK(occurrences(of_two(head + "r.csv,0,1\n").err, "two.csv:2: file is 'r.csv'" + no_file + "'" + more + "'\n") ==
        1);
  CHECK(occurrences(of_two("file,contact\n" + more + ",1\n" + more + ",1\n").err,
                    " comes next; without a column 'query' the claims are in the order of the queries") == 1);
}

TEST_CASE("a claim that is missing, the second one of its query, or of none, is named with its row") {
  const std::string missing =
      " has none; queries are counted from 0, and with --missing no-contact those without a claim are claimed to have "
      "none";
  for (const auto& [claims, message] : std::vector<std::pair<std::string, std::string>>{
           {"0,1\n2,1\n", ":3: the claims end here, after 2; query 1 of FILE" + missing},
           {"1,1\n2,1\n3,0\n", ":4: query is 3, and FILE has 3 queries, counted from 0"},
           {"7,1\n", ":2: query is 7, and FILE has 3 queries, counted from 0"},
           {"0,1\n9,1\n7,1\n", ":3: query is 9, and FILE has 3 queries, counted from 0"},
           {"1,1\n2,1\n", ":3: the claims end here, after 2; query 0 of FILE" + missing},
           {"0.99999999999999999999,1\n", ":2: query is '0.99999999999999999999'; it must be a number counted from 0"},
           {"0,0.99999999999999999999\n",
            ":2: contact is '0.99999999999999999999'; it must be 0 or 1, true or false, or yes or no"},
           {"0,1.00000000000000000001\n",
            ":2: contact is '1.00000000000000000001'; it must be 0 or 1, true or false, or yes or no"},
           {"2,1\n1,0\n0,1\n3,0\n", ":5: query is 3, and FILE has 3 queries, counted from 0"},
           {"2,1\n3,0\n1,0\n0,1\n", ":3: query is 3, and FILE has 3 queries, counted from 0"},
           {"2,1\n2,1\n1,0\n0,1\n", ":3: the second claim about query 2 of FILE; the first one is in row 2"},
           {"0,1\n1,0\n0,1\n2,1\n", ":4: the second claim about query 0 of FILE"},
           {"0,1\n1,0\n2,1\n2,1\n", ":5: the second claim about query 2 of FILE"},
           {"0,1\n,0\n2,1\n", ":3: query is ''; it must be a number counted from 0"},
       }) {
    Judging judging;
    const Run run = judging.run("a.csv", "query,contact\n" + claims);
    std::string expected = judging.folder.path("a.csv") + message + "\n";
    if (const std::size_t at = expected.find("FILE"); at != std::string::npos) expected.replace(at, 4, judging.queries);
    CHECK(run.status == 2);
    CHECK(run.err == expected);
  }
  Judging judging;
  CHECK(occurrences(judging.run("a.json", "[true]", {"--missing", "no-contact"}).err,
                    "none, and --missing is for claims that number their queries\n") == 1);
  CHECK(occurrences(judging.run("b.json", R"([{"id": 1, "hit": 0}, {"id": 1, "hit": 0}])").err,
                    "b.json: claim 2 of 2: the second claim about query 1 of ") == 1);
  const std::string mixed = "query,contact,separation\n0,1,0\n2,1,1\n";
  CHECK(occurrences(judging.run("c.csv", mixed, {"--missing", "no-contact"}).err,
                    "has none, and those of others are about several separations; --separation says which\n") == 1);
}

TEST_CASE("a false claim is refuted in each sort of file") {
  for (const auto& [name, claims] : std::vector<std::pair<std::string, std::string>>{
           {"a.csv", "0,1,0.5\n1,0,inf\n2,1,0.2500001\n"},
           {"a.json", R"([{"contact": 1}, {"contact": 0}, {"contact": 1, "toi": 0.2500001}])"},
           {"a.npy", npy("<f8", "(3, 3)", doubles({0, 1, 0.5, 1, 0, -1, 2, 1, 0.2500001}))}}) {
    Judging judging;
    const Run run = judging.run(name, claims);
    CAPTURE(run.out, run.err);
    CHECK(run.status == 1);
    CHECK(occurrences(run.out, "late        1") == 1);
  }
}

TEST_CASE("faults of claims are named with what would be right") {
  struct Fault {
    const char* name;
    std::string claims;
    std::string message;
    std::vector<std::string> more = {};
  };
  const std::vector<Fault> faults = {
      {"two.csv", "1,0.5\n",
       ":1: no names of columns; --columns says what they are, for example --columns contact,toi"},
      {"none.csv", "query,answer\n0,1\n",
       ":1: no column is a 'contact' or a 'toi'; known names are file (or filename), query (or"},
      {"sorted.csv", ",hit,toi\n1,0,\n0,1,0.5\n2,1,0.25\n",
       ":3: a column has no name, and is '0' in row 1, counted from 0: is it the number of the query? Then name it "
       "query; else delete it"},
      {"again.csv", "hit,toi,Unnamed: 0\n1,0.5,2\n0,,1\n1,0.25,0\n", ":2: a column has no name, and is '2' in row 0"},
      {"twice.csv", "hit,contact\n0,1\n", ":1: two columns are a 'contact'; --columns says which one is read"},
      {"wide.csv",
       "1,2,3,4\n",
       ":1: 4 columns where --columns names 2; a - names one that is not read, for example --columns contact,toi,-,-",
       {"--columns", "contact,toi"}},
      {"wide.npy",
       npy("<f8", "(1, 6)", doubles({1, 0, 0, 0, 0, 0})),
       ": has 6 columns where --columns names 2; a - names one that is not read, for example --columns "
       "-,contact,-,-,-,...",
       {"--columns", "-,contact"}},
      {"narrow.csv", "1\n", ":1: 1 column where --columns names 2", {"--columns", "contact,toi"}},
      {"maybe.csv", "hit\nmaybe\n", ":2: contact is 'maybe'; it must be 0 or 1, true or false, or yes or no"},
      {"late.csv", "hit,toi\n1,inf\n", ":2: toi is 'inf'; of a contact it must be a finite number such as"},
      {"upper.csv", "0,0,NaN\n1,1,inf\n", ":2: toi is 'inf'; of a contact it must be a finite number such as"},
      {"truth.csv", "query,truth,predicted\n0,1,0\n", ":1: no column is a 'contact' or a 'toi'; known names are"},
      {"nan.json", "[{\"contact\": true, \"toi\": NaN}]", ": [0].toi: is 'NaN'; of a contact it must be finite"},
      {"metric.json", "[{\"contact\": true, \"metric\": \"max\"}]", ": [0]: has a 'metric' and no 'separation'"},
      {"none.npy", npy("<f8", "(2, 0)", ""), ": has 0 columns; --columns says what they are"},
      {"empty.npy", npy("<f8", "(0, 0)", ""), ": has 0 columns; --columns says what they are"},
      {"apart.npz",
       npz({{"contact.npy", npy("|b1", "(1,)", std::string(1, '\1'))},
            {"separation.npy", npy("<f8", "(1,)", doubles({1}))}}),
       ": has a 'separation', which is read from CSV and JSON alone; for the separation, --separation says it"},
      {"short.json", "[true]", ": the claims end here, after 1; query 1 of "},
      {"long.npy", npy("|b1", "(4,)", std::string("\1\0\1\1", 4)),
       ": claim 4 of 4: a claim too many; there are only 3 queries"},
      {"no.json", "[2]", ": [0]: must be 0 or 1, or false or true"},
      {"key.json", "[{\"time_of\": 1}]", ": [0]: no key is a 'contact' or a 'toi'; known names are file (or"},
      {"toi.json", "[{\"toi\": -1}]", ": [0].toi: where nothing says whether there is contact, it must be in [0, 1]"},
      {"toi.csv", "toi\n-1\n",
       ":2: toi is '-1'; where nothing says whether there is contact, it must be in [0, 1], or"},
      {"some.json", "[{\"id\": 1, \"hit\": 1}, {\"hit\": 1}]", ": [1]: has no 'query', and the first claim has one"},
      {"both.json", "[{\"hit\": 1, \"contact\": 1}]", ": [0]: has two keys that are a 'contact'"},
      {"text.json", "[{\"hit\": 1, \"toi\": \"soon\"}]", ": [0].toi: is 'soon'; of a contact it must be finite"},
      {"line.jsonl", "{\"hit\": 1}\n{\"hit\": }\n", ": line 2: no JSON: "},
      {"two.npy", npy("<f8", "(3, 2)", doubles({0, 1, 1, 0, 2, 1})), ": has 2 columns; --columns says what they are"},
      {"value.npy", npy("<f8", "(3,)", doubles({0, 0.5, 1})), ": contact of row 1 is 0.5; it must be 0 or 1"},
      {"when.npy", npy("<f8", "(1, 3)", doubles({0, 1, kInfinity})),
       ": toi of row 0 is inf; of a contact it must be finite"},
      {"query.npy", npy("<f8", "(1, 3)", doubles({-1, 1, 0.5})), ": query of row 0 is -1; it must be a number counted"},
      {"cube.npy", npy("<f8", "(1, 1, 1)", doubles({0})), ": an array of shape (1, 1, 1); claims have one row each"},
      {"packed.npz", npz({{"contact.npy", npy("|b1", "(1,)", std::string(1, '\1'))}}, 8),
       ": is compressed; numpy.savez, not savez_compressed, writes what is read"},
      {"none.npz", npz({{"query.npy", npy("<f8", "(1,)", doubles({1}))}}),
       ": no array is a 'contact' or a 'toi'; known names are"},
      {"minus.npz", npz({{"toi.npy", npy("<f8", "(1,)", doubles({-1}))}}),
       ": toi of row 0 is -1; where nothing says whether there is contact"},
      {"cut.npz", npz({{"contact.npy", npy("|b1", "(1,)", std::string(1, '\1'))}}).substr(0, 60), ": is no .npz file"},
      {"rows.npz",
       npz({{"contact.npy", npy("|b1", "(1,)", std::string(1, '\1'))},
            {"toi.npy", npy("<f8", "(2,)", doubles({1, 1}))}}),
       ": the array 'toi' has 2 rows, and 'contact' has 1"},
      {"told.npz",
       npz({{"contact.npy", npy("|b1", "(1,)", std::string(1, '\1'))}}),
       ": names its columns itself; --columns is for CSV and .npy",
       {"--columns", "contact"}},
  };
  for (const Fault& fault : faults) {
    Judging judging;
    const Run run = judging.run(fault.name, fault.claims, fault.more);
    CAPTURE(fault.name, run.out, run.err);
    CHECK(run.status == 2);
    CHECK(run.out == "");
    CHECK(run.err.starts_with(judging.folder.path(fault.name) + fault.message));
    CHECK(occurrences(run.err, "\n") == 1);
  }
}

TEST_CASE("columns that say nothing are refused") {
  Judging judging;
  for (const auto& [columns, message] : std::vector<std::pair<std::string, std::string>>{
           {"contact,when", "unknown column 'when'; known are file (or filename), "},
           {"query,file", "no column is a 'contact' or a 'toi'; known names are"},
           {"contact,metric", "the column metric needs separation"},
           {"contact,hit", "the column 'hit' says what one before it says"}}) {
    const Run run = judging.run("a.csv", "1,1\n", {"--columns", columns});
    CAPTURE(run.err);
    CHECK(run.status == 2);
    CHECK(occurrences(run.err, message) == 1);
  }
  const Run missing = run_program({"certify", "--missing", "no-contact", judging.queries});
  CHECK(missing.status == 2);
  CHECK(occurrences(missing.err, "--missing says what a file of --claims leaves out") == 1);
  const Run run = run_program({"certify", "--columns", "contact", judging.queries});
  CHECK(run.status == 2);
  CHECK(occurrences(run.err, "--columns says what a file of --claims has") == 1);
}

TEST_CASE("JSON of claims has the shapes that programs write, whatever its name and from a pipe") {
  const std::string lines =
      "{\"hit\": true, \"toi\": 0.5}\n{\"hit\": false, \"toi\": null}\n{\"hit\": true, \"toi\": 0.25}\n";
  const std::string columns = R"({"solver": "mine", "hit": [true, false, true], "toi": [0.5, Infinity, 0.25]})";
  // A table's rows are in the order of their numbers; "10" comes before "9" in the text's order.
  const std::string pandas = R"({"hit": {"9": false, "8": true, "10": true}, "toi": {"8": 0.5, "9": null, "10": 0.25},)"
                             R"("id": {"8": 0, "9": 1, "10": 2}})";
  const std::string filtered = R"({"hit": {"2": true, "0": true}, "toi": {"0": 0.5, "2": 0.25}})";
  for (const auto& [claims, more] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {lines, {}}, {columns, {}}, {pandas, {}}, {filtered, {"--missing", "no-contact"}}}) {
    for (const char* const name : {"a.json", "a.jsonl", "a.txt"}) {
      Judging judging;
      const Run run = judging.run(name, claims, more);
      CAPTURE(name, claims, run.out, run.err);
      CHECK(run.status == 0);
      CHECK(occurrences(run.out, "all 3 claims hold") == 1);
      CHECK(occurrences(run.out, "0 to 0 doubles before the exact time") == 1);
    }
    Judging judging;
    RunOptions options;
    options.standard_input = judging.folder.write("claims", claims);
    std::vector<std::string> words = {"certify", "--claims", "-", judging.queries};
    words.insert(words.end(), more.begin(), more.end());
    const Run piped = run_program(words, options);
    CAPTURE(claims, piped.err);
    CHECK(occurrences(piped.out, "all 3 claims hold") == 1);
  }
  const auto fault = [](const std::string& claims) { return Judging().run("a.json", claims).err; };
  CHECK(occurrences(fault(R"({"hit": [1, 0], "toi": [0.5]})"), "hit has 2 rows, and toi has 1; all columns") == 1);
  CHECK(occurrences(fault(R"({"hit": [1, 0, 1], "separation": 0.5})"), "separation is one value beside columns") == 1);
  CHECK(occurrences(Judging().run("a.json", columns).out, "(not read: 'solver')") == 1);
  CHECK(occurrences(fault(R"({"hit": {"a": 1}})"), "hit has a row 'a'; the names of rows must be their numbers") == 1);
  CHECK(occurrences(fault(R"({"hit": [1, 0, 1], "hit ": [1, 0, 1]})"), "has two keys that are a 'contact'") == 1);
}

TEST_CASE("claims may have times alone, and the verdict says so") {
  for (const auto& [name, claims] : std::vector<std::pair<std::string, std::string>>{
           {"a.csv", "toi\n0.5\ninf\n0.25\n"},
           {"b.csv", "id,toi\n1,none\n2,0.25\n0,0.5\n"},
           {"c.csv", "toi,ns\n0.5,1\n,1\n0.25,1\n"},
           {"a.json", R"({"toi": [0.5, null, 0.25]})"},
           {"b.jsonl", "{\"toi\": 0.5}\n{\"toi\": NaN}\n{\"toi\": \"0x1p-2\"}\n"}}) {
    Judging judging;
    const Run run = judging.run(name, claims);
    CAPTURE(name, run.out, run.err);
    CHECK(run.status == 0);
    CHECK(run.out.starts_with("all 3 claims hold (claims of " + judging.folder.path(name) +
                              " (claims without 'contact' have one unless 'toi' denies it"));
  }
  Judging judging;  // a time claims a contact
  CHECK(judging.run("a.csv", "toi\n0.5\n1\ninf\n").status == 1);
}

TEST_CASE("text of another encoding and packed files are named with the remedy") {
  const std::string wide(
      "h\0i\0t\0\n\0"
      "1\0\n\0",
      12);
  Judging judging;
  const auto refused = [&](const std::string& name, const std::string& content, const std::string& reason) {
    const std::string file = judging.folder.write("point-point/" + name, content);
    CAPTURE(file);
    CHECK(run_program({"certify", "--claims", file, judging.queries}).err == file + reason + "\n");
    CHECK(run_program({"solve", file}).err == file + reason + "\n");
    const std::vector<std::string> bodies = {"bodies", "--poses", file, judging.folder.write("a.obj", "v 0 0 0\n"),
                                             judging.folder.write("b.obj", "v 3 0 0\n")};
    CHECK(run_program(bodies).err == file + reason + "\n");
  };
  const std::string utf_16 = ": is text in UTF-16, which is not read; save it as UTF-8: iconv -f UTF-16 -t UTF-8";
  refused("mark.csv", "\xFF\xFE" + wide, utf_16);
  refused("big.csv", "\xFE\xFF" + std::string(1, '\0') + wide, utf_16);
  refused("wide.csv", wide, utf_16);
  refused("a.json", wide, utf_16);
  refused("a.csv.gz", "\x1F\x8B\x08xxxxxxx", ": is packed by gzip, which is not read; unpack it first: gunzip");
  refused("a.zip", "PK\x03\x04xxxxxxx", ": is packed by zip, which is not read; unpack it first: unzip");
}
