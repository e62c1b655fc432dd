// One name, one meaning: identifiers have the words of the field, and no two namespaces have a type of one name.
// SPDX-License-Identifier: MIT
#include "structure/glossary.hpp"

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "structure/source_tree.hpp"
#include "support/catch.hpp"

using namespace touchstone::structure;

namespace {

/// Words of everyday English that had a meaning of their own here. The field's words say more: fraction; iterate,
/// position, index, slot; interval, piece, component; requested, selected, expected; position correction.
const std::map<std::string, std::string> kPrivateWords = {{"share", "share"},   {"shares", "share"}, {"place", "place"},
                                                          {"places", "place"},  {"part", "part"},    {"parts", "part"},
                                                          {"wanted", "wanted"}, {"pushed", "pushed"}};

/// A private word that identifiers below some folders may have.
struct AllowedWord {
  std::string word;
  std::vector<std::string> below;
  std::string reason;
};

/// Add an entry only for a name that a user sees. Otherwise choose a better word.
const std::vector<AllowedWord> kAllowedWords = {
    {"wanted",
     {"include/", "src/bindings/", "src/core/", "src/cli/bench/methods.cpp",
      "src/measuring/report/sets/body_pairs.cpp"},
     "SolveOptions::wanted and Wanted are public names, and the value keeps its name down to the levels"},
    {"part",
     {"src/bindings/python/mesh_files.cpp", "src/files/frames/", "src/files/sequence/", "src/cli/generate/frames.cpp",
      "src/cli/mesh/", "src/cli/bodies/", "src/cli/shared/mesh_results.cpp",
      "src/cli/shared/command_line/mesh_file_options"},
     "a named object or group of a mesh file, as the key `part` of reports and the columns of tables call it"},
};

/// An identifier with a private word that may stand everywhere.
struct AllowedIdentifier {
  std::string identifier, reason;
};

const std::vector<AllowedIdentifier> kAllowedIdentifiers = {
    {"in_place", "std::in_place"},
    {"solveInPlace", "Eigen's name"},
    {"solve_in_place", "linear algebra's name for a solution that replaces the right-hand side"},
    {"positive_part", "the name in analysis for max(x, 0), of a matrix by its eigenvalues"},
    {"share_vertex", "the geometer's verb: two elements share a vertex"},
    {"EnclosedPart", "the key `enclosed_parts` of reports"},
    {"ClosedParts", "the key `enclosed_parts` of reports"},
};

/// A type name that several namespaces define. No file sees two of them without a namespace in front.
struct AllowedType {
  std::string name, reason;
};

const std::vector<AllowedType> kAllowedTypes = {
    {"Body", "of the library: a mesh that turns; of a scene: what its key `bodies` lists, with mass and motion"},
    {"BodyContact", "of the library: with its exact answer; of the simulator: with the impulses' directions"},
    {"Facet", "of a scene: a face that only collides; of the filters: a facet of a polyhedron"},
    {"Frame", "of an animation; and the vectors u, w, r of a query, of which the baselines have their own"},
    {"Mesh", "of the library; and the generators' faces and edges, which know nothing of it"},
    {"Piece", "of a proof: a piece of the step; of a mesh: a surface, a wire or a loose point"},
    {"Pose", "of the library; and the simulator's, whose quaternion has the length 1"},
    {"Polynomial", "of exact numbers; and the baselines' own in doubles, as they share no code with what they check"},
    {"Question", "of a filter: about a query; of a sequence: about steps or frames"},
    {"Report", "of measurements; and the file that `touchstone mesh` writes"},
    {"Result", "each of three layers measures or checks something, and this is what one run gave"},
    {"Settings", "of a fuzz run, and the key `settings` of a scene"},
    {"Step", "of a scene's generator: two frames; of the filters: a query as they read it"},
};

/// Namespaces whose types are not compared with those of others.
const std::vector<std::string> kSeparateNamespaces = {
    "checker",  // touchstone-check shares no code with the library that it checks
    "ticcd",    // the drop-in has the type names of the library whose place it takes
};

struct Word {
  std::string word, identifier;
  int line = 0;
};

std::vector<Word> private_words_of(std::string_view text) {
  std::vector<Word> found;
  for (const Name& name : identifiers_of(text)) {
    for (const std::string& word : words_of(name.text)) {
      const auto entry = kPrivateWords.find(word);
      if (entry != kPrivateWords.end()) found.push_back({entry->second, name.text, name.line});
    }
  }
  return found;
}

/// Looks for private words, and keeps account of the exceptions that were needed.
class Glossary {
 public:
  /// @param path  from the project's folder: "src/core/exact/decide.cpp"
  void read(const std::string& path, std::string_view text) {
    for (const Word& word : private_words_of(text)) {
      if (allows_identifier(word) || allows_word(path, word)) continue;
      faults.push_back(path + ":" + std::to_string(word.line) + ": `" + word.identifier + "` has the private word `" +
                       word.word + "`");
    }
  }

