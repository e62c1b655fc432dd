// glTF 2.0: .gltf with its buffers beside it or within, and .glb. The meshes of the default scene, each node at its
// place.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>

#include "frames/formats.hpp"
#include "io/bytes.hpp"
#include "io/fail.hpp"
#include "io/sha256.hpp"
#include "io/whole_file.hpp"
#include "json/json_node.hpp"

namespace touchstone::frames {
namespace {

using json::JsonNode;

// One mesh may be in any number of nodes, so that a short file may stand for any number of vertices and corners: these,
// and so many for each byte of the file and its buffers.
constexpr std::size_t kMostRepeated = std::size_t{1} << 22;
constexpr std::size_t kMostOfByte = 16;
constexpr std::size_t kMostCount = std::size_t{1} << 33;

enum class Mode : std::uint8_t { points, lines, line_loop, line_strip, triangles, triangle_strip, triangle_fan };

/// x -> m x + p.
struct Affine {
  std::array<std::array<double, 3>, 3> m = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::array<double, 3> p = {0, 0, 0};
  bool is_identity = true;

  std::array<double, 3> operator()(const std::array<double, 3>& x) const noexcept {
    if (is_identity) return x;
    std::array<double, 3> y = p;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) y[i] += m[i][k] * x[k];
    }
    return y;
  }

  bool mirrors() const noexcept {
    const auto minor = [&](std::size_t a, std::size_t b) { return m[1][a] * m[2][b] - m[1][b] * m[2][a]; };
    return m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1) < 0;
  }
};

Affine product(const Affine& a, const Affine& b) noexcept {
  if (a.is_identity) return b;
  if (b.is_identity) return a;
  Affine c;
  c.is_identity = false;
  c.p = a(b.p);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      c.m[i][k] = a.m[i][0] * b.m[0][k] + a.m[i][1] * b.m[1][k] + a.m[i][2] * b.m[2][k];
    }
  }
  return c;
}

std::vector<double> numbers(const JsonNode& node, std::size_t count) {
  std::vector<double> values;
  for (const JsonNode& item : node.items()) values.push_back(item.number());
  if (values.size() != count) node.fail("must have " + std::to_string(count) + " numbers");
  return values;
}

/// The transform of a node in its parent.
Affine transform_of(const JsonNode& node) {
  Affine local;
  if (const auto matrix = node.find("matrix")) {
    const std::vector<double> x = numbers(*matrix, 16);  // column by column
    if (x[3] != 0 || x[7] != 0 || x[11] != 0 || x[15] != 1) matrix->fail("must have the last row 0 0 0 1");
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) local.m[i][k] = x[4 * k + i];
      local.p[i] = x[12 + i];
    }
    local.is_identity = false;
    return local;
  }
  if (const auto rotation = node.find("rotation")) {
    const std::vector<double> q = numbers(*rotation, 4);
    const double x = q[0], y = q[1], z = q[2], w = q[3], s = x * x + y * y + z * z + w * w;
    if (!(s > 0) || !std::isfinite(s)) rotation->fail("is no quaternion of a rotation");
    local.m = {{{1 - 2 * (y * y + z * z) / s, 2 * (x * y - z * w) / s, 2 * (x * z + y * w) / s},
                {2 * (x * y + z * w) / s, 1 - 2 * (x * x + z * z) / s, 2 * (y * z - x * w) / s},
                {2 * (x * z - y * w) / s, 2 * (y * z + x * w) / s, 1 - 2 * (x * x + y * y) / s}}};
    local.is_identity = false;
  }
  if (const auto scale = node.find("scale")) {
    const auto factors = scale->three_numbers();
    for (auto& row : local.m) {
      for (std::size_t k = 0; k < 3; ++k) row[k] *= factors[k];
    }
    local.is_identity = false;
  }
  if (const auto translation = node.find("translation")) {
    local.p = translation->three_numbers();
    local.is_identity = false;
  }
  return local;
}

constexpr std::string_view kBase64 = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::optional<std::string> from_base64(std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::size_t value = kBase64.find(c);
    if (value == std::string_view::npos) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xFF);
  }
  return bytes;
}

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

class GltfReader {
 public:
  GltfReader(std::string_view file, std::string_view content)
      : file_(file), document_(json::parse_json(json_of(content))), builder_(false, 0), bytes_(content.size()) {}

