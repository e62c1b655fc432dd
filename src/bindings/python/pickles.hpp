// Pickles and copies of objects that never change: the version of the library, and the members one after another.
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <touchstone/closest_approach.hpp>
#include <touchstone/distance.hpp>
#include <touchstone/fuzz.hpp>
#include <touchstone/mesh.hpp>
#include <touchstone/version.hpp>

namespace touchstone::python {

namespace py = pybind11;

/// Writes the members of objects.
class Packer {
 public:
  template <class... Values>
  void operator()(Values&... values) {
    (pack(values), ...);
  }
  static void check(bool /*fits*/) {}
  std::string bytes() && { return std::move(bytes_); }

 private:
  template <class Value>
  void pack(Value& value);
  template <class Value>
  void pack(std::vector<Value>& values) {
    std::uint64_t count = values.size();
    pack(count);
    if constexpr (std::is_arithmetic_v<Value>) {
      bytes_.append(reinterpret_cast<const char*>(values.data()), count * sizeof(Value));
    } else {
      for (Value& value : values) pack(value);
    }
  }
  void pack(std::string& text) {
    std::uint64_t size = text.size();
    pack(size);
    bytes_ += text;
  }
  template <class Value>
  void pack(std::optional<Value>& value) {
    bool there = value.has_value();
    pack(there);
    if (there) pack(*value);
  }
  template <class Value, std::size_t N>
  void pack(std::array<Value, N>& values) {
    for (Value& value : values) pack(value);
  }

  std::string bytes_;
};

/// Reads what a Packer wrote. @throws py::value_error  for other bytes
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

  template <class... Values>
  void operator()(Values&... values) {
    (unpack(values), ...);
  }
  void finish() const { check(bytes_.empty()); }
  static void check(bool fits) {
    if (!fits) fail();
  }

 private:
  [[noreturn]] static void fail() { throw py::value_error("the pickle is damaged"); }

  template <class Value>
  void unpack(Value& value);
  template <class Value>
  void unpack(std::vector<Value>& values) {
    const std::size_t count = size_of_list();
    if constexpr (std::is_arithmetic_v<Value>) {
      if (count > bytes_.size() / sizeof(Value)) fail();
      values.resize(count);
      if (count > 0) std::memcpy(values.data(), bytes_.data(), count * sizeof(Value));
      bytes_.remove_prefix(count * sizeof(Value));
    } else {
      for (std::size_t i = 0; i < count; ++i) unpack(values.emplace_back());
    }
  }
  void unpack(std::string& text) {
    const std::size_t size = size_of_list();
    text.assign(bytes_.substr(0, size));
    bytes_.remove_prefix(size);
  }
  template <class Value>
  void unpack(std::optional<Value>& value) {
    bool there = false;
    unpack(there);
    if (there) unpack(value.emplace());
  }
  template <class Value, std::size_t N>
  void unpack(std::array<Value, N>& values) {
    for (Value& value : values) unpack(value);
  }
  /// Each item has a byte at least.
  std::size_t size_of_list() {
    std::uint64_t count = 0;
    unpack(count);
    if (count > bytes_.size()) fail();
    return static_cast<std::size_t>(count);
  }

  std::string_view bytes_;
};

// The members of each class.

