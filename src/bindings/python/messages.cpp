// What is said of arguments that fit no signature: one line that names the argument, in place of pybind11's list of
// signatures and values.
// SPDX-License-Identifier: MIT
#include <pybind11/pybind11.h>

#include <exception>
#include <string>

#include "python/define.hpp"

namespace touchstone::python {
namespace {

using Call = PyCFunctionWithKeywords;

/// pybind11's, which is the same for all its functions.
Call pybind_call = nullptr;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables): set when the module is made

/// Replaces the error that is set by a shorter one, where it is pybind11's.
void shorten_error(py::handle arguments, PyObject* named) {
  py::error_already_set error;
  const std::string text = py::str(error.value());
  if (text.find("(): incompatible ") == std::string::npos) return error.restore();
  const py::object names = named == nullptr ? py::dict() : py::reinterpret_borrow<py::object>(named);
  try {
    const py::object line = py::module_::import("touchstone._hints").attr("one_line")(text, arguments, names);
    PyErr_SetObject(PyExc_TypeError, line.ptr());
  } catch (py::error_already_set&) {
    error.restore();  // another version of pybind11 may say it in another way
  }
}

PyObject* call_with_short_errors(PyObject* self, PyObject* arguments, PyObject* named) {
  PyObject* const result = pybind_call(self, arguments, named);
  if (result != nullptr || PyErr_ExceptionMatches(PyExc_TypeError) == 0) return result;
  try {
    shorten_error(arguments, named);
  } catch (py::error_already_set& error) {
    error.restore();
  } catch (const std::exception& error) {
    PyErr_SetString(PyExc_RuntimeError, error.what());
  }
  return nullptr;
}

/// What a function of Python calls, or none of anything that pybind11 has not made, or not in this way.
PyMethodDef* definition_of(py::handle thing) {
  const py::handle function = py::detail::get_function(thing);
  if (!function || !PyCFunction_Check(function.ptr())) return nullptr;
  PyMethodDef* const definition = reinterpret_cast<PyCFunctionObject*>(function.ptr())->m_ml;
  return definition->ml_flags == (METH_VARARGS | METH_KEYWORDS) ? definition : nullptr;
}

Call call_of(const PyMethodDef& definition) {
  return reinterpret_cast<Call>(reinterpret_cast<void (*)()>(definition.ml_meth));
}

void shorten(py::handle thing) {
  PyMethodDef* const definition = definition_of(thing);
  if (definition == nullptr || call_of(*definition) != pybind_call) return;
  definition->ml_meth = reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(&call_with_short_errors));
}

}  // namespace

void shorten_messages(const py::module_& module) {
  const py::cpp_function any([] {});
  const PyMethodDef* const definition = definition_of(any);
  if (definition == nullptr) return;
  pybind_call = call_of(*definition);
  for (const auto& [name, thing] : py::dict(module.attr("__dict__"))) {
    shorten(thing);
    if (!py::isinstance<py::type>(thing)) continue;
    const auto members = py::dict(thing.attr("__dict__"));
    for (const auto& [member, method] : members) shorten(method);
  }
}

}  // namespace touchstone::python