  MeshFile read() {
    const JsonNode root(document_.value(), "the file");
    if (!root.at("asset").at("version").text().starts_with("2.")) root.at("asset").at("version").fail("must be 2.x");
    refuse_extensions(root);
    read_lists(root);
    for (const JsonNode& node : nodes_) unshown_ += node.has("mesh") ? 1 : 0;
    for (const auto& [node, transform] : scene_nodes(root)) {
      const auto mesh = nodes_[node].find("mesh");
      if (!mesh) continue;
      add_mesh(node, item(*mesh, meshes_), transform);
      --unshown_;
    }
    MeshFile result = builder_.finish({file_});
    if (const auto animations = root.find("animations")) result.topology.animations = animations->items().size();
    result.topology.moved_vertices = moved_;
    result.topology.unshown_meshes = unshown_;
    result.beside = std::move(beside_);
    return result;
  }

 private:
  /// The JSON of a .gltf, or that of a .glb, whose other chunk is kept.
  std::string_view json_of(std::string_view content) {
    if (!content.starts_with("glTF")) return content;
    const auto number = [&](std::size_t at) {
      return io::unsigned_at<std::uint32_t>(content.data() + at, std::endian::little);
    };
    if (content.size() < 20 || number(4) != 2) io::fail(file_, "is no glTF 2 file: its header is another one");
    if (number(8) != content.size()) {
      io::fail(file_,
               "has " + std::to_string(content.size()) + " bytes, and says that it has " + std::to_string(number(8)));
    }
    std::string_view json;
    for (std::size_t at = 12; at < content.size();) {
      if (content.size() - at < 8 || number(at) > content.size() - at - 8)
        io::fail(file_, "has a chunk that is cut off");
      const std::string_view chunk = content.substr(at + 8, number(at));
      const std::uint32_t sort = number(at + 4);
      if (json.data() == nullptr && sort != kJsonChunk) io::fail(file_, "does not begin with its JSON");
      if (sort == kJsonChunk) json = chunk;
      if (sort == kBinaryChunk) binary_ = chunk;
      at += 8 + chunk.size();
    }
    return json;
  }

  /// Of extensions: they say how surfaces look.
  static bool is_harmless(const std::string& name) {
    return name.starts_with("KHR_materials_") || name.starts_with("KHR_texture_") || name.starts_with("EXT_texture_") ||
           name.starts_with("KHR_lights_");
  }

  /// What a reader must know to read the file.
  static void refuse_extensions(const JsonNode& root) {
    const auto required = root.find("extensionsRequired");
    if (!required) return;
    for (const JsonNode& extension : required->items()) {
      const std::string name = extension.text();
      if (!is_harmless(name)) extension.fail("is an extension that is not read: export the file without it");
    }
  }

  void read_lists(const JsonNode& root) {
    const auto list = [&](const char* key) {
      const auto found = root.find(key);
      return found ? found->items() : std::vector<JsonNode>();
    };
    nodes_ = list("nodes");
    meshes_ = list("meshes");
    accessors_ = list("accessors");
    views_ = list("bufferViews");
    const std::vector<JsonNode> buffers = list("buffers");
    for (std::size_t i = 0; i < buffers.size(); ++i) buffers_.push_back(bytes_of(buffers[i], i));
  }

  static const JsonNode& item(const JsonNode& index, const std::vector<JsonNode>& list) {
    const std::uint64_t i = index.whole_number(0, list.empty() ? 0 : list.size() - 1);
    if (list.empty()) index.fail("is an index into a list without items");
    return list[i];
  }

  std::string_view bytes_of(const JsonNode& buffer, std::size_t number) {
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

  std::string_view embedded(const JsonNode& uri, const std::string& text) {
    constexpr std::string_view kEncoding = ";base64,";
    const std::size_t at = text.find(kEncoding);
    auto bytes =
        at == std::string::npos ? std::nullopt : from_base64(std::string_view(text).substr(at + kEncoding.size()));
    if (!bytes) uri.fail("must be data:...;base64, and the bytes in base64");
    return *embedded_.emplace_back(std::make_unique<std::string>(std::move(*bytes)));
  }

  std::string_view beside(const JsonNode& uri, const std::string& text) {
    const auto file = file_beside(file_, text);
    if (!file) uri.fail("must be the name of a file beside the glTF file, or data:");
    if (!io::InputFile::check(*file)) io::fail(*file, "is a pipe or device; a buffer is a file");
    files_.push_back(io::WholeFile::read(*file, {kMeshLimits.file, kMeshLimits.stream, 0}, nullptr));
    beside_ += io::sha256(files_.back().bytes());
    return files_.back().bytes();
  }

  /// The nodes of the default scene, parents before children.
  std::vector<std::pair<std::size_t, Affine>> scene_nodes(const JsonNode& root) const {
    std::vector<std::pair<std::size_t, Affine>> placed;
    std::set<std::size_t> known;
    const auto add = [&](const JsonNode& index, const Affine& parent) {
      item(index, nodes_);
      const std::size_t node = index.whole_number(0, nodes_.size() - 1);
      if (!known.insert(node).second) index.fail("is a node that is in the scene already");
      placed.emplace_back(node, product(parent, transform_of(nodes_[node])));
    };
    const auto scenes = root.find("scenes");
    if (!scenes) root.fail("has no scenes: it shows nothing");
    const std::vector<JsonNode> all = scenes->items();
    const auto chosen = root.find("scene");
    if (all.empty()) scenes->fail("is empty");
    const JsonNode& scene = chosen ? item(*chosen, all) : all[0];
    if (const auto roots = scene.find("nodes")) {
      for (const JsonNode& node : roots->items()) add(node, {});
    }
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const Affine parent = placed[i].second;
      if (const auto children = nodes_[placed[i].first].find("children")) {
        for (const JsonNode& node : children->items()) add(node, parent);
      }
    }
    return placed;
  }

