// SPDX-License-Identifier: MIT
#include "structure/glossary.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace touchstone::structure {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_capital(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool is_small(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// Cuts a text into tokens: an identifier, "::", or any other character by itself. Comments, literals and #include
/// lines give no tokens.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  std::vector<Name> tokens() {
    while (at_ < text_.size()) step();
    return std::move(tokens_);
  }

 private:
  bool starts(std::string_view what) const { return text_.substr(at_, what.size()) == what; }

  void skip_to(std::size_t end) {
    end = std::min(end, text_.size());
    line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                         text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
    at_ = end;
  }

  void skip_past(std::string_view what) {
    const std::size_t found = text_.find(what, at_);
    skip_to(found == std::string_view::npos ? text_.size() : found + what.size());
  }

  void skip_literal(char quote) {
    std::size_t end = at_ + 1;
    while (end < text_.size() && text_[end] != quote) end += text_[end] == '\\' ? 2 : 1;
    skip_to(end + 1);
  }

  void skip_raw_string() {
    const std::size_t open = text_.find('(', at_);
    const std::string end = ")" + std::string(text_.substr(at_ + 2, open - at_ - 2)) + "\"";
    skip_past(end);
  }

  /// 1'000, 0x1p-40, 2.5e+3f
  void skip_number() {
    std::size_t end = at_;
    const auto sign_follows = [&] {
      return (text_[end] == '+' || text_[end] == '-') &&
             std::string_view("eEpP").find(text_[end - 1]) != std::string::npos;
    };
    while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]) || text_[end] == '.' ||
                                  text_[end] == '\'' || (end > at_ && sign_follows()))) {
      ++end;
    }
    skip_to(end);
  }

  bool at_include() const {
    if (text_[at_] != '#') return false;
    std::size_t word = at_ + 1;
    while (word < text_.size() && (text_[word] == ' ' || text_[word] == '\t')) ++word;
    return text_.substr(word, 7) == "include";
  }

  void take(std::size_t length) {
    tokens_.push_back({std::string(text_.substr(at_, length)), line_});
    at_ += length;
  }

  void step() {
    const char c = text_[at_];
    if (starts("//") || at_include()) return skip_to(text_.find('\n', at_));
    if (starts("/*")) return skip_past("*/");
    if (starts("R\"")) return skip_raw_string();
    if (c == '"' || c == '\'') return skip_literal(c);
    if (is_digit(c)) return skip_number();
    if (is_blank(c)) return skip_to(at_ + 1);
    if (!is_letter(c)) return take(starts("::") ? 2 : 1);
    std::size_t end = at_;
    while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
    take(end - at_);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::vector<Name> tokens_;
};

/// The text with its preprocessor lines blank.
std::string without_directives(std::string_view text) {
  std::string rest;
  bool continues = false;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    const std::size_t start = line.find_first_not_of(" \t");
    const bool directive = continues || (start != std::string_view::npos && line[start] == '#');
    continues = directive && !line.empty() && line.back() == '\\';
    if (!directive) rest += line;
    rest += '\n';
    at = end + 1;
  }
  return rest;
}

/// Follows the braces of a text, and collects the types whose braces are all those of namespaces.
class TypeFinder {
 public:
  explicit TypeFinder(std::vector<Name> tokens) : tokens_(std::move(tokens)) {}

  std::vector<TypeName> find() {
    for (at_ = 0; at_ < tokens_.size(); ++at_) {
      const std::string& token = tokens_[at_].text;
      if (token == "namespace") {
        enter_namespace();
      } else if (token == "class" || token == "struct" || token == "enum") {
        look_at_type();
      } else if (token == "{") {
        open_.push_back(is("extern", at_ - 1) ? Brace{true, true, {}} : Brace{});
      } else if (token == "}" && !open_.empty()) {
        open_.pop_back();
      }
    }
    return std::move(found_);
  }

 private:
  struct Brace {
    bool is_namespace = false;
    bool has_name = false;
    std::string name;  ///< "" for extern "C", too
  };

  bool is(std::string_view text, std::size_t i) const { return i < tokens_.size() && tokens_[i].text == text; }

  void enter_namespace() {
    std::string name;
    std::size_t i = at_ + 1;
    for (; i < tokens_.size() && !is("{", i) && !is(";", i) && !is("=", i); ++i) name += tokens_[i].text;
    if (is("{", i)) open_.push_back({true, !name.empty(), name});
    at_ = i;
  }

  void skip_attributes(std::size_t& i) const {
    while (is("[", i) || is("alignas", i)) {
      const char* const end = is("[", i) ? "]" : ")";
      while (i < tokens_.size() && !is(end, i)) ++i;
      while (is(end, i)) ++i;
    }
  }

  void look_at_type() {
    if (at_ > 0 && (is("<", at_ - 1) || is(",", at_ - 1) || is("friend", at_ - 1))) return;
    std::size_t i = at_ + 1;
    if (is("class", i) || is("struct", i)) ++i;  // of an enum
    skip_attributes(i);
    if (i >= tokens_.size() || !is_letter(tokens_[i].text[0])) return;
    const Name name = tokens_[i];
    if (is("::", i + 1)) return;
    while (i < tokens_.size() && !is("{", i) && !is(";", i) && !is("(", i) && !is("=", i)) ++i;
    at_ = i - 1;
    if (!is("{", i)) return;
    std::string scope;
    for (const Brace& brace : open_) {
      if (!brace.is_namespace || !brace.has_name) return;
      if (!brace.name.empty()) scope += (scope.empty() ? "" : "::") + brace.name;
    }
    found_.push_back({name.text, scope, name.line});
  }

  std::vector<Name> tokens_;
  std::size_t at_ = 0;
  std::vector<Brace> open_;
  std::vector<TypeName> found_;
};

}  // namespace

std::vector<Name> identifiers_of(std::string_view text) {
  std::vector<Name> tokens = Scanner(text).tokens();
  std::erase_if(tokens, [](const Name& token) { return !is_letter(token.text[0]); });
  return tokens;
}

std::vector<std::string> words_of(std::string_view identifier) {
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < identifier.size(); ++i) {
    const char c = identifier[i], before = i > 0 ? identifier[i - 1] : '_';
    const char after = i + 1 < identifier.size() ? identifier[i + 1] : '_';
    const bool starts_word =
        is_digit(c) != is_digit(before) || (is_capital(c) && (!is_capital(before) || is_small(after)));
    if (c == '_' || starts_word) words.emplace_back();
    if (c != '_') words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  std::erase(words, "");
  return words;
}

std::vector<TypeName> types_of(std::string_view text) {
  return TypeFinder(Scanner(without_directives(text)).tokens()).find();
}

}  // namespace touchstone::structure
