// SPDX-License-Identifier: MIT
#include "scene/json_node.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include <touchstone/error.hpp>

#include "io/fail.hpp"

namespace touchstone::sim {
namespace {

std::string item_path(const std::string& list, std::size_t number) { return list + "[" + std::to_string(number) + "]"; }

std::string key_path(const std::string& object, std::string_view key) {
  return object.empty() ? std::string(key) : object + "." + std::string(key);
}

/// Where a parser is, and which keys it has seen there: of two equal ones the library would drop the first without a
/// word. A pass of its own, as the library's parser with a callback takes time that grows with the square of a list.
class KeyWatch final : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool null() override { return count(); }
  bool boolean(bool) override { return count(); }
  bool number_integer(number_integer_t) override { return count(); }
  bool number_unsigned(number_unsigned_t) override { return count(); }
  bool number_float(number_float_t, const string_t&) override { return count(); }
  bool string(string_t&) override { return count(); }
  bool binary(binary_t&) override { return count(); }
  bool start_object(std::size_t) override { return begin(false); }
  bool start_array(std::size_t) override { return begin(true); }
  bool end_object() override { return end(); }
  bool end_array() override { return end(); }
  bool key(string_t& name) override {
    Open& object = open_.back();
    object.name = name;
    if (!object.keys.insert(name).second) throw Error(path() + ": the key is there twice in one object");
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override {
    return false;  // the parser that makes the document says it better
  }

 private:
  struct Open {
    bool list = false;
    std::size_t count = 0;       // of a list: values that have begun
    std::string name;            // of an object: its latest key
    std::set<std::string> keys;  // of an object
  };
  bool begin(bool list) {
    count();
    open_.push_back({list, 0, {}, {}});
    return true;
  }
  bool end() {
    open_.pop_back();
    return true;
  }
  bool count() {
    if (!open_.empty()) ++open_.back().count;
    return true;
  }
  std::string path() const {
    constexpr std::size_t kLongest = 400;  // keys may be any text, and as deep as the file is long
    std::string path;
    for (const Open& open : open_) {
      const std::string quoted = io::in_quotes(open.name);
      path = open.list ? item_path(path, open.count - 1) : key_path(path, quoted.substr(1, quoted.size() - 2));
      if (path.size() > kLongest) return path + "...";
    }
    return path;
  }

  std::vector<Open> open_;
};

}  // namespace

nlohmann::json parse_json(std::string_view text) {
  KeyWatch watch;
  nlohmann::json::sax_parse(text.begin(), text.end(), &watch);
  try {
    return nlohmann::json::parse(text.begin(), text.end());
  } catch (const nlohmann::json::exception& error) {
    // "[json.exception.parse_error.101] parse error at line 1, column 2: ..."
    const std::string what = error.what();
    const std::size_t bracket = what.find("] ");
    throw Error("no JSON: " + (bracket == std::string::npos ? what : what.substr(bracket + 2)));
  }
}

void JsonNode::fail(std::string_view reason) const {
  throw Error((path_.empty() ? std::string(whole_) : path_) + ": " + std::string(reason));
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

Vector3 JsonNode::vector() const {
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

Vector3 JsonNode::vector_or(std::string_view key, const Vector3& otherwise) const {
  return has(key) ? at(key).vector() : otherwise;
}

}  // namespace touchstone::sim