  std::string part_name(std::size_t node, const JsonNode& mesh) {
    std::string name;
    if (const auto own = nodes_[node].find("name")) name = own->text();
    if (name.empty() && mesh.has("name")) name = mesh.at("name").text();
    if (name.empty()) name = "node " + std::to_string(node);
    while (!names_.insert(name).second) name += " (node " + std::to_string(node) + ")";
    return name;
  }

  void add_mesh(std::size_t node, const JsonNode& mesh, const Affine& transform) {
    if (const auto extensions = nodes_[node].find("extensions")) {
      for (const std::string& name : extensions->keys()) {
        if (!is_harmless(name)) extensions->fail(name + " is not read: export the file without it");
      }
    }
    if (nodes_[node].has("skin")) {
      nodes_[node].fail("has a skin, whose pose is not read: export the posed mesh");
    }
    for (const JsonNode* owner : {&mesh, static_cast<const JsonNode*>(&nodes_[node])}) {
      const auto weights = owner->find("weights");
      if (!weights) continue;
      for (const JsonNode& weight : weights->items()) {
        if (weight.number() != 0) weight.fail("is that of a morph target, which is not read: export the morphed mesh");
      }
    }
    builder_.set_part(part_name(node, mesh));
    std::map<const JsonNode*, std::size_t> first_vertices;  // by the accessor of the positions
    for (const JsonNode& primitive : mesh.at("primitives").items()) {
      const JsonNode& accessor = item(primitive.at("attributes").at("POSITION"), accessors_);
      const auto [known, is_new] = first_vertices.try_emplace(&accessor, builder_.vertex_count());
      if (is_new) add_vertices(accessor, transform);
      add_primitive(primitive, known->second, builder_.vertex_count() - known->second, transform.mirrors());
    }
  }

  /// Elements side by side in a buffer.
  struct Elements {
    const char* first = nullptr;
    std::size_t stride = 0;
    std::size_t count = 0;
    std::uint64_t component = 0;  ///< the glTF number of the type
  };

