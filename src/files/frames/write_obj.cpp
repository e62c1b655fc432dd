// SPDX-License-Identifier: MIT
#include "frames/write_obj.hpp"

#include <array>
#include <charconv>
#include <optional>

namespace touchstone::frames {
namespace {

constexpr std::size_t kLongestNumber = 32;  // the shortest decimal of a double has at most 24 characters

/// Appends ' ' and the number.
template <class Number>
void append_number(std::string& to, Number number) {
  std::array<char, kLongestNumber> text;
  text[0] = ' ';
  const auto [end, error] = std::to_chars(text.data() + 1, text.data() + text.size(), number);
  to.append(text.data(), end);
}

template <std::size_t n>
void append_element(std::string& to, char keyword, const std::array<MeshIndex, n>& vertices) {
  to += keyword;
  for (const MeshIndex vertex : vertices) append_number(to, std::uint64_t{vertex} + 1);
  to += '\n';
}

void append_group(std::string& to, const std::string& name) {
  to += 'g';
  if (!name.empty()) to += ' ';
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    to += byte < 0x20 || byte == 0x7F || c == '\\' ? '_' : c;
  }
  to += '\n';
}

}  // namespace

void append_obj(std::string& to, const Topology& topology, const double* positions) {
  const auto dimension = static_cast<std::size_t>(topology.dimension);
  for (std::size_t vertex = 0; vertex < topology.vertex_count; ++vertex) {
    to += 'v';
    for (std::size_t k = 0; k < dimension; ++k) append_number(to, positions[dimension * vertex + k]);
    to += dimension == 2 ? " 0\n" : "\n";
  }
  std::optional<std::uint32_t> part;
  for (std::size_t i = 0; i < topology.faces.size(); ++i) {
    if (!topology.face_parts.empty() && part != topology.face_parts[i]) {
      part = topology.face_parts[i];
      append_group(to, topology.parts[*part]);
    }
    append_element(to, 'f', topology.faces[i]);
  }
  for (const auto& edge : topology.edges) append_element(to, 'l', edge);
  for (const MeshIndex point : topology.points) append_element(to, 'p', std::array{point});
}

}  // namespace touchstone::frames