template <class Archive>
void members(Archive& archive, Vec3& x) {
  archive(x.x, x.y, x.z);
}
template <class Archive>
void members(Archive& archive, Separation& x) {
  archive(x.distance, x.metric);
}
template <class Archive>
void members(Archive& archive, Answer& x) {
  archive(x.contact, x.level, x.nature, x.feature_a, x.feature_b, x.starts_within, x.trend, x.toi, x.toi_upper,
          x.weights_a, x.weights_b);
}
template <class Archive>
void members(Archive& archive, Distance& x) {
  archive(x.value, x.feature_a, x.feature_b, x.weights_a, x.weights_b);
}
template <class Archive>
void members(Archive& archive, MeshPair& x) {
  archive(x.kind, x.first, x.second);
}
template <class Archive>
void members(Archive& archive, PairSeparation& x) {
  archive(x.pair, x.distance);
}
template <class Archive>
void members(Archive& archive, MeshContact& x) {
  archive(x.pair, x.separation, x.answer);
}
template <class Archive>
void members(Archive& archive, Intersection& x) {
  archive(x.first_element, x.first, x.second_element, x.second, x.sort, x.weights_first, x.weights_second);
}
template <class Archive>
void members(Archive& archive, FirstContact& x) {
  archive(x.contact, x.toi, x.toi_upper, x.earliest, x.at_start, x.start_checked, x.start_intersections);
}
template <class Archive>
void members(Archive& archive, ClosestApproach& x) {
  archive(x.distance, x.first_contact);
}
template <class Archive>
void members(Archive& archive, FreeStep& x) {
  archive(x.outcome, x.length, x.positions, x.first_contact, x.proofs);
}
template <class Archive>
void members(Archive& archive, CollisionRules& x) {
  archive(x.vertex_pairs, x.element_pairs, x.groups, x.group_rule, x.group_pairs);
}
template <class Archive>
void members(Archive& archive, MeshElements& x) {
  archive(x.vertex_count, x.faces, x.edges, x.points, x.dimension, x.rules, x.separation, x.radii, x.pair_separations);
}
template <class Archive>
void members(Archive& archive, Query& x) {
  archive(x.kind, x.start, x.end);
}
template <class Archive>
void members(Archive& archive, Claim& x) {
  archive(x.contact, x.toi, x.toi_as_written);
}
template <class Archive>
void members(Archive& archive, FuzzFinding& x) {
  archive(x.failure, x.degeneracy, x.count, x.query, x.claim, x.truth, x.detail, x.case_name, x.separation);
}
template <class Archive>
void members(Archive& archive, FuzzReport& x) {
  archive(x.queries, x.failures, x.allowed, x.kinds_of_failure, x.findings, x.stopped);
}
template <class Archive>
void members(Archive& archive, Mesh& x) {
  MeshElements elements = x.elements();
  archive(elements);
  x = Mesh(std::move(elements));
}
template <class Archive>
void members(Archive& archive, StepFuzzFinding& x) {
  archive(x.failure, x.question, x.detail, x.count, x.mesh, x.x0, x.x1, x.case_name);
  const std::size_t coordinates = 3 * x.mesh.vertex_count();
  archive.check(x.x0.size() == coordinates && x.x1.size() == coordinates);
}
template <class Archive>
void members(Archive& archive, StepFuzzReport& x) {
  archive(x.steps, x.failures, x.kinds_of_failure, x.findings, x.left_out, x.stopped);
}

template <class Value>
void Packer::pack(Value& value) {
  if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  } else {
    members(*this, value);
  }
}

template <class Value>
void Unpacker::unpack(Value& value) {
  if constexpr (std::is_same_v<Value, bool>) {
    unsigned char byte = 0;
    unpack(byte);
    if (byte > 1) fail();
    value = byte == 1;
  } else if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
    if (bytes_.size() < sizeof value) fail();
    std::memcpy(&value, bytes_.data(), sizeof value);
    bytes_.remove_prefix(sizeof value);
    if constexpr (requires { names_of<Value>(); }) {
      if (static_cast<std::size_t>(value) >= names_of<Value>().size()) fail();
    }
  } else {
    members(*this, value);
  }
}

/// pickle, copy.copy and copy.deepcopy of a class whose objects never change: a copy is the object itself.
/// @param to_value    what of an object is written
/// @param from_value  makes the object of it
template <class T, class ToValue, class FromValue>
void define_pickle(py::class_<T>& bound, ToValue to_value, FromValue from_value) {
  using Value = std::decay_t<decltype(to_value(std::declval<const T&>()))>;
  bound
      .def(py::pickle(
          [to_value](const T& object) {
            Value value = to_value(object);
            Packer pack;
            pack(value);
            return py::make_tuple(std::string(version()), py::bytes(std::move(pack).bytes()));
          },
          [from_value](const py::tuple& state) {
            if (py::len(state) != 2 || !py::isinstance<py::str>(state[0]) || !py::isinstance<py::bytes>(state[1])) {
              throw py::value_error("the pickle is damaged");
            }
            const auto from = state[0].cast<std::string>();
            if (from != version()) {
              throw py::value_error("the pickle is of touchstone " + from + ", and this is touchstone " +
                                    std::string(version()));
            }
            const auto bytes = state[1].cast<std::string>();
            Value value;
            Unpacker unpack(bytes);
            unpack(value);
            unpack.finish();
            return from_value(std::move(value));
          }))
      .def("__copy__", [](const py::object& self) { return self; })
      .def("__deepcopy__", [](const py::object& self, py::handle) { return self; });
}

template <class T>
void define_pickle(py::class_<T>& bound) {
  define_pickle(
      bound, [](const T& object) { return object; }, [](T&& value) { return std::move(value); });
}

}  // namespace touchstone::python