  std::vector<std::string> unused_exceptions() const {
    std::vector<std::string> unused;
    for (const AllowedIdentifier& allowed : kAllowedIdentifiers) {
      if (used_.count(allowed.identifier) == 0) unused.push_back(allowed.identifier);
    }
    for (const AllowedWord& allowed : kAllowedWords) {
      for (const std::string& folder : allowed.below) {
        if (used_.count(allowed.word + " " + folder) == 0) unused.push_back(allowed.word + " in " + folder);
      }
    }
    return unused;
  }

  std::vector<std::string> faults;

 private:
  bool allows_identifier(const Word& word) {
    for (const AllowedIdentifier& allowed : kAllowedIdentifiers) {
      if (allowed.identifier != word.identifier) continue;
      used_.insert(allowed.identifier);
      return true;
    }
    return false;
  }

  bool allows_word(const std::string& path, const Word& word) {
    for (const AllowedWord& allowed : kAllowedWords) {
      if (allowed.word != word.word) continue;
      for (const std::string& folder : allowed.below) {
        if (path.compare(0, folder.size(), folder) != 0) continue;
        used_.insert(allowed.word + " " + folder);
        return true;
      }
    }
    return false;
  }

  std::set<std::string> used_;
};

/// Where each type name is defined: its namespaces, and in each the last file that defines it.
class TypeIndex {
 public:
  void read(const std::string& path, std::string_view text) {
    for (const TypeName& type : types_of(text)) {
      bool is_separate = false;
      for (const std::string& scope : kSeparateNamespaces) is_separate = is_separate || type.scope == scope;
      if (!is_separate) scopes_[type.name][type.scope] = path + ":" + std::to_string(type.line);
    }
  }

  std::size_t size() const { return scopes_.size(); }

  /// The names that several namespaces define: "Mesh: touchstone (mesh.hpp:106), touchstone::generators
  /// (shapes.hpp:20)".
  std::map<std::string, std::string> ambiguous() const {
    std::map<std::string, std::string> result;
    for (const auto& [name, scopes] : scopes_) {
      if (scopes.size() < 2) continue;
      std::string& text = result[name];
      for (const auto& [scope, where] : scopes)
        text += (text.empty() ? name + ": " : ", ") + scope + " (" + where + ")";
    }
    return result;
  }

 private:
  std::map<std::string, std::map<std::string, std::string>> scopes_;
};

/// Calls read(path, text) for each source below src and include.
template <class Read>
void for_each_source(const Read& read) {
  for (const std::string folder : {"src", "include"}) {
    for (const auto& file : cpp_files(folder)) {
      const std::string path = folder + "/" + file.generic_string();
      read(path, text_of(std::filesystem::path(TOUCHSTONE_SOURCE_DIR) / path));
    }
  }
}

std::vector<std::string> texts_of(const std::vector<Name>& names) {
  std::vector<std::string> texts;
  for (const Name& name : names) texts.push_back(name.text);
  return texts;
}

}  // namespace

TEST_CASE("identifiers have the field's words, and each exception has a reason and a use") {
  Glossary glossary;
  std::size_t files = 0;
  for_each_source([&](const std::string& path, const std::string& text) {
    glossary.read(path, text);
    ++files;
  });
  CHECK(files > 500);
  INFO(lines_of(glossary.faults));
  CHECK(glossary.faults.empty());

  const std::vector<std::string> unused = glossary.unused_exceptions();
  INFO("exceptions that nothing needs:\n" << lines_of(unused));
  CHECK(unused.empty());
  for (const AllowedWord& allowed : kAllowedWords) CHECK(allowed.reason.size() > 10);
  for (const AllowedIdentifier& allowed : kAllowedIdentifiers) CHECK(allowed.reason.size() > 10);
}

