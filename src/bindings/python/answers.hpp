// Answers as Python sees them: one with attributes, or many with attributes that are arrays.
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <utility>
#include <vector>

#include <touchstone/answer.hpp>

#include "python/bound.hpp"

namespace touchstone::python {

namespace py = pybind11;

/// A member of structures that lie one after another, as an array without a copy. `owner` keeps them alive.
template <class Number, class Structure>
py::array column_of(const std::vector<Structure>& structures, const void* first, py::handle owner,
                    std::size_t width = 0) {
  std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(structures.size())};
  std::vector<py::ssize_t> strides = {sizeof(Structure)};
  if (width > 0) {
    shape.push_back(static_cast<py::ssize_t>(width));
    strides.push_back(sizeof(Number));
  }
  py::array column(py::dtype::of<Number>(), shape, strides, structures.empty() ? nullptr : first, owner);
  py::detail::array_proxy(column.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return column;
}

/// The answers to many queries. It never changes.
class Answers {
 public:
  using BoundToPython = void;

  explicit Answers(std::vector<Answer> answers) : answers_(std::move(answers)) {}
  const std::vector<Answer>& all() const noexcept { return answers_; }

 private:
  std::vector<Answer> answers_;
};

/// The member of the Python enumeration `Nature`, `Feature`, `Level` or `Trend`.
py::object name_object(Nature nature);
py::object name_object(Feature feature);
py::object name_object(Level level);
py::object name_object(Trend trend);

/// Defines the classes Answer and Answers.
void define_answers(py::module_& module);

}  // namespace touchstone::python
