// Classes of the library as Python sees them. An object that `__new__` alone has made has no value: pybind11 hands out
// memory that nothing was written to. Here it is refused.
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <concepts>
#include <string>
#include <utility>

#include <touchstone/answer.hpp>
#include <touchstone/bodies.hpp>
#include <touchstone/closest_approach.hpp>
#include <touchstone/contact_times.hpp>
#include <touchstone/fuzz.hpp>
#include <touchstone/mesh.hpp>
#include <touchstone/separation.hpp>

namespace touchstone::python {

namespace py = pybind11;

template <class T, class... Others>
concept one_of = (std::same_as<T, Others> || ...);

/// A class that Python has. Those of this folder name it by `using BoundToPython = void`.
template <class T>
concept Bound = one_of<T, Answer, Bodies, Body, ClosestApproach, Distance, ExactTime, FirstContact, FuzzFinding,
                       FuzzReport, Mesh, StepFuzzFinding, StepFuzzReport> || requires {
  typename T::BoundToPython;
};

/// A Mesh itself, or the Mesh of anything that stands for one: a MeshFile, Frames, or a mesh of another package.
py::object mesh_object(py::handle given);

/// Defines a class.
template <Bound T>
py::class_<T> define_class(py::module_& module, const char* name, const char* help) {
  return py::class_<T>(module, name, help);
}

}  // namespace touchstone::python

namespace pybind11::detail {

template <touchstone::python::Bound T>
class type_caster<T> : public type_caster_base<T> {
 public:
  bool load(handle given, bool convert) {
    if constexpr (std::same_as<T, touchstone::Mesh>) {
      held_ = touchstone::python::mesh_object(given);
      given = held_;
    }
    return this->template load_impl<type_caster>(given, convert);
  }

  void load_value(value_and_holder&& held) {  // NOLINT(readability-identifier-naming): pybind11 calls it
    if (held.value_ptr() == nullptr) {
      const std::string its_class = Py_TYPE(reinterpret_cast<PyObject*>(held.inst))->tp_name;
      throw type_error("this " + its_class +
                       " has no value: __new__ alone has made it. Objects come from a call of the class, or from the "
                       "module's functions");
    }
    type_caster_base<T>::load_value(std::move(held));
  }

 private:
  object held_;  // while the call runs
};

}  // namespace pybind11::detail