TEST_CASE("no two namespaces define a type of one name, but for those with a reason") {
  TypeIndex types;
  for_each_source([&](const std::string& path, const std::string& text) { types.read(path, text); });
  CHECK(types.size() > 300);
  std::map<std::string, std::string> ambiguous = types.ambiguous();
  for (const AllowedType& allowed : kAllowedTypes) {
    INFO(allowed.name << " is listed, and only one namespace defines it");
    CHECK(ambiguous.erase(allowed.name) == 1);
    CHECK(allowed.reason.size() > 10);
  }
  for (const auto& [name, text] : ambiguous) {
    INFO(text);
    CHECK(name.empty());
  }
}

TEST_CASE("private words are found in identifiers, and not in comments, literals and includes") {
  const std::string text = R"x(#include "cli/found_parts.hpp"
// the part of a place
/* a share
of it */ int kMostParts = 1'000, in_Place2 = 0x1p-4;
const char* place_of = "wanted" "\"pushed";  // pushed
char c = '\''; auto raw = R"(a part)";
struct SharedPart { int apart, placed, particle; };
)x";
  std::vector<std::string> found;
  for (const Word& word : private_words_of(text)) {
    found.push_back(std::to_string(word.line) + " " + word.identifier + " " + word.word);
  }
  CHECK(found ==
        std::vector<std::string>{"4 kMostParts part", "4 in_Place2 place", "5 place_of place", "7 SharedPart part"});

  Glossary glossary;
  glossary.read("src/core/exact/decide.cpp", "int wanted, place_at;");
  glossary.read("src/simulation/sim/simulation.cpp", "int wanted;");
  CHECK(glossary.faults ==
        std::vector<std::string>{"src/core/exact/decide.cpp:1: `place_at` has the private word `place`",
                                 "src/simulation/sim/simulation.cpp:1: `wanted` has the private word `wanted`"});
  CHECK(glossary.unused_exceptions().size() > 10);
}

TEST_CASE("an identifier is split at underscores, capitals and digits") {
  using Words = std::vector<std::string>;
  CHECK(words_of("part_on_line_") == Words{"part", "on", "line"});
  CHECK(words_of("kPartBound") == Words{"k", "part", "bound"});
  CHECK(words_of("solveInPlace") == Words{"solve", "in", "place"});
  CHECK(words_of("TOUCHSTONE_WANTED_ALL") == Words{"touchstone", "wanted", "all"});
  CHECK(words_of("HTMLPart") == Words{"html", "part"});
  CHECK(words_of("part2of") == Words{"part", "2", "of"});
  CHECK(words_of("__part") == Words{"part"});
}

TEST_CASE("identifiers are those of the code alone") {
  CHECK(texts_of(identifiers_of("double x = 2.5e+3 + 0x1.8p-2f; a'b")) == std::vector<std::string>{"double", "x", "a"});
  CHECK(texts_of(identifiers_of("#define SIZE(a) a\n# include <vector>\nint b;")) ==
        std::vector<std::string>{"define", "SIZE", "a", "a", "int", "b"});
}

TEST_CASE("a type of one name in two namespaces is found") {
  const std::string text = R"(
namespace a { struct Same; class Alone final : public Base<int> { struct Inner { int x; }; }; }
namespace a::b {
template <class T, class Unused> struct Same { T x; };
enum class Sort : int { one };
namespace { struct Hidden {}; }
inline void f() { struct Local {}; }
struct Alone::Inner2 {};
}
extern "C" { struct touchstone_thing { int x; }; }
namespace c { class [[nodiscard]] Same {}; struct Same make() { return {}; } }
namespace d = a::b;
#define MAKE struct Made {
namespace checker { struct Sort {}; }
)";
  std::vector<std::string> found;
  for (const TypeName& type : types_of(text)) found.push_back(type.scope + " " + type.name);
  CHECK(found ==
        std::vector<std::string>{"a Alone", "a::b Same", "a::b Sort", " touchstone_thing", "c Same", "checker Sort"});

  TypeIndex types;
  types.read("x.hpp", text);
  const std::map<std::string, std::string> ambiguous = types.ambiguous();
  REQUIRE(ambiguous.size() == 1);
  CHECK(ambiguous.at("Same") == "Same: a::b (x.hpp:4), c (x.hpp:11)");
}
