// Items of results by Python's indices: a whole number gives an item, and a slice, a mask or several whole numbers give
// a result of the same class.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "python/arguments.hpp"

namespace touchstone::python {

/// Item i of a list, from its end where i is negative.
template <class Item>
const Item& item_of(const std::vector<Item>& items, py::ssize_t i, const char* what) {
  const auto size = static_cast<py::ssize_t>(items.size());
  if (i < -size || i >= size) {
    throw py::index_error("there is no " + std::string(what) + " " + std::to_string(i) + "; there are " +
                          std::to_string(size));
  }
  return items[static_cast<std::size_t>(i < 0 ? i + size : i)];
}

/// A bool of Python or NumPy, which is no number of an item: chosen_of() refuses it.
class TruthValue : public py::object {
 public:
  PYBIND11_OBJECT(TruthValue, py::object, is_truth_value)

 private:
  static bool is_truth_value(PyObject* thing) {
    const std::string_view type = Py_TYPE(thing)->tp_name;
    return PyBool_Check(thing) != 0 || type == "numpy.bool_" || type == "numpy.bool";
  }
};

/// The items with these numbers; none of an empty list, which is that of a column without values.
template <class Item>
std::vector<Item> items_at(const std::vector<Item>& items, const std::vector<std::size_t>& chosen) {
  std::vector<Item> some;
  if (items.empty()) return some;
  some.reserve(chosen.size());
  for (const std::size_t i : chosen) some.push_back(items[i]);
  return some;
}

/// Defines len() and [] of a class of results.
/// @param what   what an item is called in messages
/// @param items  the list whose items are counted
/// @param one    what an item is in Python
/// @param some   the result of several numbers
template <class T, class Items, class One, class Some>
void define_items(py::class_<T>& bound, const char* what, const Items& items, const One& one, const Some& some) {
  bound.def("__len__", [items](const T& self) { return items(self).size(); })
      .def("__getitem__",
           [=](const T& self, const TruthValue& index) {
             return some(self, chosen_of(index, items(self).size(), what));
           })
      .def("__getitem__", [=](const T& self, py::ssize_t i) { return one(item_of(items(self), i, what)); })
      .def("__getitem__", [=](const T& self, const py::object& several) {
        return some(self, chosen_of(several, items(self).size(), what));
      });
}

}  // namespace touchstone::python
