// A JSON value with its path, which every message about it names.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::json {

/// A document that can be destroyed when there is no memory left. The library's destructor allocates a list of all
/// elements, and a failure there ends the program, as no exception may leave a destructor.
class JsonDocument {
 public:
  JsonDocument() = default;
  JsonDocument(JsonDocument&& other) noexcept = default;
  JsonDocument& operator=(JsonDocument&&) = delete;
  ~JsonDocument();

  nlohmann::json& value() noexcept { return value_; }
  const nlohmann::json& value() const noexcept { return value_; }

 private:
  nlohmann::json value_;
};

/// @throws Error for text that is no JSON, and for a key that an object has twice, by its path
JsonDocument parse_json(std::string_view text);

class JsonNode {
 public:
  /// @param whole  the name of the document in messages, as its path is empty
  JsonNode(const nlohmann::json& document, std::string_view whole) : JsonNode(document, "", whole) {}

  /// @throws Error "PATH: REASON"
  [[noreturn]] void fail(std::string_view reason) const;

  /// An object with no other keys than these.
  void check_keys(std::initializer_list<std::string_view> keys) const;

  bool is_object() const noexcept { return value_->is_object(); }
  bool is_number() const noexcept { return value_->is_number(); }
  bool is_text() const noexcept { return value_->is_string(); }
  bool is_null() const noexcept { return value_->is_null(); }
  std::vector<std::string> keys() const;  ///< of an object
  bool has(std::string_view key) const;
  JsonNode at(std::string_view key) const;  ///< @throws Error when it is missing
  std::optional<JsonNode> find(std::string_view key) const;
  std::vector<JsonNode> items() const;  ///< of a list

  double number() const;
  std::uint32_t index() const;  ///< a whole number from 0 to 2^32 - 1
  std::uint64_t whole_number(std::uint64_t least, std::uint64_t most) const;
  void version(std::uint32_t must) const;  ///< this number, and no other
  bool boolean() const;
  std::string text() const;
  std::array<double, 3> three_numbers() const;

  double number_or(std::string_view key, double otherwise) const;
  bool boolean_or(std::string_view key, bool otherwise) const;

 private:
  JsonNode(const nlohmann::json& value, std::string path, std::string_view whole)
      : value_(&value), path_(std::move(path)), whole_(whole) {}

  const nlohmann::json* value_;
  std::string path_;
  std::string_view whole_;
};

}  // namespace touchstone::json
