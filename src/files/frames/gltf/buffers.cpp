// SPDX-License-Identifier: MIT
#include "frames/gltf/buffers.hpp"

#include <filesystem>
#include <optional>
#include <utility>

#include <touchstone/error.hpp>

#include "frames/base64.hpp"
#include "frames/content.hpp"
#include "io/fail.hpp"
#include "io/sha256.hpp"

namespace touchstone::frames {

using json::JsonNode;

namespace {

constexpr std::size_t kMostCount = std::size_t{1} << 33;

/// The file that a uri names, which must be beside the glTF file; nothing for others.
std::optional<std::string> file_beside(std::string_view gltf, const std::string& uri) {
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const auto digit = [&](std::size_t k) {
      return k < uri.size() ? std::string_view("0123456789abcdefABCDEF").find(uri[k]) : std::string_view::npos;
    };
    const bool escaped = uri[i] == '%' && digit(i + 1) != std::string::npos && digit(i + 2) != std::string::npos;
    name += escaped ? static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16)) : uri[i];
    i += escaped ? 2 : 0;
  }
  const std::filesystem::path path(name);
  if (name.empty() || path.is_absolute() || name.find("..") != std::string::npos ||
      name.find(':') != std::string::npos) {
    return std::nullopt;
  }
  return (std::filesystem::path(gltf).parent_path() / path).string();
}

}  // namespace

std::vector<JsonNode> items_of(const JsonNode& root, const char* key) {
  const auto found = root.find(key);
  return found ? found->items() : std::vector<JsonNode>();
}

const JsonNode& item_of(const JsonNode& index, const std::vector<JsonNode>& list) {
  const std::uint64_t i = index.whole_number(0, list.empty() ? 0 : list.size() - 1);
  if (list.empty()) index.fail("is an index into a list without items");
  return list[i];
}

Buffers::Buffers(std::string_view file, const JsonNode& root, std::string_view binary)
    : file_(file), binary_(binary), accessors_(items_of(root, "accessors")), views_(items_of(root, "bufferViews")) {
  const std::vector<JsonNode> buffers = items_of(root, "buffers");
  for (std::size_t i = 0; i < buffers.size(); ++i) buffers_.push_back(bytes_of(buffers[i], i));
}

std::string_view Buffers::bytes_of(const JsonNode& buffer, std::size_t number) {
  const std::uint64_t length = buffer.at("byteLength").whole_number(1, kMeshLimits.file);
  const auto uri = buffer.find("uri");
  std::string_view bytes = binary_;
  if (uri) {
    const std::string text = uri->text();
    bytes = text.starts_with("data:") ? embedded(*uri, text) : beside(*uri, text);
  } else if (number != 0) {
    buffer.fail("has no uri");
  }
  bytes_ += bytes.size();
  if (bytes.size() < length) {
    buffer.fail("must have " + std::to_string(length) + " bytes, and has " + std::to_string(bytes.size()));
  }
  return bytes.substr(0, length);
}

std::string_view Buffers::embedded(const JsonNode& uri, const std::string& text) {
  constexpr std::string_view kEncoding = ";base64,";
  const std::size_t at = text.find(kEncoding);
  auto bytes =
      at == std::string::npos ? std::nullopt : from_base64(std::string_view(text).substr(at + kEncoding.size()));
  if (!bytes) uri.fail("must be data:...;base64, and the bytes in base64");
  return *embedded_.emplace_back(std::make_unique<std::string>(std::move(*bytes)));
}

std::string_view Buffers::beside(const JsonNode& uri, const std::string& text) {
  const auto file = file_beside(file_, text);
  if (!file) uri.fail("must be the name of a file beside the glTF file, or data:");
  if (!io::InputFile::check(*file)) io::fail(*file, "is a pipe or device; a buffer is a file");
  files_.push_back(io::WholeFile::read(*file, {kMeshLimits.file, kMeshLimits.stream, 0}, nullptr));
  digests_ += io::sha256(files_.back().bytes());
  return files_.back().bytes();
}

AccessorElements Buffers::elements_of(const JsonNode& accessor, std::string_view type) const {
  if (accessor.at("type").text() != type) accessor.at("type").fail("must be " + std::string(type));
  for (const char* key : {"sparse", "extensions"}) {
    if (accessor.has(key)) accessor.fail("is sparse or compressed, which is not read: export the file without that");
  }
  AccessorElements elements;
  elements.component = accessor.at("componentType").whole_number(5120, 5126);
  elements.count = accessor.at("count").whole_number(1, kMostCount);
  const std::size_t size = (elements.component >= 5125   ? 4u
                            : elements.component >= 5122 ? 2u
                                                         : 1u) *
                           (type == "VEC3" ? 3u : 1u);
  const JsonNode& view = item_of(accessor.at("bufferView"), views_);
  if (view.has("extensions")) view.fail("is compressed, which is not read: export the file without that");
  const auto number_or = [](const JsonNode& node, const char* key, std::uint64_t otherwise) {
    const auto found = node.find(key);
    return found ? found->whole_number(0, kMeshLimits.file) : otherwise;
  };
  elements.stride = number_or(view, "byteStride", size);
  const JsonNode number = view.at("buffer");
  if (buffers_.empty()) number.fail("is an index into a list without items");
  const std::string_view buffer = buffers_[number.whole_number(0, buffers_.size() - 1)];
  const std::uint64_t begin = number_or(view, "byteOffset", 0),
                      length = view.at("byteLength").whole_number(1, kMeshLimits.file);
  const std::uint64_t offset = number_or(accessor, "byteOffset", 0);
  if (begin > buffer.size() || length > buffer.size() - begin) view.fail("reaches beyond its buffer");
  if (elements.stride < size || elements.stride > 252 || offset > length || size > length - offset ||
      (elements.count - 1) * elements.stride > length - offset - size) {
    accessor.fail("reaches beyond its buffer view, or its stride is none");
  }
  elements.first = buffer.data() + begin + offset;
  return elements;
}

std::vector<std::string> files_beside(const std::string& file) {
  std::vector<std::string> files;
  if (known_format_of(file) != Format::gltf) return files;
  try {
    if (!io::InputFile::check(file)) return files;  // a pipe can be read once
    const io::WholeFile content = read_content(file, nullptr);
    if (content.bytes().starts_with("glTF")) return files;
    const json::JsonDocument document = json::parse_json(content.bytes());
    const JsonNode root(document.value(), "the file");
    if (const auto buffers = root.find("buffers")) {
      for (const JsonNode& buffer : buffers->items()) {
        if (const auto uri = buffer.find("uri")) {
          if (const auto beside = file_beside(file, uri->text())) files.push_back(*beside);
        }
      }
    }
  } catch (const Error&) {  // the reader says what is wrong
  }
  return files;
}

}  // namespace touchstone::frames
