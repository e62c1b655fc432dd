// The arguments of questions about a mesh's step.
// SPDX-License-Identifier: MIT
#pragma once

#include <touchstone/mesh.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

#include "python/arguments.hpp"

namespace touchstone::python {

/// Positions in the array they came in, or in an exact copy where their type or layout needs one.
class PositionArray {
 public:
  PositionArray(py::handle values, const Mesh& mesh, const char* what) : owner_(exact_array(values, what)) {
    if (owner_.ndim() != 2 || owner_.shape(1) != mesh.dimension() ||
        static_cast<std::size_t>(owner_.shape(0)) != mesh.vertex_count()) {
      throw py::value_error(std::string(what) + " has the shape " + shape_text(owner_) +
                            "; for this mesh it must be (" + std::to_string(mesh.vertex_count()) + ", " +
                            std::to_string(mesh.dimension()) + ")");
    }
    constexpr py::ssize_t kDouble = sizeof(double);
    if (owner_.itemsize() != kDouble || owner_.strides(0) % kDouble != 0 || owner_.strides(1) % kDouble != 0 ||
        reinterpret_cast<std::uintptr_t>(owner_.data()) % alignof(double) != 0) {
      owner_ = py::array_t<double, py::array::c_style | py::array::forcecast>(py::array(owner_.attr("copy")("C")));
    }
    positions_.data = static_cast<const double*>(owner_.data());
    positions_.count = mesh.vertex_count();
    positions_.dimension = mesh.dimension();
    positions_.vertex_stride = owner_.strides(0) / kDouble;
    positions_.coordinate_stride = owner_.strides(1) / kDouble;
  }

  const Positions& view() const noexcept { return positions_; }

 private:
  py::array owner_;
  Positions positions_;
};

inline FirstContactOptions options_of(py::handle t_max, py::handle threads) {
  FirstContactOptions options;
  options.t_max = number_of(t_max, "t_max");
  options.threads = threads_of(threads);
  return options;
}

}  // namespace touchstone::python
