// glTF 2.0: .gltf with its buffers beside it or within, and .glb. The meshes of the default scene, each node at its
// place.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>

#include "frames/formats.hpp"
#include "frames/gltf/buffers.hpp"
#include "frames/gltf/transforms.hpp"
#include "io/bytes.hpp"
#include "io/fail.hpp"
#include "json/json_node.hpp"

namespace touchstone::frames {
namespace {

using json::JsonNode;

enum class Mode : std::uint8_t { points, lines, line_loop, line_strip, triangles, triangle_strip, triangle_fan };

class GltfReader {
 public:
  GltfReader(std::string_view file, std::string_view content)
      : file_(file), document_(json::parse_json(json_of(content))), builder_(false, 0), bytes_(content.size()) {}

  MeshFile read() {
    const JsonNode root(document_.value(), "the file");
    if (!root.at("asset").at("version").text().starts_with("2.")) root.at("asset").at("version").fail("must be 2.x");
    refuse_extensions(root);
    nodes_ = items_of(root, "nodes");
    meshes_ = items_of(root, "meshes");
    buffers_.emplace(file_, root, binary_);
    for (const JsonNode& node : nodes_) unshown_ += node.has("mesh") ? 1 : 0;
    for (const auto& [node, transform] : scene_nodes(root)) {
      const auto mesh = nodes_[node].find("mesh");
      if (!mesh) continue;
      add_mesh(node, item_of(*mesh, meshes_), transform);
      --unshown_;
    }
    MeshFile result = builder_.finish({file_});
    if (const auto animations = root.find("animations")) result.topology.animations = animations->items().size();
    result.topology.moved_vertices = moved_;
    result.topology.unshown_meshes = unshown_;
    result.beside = buffers_->digests();
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

  /// The nodes of the default scene, parents before children.
  std::vector<std::pair<std::size_t, Affine>> scene_nodes(const JsonNode& root) const {
    std::vector<std::pair<std::size_t, Affine>> placed;
    std::set<std::size_t> known;
    const auto add = [&](const JsonNode& index, const Affine& parent) {
      item_of(index, nodes_);
      const std::size_t node = index.whole_number(0, nodes_.size() - 1);
      if (!known.insert(node).second) index.fail("is a node that is in the scene already");
      placed.emplace_back(node, product(parent, transform_of(nodes_[node])));
    };
    const auto scenes = root.find("scenes");
    if (!scenes) root.fail("has no scenes: it shows nothing");
    const std::vector<JsonNode> all = scenes->items();
    const auto chosen = root.find("scene");
    if (all.empty()) scenes->fail("is empty");
    const JsonNode& scene = chosen ? item_of(*chosen, all) : all[0];
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
      const JsonNode& accessor = buffers_->accessor(primitive.at("attributes").at("POSITION"));
      const auto [known, is_new] = first_vertices.try_emplace(&accessor, builder_.vertex_count());
      if (is_new) add_vertices(accessor, transform);
      add_primitive(primitive, known->second, builder_.vertex_count() - known->second, transform.mirrors());
    }
  }

  void add_vertices(const JsonNode& accessor, const Affine& transform) {
    const AccessorElements elements = buffers_->elements_of(accessor, "VEC3");
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
    const JsonNode& accessor = buffers_->accessor(*index);
    const AccessorElements elements = buffers_->elements_of(accessor, "SCALAR");
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
      case Mode::triangle_strip: for_each_of_strip(v, triangle); break;
      case Mode::triangle_fan:
        for (std::size_t i = 2; i < n; ++i) triangle(v[i - 1], v[i], v[0]);
        break;
    }
  }

  std::size_t most() const noexcept { return most_items(bytes_ + buffers_->bytes()); }

  static constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

  std::string_view file_;
  std::string_view binary_;  ///< of a .glb
  json::JsonDocument document_;
  std::vector<JsonNode> nodes_, meshes_;
  std::optional<Buffers> buffers_;
  MeshBuilder builder_;
  std::set<std::string> names_;
  std::size_t faces_ = 0, corners_ = 0, moved_ = 0, unshown_ = 0;
  std::size_t bytes_ = 0;  ///< of the file
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

}  // namespace touchstone::frames
