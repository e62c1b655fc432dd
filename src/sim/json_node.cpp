// SPDX-License-Identifier: MIT
#include "sim/json_node.hpp"

#include <algorithm>
#include <limits>

#include <touchstone/error.hpp>

#include "io/fail.hpp"

namespace touchstone::sim {

void JsonNode::fail(std::string_view reason) const {
  throw Error((path_.empty() ? std::string("the scene") : path_) + ": " + std::string(reason));
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
  return {*found, path_.empty() ? std::string(key) : path_ + "." + std::string(key)};
}

std::optional<JsonNode> JsonNode::find(std::string_view key) const {
  if (!has(key)) return std::nullopt;
  return at(key);
}

std::vector<JsonNode> JsonNode::items() const {
  if (!value_->is_array()) fail("must be a list");
  std::vector<JsonNode> all;
  all.reserve(value_->size());
  for (std::size_t i = 0; i < value_->size(); ++i)
    all.emplace_back((*value_)[i], path_ + "[" + std::to_string(i) + "]");
  return all;
}

double JsonNode::number() const {
  if (!value_->is_number()) fail("must be a number");
  return value_->get<double>();
}

std::uint32_t JsonNode::index() const {
  if (value_->is_number_unsigned() && value_->get<std::uint64_t>() <= std::numeric_limits<std::uint32_t>::max()) {
    return value_->get<std::uint32_t>();
  }
  fail("must be a whole number from 0 to 4294967295");
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
