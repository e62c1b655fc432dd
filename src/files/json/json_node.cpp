// SPDX-License-Identifier: MIT
#include "json/json_node.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include <touchstone/error.hpp>

#include "io/fail.hpp"

namespace touchstone::json {
namespace {

std::string item_path(const std::string& list, std::size_t number) { return list + "[" + std::to_string(number) + "]"; }

std::string key_path(const std::string& object, std::string_view key) {
  return object.empty() ? std::string(key) : object + "." + std::string(key);
}

/// Makes a document of the values that the library's parser reads. The library's own maker drops the first of two equal
/// keys without a word. When memory runs out, it destroys its own document, which ends the program (see JsonDocument).
class DocumentMaker final : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit DocumentMaker(nlohmann::json& root) : root_(root) {}

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t& text) override {
    add(value);
    // The library's parser takes a number below the least double for 0, and one beyond the greatest for an error.
    const std::string_view digits = std::string_view(text).substr(0, text.find_first_of("eE"));
    if (value == 0 && digits.find_first_of("123456789") != std::string_view::npos) {
      throw Error(path() + ": " + io::shortened(text) +
                  " is too small for a double; write 0, or a number of 1e-323 or more");
    }
    return true;
  }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // no JSON text has any
  bool start_object(std::size_t) override { return begin(nlohmann::json::object()); }
  bool start_array(std::size_t) override { return begin(nlohmann::json::array()); }
  bool end_object() override { return end(); }
  bool end_array() override { return end(); }
  bool key(string_t& name) override {
    Open& object = open_.back();
    object.name = name;
    if (object.value->contains(name)) throw Error(path() + ": the key is there twice in one object");
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception& error) override {
    // "[json.exception.parse_error.101] parse error at line 1, column 2: ..."
    const std::string what = error.what();
    const std::size_t bracket = what.find("] ");
    throw Error("no JSON: " + io::with_short_words(bracket == std::string::npos ? what : what.substr(bracket + 2)));
  }

 private:
  struct Open {
    nlohmann::json* value;  // does not move: nothing is added to its holder while it is open
    std::string name;       // of an object: its latest key
  };

  nlohmann::json& put(nlohmann::json&& value) {
    if (open_.empty()) return root_ = std::move(value);
    nlohmann::json& parent = *open_.back().value;
    if (parent.is_array()) return parent.emplace_back(std::move(value));
    return parent[open_.back().name] = std::move(value);
  }
  bool add(nlohmann::json&& value) {
    put(std::move(value));
    return true;
  }
  bool begin(nlohmann::json&& empty) {
    nlohmann::json& value = put(std::move(empty));
    open_.push_back({&value, {}});
    return true;
  }
  bool end() {
    open_.pop_back();
    return true;
  }
  std::string path() const {
    constexpr std::size_t kLongest = 400;  // keys may be any text, and as deep as the file is long
    std::string path;
    for (const Open& open : open_) {
      const std::string name = io::shortened(open.name);
      path = open.value->is_array() ? item_path(path, open.value->size() - 1) : key_path(path, name);
      if (path.size() > kLongest) return path + "...";
    }
    return path;
  }

  nlohmann::json& root_;
  std::vector<Open> open_;
};

/// The last element of a list or object, which is not empty.
nlohmann::json& last_of(nlohmann::json& value) { return *std::prev(value.end()); }

void erase_last(nlohmann::json& value) { value.erase(std::prev(value.end())); }

}  // namespace

JsonDocument::~JsonDocument() {
  // Depth first, from the last element to the first. `current` is being emptied; `above` holds it, with the
  // next one above in the place from which the current one was taken.
  nlohmann::json current = std::move(value_), above;
  for (;;) {
    if (current.is_structured() && !current.empty()) {
      nlohmann::json next = std::move(last_of(current));
      last_of(current) = std::move(above);
      above = std::move(current);
      current = std::move(next);
    } else if (above.is_structured()) {
      current = std::move(above);
      above = std::move(last_of(current));
      erase_last(current);
    } else {
      return;
    }
  }
}

JsonDocument parse_json(std::string_view text) {
  JsonDocument document;
  DocumentMaker maker(document.value());
  nlohmann::json::sax_parse(text.begin(), text.end(), &maker);
  return document;
}

void JsonNode::fail(std::string_view reason) const {
  throw Error((path_.empty() ? std::string(whole_) : path_) + ": " + std::string(reason));
}

std::vector<std::string> JsonNode::keys() const {
  std::vector<std::string> keys;
  for (const auto& [key, value] : value_->items()) keys.push_back(key);
  return keys;
}

void JsonNode::check_keys(std::initializer_list<std::string_view> keys) const {
  if (!value_->is_object()) fail("must be an object");
  for (const auto& item : value_->items()) {
    if (std::find(keys.begin(), keys.end(), item.key()) != keys.end()) continue;
    std::string known;
    for (const auto key : keys) known += (known.empty() ? "" : ", ") + std::string(key);
    fail("has no key " + io::in_quotes(item.key()) + "; it may have " + known);
  }
}

bool JsonNode::has(std::string_view key) const { return value_->is_object() && value_->contains(std::string(key)); }

JsonNode JsonNode::at(std::string_view key) const {
  if (!value_->is_object()) fail("must be an object");
  const auto found = value_->find(std::string(key));
  if (found == value_->end()) fail("lacks the key '" + std::string(key) + "'");
  return {*found, key_path(path_, key), whole_};
}

std::optional<JsonNode> JsonNode::find(std::string_view key) const {
  if (!has(key)) return std::nullopt;
  return at(key);
}

std::vector<JsonNode> JsonNode::items() const {
  if (!value_->is_array()) fail("must be a list");
  std::vector<JsonNode> all;
  all.reserve(value_->size());
  for (std::size_t i = 0; i < value_->size(); ++i) all.push_back(JsonNode((*value_)[i], item_path(path_, i), whole_));
  return all;
}

double JsonNode::number() const {
  if (!value_->is_number()) fail("must be a number");
  return value_->get<double>();
}

std::uint32_t JsonNode::index() const {
  return static_cast<std::uint32_t>(whole_number(0, std::numeric_limits<std::uint32_t>::max()));
}

std::uint64_t JsonNode::whole_number(std::uint64_t least, std::uint64_t most) const {
  const std::uint64_t number = value_->is_number_unsigned() ? value_->get<std::uint64_t>() : 0;
  if (value_->is_number_unsigned() && number >= least && number <= most) return number;
  fail("must be a whole number from " + std::to_string(least) + " to " + std::to_string(most));
}

void JsonNode::version(std::uint32_t must) const {
  if (!value_->is_number_unsigned() || value_->get<std::uint64_t>() != must) fail("must be " + std::to_string(must));
}

bool JsonNode::boolean() const {
  if (!value_->is_boolean()) fail("must be true or false");
  return value_->get<bool>();
}

std::string JsonNode::text() const {
  if (!value_->is_string()) fail("must be a string");
  return value_->get<std::string>();
}

std::array<double, 3> JsonNode::three_numbers() const {
  const auto all = items();
  if (all.size() != 3) fail("must be a list of three numbers");
  return {all[0].number(), all[1].number(), all[2].number()};
}

double JsonNode::number_or(std::string_view key, double otherwise) const {
  return has(key) ? at(key).number() : otherwise;
}

bool JsonNode::boolean_or(std::string_view key, bool otherwise) const {
  return has(key) ? at(key).boolean() : otherwise;
}

}  // namespace touchstone::json