  Elements elements_of(const JsonNode& accessor, std::string_view type) const {
    if (accessor.at("type").text() != type) accessor.at("type").fail("must be " + std::string(type));
    for (const char* key : {"sparse", "extensions"}) {
      if (accessor.has(key)) accessor.fail("is sparse or compressed, which is not read: export the file without that");
    }
    Elements elements;
    elements.component = accessor.at("componentType").whole_number(5120, 5126);
    elements.count = accessor.at("count").whole_number(1, kMostCount);
    const std::size_t size = (elements.component >= 5125   ? 4u
                              : elements.component >= 5122 ? 2u
                                                           : 1u) *
                             (type == "VEC3" ? 3u : 1u);
    const JsonNode& view = item(accessor.at("bufferView"), views_);
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

  void add_vertices(const JsonNode& accessor, const Affine& transform) {
    const Elements elements = elements_of(accessor, "VEC3");
    if (elements.component != 5126) accessor.at("componentType").fail("must be 5126: positions are floats");
    if (builder_.vertex_count() + elements.count > most()) {
      accessor.fail("makes more than " + std::to_string(most()) + " vertices, too many for a file of this size");
    }
    for (std::size_t i = 0; i < elements.count; ++i) {
      std::array<double, 3> x;
      for (std::size_t k = 0; k < 3; ++k) {
        x[k] = io::float_at(elements.first + i * elements.stride + 4 * k, std::endian::little);
      }
      x = transform(x);
      moved_ += transform.is_identity ? 0 : 1;
      for (const double coordinate : x) {
        if (!std::isfinite(coordinate)) accessor.fail("has a position that is not finite: " + std::to_string(i));
      }
      builder_.add_vertex(x[0], x[1], x[2]);
    }
  }

  std::vector<MeshIndex> indices_of(const JsonNode& primitive, std::size_t first, std::size_t count) const {
    std::vector<MeshIndex> indices;
    const auto index = primitive.find("indices");
    if (!index) {
      for (std::size_t i = 0; i < count; ++i) indices.push_back(static_cast<MeshIndex>(first + i));
      return indices;
    }
    const JsonNode& accessor = item(*index, accessors_);
    const Elements elements = elements_of(accessor, "SCALAR");
    indices.reserve(elements.count);
    for (std::size_t i = 0; i < elements.count; ++i) {
      const char* const at = elements.first + i * elements.stride;
      std::uint32_t value = 0;
      switch (elements.component) {
        case 5121: value = static_cast<unsigned char>(*at); break;
        case 5123: value = io::unsigned_at<std::uint16_t>(at, std::endian::little); break;
        case 5125: value = io::unsigned_at<std::uint32_t>(at, std::endian::little); break;
        default: accessor.at("componentType").fail("must be 5121, 5123 or 5125: indices have no sign");
      }
      if (value >= count)
        accessor.fail("has the index " + std::to_string(value) + " of " + std::to_string(count) + " positions");
      indices.push_back(static_cast<MeshIndex>(first + value));
    }
    return indices;
  }

  void add_primitive(const JsonNode& primitive, std::size_t first, std::size_t count, bool mirrored) {
    const auto mode = primitive.find("mode");
    const Mode sort = mode ? static_cast<Mode>(mode->whole_number(0, 6)) : Mode::triangles;
    const std::vector<MeshIndex> v = indices_of(primitive, first, count);
    corners_ += v.size();
    if (corners_ > most()) {
      primitive.fail("makes more than " + std::to_string(most()) + " corners, too many for a file of this size");
    }
    const std::size_t n = v.size();
    const auto triangle = [&](MeshIndex a, MeshIndex b, MeshIndex c) {
      if (mirrored) std::swap(b, c);
      builder_.add_polygon(std::array{a, b, c}, faces_++, {file_});
    };
    if ((sort == Mode::triangles && n % 3 != 0) || (sort == Mode::lines && n % 2 != 0)) {
      primitive.fail("has " + std::to_string(n) + " indices, which do not make whole elements");
    }
    switch (sort) {
      case Mode::points:
        for (const MeshIndex point : v) builder_.add_point(point);
        break;
      case Mode::lines:
        for (std::size_t i = 0; i < n; i += 2) builder_.add_edge(v[i], v[i + 1]);
        break;
      case Mode::line_loop:
      case Mode::line_strip:
        builder_.add_polyline(v, {file_});
        if (sort == Mode::line_loop) builder_.add_edge(v[n - 1], v[0]);
        break;
      case Mode::triangles:
        for (std::size_t i = 0; i < n; i += 3) triangle(v[i], v[i + 1], v[i + 2]);
        break;
      case Mode::triangle_strip:
        for (std::size_t i = 2; i < n; ++i) triangle(v[i - 2], v[i - 1 + i % 2], v[i - i % 2]);
        break;
      case Mode::triangle_fan:
        for (std::size_t i = 2; i < n; ++i) triangle(v[i - 1], v[i], v[0]);
        break;
    }
  }

  std::size_t most() const noexcept { return kMostRepeated + kMostOfByte * bytes_; }

  static constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

  std::string_view file_;
  std::string_view binary_;  ///< of a .glb
  json::JsonDocument document_;
  std::vector<JsonNode> nodes_, meshes_, accessors_, views_;
  std::vector<std::string_view> buffers_;
  std::vector<std::unique_ptr<std::string>> embedded_;
  std::vector<io::WholeFile> files_;
  std::string beside_;  ///< the digests of the files
  MeshBuilder builder_;
  std::set<std::string> names_;
  std::size_t faces_ = 0, corners_ = 0, moved_ = 0, unshown_ = 0;
  std::size_t bytes_ = 0;  ///< of the file and its buffers
};

}  // namespace

MeshFile read_gltf(std::string_view file, std::string_view content) {
  try {
    return GltfReader(file, content).read();
  } catch (const FileError&) {
    throw;
  } catch (const Error& error) {
    io::fail(file, error.what());
  }
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
