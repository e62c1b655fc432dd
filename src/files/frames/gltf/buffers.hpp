// The buffers of a glTF file: within it, beside it and in base64.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/whole_file.hpp"
#include "json/json_node.hpp"

namespace touchstone::frames {

/// Elements side by side in a buffer.
struct AccessorElements {
  const char* first = nullptr;
  std::size_t stride = 0;
  std::size_t count = 0;
  std::uint64_t component = 0;  ///< glTF's number of the type
};

/// The items of a list of the file; none where it has no such list.
std::vector<json::JsonNode> items_of(const json::JsonNode& root, const char* key);

/// The item of a list that an index names. @throws Error  if there is none
const json::JsonNode& item_of(const json::JsonNode& index, const std::vector<json::JsonNode>& list);

class Buffers {
 public:
  /// Reads the files beside the glTF file.
  /// @param binary  the binary chunk of a .glb; used as long as this object is
  Buffers(std::string_view file, const json::JsonNode& root, std::string_view binary);

  /// What an accessor's number names. @throws Error
  const json::JsonNode& accessor(const json::JsonNode& index) const { return item_of(index, accessors_); }

  /// @param type  "VEC3" or "SCALAR". @throws Error  for an accessor of another type, or beyond its buffer
  AccessorElements elements_of(const json::JsonNode& accessor, std::string_view type) const;

  std::size_t bytes() const noexcept { return bytes_; }             ///< of all buffers
  const std::string& digests() const noexcept { return digests_; }  ///< of the files beside the glTF file

 private:
  std::string_view bytes_of(const json::JsonNode& buffer, std::size_t number);
  std::string_view embedded(const json::JsonNode& uri, const std::string& text);
  std::string_view beside(const json::JsonNode& uri, const std::string& text);

  std::string_view file_, binary_;
  std::vector<json::JsonNode> accessors_, views_;
  std::vector<std::string_view> buffers_;
  std::vector<std::unique_ptr<std::string>> embedded_;
  std::vector<io::WholeFile> files_;
  std::string digests_;
  std::size_t bytes_ = 0;
};

}  // namespace touchstone::frames
